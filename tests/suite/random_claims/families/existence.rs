//! Values that exist for all values of the other variables, with a known witness, and values that do not.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Claim, Formula, compare};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Term, exp, ln, minus, n, s, sqrt};

pub fn claim(random: &mut Random) -> Claim {
    let (claim, witness) = if random.percent(60) { there_is(random) } else { there_is_under(random) };
    let name = claim.there_is[0];
    let [u] = positives(random);
    match (witness, random.below(10)) {
        (Some(witness), 0..=4) => claim.witness(name, witness),
        // A witness that need not do: the claim is true or false without it.
        (_, 5) if Term::Name(name) != u => claim.witness(name, u / n(2)),
        _ => claim,
    }
}

/// A claim that there is such a value of a variable, and the value.
fn there_is(random: &mut Random) -> (Claim, Option<Term>) {
    let [v, a, b] = positives(random);
    let [w, y] = frees(random);
    let c = n(random.whole(1, 6));
    let kind = "existence";
    let is = |truth, left: Term, sign, right: Term, of: &Term| {
        Claim::compare(kind, truth, left, sign, right).there_is(name_of(of))
    };
    let found = match random.below(22) {
        0 => (is(true, v.clone(), ">", a.clone(), &v), a + n(1)),
        1 => (is(true, &v * &a, "=", b.clone(), &v), b / a),
        2 => (is(true, v.power(2), "=", a.clone(), &v), sqrt(a)),
        3 => (is(true, v.clone(), "<", a.clone(), &v), a / n(2)),
        4 => return (is(false, &v + &a, "=", b, &v), None),
        5 => (is(true, &w + &a, "=", b.clone(), &w), b - a),
        6 => return (is(false, w.power(2), "=", y, &w), None),
        7 => (is(true, w.clone(), ">=", y.clone(), &w), y),
        8 => (is(true, v.clone(), ">=", y.clone(), &v), y.power(2) + n(1)),
        9 => return (is(false, &w * y, "=", n(1), &w), None),
        10 => return (is(false, &v * y, "=", n(0), &v), None),
        11 => (is(true, &w * y, "=", n(0), &w), n(0)),
        12 => (is(true, exp(&w), "=", a.clone(), &w), ln(a)),
        13 => return (is(false, exp(&w), "=", y, &w), None),
        14 => return (is(false, v.power(2) + n(1), "<", n(2) * &v, &v), None),
        15 => (is(true, v.power(2), "<=", n(2) * &v - n(1), &v), n(1)),
        16 => return (is(false, v.clone(), "<", y, &v), None),
        17 => (is(true, w.clone(), "<", minus(&a), &w), minus(a) - n(1)),
        18 => (is(true, w.power(2), "=", n(2), &w), sqrt(n(2))),
        19 => return (is(false, w.power(2), "<", n(0), &w), None),
        20 => return (is(true, w.power(3), "=", y, &w), None),
        _ => return (is(true, w.power(2), ">", &y + c, &w), None),
    };
    (found.0, Some(found.1))
}

/// The same with conditions on the variable itself: it has to meet them, for all values of the others.
fn there_is_under(random: &mut Random) -> (Claim, Option<Term>) {
    let [v, a, b] = positives(random);
    let [w, y] = frees(random);
    let number = random.whole(1, 6);
    let c = n(number);
    let kind = "existence under conditions";
    let is = |truth, left: &Term, sign, right: Term, of: &Term| {
        Claim::compare(kind, truth, left.clone(), sign, right).there_is(name_of(of))
    };
    let oscillator = |damping: &Term| Formula::Roots("stable", s().power(2) + damping * s() + n(1));
    let between = Formula::And(vec![
        Formula::Compare(compare(a.clone(), "<", v.clone())),
        Formula::Compare(compare(v.clone(), "<", b.clone())),
    ]);
    let found = match random.below(15) {
        0 => return (is(false, &v, ">", n(0), &v).given(v, "<", a - b), None),
        1 => {
            let claim = is(true, &v, ">", n(0), &v).given(v, "<", &a - &b).given(a.clone(), ">", b.clone());
            (claim, (a - b) / n(2))
        }
        2 => return (is(false, &v, "=", c, &v).given(v, ">", a), None),
        3 => (is(true, &v, "=", c.clone(), &v).given(v, ">", a.clone()).given(a, "<", c.clone()), c),
        4 => (is(true, &w.power(2), "=", y.clone(), &w).given(y.clone(), ">=", n(0)), sqrt(y)),
        5 => (is(true, &(&w * &y), "=", n(1), &w).given(y.clone(), "!=", n(0)), n(1) / y),
        6 => {
            let claim = Claim::formula(kind, false, oscillator(&w)).there_is(name_of(&w));
            return (claim.given(w, "<", y), None);
        }
        7 => {
            let claim = Claim::formula(kind, true, oscillator(&v)).there_is(name_of(&v));
            (claim.given(v, "<", a.clone()), a / n(2))
        }
        8 => (is(true, &v, ">", n(0), &v).given(v, "<", a.clone()), a / n(2)),
        9 => return (is(false, &w, ">", n(0), &w).given(w, "<", y), None),
        10 => return (Claim::formula(kind, false, between).there_is(name_of(&v)), None),
        11 => {
            let claim = Claim::formula(kind, true, between).there_is(name_of(&v));
            (claim.given(a.clone(), "<", b.clone()), (a + b) / n(2))
        }
        12 => return (is(false, &v, ">=", b, &v).given(v, "<=", a), None),
        13 => (is(true, &v, "<=", a.clone(), &v).given(v, ">=", a.clone()), a),
        _ => return (is(false, &w, ">", a, &w).given(w, "<", y), None),
    };
    (found.0, Some(found.1))
}
