//! The friction law and its regularised form.

use crate::claims::Finding;
use crate::claims::check::{Asked, NO_NUMBER};
use crate::experiments::Context;
use crate::scene::cited;
use slipmode_theory::regularised;

/// In steady sliding with the friction μ0 that it is asked about.
pub(super) fn in_linear_analysis(context: &Context, asked: Asked) -> Finding {
    let Some(parameters) = context.outcome.potentially_unstable().and_then(|scene| scene.slider()) else {
        return Finding::not_checked("No scene of the report has a < b, so the direct effect a is unknown.");
    };
    let Some((written, friction)) = asked.number() else { return Finding::not_checked(NO_NUMBER) };
    match regularised::bound(&friction, &parameters.direct_effect) {
        Err(refutation) => Finding::from_proofs([Err(refutation)]),
        Ok(difference) => asked.proved().with_proof(Ok(difference.proof)).on(cited(&format!(
            "a relative difference of σ in {{characteristic}} below 1e{}, for μ0 = {written} and the scene's a",
            difference.log10_bound
        ))),
    }
}
