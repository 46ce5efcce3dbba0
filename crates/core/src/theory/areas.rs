//! How many areas of the (V, σ) plane have max Im(s) = 0, and which of the four kinds of area exist.

use super::notation::{cubic, formula, given_nonzero, given_positive, in_parameters};
use super::{PaperEquations, boundary, transition};
use crate::polynomial::{Certificate, Domain, Expression, Proof, Refutation, Symbol};

crate::named! {
    /// Which of a and b is the larger one.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Effects {
        /// a < b: velocity weakening.
        Weakening = "a < b",
        /// a = b: velocity neutral.
        Neutral = "a = b",
        /// a > b: velocity strengthening.
        Strengthening = "a > b",
    }
}

/// The areas of one case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Areas {
    /// Which of a and b is larger.
    pub effects: Effects,
    /// The number of separate areas in which all roots are real.
    pub real_areas: usize,
    /// How many of them are unstable.
    pub unstable_real_areas: usize,
    /// Which of the paper's areas (i)-(iv) exist, in that order.
    pub exists: [bool; 4],
    /// The proof.
    pub proof: Proof,
}

/// Counts the areas max Im(s) = 0 and finds which of (i)-(iv) exist (claims B1 and B9).
///
/// # Errors
/// When eq 8 does not have the form that the count rests on.
pub fn count(equations: &PaperEquations, effects: Effects) -> Result<Areas, Refutation> {
    let (proof, upper) = upper_area(form(equations, effects)?, effects)?;
    let proof = separate(lower_area(proof)?);
    let unstable = upper == Upper::Unstable;
    let proof = if unstable {
        proof
            .using(transition::stability(equations)?)
            .using(boundary::transition_avoids(equations)?)
            .reason("So complex pairs lie on either side of K = K_c: areas (i)-(iv) all exist.")
    } else {
        proof
            .using(transition::intrinsically_stable(equations)?)
            .reason("So everything is stable: areas (i) and (ii) exist, (iii) and (iv) do not.")
    };
    let real_areas = 1 + usize::from(upper != Upper::Absent);
    let statement = format!(
        "For {} the (V, σ) plane has {real_areas} separate area(s) with max Im(s) = 0: a \
             stable one at low σ, {}.",
        effects.as_str(),
        upper.as_str()
    );
    Ok(Areas {
        effects,
        real_areas,
        unstable_real_areas: usize::from(unstable),
        exists: [true, true, unstable, unstable],
        proof: Proof { statement, ..proof },
    })
}

/// What the area with two roots right of −1 is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Upper {
    Absent,
    Stable,
    Unstable,
}

impl Upper {
    fn as_str(self) -> &'static str {
        match self {
            Self::Absent => "and none at high σ",
            Self::Stable => "and a stable one at high σ",
            Self::Unstable => "and an unstable one at high σ",
        }
    }
}

fn separate(proof: Proof) -> Proof {
    proof
        .reason(
            "The sets are closed in the open quadrant and disjoint (in one two roots exceed −1, \
             in the other none), so they are separate areas; outside them a pair is complex.",
        )
        .reason(
            "(η, κ) ↔ (V0, σ) by σ = K D_c/(a κ), V0² = η σ a D_c/M maps the open quadrants \
             continuously onto each other, both ways.",
        )
}

/// F(p) = (p + 1)(κ − g(p)) with g(p) = β p/(p + 1) − p − η p²: roots are where g takes the value κ.
fn form(equations: &PaperEquations, effects: Effects) -> Result<Proof, Refutation> {
    let f = cubic(equations);
    let product = formula("p + 1") * (formula("kappa") - level());
    let id = format!("areas-for-{}", format!("{effects:?}").to_lowercase());
    Proof::new(&id, "")
        .identity(
            "F(−1) = β > 0, so −1 is no root",
            &["8"],
            &f.with("p", &formula("-1")),
            &formula("beta"),
            &Domain::default(),
        )?
        .identity(
            "F is (p + 1)(κ − g(p)): the roots are where g(p) = κ",
            &["8"],
            &f,
            &product,
            &given_nonzero(Domain::default(), &["p + 1"], &[]),
        )
}

fn level() -> Expression {
    formula("beta*p/(p + 1) - p - eta*p^2")
}

/// β > 1, β = 1 or 0 < β < 1, with d > 0 for the distance from 1.
fn case(effects: Effects) -> Domain {
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

/// Right of p = −1 the function g is strictly concave and zero at 0; the sign of its slope there decides the rest.
fn upper_area(proof: Proof, effects: Effects) -> Result<(Proof, Upper), Refutation> {
    let g = level();
    let p = Symbol::new("p");
    let curvature = g.derivative(&p).derivative(&p);
    let right = given_positive(Domain::positive("beta eta"), "p + 1", &[]);
    let domain = in_parameters(right, &[("p", "x - 1", "x", "p + 1")]);
    let slope = g.derivative(&p).with("p", &formula("0"));
    let case = case(effects);
    let proof = proof
        .certify(
            "g'' < 0 for p = x − 1 > −1",
            &[],
            Certificate::Sign { expression: curvature, sign: -1, domain },
        )?
        .identity("g(0)", &[], &g.with("p", &formula("0")), &formula("0"), &Domain::default())?;
    let sign = case.sign(&slope).map_err(|error| proof.refute("g'(0) has a sign", &[], error.to_string()))?;
    let Some(sign) = sign else {
        let proof = proof.identity("g'(0)", &[], &slope, &formula("0"), &case)?.reason(
            "So the greatest value of g right of −1 is g(0) = 0: no root there for any κ > 0, and \
             no upper area.",
        );
        return Ok((proof, Upper::Absent));
    };
    let proof =
        proof.certify("sign of g'(0)", &[], Certificate::Sign { expression: slope, sign, domain: case })?;
    Ok(if sign > 0 {
        (proof.reason(concave("positive: the area is unstable")), Upper::Unstable)
    } else {
        (proof.reason(concave("between −1 and 0, the third below −1: the area is stable")), Upper::Stable)
    })
}

fn concave(roots: &str) -> String {
    format!(
        "g → −∞ at both ends of (−1, ∞), so it has one greatest value m(η) > 0, continuous in \
             η, and takes each value κ in (0, m) twice. Two roots right of −1 exist exactly for 0 \
             < κ ≤ m(η): a connected area for all η > 0, in which these roots are {roots}."
    )
}

/// Left of p = −1, with p = −1 − x: G(x) = g(−1 − x) falls from +∞ to −∞, but for one rise when η is small.
fn lower_area(proof: Proof) -> Result<Proof, Refutation> {
    let x = Symbol::new("x");
    let level = level().with("p", &formula("-1 - x"));
    let slope = level.derivative(&x);
    let third = slope.derivative(&x).derivative(&x);
    let threshold = formula("(1 - beta/x^2)/(2*(1 + x))");
    let factor = Expression::integer(2) * formula("1 + x") * (threshold.clone() - formula("eta"));
    let stationary = level.with("eta", &threshold);
    let threshold_slope = formula("(beta*(3*x + 2) - x^3)/(2*x^3*(1 + x)^2)");
    let positive = Domain::positive("beta eta x");
    let below_half = formula("1/2") - threshold.clone();
    let cusp = formula("x^3/(3*x + 2)").derivative(&x);
    let proof = proof
        .certify(
            "G''' < 0: G' is strictly concave",
            &[],
            Certificate::Sign { expression: third, sign: -1, domain: positive.clone() },
        )?
        .identity(
            "G' is 2(1 + x)(e(x) − η) with e(x) = (1 − β/x²)/(2(1 + x))",
            &[],
            &slope,
            &factor,
            &positive,
        )?
        .positive("e(x) < 1/2, so that G' < 0 throughout for η ≥ 1/2", &[], &below_half, &positive)?
        .identity("slope of e", &[], &threshold.derivative(&x), &threshold_slope, &positive)?
        .positive(
            "x³/(3x + 2) rises from 0 without limit: e has one greatest value η_c, rising before \
             it and falling after",
            &[],
            &cusp,
            &positive,
        )?
        .positive("G > 0 where G' = 0", &[], &stationary, &positive)?;
    Ok(proof
        .reason(
            "So for η > η_c there is one root left of −1, and for 0 < η ≤ η_c G has a least value \
             at x1(η) and a greatest at x2(η), both continuous in η and equal at η_c only; three \
             roots left of −1 exist exactly for G(x1) ≤ κ ≤ G(x2), all κ > 0: one connected area, \
             with η < 1/2, stable because all roots are below −1, closed by one cusp at η_c.",
        )
        .reason(
            "F(−1) > 0 puts an odd number of roots left of −1: three, or one with the other two \
             both right of −1 or complex. So all roots are real exactly in these sets.",
        ))
}
