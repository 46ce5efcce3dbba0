//! Maps of max Im(s) over the (V, σ) plane (figs 1 and 6a).

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::operating_point::mark::operating_point_mark;
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::{
    arc_points, asymptote_lines, axes, boundary_lines, cusp_mark, transition_line,
};
use crate::experiments::shared::bands::{FINE, band_lines};
use crate::experiments::shared::map_readout::readout;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_core::stability::{Arc, Classification};
use slipmode_plot::figure::{Axis, HeatMap, Line, LineRole};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-1", |outcome, words| frequency_map(outcome.potentially_unstable()?, words)),
    ("fig-6a", |outcome, words| frequency_map(outcome.never_unstable()?, words)),
];

pub(crate) fn theory_lines(
    scene: &SceneOutcome,
    boundary: &BoundaryOutcome,
    x: &Axis,
    y: &Axis,
) -> Vec<Line> {
    let mut lines = known_lines(scene, boundary, x, y);
    let formulas = scene.slider().map_or_else(Vec::new, |slider| asymptote_lines(slider, x, y));
    // The transition is drawn above the formulas.
    let above = lines.iter().position(|line| line.role == LineRole::Transition).unwrap_or(lines.len());
    lines.splice(above..above, formulas);
    lines
}

/// The exact lines with their error bands, those alone that may cross the map.
pub(crate) fn known_lines(scene: &SceneOutcome, boundary: &BoundaryOutcome, x: &Axis, y: &Axis) -> Vec<Line> {
    let Some(parameters) = scene.slider() else { return Vec::new() };
    let mut lines = error_bands(scene, x, y);
    lines.extend(boundary_lines(&boundary.points));
    lines.extend(transition_line(parameters, x, y));
    lines.retain(|line| may_cross(line, x, y));
    lines
}

/// Whether the rectangle around a piece of a line meets a map.
fn may_cross(line: &Line, x: &Axis, y: &Axis) -> bool {
    let meets = |axis: &Axis, one: f64, next: f64| one.min(next) <= axis.max && one.max(next) >= axis.min;
    line.points.windows(2).any(|piece| {
        let [one, next] = [piece[0], piece[1]];
        meets(x, one.0, next.0) && meets(y, one.1, next.1)
    })
}

/// Where the boundary and the transition lie for the values within the scene's error bars.
fn error_bands(scene: &SceneOutcome, x: &Axis, y: &Axis) -> Vec<Line> {
    let region = scene.scene.parameters.as_ref().and_then(|parameters| parameters.error_bars.as_ref());
    region.map_or_else(Vec::new, |region| band_lines(region, x, y, FINE))
}

/// The described map of the values of a grid, with the lines of theory over it.
pub(crate) fn heat_map<T>(
    scene: &SceneOutcome,
    words: &Words,
    grid: &Grid<T>,
    value: impl Fn(f64, &T) -> f64,
) -> Option<HeatMap> {
    let (x, y) = axes(grid)?;
    let values = grid.points().map(|(velocity, _, point)| value(velocity, point)).collect();
    let lines = theory_lines(scene, scene.boundary.as_ref()?, &x, &y);
    let columns = grid.loading_velocity_m_per_s.len();
    Some(HeatMap { columns, values, lines, x, y, ..words.drawing()? })
}

fn frequency_map(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let (grid, boundary) = (scene.map.as_ref()?, scene.boundary.as_ref()?);
    let frequency = |_, point: &Classification| point.max_imaginary_per_s.to_f64().unwrap_or(0.0);
    let mut map = heat_map(scene, words, grid, frequency)?;
    let natural = scene.slider()?.map(nearest_f64).natural_angular_frequency_per_s();
    (map.colours.min, map.colours.max) = (natural * 1e-4, natural);
    // They are described as shares of the natural angular frequency.
    map.colours.contours.iter_mut().for_each(|level| *level *= natural);
    map.zero_areas = zero_areas(&boundary.points, &map.x, &map.y);
    map.marks = cusp_mark(&boundary.points);
    map.marks.extend(operating_point_mark(scene, &map.x, &map.y));
    Some(map.svg_with(Some(&readout(grid, boundary))))
}

/// The areas without oscillation, closed along the edges of the map.
pub(crate) fn zero_areas(points: &[BoundaryPoint], x: &Axis, y: &Axis) -> Vec<Vec<(f64, f64)>> {
    [(Arc::Upper, y.max), (Arc::Lower, y.min)]
        .into_iter()
        .filter_map(|(arc, edge)| {
            let mut outline = arc_points(points, arc);
            let (first, last) = (*outline.first()?, *outline.last()?);
            // The arc runs from the slow (quasi-static) end to the inertial one; both ends go on along their asymptote.
            let outside = x.min.min(first.0);
            outline.insert(0, (outside, first.1));
            outline.push((last.0, if arc == Arc::Upper { edge.max(last.1) } else { edge.min(last.1) }));
            outline.push((outside, if arc == Arc::Upper { edge.max(last.1) } else { edge.min(last.1) }));
            Some(outline)
        })
        .collect()
}
