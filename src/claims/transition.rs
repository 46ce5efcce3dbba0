//! Claims S: the stability transition K = K_c.

use crate::claims::{Check, Finding};
use crate::experiments::Context;
use slipmode_core::theory::transition;

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "S1",
        criterion: "For a < b eq 8 factors with a pure imaginary pair when K = K_c, and the Routh-Hurwitz condition for stability is K > K_c.",
        not_established: "The effect of a finite disturbance near K = K_c.",
        needs: &[],
        rests_on: &["L3"],
        decide: |context| Finding::from_proofs([transition::stability(context.equations)]),
    },
    Check {
        id: "S2",
        criterion: "Eq 9 is the sum of eqs 10 and 11. Of σ, M and V0, eq 10 contains only σ, and eq 11 contains only M·V0².",
        not_established: "Whether kinetic energy is the physical cause: both terms also contain a, b and D_c.",
        needs: &[],
        rests_on: &["S1"],
        decide: |context| Finding::from_proofs([transition::parts(context.equations)]),
    },
    Check {
        id: "S3",
        criterion: "K_c rises with V0 without bound, so it exceeds every K > 0 at some velocity.",
        not_established: "The behaviour at velocities where rate-and-state friction no longer describes the contact.",
        needs: &[],
        rests_on: &["S1"],
        decide: s3,
    },
    Check {
        id: "S4",
        criterion: "K < K_c is equivalent to V²/V_c² + σ/σ_c > 1, so V > V_c or σ > σ_c suffices, and both lines are asymptotes.",
        not_established: "The converse: the slider can be unstable with both below their critical values.",
        needs: &[],
        rests_on: &["S1"],
        decide: s4,
    },
    Check {
        id: "S5",
        criterion: "For a > b all Routh-Hurwitz quantities of eq 8 are positive for all K, M, σ and V0.",
        not_established: "Nonlinear stability.",
        needs: &[],
        rests_on: &["S1"],
        decide: |context| Finding::from_proofs([transition::intrinsically_stable(context.equations)]),
    },
    Check {
        id: "S6",
        criterion: "Eq 23 is a root of eq 8 when K is replaced by eq 9.",
        not_established: "The frequency away from K = K_c.",
        needs: &[],
        rests_on: &["S1"],
        decide: |context| Finding::from_proofs([transition::crossing_frequency(context.equations)]),
    },
];

fn s3(context: &Context) -> Finding {
    let finding = Finding::from_proofs([transition::velocity_destabilises(context.equations)]);
    match transition::intrinsically_stable(context.equations) {
        Ok(stable) => finding
            .within("a < b only: then every velocity above V_c √(1 − σ/σ_c) is unstable; for σ ≥ σ_c every velocity is unstable.")
            .outside("For a > b no velocity makes the slider unstable.")
            .with_proof(Ok(stable)),
        Err(refutation) => finding.with_proof(Err(refutation)),
    }
}

fn s4(context: &Context) -> Finding {
    Finding::from_proofs([transition::critical_stress_and_velocity(context.equations)])
        .remark("The condition is sufficient, not necessary: with σ = 3σ_c/4 and V = 3V_c/4 neither is exceeded, and V²/V_c² + σ/σ_c = 21/16 > 1.")
}
