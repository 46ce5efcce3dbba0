//! Maps of slip modes over the (V, σ) plane (fig 7).

use crate::experiments::map::MapPoint;
use crate::experiments::map::figures::{FIG_1, FIG_6A, Words, theory_lines};
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::{axes, cusp_mark};
use crate::experiments::{Figure, FigureMaker, Need, SceneOutcome};
use slipmode_core::stability::SlipMode;
use slipmode_plot::figure::{Caption, Readout, Zone, ZoneMap, zones_of_grid};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker::new("fig-7a", &[Need::Map, Need::Zones, Need::Boundary], &["zones"], |outcome| {
        zone_map(outcome.potentially_unstable()?, &FIG_7A, &FIG_1)
    }),
    FigureMaker::new("fig-7b", &[Need::Map, Need::Zones, Need::Boundary], &["zones"], |outcome| {
        zone_map(outcome.never_unstable()?, &FIG_7B, &FIG_6A)
    }),
];

const FIG_7A: Words = Words {
    id: "fig-7a",
    label: "Figure 7a",
    title: "Slip modes, a < b",
    caption: "Slip modes, decided exactly at every point (compare fig 7a of the paper), with the exact boundary, the asymptotes and the transition. The paper draws the zones with straight lines instead.",
    description: "Map of the slip modes over loading velocity and normal stress: overdamped stable sliding at low stress and low velocity, non-inertial and inertial underdamped oscillation around it, stick-slip at high stress, harmonic vibration at high velocity.",
};

const FIG_7B: Words = Words {
    id: "fig-7b",
    label: "Figure 7b",
    title: "Slip modes, a ≥ b",
    caption: "Slip modes for a ≥ b, decided exactly at every point (compare fig 7b of the paper). All modes are stable. The upper area is an overdamped oscillation. The paper draws the zones with straight lines instead.",
    description: "Map of the slip modes over loading velocity and normal stress: overdamped stable sliding, non-inertial and inertial underdamped oscillation, and overdamped oscillation at high stress.",
};

/// The zones, with the words of the map of frequencies over the same axes.
fn zone_map(scene: &SceneOutcome, words: &Words, frequencies: &Words) -> Option<Figure> {
    let (zones, boundary) = (scene.zones.as_ref()?, scene.boundary.as_ref()?);
    let (x, y) = axes(&zones.exact)?;
    let classes: Vec<usize> = zones
        .exact
        .values
        .iter()
        .map(|mode| SlipMode::ALL.iter().position(|known| known == mode).unwrap_or(0))
        .collect();
    let columns = zones.exact.loading_velocity_m_per_s.len();
    let outlines = zones_of_grid(&x, &y, columns, &classes, SlipMode::ALL.len());
    let present = SlipMode::ALL
        .iter()
        .zip(outlines)
        .enumerate()
        .filter(|(_, (_, outlines))| !outlines.is_empty())
        .map(|(style, (mode, outlines))| Zone { label: mode.words().into(), outlines, style })
        .collect();
    let lines = theory_lines(scene, boundary, &x, &y);
    let same_axes =
        |map: &Grid<MapPoint>| axes(map).is_some_and(|(other_x, other_y)| (&other_x, &other_y) == (&x, &y));
    let said =
        scene.map.as_ref().filter(|map| same_axes(map)).map(|_| Readout::SameAs(frequencies.id.into()));
    let map = ZoneMap {
        caption: Caption::new(words.id, words.title, words.description),
        zones: present,
        lines,
        marks: cusp_mark(&boundary.points),
        labels: Vec::new(),
        x,
        y,
    };
    Some(Figure::new(&map.caption, words.label, words.caption, map.svg_with(said.as_ref())))
}
