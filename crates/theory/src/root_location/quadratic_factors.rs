//! When all roots of a polynomial of degree 4 to 6 lie left of the imaginary axis, and when one lies right of it (Liénard and Chipart).
//!
//! Complex roots come in pairs, so that the polynomial is a product of real quadratics s² + ps + q, s² + rs + t, s² + ms + n, and s + u.
//! A quadratic has a root right of the axis exactly when p < 0 or q < 0, and all roots left of it exactly when both are positive. The proofs
//! are about leading coefficient 1, because all conditions are homogeneous.

use std::collections::BTreeMap;

use super::free;
use super::{below_zero, not_negative_step};
use crate::notation::formula;
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Relation, Sign, SignFormula, Symbol};

/// The names of the coefficients, by ascending power.
const NAMES: [&str; 7] = ["c_0", "c_1", "c_2", "c_3", "c_4", "c_5", "c_6"];

/// What decides polynomials of one degree.
struct Rule {
    /// The roots are left of the axis exactly when all of these are positive.
    stable: &'static [&'static str],
    /// A root is right of it when a coefficient or one of these is negative.
    negative: &'static [&'static str],
    /// Or when in one of these lists all of the first are zero, the second is negative, and the third is positive.
    even: &'static [(&'static [&'static str], &'static str, Option<&'static str>)],
    /// The coefficients by the quadratics, by ascending power.
    factors: &'static [&'static str],
    /// The product itself.
    product: &'static str,
    steps: &'static [(&'static str, Fact)],
}

/// A fact over the reals. Names that are not listed are free.
enum Fact {
    /// Both sides are the same polynomial.
    Same(&'static str, &'static str),
    /// The same, with the coefficients of the product on the left.
    OfProduct(&'static str, &'static str),
    /// Positive where the first names are positive and the second ones not negative.
    Positive(&'static str, &'static str, &'static str),
    /// Not negative where these names are not negative.
    NotNegative(&'static str, &'static str),
}

use Fact::{NotNegative, OfProduct, Positive, Same};

fn rule(degree: usize) -> &'static Rule {
    match degree {
        4 => &QUARTIC,
        5 => &QUINTIC,
        _ => &SEXTIC,
    }
}

pub(super) fn stable(coefficients: &[Expression]) -> Vec<Expression> {
    let rule = rule(coefficients.len() - 1);
    rule.stable.iter().map(|text| put_in(text, coefficients)).collect()
}

pub(super) fn unstable(coefficients: &[Expression]) -> SignFormula {
    let rule = rule(coefficients.len() - 1);
    let determinants = rule.negative.iter().map(|text| put_in(text, coefficients));
    let lower = coefficients.iter().take(coefficients.len() - 1).cloned();
    let negative = lower.chain(determinants).map(|one| below_zero(&one));
    let even = rule.even.iter().map(|(zero, negative, positive)| {
        let zero = zero.iter().map(|text| SignFormula::sign(&put_in(text, coefficients), Sign::Zero));
        let positive =
            positive.iter().map(|text| SignFormula::sign(&put_in(text, coefficients), Sign::Positive));
        SignFormula::All(zero.chain(positive).chain([below_zero(&put_in(negative, coefficients))]).collect())
    });
    SignFormula::Any(negative.chain(even).collect())
}

/// The text with these coefficients.
fn put_in(text: &str, coefficients: &[Expression]) -> Expression {
    let values: BTreeMap<Symbol, Expression> =
        NAMES.into_iter().map(Symbol::from).zip(coefficients.iter().cloned()).collect();
    formula(text).substitute(&values)
}

pub(super) fn lemma(degree: usize) -> Result<Proof, Refutation> {
    let Rule { stable, negative, even, factors, product, steps } = rule(degree);
    let shown = |list: &[&str]| list.join(", ");
    let cases = even.iter().map(|(zero, negative, positive)| {
        let positive = positive.map_or(String::new(), |one| format!("{one} > 0 and "));
        format!(", or when {} = 0 and {positive}{negative} < 0", zero.join(" = 0 and "))
    });
    let statement = format!(
        "A real polynomial of degree {degree} with positive leading coefficient has all roots left of the imaginary axis exactly when {} are \
         positive, and a root right of it exactly when a coefficient, {} is negative{}.",
        shown(stable),
        negative.join(" or "),
        cases.collect::<String>()
    );
    let values: Vec<Expression> = factors.iter().map(|text| formula(text)).collect();
    let multiplied = super::polynomial(&values, "s");
    let proof = Proof::new(&format!("roots-of-degree-{degree}"), statement).identity(
        "complex roots come in pairs, so that it is a product of real factors",
        &[],
        &formula(product),
        &multiplied,
        &free(),
    )?;
    steps.iter().try_fold(proof, |proof, (says, fact)| match fact {
        Same(left, right) => proof.identity(says, &[], &formula(left), &formula(right), &free()),
        OfProduct(left, right) => proof.identity(says, &[], &put_in(left, &values), &formula(right), &free()),
        Positive(text, positive, others) => {
            proof.positive(says, &[], &formula(text), &not_negative(Domain::positive(positive), others))
        }
        NotNegative(text, names) => {
            not_negative_step(proof, says, &formula(text), &not_negative(free(), names))
        }
    })
}

/// The domain in which these names are not negative, too.
pub(super) fn not_negative(domain: Domain, names: &str) -> Domain {
    names.split_whitespace().fold(domain, |domain, name| domain.given(formula(name), Relation::NonNegative))
}

const QUARTIC: Rule = Rule {
    stable: &["c_0", "c_1", "c_3", "c_1*c_2*c_3 - c_1^2*c_4 - c_0*c_3^2"],
    negative: &["c_1*c_2*c_3 - c_1^2*c_4 - c_0*c_3^2"],
    even: &[(&["c_1", "c_3"], "c_2^2 - 4*c_0*c_4", None)],
    factors: &["q*t", "p*t + q*r", "q + t + p*r", "p + r", "1"],
    product: "(s^2 + p*s + q)*(s^2 + r*s + t)",
    steps: &[
        (
            "the determinant D3 by the quadratics",
            OfProduct("c_1*c_2*c_3 - c_1^2*c_4 - c_0*c_3^2", "p*r*((q - t)^2 + (p + r)*(p*t + q*r))"),
        ),
        ("all roots left: c3", Positive("p + r", "p q r t", "")),
        ("all roots left: c2", Positive("q + t + p*r", "p q r t", "")),
        ("all roots left: c1", Positive("p*t + q*r", "p q r t", "")),
        ("all roots left: D3/(p r)", Positive("(q - t)^2 + (p + r)*(p*t + q*r)", "p q r t", "")),
        (
            "no root right: c2 is not negative, and neither are c3, c1 and c0",
            NotNegative("q + t + p*r", "p q r t"),
        ),
        (
            "no root right: D3/(p r) is not negative",
            NotNegative("(q - t)^2 + (p + r)*(p*t + q*r)", "p q r t"),
        ),
        (
            "c1, c3 > 0: D3/(p r) is positive, so that D3 > 0 gives p r > 0, and p + r > 0 gives p, r > 0",
            Positive("(q - t)^2 + c_3*c_1", "c_1 c_3", ""),
        ),
        (
            "q, t < 0 would make c1 negative: with c0 > 0 both are positive",
            Positive("p*x + r*y", "p r x y", ""),
        ),
        (
            "no condition violated, q < 0: t <= 0, and c2 >= 0 gives p, r > 0; c1 would be negative",
            Positive("r*y + p*x", "p r y", "x"),
        ),
        (
            "so q, t >= 0; p = -w < 0: r >= w, and D3 >= 0 makes this zero, where c1 and c3 are not negative",
            NotNegative("(q - t)^2 + c_3*c_1", "c_1 c_3"),
        ),
        (
            "c3 > 0: then c1 = q (p + r) = 0 and q = t = 0, so that c2 = -w r would be negative",
            Positive("w*r", "w r", ""),
        ),
        (
            "c3 = 0: r = w and q = t, and it has even powers only",
            Same("(s^2 - w*s + q)*(s^2 + w*s + q)", "s^4 + (2*q - w^2)*s^2 + q^2"),
        ),
        ("its c2^2 - 4 c0 c4", Same("(2*q - w^2)^2 - 4*q^2", "-w^2*(2*(2*q - w^2) + w^2)")),
        ("is negative, where c2 is not", Positive("w^2*(2*c_2 + w^2)", "w", "c_2")),
        (
            "even powers only, c2^2 < 4 c0 c4: with y^2 = c0 and x^2 = 2 y - c2 one of both pairs is right of the axis",
            Same("(s^2 + x*s + y)*(s^2 - x*s + y)", "s^4 + (2*y - x^2)*s^2 + y^2"),
        ),
    ],
};

const QUINTIC: Rule = Rule {
    stable: &[
        "c_0",
        "c_2",
        "c_4",
        "c_3*c_4 - c_2*c_5",
        "(c_3*c_4 - c_2*c_5)*(c_1*c_2 - c_0*c_3) - (c_1*c_4 - c_0*c_5)^2",
    ],
    negative: &["c_3*c_4 - c_2*c_5", "(c_3*c_4 - c_2*c_5)*(c_1*c_2 - c_0*c_3) - (c_1*c_4 - c_0*c_5)^2"],
    even: &[(&["c_3*c_4 - c_2*c_5", "c_1*c_4 - c_0*c_5"], "c_3^2 - 4*c_1*c_5", None)],
    factors: &[
        "u*q*t",
        "q*t + u*(p*t + q*r)",
        "p*t + q*r + u*(q + t + p*r)",
        "q + t + p*r + u*(p + r)",
        "u + p + r",
        "1",
    ],
    product: "(s + u)*(s^2 + p*s + q)*(s^2 + r*s + t)",
    steps: &[
        (
            "the determinant D2 by the factors",
            OfProduct("c_3*c_4 - c_2*c_5", "p*q + r*t + (p + r)*p*r + u*(p + r)*(u + p + r)"),
        ),
        (
            "the determinant D4 by the factors",
            OfProduct(
                "(c_3*c_4 - c_2*c_5)*(c_1*c_2 - c_0*c_3) - (c_1*c_4 - c_0*c_5)^2",
                "p*r*(u^2 + p*u + q)*(u^2 + r*u + t)*((q - t)^2 + (p + r)*(p*t + q*r))",
            ),
        ),
        ("all roots left: c1", Positive("q*t + u*(p*t + q*r)", "u p q r t", "")),
        ("all roots left: c2", Positive("p*t + q*r + u*(q + t + p*r)", "u p q r t", "")),
        ("all roots left: c3", Positive("q + t + p*r + u*(p + r)", "u p q r t", "")),
        ("all roots left: D2", Positive("p*q + r*t + (p + r)*p*r + u*(p + r)*(u + p + r)", "u p q r t", "")),
        ("all roots left: a factor of D4", Positive("u^2 + p*u + q", "u p q", "")),
        ("all roots left: the last factor of D4", Positive("(q - t)^2 + (p + r)*(p*t + q*r)", "p q r t", "")),
        (
            "no root right: c1 is not negative, and neither are c0, c2, c3 and c4",
            NotNegative("q*t + u*(p*t + q*r)", "u p q r t"),
        ),
        (
            "no root right: D2 is not negative",
            NotNegative("p*q + r*t + (p + r)*p*r + u*(p + r)*(u + p + r)", "u p q r t"),
        ),
        ("no root right: D4/(p r) is a product of such factors", NotNegative("u^2 + p*u + q", "u p q")),
        ("and of this one", NotNegative("(q - t)^2 + (p + r)*(p*t + q*r)", "p q r t")),
        (
            "c0, c2, c4, D2, D4 > 0: c3 c4 = D2 + c2 c5 is positive, and so is c1 c2 D2 = D4 + (c1 c4 - c0 c5)^2 + c0 c3 D2",
            Positive("z + y^2 + x", "z x", ""),
        ),
        (
            "no coefficient is negative: no root is positive",
            Positive("s^5 + c_4*s^4 + c_3*s^3 + c_2*s^2 + c_1*s + c_0", "s", "c_0 c_1 c_2 c_3 c_4"),
        ),
        (
            "so u >= 0, and a root that is not left of the axis is in a pair p = -v <= 0, 4 q > v^2, or is zero; for the pair",
            Same("4*(u^2 + p*u + q)", "(2*u + p)^2 + (4*q - p^2)"),
        ),
        (
            "the other factors of D4 are not negative",
            Same("4*((q - t)^2 + (p + r)*(p*t + q*r))", "(2*(t - q) + (p + r)*p)^2 + (p + r)^2*(4*q - p^2)"),
        ),
        (
            "r = -w <= 0, too, where c4 = k >= 0 and v > 0: D2 is negative",
            Positive("v*q + w*t + (v + w)*v*w + u*(v + w)*k", "v q", "u w t k"),
        ),
        (
            "v > 0, r > 0: D4 >= 0 makes a factor zero; u = t = 0 makes D2 negative, where c4 = k = r - v",
            Positive("v*q + k*v*r", "v q r", "k"),
        ),
        (
            "or r = v and t = q, and it is the product of s + u and even powers",
            Same("(s + u)*(s^2 - v*s + q)*(s^2 + v*s + q)", "(s + u)*(s^4 + (2*q - v^2)*s^2 + q^2)"),
        ),
        (
            "its c3^2 - 4 c1 c5 is minus this, with 4 q - v^2 = y",
            Same("4*q^2 - (2*q - v^2)^2", "v^2*(4*q - v^2)"),
        ),
        ("which is positive", Positive("v^2*y", "v y", "")),
        (
            "c2 = c3 c4 and c0 = c1 c4: it is such a product",
            Same(
                "s^5 + c_4*s^4 + c_3*s^3 + c_3*c_4*s^2 + c_1*s + c_1*c_4",
                "(s + c_4)*(s^4 + c_3*s^2 + c_1)",
            ),
        ),
        (
            "c3^2 < 4 c1: with y^2 = c1 and x^2 = 2 y - c3 one of both pairs is right of the axis",
            Same("(s^2 + x*s + y)*(s^2 - x*s + y)", "s^4 + (2*y - x^2)*s^2 + y^2"),
        ),
    ],
};

/// The determinants of order 3 and 5.
const D3: &str = "c_5*(c_3*c_4 - c_2*c_5) - c_6*(c_3^2 - c_1*c_5)";
const D5: &str = "-c_0^2*c_5^3 - 3*c_0*c_1*c_3*c_5*c_6 + 2*c_0*c_1*c_4*c_5^2 + c_0*c_2*c_3*c_5^2 + c_0*c_3^3*c_6 - c_0*c_3^2*c_4*c_5 \
                  - c_1^3*c_6^2 + 2*c_1^2*c_2*c_5*c_6 + c_1^2*c_3*c_4*c_6 - c_1^2*c_4^2*c_5 - c_1*c_2^2*c_5^2 - c_1*c_2*c_3^2*c_6 \
                  + c_1*c_2*c_3*c_4*c_5";

/// D3 of a polynomial with all roots left, without p r (q − t)² and the like: all terms are positive.
const REST: &str = "m^3*p^2*r + m^3*p*q + m^3*p*r^2 + m^3*r*t + m^2*n*p^2 + 2*m^2*n*p*r + m^2*n*r^2 + m^2*p^3*r + m^2*p^2*q \
                    + 2*m^2*p^2*r^2 + m^2*p*q*r + m^2*p*r^3 + m^2*p*r*t + m^2*r^2*t + m*n*p^3 + m*n*p^2*r + m*n*p*r^2 + m*n*r^3 \
                    + m*p^3*r^2 + 2*m*p^2*q*r + m*p^2*r^3 + m*p^2*r*t + m*p*q*r^2 + 2*m*p*r^2*t + p^3*r*t + p^2*q*r^2 + p^2*r^2*t \
                    + p*q*r^3";
const SQUARES_AND_REST: &str = "p*r*(q - t)^2 + p*m*(q - n)^2 + r*m*(t - n)^2 \
                                + (m^3*p^2*r + m^3*p*q + m^3*p*r^2 + m^3*r*t + m^2*n*p^2 + 2*m^2*n*p*r + m^2*n*r^2 + m^2*p^3*r + m^2*p^2*q \
                                + 2*m^2*p^2*r^2 + m^2*p*q*r + m^2*p*r^3 + m^2*p*r*t + m^2*r^2*t + m*n*p^3 + m*n*p^2*r + m*n*p*r^2 + m*n*r^3 \
                                + m*p^3*r^2 + 2*m*p^2*q*r + m*p^2*r^3 + m*p^2*r*t + m*p*q*r^2 + 2*m*p*r^2*t + p^3*r*t + p^2*q*r^2 \
                                + p^2*r^2*t + p*q*r^3)";

/// With c5 = x and c1 in the place of the third quadratic.
const TWO_PAIRS: &str = "-(x + a)*(x*a*d - a*((x + a)*d - n*b) - (a*b*g - b^2 - a^2*d))^2 \
                         - x*a*b*((a*b*g - b^2 - a^2*d)*(x^2 + 2*a*x + a^2) + ((x + a)*d - n*b)*(a^2*x + a^3)) \
                         - b^2*x*(a*b*g - b^2 - a^2*d)";

const SEXTIC: Rule = Rule {
    stable: &["c_0", "c_1", "c_2", "c_3", "c_4", "c_5", D3, D5],
    negative: &[D3, D5],
    even: &[
        (
            &["c_1", "c_3", "c_5"],
            "18*c_6*c_4*c_2*c_0 - 4*c_4^3*c_0 + c_4^2*c_2^2 - 4*c_6*c_2^3 - 27*c_6^2*c_0^2",
            None,
        ),
        (
            &["c_5^2*c_2 - c_1*c_5*c_6 - c_3*(c_4*c_5 - c_3*c_6)", "c_5^2*c_0 - c_1*(c_4*c_5 - c_3*c_6)"],
            "c_3^2 - 4*c_1*c_5",
            Some("c_5"),
        ),
    ],
    factors: &[
        "n*q*t",
        "m*q*t + n*(p*t + q*r)",
        "q*t + m*(p*t + q*r) + n*(q + t + p*r)",
        "p*t + q*r + m*(q + t + p*r) + n*(p + r)",
        "q + t + p*r + m*(p + r) + n",
        "p + r + m",
        "1",
    ],
    product: "(s^2 + p*s + q)*(s^2 + r*s + t)*(s^2 + m*s + n)",
    steps: &[
        ("the determinant D3 by the quadratics", OfProduct(D3, SQUARES_AND_REST)),
        (
            "the determinant D5 by the quadratics",
            OfProduct(
                D5,
                "p*r*m*((q - t)^2 + (p + r)*(p*t + q*r))*((q - n)^2 + (p + m)*(p*n + q*m))*((t - n)^2 + (r + m)*(r*n + t*m))",
            ),
        ),
        ("all roots left: c1", Positive("m*q*t + n*(p*t + q*r)", "p q r t m n", "")),
        ("all roots left: c2", Positive("q*t + m*(p*t + q*r) + n*(q + t + p*r)", "p q r t m n", "")),
        ("all roots left: c3", Positive("p*t + q*r + m*(q + t + p*r) + n*(p + r)", "p q r t m n", "")),
        ("all roots left: c4", Positive("q + t + p*r + m*(p + r) + n", "p q r t m n", "")),
        ("all roots left: D3 without its squares", Positive(REST, "p q r t m n", "")),
        ("all roots left: a factor of D5", Positive("(q - t)^2 + (p + r)*(p*t + q*r)", "p q r t", "")),
        (
            "no root right: c3 is not negative, and neither are the others",
            NotNegative("p*t + q*r + m*(q + t + p*r) + n*(p + r)", "p q r t m n"),
        ),
        ("no root right: D3 without its squares is not negative", NotNegative(REST, "p q r t m n")),
        (
            "no root right: a factor of D5 is not negative",
            NotNegative("(q - t)^2 + (p + r)*(p*t + q*r)", "p q r t"),
        ),
        (
            "no coefficient is negative: no root is positive",
            Positive(
                "s^6 + c_5*s^5 + c_4*s^4 + c_3*s^3 + c_2*s^2 + c_1*s + c_0",
                "s",
                "c_0 c_1 c_2 c_3 c_4 c_5",
            ),
        ),
        (
            "so a root that is not left of the axis is in a pair p = -v <= 0, 4 q > v^2, or is zero; for the pair, a factor of D5 is a sum of squares",
            Same("4*((q - t)^2 + (p + r)*(p*t + q*r))", "(2*(t - q) + (p + r)*p)^2 + (p + r)^2*(4*q - p^2)"),
        ),
        (
            "two pairs with p = -v, r = -w: their product is s^4 - a s^3 + g s^2 - b s + d, and a b g - b^2 - a^2 d is",
            Same(
                "(v + w)*(v*t + w*q)*(q + t + v*w) - (v*t + w*q)^2 - (v + w)^2*q*t",
                "v*w*((q - t)^2 + (v + w)*(v*t + w*q))",
            ),
        ),
        ("which is h > 0 for v, w > 0", Positive("(q - t)^2 + (v + w)*(v*t + w*q)", "v w q t", "")),
        (
            "with c5 = x, so that m = x + a, a b^2 D3 is",
            Same(
                "a*b^2*(x*((g - a*(x + a) + n)*((x + a)*g - b - n*a) - x*(d - (x + a)*b + n*g)) - ((x + a)*g - b - n*a)^2 + x*((x + a)*d - n*b))",
                TWO_PAIRS,
            ),
        ),
        (
            "where c1 = (x + a) d - n b: for x = 0 it is minus this, which is positive",
            Positive("a*(a*c_1 + h)^2", "a h", "c_1"),
        ),
        (
            "for x > 0 minus a square, minus b^2 x h, and minus this, which is positive: D3 is negative",
            Positive("x*a*b*(h*(x^2 + 2*a*x + a^2) + c_1*(a^2*x + a^3))", "x a b h", "c_1"),
        ),
        (
            "r = 0, t > 0: h = 0, and for x > 0 D3 is negative: c1 > 0 makes the second part positive",
            Positive("x*a*b*c_1*(a^2*x + a^3)", "x a b c_1", ""),
        ),
        ("and c1 = 0 the first", Positive("(x + a)*(x*a*d)^2", "x a d", "")),
        (
            "for x = 0 it is this: c1 = 0, and n = q, so that it has even powers only",
            Same("(s^2 - v*s + q)*(s^2 + t)*(s^2 + v*s + q)", "(s^2 + t)*(s^4 + (2*q - v^2)*s^2 + q^2)"),
        ),
        (
            "r = t = 0, or t = n = 0: it is s^2 times a polynomial of degree 4, whose D3 is D3",
            Same("c_5*(c_3*c_4 - c_2*c_5) - c_3^2", "c_3*c_4*c_5 - c_3^2 - c_2*c_5^2"),
        ),
        (
            "the lemma on degree 4 leaves even powers only, with this discriminant",
            Same("c_4^2*c_2^2 - 4*c_2^3", "c_2^2*(c_4^2 - 4*c_2)"),
        ),
        (
            "one pair with v > 0, and r, m > 0: D5 >= 0 makes a factor zero; r = v and t = q give",
            Same(
                "(s^2 - v*s + q)*(s^2 + v*s + q)*(s^2 + m*s + n)",
                "(s^4 + (2*q - v^2)*s^2 + q^2)*(s^2 + m*s + n)",
            ),
        ),
        (
            "its c3^2 - 4 c1 c5 is minus m^2 times this, with 4 q - v^2 = y",
            Same("4*q^2 - (2*q - v^2)^2", "v^2*(4*q - v^2)"),
        ),
        ("which is positive", Positive("v^2*y", "v y", "")),
        (
            "the third factor of D5 is zero for r, m > 0 and t, n >= 0 only when t = n = 0",
            NotNegative("(t - n)^2 + (r + m)*(r*n + t*m)", "r m t n"),
        ),
        (
            "c5 = m > 0, c3 = m e, c1 = m f: the second case says that it is a product",
            Same(
                "(s^4 + e*s^2 + f)*(s^2 + m*s + n)",
                "s^6 + m*s^5 + (e + n)*s^4 + m*e*s^3 + (f + e*n)*s^2 + m*f*s + f*n",
            ),
        ),
        (
            "e^2 < 4 f: with y^2 = f and x^2 = 2 y - e one of both pairs is right of the axis",
            Same("(s^2 + x*s + y)*(s^2 - x*s + y)", "s^4 + (2*y - x^2)*s^2 + y^2"),
        ),
        (
            "even powers only, and a square of a root that is not real: a root and its opposite are on both sides",
            Same("(-s)^6 + c_4*(-s)^4 + c_2*(-s)^2 + c_0", "s^6 + c_4*s^4 + c_2*s^2 + c_0"),
        ),
    ],
};
