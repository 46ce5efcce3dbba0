//! The map of simulated peak velocities with the theory's lines over it (fig 3a).

use crate::experiments::map::figures::theory_lines;
use crate::experiments::onset::{Onset, ShownRun};
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::simulated_readout;
use crate::experiments::simulations::{LeastPeak, SimulatedPoint, SimulationsOutcome};
use crate::experiments::trajectories::curves::point_marks;
use crate::experiments::{Figure, FigureMaker, Need, SceneOutcome};
use crate::scene::cited;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{Caption, ColourScale, HeatMap, Line, LineRole, PointMark, Side};

pub(crate) const FIGURES: &[FigureMaker] = &[FigureMaker::new(
    "fig-3a",
    &[Need::Simulations, Need::Boundary],
    &["simulations", "least-peaks"],
    |outcome| peak_map(outcome.potentially_unstable()?),
)];

const TITLE: &str = "Peak velocity of the simulated limit cycles, slip law, a < b";
const DESCRIPTION: &str = "Map over loading velocity and normal stress. Simulations that end in steady sliding fill the lower left, without colour, up to the line of the transition. Beyond it the peak velocity rises with normal stress; from left to right it falls to a minimum near {inertial-upper} and then rises.";
const LETTERS: &str = " Letters mark the points of figs 3b to 3g, and 4a and 4b their runs.";
const CAPTION: &str = "Peak velocity of the limit cycle, simulated on a grid with the slip law (compare fig 3a of the paper), with the exact boundary, its asymptotes and the transition of the linear theory. Points that end in steady sliding have no colour. The dotted line joins the lowest peak velocities at given normal stress (compare fig 5). The edge of the colour lies half-way between grid points. The paper has one circle a simulation and an approximate line between fast and slow oscillation; the exact boundary and the line of lowest peaks are added here.";

fn peak_map(scene: &SceneOutcome) -> Option<Figure> {
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
        caption: Caption::new("fig-3a", TITLE, &cited(DESCRIPTION)),
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
    highest.is_normal().then(|| {
        Figure::new(
            &map.caption,
            "Figure 3a",
            &if scene.trajectories.is_some() { format!("{CAPTION}{LETTERS}") } else { CAPTION.into() },
            map.svg_with(Some(&simulated_readout(grid, boundary))),
        )
    })
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
