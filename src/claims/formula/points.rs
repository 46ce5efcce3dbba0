//! Rational points at which conditions are met: examples of a domain, and counter-examples.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeMap;

use rug::float::Round;
use slipmode_algebra::number::Interval;
use slipmode_algebra::{Expression, Literal, Symbol, unknowns};
use slipmode_core::number::{Ball, Rational};

use crate::claims::finding::NamedPoint;
use crate::scene::Premises;

/// A value for each variable.
pub(super) type Point = BTreeMap<Symbol, Rational>;

/// Values that variables take. Most are squares, so that square roots are rational.
const VALUES: [(u32, u32); 14] = [
    (1, 1),
    (4, 1),
    (9, 1),
    (16, 1),
    (25, 1),
    (1, 4),
    (1, 9),
    (1, 100),
    (100, 1),
    (2, 1),
    (1, 2),
    (10_000, 1),
    (1, 10_000),
    (3, 1),
];

/// How often a point is moved towards the literals that it does not meet.
const REPAIRS: usize = 3;

/// Points among which an example is sought. Of 896 searches in seven reports the last one that found any needed 104.
const EXAMPLES: usize = 128;

/// The points of a fixed sequence.
pub(super) struct Points {
    /// The variables and what is to be known of functions, and whether each is positive.
    variables: Vec<(Symbol, bool)>,
    /// The ends of those that have some.
    within: BTreeMap<Symbol, [Rational; 2]>,
    /// The examples that were asked for, with their literals.
    examples: RefCell<Vec<(Vec<Literal>, Option<Point>)>>,
}

impl Points {
    /// How many points are looked at.
    pub const MOST: usize = 4096;

    /// Points in the variables of these expressions and of the conditions.
    pub fn new<'e>(
        premises: &'e Premises,
        within: &[(Symbol, [Rational; 2])],
        expressions: impl IntoIterator<Item = &'e Expression>,
    ) -> Self {
        let conditions = premises.conditions.iter().map(|condition| &condition.expression);
        let is_variable = |name: &Symbol| !["i", "pm"].contains(&name.as_str());
        let variables =
            unknowns(expressions.into_iter().chain(conditions)).into_iter().filter(is_variable).map(|name| {
                let positive = premises.positive.contains(&name);
                (name, positive)
            });
        let within = within.iter().cloned().collect();
        Self { variables: variables.collect(), within, examples: RefCell::default() }
    }

    /// The first so many points, each moved so that it meets the literals, where that succeeds.
    pub fn meeting<'p>(&'p self, literals: &'p [Literal], count: usize) -> impl Iterator<Item = Point> + 'p {
        (0..count).filter_map(move |index| self.repaired(self.point(index), literals, index))
    }

    /// The first point that meets the literals, one at which they are rational if there is one.
    pub fn example(&self, literals: &[Literal]) -> Option<Point> {
        let known = self.examples.borrow().iter().find(|(of, _)| of == literals).cloned();
        if let Some((_, example)) = known {
            return example;
        }
        // Coq computes the conditions at the example: rational roots are the easy ones.
        let is_rational =
            |point: &Point| literals.iter().all(|one| one.expression.rational_value(point).is_some());
        let mut first = None;
        let rational = self.meeting(literals, EXAMPLES).find(|point| {
            first.get_or_insert_with(|| point.clone());
            is_rational(point)
        });
        let example = rational.or(first);
        self.examples.borrow_mut().push((literals.to_vec(), example.clone()));
        example
    }

    /// The point moved onto the zeros of expressions and to both sides of them, one variable at a time.
    pub fn edges<'p>(
        &'p self,
        point: &'p Point,
        expressions: &'p [Expression],
    ) -> impl Iterator<Item = Point> + 'p {
        let moved = move |expression: &'p Expression| {
            self.variables.iter().filter_map(move |(name, _)| Some((name, zero(expression, name, point)?)))
        };
        let beside = move |(name, zero): (&'p Symbol, Rational)| {
            let values = [zero.clone(), zero.clone() + 1, zero - 1].into_iter();
            values.map(move |value| with(point, name, value)).filter(move |moved| self.allows(moved))
        };
        expressions.iter().flat_map(moved).flat_map(beside)
    }

    /// Whether each positive variable is, and each lies between its ends.
    fn allows(&self, point: &Point) -> bool {
        let positive = self.variables.iter().all(|(name, positive)| !positive || point[name] > 0);
        let inside = |(name, [low, high]): (&Symbol, &[Rational; 2])| {
            point.get(name).is_none_or(|value| low <= value && value <= high)
        };
        positive && self.within.iter().all(inside)
    }

    fn repaired(&self, mut point: Point, literals: &[Literal], turn: usize) -> Option<Point> {
        let unmet = |point: &Point| literals.iter().find(|literal| literal.holds_at(point) != Some(true));
        for _ in 0..REPAIRS {
            let Some(literal) = unmet(&point) else { break };
            let count = self.variables.len().max(1);
            let names = self.variables.iter().cycle().skip(turn % count).take(count);
            point = names.filter_map(|(name, _)| self.moved(&point, literal, name)).next()?;
        }
        (unmet(&point).is_none() && self.allows(&point)).then_some(point)
    }

    /// The point with another value of one variable, so that it meets a literal.
    fn moved(&self, point: &Point, literal: &Literal, name: &Symbol) -> Option<Point> {
        let zero = zero(&literal.expression, name, point)?;
        let ends = self.within.get(name).into_iter().flatten().map(|end| Rational::from(end + &zero) / 2);
        let near = [zero.clone(), zero.clone() + 1, zero.clone() - 1, zero.clone() * 2, zero.clone() / 2];
        let mut candidates = near.into_iter().chain(ends).map(|value| with(point, name, value));
        candidates.find(|moved| self.allows(moved) && literal.holds_at(moved) == Some(true))
    }

    /// Point number `index`: the first has 1 everywhere, the others are spread by a linear congruential generator.
    fn point(&self, index: usize) -> Point {
        let mut state = index as u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 40).unwrap_or_default()
        };
        let values = self.variables.iter().map(|(name, positive)| {
            let place = if index == 0 { 0 } else { next() };
            let value = Rational::from(VALUES[place % VALUES.len()]);
            let sign = if *positive || index == 0 { 0 } else { next() % 3 };
            let value = match (self.within.get(name), sign) {
                (Some([low, high]), _) => low + Rational::from(high - low) * (place % 9) as u32 / 8_u32,
                (None, 0) => value,
                (None, 1) => -value,
                (None, _) => Rational::new(),
            };
            (name.clone(), value)
        });
        values.collect()
    }
}

/// The point with another value of one variable.
pub(super) fn with(point: &Point, name: &Symbol, value: Rational) -> Point {
    let mut moved = point.clone();
    moved.insert(name.clone(), value);
    moved
}

/// The zero of an expression that is linear in a variable, the others as at a point.
fn zero(expression: &Expression, name: &Symbol, point: &Point) -> Option<Rational> {
    // What is known of a function stands in no expression.
    let is_seen = name.function_at_zero().is_none();
    if is_seen && (!expression.contains(name) || is_bent(expression, name, point)) {
        return None;
    }
    let expression = if is_seen { &expression.along(name, point) } else { expression };
    let mut point = point.clone();
    let mut at = |value: u32| {
        point.insert(name.clone(), Rational::from(value));
        expression.rational_value(&point)
    };
    let (one, two) = (at(1)?, at(2)?);
    let slope = Rational::from(&two - &one);
    (slope != 0 && at(3)? - two == slope).then(|| 1 - one / &slope)
}

/// Whether 64 bits show that an expression is not linear in a variable: its second difference is not zero.
fn is_bent(expression: &Expression, name: &Symbol, point: &Point) -> bool {
    let at = |value: f64| {
        let number = |other: &Symbol| match other == name {
            true => Some(Interval::point(value)),
            false => point.get(other).map(Interval::enclosing),
        };
        expression.enclosed_with(&number, f64::MANTISSA_DIGITS)
    };
    let second = || Some(at(1.0)? - at(2.0)? * 2.0 + at(3.0)?);
    second().and_then(Interval::sign).is_some_and(Ordering::is_ne)
}

/// The value of an expression at a point: exact where it is rational, else to twelve digits.
pub(super) fn value(expression: &Expression, point: &Point) -> Option<String> {
    if let Some(value) = expression.rational_value(point) {
        return Some(value.to_string());
    }
    let balls = point.iter().map(|(name, value)| (name.clone(), Ball::from_rational(value, BITS)));
    let value = expression.enclosed(&balls.collect(), BITS)?;
    let text = |digits| value.centre().to_string_radix_round(10, Some(digits), Round::Zero);
    // Cut at its decimal point, a number would not say how large it is: with a digit less it has an exponent.
    let text = Some(text(DIGITS)).filter(|text| text.contains('.')).unwrap_or_else(|| text(DIGITS - 1));
    Some(format!("{text}…"))
}

/// Bits and digits of values that are not rational.
const BITS: u32 = 128;
const DIGITS: usize = 12;

/// A point by the names of the variables.
pub(super) fn named(point: &Point) -> NamedPoint {
    point.iter().map(|(name, value)| (name.to_string(), value.clone())).collect()
}

/// The beginning of a sentence on a point: none where it has no coordinates.
pub(super) fn place(point: &Point) -> String {
    if point.is_empty() { String::new() } else { format!("at {}: ", text(point)) }
}

/// A point in words: the values of variables, and functions as polynomials.
pub(super) fn text(point: &Point) -> String {
    let letter = LETTERS.iter().find(|letter| point.keys().all(|name| name.as_str() != **letter));
    let letter: Option<Symbol> = letter.and_then(|letter| letter.parse().ok());
    let one = |(name, value): (&Symbol, &Rational)| match (name.function_at_zero(), &letter) {
        (None, _) | (_, None) => Some(format!("{name} = {value}")),
        (Some(function), Some(_)) if function.derivative_order() > 0 => None,
        (Some(function), Some(letter)) => {
            let polynomial = Expression::polynomial(&function, &Expression::variable(letter), point)?;
            Some(format!("{function}({letter}) = {polynomial}"))
        }
    };
    point.iter().filter_map(one).collect::<Vec<_>>().join(", ")
}

/// Letters for the argument of a function, of which no variable of the point may be one.
const LETTERS: [&str; 8] = ["x", "y", "z", "u", "w", "r", "p", "q"];
