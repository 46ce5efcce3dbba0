//! The friction law and its regularised form.

use crate::claims::Finding;
use crate::claims::check::Asked;
use crate::experiments::Context;
use crate::scene::cited;
use slipmode_core::number::Rational;
use slipmode_core::theory::regularised;

/// μ0 of the comparison, as the claim states it: 3/5.
fn reference_friction() -> Rational {
    Rational::from((3, 5))
}

pub(super) fn in_linear_analysis(context: &Context, asked: Asked) -> Finding {
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
