//! Expressions with a known limit.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Claim, Statement, Truth};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Term, exp, ln, minus, n, sqrt};

pub fn claim(random: &mut Random) -> Claim {
    match random.below(10) {
        0..=4 => rational(random),
        5..=7 => with_functions(random),
        8 => beyond_all_bounds(random),
        _ => without_limit(random),
    }
}

fn limit(kind: &'static str, truth: bool, side: Term, value: Term, of: &Term, to: &'static str) -> Claim {
    Claim::new(kind, Truth::of(truth), Statement::Limit { side, value, of: name_of(of), to })
}

/// The value as it is, or another one.
fn claimed(random: &mut Random, value: Term, u: &Term) -> (bool, Term) {
    match random.below(6) {
        0 => (false, value + u),
        1 => (false, value + n(1)),
        2 => (false, value - u),
        _ => (true, value),
    }
}

/// A positive coefficient without the variable.
fn coefficient(random: &mut Random, others: &[Term]) -> Term {
    match random.below(4) {
        0 => n(random.whole(1, 6)),
        1 => random.pick(others) * random.pick(others),
        _ => random.pick(others).clone(),
    }
}

fn rational(random: &mut Random) -> Claim {
    let [x, u, v, w] = positives(random);
    let others = [u.clone(), v, w];
    let polynomial = |random: &mut Random, degree: i32| -> (Term, Term, Term) {
        let (lowest, highest) = (coefficient(random, &others), coefficient(random, &others));
        let middle = coefficient(random, &others);
        let sum = match degree {
            0 => return (lowest.clone(), lowest.clone(), lowest),
            1 => &highest * &x + &lowest,
            _ => &highest * x.power(degree) + middle * &x + &lowest,
        };
        (sum, lowest, highest)
    };
    let below = random.whole(1, 2) as i32;
    let above = random.whole(0, i64::from(below)) as i32;
    let (top, top_lowest, top_highest) = polynomial(random, above);
    let (bottom, bottom_lowest, bottom_highest) = polynomial(random, below);
    let (to, value) = match random.coin() {
        true => ("0", top_lowest / bottom_lowest),
        false if above == below => ("infinity", top_highest / bottom_highest),
        false => ("infinity", n(0)),
    };
    let (truth, value) = claimed(random, value, &u);
    limit("limits of quotients", truth, top / bottom, value, &x, to)
}

fn with_functions(random: &mut Random) -> Claim {
    let [x, u, v] = positives(random);
    let [y] = frees(random);
    let (side, value, to) = match random.below(16) {
        0 => (sqrt(x.power(2) + &u) - &x, n(0), "infinity"),
        1 => (exp(minus(&x)), n(0), "infinity"),
        2 => (&x * exp(minus(&x)), n(0), "infinity"),
        3 => (ln(n(1) + &x) / &x, n(1), "0"),
        4 => (&x * ln(&x), n(0), "0"),
        5 => ((exp(&x) - n(1)) / &x, n(1), "0"),
        6 => (sqrt(x.power(2) + &u * &x) - &x, &u / n(2), "infinity"),
        7 => (exp(minus(&u) / &x), n(0), "0"),
        8 => (sqrt(&u + &x), sqrt(&u), "0"),
        9 => (ln(&u + &x), ln(&u), "0"),
        10 => (sqrt((&u * &x + &v) / (&x + n(1))), sqrt(&u), "infinity"),
        11 => (exp(&u * &x / (&x + &v)), exp(&u), "infinity"),
        12 => (sqrt(&u * &x) / (&x + v), n(0), "infinity"),
        13 => (ln(&x) / &x, n(0), "infinity"),
        14 => (&y + &u / (n(1) + sqrt(&x)), &y + &u, "0"),
        _ => (&u / sqrt(&u + x.power(2)), sqrt(&u), "0"),
    };
    let (truth, value) = claimed(random, value, &u);
    limit("limits with functions", truth, side, value, &x, to)
}

/// An expression that grows without bound as x goes there, and whether it goes up.
fn unbounded(random: &mut Random, [x, u, v]: [&Term; 3]) -> (Term, &'static str, bool) {
    match random.below(10) {
        0 => (u * x + v, "infinity", true),
        1 => (u / x, "0", true),
        2 => (ln(x), "0", false),
        3 => (sqrt(x) * u, "infinity", true),
        4 => (exp(x), "infinity", true),
        5 => (x.power(2) / (x + u), "infinity", true),
        6 => ((x + u) / x.power(2), "0", true),
        7 => (exp(x) / x.power(2) * u, "infinity", true),
        8 => (ln(u + x) - v / x, "0", false),
        _ => (u - v * x, "infinity", false),
    }
}

/// What goes up, or down, without bound; or does not.
fn beyond_all_bounds(random: &mut Random) -> Claim {
    let [x, u, v] = positives(random);
    let (side, to, up) = unbounded(random, [&x, &u, &v]);
    let (side, grows) = if random.percent(20) { (&u / (n(1) + side.power(2)), false) } else { (side, true) };
    let (side, up) = if random.coin() { (minus(side), !up) } else { (side, up) };
    let says_up = random.coin();
    let statement = Statement::Unbounded { side, up: says_up, of: name_of(&x), to };
    Claim::new("limits beyond all bounds", Truth::of(grows && says_up == up), statement)
}

/// Expressions that grow without bound: no number is their limit.
fn without_limit(random: &mut Random) -> Claim {
    let [x, u, v] = positives(random);
    let (side, to, _) = unbounded(random, [&x, &u, &v]);
    let value = random.pick(&[n(0), n(1), u, v]).clone();
    limit("no limit", false, side, value, &x, to)
}
