//! The coefficient of either law in closed form, and its sign over all parameters.

use super::slider::{crossing_imaginary, crossing_real};
use crate::notation::formula;
use crate::stated_proofs::{add_block, named};
use slipmode_algebra::{Expression, Proof, Refutation};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

slipmode_algebra::named! {
    /// How a cycle is born where K = K_c is crossed.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Criticality {
        /// l_1 < 0: a small stable cycle on the unstable side, so that oscillation sets in softly.
        Supercritical = "supercritical",
        /// l_1 > 0: an unstable cycle on the stable side; a finite kick beyond it destabilises a linearly stable slider.
        Subcritical = "subcritical",
        /// l_1 = 0: the next coefficient decides.
        Degenerate = "degenerate",
    }
}

impl Criticality {
    /// The kind at this η > 0 and β > 1, decided exactly.
    #[must_use]
    pub fn of(law: EvolutionLaw, inertial_parameter: &Rational, effect_ratio: &Rational) -> Self {
        let [_, divisor] = law.square_amplitude(inertial_parameter, effect_ratio);
        match divisor.cmp0() {
            std::cmp::Ordering::Greater => Self::Supercritical,
            std::cmp::Ordering::Less => Self::Subcritical,
            std::cmp::Ordering::Equal => Self::Degenerate,
        }
    }
}

/// The closed form with this name and this law, in η and ω: the names stand in `lemmas.toml`.
pub(super) fn stated(name: &str, law: EvolutionLaw) -> Expression {
    named(&format!("{name}_with_the_{}_law", law.as_str()))
}

/// κ_2 of κ = κ_c + A² κ_2 + O(A⁴), A the amplitude of ln(V/V_l).
pub(super) fn stiffness_shift(law: EvolutionLaw) -> Expression {
    -stated("real_part", law) / (formula("4") * crossing_real())
}

/// Ω_2 of Ω = ω + A² Ω_2 + O(A⁴).
pub(super) fn frequency_shift(law: EvolutionLaw) -> Expression {
    crossing_imaginary() * stiffness_shift(law) + stated("imaginary_part", law) / formula("4")
}

/// The statement of the sign over all η > 0 and β > 1.
pub(super) fn sign_statement(law: EvolutionLaw) -> &'static str {
    match law {
        EvolutionLaw::Slip => "l_1 < 0 for all η > 0 and β > 1 (supercritical); l_1 → 0 as η → 0",
        EvolutionLaw::Aging => {
            "l_1 < 0 (supercritical) for η > η_0, l_1 = 0 at η = η_0, l_1 > 0 (subcritical) for \
             0 < η < η_0, with η_0 = 1/(3 + 2√(β + 3)) < 1/7; l_1 → 0 as η → 0"
        }
    }
}

/// Adds the proof of the sign statement, which cites the equation of the law.
///
/// # Errors
/// When the closed form has another sign.
pub(super) fn sign(proof: Proof, cited: &str, law: EvolutionLaw) -> Result<Proof, Refutation> {
    let before = proof.steps.len();
    let id = format!("sign-of-the-lyapunov-coefficient-with-the-{}-law", law.as_str());
    let mut proof = add_block(proof, &id)?;
    proof.steps[before..].iter_mut().for_each(|step| step.equations = vec![cited.to_owned()]);
    Ok(proof)
}
