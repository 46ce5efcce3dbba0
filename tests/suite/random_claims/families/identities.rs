//! Two forms of one expression, and what differs from it by a known amount.

use crate::random::Random;
use crate::random_claims::claim::Claim;
use crate::random_claims::rewriting::{all_names, frees, positive, positives, total};
use crate::random_claims::term::{Term, exp, ln, minus, n, sqrt};

pub fn claim(random: &mut Random) -> Claim {
    let (kind, left, right) = if random.percent(65) { rational(random) } else { with_functions(random) };
    let names: Vec<_> = left.names().into_iter().collect();
    let names = if names.is_empty() { all_names() } else { names };
    let more = positive(random, 1, &names);
    let [free] = frees(random);
    let moving = &free - n(random.whole(-3, 3));
    let (truth, sign, right) = match random.below(12) {
        0..=3 => (true, "=", right),
        4 => (true, "!=", right + more),
        5 => (true, "<", right + more),
        6 => (true, ">=", right - more),
        7 => (false, "=", right + more),
        8 => (false, "=", right + moving),
        9 => (false, "!=", right + moving),
        10 => (false, *random.pick(&["<", ">", "!="]), right),
        _ => (false, *random.pick(&[">", ">=", "="]), right + more),
    };
    Claim::compare(kind, truth, left, sign, right)
}

/// Laws for sums, products and quotients.
fn rational(random: &mut Random) -> (&'static str, Term, Term) {
    let names = all_names();
    let [a, b] = [total(random, 1, &names), total(random, 1, &names)];
    let [u, v] = [positive(random, 1, &names), positive(random, 1, &names)];
    let [x, y] = positives(random);
    let (left, right) = match random.below(10) {
        0 => ((&a + &b).power(2), a.power(2) + n(2) * &a * &b + b.power(2)),
        1 => ((&a - &b) * (&a + &b), a.power(2) - b.power(2)),
        2 => (n(1) / &u + n(1) / &v, (&u + &v) / (&u * &v)),
        3 => (n(1) / (&u * (&u + &v)), (n(1) / &u - n(1) / (&u + &v)) / v),
        4 => (a.power(3) - b.power(3), (&a - &b) * (a.power(2) + &a * &b + b.power(2))),
        5 => (u.power(-2), n(1) / u.power(2)),
        6 => (&a / &u + &b / &v, (&a * &v + &b * &u) / (u * v)),
        7 => ((&x + &y).power(3), x.power(3) + n(3) * x.power(2) * &y + n(3) * &x * y.power(2) + y.power(3)),
        8 => (&a * (&b + &u), &a * b + a * u),
        _ => (&x / &y, n(1) / (&y / &x)),
    };
    ("identity", left, right)
}

/// Laws of roots, logarithms, exponentials and absolute values.
fn with_functions(random: &mut Random) -> (&'static str, Term, Term) {
    let names = all_names();
    let [a, b] = frees(random);
    let a = a * n(random.whole(1, 3)) + b;
    let b = total(random, 0, &names);
    let [u, v] = [positive(random, 1, &names), positive(random, 1, &names)];
    let (left, right) = match random.below(14) {
        0 => (sqrt(u.power(2) * &v), u * sqrt(v)),
        1 => (ln(&u * &v), ln(u) + ln(v)),
        2 => (ln(u.power(3)), n(3) * ln(u)),
        3 => (exp(&a + &b), exp(a) * exp(b)),
        4 => (exp(ln(&u)), u),
        5 => (ln(exp(&a)), a),
        6 => (sqrt(&u) * sqrt(&v), sqrt(u * v)),
        7 => ((sqrt(&u) + sqrt(&v)) * (sqrt(&u) - sqrt(&v)), u - v),
        8 => (minus(&u).call("abs"), u),
        9 => (sqrt(a.power(2)), a.call("abs")),
        10 => (exp(minus(&a)), n(1) / exp(a)),
        11 => (ln(&u / &v), ln(u) - ln(v)),
        12 => (sqrt(&u).power(2), u),
        _ => (ln(n(6)), ln(n(2)) + ln(n(3))),
    };
    ("identity with functions", left, right)
}
