//! Expressions with a known infimum, which is a value of theirs or is not.

use crate::random::Random;
use crate::random_claims::claim::Claim;
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Term, exp, ln, n, sqrt};

/// An expression, its infimum, and whether it has this value somewhere.
struct Bounded {
    kind: &'static str,
    side: Term,
    infimum: Term,
    attained: bool,
}

pub fn claim(random: &mut Random) -> Claim {
    let Bounded { kind, side, infimum, attained } = match random.below(10) {
        0..=3 => squares(random),
        4..=6 => means(random),
        7 => open(random),
        _ => with_functions(random),
    };
    let small = Term::Number(1, *random.pick(&[1, 3, 10, 1000, 1_000_000]));
    let (truth, sign, right) = match random.below(10) {
        0..=2 => (true, ">=", infimum),
        3..=5 => (!attained, ">", infimum),
        6 => (true, ">", infimum - small),
        7 => (false, ">=", infimum + small),
        8 => (!attained, "!=", infimum),
        _ => (false, *random.pick(&["<", "<=", "="]), infimum),
    };
    Claim::compare(kind, truth, side, sign, right)
}

fn bounded(kind: &'static str, side: Term, infimum: Term, attained: bool) -> Bounded {
    Bounded { kind, side, infimum, attained }
}

/// Sums of squares.
fn squares(random: &mut Random) -> Bounded {
    let [x, y, z] = frees(random);
    let [u, v] = positives(random);
    let mut number = || n(random.whole(-4, 5));
    let (c, d, least) = (number(), number(), number());
    let positive = n(random.whole(1, 5));
    let kind = "squares";
    match random.below(10) {
        0 => bounded(kind, (&x - &c).power(2) + &least, least, true),
        1 => bounded(kind, (&x - &c).power(2) + (&y - &d).power(2) * &u + &least, least, true),
        2 => bounded(kind, (&u - &positive).power(2) + &least, least, true),
        3 => bounded(kind, (&x - &y).power(2) + z.power(2), n(0), true),
        4 => bounded(kind, x.power(2) + &x * &y + y.power(2), n(0), true),
        5 => bounded(kind, x.power(4) - n(2) * x.power(2), n(-1), true),
        // Zero at the root of 2 only, which is no quotient.
        6 => bounded(kind, (x.power(2) - n(2)).power(2), n(0), true),
        7 => bounded(kind, (&x * &u - &c).power(2) + &least, least, true),
        8 => bounded(kind, x.power(2) + (&u - &v).power(2) + &positive, positive, true),
        // Positive squares: the expression comes near zero and does not reach it.
        _ => bounded(kind, x.power(2) + u.power(2), n(0), false),
    }
}

/// Means and their like, for positive variables.
fn means(random: &mut Random) -> Bounded {
    let [u, v, w] = positives(random);
    let c = random.whole(1, 4);
    let kind = "means";
    match random.below(8) {
        0 => bounded(kind, &u + n(c * c) / &u, n(2 * c), true),
        1 => bounded(kind, &u / &v + &v / &u, n(2), true),
        2 => bounded(kind, (&u + &v) * (n(1) / &u + n(1) / &v), n(4), true),
        3 => bounded(kind, &u + &v - n(2) * sqrt(&u * &v), n(0), true),
        4 => bounded(kind, &u - n(2 * c) * sqrt(&u), n(-c * c), true),
        5 => bounded(kind, &u * &v + n(c * c) / (&u * &v), n(2 * c), true),
        6 => bounded(kind, &u / &v + &v / &w + &w / &u, n(3), true),
        _ => bounded(kind, u.power(2) + v.power(2) - n(2) * &u * &v, n(0), true),
    }
}

/// Sums of positive products, and quotients, which do not reach their infimum.
fn open(random: &mut Random) -> Bounded {
    let [u, v, w] = positives(random);
    let [x] = frees(random);
    let c = n(random.whole(1, 5));
    let kind = "positive sums";
    match random.below(7) {
        0 => bounded(kind, &u * &v + w * &c, n(0), false),
        1 => bounded(kind, u.power(2) / &v + &c * &v, n(0), false),
        2 => bounded(kind, &c / (n(1) + u), n(0), false),
        3 => bounded(kind, &u + &c, c, false),
        4 => bounded(kind, n(1) / (x.power(2) + &c), n(0), false),
        5 => bounded(kind, n(-1) * (&u / (&u + &v)), n(-1), false),
        _ => bounded(kind, n(-2) * &x / (x.power(2) + n(1)), n(-1), true),
    }
}

fn with_functions(random: &mut Random) -> Bounded {
    let [u, v] = positives(random);
    let [x] = frees(random);
    let kind = "signs with functions";
    match random.below(9) {
        0 => bounded(kind, exp(&x) - &x, n(1), true),
        1 => bounded(kind, exp(&u) - &u, n(1), false),
        2 => bounded(kind, &u - ln(&u), n(1), true),
        3 => bounded(kind, &u - ln(n(1) + &u), n(0), false),
        4 => bounded(kind, sqrt(n(1) + x.power(2)), n(1), true),
        5 => bounded(kind, sqrt(n(1) + x.power(2)) - &x, n(0), false),
        6 => bounded(kind, exp(&x) + exp(n(-1) * &x), n(2), true),
        7 => bounded(kind, x.call("abs") + &u, n(0), false),
        _ => bounded(kind, sqrt(&u) + sqrt(&v) - sqrt(u + v), n(0), false),
    }
}
