//! Formulas whose variables all lie between two numbers, or have one value: decided by balls with outward rounding.

use std::cmp::Ordering;
use std::collections::{BTreeMap, VecDeque};

use slipmode_algebra::{Literal, Sign, SignFormula, Symbol, unknowns};
use slipmode_core::number::{Ball, Rational};

use super::Problem;
use super::lowering::Lowered;
use super::points::{self, Point};
use crate::claims::{Evidence, Finding};
use crate::scene::within_ends;

/// The most parts of a box that are looked at.
const MOST_PARTS: usize = 4096;

/// Bits of the numbers.
const BITS: u32 = 192;

/// The digits of the ends that are printed.
const DIGITS: usize = 12;

/// A variable and its ends.
type Side = (Symbol, [Rational; 2]);

impl Problem<'_> {
    /// The finding by enclosures, where every variable has ends or a value; none where it stays open.
    pub(super) fn enclosed(&self, lowered: &Lowered) -> Option<Finding> {
        let whole: Vec<Side> = self.formula.scope.within.clone();
        let ends: Vec<Literal> = whole.iter().flat_map(within_ends).collect();
        let other = self.premises.conditions.iter().filter(|condition| !ends.contains(condition));
        let not_met = other.map(|condition| SignFormula::Literal(condition.negated()));
        let signs = SignFormula::Any(not_met.chain([lowered.signs.clone()]).collect());
        let has_ends = |name: &Symbol| whole.iter().any(|(known, _)| known == name);
        let expressions = signs.literals().into_iter().map(|literal| &literal.expression);
        if !unknowns(expressions).iter().all(has_ends) {
            return None;
        }
        let (mut open, mut looked_at) = (VecDeque::from([whole.clone()]), 0);
        // The large parts first: along an edge of the formula there is no end of small ones.
        while let Some(part) = open.pop_front() {
            looked_at += 1;
            let values: BTreeMap<Symbol, Ball> =
                part.iter().map(|(name, [low, high])| (name.clone(), between(low, high))).collect();
            match signs.truth(&|literal| truth(literal, &values)) {
                Some(true) => {}
                Some(false) => return Some(self.false_within(lowered, &part, looked_at)),
                None if looked_at + open.len() < MOST_PARTS => open.extend(halves(&part, &whole)?),
                None => return None,
            }
        }
        Some(self.shown(match looked_at {
            1 => format!("true: {}", enclosures(lowered, &whole)),
            _ => format!("true in each of {looked_at} parts of the box, at most {MOST_PARTS}"),
        }))
    }

    fn shown(&self, value: String) -> Finding {
        let quantity = format!("'{}', by enclosures", self.formula.text);
        Finding::from_evidence(Evidence::Enclosure { quantity, value })
    }

    /// The finding that the formula is true at a point.
    pub(super) fn true_at(&self, lowered: &Lowered, point: &Point) -> Finding {
        let part: Vec<Side> =
            point.iter().map(|(name, value)| (name.clone(), [value.clone(), value.clone()])).collect();
        let value = format!("true at {}: {}", points::text(point), enclosures(lowered, &part));
        self.shown(value).seen_at([points::named(&self.full(point))])
    }

    /// The finding that the formula is false everywhere in a part.
    fn false_within(&self, lowered: &Lowered, part: &[Side], looked_at: usize) -> Finding {
        let middle = |(name, [low, high]): &Side| (name.clone(), Rational::from(low + high) / 2);
        let point = self.full(&part.iter().map(middle).collect());
        let sides = part.iter().map(|(name, [low, high])| format!("{name} from {low} to {high}"));
        let everywhere = if part.is_empty() {
            String::new()
        } else {
            format!("false for all {}; ", sides.collect::<Vec<_>>().join(", "))
        };
        let place = format!("{}{everywhere}{}", points::place(&point), enclosures(lowered, part));
        let value = format!("false in part {looked_at} of the box, at most {MOST_PARTS}");
        self.shown(value).refuted(place).seen_at([points::named(&point)])
    }
}

/// The ends between which left minus right of each comparison lies.
fn enclosures(lowered: &Lowered, part: &[Side]) -> String {
    let values: BTreeMap<Symbol, Ball> =
        part.iter().map(|(name, [low, high])| (name.clone(), between(low, high))).collect();
    let end = |value: rug::Float, round| value.to_string_radix_round(10, Some(DIGITS), round);
    let texts = lowered.signs.literals().into_iter().filter_map(|literal| {
        let ball = literal.expression.enclosed(&values, BITS)?;
        let (low, high) =
            (end(ball.lower(), rug::float::Round::Down), end(ball.upper(), rug::float::Round::Up));
        Some(format!("{} lies between {low} and {high}", literal.expression))
    });
    texts.collect::<Vec<_>>().join(", ")
}

/// All numbers between two, both included.
fn between(low: &Rational, high: &Rational) -> Ball {
    let middle = Ball::from_rational(&(Rational::from(low + high) / 2), BITS);
    let half = Ball::from_rational(&(Rational::from(high - low) / 2), BITS).upper();
    middle + Ball::new(rug::Float::new(BITS), half)
}

/// Whether a literal is true for all values, or false for all; none otherwise.
fn truth(literal: &Literal, values: &BTreeMap<Symbol, Ball>) -> Option<bool> {
    let ball = literal.expression.enclosed(values, BITS)?;
    if let Some(order) = ball.sign() {
        return Some(literal.sign.admits(order));
    }
    let lower = ball.lower().cmp0() != Some(Ordering::Less);
    let upper = ball.upper().cmp0() != Some(Ordering::Greater);
    match literal.sign {
        Sign::NonNegative if lower => Some(true),
        Sign::Positive if upper => Some(false),
        _ => None,
    }
}

/// The part cut in two across the side that is longest, as a share of the whole box; none for a point.
fn halves(part: &[Side], whole: &[Side]) -> Option<[Vec<Side>; 2]> {
    let length = |[low, high]: &[Rational; 2]| Rational::from(high - low);
    let share = |at: &usize| length(&part[*at].1) / length(&whole[*at].1);
    let at = (0..part.len()).max_by_key(share)?;
    let [low, high] = &part[at].1;
    let middle: Rational = Rational::from(low + high) / 2;
    let with = |ends: [Rational; 2]| {
        let mut half = part.to_vec();
        half[at].1 = ends;
        half
    };
    Some([with([low.clone(), middle.clone()]), with([middle, high.clone()])])
}
