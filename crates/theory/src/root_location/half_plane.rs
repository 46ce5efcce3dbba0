//! Routh and Hurwitz for degrees 1 to 6: when all roots lie left of the imaginary axis, and when one lies right of it.
//!
//! The lemmas stand in `stated_proofs/lemmas.toml`. Those on degrees 4 to 6 write a polynomial as a product of real quadratics, and of
//! one linear factor for degree 5. Its determinants are products and sums of the factors' coefficients, which decide where the roots are.

use super::{below_zero, of_coefficients};
use slipmode_algebra::{Expression, Sign, SignFormula};

/// A case that the negative ones leave: all of these are zero, this one is negative, and this one positive.
type Even = (&'static [&'static str], &'static str, Option<&'static str>);

/// Of degree 4 to 6: what is positive exactly when all roots have negative real parts, by the names of the coefficients and of
/// determinants, and the cases with even powers.
fn rule(degree: usize) -> (&'static str, &'static [Even]) {
    match degree {
        4 => ("c_0 c_1 c_3 determinant_of_quartic", &[(&["c_1", "c_3"], "c_2^2 - 4*c_0*c_4", None)]),
        5 => (
            "c_0 c_2 c_4 first_determinant_of_quintic second_determinant_of_quintic",
            &[(&["first_determinant_of_quintic", "c_1*c_4 - c_0*c_5"], "c_3^2 - 4*c_1*c_5", None)],
        ),
        _ => (
            "c_0 c_1 c_2 c_3 c_4 c_5 first_determinant_of_sextic second_determinant_of_sextic",
            &[
                (
                    &["c_1", "c_3", "c_5"],
                    "18*c_6*c_4*c_2*c_0 - 4*c_4^3*c_0 + c_4^2*c_2^2 - 4*c_6*c_2^3 - 27*c_6^2*c_0^2",
                    None,
                ),
                (
                    &[
                        "c_5^2*c_2 - c_1*c_5*c_6 - c_3*(c_4*c_5 - c_3*c_6)",
                        "c_5^2*c_0 - c_1*(c_4*c_5 - c_3*c_6)",
                    ],
                    "c_3^2 - 4*c_1*c_5",
                    Some("c_5"),
                ),
            ],
        ),
    }
}

/// For a positive leading coefficient: all are positive exactly when all roots have negative real parts.
pub(super) fn stable(coefficients: &[Expression]) -> Vec<Expression> {
    match coefficients {
        [] => Vec::new(),
        [lower @ .., _] if lower.len() < 3 => lower.to_vec(),
        [c0, c1, c2, c3] => {
            let hurwitz = c2.clone() * c1.clone() - c3.clone() * c0.clone();
            vec![c0.clone(), c1.clone(), c2.clone(), hurwitz]
        }
        [_, lower @ ..] => {
            rule(lower.len()).0.split(' ').map(|name| of_coefficients(name, coefficients)).collect()
        }
    }
}

/// For a positive leading coefficient: a root has a positive real part.
pub(super) fn unstable(coefficients: &[Expression]) -> SignFormula {
    let [lower @ .., _] = coefficients else { return SignFormula::Any(Vec::new()) };
    if lower.len() < 4 {
        return SignFormula::Any(stable(coefficients).iter().map(below_zero).collect());
    }
    let (conditions, even) = rule(lower.len());
    let determinants = conditions.split(' ').filter(|name| name.contains("determinant"));
    let determinants = determinants.map(|name| of_coefficients(name, coefficients));
    let negative = lower.iter().cloned().chain(determinants).map(|one| below_zero(&one));
    let even = even.iter().map(|(zero, negative, positive)| {
        let sign = |text: &&str, sign| SignFormula::sign(&of_coefficients(text, coefficients), sign);
        let zero = zero.iter().map(|text| sign(text, Sign::Zero));
        let positive = positive.iter().map(|text| sign(text, Sign::Positive));
        SignFormula::All(
            zero.chain(positive).chain([below_zero(&of_coefficients(negative, coefficients))]).collect(),
        )
    });
    SignFormula::Any(negative.chain(even).collect())
}
