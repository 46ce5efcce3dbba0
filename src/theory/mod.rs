//! The paper's derivations as proofs over ℚ.
//!
//! The numbered equations are input data ([`PaperEquations`]). Each function derives its result from eqs 1-4 (or from
//! what was derived from them), compares it with what the paper states, and returns the proof or the refutation:
//! an equation with a wrong sign is refuted by name, with the exact remainder.

pub mod characteristic;
mod equations;
pub mod linearisation;
mod notation;
pub mod steady_state;
pub mod third_order;

pub use equations::{Equation, EquationFault, EquationsError, PaperEquations};

#[cfg(test)]
mod tests {
    use super::equations::tests::paper;
    use super::*;
    use crate::polynomial::{Proof, Refutation};

    type Prover = fn(&PaperEquations) -> Result<Proof, Refutation>;

    /// Every proof of this module, by the path of its function.
    const PROVERS: [(&str, Prover); 7] = [
        ("steady_state::prove", steady_state::prove),
        ("steady_state::laws_differ_at_rest", steady_state::laws_differ_at_rest),
        ("linearisation::laws_agree", linearisation::laws_agree),
        ("linearisation::prove", linearisation::prove),
        ("third_order::prove", third_order::prove),
        ("characteristic::prove", characteristic::prove),
        ("characteristic::dimensionless", characteristic::dimensionless),
    ];

    #[test]
    fn the_papers_equations_are_proved_and_the_proofs_recheck_after_a_round_trip() {
        for (name, prover) in PROVERS {
            let proof = prover(&paper()).unwrap_or_else(|refutation| panic!("{name}: {refutation}"));
            let text = serde_json::to_string(&proof).expect("serialisable");
            let read: Proof = serde_json::from_str(&text).expect("readable");
            assert_eq!(read.recheck(), Ok(()), "{name}");
        }
    }
}
