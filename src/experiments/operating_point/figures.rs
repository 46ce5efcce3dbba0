//! The map of slip modes around an operating point, and the point on other maps.

use super::words::point_of;
use crate::experiments::map::figures::known_lines;
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::readout;
use crate::experiments::trajectories::curves::point_marks;
use crate::experiments::zones::figures::present_zones;
use crate::experiments::{Drawer, Outcome, SceneOutcome, Words};
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, PointMark, Side, ZoneMap};

pub(crate) const FIGURES: &[Drawer] = &[("operating-map", |outcome, words| operating_map(outcome, words))];

fn operating_map(outcome: &Outcome, words: &Words) -> Option<String> {
    let scene = outcome.scenes.iter().find(|scene| scene.operating_point.is_some())?;
    let (map, boundary) = (scene.map.as_ref()?, scene.boundary.as_ref()?);
    let (x, y) = axes(map)?;
    let modes = map.values.iter().map(|point| point.slip_mode);
    let runs = point_marks(scene, "", |id| id.replace('-', " "), Side::Right);
    let marks =
        if runs.is_empty() { operating_point_mark(scene, &x, &y).into_iter().collect() } else { runs };
    let zones = ZoneMap {
        zones: present_zones(modes, map.loading_velocity_m_per_s.len(), &x, &y),
        lines: known_lines(scene, boundary, &x, &y),
        marks,
        ..words.zone_map(x, y)
    };
    Some(zones.svg_with(Some(&readout(map, boundary))))
}

/// The scene's operating point as a mark on a map, its name towards the middle; none when the scene states none, or outside of the axes.
pub(crate) fn operating_point_mark(scene: &SceneOutcome, x: &Axis, y: &Axis) -> Option<PointMark> {
    let point = point_of(scene)?;
    let place = (nearest_f64(&point.loading_velocity_m_per_s), nearest_f64(&point.normal_stress_pa));
    let is_inside = (x.min..=x.max).contains(&place.0) && (y.min..=y.max).contains(&place.1);
    let is_right = place.0 > (x.min * x.max).sqrt();
    let side = if is_right { Side::Left } else { Side::Right };
    is_inside.then(|| PointMark::new("operating point", place, side))
}
