//! The edge of bistability of the aging law as η → 0, by the balance of small terms along the closed orbits without inertia.

use slipmode_core::dynamics::edge_orbit;
use slipmode_core::number::search::minimum_between;

/// Step along an orbit, and distance of the orbits from which the largest value is refined, in ln V_peak.
const STEP: f64 = 0.04;
const STENCIL: f64 = 0.03;

/// The fold of the cycles by the law, each value with what twice the step changes of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeLaw {
    /// K/K_c − 1.
    pub excess: [f64; 2],
    /// ln(V_peak/V_l).
    pub log_peak: [f64; 2],
}

impl EdgeLaw {
    /// The largest K/K_c − 1 over the closed orbits, and where.
    pub(crate) fn new(effect_ratio: f64, inertial_parameter: f64) -> Option<Self> {
        let [fine, coarse] = [STEP, 2.0 * STEP].map(|step| fold(effect_ratio, inertial_parameter, step));
        let (fine, coarse) = (fine?, coarse?);
        let [excess, log_peak] = [0, 1].map(|n| [fine[n], (fine[n] - coarse[n]).abs()]);
        Some(Self { excess, log_peak })
    }
}

fn fold(effect_ratio: f64, eta: f64, step: f64) -> Option<[f64; 2]> {
    let excess = |log_peak: f64| Some(edge_orbit(effect_ratio, log_peak, step)?.stiffness_excess(eta));
    let ends = (0.1, 1.0 - libm::log(0.1 * eta) / 3.0);
    let log_peak = minimum_between(|at| Some(-excess(at)? / eta), ends, STENCIL, f64::EPSILON)?.at;
    Some([excess(log_peak)?, log_peak])
}
