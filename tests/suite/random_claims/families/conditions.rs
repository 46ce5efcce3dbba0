//! What follows from conditions, and what does not.

use crate::random::Random;
use crate::random_claims::claim::{Claim, Formula, compare};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Term, exp, ln, n, sqrt};

pub fn claim(random: &mut Random) -> Claim {
    match random.below(3) {
        0 => ordered(random),
        1 => along_equations(random),
        _ => nonlinear(random),
    }
}

fn is(truth: bool, left: Term, sign: &'static str, right: Term) -> Claim {
    Claim::compare("conditions", truth, left, sign, right)
}

/// Two or three variables in order.
fn ordered(random: &mut Random) -> Claim {
    let [a, b, c] = positives(random);
    let [x, y] = frees(random);
    let zero = n(0);
    let below = |claim: Claim| claim.given(a.clone(), "<", b.clone());
    match random.below(20) {
        0 => below(is(true, b.power(2), ">", a.power(2))),
        1 => below(is(true, n(1) / &a, ">", n(1) / &b)),
        2 => below(is(false, a.clone(), ">=", b.clone())),
        3 => below(is(false, b.clone(), ">", n(2) * &a)),
        4 => below(is(true, sqrt(&b), ">", sqrt(&a))),
        5 => below(is(true, &a * &c, "<", &b * &c)),
        6 => below(is(false, &a * &x, "<", &b * x)),
        7 => below(is(true, a.clone(), "<", c.clone())).given(b.clone(), "<", c),
        8 => below(is(false, b.clone(), ">", (&a + &c) / n(2))).given(b.clone(), "<", c),
        9 => is(true, a.clone(), "=", b.clone()).given(a.clone(), "<=", b.clone()).given(a, ">=", b),
        10 => is(false, a.clone(), "<", b.clone()).given(a, "<=", b),
        11 => is(true, (&a - &b).power(2), ">", zero).given(a, "!=", b),
        12 => below(is(true, exp(&a), "<", exp(&b))),
        13 => below(is(true, ln(&a), "<", ln(&b))),
        14 => below(is(true, &a / (n(1) + &a), "<", &b / (n(1) + &b))),
        15 => below(is(false, (&b - &a) * &c, ">", n(1))),
        16 => is(true, x.power(3), "<", y.power(3)).given(x, "<", y),
        17 => is(false, x.power(2), "<", y.power(2)).given(x, "<", y),
        18 => is(true, n(1) / (&a - &b), ">", zero).given(a, ">", b),
        _ => is(false, x.clone(), ">", zero).given(x, ">", n(-1) * a),
    }
}

/// Equations among the conditions.
fn along_equations(random: &mut Random) -> Claim {
    let [a, b, c] = positives(random);
    let [x, y] = frees(random);
    let one = |claim: Claim| claim.given(&a + &b, "=", n(1));
    match random.below(12) {
        0 => one(is(true, a.clone(), "<", n(1))),
        1 => one(is(true, &a * &b, "<=", Term::Number(1, 4))),
        2 => one(is(false, &a * &b, "<", Term::Number(1, 4))),
        3 => one(is(false, a.clone(), ">", b.clone())),
        4 => is(true, &c / &a, "=", b.clone()).given(&a * &b, "=", c),
        5 => is(false, a.clone(), "=", c.clone()).given(&a * &b, "=", c),
        6 => is(true, a.clone(), "=", b.clone()).given(n(2) * &a, "=", n(2) * b),
        7 => is(true, &x * &y, "=", n(0)).given(x, "=", n(0)),
        8 => is(true, sqrt(&a), "=", b.clone()).given(a, "=", b.power(2)),
        9 => is(true, &a / &b, "=", c.clone()).given(a, "=", &b * c),
        10 => is(false, x.clone(), "=", y.clone()).given(&x + &y, "=", n(0)),
        _ => is(true, x.power(2), "=", y.power(2)).given(&x + &y, "=", n(0)),
    }
}

/// Products and squares among the conditions.
fn nonlinear(random: &mut Random) -> Claim {
    let [a, b] = positives(random);
    let [x] = frees(random);
    let c = random.whole(1, 4);
    let (number, zero) = (n(c), n(0));
    let holds =
        |left: &Term, sign, right: &Term| Formula::Compare(compare(left.clone(), sign, right.clone()));
    let product = |claim: Claim| claim.given(&a * &b, ">", n(1));
    let small = |claim: Claim| claim.given(x.power(2), "<", n(c * c));
    match random.below(11) {
        0 => product(is(true, a.power(2) * b.power(2), ">", n(1))),
        1 => product(is(false, a.clone(), ">", n(1))),
        2 => product(is(true, &a + &b, ">=", n(2))),
        3 => small(is(true, x.clone(), "<", number)),
        4 => small(is(false, x.clone(), "<", number - Term::Number(1, 3))),
        5 => is(false, x.clone(), ">=", number).given(x.power(2), ">=", n(c * c)),
        6 => is(true, a.clone(), ">=", number).given(a.power(2), ">=", n(c * c)),
        7 => is(false, x.power(2), ">", n(c * c)).given(x, ">", n(-c)),
        8 => {
            let either = Formula::Or(vec![holds(&x, ">", &zero), holds(&x, "<", &zero)]);
            Claim::formula("conditions", true, either).given(x.power(2), ">", zero)
        }
        9 => is(true, &a + &b, ">", a.clone()).given(sqrt(&a), ">", n(2)),
        _ => is(true, a.clone(), ">", n(c * c)).given(sqrt(a), ">", number),
    }
}
