//! Expressions in which a variable cancels, and those in which it does not.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Claim, Statement, Truth};
use crate::random_claims::rewriting::{all_names, frees, positive, positives, total};
use crate::random_claims::term::{Name, Term, exp, ln, minus, n, sqrt};

fn depends(truth: bool, side: Term, depends: bool, on: Name) -> Claim {
    let statement = Statement::Depends { side, depends: depends == truth, on };
    Claim::new(if depends { "dependence" } else { "independence" }, Truth::of(truth), statement)
}

pub fn claim(random: &mut Random) -> Claim {
    let truth = random.percent(55);
    match random.below(10) {
        0..=3 => cancelled(random, truth),
        4..=7 => present(random, truth),
        _ => under_conditions(random, truth),
    }
}

fn without(name: Name) -> Vec<Name> {
    all_names().into_iter().filter(|other| *other != name).collect()
}

fn cancelled(random: &mut Random, truth: bool) -> Claim {
    let [x] = positives(random);
    let others = without(name_of(&x));
    let (h, u) = (total(random, 1, &others), positive(random, 1, &others));
    let side = match random.below(9) {
        0 => &h + &x - &x,
        1 => &h * &x / &x,
        2 => (&x + &h).power(2) - x.power(2) - n(2) * &x * &h,
        3 => &x / (&x * &u),
        4 => exp(&x) * exp(minus(&x)) * h,
        5 => ln(&x * u) - ln(&x),
        6 => sqrt(x.power(2)) / &x + h,
        7 => n(0) * &x + h,
        _ => h,
    };
    depends(truth, side, false, name_of(&x))
}

fn present(random: &mut Random, truth: bool) -> Claim {
    let [x] = positives(random);
    let [y, z] = frees(random);
    let moving = if random.percent(30) { y } else { x };
    let others = without(name_of(&moving));
    let (h, u) = (total(random, 1, &others), positive(random, 1, &others));
    let side = match random.below(8) {
        0 => &h + &moving,
        1 => &moving * &u,
        2 => (&moving + n(2)).power(2) + h,
        3 => &u / (moving.power(2) + n(1)),
        4 => &z * &moving,
        5 => exp(&moving) + h,
        6 => sqrt(moving.power(2) + u),
        _ => moving.power(3) - &u,
    };
    depends(truth, side, true, name_of(&moving))
}

fn under_conditions(random: &mut Random, truth: bool) -> Claim {
    let [x, u] = positives(random);
    let [y, z] = frees(random);
    let sign = y.call("abs") / &y;
    let (with_x, with_y) = (name_of(&x), name_of(&y));
    match random.below(6) {
        0 => depends(truth, &z * &x, false, with_x).given(z, "=", n(0)),
        1 => depends(truth, sign, true, with_y).given(y, "!=", n(0)),
        2 => depends(truth, sign, false, with_y).given(y, ">", n(0)),
        3 => depends(truth, &z * &x, true, with_x).given(z, "<", u),
        4 => depends(truth, sqrt(y.power(2)) + &y, false, with_y).given(y, "<", n(0)),
        _ => depends(truth, (&z - &u) * &x + u.clone(), false, with_x).given(z, "=", u),
    }
}
