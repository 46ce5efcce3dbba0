//! The map of simulated peak velocities with the theory's lines over it (fig 3a).

use crate::experiments::map::figures::theory_lines;
use crate::experiments::onset::{Onset, ShownRun};
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::simulated_readout;
use crate::experiments::simulations::{LeastPeak, SimulatedPoint, SimulationsOutcome};
use crate::experiments::trajectories::curves::point_marks;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{ColourScale, HeatMap, Line, LineRole, PointMark, Side};

pub(crate) const FIGURES: &[Drawer] =
    &[("fig-3a", |outcome, words| peak_map(outcome.potentially_unstable()?, words))];

const LETTERS: &str = " Letters mark the points of figs 3b to 3g, and 4a and 4b their runs.";

fn peak_map(scene: &SceneOutcome, words: &mut Words) -> Option<String> {
    words.fill(&[("letters", if scene.trajectories.is_some() { LETTERS } else { "" })]);
    let outcome = scene.simulations.as_ref()?;
    let (_, grid) = outcome.grids.iter().find(|(law, _)| *law == LAW)?;
    let (x, y) = axes(grid)?;
    let values: Vec<f64> = grid.values.iter().map(peak_velocity).collect();
    let positive = || values.iter().copied().filter(|value| *value > 0.0);
    let lowest = positive().fold(f64::INFINITY, f64::min);
    let highest = positive().fold(0.0, f64::max);
    let boundary = scene.boundary.as_ref()?;
    let mut lines = theory_lines(scene, boundary, &x, &y);
    lines.push(least_peak_line(outcome, LAW));
    let map = HeatMap {
        caption: words.caption.clone(),
        columns: grid.loading_velocity_m_per_s.len(),
        colours: ColourScale::new(
            "Peak velocity",
            "m/s",
            (libm::exp10(libm::log10(lowest).floor()), libm::exp10(libm::log10(highest).ceil())),
            STEPS,
        ),
        values,
        zero_areas: Vec::new(),
        zero_label: "ends in steady sliding".into(),
        lines,
        marks: [
            point_marks(scene, "3", |id| format!("**{}**", id.trim_start_matches('3')), Side::Right),
            onset_marks(scene),
        ]
        .concat(),
        x,
        y,
    };
    highest.is_normal().then(|| map.svg_with(Some(&simulated_readout(grid, boundary))))
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

/// The law of the paper's figure.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

/// Colour steps of the map.
const STEPS: usize = 30;

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
