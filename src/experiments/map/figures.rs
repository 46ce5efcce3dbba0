//! Maps of max Im(s) over the (V, σ) plane (figs 1 and 6a).

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::map::MapPoint;
use crate::experiments::operating_point::mark::operating_point_mark;
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::{asymptote_lines, axes, boundary_lines, cusp_mark, transition_line};
use crate::experiments::shared::bands::{FINE, band_lines};
use crate::experiments::shared::map_readout::readout;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Arc;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::figure::{Axis, ColourScale, HeatMap, Line, LineRole};

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

fn frequency_map(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let (map, boundary) = (scene.map.as_ref()?, scene.boundary.as_ref()?);
    let (x, y) = axes(map)?;
    let parameters = scene.slider()?;
    let natural = parameters.map(nearest_f64).natural_angular_frequency_per_s();
    let heat_map = HeatMap {
        caption: words.caption.clone(),
        columns: map.loading_velocity_m_per_s.len(),
        values: frequencies(map),
        colours: ColourScale::new("max Im(*s*)", "1/s", (natural * 1e-4, natural), STEPS).with_contours(
            "79, 90 and 99 % of √(*K*/*M*)",
            NEARLY_NATURAL.map(|share| share * natural).to_vec(),
        ),
        zero_areas: zero_areas(&boundary.points, &x, &y),
        zero_label: "max Im(*s*) = 0 exactly".into(),
        lines: theory_lines(scene, boundary, &x, &y),
        marks: cusp_mark(&boundary.points).into_iter().chain(operating_point_mark(scene, &x, &y)).collect(),
        x,
        y,
    };
    Some(heat_map.svg_with(Some(&readout(map, boundary))))
}

/// Colour steps of the map: six a decade.
const STEPS: usize = 24;

/// Shares of the natural angular frequency at which the map has a line: all of the brightest colour or close to it.
const NEARLY_NATURAL: [f64; 3] = [0.79, 0.9, 0.99];

fn frequencies(map: &Grid<MapPoint>) -> Vec<f64> {
    map.values.iter().map(|point| point.max_imaginary_per_s.to_f64().unwrap_or(0.0)).collect()
}

/// The areas without oscillation, closed along the edges of the map.
pub(crate) fn zero_areas(points: &[BoundaryPoint], x: &Axis, y: &Axis) -> Vec<Vec<(f64, f64)>> {
    [(Arc::Upper, y.max), (Arc::Lower, y.min)]
        .into_iter()
        .filter_map(|(arc, edge)| {
            let mut outline: Vec<(f64, f64)> = points
                .iter()
                .filter(|point| point.arc == arc)
                .map(|point| (point.loading_velocity_m_per_s.to_f64(), point.normal_stress_pa.to_f64()))
                .collect();
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
