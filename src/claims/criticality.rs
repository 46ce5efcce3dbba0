//! The kind of the transition along the loading velocity, by the sign of the first Lyapunov coefficient.

use crate::claims::Finding;
use crate::claims::check::Asked;
use crate::claims::reading::{Draft, of_readings};
use crate::experiments::Context;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_theory::hopf::degenerate_inertial_parameter;

/// Standard gravity, m/s².
const GRAVITY: f64 = 9.80665;

pub(super) fn sign_of_lyapunov_coefficient(context: &Context, asked: Asked) -> Finding {
    let path = asked.proved();
    let sign = |law| context.hopf_coefficient(law).map(|hopf| hopf.proof.clone());
    let written = Draft::new("σ = M g, with V and K/M as axes: every b/a > 1")
        .part("η rises with V along K = K_c", path.clone())
        .part(
            "with the aging law the transition is subcritical below V = √(η_0 g a D_c) and supercritical above, with η_0 = 1/(3 + 2√(b/a + 3))",
            path.with_proof(sign(EvolutionLaw::Aging)),
        )
        .part(
            "with the slip law the transition is supercritical at every V",
            Finding::from_proof(sign(EvolutionLaw::Slip)),
        );
    let finding = of_readings([written]);
    let slider = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let Some(slider) = slider.map(|slider| slider.map(nearest_f64)) else { return finding };
    let eta = degenerate_inertial_parameter(slider.effect_ratio());
    let velocity = (eta * GRAVITY * slider.direct_effect * slider.critical_slip_distance_m).sqrt();
    finding.remark(format!(
        "With the friction parameters of the simulations, the aging law changes from subcritical to supercritical at η_0 = {}, V = {} m/s.",
        round_digits(eta, 4),
        round_digits(velocity, 3)
    ))
}
