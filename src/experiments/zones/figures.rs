//! Maps of slip modes over the (V, σ) plane (fig 7).

use crate::experiments::map::figures::theory_lines;
use crate::experiments::operating_point::mark::operating_point_mark;
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::{asymptote_lines, axes, cusp_mark, pair_line, transition_line};
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::{Arc, Classification, PairRatio, SlipMode, asymptote};
use slipmode_plot::figure::{Axis, Line, LineRole, PointMark, Readout, Zone, ZoneMap, zones_of_grid};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-7a", |outcome, words| zone_map(outcome.potentially_unstable()?, words, "fig-1")),
    ("fig-7b", |outcome, words| zone_map(outcome.never_unstable()?, words, "fig-6a")),
];

/// The zones. A map of frequencies over the same axes has the words that are read out at the points.
fn zone_map(scene: &SceneOutcome, words: &Words, frequencies: &str) -> Option<String> {
    let (zones, boundary) = (scene.zones.as_ref()?, scene.boundary.as_ref()?);
    let (x, y) = axes(&zones.exact)?;
    let same_axes = |map: &Grid<Classification>| {
        axes(map).is_some_and(|(other_x, other_y)| (&other_x, &other_y) == (&x, &y))
    };
    let said = scene.map.as_ref().filter(|map| same_axes(map)).map(|_| Readout::SameAs(frequencies.into()));
    let drawing: ZoneMap = words.drawing()?;
    let map = |grid: &Grid<SlipMode>, lines: Vec<Line>, marks: Vec<PointMark>| {
        let zones = present_zones(grid.values.iter().copied(), grid.loading_velocity_m_per_s.len(), &x, &y);
        ZoneMap { zones, lines, marks, x: x.clone(), y: y.clone(), ..drawing.clone() }
    };
    let parameters = scene.slider()?;
    let straight = asymptote_lines(parameters, &x, &y).into_iter().chain(transition_line(parameters, &x, &y));
    let corners = [Arc::Upper, Arc::Lower].map(|arc| asymptote::corner(arc, &parameters.map(nearest_f64)));
    let ends = corners.map(|corner| (corner.loading_velocity_m_per_s, corner.normal_stress_pa));
    let between =
        ends[0].1.is_finite().then(|| Line::new("line between the corners", LineRole::Guide, ends.to_vec()));
    let own = || operating_point_mark(scene, &x, &y);
    let marks = cusp_mark(&boundary.points).into_iter().chain(own()).collect();
    let mut exact_lines = theory_lines(scene, boundary, &x, &y);
    exact_lines.push(pair_line(parameters, &PairRatio::Frequency(scene.scene.threshold())));
    let exact = map(&zones.exact, exact_lines, marks);
    let of_the_paper =
        map(&zones.between_corners, straight.chain(between).collect(), own().into_iter().collect());
    let headings = ["exact", "by the lines of the paper"];
    Some(exact.svg_beside(&of_the_paper, headings, said.as_ref()))
}

/// The slip modes that occur on a grid with rows of so many columns.
pub(crate) fn present_zones(
    modes: impl Iterator<Item = SlipMode>,
    columns: usize,
    x: &Axis,
    y: &Axis,
) -> Vec<Zone> {
    let class = |mode: SlipMode| SlipMode::ALL.iter().position(|known| *known == mode).unwrap_or(0);
    let classes: Vec<usize> = modes.map(class).collect();
    let outlines = zones_of_grid(x, y, columns, &classes, SlipMode::ALL.len());
    let zones = SlipMode::ALL.iter().zip(outlines).enumerate();
    zones
        .filter(|(_, (_, outlines))| !outlines.is_empty())
        .map(|(style, (mode, outlines))| Zone { label: mode.words().into(), outlines, style })
        .collect()
}
