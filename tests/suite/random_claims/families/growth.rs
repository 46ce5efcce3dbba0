//! Expressions that rise or fall with a variable because of how they are composed.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Claim, Statement, Truth};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Name, Term, exp, ln, minus, n, sqrt};

fn monotone(kind: &'static str, truth: bool, side: Term, rises: bool, with: Name) -> Claim {
    Claim::new(kind, Truth::of(truth), Statement::Monotone { side, rises, with })
}

pub fn claim(random: &mut Random) -> Claim {
    match random.below(10) {
        0..=4 => composed(random),
        5 => turning(random),
        6..=7 => of_either_sign(random),
        8 => under_conditions(random),
        _ => along_an_equation(random),
    }
}

/// An expression that is positive and rises with a positive variable.
fn rising(random: &mut Random, x: &Term, others: &[Term], depth: usize) -> Term {
    if depth == 0 {
        return x.clone();
    }
    let inner = rising(random, x, others, depth - 1);
    let u = if random.percent(25) { n(random.whole(1, 5)) } else { random.pick(others).clone() };
    match random.below(12) {
        0..=1 => inner + u,
        2..=3 => inner * u,
        4 => inner.power(random.whole(2, 3) as i32),
        5..=6 => &inner / (u + &inner),
        7 => inner + rising(random, x, others, 0) * u,
        8 => inner * rising(random, x, others, 0),
        9 => u - n(1) / (n(1) + &inner) + n(1),
        10 if random.coin() => sqrt(inner),
        10 => ln(n(1) + inner),
        _ if random.percent(40) => exp(inner),
        _ => inner / u,
    }
}

fn composed(random: &mut Random) -> Claim {
    let [x, u, v, w] = positives(random);
    let depth = random.below(3) + 1;
    let side = rising(random, &x, &[u.clone(), v, w], depth);
    let (rises, side) = match random.below(4) {
        0 => (false, minus(side)),
        1 => (false, u / side),
        2 => (false, u - side),
        _ => (true, side),
    };
    let truth = random.percent(60);
    monotone("composed growth", truth, side, rises == truth, name_of(&x))
}

/// Expressions that turn, or do not move.
fn turning(random: &mut Random) -> Claim {
    let [x, u, v] = positives(random);
    let c = n(random.whole(1, 5));
    let side = match random.below(7) {
        0 => (&x - &c).power(2),
        1 => &x + c / &x,
        2 => &x - x.power(2) * u,
        3 => &u * v,
        4 => &x * exp(minus(&x)),
        5 => &x / (x.power(2) + u),
        _ => (&x - u) * (&x - v),
    };
    monotone("turning points", false, side, random.coin(), name_of(&x))
}

/// Expressions of a variable that may be negative or zero.
fn of_either_sign(random: &mut Random) -> Claim {
    let [x, y] = frees(random);
    let [u] = positives(random);
    let (rises, falls, side) = match random.below(12) {
        0 => (true, false, x.power(3)),
        1 => (true, false, x.power(3) + &u * &x),
        2 => (true, false, &x * u),
        3 => (false, false, &x * y),
        4 => (false, false, x.power(2)),
        5 => (true, false, exp(&x)),
        6 => (false, false, &x / (n(1) + x.power(2))),
        7 => (false, false, x.call("abs")),
        8 => (true, false, &x + sqrt(n(1) + x.power(2))),
        9 => (false, true, y.power(2) - &x),
        10 => (false, false, x.power(3) - &u * &x),
        _ => (false, false, y.power(2) * &x),
    };
    let up = random.coin();
    monotone("growth of either sign", if up { rises } else { falls }, side, up, name_of(&x))
}

fn under_conditions(random: &mut Random) -> Claim {
    let kind = "growth under conditions";
    let [a, b, x] = positives(random);
    let [y] = frees(random);
    let c = n(random.whole(2, 5));
    let square = (&x - &c).power(2);
    let (with, moving) = (name_of(&x), name_of(&y));
    match random.below(9) {
        0 => monotone(kind, true, square, true, with).given(x, ">", c),
        1 => monotone(kind, true, square, true, with).given(x, ">=", c),
        2 => monotone(kind, false, square, true, with).given(x, ">", c - n(1)),
        3 => monotone(kind, true, square, false, with).given(x, "<", c),
        4 => monotone(kind, true, n(1) / (&a - &b), false, name_of(&a)).given(a, ">", b),
        // It falls on both sides of its pole, and rises across it.
        5 => monotone(kind, false, n(1) / (&y - &c), false, moving).given(y, "!=", c),
        6 => monotone(kind, true, (&b - &a) * &x, true, with).given(a, "<", b),
        7 => monotone(kind, false, (&b - &a) * &x, true, with).given(a, "<=", b),
        _ => monotone(kind, true, y.power(2), true, moving).given(y, ">", n(0)),
    }
}

/// A variable that moves because an equation ties it to the one that is changed.
fn along_an_equation(random: &mut Random) -> Claim {
    let kind = "growth along an equation";
    let [x, y, a] = positives(random);
    let (rises, left, right) = match random.below(5) {
        0 => (false, &x + &y, a),
        1 => (false, y.clone(), a - &x),
        2 => (true, y.clone(), a + &x),
        3 => (false, &x * &y, a),
        _ => (true, &y / &x, a),
    };
    let claimed = random.coin();
    let mut claim = monotone(kind, claimed == rises, y.clone(), claimed, name_of(&x)).given(left, "=", right);
    // Without the key it is not said which variable moves.
    if random.coin() {
        claim.truth = Truth::Meaningless;
        claim
    } else {
        claim.moves(name_of(&y))
    }
}
