//! Strong vibration: limit cycles with growing η at κ = 1, where the least friction and the harmonics approach their laws.

use crate::parallel;

use crate::experiments::simulations::CYCLE_TOLERANCE;
use slipmode_core::dynamics::{LongTerm, Model, Options, Profile, simulate_model};
use slipmode_core::friction::{EvolutionLaw, Groups};

/// One limit cycle with κ = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrongVibration {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: f64,
    /// ln(V_min/V_l).
    pub log_trough: f64,
    /// What the cycle shows.
    pub profile: Profile,
}

/// η of the runs, evenly in logarithm.
const INERTIAL_PARAMETERS: [f64; 4] = [1e6, 1e8, 1e10, 1e12];

/// Ratio of neighbouring η.
pub const STEP: f64 = 100.0;

/// Tolerance of the runs.
const TOLERANCE: f64 = 1e-6;

/// The limit cycles of each law by ascending η; a run without a limit cycle or a result is left out.
pub(crate) fn strong_vibrations(effect_ratio: f64, laws: &[EvolutionLaw]) -> Vec<StrongVibration> {
    let cases = laws.iter().flat_map(|&law| INERTIAL_PARAMETERS.map(|inertial| (law, inertial)));
    let cases: Vec<(EvolutionLaw, f64)> = cases.collect();
    parallel::flat_map(&cases, |&(law, inertial)| strong_vibration(effect_ratio, law, inertial))
}

fn strong_vibration(
    effect_ratio: f64,
    law: EvolutionLaw,
    inertial_parameter: f64,
) -> Option<StrongVibration> {
    let model = Model::new(Groups { inertial_parameter, stiffness_group: 1.0, effect_ratio }, law);
    let found = simulate_model(&model, &Options::at(TOLERANCE)).ok()?;
    let LongTerm::Cycle(cycle) = found.long_term() else { return None };
    let profile = Profile::of(&model, cycle.from, cycle.orbit.duration, CYCLE_TOLERANCE).ok()?;
    Some(StrongVibration { law, inertial_parameter, log_trough: cycle.orbit.trough, profile })
}
