//! Lemmas of this package, stated as a report states its proofs.

use std::sync::LazyLock;

use super::names::Named;
use super::{StatedProof, StatedProofs};
use crate::notation::formula;
use slipmode_algebra::{Domain, Expression, Proof, Refutation};

/// The block that the proofs of a report may use.
pub(super) const FOR_REPORTS: &str = "positive-coefficients-of-a-cubic";

static LEMMAS: LazyLock<StatedProofs> = LazyLock::new(|| {
    let file = toml::from_str(include_str!("lemmas.toml")).unwrap_or_else(|error| panic!("{error}"));
    StatedProofs::read([file]).unwrap_or_else(|faults| panic!("lemmas.toml: {faults:?}"))
});

/// The proof of a lemma.
///
/// # Errors
/// Never, unless a step is at fault; the tests prove all of them.
pub(crate) fn lemma(id: &str) -> Result<Proof, Refutation> {
    LEMMAS.proved(id, &[])
}

/// Adds the steps of a block.
///
/// # Errors
/// Never, unless a step is at fault; the tests prove all of them.
pub(crate) fn add_block(proof: Proof, id: &str) -> Result<Proof, Refutation> {
    match LEMMAS.blocks.get(id) {
        Some(block) => LEMMAS.add_steps(proof, block, &[], 0),
        None => Err(proof.refute(id, &[], "there is no such lemma")),
    }
}

/// What a name of the lemmas stands for, or the formula that the text is.
pub(crate) fn named(text: &str) -> Expression {
    let meaning = LEMMAS.names.get(text).and_then(|form| form.expressions.first());
    meaning.cloned().unwrap_or_else(|| formula(text))
}

/// A domain of the lemmas.
///
/// # Panics
/// When there is none of this name: a slip in the program text, which the tests show.
pub(crate) fn stated_domain(name: &str) -> Domain {
    let nothing = StatedProof::default();
    let domain = LEMMAS.domain(name, &Named::new(&LEMMAS, &nothing, &[]));
    domain.unwrap_or_else(|fault| panic!("{fault}"))
}
