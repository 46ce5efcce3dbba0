//! Maps of simulations with the theory's lines over them: peak velocities (fig 3a), and overshoots for a > b (fig 6a).

use crate::experiments::described::extent;
use crate::experiments::map::figures::heat_map;
use crate::experiments::onset::{Onset, ShownRun};
use crate::experiments::shared::map_readout::simulated_readout;
use crate::experiments::simulations::{LeastPeak, SimulatedPoint, SimulationsOutcome};
use crate::experiments::trajectories::curves::point_marks;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{HeatMap, Line, LineRole, PointMark, Side};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-3a", |outcome, words| peak_map(outcome.potentially_unstable()?, words)),
    ("fig-6a-simulated", |outcome, words| overshoot_map(outcome.never_unstable()?, words)),
];

const LETTERS: &str = " Letters mark the points of figs 3b to 3g, and 4a and 4b their runs.";

fn peak_map(scene: &SceneOutcome, words: &mut Words) -> Option<String> {
    words.fill(&[("letters", if scene.trajectories.is_some() { LETTERS } else { "" })]);
    let outcome = scene.simulations.as_ref()?;
    let (_, grid) = outcome.grids.iter().find(|(law, _)| *law == LAW)?;
    let mut map = heat_map(scene, words, grid, |_, point| peak_velocity(point))?;
    let positive = map.values.iter().copied().filter(|value| *value > 0.0);
    let (lowest, highest) = extent(positive)?;
    map.colours.min = libm::exp10(libm::log10(lowest).floor());
    map.colours.max = libm::exp10(libm::log10(highest).ceil());
    map.lines.push(least_peak_line(outcome, LAW));
    let letter = |id: &str| format!("**{}**", id.trim_start_matches('3'));
    map.marks = [point_marks(scene, "3", letter, Side::Right), onset_marks(scene)].concat();
    Some(map.svg_with(Some(&simulated_readout(grid, scene.boundary.as_ref()?))))
}

/// The runs of figs 4a and 4b; the fastest of each has the name of its figure.
fn onset_marks(scene: &SceneOutcome) -> Vec<PointMark> {
    let mark = |(line, letter): (&Onset, char)| {
        let stress = nearest_f64(&line.normal_stress_pa);
        let last = line.shown.len().saturating_sub(1);
        let one = |(index, run): (usize, &ShownRun)| {
            let label = if index == last { format!("**4{letter}**") } else { String::new() };
            PointMark::new(label, (run.loading_velocity_m_per_s, stress), Side::Right)
        };
        line.shown.iter().enumerate().map(one).collect::<Vec<_>>()
    };
    let lines = scene.onset.iter().flat_map(|onset| &onset.lines);
    lines.filter(|line| line.asymptote == Asymptote::InertialLower).zip('a'..).flat_map(mark).collect()
}

/// The law of the paper's figures.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

/// The minima of the peak velocity with one law.
pub(crate) fn least_peak_line(outcome: &SimulationsOutcome, law: EvolutionLaw) -> Line {
    let place = |least: &LeastPeak| {
        (least.eq18_velocity_m_per_s * libm::exp10(least.offset_dex), least.normal_stress_pa)
    };
    Line::new(
        "lowest peak velocity at given *σ*",
        LineRole::Guide,
        outcome.least_peaks.iter().filter(|least| least.law == law).map(place).collect(),
    )
}

/// The peak velocity of a limit cycle, m/s; 0, which a map leaves uncoloured, for a decay or a run without a result.
pub(crate) fn peak_velocity(point: &SimulatedPoint) -> f64 {
    match (&point.simulation, point.periodic()) {
        (Ok(simulation), Some(true)) => simulation.peak_velocity_m_per_s,
        _ => 0.0,
    }
}

fn overshoot_map(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let outcome = scene.simulations.as_ref()?;
    let (_, grid) = outcome.grids.iter().find(|(law, _)| *law == LAW)?;
    let marks = point_marks(scene, "6", first_of_a_panel, Side::Left);
    let map = HeatMap { marks, ..heat_map(scene, words, grid, overshoot)? };
    Some(map.svg_with(Some(&simulated_readout(grid, scene.boundary.as_ref()?))))
}

/// The panel's letter at its first point: `b` for `6b-1`.
fn first_of_a_panel(id: &str) -> String {
    id.strip_suffix("-1").map_or_else(String::new, |name| format!("**{}**", name.trim_start_matches('6')))
}

/// V_peak/V_l − 1 of a decay; 0, which a map leaves uncoloured, within its error, and where there is no result.
fn overshoot(velocity: f64, point: &SimulatedPoint) -> f64 {
    let Ok(simulation) = &point.simulation else { return 0.0 };
    let overshoot = simulation.peak_velocity_m_per_s / velocity - 1.0;
    let seen = point.periodic() == Some(false) && overshoot > simulation.peak_relative_error;
    if seen { overshoot } else { 0.0 }
}
