//! Names that `equations.toml` derives, with results that are known without the program's algebra.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Argument, Claim, Definition, Formula, Truth, compare};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Name, Term, ln, minus, n, s};

const KIND: &str = "derivations";

pub fn claim(random: &mut Random) -> Claim {
    match random.below(10) {
        0..=2 => characteristic(random),
        3..=4 => under_a_condition(random),
        _ => by_word(random),
    }
}

/// A claim that a definition is equal to this, or to something else.
fn is(random: &mut Random, definition: Definition, value: Term) -> Claim {
    let [u] = positives(random);
    let truth = random.percent(60);
    let value = if truth { value } else { value + u };
    let mut claim = Claim::compare(KIND, truth, Term::Name(Name::Defined(0)), "=", value);
    claim.define(definition);
    claim
}

fn derived(word: &'static str, arguments: Vec<Argument>) -> Definition {
    Definition::Derivation(word, arguments)
}

fn by_word(random: &mut Random) -> Claim {
    let [x, u, v, w] = positives(random);
    let [y] = frees(random);
    let term = |one: &Term| Argument::Term(one.clone());
    let text = |one: &str| Argument::Text(one.to_owned());
    let cubic = x.power(3) + &u * x.power(2) + &v * &x + &w;
    let quadratic = &u * x.power(2) + &v * &x + &w;
    let (definition, value) = match random.below(13) {
        0 => (derived("solve", vec![term(&(&u * &y + &v - &w)), term(&y)]), (w - v) / u),
        1 => (derived("solve", vec![term(&(&u * &x - &v)), term(&x)]), v / u),
        2 => (derived("derivative", vec![term(&cubic), term(&x)]), n(3) * x.power(2) + n(2) * &u * &x + v),
        3 => (derived("derivative", vec![term(&(&u / &x)), term(&x)]), minus(u) / x.power(2)),
        4 => (
            Definition::Derivation("at", vec![term(&cubic), Argument::Value(name_of(&x), n(2))]),
            n(8) + n(4) * u + n(2) * v + w,
        ),
        5 => (derived("coefficient", vec![term(&((&x + &u) * (&x + &v))), term(&x), text("1")]), u + v),
        6 => (
            derived(
                "coefficient",
                vec![term(&((&x + &u) * (x.power(2) + &v * &x + &w))), term(&x), text("2")],
            ),
            u + v,
        ),
        7 => (derived("discriminant", vec![term(&quadratic), term(&x)]), v.power(2) - n(4) * u * w),
        8 => (derived("exchange", vec![term(&(&u.power(2) - &v)), term(&u), term(&v)]), v.power(2) - u),
        9 => (derived("limit", vec![term(&((&u * &x + &v) / (&x + &w))), term(&x), text("infinity")]), u),
        10 => (derived("limit", vec![term(&((&u * &x + &v) / (&x + &w))), term(&x), text("0")]), v / w),
        11 => (
            derived("series", vec![term(&(&u / (n(1) + &x))), term(&x), text("2")]),
            &u - &u * &x + &u * x.power(2),
        ),
        _ => (derived("hurwitz", vec![term(&cubic), term(&x), text("2")]), u * v - w),
    };
    is(random, definition, value)
}

/// A name that has a meaning under a condition only, which a claim on it has to state.
fn under_a_condition(random: &mut Random) -> Claim {
    let [a, b, c] = positives(random);
    let (definition, sign) = match random.below(3) {
        0 => (Definition::Equation(&c / (&b - &a)), ">"),
        1 => (Definition::Expression(ln(&b - &a)), "!="),
        _ => (derived("solve", vec![Argument::Term((&b - &a) * &c - n(1)), Argument::Term(c)]), ">"),
    };
    let mut claim = Claim::compare(KIND, sign == ">", Term::Name(Name::Defined(0)), sign, n(0));
    claim.define(Definition::Given(Box::new(definition), compare(a.clone(), "<", b.clone())));
    match random.below(3) {
        0 => Claim { truth: Truth::Meaningless, ..claim },
        1 => Claim { truth: Truth::Meaningless, ..claim.given(a, "<=", b) },
        _ => claim.given(a, "<", b),
    }
}

/// The characteristic polynomial of a system with known slopes.
fn characteristic(random: &mut Random) -> Claim {
    let [a, b, c, d] = positives(random);
    let [x, y] = frees(random);
    let (states, zero) = (vec![name_of(&x), name_of(&y)], n(0));
    let curved = x.power(2) * n(random.whole(-3, 3));
    // x' = −a x + b y + …, y' = −c x − d y around zero, or around another point.
    let moved = random.coin();
    let (at_x, at_y) = if moved { (c.clone(), n(1)) } else { (zero.clone(), zero.clone()) };
    let curved = if moved { zero } else { curved };
    let (dx, dy) = (&x - &at_x, &y - &at_y);
    let rates = vec![minus(&a) * &dx + &b * &dy + curved, minus(&c) * dx - &d * dy];
    let definition = Definition::Characteristic(states, rates, vec![at_x, at_y]);
    let known = s().power(2) + (&a + &d) * s() + (&a * &d + &b * &c);
    match random.below(3) {
        0 => is(random, definition, known),
        1 => roots(definition, true, "stable", None),
        _ => roots(definition, false, "all_real", Some((a, d))),
    }
}

fn roots(definition: Definition, truth: bool, word: &'static str, equal: Option<(Term, Term)>) -> Claim {
    let mut claim = Claim::formula(KIND, truth, Formula::Roots(word, Term::Name(Name::Defined(0))));
    claim.define(definition);
    claim.given.extend(equal.map(|(left, right)| compare(left, "=", right)));
    claim
}
