//! The ranges of the largest real and imaginary part of the roots over a box: enclosed, with values that points of the box have.
//!
//! The greatest and the least value are searched apart, by halving the part of the box with the greatest bound. Where the derivative by a
//! parameter has one sign over a part, the greatest value over the part is at the parameter's end. Discs about the roots give derivatives
//! and bounds where roots are apart, conditions on coefficients ([`growth`]) where they meet. All arithmetic is that of 64-bit intervals.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::corners::{A, B, D, K, M, Point, S, V};
use super::growth;
use super::pair::Pair;
use super::pair_search::{PairSearch, Sought};
use super::ranked::Ranked;
use super::root_discs::{Quantity, RootDiscs, Values};
use super::summit::Summit;
use super::{OverBox, ParameterBox};
use crate::number::{Interval, Rational};

/// A search ends when the enclosure's end is as near to a value that is attained, relative to it.
const TOLERANCE: f64 = 1e-9;
/// The most parts that a search halves.
const MOST_PARTS: usize = 1 << 4;
/// Where a search over seven parameters does not end, one over the roots goes on to this share of the attained values' distance.
const NEAR: f64 = 4e-3;
/// The most places that a search over the roots halves, and one that compares with a value.
const MOST_PLACES: usize = 1 << 12;
const MOST_PLACES_COMPARED: usize = 1 << 10;
/// The most levels that are compared with a least value.
const MOST_LEVELS: u32 = 12;
/// How much farther from the attained value the next level is, up to the middle.
const WIDER: f64 = 4.0;

/// A bound is lowered to the attained value with such a share of it, or of its distance from the bound, if that is certain; one
/// within the first share of it is left to smaller parts.
const LOWERINGS: [f64; 3] = [0.3, 0.05, 0.002];

/// The values of a quantity at the points of a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueRange {
    /// All values lie between these two.
    pub enclosure: [f64; 2],
    /// The least and the greatest value found at points of the box, to within rounding.
    pub attained: [f64; 2],
}

/// The ranges of the parts of the roots of eq 8 over a box. A range beyond 64-bit numbers is absent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// The largest real part, 1/s.
    pub max_real_per_s: Option<ValueRange>,
    /// The largest imaginary part, 1/s; 0 exactly where no root is complex.
    pub max_imaginary_per_s: Option<ValueRange>,
}

/// The ranges over a box, of which `found` states the exact signs.
///
/// ```
/// use slipmode_core::stability::{ParameterBox, over_box, ranges_over_box};
/// use slipmode_core::{stability::InertialThreshold, friction::Parameters, number::parse_decimal};
///
/// let point = |b: &str| {
///     Parameters::from(["0.004", b, "1e-5", "1e7", "1000", "1e6", "1e-5"].map(|text| parse_decimal(text).unwrap()))
/// };
/// let uncertain = ParameterBox::new(point("0.005"), point("0.007")).unwrap();
/// let found = over_box(&uncertain, &InertialThreshold::default()).unwrap();
/// let growth = ranges_over_box(&uncertain, &found).max_real_per_s.unwrap();
/// // Growth rises with b.
/// assert!((growth.enclosure[0] / 0.112_499_686_719_79 - 1.0).abs() < 1e-9);
/// assert!((growth.enclosure[1] / 0.688_696_639_490_72 - 1.0).abs() < 1e-9);
/// ```
#[must_use]
pub fn ranges_over_box(region: &ParameterBox, found: &OverBox) -> Ranges {
    let scaled = Scaled::new(region);
    let range = |quantity| {
        let [least, greatest] = [Side::Least, Side::Greatest].map(|side| scaled.extreme(quantity, side));
        least.zip(greatest).map(|(least, greatest)| ValueRange {
            enclosure: [least.bound, greatest.bound],
            attained: [least.attained.min(greatest.attained), least.attained.max(greatest.attained)],
        })
    };
    let mut real = range(Quantity::Real).map(|range| of_signs(range, found.transition_signs));
    let [least_sign, greatest_sign] = found.boundary_signs;
    let mut imaginary = if least_sign >= 0 {
        Some(ValueRange { enclosure: [0.0; 2], attained: [0.0; 2] })
    } else if greatest_sign >= 0 {
        let greatest = scaled.extreme(Quantity::Imaginary, Side::Greatest);
        greatest.map(|Extreme { bound, attained }| ValueRange {
            enclosure: [0.0, bound],
            attained: [0.0, attained],
        })
    } else {
        range(Quantity::Imaginary)
    };
    for side in [Side::Least, Side::Greatest] {
        for (quantity, range) in [(Quantity::Real, &mut real), (Quantity::Imaginary, &mut imaginary)] {
            // Where some points do not oscillate, the least frequency is zero.
            let is_zero = quantity == Quantity::Imaginary && side == Side::Least && greatest_sign >= 0;
            if let Some(range) = range.as_mut().filter(|_| !is_zero) {
                scaled.by_roots(quantity, side, range);
            }
        }
    }
    let [max_real_per_s, max_imaginary_per_s] =
        [real, imaginary].map(|range| range.map(ValueRange::consistent));
    Ranges { max_real_per_s, max_imaginary_per_s }
}

impl ValueRange {
    /// With attained values inside the enclosure: over a thin box the rounding of an attained value is wider than the range.
    fn consistent(self) -> Self {
        let [low, high] = self.enclosure;
        Self { attained: self.attained.map(|value| value.clamp(low, high)), ..self }
    }
}

/// Growth has the sign of K_c − K, whose extremes are known exactly.
fn of_signs(mut range: ValueRange, [least, greatest]: [i8; 2]) -> ValueRange {
    if greatest <= 0 {
        range.enclosure[0] = range.enclosure[0].max(0.0);
    }
    if least >= 0 {
        range.enclosure[1] = range.enclosure[1].min(0.0);
    }
    if greatest == 0 {
        range.attained[0] = 0.0;
    }
    if least == 0 {
        range.attained[1] = 0.0;
    }
    range
}

/// Whether a point of the box has a value of the quantity in an interval, 1/s.
pub(in crate::stability) fn sought_in(region: &ParameterBox, quantity: Quantity, values: Interval) -> Sought {
    let scaled = Scaled::new(region);
    let goal = values / scaled.rate;
    let compared = |side| {
        let turned = if side == Side::Least { -goal } else { goal };
        let found = Search::new(quantity, side, Some(turned)).run(scaled.part)?;
        let is_reached = found.attained >= turned.high;
        let is_passed_by_none = found.bound < turned.low;
        Some([
            is_passed_by_none || !is_reached && scaled.reaches_by_no_root(quantity, side, goal),
            is_reached,
        ])
    };
    match [Side::Greatest, Side::Least].map(compared) {
        [Some([true, _]), _] | [_, Some([true, _])] => Sought::Nowhere,
        // The values of a box are connected.
        [Some([_, true]), Some([_, true])] => Sought::Somewhere,
        _ => Sought::Unknown,
    }
}

/// Which end of a range is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Least,
    Greatest,
}

/// An end of a range: a bound that no value passes, and a value that is attained.
struct Extreme {
    bound: f64,
    attained: f64,
}

/// A box in its own units of D_c, V0 and σ: those of its lower end.
pub(in crate::stability) struct Scaled {
    part: Part,
    /// V0/D_c of the lower end, 1/s.
    pub(in crate::stability) rate: Interval,
}

/// A part of a box: an enclosure of each end of each parameter.
#[derive(Debug, Clone, Copy)]
struct Part {
    lower: Values,
    upper: Values,
}

impl Scaled {
    /// The values of the seven parameters.
    pub(in crate::stability) fn values(&self) -> Values {
        self.part.hull()
    }

    /// The units of the seven parameters in SI.
    pub(in crate::stability) fn units(region: &ParameterBox) -> Point {
        let mut units = region.lower.clone();
        let [distance, stress, velocity] = [D, S, V].map(|i| region.lower[i].clone());
        units[K] = stress.clone() / &distance;
        units[M] = stress * distance / velocity.square();
        (units[A], units[B]) = (Rational::from(1), Rational::from(1));
        units
    }

    pub(in crate::stability) fn new(region: &ParameterBox) -> Self {
        let units = Self::units(region);
        let ends = |point: &Point| -> Values {
            std::array::from_fn(|i| Interval::enclosing(&Rational::from(&point[i] / &units[i])))
        };
        Self {
            part: Part { lower: ends(&region.lower), upper: ends(&region.upper) },
            rate: Interval::enclosing(&Rational::from(&units[V] / &units[D])),
        }
    }

    /// Both estimates of an end, brought together by a search over the roots where they are farther apart than a share of the range.
    fn by_roots(&self, quantity: Quantity, side: Side, range: &mut ValueRange) {
        let values = self.values();
        let is_greatest = side == Side::Greatest;
        let search =
            |ceiling| PairSearch { values: &values, quantity, is_greatest, ceiling, most: MOST_PLACES };
        let (in_si, scaled) = (
            |value: f64| Interval::point(value) * self.rate,
            |value: f64| Interval::point(value) / self.rate,
        );
        let gap = NEAR * (range.attained[1] - range.attained[0]);
        let end = usize::from(is_greatest);
        let mut step = gap;
        for _ in 0..MOST_LEVELS {
            let (outer, attained) = (&mut range.enclosure[end], &mut range.attained[end]);
            // A level that was compared is as far as the gap to rounding.
            if (*outer - *attained).abs() <= 1.01 * gap {
                break;
            }
            if quantity == Quantity::Imaginary || is_greatest {
                let bound = in_si(search(f64::INFINITY).bound(scaled(*attained).middle(), scaled(gap).low));
                *outer = if is_greatest { outer.min(bound.high) } else { outer.max(bound.low) };
                break;
            }
            // For the least value of the largest of three, no point is below a level, or some point is. The first level is next to the
            // attained value, which is mostly the least one.
            let half = 0.5 * (*attained - *outer);
            let level = *attained - step.min(half);
            let ceiling = scaled(level).high;
            match search(ceiling).has_points() {
                Sought::Nowhere => *outer = level,
                Sought::Somewhere => *attained = in_si(ceiling).high,
                Sought::Unknown if step >= half => break,
                Sought::Unknown => {}
            }
            step *= WIDER;
        }
    }

    /// Whether two roots are of no point with a value as far out as some, which are not zero, for certain.
    fn reaches_by_no_root(&self, quantity: Quantity, side: Side, goal: Interval) -> bool {
        let is_greatest = side == Side::Greatest;
        let values = self.values();
        let search = |ceiling| PairSearch {
            values: &values,
            quantity,
            is_greatest,
            ceiling,
            most: MOST_PLACES_COMPARED,
        };
        if quantity == Quantity::Real && !is_greatest {
            return search(goal.high).has_points() == Sought::Nowhere;
        }
        let beside = if is_greatest { goal.low.next_down() } else { goal.high.next_up() };
        goal.sign().is_some_and(Ordering::is_ne) && search(f64::INFINITY).bound(beside, 0.0) == beside
    }

    /// An end of the range of a quantity, in 1/s; none beyond the range of 64-bit numbers.
    fn extreme(&self, quantity: Quantity, side: Side) -> Option<Extreme> {
        let found = Search::new(quantity, side, None).run(self.part)?;
        let in_si =
            |value: f64| Interval::point(if side == Side::Least { -value } else { value }) * self.rate;
        let ends = |interval: Interval| if side == Side::Least { interval.low } else { interval.high };
        let [bound, attained] = [found.bound, found.attained].map(in_si);
        // Towards the inside, so that a point has this value or one nearer to the bound.
        let inside = if side == Side::Least { attained.high } else { attained.low };
        // An imaginary part of a pair's upper root is not negative, and a sum with zero has no negative zero.
        let least = if quantity == Quantity::Imaginary { 0.0 } else { f64::NEG_INFINITY };
        let [bound_si, attained_si] = [ends(bound), inside].map(|value| value.max(least) + 0.0);
        let extreme = Extreme { bound: bound_si, attained: attained_si };
        (bound.is_finite() && attained.is_finite()).then_some(extreme)
    }
}

/// A search for the greatest value of a quantity, or of its negative.
struct Search {
    quantity: Quantity,
    side: Side,
    /// The greatest value known to be attained.
    attained: f64,
    /// The search ends when it is known that no value is as great as these, or that one is greater.
    goal: Option<Interval>,
}

/// A part that was examined, with the parameter to halve, none where all are certain; no value is greater than its rank.
type Examined = Ranked<(Part, Option<usize>)>;

impl Search {
    const fn new(quantity: Quantity, side: Side, goal: Option<Interval>) -> Self {
        Self { quantity, side, attained: f64::NEG_INFINITY, goal }
    }

    /// Notes the value at a point.
    fn visit(&mut self, point: &Values) {
        if let Some(discs) = RootDiscs::of(point) {
            self.attained = self.attained.max(self.value(discs.largest(self.quantity, &[None; 3])).low);
        }
    }

    /// A value, negated in a search for the least.
    fn value(&self, value: Interval) -> Interval {
        if self.side == Side::Least { -value } else { value }
    }

    fn run(mut self, whole: Part) -> Option<Extreme> {
        let summit = Summit {
            lower: whole.lower.map(|lower| lower.high),
            upper: std::array::from_fn(|i| whole.upper[i].low.max(whole.lower[i].high)),
            quantity: self.quantity,
            is_greatest: self.side == Side::Greatest,
        };
        let near_a_corner = summit.near_a_corner();
        self.visit(&whole.with_ends(&near_a_corner));
        let mut open = BinaryHeap::from([self.examine(whole, f64::INFINITY)?]);
        let mut bound = f64::NEG_INFINITY;
        for _ in 0..MOST_PARTS {
            let Some(most) = open.peek() else { break };
            let is_decided = |goal: Interval| most.rank.max(bound) < goal.low || self.attained >= goal.high;
            let is_near = most.rank <= self.attained + TOLERANCE * self.attained.abs();
            if is_near || self.goal.is_some_and(is_decided) {
                break;
            }
            let Some(Ranked { rank: of_part, of: (part, axis) }) = open.pop() else { break };
            let Some(halves) = axis.and_then(|axis| part.halves(axis)) else {
                bound = bound.max(of_part);
                continue;
            };
            for half in halves {
                let examined = self.examine(half, of_part)?;
                if examined.rank > self.attained {
                    open.push(examined);
                }
            }
        }
        let bound = open.peek().map_or(bound, |most| bound.max(most.rank));
        let is_minimax = self.quantity == Quantity::Real && self.side == Side::Least;
        if is_minimax && self.goal.is_none() && bound > self.attained + TOLERANCE * self.attained.abs() {
            self.visit(&whole.with_ends(&summit.evolved(near_a_corner)));
        }
        let bound = bound.max(self.attained);
        Some(Extreme { bound, attained: self.attained })
    }

    /// The derivatives of the largest real part, negated in a search for the least, as far as they are known without roots: they count
    /// where the value lies between the greatest that is attained and the bound, since others cannot be the greatest.
    fn slopes_of_growth(&self, hull: &Values, bound: f64) -> [Interval; 7] {
        let values = self.value(Interval { low: self.attained.min(bound), high: bound });
        self.turned(growth::slopes(hull, values))
    }

    fn turned(&self, slopes: [Interval; 7]) -> [Interval; 7] {
        if self.side == Side::Least { slopes.map(|slope| -slope) } else { slopes }
    }

    /// A bound over a part, lowered towards the greatest value that is attained as far as is certain.
    fn lowered(&self, bound: f64, hull: &Values) -> f64 {
        let highest = self.attained + TOLERANCE * self.attained.abs();
        if bound <= highest || self.quantity == Quantity::Imaginary {
            return bound;
        }
        let is_above_all = |value: f64| match self.side {
            Side::Greatest => growth::are_left(hull, value),
            Side::Least => growth::are_not_left(hull, -value),
        };
        if is_above_all(highest) {
            return highest;
        }
        if let Some(below) = self.goal.map(|goal| goal.low.next_down()).filter(|below| *below < bound)
            && is_above_all(below)
        {
            return below;
        }
        let distant = self.attained + LOWERINGS[0] * self.attained.abs();
        let of_attained = LOWERINGS.map(|share| self.attained + share * self.attained.abs());
        let of_bound = LOWERINGS.map(|share| self.attained + share * (bound - self.attained));
        let steps = of_attained.into_iter().chain(of_bound).filter(|step| *step < bound && bound > distant);
        steps.filter(|step| is_above_all(*step)).fold(bound, f64::min)
    }

    /// Bounds the values over a part, none of which is above a bound, after the parameters in which it is monotone are at their ends.
    fn examine(&mut self, mut part: Part, mut bound: f64) -> Option<Examined> {
        loop {
            let hull = part.hull();
            let discs = RootDiscs::of(&hull)?;
            bound = bound.min(self.value(discs.largest(self.quantity, &[None; 3])).high);
            bound = self.lowered(bound, &hull);
            if self.quantity == Quantity::Real && part.go_to_ends(&self.slopes_of_growth(&hull, bound)) {
                continue;
            }
            let middle = part.middle();
            let at_middle = RootDiscs::of(&middle)?;
            self.visit(&middle);
            let tracked = discs.tracked(&hull, &at_middle, &middle);
            let pair = (self.quantity == Quantity::Imaginary).then(|| {
                let at_point = at_middle.others(&middle, &[None; 3])?[1];
                Pair::of(&hull, discs.others(&hull, &tracked)?, at_point, &middle)
            });
            let pair = pair.flatten();
            let top = discs.top(self.quantity, &tracked).map(|top| top.slopes(self.quantity));
            let slopes = top.or_else(|| pair.as_ref().map(Pair::slopes)).map(|slopes| self.turned(slopes));
            if slopes.is_some_and(|slopes| part.go_to_ends(&slopes)) {
                continue;
            }
            let of_discs = discs.largest(self.quantity, &tracked);
            let values = pair.map_or(of_discs, |pair| of_discs.intersection(pair.height()));
            let bound = bound.min(self.value(values).high);
            let effects: [f64; 7] = std::array::from_fn(|i| match slopes {
                Some(slopes) => (slopes[i] * (hull[i] - middle[i])).width(),
                None => hull[i].width() / hull[i].high,
            });
            let wide = (0..7).filter(|i| part.is_wide(*i));
            let axis = wide.max_by(|i, j| effects[*i].total_cmp(&effects[*j]).then(j.cmp(i)));
            return Some(Ranked { rank: bound, of: (part, axis) });
        }
    }
}

impl Part {
    fn hull(&self) -> Values {
        std::array::from_fn(|i| self.lower[i].hull(self.upper[i]))
    }

    /// Whether a number lies between the enclosures of a parameter's ends.
    fn is_wide(&self, i: usize) -> bool {
        self.lower[i].high.next_up() < self.upper[i].low
    }

    /// A point with the enclosures of the ends where it is at one.
    fn with_ends(&self, point: &[f64; 7]) -> Values {
        std::array::from_fn(|i| match point[i] {
            value if value <= self.lower[i].high => self.lower[i],
            value if value >= self.upper[i].low => self.upper[i],
            value => Interval::point(value),
        })
    }

    /// A point of the part.
    fn middle(&self) -> Values {
        std::array::from_fn(
            |i| if self.is_wide(i) { Interval::point(self.between(i)) } else { self.lower[i] },
        )
    }

    fn between(&self, i: usize) -> f64 {
        Interval { low: self.lower[i].high, high: self.upper[i].low }.middle()
    }

    /// Sets parameters in which a value rises or falls to the end where it is greatest; whether there are such.
    fn go_to_ends(&mut self, slopes: &[Interval; 7]) -> bool {
        let mut is_changed = false;
        for (i, slope) in slopes.iter().enumerate() {
            let is_rising = slope.low >= 0.0;
            if self.lower[i] != self.upper[i] && (is_rising || slope.high <= 0.0) {
                let end = if is_rising { self.upper[i] } else { self.lower[i] };
                (self.lower[i], self.upper[i]) = (end, end);
                is_changed = true;
            }
        }
        is_changed
    }

    fn halves(&self, axis: usize) -> Option<[Self; 2]> {
        let middle = Interval::point(self.is_wide(axis).then(|| self.between(axis))?);
        let (mut low, mut high) = (*self, *self);
        low.upper[axis] = middle;
        high.lower[axis] = middle;
        Some([low, high])
    }
}
