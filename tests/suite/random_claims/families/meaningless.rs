//! What is neither true nor false: sides without a value, conditions that no point meets, texts outside the grammar.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Claim, Definition, Formula, Statement, Truth, compare};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Term, exp, ln, minus, n, s, sqrt};

pub fn claim(random: &mut Random) -> Claim {
    let claim = match random.below(10) {
        0..=4 => without_value(random),
        5 => without_value_at_an_edge(random),
        6..=7 => without_points(random),
        8 => beyond_the_domain(random),
        _ => ill_formed(random),
    };
    Claim { truth: Truth::Meaningless, ..claim }
}

/// An expression without a value at some values of its variables.
fn undefined(random: &mut Random) -> Term {
    let [a, b] = positives(random);
    let [y] = frees(random);
    match random.below(17) {
        0 => n(1) / (&a - &b),
        1 => ln(y),
        2 => ln(a - b),
        3 => sqrt(a - b),
        4 => sqrt(y),
        5 => y.power(-1),
        6 => y.power(0),
        7 => ln(&b - n(2) * &b),
        8 => n(0) / (&a + minus(&a)),
        9 => n(1) / n(0),
        10 => n(1) / (y.power(2) - n(1)),
        11 => sqrt(minus(a)),
        12 => ln(y.power(2)),
        13 => exp(n(1) / y),
        14 => n(1) / y.call("abs"),
        15 => n(1) / (sqrt(a.power(2)) - a),
        _ => ln(n(-1)),
    }
}

/// The expression in a place where it seems to do no harm.
fn without_value(random: &mut Random) -> Claim {
    let kind = "no value";
    let bad = undefined(random);
    let [a, x] = positives(random);
    let hidden = match random.below(5) {
        0 => n(0) * &bad,
        1 => &bad + minus(&bad),
        2 => bad.power(0),
        3 => &bad * n(0),
        _ => n(0) * &bad * &a,
    };
    let side = &a + &hidden;
    let known = |left: &Term| Formula::Compare(compare(left.clone(), ">", n(0)));
    let statement = |statement| Claim::new(kind, Truth::Meaningless, statement);
    match random.below(13) {
        0 => Claim::compare(kind, true, side, "=", a),
        1 => Claim::compare(kind, true, hidden, "=", n(0)),
        2 => Claim::compare(kind, true, bad.clone() / bad, "=", n(1)),
        3 => Claim::compare(kind, true, bad.clone(), "<", bad + n(1)),
        4 => Claim::formula(kind, true, Formula::Or(vec![known(&a), known(&bad)])),
        5 => Claim::formula(kind, true, known(&hidden).implies(known(&a))),
        6 => Claim::formula(kind, true, Formula::Roots("stable", s() + side)),
        7 => statement(Statement::Monotone { side: &x + hidden, rises: true, with: name_of(&x) }),
        8 => statement(Statement::Depends { side, depends: false, on: name_of(&x) }),
        9 => statement(Statement::Limit { side: &x + hidden, value: n(0), of: name_of(&x), to: "0" }),
        10 => Claim::compare(kind, true, a.clone(), ">", n(0)).given(side, ">", n(0)),
        11 => {
            let mut claim = Claim::compare(kind, true, a.clone(), ">", n(0));
            let name = claim.define(if random.coin() {
                Definition::Equation(side)
            } else {
                Definition::Expression(side)
            });
            let Statement::Formula(formula) = claim.statement else { unreachable!("a comparison") };
            let uses = known(&Term::Name(name));
            claim.statement = Statement::Formula(Formula::Or(vec![formula, uses]));
            claim
        }
        _ => Claim::compare(kind, true, &x * &a, ">", hidden).there_is(name_of(&x)),
    }
}

/// A side that loses its value on the edge of the conditions.
fn without_value_at_an_edge(random: &mut Random) -> Claim {
    let kind = "no value at an edge";
    let [a, b] = positives(random);
    let [y] = frees(random);
    let is = |left: Term| Claim::compare(kind, true, left, ">", n(0));
    match random.below(5) {
        0 => is(n(1) / (&a - &b)).given(a, ">=", b),
        1 => is(n(1) + sqrt(&a - &b)).given(a, ">", b - Term::Number(1, 1000)),
        2 => is(n(1) / &y).given(y, ">=", n(0)),
        3 => is(n(1) + n(0) * ln(&y)).given(y, ">=", n(0)),
        _ => is(n(1) / (&a - &b).power(2)).given(&a + &b, ">", n(1)),
    }
}

/// Conditions that contradict each other.
fn without_points(random: &mut Random) -> Claim {
    let kind = "no points";
    let [a, b, c] = positives(random);
    let [x, y] = frees(random);
    let sign = ["<", ">", "=", ">="][random.below(4)];
    let is = Claim::compare(kind, true, &a + &c, sign, b.clone());
    match random.below(8) {
        0 => is.given(a.clone(), "<", b.clone()).given(b, "<", a),
        1 => is.given(a.clone(), "=", &b + &c).given(a, "<", b),
        2 => is.given(x.power(2), "<", n(0)),
        3 => is.given(x.clone(), ">", n(1)).given(x, "<", n(1)),
        4 => is.given(&a + &b, "<=", n(0)),
        5 => is.given(x.power(2) + y.power(2) + n(1), "=", n(0)),
        6 => is.given(a.clone(), ">", n(2)).at(name_of(&a), n(1)),
        _ => is.given(a.clone(), "=", minus(b)),
    }
}

/// Limits where the variable does not come.
fn beyond_the_domain(random: &mut Random) -> Claim {
    let [x, u] = positives(random);
    let limit = |side: Term, value: Term, to| {
        let statement = Statement::Limit { side, value, of: name_of(&x), to };
        Claim::new("limits beyond the domain", Truth::Meaningless, statement)
    };
    match random.below(4) {
        0 => limit(&x + &u, u, "0").given(x.clone(), ">", n(1)),
        1 => limit(&u / &x, n(0), "infinity").given(x.clone(), "<", n(1)),
        2 => limit(&u / &x, n(0), "infinity").given(x.clone(), "<=", u),
        _ => limit(&x * &u, n(0), "0").given(x.clone(), ">=", u),
    }
}

/// Texts that are no formula of the grammar, whatever the names of the variables are.
const ILL_FORMED: [&str; 40] = [
    "1 <",
    "< 1",
    "1 = = 1",
    "1 < 2 < 3",
    "[1 > 0",
    "1 > 0]",
    "not",
    "and 1 > 0",
    "1 > 0 or",
    "1 > 0 and or 2 > 1",
    "(1 > 0",
    "1) > 0",
    "2x > 0",
    "no_such_name > 0",
    "no_such_function(1) > 0",
    "stable(2)",
    "stable(no_such_name + 1, zz)",
    "stable(zz + 1, 1)",
    "stable(zz + 1, zz) = 1",
    "1 > stable(zz + 1, zz)",
    "stable(1/zz, zz)",
    "all_real(sqrt(zz), zz)",
    "unstable(zz^9 + 1, zz)",
    "stable(ln(2), zz) and",
    "pair_crosses(zz^2 + 1, zz)",
    "1.2.3 > 0",
    "1 -> 1 as",
    "1 -> 1 as no_such_name -> 0",
    "1 rises with",
    "1 rises with no_such_name",
    "1 depends on 2",
    "1^2.5 > 0",
    "1^(2) > 0",
    "5",
    "1 => 0",
    "1 > 0 implies implies 2 > 0",
    "θ > 0",
    "1 ≥ 0",
    "1 > 0;",
    "stable(exp(zz), zz)",
];

fn ill_formed(random: &mut Random) -> Claim {
    let text = (*random.pick(&ILL_FORMED)).to_owned();
    Claim::new("ill-formed", Truth::Meaningless, Statement::IllFormed(text))
}

/// Equations that are refused as a whole, with a word of the refusal; the names `a`, `b` and `x` are positive, `y` is free.
pub fn faulty_equations() -> Vec<(&'static str, &'static str)> {
    vec![
        (
            "[[equation]]\nnumber = \"1\"\nequation = \"Z = 1\"\n[[equation]]\nnumber = \"2\"\nequation = \"Z = 2\"\n",
            "Z",
        ),
        ("[[definition]]\nname = \"Z\"\nis = \"1\"\n[[definition]]\nname = \"Z\"\nis = \"2\"\n", "Z"),
        (
            "[[definition]]\nname = \"Z\"\nis = \"1\"\n[[equation]]\nnumber = \"1\"\nequation = \"Z = 1\"\n",
            "Z",
        ),
        ("[[definition]]\nname = \"a\"\nis = \"1\"\n", "a"),
        ("[[definition]]\nname = \"Z\"\nis = \"Z + 1\"\n", "Z"),
        ("[[definition]]\nname = \"Z\"\nis = \"Q + 1\"\n[[definition]]\nname = \"Q\"\nis = \"Z + 1\"\n", "Z"),
        ("[[definition]]\nname = \"ln\"\nis = \"1\"\n", "ln"),
        ("[[definition]]\nname = \"i\"\nis = \"1\"\n", "i"),
        ("[[definition]]\nname = \"Z\"\nis = \"0*ln(a - b)\"\n", "Z"),
        ("[[equation]]\nnumber = \"1\"\nequation = \"Z = 0/(a - a)\"\n", "1"),
        ("[[definition]]\nname = \"Z\"\nis = \"solve(a*x, y)\"\n", "Z"),
        ("[[definition]]\nname = \"Z\"\nis = \"derivative(a*no_such_name, a)\"\n", "no_such_name"),
        ("[[system]]\nname = \"S\"\nstate = [\"y\"]\nrates = [\"1 - y\"]\nsteady = [\"2\"]\n", "S"),
        ("[[system]]\nname = \"S\"\nstate = [\"y\"]\nrates = [\"1 - y\", \"y\"]\nsteady = [\"1\"]\n", "S"),
    ]
}
