//! Claims for every smooth function of which nothing else is known. A false one names no function: there is one that makes it false.

use super::roots::name_of;
use crate::random::Random;
use crate::random_claims::claim::{Argument, Claim, Definition, Formula, Statement, Truth, compare};
use crate::random_claims::rewriting::{all_names, frees, positive, positives, total};
use crate::random_claims::term::{Name, Term, ln, minus, n, s, sqrt, unknown};

const KIND: &str = "functions";

pub fn claim(random: &mut Random) -> Claim {
    match random.below(12) {
        0..=2 => same_argument(random),
        3..=4 => signs(random),
        5 => at_another_argument(random),
        6..=7 => derivatives(random),
        8 => stability(random),
        9 => moving(random),
        10 => existence(random),
        _ => meaningless(random),
    }
}

/// A derivative of the function, of low order more often.
fn derivative(random: &mut Random, argument: &Term) -> Term {
    let order = random.below(4).min(random.below(4));
    unknown(order, argument)
}

/// Values at equal arguments are equal, those at different ones are not for every function.
fn same_argument(random: &mut Random) -> Claim {
    let argument = total(random, 2, &all_names());
    let here = derivative(random, &argument);
    let order = here.primes();
    let (truth, there) = match random.below(5) {
        0 => (true, unknown(order, &(n(2) * &argument / n(2)))),
        1 => (true, unknown(order, &((&argument + n(1)) - n(1)))),
        2 => (false, unknown(order + 1, &argument)),
        3 => (false, unknown(order, &(&argument + positive(random, 1, &all_names())))),
        _ => (false, unknown(order, &argument) - positive(random, 1, &all_names())),
    };
    let sign = if truth { *random.pick(&["=", "<=", ">="]) } else { "=" };
    let [x] = frees(random);
    match random.below(4) {
        // At equal values of two variables.
        0 => {
            let (left, right) = (unknown(order, &x), unknown(order, &Term::Name(Name::Free(3))));
            let equal = random.coin() && x != Term::Name(Name::Free(3));
            let claim = Claim::compare(KIND, equal || left == right, left, "=", right);
            if equal { claim.given(x, "=", Term::Name(Name::Free(3))) } else { claim }
        }
        1 => {
            let both = [compare(here.clone(), ">", n(0)), compare(there, "<", n(0))].map(Formula::Compare);
            // Where the values are equal it cannot be both; where they differ, some function is both.
            Claim::formula(KIND, truth, Formula::And(both.to_vec()).negated())
        }
        _ => Claim::compare(KIND, truth, here, sign, there),
    }
}

fn signs(random: &mut Random) -> Claim {
    let argument = total(random, 1, &all_names());
    let here = derivative(random, &argument);
    let more = positive(random, 1, &all_names());
    match random.below(8) {
        0 => Claim::compare(KIND, true, here.power(2) + more, ">", n(0)),
        1 => Claim::compare(KIND, true, here.power(2), ">=", n(0)),
        2 => Claim::compare(KIND, false, here.power(2), ">", n(0)),
        3 => Claim::compare(KIND, false, here + more, ">", n(0)),
        4 => Claim::compare(KIND, true, &more * &here, ">", minus(&more)).given(here, ">", n(0)),
        5 => Claim::compare(KIND, true, sqrt(here.power(2)).power(2), "=", here.power(2)),
        6 => Claim::compare(KIND, true, ln(n(1) + here.power(2)), ">=", n(0)),
        _ => Claim::compare(KIND, false, here.clone(), ">", n(0)).given(here, ">=", n(0)),
    }
}

/// What is known at one argument says nothing of another one, of another derivative and of another order.
fn at_another_argument(random: &mut Random) -> Claim {
    let argument = total(random, 1, &all_names());
    let known = unknown(1, &argument);
    let wanted = match random.below(4) {
        0 => unknown(1, &(&argument + positive(random, 1, &all_names()))),
        1 => unknown(1, &(&argument - positive(random, 1, &all_names()))),
        2 => unknown(0, &argument),
        _ => unknown(2, &argument),
    };
    let sign = *random.pick(&[">", "<", "!="]);
    Claim::compare(KIND, false, wanted, sign, n(0)).given(known, sign, n(0))
}

/// The rules of differentiation.
fn derivatives(random: &mut Random) -> Claim {
    let ([u, v], [x]) = (positives(random), frees(random));
    let inner = &u * &x + &v;
    let order = random.below(3);
    let (of, value) = match random.below(5) {
        0 => (unknown(order, &inner), &u * unknown(order + 1, &inner)),
        1 => (&x * unknown(order, &x), unknown(order, &x) + &x * unknown(order + 1, &x)),
        2 => (unknown(order, &x).power(2), n(2) * unknown(order, &x) * unknown(order + 1, &x)),
        3 => (unknown(0, &unknown(order, &x)), unknown(1, &unknown(order, &x)) * unknown(order + 1, &x)),
        _ => (unknown(order, &x.power(2)) / &u, n(2) * &x * unknown(order + 1, &x.power(2)) / &u),
    };
    let truth = random.percent(60);
    let value = match random.below(2) {
        _ if truth => value,
        0 => value + v,
        _ => n(2) * value + v,
    };
    let mut claim = Claim::compare(KIND, truth, Term::Name(Name::Defined(0)), "=", value);
    claim.define(Definition::Derivation("derivative", vec![Argument::Term(of), Argument::Term(x)]));
    claim
}

/// A slider with mass whose friction is any function of velocity.
fn stability(random: &mut Random) -> Claim {
    let [stiffness, mass, velocity, more] = positives(random);
    let slope = unknown(1, &velocity);
    let polynomial = s().power(2) + &slope / &mass * s() + &stiffness / &mass;
    let of = |word: &'static str| Formula::Roots(word, polynomial.clone());
    let is_positive = || Formula::Compare(compare(slope.clone(), ">", n(0)));
    match random.below(7) {
        0..=1 => Claim::formula(KIND, true, of("stable").iff(is_positive())),
        2 => Claim::formula(KIND, true, of("unstable")).given(slope, "<", n(0)),
        3 => Claim::formula(KIND, false, of("stable")),
        4 => Claim::formula(KIND, false, of("stable")).given(slope, ">=", n(0)),
        5 => Claim::formula(KIND, false, of("stable")).given(unknown(1, &(&velocity + &more)), ">", n(0)),
        _ => Claim::formula(KIND, true, is_positive().implies(of("stable"))),
    }
}

/// Limits, slopes and dependences: what not every function does is false.
fn moving(random: &mut Random) -> Claim {
    let ([x, u], [y]) = (positives(random), frees(random));
    let at = |argument: &Term| unknown(0, argument);
    let claim = |truth: bool, statement: Statement| Claim::new(KIND, Truth::of(truth), statement);
    let limit =
        |side: Term, value: Term, to: &'static str| Statement::Limit { side, value, of: name_of(&x), to };
    let rises = |side: Term| Statement::Monotone { side, rises: true, with: name_of(&x) };
    let depends = |side: Term, depends: bool| Statement::Depends { side, depends, on: name_of(&x) };
    let quotient = || (at(&x) - at(&n(0))) / &x;
    match random.below(13) {
        0 => claim(true, limit(at(&(&x + &y)), at(&y), "0")),
        1 => claim(true, limit(quotient(), unknown(1, &n(0)), "0")),
        2 => claim(false, limit(quotient(), unknown(1, &n(0)) + u, "0")),
        3 => claim(false, limit(at(&x), n(0), "infinity")),
        4 => claim(false, limit(at(&x) / (n(1) + at(&x).power(2)), n(0), "infinity")),
        5 => claim(false, rises(at(&x) + &u * &x)),
        6 => claim(true, rises(&u * &x + at(&y))),
        7 => claim(true, rises(&x * unknown(1, &y))).given(unknown(1, &y), ">", n(0)),
        8 => claim(false, rises(at(&x))).given(unknown(1, &x), ">", n(0)),
        9 => claim(false, depends(at(&x), true)),
        10 => claim(false, depends(at(&x) * &u, false)),
        11 => claim(true, depends(at(&y) + u, false)),
        _ => claim(true, depends(&x + at(&u), true)),
    }
}

/// For every function there is a value.
fn existence(random: &mut Random) -> Claim {
    let [x, y] = frees(random);
    let at = |argument: &Term| unknown(0, argument);
    let shift =
        positive(random, 1, &all_names().into_iter().filter(|name| *name != name_of(&x)).collect::<Vec<_>>());
    let claim = match random.below(5) {
        0 => Claim::compare(KIND, true, at(&x), "=", at(&y)).witness(name_of(&x), y),
        1 => Claim::compare(KIND, true, &x - &shift, "=", at(&y)).witness(name_of(&x), at(&y) + shift),
        2 => Claim::compare(KIND, true, x.clone(), ">", at(&y)).witness(name_of(&x), at(&y) + shift),
        3 => Claim::compare(KIND, false, at(&x), "=", shift),
        _ => Claim::compare(KIND, false, at(&x).power(2) + shift, "=", n(0)),
    };
    claim.there_is(name_of(&x))
}

/// A side without a value for some function.
fn meaningless(random: &mut Random) -> Claim {
    let [x] = frees(random);
    let here = derivative(random, &x);
    let side = match random.below(4) {
        0 => sqrt(&here),
        1 => ln(&here),
        2 => n(1) / &here,
        _ => unknown(0, &(n(1) / &x)),
    };
    let statement = Formula::Compare(compare(side.clone(), "=", side * n(1)));
    Claim::new(KIND, Truth::Meaningless, Statement::Formula(statement))
}
