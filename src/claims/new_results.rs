//! Claims X: what this project states of its own, decided like the claims of the paper.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::{Check, Finding, new_edge, new_peak};
use crate::experiments::{Context, Need};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::theory::hopf::{along_velocity, degenerate_inertial_parameter};

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "X1",
        criterion: "With the slip law, in every limit cycle of the grid that is deep stick-slip, stress drop and peak velocity follow the formulas up to what the spring loses while the state weakens, and the distance of the lowest peak from its formula falls at every step of σ.",
        not_established: "Values of the remainder beyond the grid, and other values of b/a. Next to b/a = 1 the stress drop is not large against aσ, and the contact remembers the previous slip. Next to K = K_c,qs the slip is not long against D_c.",
        needs: &[Need::Simulations],
        equations: &["18"],
        rests_on: &["N7"],
        decide: |context| new_peak::decide(context, EvolutionLaw::Slip).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "X2",
        criterion: "The same with the aging law, whose strength contains the logarithm of the stick's duration.",
        not_established: "Values of the remainder beyond the grid, and other values of b/a. Next to b/a = 1 the stress drop is not large against aσ, and the contact remembers the previous slip. Next to K = K_c,qs the slip is not long against D_c.",
        needs: &[Need::Simulations],
        equations: &["18"],
        rests_on: &["N7"],
        decide: |context| {
            new_peak::decide(context, EvolutionLaw::Aging).unwrap_or_else(|undecided| undecided)
        },
    },
    Check {
        id: "X3",
        criterion: "η rises along K = K_c with velocity; the first Lyapunov coefficient of the aging law is positive below one velocity and negative above it, and that of the slip law negative everywhere, for all b/a > 1.",
        not_established: "Other friction laws. With a steady-state friction that has a minimum in velocity, Putelat, Dawes & Willis (2010) find the order of the experiments.",
        needs: &[],
        equations: &["1", "2", "3", "4", "8", "9", "inertial-parameter", "steady-state"],
        rests_on: &["S1"],
        decide: x3,
    },
    Check {
        id: "X4",
        criterion: "At every η up to 0.01, K/K_c − 1 at the fold of the aging law's cycles is the largest value of the balance over the closed orbits without inertia, within the relative size η V_peak² of the terms left out.",
        not_established: "A proof that the balance is asymptotic: the term of second order is derived for large orbits. Other values of b/a.",
        needs: &[Need::NearTransition],
        equations: &["1", "2", "4", "steady-state"],
        rests_on: &["N4"],
        decide: |context| new_edge::decide(context).unwrap_or_else(|undecided| undecided),
    },
];

/// Standard gravity, m/s².
const GRAVITY: f64 = 9.80665;

fn x3(context: &Context) -> Finding {
    let path = || along_velocity(context.equations);
    let sign = |law| context.hopf_coefficient(law).map(|hopf| hopf.proof.clone());
    let written = Draft::new("σ = M g, with V and K/M as axes: every b/a > 1")
        .part("η rises with V along K = K_c", Finding::from_proof(path()))
        .part(
            "with the aging law the transition is subcritical below V = √(η_0 g a D_c) and supercritical above, with η_0 = 1/(3 + 2√(b/a + 3))",
            Finding::from_proofs([path(), sign(EvolutionLaw::Aging)]),
        )
        .part(
            "with the slip law the transition is supercritical at every V",
            Finding::from_proof(sign(EvolutionLaw::Slip)),
        );
    let finding = of_readings([written])
        .remark("Experiments with paper on paper (Heslot et al. 1994) show the opposite order; Lim & Chen (cond-mat/9803217) and Putelat, Dawes & Willis (2010) reproduce it with other friction laws. Eqs 1 to 4 with either law do not, at any b/a > 1. That inertia raises the critical stiffness is due to Rice & Ruina (1983); that the slider without inertia has closed orbits at K = K_c, to Gu, Rice, Ruina & Tse (1984) for the slip law and to Ranjith & Rice (1999) for the aging law.");
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
