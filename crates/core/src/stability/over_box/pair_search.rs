//! Which two numbers are roots of eq 8 for some point of a box, and bounds of the largest real and imaginary part over the box.
//!
//! The roots beside a negative one are X ± √(−w): with their product N = X² + w > 0, r = V0/D_c, δ = D_c/σ and Q = N + r² + 2rX, eq 8 is
//! a = δ (r² k/N − m r (r + 2X)) and b = δ Q (k/N − m); the third root is −r k/(m N). For given X, w and r, the pairs (a/δ, b/δ) of a box are a
//! polygon, and those of all k and m a parallelogram. They meet unless a side of one of them divides them, so that five conditions decide
//! whether these are roots for some point with this r. A search over X, w and r has three dimensions in the place of seven.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::pair_conditions::{CONDITIONS, Changing, Terms, VARIABLES};
use super::ranges::Sought;
use super::root_discs::{Quantity, Values, cubic};
use crate::number::Interval;

/// The most places that a search for a bound halves, and one for a point.
const MOST_PLACES: usize = 1 << 12;
const MOST_PLACES_FOR_A_POINT: usize = 1 << 11;
/// How often the equations narrow a place, and how often its end is cut.
const NARROWINGS: u32 = 3;
const CUTS: u32 = 3;

/// A search for the greatest or the least value of a quantity.
#[derive(Debug, Clone, Copy)]
pub(super) struct PairSearch<'v> {
    /// The box.
    pub values: &'v Values,
    /// Which quantity.
    pub quantity: Quantity,
    /// Whether its greatest value is sought.
    pub is_greatest: bool,
    /// Points with a largest real part above it are left out.
    pub ceiling: f64,
}

/// Values of X, w and r.
type Place = [Interval; 3];

const MIDDLE: usize = 0;
const SQUARE: usize = 1;
const RATE: usize = 2;

impl PairSearch<'_> {
    /// A value that no point of the box passes, or `attained` where that is farther out. The search ends where the two are as near as `gap`.
    pub(super) fn bound(&self, attained: f64, gap: f64) -> f64 {
        let outward = |value: f64| if self.is_greatest { value } else { -value };
        let attained = outward(attained);
        let ranked = |place: Place| Ranked { rank: outward(self.bound_over(&place)), place };
        let mut open: BinaryHeap<Ranked> = self.narrowed(self.whole()).map(ranked).into_iter().collect();
        for _ in 0..MOST_PLACES {
            if open.peek().is_none_or(|first| first.rank <= attained + gap) {
                break;
            }
            let Some(first) = open.pop() else { break };
            let halves = halves(&first.place).into_iter();
            let left = halves.filter_map(|half| self.cut(self.narrowed(half)?)).map(ranked);
            open.extend(left.filter(|half| half.rank > attained));
        }
        outward(open.peek().map_or(attained, |first| first.rank.max(attained)))
    }

    /// Whether a point of the box is below the ceiling.
    pub(super) fn has_points(&self) -> Sought {
        let ranked = |place: Place| Ranked { rank: -self.bound_over(&place), place };
        let mut open: BinaryHeap<Ranked> = self.narrowed(self.whole()).map(ranked).into_iter().collect();
        for _ in 0..MOST_PLACES_FOR_A_POINT {
            let Some(Ranked { place, .. }) = open.pop() else { return Sought::Nowhere };
            for half in halves(&place).into_iter().filter_map(|half| self.cut(self.narrowed(half)?)) {
                let middle = half.map(|variable| Interval::point(variable.middle()));
                if self.narrowed(middle).and_then(|middle| self.cut(middle)).is_some() {
                    return Sought::Somewhere;
                }
                open.push(ranked(half));
            }
        }
        Sought::Unknown
    }

    /// k, m and m N/k: the third root, −r k/(m N), is below the ceiling, and below the other two where these are real.
    fn machine(&self, [middle, square, rate]: &Place, product: Interval) -> Option<[Interval; 3]> {
        let [.., k, m, _, _] = *self.values;
        let mut machine = [k, m, m / k * product];
        let lower = *middle - (-*square).square_root();
        let ceiling = if square.high < 0.0 { self.ceiling.min(lower.high) } else { self.ceiling };
        if ceiling < 0.0 {
            machine[2] = common(machine[2], at_most((*rate / Interval::point(-ceiling)).high))?;
            let least = product / Interval::point(machine[2].high);
            machine[0].low = k.low.max((least * m.low).low);
            machine[1].high = m.high.min((Interval::point(k.high) / least).high);
        }
        Some(machine)
    }

    /// The variable with which the quantity changes most.
    const fn leading(&self) -> usize {
        if matches!(self.quantity, Quantity::Real) { MIDDLE } else { SQUARE }
    }

    /// The end of that variable at which the search looks.
    fn end(&self, place: &Place) -> f64 {
        let leading = place[self.leading()];
        if self.is_greatest { leading.high } else { leading.low }
    }

    /// A value that the quantity does not pass over a place.
    fn bound_over(&self, [middle, square, rate]: &Place) -> f64 {
        let value = match self.quantity {
            Quantity::Imaginary => square.square_root(),
            Quantity::Real => {
                let [.., k, m, _, _] = *self.values;
                let third = -(*rate * k / (m * (middle.square() + *square)));
                let of_two = *middle + (-*square).square_root();
                Interval { low: of_two.low.max(third.low), high: of_two.high.max(third.high.min(0.0)) }
            }
        };
        if self.is_greatest { value.high } else { value.low }
    }

    /// All places: a pair is slower than the slider on its spring alone, the third root is negative, and no root is beyond twice the
    /// greatest of c2/c3, √(|c1|/c3) and ∛(c0/c3).
    fn whole(&self) -> Place {
        let [.., d, k, m, _, v] = *self.values;
        let [c0, c1, c2, c3] = cubic(self.values);
        let size = |coefficient: Interval| (coefficient / c3).high.max(-(coefficient / c3).low).next_up();
        let reach = 2.0 * size(c2).max(size(c1).sqrt()).max(libm::cbrt(size(c0))).next_up();
        let least = if self.quantity == Quantity::Real { -reach * reach } else { 0.0 };
        [Interval { low: -0.5 * size(c2), high: reach }, Interval { low: least, high: (k / m).high }, v / d]
    }

    /// D_c/σ where V0/D_c has the values of a rate.
    fn delta(&self, rate: Interval) -> Option<Interval> {
        let [_, _, d, _, _, s, v] = *self.values;
        Some(common(d, v / rate)? / s)
    }

    /// The part of a place that the ceiling and each equation alone leave; none where no numbers of it are roots.
    fn narrowed(&self, mut place: Place) -> Option<Place> {
        let [a, b, ..] = *self.values;
        let delta = self.delta(place[RATE])?;
        place[MIDDLE] = common(place[MIDDLE], at_most(self.ceiling))?;
        for _ in 0..NARROWINGS {
            let [middle, square, rate] = place;
            let depth = (Interval::point(self.ceiling) - Interval::point(middle.low)).square();
            let square = common(square, Interval { low: -depth.high, high: f64::INFINITY })?;
            let product = positive(middle.square() + square)?;
            let [k, m, _] = self.machine(&[middle, square, rate], product)?;
            let (rate_square, twice) = (rate.square(), delta * m * rate * 2.0);
            let from_pole = (rate + middle).square() + square;
            // N by a, and X by what remains of both equations without k.
            let of_a = a / delta + m * (rate_square + rate * middle * 2.0);
            let product = common(product, k * rate_square / positive(of_a)?)?;
            common(k / product - m, b / (delta * from_pole))?;
            place[MIDDLE] = common(middle, (b / from_pole * rate_square - a) / twice)?;
            place[SQUARE] = common(square, product - place[MIDDLE].square())?;
        }
        Some(place)
    }

    /// The part of a place that the five conditions leave, cut at the end at which the search looks; none where nothing is left.
    ///
    /// A condition that has one sign at this end keeps it as far inside as its derivative allows.
    fn cut(&self, mut place: Place) -> Option<Place> {
        let [a, b, ..] = *self.values;
        let leading = self.leading();
        let [middle, square, rate] = place;
        let [k, m, share] = self.machine(&place, positive(middle.square() + square)?)?;
        let mut variables = [middle, square, rate, self.delta(rate)?, a, b, k, m, share];
        let changing = std::array::from_fn(|i| Changing::variable(variables[i], i));
        let terms = Terms::of(&changing);
        let slopes: [_; CONDITIONS] = std::array::from_fn(|which| terms.condition(which).slopes);
        for _ in 0..CUTS {
            let end = self.end(&place);
            variables[leading] = Interval::point(end);
            let cut_by = |which: usize| {
                let distance = distance_from_zero(&variables, &slopes[which], which);
                let steepest = slopes[which][leading].low.abs().max(slopes[which][leading].high.abs());
                (Interval::point(distance) / Interval::point(steepest)).low
            };
            let cut = (0..CONDITIONS).map(cut_by).fold(0.0, f64::max);
            let width = place[leading].width();
            if cut > width {
                return None;
            }
            let of_leading = &mut place[leading];
            if self.is_greatest {
                of_leading.high = (end - cut).next_up().min(end);
            } else {
                of_leading.low = (end + cut).next_down().max(end);
            }
            // Less than this does not pay.
            if cut < 0.1 * width {
                break;
            }
        }
        Some(place)
    }
}

/// How far a condition is from zero for certain; not positive where it may be zero.
///
/// Variables in which it rises or falls stand at their ends. Others stand in the middle, and change it as their derivatives say.
fn distance_from_zero(
    variables: &[Interval; VARIABLES],
    slopes: &[Interval; VARIABLES],
    which: usize,
) -> f64 {
    let extreme = |is_upper: bool| {
        let mut change = Interval::point(0.0);
        let corner = std::array::from_fn(|i| {
            let (variable, slope) = (variables[i], slopes[i]);
            Interval::point(if slope.low >= 0.0 || slope.high <= 0.0 {
                if (slope.low >= 0.0) == is_upper { variable.high } else { variable.low }
            } else {
                let middle = variable.middle();
                change = change + slope * (variable - Interval::point(middle));
                middle
            })
        });
        Terms::of(&corner).condition(which) + change
    };
    extreme(false).low.max(-extreme(true).high)
}

fn common(one: Interval, other: Interval) -> Option<Interval> {
    let common = Interval { low: one.low.max(other.low), high: one.high.min(other.high) };
    (common.low <= common.high).then_some(common)
}

fn at_most(value: f64) -> Interval {
    Interval { low: f64::NEG_INFINITY, high: value }
}

/// The numbers of an interval that are not negative.
fn positive(interval: Interval) -> Option<Interval> {
    common(interval, Interval { low: 0.0, high: f64::INFINITY })
}

/// Both halves of a place, by the variable that is the widest beside its size.
fn halves(place: &Place) -> [Place; 2] {
    let [middle, square, rate] = *place;
    let largest = |interval: Interval| interval.high.abs().max(interval.low.abs());
    let size = largest(middle).max(largest(square).sqrt());
    let widths = [
        middle.width() / size,
        (signed_root(square.high) - signed_root(square.low)) / size,
        rate.width() / rate.high,
    ];
    let widest = (0..3).fold(MIDDLE, |widest, i| if widths[i] > widths[widest] { i } else { widest });
    let half = place[widest].middle();
    let mut halves = [*place; 2];
    halves[0][widest].high = half;
    halves[1][widest].low = half;
    halves
}

/// √w, or −√(−w).
fn signed_root(square: f64) -> f64 {
    square.abs().sqrt().copysign(square)
}

/// A place by its end at which the search looks.
struct Ranked {
    rank: f64,
    place: Place,
}

impl PartialEq for Ranked {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Ranked {}

impl PartialOrd for Ranked {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ranked {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank.total_cmp(&other.rank)
    }
}
