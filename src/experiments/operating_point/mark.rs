//! The operating point of a scene as a mark on a map.

use super::words::point_of;
use crate::experiments::SceneOutcome;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, PointMark, Side};

/// The scene's operating point as a mark on a map, its name towards the middle; none when the scene states none, or outside of the axes.
pub(crate) fn operating_point_mark(scene: &SceneOutcome, x: &Axis, y: &Axis) -> Option<PointMark> {
    let point = point_of(scene)?;
    let place = (nearest_f64(&point.loading_velocity_m_per_s), nearest_f64(&point.normal_stress_pa));
    let is_inside = (x.min..=x.max).contains(&place.0) && (y.min..=y.max).contains(&place.1);
    let side = if place.0 > (x.min * x.max).sqrt() { Side::Left } else { Side::Right };
    is_inside.then(|| PointMark::new("operating point", place, side))
}
