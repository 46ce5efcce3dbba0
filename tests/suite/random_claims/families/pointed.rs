//! Random expressions whose values at a random point are known, so that one point decides.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use crate::random::Random;
use crate::random_claims::claim::{Claim, Comparison, Formula, Statement, Truth, compare};
use crate::random_claims::rewriting::{all_names, positive, total};
use crate::random_claims::term::{Name, Term, n, s};

/// Values of the variables.
type Point = BTreeMap<Name, Fraction>;

/// A quotient of two whole numbers, the second one positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Fraction(i64, i64);

impl Fraction {
    fn of(above: i128, below: i128) -> Option<Self> {
        fn divisor(one: i128, other: i128) -> i128 {
            if other == 0 { one.abs() } else { divisor(other, one % other) }
        }
        let common = divisor(above, below) * below.signum();
        Some(Self(i64::try_from(above.checked_div(common)?).ok()?, i64::try_from(below / common).ok()?))
    }

    fn parts(self) -> [i128; 2] {
        [i128::from(self.0), i128::from(self.1)]
    }

    fn plus(self, other: Self) -> Option<Self> {
        let ([a, b], [c, d]) = (self.parts(), other.parts());
        Self::of(a * d + c * b, b * d)
    }

    fn times(self, other: Self) -> Option<Self> {
        let ([a, b], [c, d]) = (self.parts(), other.parts());
        Self::of(a * c, b * d)
    }

    fn over(self, other: Self) -> Option<Self> {
        let ([a, b], [c, d]) = (self.parts(), other.parts());
        Self::of(a * d, b * c)
    }

    fn term(self) -> Term {
        Term::Number(self.0, self.1)
    }
}

/// The value at a point; none for a function, and for what grows too large.
fn value(term: &Term, point: &Point) -> Option<Fraction> {
    let all = |parts: &[Term]| parts.iter().map(|part| value(part, point)).collect::<Option<Vec<_>>>();
    match term {
        Term::Number(above, below) => Some(Fraction(*above, *below)),
        Term::Name(name) => point.get(name).copied(),
        Term::Sum(parts) => all(parts)?.into_iter().try_fold(Fraction(0, 1), Fraction::plus),
        Term::Product(parts) => all(parts)?.into_iter().try_fold(Fraction(1, 1), Fraction::times),
        Term::Quotient(both) => value(&both[0], point)?.over(value(&both[1], point)?),
        Term::Power(inner, exponent) => {
            let one = value(inner, point)?;
            let power = (0..exponent.abs()).try_fold(Fraction(1, 1), |product, _| product.times(one))?;
            if *exponent < 0 { Fraction(1, 1).over(power) } else { Some(power) }
        }
        Term::Call(..) => None,
    }
}

fn drawn_point(random: &mut Random) -> Point {
    let mut value = |name: &Name| match name {
        Name::Positive(_) => *random.pick(&[(1, 1), (2, 1), (3, 1), (1, 2), (1, 3), (5, 1), (1, 10)]),
        _ => *random.pick(&[(0, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-3, 1)]),
    };
    let names = all_names();
    names.iter().map(|name| (*name, value(name))).map(|(name, (a, b))| (name, Fraction(a, b))).collect()
}

/// A random expression in some of the names, and its value at the point.
fn drawn_term(random: &mut Random, names: &[Name], point: &Point) -> (Term, Fraction) {
    loop {
        let depth = random.below(3) + 1;
        let term = total(random, depth, names);
        if let Some(value) = value(&term, point).filter(|_| !term.names().is_empty()) {
            return (term, value);
        }
    }
}

/// A comparison of an expression with a number that is true, or false, at the point.
fn at_point(random: &mut Random, names: &[Name], point: &Point, truth: bool) -> Comparison {
    let (term, Fraction(above, below)) = drawn_term(random, names, point);
    let known = || Term::Number(above, below);
    let (more, less) = (|| Term::Number(above + below, below), || Term::Number(above - below, below));
    match (truth, random.below(5)) {
        (true, 0) => compare(term, ">=", known()),
        (true, 1) => compare(term, "<=", known()),
        (true, 2) => compare(term, "<", more()),
        (true, 3) => compare(term, ">", less()),
        (true, _) => compare(term, "!=", more()),
        (false, 0) => compare(term, ">", known()),
        (false, 1) => compare(term, "<", known()),
        (false, 2) => compare(term, ">=", more()),
        (false, 3) => compare(term, "=", less()),
        (false, _) => compare(term, "!=", known()),
    }
}

pub fn claim(random: &mut Random) -> Claim {
    let point = drawn_point(random);
    let mut names = all_names();
    random.shuffle(&mut names);
    names.truncate(random.below(3) + 2);
    match random.below(12) {
        0..=3 => refuted(random, &names, &point),
        4..=5 => implied(random, &names, &point),
        6 => of_roots(random, &names, &point),
        7 => of_change(random, &names, &point),
        8..=9 => existing(random, &names, &point),
        _ => with_values(random, &names, &point),
    }
}

/// False at the point, which meets the conditions.
fn refuted(random: &mut Random, names: &[Name], point: &Point) -> Claim {
    let goal = Formula::Compare(at_point(random, names, point, false));
    let other = |random: &mut Random, truth| Formula::Compare(at_point(random, names, point, truth));
    let formula = match random.below(6) {
        0 => Formula::And(vec![other(random, true), goal]),
        1 => Formula::Or(vec![goal, other(random, false)]),
        2 => other(random, true).implies(goal),
        3 => other(random, true).iff(goal),
        4 => other(random, true).negated(),
        _ => goal,
    };
    let mut claim = Claim::formula("refuted at a point", false, formula);
    claim.given = (0..random.below(3)).map(|_| at_point(random, names, point, true)).collect();
    claim
}

/// What follows from conditions that the point meets.
fn implied(random: &mut Random, names: &[Name], point: &Point) -> Claim {
    // Two expressions, the one with the larger value first.
    let mut pair = || {
        let [(one, of_one), (other, of_other)] = [(); 2].map(|()| drawn_term(random, names, point));
        let ([p, q], [r, t]) = (of_one.parts(), of_other.parts());
        match (p * t).cmp(&(r * q)) {
            Ordering::Less => Some((other, one)),
            Ordering::Equal => None,
            Ordering::Greater => Some((one, other)),
        }
    };
    let (Some(first), Some(second)) = (pair(), pair()) else { return refuted(random, names, point) };
    let unit = positive(random, 1, names);
    let ((a, b), (c, d)) = (first.clone(), second.clone());
    let claim = match random.below(5) {
        0 => Claim::compare("implied by conditions", true, &a + &c, ">", &b + &d),
        1 => Claim::compare("implied by conditions", true, &a * &unit, ">", &b * &unit),
        2 => Claim::compare("implied by conditions", true, (&a - &b) * (&c - &d), ">", n(0)),
        3 => Claim::compare("implied by conditions", true, n(1) / (&a - &b), ">", n(0)),
        _ => Claim::compare("implied by conditions", true, &a + &unit, "!=", b),
    };
    claim.given(first.0, ">", first.1).given(second.0, ">", second.1)
}

/// A coefficient that is not positive at the point.
fn of_roots(random: &mut Random, names: &[Name], point: &Point) -> Claim {
    let [(a, of_a), (b, of_b)] = [(); 2].map(|()| drawn_term(random, names, point));
    let polynomial = s().power(2) + &a * s() + &b;
    let is_stable = of_a.0 > 0 && of_b.0 > 0;
    let is_unstable = of_a.0 < 0 || of_b.0 < 0;
    let roots = |word| Formula::Roots(word, polynomial.clone());
    let formula = match (is_stable, is_unstable) {
        (true, _) => roots("unstable"),
        (_, true) => roots("stable"),
        _ => Formula::Or(vec![roots("stable"), roots("unstable")]),
    };
    Claim::formula("refuted roots", false, formula)
}

/// Two values of one variable, between which an expression does not rise, or changes.
fn of_change(random: &mut Random, names: &[Name], point: &Point) -> Claim {
    let (side, before) = drawn_term(random, names, point);
    let with = *random.pick(&side.names().into_iter().collect::<Vec<_>>());
    let mut moved = point.clone();
    let further = point[&with].plus(Fraction(random.whole(1, 3), 1));
    moved.extend(further.map(|value| (with, value)));
    let Some(after) = value(&side, &moved) else { return refuted(random, names, point) };
    let change = after.parts()[0] * before.parts()[1] - before.parts()[0] * after.parts()[1];
    let kind = "refuted by two points";
    let monotone =
        |rises| Claim::new(kind, Truth::False, Statement::Monotone { side: side.clone(), rises, with });
    let depends = |truth: bool| {
        let statement = Statement::Depends { side: side.clone(), depends: truth, on: with };
        Claim::new("change between two points", Truth::of(truth), statement)
    };
    match (change.signum(), random.coin()) {
        (0, rises) => monotone(rises),
        (_, true) => depends(random.coin()),
        (sign, _) => monotone(sign < 0),
    }
}

/// There are values of all variables: those of the point.
fn existing(random: &mut Random, names: &[Name], point: &Point) -> Claim {
    let parts =
        (0..=random.below(2)).map(|_| Formula::Compare(at_point(random, names, point, true))).collect();
    let mut claim = Claim::formula("existing at a point", true, Formula::And(parts));
    claim.there_is = claim.names();
    if random.coin() {
        claim.witness = claim.there_is.iter().map(|name| (*name, point[name].term())).collect();
    }
    claim
}

/// Every variable has a value.
fn with_values(random: &mut Random, names: &[Name], point: &Point) -> Claim {
    let truth = random.coin();
    let comparison = at_point(random, names, point, truth);
    let mut claim = Claim::formula("values of all variables", truth, Formula::Compare(comparison));
    claim.at = claim.names().into_iter().map(|name| (name, point[&name].term())).collect();
    claim
}
