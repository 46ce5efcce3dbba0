//! The friction law and its regularised form.

use crate::claims::computed::Asked;
use crate::claims::{Check, Finding};
use crate::experiments::Context;
use crate::scene::cited;
use slipmode_core::number::Rational;
use slipmode_core::theory::regularised;

pub(super) const CHECKS: &[Check] = &[Check {
    name: "difference-of-the-regularised-law",
    is_of_runs: false,
    roles: &[],
    needs: &[],
    decide: in_linear_analysis,
}];

/// μ0 of the comparison, as the claim states it: 3/5.
fn reference_friction() -> Rational {
    Rational::from((3, 5))
}

fn in_linear_analysis(context: &Context, asked: Asked) -> Finding {
    let Some(parameters) = context.outcome.potentially_unstable().and_then(|scene| scene.slider()) else {
        return Finding::not_checked("No scene of the report has a < b, so the direct effect a is unknown.");
    };
    match regularised::bound(&reference_friction(), &parameters.direct_effect) {
        Err(refutation) => Finding::from_proofs([Err(refutation)]),
        Ok(difference) => asked.proved().with_proof(Ok(difference.proof)).on(cited(&format!(
            "a relative difference of σ in {{characteristic}} below 1e{}, for μ0 = 0.6 and the scene's a",
            difference.log10_bound
        ))),
    }
}
