//! Polynomials given by their factors, and the criteria of Routh and Hurwitz with known edges.

use crate::random::Random;
use crate::random_claims::claim::{Claim, Formula, compare};
use crate::random_claims::rewriting::{frees, positives};
use crate::random_claims::term::{Name, Term, exp, ln, minus, n, s, sqrt};

/// The largest degree of a polynomial of which a claim may speak, and of one with roots that may all be real.
const MOST_DEGREE: usize = 6;
const MOST_DEGREE_OF_REAL: usize = 3;

fn is(left: &Term, sign: &'static str, right: &Term) -> Formula {
    Formula::Compare(compare(left.clone(), sign, right.clone()))
}

/// What is true of all roots for all values of the variables, or exactly under a condition.
pub fn location(random: &mut Random) -> Claim {
    match random.below(10) {
        0..=3 => always(random),
        4..=7 => exactly(random),
        8 => under_conditions(random),
        _ => of_functions(random),
    }
}

/// A factor, its degree, whether its roots are always to the left, whether one is always to the right, and whether all are real.
struct Factor {
    term: Term,
    degree: usize,
    left: bool,
    right: bool,
    real: bool,
}

/// A factor with simple positive parameters.
fn factor(random: &mut Random, u: &Term, v: &Term) -> Factor {
    let of = |term, degree, left, right, real| Factor { term, degree, left, right, real };
    match random.below(8) {
        0..=2 => of(s() + u, 1, true, false, true),
        3 => of(s() - u, 1, false, true, true),
        // Real roots only for u² >= 4v, which does not hold for all values.
        4..=5 => of(s().power(2) + u * s() + v, 2, true, false, false),
        6 => of(s().power(2) + u, 2, false, false, false),
        _ => of(s().power(2) - u.power(2), 2, false, true, true),
    }
}

/// A leading factor that moves no root.
fn leading(random: &mut Random, polynomial: Term) -> Term {
    let [u] = positives(random);
    let [x] = frees(random);
    match random.below(7) {
        0 => polynomial * u,
        1 => minus(polynomial),
        2 => polynomial * (x.power(2) + n(1)),
        3 => polynomial * Term::Number(random.whole(1, 5), random.whole(2, 7)),
        _ => polynomial,
    }
}

/// A product of factors.
fn always(random: &mut Random) -> Claim {
    let names: [Term; 6] = positives(random);
    let mut found: Option<Factor> = None;
    for pair in names.chunks(2).take(random.below(3) + 1) {
        let next = factor(random, &pair[0], &pair[1]);
        found = Some(match found {
            None => next,
            Some(one) if one.degree + next.degree > MOST_DEGREE => one,
            Some(one) => Factor {
                term: one.term * next.term,
                degree: one.degree + next.degree,
                left: one.left && next.left,
                right: one.right || next.right,
                real: one.real && next.real,
            },
        });
    }
    let Some(Factor { term, degree, left, right, real }) = found else { return exactly(random) };
    let polynomial = leading(random, term);
    let words = [("stable", left), ("unstable", right), ("all_real", real)];
    let count = if degree > MOST_DEGREE_OF_REAL { 2 } else { 3 };
    let (word, truth) = *random.pick(&words[..count]);
    Claim::formula("roots of products", truth, Formula::Roots(word, polynomial))
}

/// A polynomial, and a condition that is true exactly where the statement on its roots is.
fn exactly(random: &mut Random) -> Claim {
    let [x, y] = frees(random);
    let [u, v, w, z] = positives(random);
    let zero = n(0);
    let positive = |one: &Term| is(one, ">", &zero);
    let negative = |one: &Term| is(one, "<", &zero);
    let damped = s().power(2) + &x * s() + &v;
    // The statement, the condition, and the condition at whose edge it is wrong.
    let (polynomial, word, right, wrong) = match random.below(20) {
        0 => (s() + &x, "stable", positive(&x), is(&x, ">=", &zero)),
        1 => (s() + &x, "unstable", negative(&x), is(&x, "<=", &zero)),
        2 => (damped, "stable", positive(&x), is(&x, ">=", &zero)),
        3 => (damped, "unstable", negative(&x), is(&x, "<=", &zero)),
        4 => (
            s().power(2) + &x * s() + &y,
            "stable",
            Formula::And(vec![positive(&x), positive(&y)]),
            Formula::Or(vec![positive(&x), positive(&y)]),
        ),
        5 => (
            s().power(2) + &x * s() + &y,
            "unstable",
            Formula::Or(vec![negative(&x), negative(&y)]),
            Formula::Or(vec![is(&x, "<=", &zero), negative(&y)]),
        ),
        6 => (
            s().power(2) + &u * s() + &v,
            "all_real",
            is(&u.power(2), ">=", &(n(4) * &v)),
            is(&u.power(2), ">", &(n(4) * &v)),
        ),
        7 => (
            s().power(3) + &u * s().power(2) + &v * s() + &w,
            "stable",
            is(&(&u * &v), ">", &w),
            is(&(&u * &v), ">=", &w),
        ),
        8 => (
            s().power(3) + &u * s().power(2) + &v * s() + &w,
            "unstable",
            is(&(&u * &v), "<", &w),
            is(&(&u * &v), "<=", &w),
        ),
        9 => ((s() + &u) * damped, "stable", positive(&x), is(&x, "!=", &zero)),
        10 => (
            (s() + &x) * (s() + &y),
            "stable",
            Formula::And(vec![positive(&x), positive(&y)]),
            positive(&(&x + &y)),
        ),
        11 => (
            s().power(2) + &x * s() + &y,
            "all_real",
            is(&x.power(2), ">=", &(n(4) * &y)),
            is(&y, "<=", &zero),
        ),
        12 => ((s().power(2) + &u * s() + &w) * damped, "stable", positive(&x), is(&x, ">=", &zero)),
        13 => ((s().power(2) + &u * s() + &w) * damped, "unstable", negative(&x), is(&x, "<=", &zero)),
        14 => ((s() + &u).power(3) * damped, "unstable", negative(&x), is(&x, "!=", &zero)),
        15 | 16 => {
            let quartic = s().power(4) + &u * s().power(3) + &v * s().power(2) + &w * s() + &z;
            let [right, left] = [&u * &v * &w, w.power(2) + u.power(2) * &z];
            match random.coin() {
                true => (quartic, "stable", is(&right, ">", &left), is(&right, ">=", &left)),
                false => (quartic, "unstable", is(&right, "<", &left), is(&right, "<=", &left)),
            }
        }
        17 => {
            let even = s().power(4) + &x * s().power(2) + &v;
            (even, "unstable", is(&x, "<", &(n(2) * sqrt(&v))), is(&x, "<=", &(n(2) * sqrt(&v))))
        }
        // The leading coefficient may vanish, and the root is then that of the rest.
        18 => (&x * s().power(2) + &u * s() + &v, "stable", is(&x, ">=", &zero), positive(&x)),
        _ => (s() - (&u - &v), "stable", is(&u, "<", &v), is(&u, "<=", &v)),
    };
    let roots = Formula::Roots(word, polynomial);
    let truth = random.percent(55);
    let condition = if truth { right } else { wrong };
    let formula = match random.below(4) {
        0 if truth => condition.implies(roots),
        1 if truth => roots.implies(condition),
        2 => roots.negated().iff(condition.negated()),
        _ => roots.iff(condition),
    };
    Claim::formula("roots by criteria", truth, formula)
}

/// Coefficients whose signs follow from a condition between two variables.
fn under_conditions(random: &mut Random) -> Claim {
    let kind = "roots under conditions";
    let [a, b, c] = positives(random);
    let [x] = frees(random);
    let shift = n(*random.pick(&[0, 1, 20_000]));
    let roots = |word, polynomial| Formula::Roots(word, polynomial);
    let gap = &b - &a;
    let oscillator = s().power(2) + &gap * s() + &c;
    let moved = s().power(2) + (&x + &shift) * s() + &gap;
    let below = |claim: Claim| claim.given(a.clone(), "<", b.clone());
    match random.below(8) {
        0 => below(Claim::formula(kind, true, roots("stable", oscillator))),
        1 => Claim::formula(kind, false, roots("stable", oscillator)).given(a, "<=", b),
        2 => below(Claim::formula(kind, false, roots("unstable", oscillator))),
        3 => below(Claim::formula(kind, false, roots("unstable", moved).negated())),
        4 => below(Claim::formula(kind, true, roots("stable", moved).iff(is(&(x + shift), ">", &n(0))))),
        5 => below(Claim::formula(kind, true, roots("all_real", s().power(2) - gap))),
        6 => Claim::formula(kind, true, roots("stable", oscillator)).given(a.power(2), "<", b.power(2)),
        _ => Claim::formula(kind, false, roots("stable", oscillator)).given(&a + &b, "=", c),
    }
}

/// Coefficients with roots, exponentials and logarithms of variables.
fn of_functions(random: &mut Random) -> Claim {
    let kind = "roots with functions";
    let [u, v, w] = positives(random);
    let c = random.whole(1, 4);
    let roots = |word, polynomial| Formula::Roots(word, polynomial);
    let frequency = sqrt(&u / &v);
    match random.below(10) {
        0 => Claim::formula(kind, true, roots("stable", s() + sqrt(u))),
        1 => Claim::formula(kind, true, roots("stable", s() + exp(u))),
        2 => Claim::formula(kind, true, roots("unstable", s() - exp(u))),
        3 => Claim::formula(
            kind,
            true,
            roots("stable", s().power(2) + n(2) * w * &frequency * s() + frequency.power(2)),
        ),
        4 => Claim::formula(kind, true, roots("unstable", s() + n(c) - sqrt(&u)).iff(is(&u, ">", &n(c * c)))),
        5 => {
            Claim::formula(kind, false, roots("unstable", s() + n(c) - sqrt(&u)).iff(is(&u, ">=", &n(c * c))))
        }
        6 => {
            let name = name_of(&u);
            Claim::formula(kind, true, roots("unstable", s() + n(c) - sqrt(&u))).there_is(name)
        }
        7 => Claim::formula(kind, true, roots("stable", s() + ln(&u)).iff(is(&u, ">", &n(1)))),
        8 => Claim::formula(kind, false, roots("stable", s() + ln(u))),
        _ => Claim::formula(kind, false, roots("all_real", s().power(2) + sqrt(u) * s() + v)),
    }
}

/// The name that an expression is.
pub fn name_of(term: &Term) -> Name {
    match term {
        Term::Name(name) => *name,
        other => panic!("{other:?} is no variable"),
    }
}

/// A pair of roots −(K − K_c)·u/2 ± i·…, alone or beside a third root.
pub fn crossing(random: &mut Random) -> Claim {
    let [k, u, v, w] = positives(random);
    let parameter = name_of(&k);
    let critical = match random.below(5) {
        0 => v.clone(),
        1 => &v * &w,
        2 => n(random.whole(1, 5)),
        3 => exp(&v),
        _ => &v / (&w + n(1)),
    };
    let (square, frequency) = match random.below(4) {
        0 => (w.power(2), w.clone()),
        1 => (w.clone(), sqrt(&w)),
        2 => (&w / &v, sqrt(&w / &v)),
        _ => (n(4), n(2)),
    };
    let away = &k - &critical;
    let pair = |damping: Term| s().power(2) + damping * s() + &square;
    let crosses = pair(&away * &u);
    let (truth, polynomial, critical, frequency) = match random.below(10) {
        0..=2 => (true, crosses, critical, frequency),
        3..=4 => (true, crosses * (s() + u), critical, frequency),
        5 => (true, pair(minus(away) * u), critical, frequency),
        6 => (false, crosses, critical, frequency * n(2)),
        7 => (false, crosses, critical * n(2), frequency),
        // It touches the axis, or another root is on the axis too.
        8 => (false, pair(away.power(2)), critical, frequency),
        _ => (false, crosses * s(), critical, frequency),
    };
    let crossing = Formula::Crossing { polynomial, parameter, critical, frequency };
    Claim::formula("crossings", truth, crossing)
}
