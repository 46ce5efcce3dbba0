//! The coefficient of either law in closed form, and its sign over all parameters.

use super::slider::{crossing_imaginary, crossing_real, on_transition};
use crate::notation::{formula, given_positive, in_parameters};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Toward};
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

/// Re c_1 in η and ω.
pub(super) fn real(law: EvolutionLaw) -> Expression {
    formula(match law {
        EvolutionLaw::Slip => {
            "-eta*omega^2*(1 + eta)*(1 + 9*eta)*(1 + omega^2)\
             /(2*((1 + eta)^2 + eta^2*omega^2)*((1 + eta)^2 + 4*eta^2*omega^2))"
        }
        EvolutionLaw::Aging => {
            "-eta*omega^2*(eta^2*(7 + 4*omega^2) + 6*eta - 1)\
             /(2*((1 + eta)^2 + eta^2*omega^2)*((1 + eta)^2 + 4*eta^2*omega^2))"
        }
    })
}

/// Im c_1 in η and ω.
pub(super) fn imaginary(law: EvolutionLaw) -> Expression {
    formula(match law {
        EvolutionLaw::Slip => {
            "-omega*(1 + 9*eta)*(1 + omega^2)*((1 + eta)^2 - 2*eta^2*omega^2)\
             /(6*((1 + eta)^2 + eta^2*omega^2)*((1 + eta)^2 + 4*eta^2*omega^2))"
        }
        EvolutionLaw::Aging => {
            "-omega*(9*eta^3 + 16*eta^2*omega^2 + 19*eta^2 + 11*eta + 1)\
             /(6*((1 + eta)^2 + eta^2*omega^2)*((1 + eta)^2 + 4*eta^2*omega^2))"
        }
    })
}

/// κ_2 of κ = κ_c + A² κ_2 + O(A⁴), A the amplitude of ln(V/V_l).
pub(super) fn stiffness_shift(law: EvolutionLaw) -> Expression {
    -real(law) / (formula("4") * crossing_real())
}

/// Ω_2 of Ω = ω + A² Ω_2 + O(A⁴).
pub(super) fn frequency_shift(law: EvolutionLaw) -> Expression {
    crossing_imaginary() * stiffness_shift(law) + imaginary(law) / formula("4")
}

/// A²/(K/K_c − 1) to leading order: the square amplitude of ln(V/V_l) per relative distance from the line.
pub(super) fn square_amplitude(law: EvolutionLaw) -> Expression {
    formula(match law {
        EvolutionLaw::Slip => "-4*((1 + eta)^2 + 4*eta^2*omega^2)/(eta*(1 + 9*eta)*(1 + omega^2))",
        EvolutionLaw::Aging => {
            "-4*(1 + eta)*((1 + eta)^2 + 4*eta^2*omega^2)/(eta*(eta^2*(7 + 4*omega^2) + 6*eta - 1))"
        }
    })
}

/// (Ω − ω)/(K/K_c − 1) along the cycle to leading order.
pub(super) fn frequency_slope(law: EvolutionLaw) -> Expression {
    formula(match law {
        EvolutionLaw::Slip => "omega*(1 + 3*eta)/(6*eta)",
        EvolutionLaw::Aging => {
            "omega*(1 + eta)*(3*eta^2*(7 + 4*omega^2) + 6*eta + 1)/(6*eta*(eta^2*(7 + 4*omega^2) + 6*eta - 1))"
        }
    })
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

/// Adds the proof of the sign statement.
///
/// # Errors
/// When the closed form has another sign.
pub(super) fn sign(proof: Proof, cited: &str, law: EvolutionLaw) -> Result<Proof, Refutation> {
    match law {
        EvolutionLaw::Slip => {
            proof.positive("−Re c_1 for every η and ω", &[cited], &-real(law), &on_transition())
        }
        EvolutionLaw::Aging => aging_sign(proof, cited),
    }
}

/// η²(4β + 3) + 6η − 1 changes sign once, at η_0 = 1/(3 + 2r) with r = √(β + 3) > 2.
fn aging_sign(proof: Proof, cited: &str) -> Result<Proof, Refutation> {
    let used = [cited];
    let factor = formula("eta^2*(4*beta + 3) + 6*eta - 1");
    let scale = formula("eta*omega^2/(2*((1 + eta)^2 + eta^2*omega^2)*((1 + eta)^2 + 4*eta^2*omega^2))");
    let split = formula("((2*r + 3)*eta - 1)*((2*r - 3)*eta + 1)");
    let greater = ("r", "2 + d", "d", "r - 2");
    let positive = given_positive(Domain::positive("eta r"), "r - 2", &[("r", "3")]);
    let beyond = in_parameters(positive.clone(), &[greater]);
    let margin = formula("(2*r + 3)*eta - 1");
    let above = ("eta", "(1 + e)/(2*(2 + d) + 3)", "e", "(2*r + 3)*eta - 1");
    let above = in_parameters(given_positive(positive.clone(), above.3, &[]), &[greater, above]);
    let below = ("eta", "1/((1 + e)*(2*(2 + d) + 3))", "e", "(1 - (2*r + 3)*eta)/((2*r + 3)*eta)");
    let is_below = given_positive(positive, "1 - (2*r + 3)*eta", &[("eta", "1/18")]);
    let below = in_parameters(is_below, &[greater, below]);
    proof
        .identity(
            "Re c_1 is minus a factor times N = η²(4β + 3) + 6η − 1",
            &used,
            &real(EvolutionLaw::Aging),
            &(-scale.clone() * factor.clone()),
            &on_transition(),
        )?
        .positive("the factor", &used, &scale, &on_transition())?
        .identity(
            "N with β = r² − 3",
            &used,
            &factor.with("beta", &formula("r^2 - 3")),
            &split,
            &Domain::default(),
        )?
        .positive("the second factor, r > 2 because β > 1", &used, &formula("(2*r - 3)*eta + 1"), &beyond)?
        .positive("the first factor for η > η_0 = 1/(3 + 2r)", &used, &margin, &above)?
        .positive("minus the first factor for η < η_0", &used, &-margin, &below)?
        .positive(
            "1/7 − η_0: the sign never changes above η = 1/7",
            &used,
            &formula("1/7 - 1/(3 + 2*r)"),
            &beyond,
        )
}

/// Adds the quasi-static limit: l_1 vanishes in proportion to η, with opposite signs for the two laws.
///
/// # Errors
/// When the limits are others.
pub(super) fn quasi_static(proof: Proof, cited: &str, law: EvolutionLaw) -> Result<Proof, Refutation> {
    let first = real(law) / formula("omega");
    let per_eta = match law {
        EvolutionLaw::Slip => formula("-omega*(1 + omega^2)/2"),
        EvolutionLaw::Aging => formula("omega/2"),
    };
    let ends = ("eta", Toward::Zero);
    let used = [cited];
    proof.limit("l_1 = Re c_1/ω as η → 0", &used, &first, ends, &formula("0"), &on_transition())?.limit(
        "l_1/η as η → 0",
        &used,
        &(first / formula("eta")),
        ends,
        &per_eta,
        &on_transition(),
    )
}
