//! The ranges of the largest real and imaginary part of the roots over a box: enclosed, with values that points of the box have.
//!
//! A search with 64-bit numbers finds a point with nearly the extreme value ([`super::summit`]); a search over the roots shows that no point has
//! one farther out ([`super::pair_search`]). All arithmetic of the latter is that of 64-bit intervals.

use std::cmp::Ordering;

use super::corners::{A, B, D, K, M, Point, S, V};
use super::pair_search::{FEW, PairSearch, Sought};
use super::root_discs::{RootPart, Values, value_at};
use super::summit::Summit;
use super::{OverBox, ParameterBox, boundary_signs};
use crate::number::{Interval, Rational};

/// A search ends when the enclosure's end is as near to a value that is attained: as a share of the range, and of the value.
const NEAR: f64 = 1e-10;
const FAR: f64 = 4e-3;
const TOLERANCE: f64 = 1e-12;
/// The most places that a search over the roots halves, and one that compares with a value.
const MOST_PLACES: usize = 1 << 12;
const MOST_PLACES_COMPARED: usize = 1 << 10;
/// The most levels that are compared with a least value.
const MOST_LEVELS: u32 = 16;
/// How much farther from the attained value the next level is, up to the middle.
const WIDER: f64 = 4.0;

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
    // Growth has the sign of K_c − K, and where a point does not oscillate, the least frequency is zero.
    let [nearest, farthest] = found.transition_signs;
    let [least, greatest] = found.boundary_signs;
    let real = scaled.range(RootPart::Real, [farthest == 0, nearest == 0]).map(|mut range| {
        let [low, high] = &mut range.enclosure;
        *low = if farthest <= 0 { low.max(0.0) } else { *low };
        *high = if nearest >= 0 { high.min(0.0) } else { *high };
        range.consistent()
    });
    let imaginary =
        scaled.range(RootPart::Imaginary, [greatest >= 0, least >= 0]).map(ValueRange::consistent);
    Ranges { max_real_per_s: real, max_imaginary_per_s: imaginary }
}

impl ValueRange {
    /// With attained values inside the enclosure: over a thin box the rounding of an attained value is wider than the range.
    fn consistent(self) -> Self {
        let [low, high] = self.enclosure;
        Self { attained: self.attained.map(|value| value.clamp(low, high)), ..self }
    }
}

/// Whether a point of the box has a value of the quantity in an interval, 1/s.
pub(in crate::stability) fn sought_in(region: &ParameterBox, quantity: RootPart, values: Interval) -> Sought {
    let scaled = Scaled::new(region);
    let goal = values / scaled.rate;
    // Where a point does not oscillate, the least frequency is zero.
    let is_below_goal = quantity == RootPart::Imaginary && goal.low >= 0.0 && boundary_signs(region)[1] >= 0;
    let least = if is_below_goal { Sought::Somewhere } else { scaled.beyond(quantity, Side::Least, goal) };
    match [scaled.beyond(quantity, Side::Greatest, goal), least] {
        [Sought::Nowhere, _] | [_, Sought::Nowhere] => Sought::Nowhere,
        // The values of a box are connected.
        [Sought::Somewhere, Sought::Somewhere] => Sought::Somewhere,
        _ => Sought::Unknown,
    }
}

/// Which end of a range is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Least,
    Greatest,
}

/// A box in its own units of D_c, V0 and σ: those of its lower end.
pub(in crate::stability) struct Scaled {
    /// An enclosure of each end of each parameter.
    lower: Values,
    upper: Values,
    /// V0/D_c of the lower end, 1/s.
    pub(in crate::stability) rate: Interval,
}

impl Scaled {
    /// The values of the seven parameters.
    pub(in crate::stability) fn values(&self) -> Values {
        std::array::from_fn(|i| self.lower[i].hull(self.upper[i]))
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
            lower: ends(&region.lower),
            upper: ends(&region.upper),
            rate: Interval::enclosing(&Rational::from(&units[V] / &units[D])),
        }
    }

    /// The range of a quantity, 1/s, of which some ends are known to be zero; none beyond the range of 64-bit numbers.
    fn range(&self, quantity: RootPart, is_zero: [bool; 2]) -> Option<ValueRange> {
        let sides = [(Side::Least, is_zero[0]), (Side::Greatest, is_zero[1])];
        let mut values = [Interval::point(0.0); 2];
        for (value, (side, is_zero)) in values.iter_mut().zip(sides) {
            if !is_zero {
                *value = self.value_at(quantity, &self.summit(quantity, side).near_a_corner())?;
            }
        }
        let attained = [values[0].high, values[1].low];
        let width = (attained[1] - attained[0]).abs();
        let mut ends = [[0.0; 2]; 2];
        for ((end, attained), (side, is_zero)) in ends.iter_mut().zip(attained).zip(sides) {
            if !is_zero {
                *end = self.extreme(
                    quantity,
                    side,
                    attained,
                    [NEAR, FAR].map(|share| (share * width).max(TOLERANCE * attained.abs())),
                )?;
            }
        }
        let in_si = |value: f64| Interval::point(value) * self.rate;
        let [[least_bound, least], [greatest_bound, greatest]] = ends.map(|end| end.map(in_si));
        // Towards the inside, so that a point has this value or one nearer to the bound. Where rounding is wider than the range,
        // the values of both points.
        let of_points = values.map(|value| in_si(value.middle()).middle());
        let mut attained = if least.high <= greatest.low { [least.high, greatest.low] } else { of_points };
        attained.sort_by(f64::total_cmp);
        let range = ValueRange { enclosure: [least_bound.low, greatest_bound.high], attained };
        [range.enclosure, range.attained].as_flattened().iter().all(|end| end.is_finite()).then_some(range)
    }

    /// A bound that no value passes, and a value that is attained.
    fn extreme(
        &self,
        quantity: RootPart,
        side: Side,
        attained: f64,
        [near, far]: [f64; 2],
    ) -> Option<[f64; 2]> {
        let search = |ceiling, most| self.search(quantity, side, ceiling, most);
        if quantity == RootPart::Imaginary || side == Side::Greatest {
            return Some(search(f64::INFINITY, MOST_PLACES).bound(attained, [near, far]));
        }
        // For the least value of the largest of three, no point is below a level, or some point is. The first level is next to the
        // attained value, which is mostly the least one.
        let (mut outer, mut attained) = (search(f64::INFINITY, 0).bound(attained, [0.0; 2])[0], attained);
        let mut step = near;
        let mut most = FEW;
        for level in 0..MOST_LEVELS {
            // A level that was compared is as far as the gap to rounding.
            if attained - outer <= 1.01 * if level == 0 { near } else { far } {
                break;
            }
            let half = 0.5 * (attained - outer);
            let ceiling = attained - step.min(half);
            match search(ceiling, most).has_points() {
                Sought::Nowhere => outer = ceiling,
                Sought::Somewhere => attained = ceiling,
                Sought::Unknown if step >= half => break,
                Sought::Unknown => {}
            }
            if level == 0 && outer < ceiling {
                let summit = self.summit(quantity, side);
                attained =
                    attained.min(self.value_at(quantity, &summit.evolved(summit.near_a_corner()))?.high);
            }
            step = if level == 0 { far } else { step * WIDER };
            most = MOST_PLACES_COMPARED;
        }
        Some([outer, attained])
    }

    /// Whether a point has a value as far out as some.
    fn beyond(&self, quantity: RootPart, side: Side, goal: Interval) -> Sought {
        let summit = self.summit(quantity, side);
        let is_reached = |point: &[f64; 7]| {
            self.value_at(quantity, point).is_some_and(|value| match side {
                Side::Least => value.high <= goal.low,
                Side::Greatest => value.low >= goal.high,
            })
        };
        let near_a_corner = summit.near_a_corner();
        if is_reached(&near_a_corner) {
            return Sought::Somewhere;
        }
        let search = |ceiling| self.search(quantity, side, ceiling, MOST_PLACES_COMPARED);
        let (beside, reached) = match side {
            Side::Greatest => (goal.low.next_down(), goal.high),
            Side::Least => (goal.high.next_up(), goal.low),
        };
        let found = if quantity == RootPart::Real && side == Side::Least {
            search(goal.high).has_points()
        } else if goal.sign().is_none_or(Ordering::is_eq) {
            Sought::Unknown
        } else {
            match search(f64::INFINITY).bound(beside, [0.0; 2]) {
                [bound, _] if bound == beside => Sought::Nowhere,
                [_, attained] if side.outward(attained) >= side.outward(reached) => Sought::Somewhere,
                _ => Sought::Unknown,
            }
        };
        let is_found = found == Sought::Unknown && is_reached(&summit.evolved(near_a_corner));
        if is_found { Sought::Somewhere } else { found }
    }

    fn search(&self, quantity: RootPart, side: Side, ceiling: f64, most: usize) -> PairSearch<'_> {
        let is_greatest = side == Side::Greatest;
        PairSearch { lower: &self.lower, upper: &self.upper, quantity, is_greatest, ceiling, most }
    }

    fn summit(&self, quantity: RootPart, side: Side) -> Summit {
        let (lower, upper) = (&self.lower, &self.upper);
        Summit {
            lower: lower.map(|lower| lower.high),
            upper: std::array::from_fn(|i| upper[i].low.max(lower[i].high)),
            quantity,
            is_greatest: side == Side::Greatest,
        }
    }

    fn value_at(&self, quantity: RootPart, point: &[f64; 7]) -> Option<Interval> {
        value_at(quantity, point, [&self.lower, &self.upper])
    }
}

impl Side {
    const fn outward(self, value: f64) -> f64 {
        match self {
            Self::Least => -value,
            Self::Greatest => value,
        }
    }
}
