//! Claims F: the friction law and its two evolution laws.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated_friction::in_simulations;
use crate::claims::{Check, Finding};
use crate::experiments::{Context, Need};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::theory::{regularised, steady_state};

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "F3",
        criterion: "As V → 0 at fixed θ, dθ/dt tends to 1 by eq 2 and to 0 by eq 3.",
        not_established: "Which of the two laws a given material follows.",
        needs: &[],
        equations: &["2", "3"],
        rests_on: &["F1"],
        decide: |context| Finding::from_proofs([steady_state::laws_differ_at_rest(context.equations)]),
    },
    Check {
        id: "F4",
        criterion: "The regularised law has the same linearisation at steady sliding, except for a certified relative difference. In every run, its velocity at the same friction and state differs from that of eq 1 by less than 64-bit arithmetic resolves, in units of V_l.",
        not_established: "Runs outside the grid of fig 3a; values of μ0 other than 0.6.",
        needs: &[Need::Simulations],
        equations: &["1", "8", "regularised", "steady-state"],
        rests_on: &["L3"],
        decide: f4,
    },
];

/// μ0 of the comparison, as the claim states it: 3/5.
fn reference_friction() -> Rational {
    Rational::from((3, 5))
}

fn f4(context: &Context) -> Finding {
    let Some(parameters) = context.outcome.potentially_unstable().and_then(|scene| scene.slider()) else {
        return Finding::not_checked("No scene of the report has a < b, so the direct effect a is unknown.");
    };
    match regularised::bound(context.equations, &reference_friction(), &parameters.direct_effect) {
        Err(refutation) => Finding::from_proofs([Err(refutation)]),
        Ok(difference) => {
            let bound = difference.log10_bound;
            let linear = Finding::from_proofs([Ok(difference.proof)]).on(format!(
                "a relative difference of σ in eq 8 below 1e{bound}, for μ0 = 0.6 and the scene's a"
            ));
            let analysis = |words| Draft::new(words).part("linear analysis", linear.clone());
            let study = analysis("the study: its linear analysis and its simulations");
            let study = in_simulations(context, study, nearest_f64(&reference_friction()));
            of_readings([study, analysis("the linear analysis alone")])
                .remark("The two laws are not identical: the regularised law multiplies a and b by a factor below 1. In 64-bit arithmetic this factor rounds to 1.")
        }
    }
}
