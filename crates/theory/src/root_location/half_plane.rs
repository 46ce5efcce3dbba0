//! Routh and Hurwitz for degrees 1 to 3: when all roots lie left of the imaginary axis, and when one lies right of it.

use super::quadratic_factors::{self, not_negative};
use super::{below_zero, free, not_negative_step};
use crate::notation::{formula, given_nonzero, given_positive, in_parameters};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, SignFormula};

/// For a positive leading coefficient: all are positive exactly when all roots have negative real parts.
pub(super) fn stable(coefficients: &[Expression]) -> Vec<Expression> {
    match coefficients {
        [_, _, _, _, _, ..] => quadratic_factors::stable(coefficients),
        _ => conditions(coefficients),
    }
}

/// For a positive leading coefficient: a root has a positive real part.
pub(super) fn unstable(coefficients: &[Expression]) -> SignFormula {
    match coefficients {
        [_, _, _, _, _, ..] => quadratic_factors::unstable(coefficients),
        _ => SignFormula::Any(conditions(coefficients).iter().map(below_zero).collect()),
    }
}

/// Up to degree 3 one list serves both: a root has a positive real part exactly when one of these is negative.
fn conditions(coefficients: &[Expression]) -> Vec<Expression> {
    match coefficients {
        [lower @ .., _] if lower.len() < 3 => lower.to_vec(),
        [c0, c1, c2, c3] => {
            let hurwitz = c2.clone() * c1.clone() - c3.clone() * c0.clone();
            vec![c0.clone(), c1.clone(), c2.clone(), hurwitz]
        }
        _ => Vec::new(),
    }
}

pub(super) fn lemma(degree: usize) -> Result<Proof, Refutation> {
    let statement = |conditions: &str| {
        format!(
            "A real polynomial of degree {degree} with positive leading coefficient has all roots left of the imaginary axis exactly \
             when {conditions} are positive, and a root right of it exactly when one of them is negative."
        )
    };
    match degree {
        1 => linear(Proof::new("roots-of-degree-1", statement("its other coefficients"))),
        2 => quadratic(Proof::new("roots-of-degree-2", statement("its other coefficients"))),
        4.. => quadratic_factors::lemma(degree),
        _ => {
            let proof = Proof::new("roots-of-degree-3", statement("c2, c1, c0 and c2 c1 − c3 c0"));
            cubic(positive_coefficients(pair(proof)?)?)
        }
    }
}

fn linear(proof: Proof) -> Result<Proof, Refutation> {
    let root = given_nonzero(free(), &["c_1"], &[("c_1", "1")]);
    proof.identity(
        "the root of c1 s + c0 is −c0/c1",
        &[],
        &formula("c_1*(-c_0/c_1) + c_0"),
        &formula("0"),
        &root,
    )
}

/// s² − T s + Q has the roots' sum T and product Q.
fn quadratic(proof: Proof) -> Result<Proof, Refutation> {
    let zero = formula("0");
    let below_zero = in_parameters(given_positive(free(), "-Q", &[("Q", "-1")]), &[("Q", "-w", "w", "-Q")]);
    pair(proof)?
        .identity(
            "c2 s² + c1 s + c0 is c2 (s² − T s + Q) with T = −c1/c2 and Q = c0/c2",
            &[],
            &formula("c_2*s^2 + c_1*s + c_0"),
            &formula("c_2*(s^2 - (-c_1/c_2)*s + c_0/c_2)"),
            &given_nonzero(free(), &["c_2"], &[("c_2", "1")]),
        )?
        .root(
            "Q < 0: a root is positive",
            &[],
            (&formula("s^2 - T*s + Q"), "s"),
            [Some(&zero), None],
            &below_zero,
        )?
        .identity(
            "Q = 0: the roots are 0 and T",
            &[],
            &formula("s*(s - T)"),
            &formula("s^2 - T*s + Q").with("Q", &zero),
            &free(),
        )
}

/// The pair of roots of s² − T s + Q.
fn pair(proof: Proof) -> Result<Proof, Refutation> {
    proof
        .identity(
            "a pair x ± iy has the sum T = 2x and the product Q = x² + y²",
            &[],
            &formula("(s - x - i*y)*(s - x + i*y)"),
            &formula("s^2 - 2*x*s + (x^2 + y^2)"),
            &free(),
        )?
        .identity(
            "a real pair r, q has rT = r² + Q: for Q > 0 both have the sign of T",
            &[],
            &formula("r*(r + q)"),
            &formula("r^2 + r*q"),
            &free(),
        )?
        .positive("both negative: minus T", &[], &formula("u + w"), &Domain::positive("u w"))?
        .positive("both negative: Q", &[], &formula("u*w"), &Domain::positive("u w"))
}

/// The rest of the lemma on cubics: −u is a real root, T and Q are the sum and the product of the other two.
fn cubic(proof: Proof) -> Result<Proof, Refutation> {
    let stable = Domain::positive("u w Q");
    let closed = not_negative(free(), "u w Q");
    let parts = [
        ("c2/c3", "u + w"),
        ("c1/c3", "Q + u*w"),
        ("c0/c3", "u*Q"),
        ("(c2 c1 − c3 c0)/c3²", "w*(u^2 + u*w + Q)"),
    ];
    let monic = formula("s^3 + B*s^2 + C*s + D");
    let proof = proof
        .root("every real cubic has a real root −u", &[], (&monic, "s"), [None, None], &free())?
        .identity(
            "with T = −w the others have the sum −w and the product Q",
            &[],
            &formula("(s + u)*(s^2 + w*s + Q)"),
            &formula("s^3 + (u + w)*s^2 + (Q + u*w)*s + u*Q"),
            &free(),
        )?
        .identity(
            "and c2 c1 − c3 c0 is",
            &[],
            &formula("(u + w)*(Q + u*w) - u*Q"),
            &formula("w*(u^2 + u*w + Q)"),
            &free(),
        )?;
    let proof = parts.iter().try_fold(proof, |proof, (name, value)| {
        proof.positive(
            &format!("all roots left of the axis (u, w, Q > 0): {name}"),
            &[],
            &formula(value),
            &stable,
        )
    })?;
    let proof = parts.iter().try_fold(proof, |proof, (name, value)| {
        let says =
            format!("no root right of it (u, w, Q ≥ 0): {name} has a real root, so it is not negative");
        not_negative_step(proof, &says, &formula(value), &closed)
    })?;
    let lower = not_negative(Domain::positive("s"), "B C D");
    let pair = not_negative(Domain::positive("T Q"), "B");
    proof
        .positive("B, C, D ≥ 0: no root is positive", &[], &monic, &lower)?
        .identity(
            "for a pair with T > 0 and B = u − T, c2 c1 − c3 c0 is c3² times",
            &[],
            &formula("(u - T)*(Q - u*T) - u*Q").with("u", &formula("B + T")),
            &formula("-T*(B*(B + T) + Q)"),
            &free(),
        )?
        .negative("so it is negative for B ≥ 0", &[], &formula("-T*(B*(B + T) + Q)"), &pair)
}

/// Routh and Hurwitz for a cubic with c3, c2, c0 > 0: the sign of c2 c1 − c3 c0 is minus that of the pair's real part.
pub(crate) fn positive_coefficients(proof: Proof) -> Result<Proof, Refutation> {
    real_part_of_pair(determinant_of_pair(negative_root(proof)?)?)
}

/// −u is a root, and the other two have the sum T and the product Q.
fn negative_root(proof: Proof) -> Result<Proof, Refutation> {
    let cubic = formula("c_3*s^3 + c_2*s^2 + c_1*s + c_0");
    let positive = Domain::positive("c_3 c_2 c_0");
    // −u is a root when c_1 is this; the other two have the sum T = u − c_2/c_3 and the product Q = c_0/(c_3 u).
    let with_root = positive.clone().and_positive("u").with("c_1", formula("c_0/u + c_2*u - c_3*u^2"));
    let factors = formula("c_3*(s + u)*(s^2 - T*s + Q)");
    let factors = factors.with("T", &formula("u - c_2/c_3")).with("Q", &formula("c_0/(c_3*u)"));
    proof
        .root(
            "a cubic with c3, c2, c0 > 0 has a root −u < 0",
            &[],
            (&cubic, "s"),
            [None, Some(&formula("0"))],
            &positive,
        )?
        .identity("it is c3 (s + u)(s² − T s + Q)", &[], &cubic, &factors, &with_root)?
        .positive("Q = c0/(c3 u)", &[], &formula("c_0/(c_3*u)"), &with_root)?
        .positive("u − T = c2/c3", &[], &formula("c_2/c_3"), &with_root)
}

/// c2 c1 − c3 c0 has the sign of −T.
fn determinant_of_pair(proof: Proof) -> Result<Proof, Refutation> {
    let falling_or_zero = Domain::positive("u Q");
    let falling = given_positive(falling_or_zero.clone(), "-T", &[("T", "-1")]);
    let rising = given_positive(Domain::positive("u Q T"), "u - T", &[("u", "2")]);
    let factor = formula("u^2 - u*T + Q");
    proof
        .identity(
            "(c2 c1 − c3 c0)/c3², with c2/c3 = u − T, c1/c3 = Q − u T, c0/c3 = u Q",
            &[],
            &formula("(u - T)*(Q - u*T) - u*Q"),
            &(formula("-T") * factor.clone()),
            &Domain::default(),
        )?
        .positive(
            "the second factor for T = −w < 0",
            &[],
            &factor,
            &in_parameters(falling, &[("T", "-w", "w", "-T")]),
        )?
        .positive(
            "the second factor for T > 0, where u − T = w > 0",
            &[],
            &factor,
            &in_parameters(rising, &[("u", "T + w", "w", "u - T")]),
        )?
        .positive(
            "and for T = 0: c2 c1 − c3 c0 has the sign of −T",
            &[],
            &factor.with("T", &formula("0")),
            &falling_or_zero,
        )
}

/// The real part of the pair has the sign of T.
fn real_part_of_pair(proof: Proof) -> Result<Proof, Refutation> {
    proof
        .identity(
            "a complex pair x ± iy has T = 2x: its real part has the sign of T",
            &[],
            &formula("(s - x - i*y)*(s - x + i*y)"),
            &formula("s^2 - 2*x*s + x^2 + y^2"),
            &Domain::default(),
        )?
        .identity(
            "a real pair r, q has T = r + q and rT = r² + Q > 0: both have the sign of T",
            &[],
            &formula("r*(r + q)"),
            &formula("r^2 + Q").with("Q", &formula("r*q")),
            &Domain::default(),
        )?
        .identity(
            "for T = 0 the pair is ±i√Q",
            &[],
            &formula("(s - i*sqrt(Q))*(s + i*sqrt(Q))"),
            &formula("s^2 + Q"),
            &Domain::positive("Q"),
        )
}
