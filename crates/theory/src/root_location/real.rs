//! When all roots of a polynomial of degree 1 to 3 are real: its discriminant is not negative.

use super::free;
use crate::notation::formula;
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Sign, SignFormula, Symbol};

/// For a leading coefficient that is not zero.
pub(super) fn signs(coefficients: &[Expression]) -> SignFormula {
    let discriminant = match coefficients.len() {
        3 => formula(QUADRATIC),
        4 => formula(CUBIC),
        _ => return SignFormula::All(Vec::new()),
    };
    let values = NAMES.into_iter().map(Symbol::from).zip(coefficients.iter().cloned()).collect();
    SignFormula::sign(&discriminant.substitute(&values), Sign::NonNegative)
}

/// The names of the coefficients, by ascending power.
const NAMES: [&str; 4] = ["c_0", "c_1", "c_2", "c_3"];

const QUADRATIC: &str = "c_1^2 - 4*c_2*c_0";
const CUBIC: &str = "18*c_3*c_2*c_1*c_0 - 4*c_2^3*c_0 + c_2^2*c_1^2 - 4*c_3*c_1^3 - 27*c_3^2*c_0^2";

/// The discriminant by roots, for real ones and for one pair x ± iy with y > 0.
pub(super) fn lemma(degree: usize) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        &format!("real-roots-of-degree-{degree}"),
        format!(
            "A real polynomial of degree {degree} has real roots only exactly when its discriminant is not negative."
        ),
    );
    let by_roots = |text: &str, values: &[(&'static str, &str)]| {
        values.iter().fold(formula(text), |formula_, (name, value)| formula_.with(*name, &formula(value)))
    };
    let pair = Domain::positive("y");
    match degree {
        1 => proof.identity(
            "the root of c1 s + c0 with a real −c0/c1 = r is r",
            &[],
            &formula("c_1*(s - r)"),
            &formula("c_1*s - c_1*r"),
            &free(),
        ),
        2 => proof
            .identity(
                "for real roots r, q it is a square",
                &[],
                &by_roots(QUADRATIC, &[("c_1", "-c_2*(r + q)"), ("c_0", "c_2*r*q")]),
                &formula("(c_2*(r - q))^2"),
                &free(),
            )?
            .identity(
                "for x ± iy it is a negative square",
                &[],
                &by_roots(QUADRATIC, &[("c_1", "-2*c_2*x"), ("c_0", "c_2*(x^2 + y^2)")]),
                &formula("-(2*c_2*y)^2"),
                &pair,
            ),
        _ => {
            let real = [("c_2", "-c_3*(r + q + p)"), ("c_1", "c_3*(r*q + q*p + p*r)"), ("c_0", "-c_3*r*q*p")];
            let complex = [
                ("c_2", "-c_3*(r + 2*x)"),
                ("c_1", "c_3*(2*r*x + x^2 + y^2)"),
                ("c_0", "-c_3*r*(x^2 + y^2)"),
            ];
            proof
                .identity(
                    "for real roots r, q, p it is a square",
                    &[],
                    &by_roots(CUBIC, &real),
                    &formula("(c_3^2*(r - q)*(q - p)*(p - r))^2"),
                    &free(),
                )?
                .identity(
                    "for r and x ± iy it is a negative square",
                    &[],
                    &by_roots(CUBIC, &complex),
                    &formula("-(2*c_3^2*y*((r - x)^2 + y^2))^2"),
                    &pair,
                )
        }
    }
}
