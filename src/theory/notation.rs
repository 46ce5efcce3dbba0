//! Formulas and assumptions that the proofs share.

use crate::polynomial::{Domain, Expression, Proof, RationalFunction, Refutation};

/// The physical quantities, all positive.
const QUANTITIES: &str = "a b D_c K M sigma V V_0 theta mu_0";

/// A formula written in the program text.
///
/// # Panics
/// When the text is not of the grammar: a slip in the program text, which the test of the module shows.
pub(super) fn formula(text: &str) -> Expression {
    text.parse().unwrap_or_else(|error| panic!("formula {text}: {error}"))
}

/// All physical quantities are positive, nothing is said of a − b.
pub(super) fn any() -> Domain {
    Domain::positive(QUANTITIES)
}

/// a < b with both roots rational: a = α², b = (α + δ)².
pub(super) fn weakening() -> Domain {
    roots_of_machine().with("a", formula("alpha^2")).with("b", formula("(alpha + delta)^2"))
}

/// a > b with both roots rational: a = (α + δ)², b = α².
pub(super) fn strengthening() -> Domain {
    roots_of_machine().with("a", formula("(alpha + delta)^2")).with("b", formula("alpha^2"))
}

/// a = b with a rational root: a = b = α².
pub(super) fn neutral() -> Domain {
    roots_of_machine().with("a", formula("alpha^2")).with("b", formula("alpha^2"))
}

/// a < b with √a and √(b − a) rational: a = α², b = α² + γ²; K = k², M = m².
pub(super) fn weakening_by_square() -> Domain {
    roots_of_machine().with("a", formula("alpha^2")).with("b", formula("alpha^2 + gamma^2"))
}

/// a ≥ b written as a = b + d: strictly greater with d > 0.
pub(super) fn stronger_direct_effect() -> Domain {
    Domain::positive(&format!("{QUANTITIES} d")).with("a", formula("b + d"))
}

/// a < b written as b = a + d with d > 0.
pub(super) fn weaker_direct_effect() -> Domain {
    Domain::positive(&format!("{QUANTITIES} d")).with("b", formula("a + d"))
}

/// √K and √M rational: K = k², M = m².
fn roots_of_machine() -> Domain {
    Domain::positive(&format!("{QUANTITIES} alpha gamma delta k m"))
        .with("K", formula("k^2"))
        .with("M", formula("m^2"))
}

/// The expression in lowest terms.
///
/// # Errors
/// A refutation that names the equations, when it is no rational function.
pub(super) fn simplified(
    proof: &Proof,
    equations: &[&str],
    expression: &Expression,
    domain: &Domain,
) -> Result<Expression, Refutation> {
    Ok(Expression::from(&rational(proof, equations, expression, domain)?))
}

/// The expression as a rational function.
///
/// # Errors
/// A refutation that names the equations, when it is none.
pub(super) fn rational(
    proof: &Proof,
    equations: &[&str],
    expression: &Expression,
    domain: &Domain,
) -> Result<RationalFunction, Refutation> {
    domain.rational_function(expression).map_err(|error| {
        proof.refute("an expression of the derivation is no rational function", equations, error.to_string())
    })
}
