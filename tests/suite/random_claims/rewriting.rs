//! Other ways to write an expression, with the same value wherever the expression has one.

use super::term::{Name, Term, exp, f, ln, minus, n, p, sqrt, unknown};
use super::world::{FREE, POSITIVE};
use crate::random::Random;

/// An expression that has a value for all values of its variables, of small size.
pub fn total(random: &mut Random, depth: usize, names: &[Name]) -> Term {
    if depth == 0 || random.percent(15) {
        return match random.below(4) {
            0 => n(random.whole(-4, 6)),
            _ => variable(random, names),
        };
    }
    let deeper = |random: &mut Random| total(random, depth - 1, names);
    match random.below(9) {
        0..=2 => deeper(random) + deeper(random),
        3 => deeper(random) - deeper(random),
        4..=5 => deeper(random) * deeper(random),
        6 => deeper(random).power(2),
        7 => deeper(random) / positive(random, depth - 1, names),
        _ if random.percent(30) => functions_of(random, depth - 1, names),
        _ => deeper(random) * n(random.whole(2, 5)),
    }
}

fn functions_of(random: &mut Random, depth: usize, names: &[Name]) -> Term {
    match random.below(7) {
        6 => unknown(random.below(3), &total(random, depth.min(1), names)),
        4 => total(random, depth.min(1), names).call("sin"),
        5 => total(random, depth.min(1), names).call("cos"),
        0 => sqrt(positive(random, depth, names)),
        1 => ln(positive(random, depth, names)),
        2 => exp(total(random, depth.min(1), names)),
        _ => total(random, depth, names).call("abs"),
    }
}

/// An expression that is positive for all values of its variables.
pub fn positive(random: &mut Random, depth: usize, names: &[Name]) -> Term {
    let own: Vec<Name> = names.iter().copied().filter(|name| matches!(name, Name::Positive(_))).collect();
    if depth == 0 || random.percent(20) {
        return match random.below(3) {
            0 => n(random.whole(1, 5)),
            _ if own.is_empty() => n(random.whole(1, 3)) + variable(random, names).power(2),
            _ => variable(random, &own),
        };
    }
    let deeper = |random: &mut Random| positive(random, depth - 1, names);
    match random.below(8) {
        0..=1 => deeper(random) + deeper(random),
        2..=3 => deeper(random) * deeper(random),
        4 => deeper(random) / deeper(random),
        5 => deeper(random).power(2),
        6 => n(random.whole(1, 3)) + variable(random, names).power(2),
        _ if random.percent(40) => sqrt(deeper(random)),
        _ => deeper(random) + n(random.whole(1, 4)),
    }
}

/// One of these names, or a number where there is none.
pub fn variable(random: &mut Random, names: &[Name]) -> Term {
    if names.is_empty() { n(random.whole(1, 5)) } else { Term::Name(*random.pick(names)) }
}

/// All variables of a folder.
pub fn all_names() -> Vec<Name> {
    (0..POSITIVE).map(Name::Positive).chain((0..FREE).map(Name::Free)).collect()
}

/// A random part of the expression written differently; what is brought in contains these names only.
pub fn rewrite(term: &mut Term, names: &[Name], random: &mut Random) {
    let place = random.below(term.size());
    let Some(node) = term.node_mut(place) else { return };
    *node = other_form(node, names, random);
}

/// The same value in another form.
fn other_form(one: &Term, names: &[Name], random: &mut Random) -> Term {
    if let Some(form) = structural(one, random) {
        return form;
    }
    let unit = positive(random, 1, names);
    // A polynomial stays a polynomial in its variable, whose values are complex.
    let is_polynomial = one.contains(Name::Root);
    match random.below(15) {
        14 if !is_polynomial => {
            let angle = total(random, 1, names);
            one * (angle.call("sin").power(2) + angle.call("cos").power(2))
        }
        0 => {
            let more = total(random, 1, names);
            if random.coin() { one + &more - more } else { more.clone() + one - more }
        }
        1 => one * &unit / unit,
        2 => one / &unit * unit,
        3 => n(2) * one - one,
        4 => minus(minus(one)),
        5 => {
            let other = positive(random, 1, names);
            (one * &unit + one * &other) / (unit + other)
        }
        6 => {
            let count = random.whole(2, 7);
            (n(count) * one + one) / n(count + 1)
        }
        7 => one + n(0),
        _ if is_polynomial => one + total(random, 1, names) * n(0),
        8 => ln(exp(one)),
        9 if one.is_positive() => exp(ln(one)),
        10 if one.is_positive() => sqrt(one).power(2),
        11 if one.is_not_negative() => sqrt(one.power(2)),
        12 if one.is_positive() => one.power(3) / one.power(2),
        13 if one.is_positive() => one.call("abs"),
        _ => one + total(random, 1, names) * n(0),
    }
}

/// A form by a law of arithmetic that applies to the expression as it is built.
fn structural(one: &Term, random: &mut Random) -> Option<Term> {
    if random.percent(35) {
        return None;
    }
    match one {
        Term::Sum(parts) => {
            let mut parts = parts.clone();
            random.shuffle(&mut parts);
            Some(Term::Sum(parts))
        }
        Term::Product(parts) => {
            let sum = parts.iter().position(|part| matches!(part, Term::Sum(_)));
            let Some(Term::Sum(summands)) = sum.map(|at| &parts[at]) else {
                let mut parts = parts.clone();
                random.shuffle(&mut parts);
                return Some(Term::Product(parts));
            };
            let mut rest = parts.clone();
            rest.remove(sum?);
            let distributed =
                |summand: &Term| Term::Product(rest.iter().cloned().chain([summand.clone()]).collect());
            Some(Term::Sum(summands.iter().map(distributed).collect()))
        }
        Term::Quotient(both) => {
            let [above, below] = &**both;
            match above {
                Term::Sum(parts) => Some(Term::Sum(parts.iter().map(|part| part / below).collect())),
                _ => Some(above * below.power(-1)),
            }
        }
        Term::Power(inner, 2) => match &**inner {
            Term::Sum(parts) if parts.len() == 2 => {
                let [a, b] = [&parts[0], &parts[1]];
                Some(a.power(2) + n(2) * a * b + b.power(2))
            }
            inner => Some(inner * inner),
        },
        Term::Power(inner, exponent) if *exponent > 2 => Some(&**inner * inner.power(exponent - 1)),
        Term::Call("sqrt", inner) => match &**inner {
            Term::Product(parts) if parts.iter().all(Term::is_positive) => {
                Some(Term::Product(parts.iter().map(sqrt).collect()))
            }
            _ => None,
        },
        Term::Call("ln", inner) => match &**inner {
            Term::Product(parts) if parts.iter().all(Term::is_positive) => {
                Some(Term::Sum(parts.iter().map(ln).collect()))
            }
            Term::Quotient(both) if both.iter().all(Term::is_positive) => Some(ln(&both[0]) - ln(&both[1])),
            _ => None,
        },
        Term::Call("exp", inner) => match &**inner {
            Term::Sum(parts) => Some(Term::Product(parts.iter().map(exp).collect())),
            _ => None,
        },
        _ => None,
    }
}

/// Some different positive variables.
pub fn positives<const COUNT: usize>(random: &mut Random) -> [Term; COUNT] {
    let mut order: Vec<usize> = (0..POSITIVE).collect();
    random.shuffle(&mut order);
    std::array::from_fn(|at| p(order[at]))
}

/// Some different variables of either sign.
pub fn frees<const COUNT: usize>(random: &mut Random) -> [Term; COUNT] {
    let mut order: Vec<usize> = (0..FREE).collect();
    random.shuffle(&mut order);
    std::array::from_fn(|at| f(order[at]))
}
