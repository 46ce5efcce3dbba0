//! When all roots of eq 8 are real: three roots −1 − x_i with x_1 x_2 x_3 = β (x_1 + x_2 + x_3 + 2).
//!
//! All x_i are positive (the lower area, all roots left of −1), or two are negative (the upper area). Each solution set is the
//! image of an orthant, so each area is connected.

use super::Equations;
use super::areas::Effects;
use super::notation::{cubic, formula, given_nonzero, given_positive, in_parameters};
use slipmode_algebra::{Certificate, Domain, Expression, Proof, Refutation, Symbol};

/// Real roots of eq 8, named by x_i = −1 − p_i, determine η, κ and β, and have one relation.
///
/// # Errors
/// When eq 8 does not have that form.
pub(super) fn by_roots(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let f = cubic(equations);
    let p = Symbol::from("p");
    let product = formula("eta*(p + 1 + x_1)*(p + 1 + x_2)*(p + 1 + x_3)");
    let half_curvature =
        |cubic: &Expression| cubic.derivative(&p).derivative(&p).with("p", &formula("-1")) / formula("2");
    let free = Domain::default();
    let at_roots = given_nonzero(free.clone(), &["x_1 + x_2 + x_3 + 2"], &[])
        .with("eta", formula("1/(x_1 + x_2 + x_3 + 2)"))
        .with("kappa", formula("(1 + x_1)*(1 + x_2)*(1 + x_3)/(x_1 + x_2 + x_3 + 2)"))
        .with("beta", formula("x_1*x_2*x_3/(x_1 + x_2 + x_3 + 2)"));
    let used = ["8"];
    let at = |cubic: &Expression, place: &str| cubic.with("p", &formula(place));
    proof
        .identity("F(−1) = β, so −1 is no root", &used, &at(&f, "-1"), &formula("beta"), &free)?
        .identity("F(0) = κ, so 0 is no root", &used, &at(&f, "0"), &formula("kappa"), &free)?
        .identity("F''(−1)/2 = 1 − 2η", &used, &half_curvature(&f), &formula("1 - 2*eta"), &free)?
        .identity(
            "With three real roots −1 − x_i F is η Π(p + 1 + x_i): so β = η x_1 x_2 x_3",
            &[],
            &at(&product, "-1"),
            &formula("eta*x_1*x_2*x_3"),
            &free,
        )?
        .identity(
            "and 1 − 2η = η (x_1 + x_2 + x_3), so η = 1/(x_1 + x_2 + x_3 + 2)",
            &[],
            &half_curvature(&product),
            &formula("eta*(x_1 + x_2 + x_3)"),
            &free,
        )?
        .identity(
            "conversely F is this product for such η, κ = η Π(1 + x_i), β",
            &used,
            &f,
            &product,
            &at_roots,
        )?
        .positive(
            "x_1 x_2 x_3 = β/η: none of the x_i is negative, or two are",
            &[],
            &formula("beta/eta"),
            &Domain::positive("beta eta"),
        )
}

/// None of the x_i is negative: x_1 = s, x_2 = β (1 + t)/s for s, t > 0.
///
/// # Errors
/// When eq 8 does not have that form.
pub(super) fn lower_area(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let roots = ["s", "beta*(1 + t)/s", "(s + beta*(1 + t)/s + 2)/t"].map(formula);
    let parametrised = Domain::positive("s t beta");
    let solutions = below_minus_one();
    let back = formula("(x_1 + x_2 + 2)/t").with("t", &formula("x_1*x_2/beta - 1"));
    let proof = proof
        .positive(
            "all x_i > 0: t = x_1 x_2/β − 1 is positive",
            &[],
            &formula("x_1*x_2/beta - 1"),
            &solutions,
        )?
        .identity("and gives back x_3 = (x_1 + x_2 + 2)/t", &[], &back, &formula("x_3"), &solutions)?
        .positive("1/2 − η: this area has η < 1/2", &[], &formula("1/2 - eta"), &solutions)?;
    image(proof, equations, "lower", &roots, &parametrised)
}

/// All roots left of −1: x_i > 0, and η and β follow.
pub(super) fn below_minus_one() -> Domain {
    Domain::positive("x_1 x_2 x_3")
        .with("eta", formula("1/(x_1 + x_2 + x_3 + 2)"))
        .with("beta", formula("x_1*x_2*x_3/(x_1 + x_2 + x_3 + 2)"))
}

/// Two of the x_i are −y_1 and −y_2: both y_i lie between 1 and β, and none does for β = 1.
///
/// # Errors
/// When eq 8 does not have that form.
pub(super) fn upper_area(proof: Proof, equations: &Equations, effects: Effects) -> Result<Proof, Refutation> {
    let (right, left) = ("1 + e", "1/(1 + e)");
    let relation = formula("x_3*(y_1*y_2 - beta) - beta*(2 - y_1 - y_2)");
    let side = |domain: Domain, [one, other]: [&str; 2]| {
        let value = |form: &str, index: &str| formula(&form.replace('e', &format!("e_{index}")));
        domain.and_positive("x_3 e_1 e_2").with("y_1", value(one, "1")).with("y_2", value(other, "2"))
    };
    let mixed = side(Domain::default(), [left, right]);
    let proof = proof.negative(
        "x_1 = −y_1 and x_2 = −y_2: κ/η would be negative for y_1 < 1 < y_2",
        &[],
        &formula("(1 + x_3)*(1 - y_1)*(1 - y_2)"),
        &mixed,
    )?;
    let proof = match effects {
        Effects::Strengthening => proof,
        _ => proof.negative(
            "no y_1, y_2 < 1: x_3 (y_1 y_2 − β) − β (2 − y_1 − y_2) is not zero",
            &[],
            &relation,
            &side(case(effects), [left, left]),
        )?,
    };
    let proof = match effects {
        Effects::Weakening => proof,
        _ => proof.positive(
            "no y_1, y_2 > 1: it is not zero",
            &[],
            &relation,
            &side(case(effects), [right, right]),
        )?,
    };
    let domain = match effects {
        Effects::Neutral => return Ok(proof),
        Effects::Weakening => {
            let inertial = given_positive(Domain::default(), "x_3 - e_1 - e_2", &[("x_3", "3")]);
            let inertial = in_parameters(inertial, &[("x_3", "e_1 + e_2 + w", "w", "x_3 - e_1 - e_2")]);
            side(inertial, [right, right])
        }
        Effects::Strengthening => side(Domain::default(), [left, left]),
    };
    upper_image(proof, equations, effects, domain)
}

/// y_1 = (β + s)/(1 + s) and y_2 = (β/y_1 + t)/(1 + t) for s, t > 0.
fn upper_image(
    proof: Proof,
    equations: &Equations,
    effects: Effects,
    solutions: Domain,
) -> Result<Proof, Refutation> {
    let [one, other] =
        ["(beta + s)/(1 + s)", "(beta + s*beta + t*beta + s*t)/((beta + s)*(1 + t))"].map(formula);
    let third = formula("beta*((1 + t)/(t*s) + (1 + s)/(t*(beta + s)))");
    let roots = [-one.clone(), -other.clone(), third];
    let parametrised = Domain::positive("s t beta");
    let proof = image(proof, equations, "upper", &roots, &parametrised)?;
    let beta = solutions.substituted(&formula("y_1*y_2*x_3/(x_3 + 2 - y_1 - y_2)"));
    let in_roots = solutions.with("beta", beta);
    let (s, t) = (formula("(y_1 - beta)/(1 - y_1)"), formula("(y_2 - beta/y_1)/(1 - y_2)"));
    let back = other.with("s", &s).with("t", &t);
    let between = case(effects).and_positive("s t");
    let (says, sign) = match effects {
        Effects::Weakening => ("positive: two unstable roots", 1),
        _ => ("between −1 and 0", -1),
    };
    let excess = |root: Expression| Certificate::Sign {
        expression: root - formula("1"),
        sign,
        domain: between.clone(),
    };
    proof
        .positive("s = (y_1 − β)/(1 − y_1) is positive", &[], &s, &in_roots)?
        .positive("t = (y_2 − β/y_1)/(1 − y_2) is positive", &[], &t, &in_roots)?
        .identity("and both give back y_2", &[], &back, &formula("y_2"), &in_roots)?
        .certify(&format!("the root y_1 − 1 is {says}"), &[], excess(one))?
        .certify(&format!("the root y_2 − 1 is {says}"), &[], excess(other))
}

/// The area as the image of all s, t > 0: its roots, and that it is connected for each β.
fn image(
    proof: Proof,
    equations: &Equations,
    name: &str,
    roots: &[Expression; 3],
    parametrised: &Domain,
) -> Result<Proof, Refutation> {
    let product = roots.iter().fold(formula("1"), |product, root| product * root.clone());
    let eta = formula("beta") / product;
    let from_zero = roots.iter().fold(eta.clone(), |product, root| product * (formula("1") + root.clone()));
    let factors = roots.iter().fold(eta.clone(), |product, root| product * (formula("p + 1") + root.clone()));
    let area = parametrised.clone().with("eta", eta.clone()).with("kappa", from_zero.clone());
    let image = vec![("eta".into(), eta), ("kappa".into(), from_zero)];
    proof
        .identity(
            &format!("{name} area: F has the roots −1 − x_i of every s, t > 0"),
            &["8"],
            &cubic(equations),
            &factors,
            &area,
        )?
        .certify(
            &format!("the {name} area is connected for each β"),
            &[],
            Certificate::Connected { image, domain: parametrised.clone() },
        )
}

/// β > 1, β = 1 or 0 < β < 1, with d > 0 for the distance from 1.
pub(super) fn case(effects: Effects) -> Domain {
    let beta = Domain::positive("beta");
    match effects {
        Effects::Weakening => {
            let above = given_positive(beta, "beta - 1", &[("beta", "2")]);
            in_parameters(above, &[("beta", "1 + d", "d", "beta - 1")])
        }
        Effects::Neutral => Domain::default().with("beta", formula("1")),
        Effects::Strengthening => {
            let below = given_positive(beta, "1 - beta", &[("beta", "1/2")]);
            in_parameters(below, &[("beta", "1/(1 + d)", "d", "(1 - beta)/beta")])
        }
    }
}
