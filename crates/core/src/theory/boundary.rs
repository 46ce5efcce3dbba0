//! The exact boundary max Im(s) = 0: a rational curve with one cusp.

use super::Equations;
use super::notation::{
    coefficients, cubic, discriminant_of_cubic, formula, given_nonzero, given_positive, in_parameters,
    rational, simplified,
};
use slipmode_algebra::{
    Domain, Expression, Polynomial, Proof, RationalFunction, Refutation, Relation, Symbol,
};

/// The parametrisation of the boundary by its double root r, as derived from eq 8.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Curve {
    /// η(r) in r and β.
    pub inertial_parameter: RationalFunction,
    /// κ(r) in r and β.
    pub stiffness_group: RationalFunction,
    /// The third root t(r) in r and β.
    pub third_root: RationalFunction,
}

/// Solves F(r) = F'(r) = 0 for η and κ, in which both are linear.
///
/// # Errors
/// When eq 8 is no cubic that is linear in η and κ.
pub fn curve(equations: &Equations) -> Result<Curve, Refutation> {
    let proof = Proof::new("boundary-curve", "");
    let value = cubic(equations).with("p", &formula("r"));
    let slope = value.derivative(&Symbol::from("r"));
    let [inertial_parameter, stiffness_group] = solve_for_groups(&proof, [&value, &slope])?;
    let [_, _, c2, c3]: [Expression; 4] = coefficients(&proof, &["8"], &cubic(equations), "p")?;
    let sum = (Expression::integer(-1) * c2 / c3 - formula("2*r"))
        .with("eta", &Expression::from(&inertial_parameter))
        .with("kappa", &Expression::from(&stiffness_group));
    let third_root = rational(&proof, &["8"], &sum, &at_double_root())?;
    Ok(Curve { inertial_parameter, stiffness_group, third_root })
}

/// η and κ at which two expressions that are linear in both are zero.
///
/// # Errors
/// When an expression is not linear, or the two do not determine η and κ.
pub(super) fn solve_for_groups(
    proof: &Proof,
    zeros: [&Expression; 2],
) -> Result<[RationalFunction; 2], Refutation> {
    let [first, second] = [linear_parts(proof, zeros[0])?, linear_parts(proof, zeros[1])?];
    let minor =
        |left: usize, right: usize| &(&first[left] * &second[right]) - &(&first[right] * &second[left]);
    let [determinant, eta, kappa] = [minor(0, 1), minor(1, 2), minor(2, 0)];
    let solved = eta.checked_div(&determinant).zip(kappa.checked_div(&determinant));
    solved.map(|(eta, kappa)| [eta, kappa]).ok_or_else(|| {
        proof.refute(
            "η and κ of two equal roots or a pair are determined",
            &["8"],
            "the determinant vanishes",
        )
    })
}

/// The coefficients of η and of κ, and the rest, of an expression linear in both.
fn linear_parts(proof: &Proof, expression: &Expression) -> Result<[RationalFunction; 3], Refutation> {
    let domain = Domain::default();
    let part = |name: &'static str| rational(proof, &["8"], &expression.derivative(&name.into()), &domain);
    let rest = expression.with("eta", &formula("0")).with("kappa", &formula("0"));
    let parts = [part("eta")?, part("kappa")?, rational(proof, &["8"], &rest, &domain)?];
    let linear = formula("0")
        + Expression::from(&parts[0]) * formula("eta")
        + Expression::from(&parts[1]) * formula("kappa");
    proof.clone().identity("linear in η and κ", &["8"], expression, &(linear + rest), &domain)?;
    Ok(parts)
}

/// The curve carries every double root and nothing else, and has slope dκ/dη = −r².
///
/// # Errors
/// When a relation does not follow from eq 8.
pub fn prove(equations: &Equations) -> Result<Proof, Refutation> {
    let curve = curve(equations)?;
    let (eta, kappa) =
        (Expression::from(&curve.inertial_parameter), Expression::from(&curve.stiffness_group));
    let free = Domain::default();
    let at_root = at_double_root();
    let on_curve = at_root.clone().with("eta", eta.clone()).with("kappa", kappa.clone());
    let f = cubic(equations);
    let product = formula("eta*(p - r)^2") * (formula("p") - Expression::from(&curve.third_root));
    let determinant = formula("(r^3 + r^2) - (r + 1)*(3*r^2 + 2*r)");
    let r = Symbol::from("r");
    let envelope = kappa.derivative(&r) + formula("r^2") * eta.derivative(&r);
    let zero = formula("0");
    Proof::new(
        "boundary-curve",
        format!(
            "Eq 8 has a double root r exactly for η = {eta}, κ = {kappa}; the third root is {}; \
             dκ/dη = −r².",
            Expression::from(&curve.third_root)
        ),
    )
    .identity("F(−1) = β", &["8"], &f.with("p", &formula("-1")), &formula("beta"), &free)?
    .identity("F(0) = κ", &["8"], &f.with("p", &zero), &formula("kappa"), &free)?
    .identity(
        "determinant of F(r) = F'(r) = 0 in (η, κ)",
        &["8"],
        &determinant,
        &formula("-2*r*(r + 1)^2"),
        &free,
    )?
    .identity(
        "its quotient by itself: it is not zero, because r is neither −1 nor 0, so that r determines η and κ",
        &[],
        &(determinant.clone() / determinant.clone()),
        &formula("1"),
        &given_nonzero(Domain::default(), &["r", "r + 1"], &[("r", "1")]),
    )?
    .identity("F on the curve", &["8"], &f, &product, &on_curve)?
    .identity("dκ/dr = −r² dη/dr", &[], &envelope, &zero, &at_root)?
    .identity(
        "discriminant on the curve",
        &["8"],
        &Expression::from(&cubic_discriminant(equations)?),
        &zero,
        &on_curve,
    )
}

/// A double root r is neither 0 nor −1, because F(0) = κ and F(−1) = β are not zero; with η > 0 it is not −1 ± √β either.
fn at_double_root() -> Domain {
    given_nonzero(Domain::default(), &["r", "r + 1", "(r + 1)^2 - beta"], &[("r", "1"), ("beta", "1")])
}

/// The discriminant of F as a polynomial in η, κ, β.
///
/// # Errors
/// When eq 8 is no polynomial.
pub fn cubic_discriminant(equations: &Equations) -> Result<Polynomial, Refutation> {
    let proof = Proof::new("discriminant", "");
    discriminant_of_cubic(&proof, &cubic(equations), "p", &Domain::default())
}

/// One triple root for each β: (r+1)³ = β(3r+1) with r < −1, η = −1/(3r+1), κ = r³/(3r+1).
///
/// # Errors
/// When the triple root of eq 8 is another one.
pub fn cusp(equations: &Equations) -> Result<Proof, Refutation> {
    let f = cubic(equations);
    // With r = −1 − x, x > 0, everything at the cusp is a quotient of polynomials with positive coefficients.
    let ratio = formula("x^3/(3*x + 2)");
    let at_cusp = Domain::positive("x")
        .with("beta", ratio.clone())
        .with("eta", formula("1/(3*x + 2)"))
        .with("kappa", formula("(1 + x)^3/(3*x + 2)"));
    let second = f.derivative(&Symbol::from("p")).derivative(&Symbol::from("p"));
    let slope = ratio.derivative(&Symbol::from("x"));
    let at_root = at_double_root();
    let curve = curve(equations)?;
    let eta_slope = Expression::from(&curve.inertial_parameter.derivative(&Symbol::from("r")));
    let condition = formula("(beta*(3*r + 1) - (r + 1)^3)");
    let quotient = simplified(
        &Proof::new("cusp", ""),
        &["8"],
        &(eta_slope.clone() / condition.clone()),
        &at_root.clone().given(condition.clone(), Relation::NonZero),
    )?;
    let triple = formula("eta*(p - r)^3");
    let triple_curvature = triple.derivative(&Symbol::from("p")).derivative(&Symbol::from("p"));
    let minus_one = formula("-1");
    Proof::new(
        "cusp",
        "The boundary has exactly one cusp for each β > 0: the triple root r = −1 − x with β \
             = x³/(3x + 2), η = 1/(3x + 2) < 1/2, κ = (1 + x)³/(3x + 2). At a = b: r = −3, η = \
             1/8, κ = 27/8.",
    )
    .identity("F is η (p + 1 + x)³ there", &["8"], &f, &formula("eta*(p + 1 + x)^3"), &at_cusp)?
    .identity(
        "second derivative at the triple root",
        &["8"],
        &second.with("p", &formula("-1 - x")),
        &formula("0"),
        &at_cusp,
    )?
    .identity(
        "dη/dr vanishes where (r + 1)³ = β (3r + 1)",
        &["8"],
        &eta_slope,
        &(quotient * condition),
        &at_root,
    )?
    .positive("β rises with x, from 0 without limit: one x for each β", &[], &slope, &Domain::positive("x"))?
    .positive("1/2 − η", &[], &formula("1/2 - 1/(3*x + 2)"), &Domain::positive("x"))?
    .identity("β at x = 2", &[], &ratio.with("x", &formula("2")), &formula("1"), &Domain::default())?
    .identity(
        "conversely with a triple root r = −1 − x F is η (p − r)³: F(−1) = β = η x³, so x > 0",
        &[],
        &triple.with("p", &minus_one).with("r", &formula("-1 - x")),
        &formula("eta*x^3"),
        &Domain::default(),
    )?
    .identity(
        "and F''(−1)/2 = 1 − 2η",
        &["8"],
        &(second.with("p", &minus_one) / formula("2")),
        &formula("1 - 2*eta"),
        &Domain::default(),
    )?
    .identity(
        "is 3ηx, so η = 1/(3x + 2) and β = x³/(3x + 2)",
        &[],
        &(triple_curvature.with("p", &minus_one).with("r", &formula("-1 - x")) / formula("2")),
        &formula("3*eta*x"),
        &Domain::default(),
    )
}

/// For a < b the transition never meets the boundary: the discriminant is negative all along K = K_c.
///
/// # Errors
/// When eq 9 meets the boundary of eq 8.
pub fn transition_avoids(equations: &Equations) -> Result<Proof, Refutation> {
    let critical = super::notation::in_groups(&equations.right("9"));
    let discriminant = Expression::from(&cubic_discriminant(equations)?).with("kappa", &critical);
    let weakening = given_positive(Domain::positive("eta beta"), "beta - 1", &[("beta", "2")]);
    let domain = in_parameters(weakening, &[("beta", "1 + d", "d", "beta - 1")]);
    Proof::new(
        "transition-avoids-boundary",
        "For a < b the roots on K = K_c are never all real: K = K_c does not meet the \
             boundary.",
    )
    .positive(
        "minus the discriminant at κ = (β − 1)(1 + η), β = 1 + d",
        &["8", "9"],
        &(-discriminant),
        &domain,
    )
}
