//! Variables between two numbers, or with one value.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::Claim;
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Term, exp, ln, n, sqrt};

pub fn claim(random: &mut Random) -> Claim {
    match random.below(3) {
        0 => parabola(random),
        1 => monotone(random),
        _ => values(random),
    }
}

fn is(truth: bool, left: Term, sign: &'static str, right: Term) -> Claim {
    Claim::compare("boxes and values", truth, left, sign, right)
}

/// (x − c)² + m between two whole numbers.
fn parabola(random: &mut Random) -> Claim {
    let [u] = positives(random);
    let [y] = frees(random);
    let x = if random.coin() { u } else { y };
    let (centre, least) = (random.whole(0, 6), random.whole(-3, 3));
    let low = random.whole(1, 4);
    let high = low + random.whole(1, 4);
    let value = |at: i64| (at - centre).pow(2) + least;
    let smallest = value(centre.clamp(low, high));
    let largest = value(low).max(value(high));
    let side = (&x - n(centre)).power(2) + n(least);
    let claim = match random.below(5) {
        0 => is(true, side, ">=", n(smallest)),
        1 => is(false, side, ">", n(smallest)),
        2 => is(true, side, "<=", n(largest)),
        3 => is(false, side, "<", n(largest)),
        _ => is(true, side, "<", n(largest + 1)),
    };
    claim.within(name_of(&x), [n(low), n(high)])
}

/// Functions whose extreme values are at corners.
fn monotone(random: &mut Random) -> Claim {
    let [x, y] = positives(random);
    let (of_x, of_y) = (name_of(&x), name_of(&y));
    let unit = |claim: Claim| claim.within(of_x, [n(1), n(2)]);
    match random.below(10) {
        0 => unit(is(true, exp(&x), "<", n(8))),
        1 => unit(is(false, exp(&x), "<", n(7))),
        2 => unit(is(true, ln(&x), "<", Term::Number(7, 10))),
        3 => unit(is(false, ln(&x), "<", Term::Number(1, 2))),
        4 => unit(is(true, sqrt(&x), "<=", Term::Number(3, 2))),
        5 => unit(is(true, &x * &y, "<=", n(6))).within(of_y, [n(1), n(3)]),
        6 => unit(is(false, &x * &y, "<", n(6))).within(of_y, [n(1), n(3)]),
        7 => unit(is(true, &x / &y, ">=", Term::Number(1, 3))).within(of_y, [n(1), n(3)]),
        8 => unit(is(false, &x / &y, ">", Term::Number(1, 3))).within(of_y, [n(1), n(3)]),
        _ => unit(is(true, ln(n(1) + &x), "<", x)),
    }
}

/// One value of each variable.
fn values(random: &mut Random) -> Claim {
    let [x, y] = positives(random);
    let (above, below) = (random.whole(1, 9), random.whole(1, 9));
    let at = |claim: Claim| claim.at(name_of(&x), Term::Number(above, below));
    let whole = n(random.whole(1, 9));
    match random.below(6) {
        0 => at(is(true, n(below) * &x, "=", n(above))),
        1 => at(is(false, n(below) * &x, "=", n(above + 1))),
        2 => at(is(above > below, x.clone(), ">", n(1))),
        3 => at(is(true, sqrt(x.power(2)), "=", Term::Number(above, below))),
        4 => at(is(true, ln(&x), "<", x.clone())),
        _ => at(is(true, &x * &y, "=", Term::Number(above, below) * &whole)).at(name_of(&y), whole),
    }
}
