//! The map of slip modes around an operating point, and the point on other maps.

use super::mark::operating_point_mark;
use crate::experiments::map::figures::known_lines;
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::readout;
use crate::experiments::trajectories::curves::point_marks;
use crate::experiments::zones::figures::present_zones;
use crate::experiments::{Drawer, Outcome, Words};
use slipmode_plot::figure::{Side, ZoneMap};

pub(crate) const FIGURES: &[Drawer] = &[("operating-map", |outcome, words| operating_map(outcome, words))];

fn operating_map(outcome: &Outcome, words: &Words) -> Option<String> {
    let scene = outcome.scenes.iter().find(|scene| scene.operating_point.is_some())?;
    let (map, boundary) = (scene.map.as_ref()?, scene.boundary.as_ref()?);
    let (x, y) = axes(map)?;
    let modes = map.values.iter().map(|point| point.slip_mode);
    let runs = point_marks(scene, "", |id| id.replace('-', " "), Side::Right);
    let marks =
        if runs.is_empty() { operating_point_mark(scene, &x, &y).into_iter().collect() } else { runs };
    let zones = present_zones(modes, map.loading_velocity_m_per_s.len(), &x, &y);
    let lines = known_lines(scene, boundary, &x, &y);
    let drawn = ZoneMap { zones, lines, marks, x, y, ..words.drawing()? };
    Some(drawn.svg_with(Some(&readout(map, boundary))))
}
