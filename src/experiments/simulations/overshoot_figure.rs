//! The map of simulated overshoots for a > b with the theory's lines over it (fig 6a).

use crate::experiments::map::figures::theory_lines;
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::simulated_readout;
use crate::experiments::simulations::SimulatedPoint;
use crate::experiments::trajectories::curves::point_marks;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::figure::{ColourScale, HeatMap, Side};

pub(crate) const FIGURES: &[Drawer] =
    &[("fig-6a-simulated", |outcome, words| overshoot_map(outcome.never_unstable()?, words))];

/// The law of the paper's figure.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

fn overshoot_map(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let outcome = scene.simulations.as_ref()?;
    let (_, grid) = outcome.grids.iter().find(|(law, _)| *law == LAW)?;
    let (x, y) = axes(grid)?;
    let boundary = scene.boundary.as_ref()?;
    let map = HeatMap {
        caption: words.caption.clone(),
        columns: grid.loading_velocity_m_per_s.len(),
        values: grid.points().map(|(velocity, _, point)| overshoot(velocity, point)).collect(),
        colours: ColourScale::new("Overshoot *V*/*V*_l − 1", "", (0.01, 1.0), 20),
        zero_areas: Vec::new(),
        zero_label: "never faster than *V*_l".into(),
        lines: theory_lines(scene, boundary, &x, &y),
        marks: point_marks(scene, "6", first_of_a_panel, Side::Left),
        x,
        y,
    };
    Some(map.svg_with(Some(&simulated_readout(grid, boundary))))
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
