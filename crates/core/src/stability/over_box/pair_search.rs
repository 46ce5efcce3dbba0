//! Which two numbers are roots of eq 8 for some point of a box, and bounds of the largest real and imaginary part over the box.
//!
//! Two roots with the sum 2X and the product N > 0, r = V0/D_c, δ = D_c/σ and Q = N + r² + 2rX: eq 8 is
//! a = δ (r² k/N − m r (r + 2X)) and b = δ Q (k/N − m); the third root is −r k/(m N). For given X, N and r, the pairs (a/δ, b/δ) of a box are a
//! polygon, and those of all k and m a parallelogram. They meet unless a side of one of them divides them, so that five conditions decide
//! whether these are roots for some point with this r. A search over two roots and r has three dimensions in the place of seven.
//!
//! Only points with an extreme value count, and such a point has most parameters at their ends ([`super::extreme_point`]): over a place they are
//! set there. Where all are, one point remains, whose roots are found.
//!
//! A pair X ± i√w is known by X and w. Of three real roots the upper two are known by themselves: where they lie decades apart, half of their
//! sum says nothing of the larger one.

use std::collections::BinaryHeap;

use super::corners::{A, B};
use super::extreme_point::Known;
use super::pair_conditions::{CONDITIONS, Slopes, Terms, TwoRoots, VARIABLES};
use super::pair_point::point_with;
use super::ranked::Ranked;
use super::root_discs::{RootDiscs, RootPart, Values, cubic, value_at};
use crate::number::Interval;

/// How often the end of a place is cut.
const CUTS: u32 = 2;
/// How much of what the other variables can change counts against a cut that is tried.
const EFFECT: f64 = 0.5;
/// A cut below this part of a place does not pay.
const LEAST_CUT: f64 = 0.2;

/// After so many places a search is content with less.
pub(super) const FEW: usize = 64;

/// What is known of a value that is looked for in a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::stability) enum Sought {
    /// No point has it.
    Nowhere,
    /// Some point has it.
    Somewhere,
    /// Not decided.
    Unknown,
}

/// A search for the greatest or the least value of a quantity; for the least frequency only where all points oscillate.
#[derive(Debug, Clone, Copy)]
pub(super) struct PairSearch<'v> {
    /// The lower and the upper ends of the box.
    pub lower: &'v Values,
    pub upper: &'v Values,
    /// Which quantity.
    pub quantity: RootPart,
    /// Whether its greatest value is sought.
    pub is_greatest: bool,
    /// Points with a largest real part above it are left out.
    pub ceiling: f64,
    /// The most places that are halved.
    pub most: usize,
}

/// Values of two roots, as their kind says, and of r.
#[derive(Debug, Clone, Copy)]
struct RootPlace {
    kind: TwoRoots,
    values: [Interval; 3],
    /// The parameters that a point with an extreme value can have there.
    parameters: Values,
    /// The value, where only one point remains.
    value: Option<Interval>,
}

/// X, or the largest root.
const FIRST: usize = 0;
/// w, or the second largest root.
const SECOND: usize = 1;
const RATE: usize = 2;

impl PairSearch<'_> {
    /// A value that no point of the box passes, and one that is attained. The search ends where the two are as near as `near`, or, after a few
    /// places, as `far`.
    pub(super) fn bound(&self, attained: f64, [near, far]: [f64; 2]) -> [f64; 2] {
        let outward = |value: f64| if self.is_greatest { value } else { -value };
        let (mut attained, mut bound) = (outward(attained), f64::NEG_INFINITY);
        let ranked = |place: RootPlace| Ranked { rank: outward(self.bound_over(&place)), of: place };
        let mut open: BinaryHeap<_> = self.whole().into_iter().flatten().map(ranked).collect();
        for halved in 0..self.most {
            let gap = if halved < FEW { near } else { far };
            if open.peek().is_none_or(|first| first.rank <= attained + gap) {
                break;
            }
            let Some(Ranked { rank, of: place }) = open.pop() else { break };
            if let Some(value) = place.value {
                attained = attained.max(if self.is_greatest { value.low } else { -value.high });
                bound = bound.max(rank);
                continue;
            }
            let left = place.halves().into_iter().filter_map(|half| self.reduced(half)).map(ranked);
            open.extend(left.filter(|half| half.rank > attained));
        }
        bound = open.peek().map_or(bound, |first| first.rank.max(bound)).max(attained);
        [bound, attained].map(outward)
    }

    /// Whether a point of the box is below the ceiling.
    pub(super) fn has_points(&self) -> Sought {
        let ranked = |place: RootPlace| Ranked { rank: -self.bound_over(&place), of: place };
        let (mut open, mut places) = (BinaryHeap::new(), self.whole());
        for _ in 0..=self.most {
            for place in places.into_iter().flatten() {
                if self.has_point_in(&place) {
                    return Sought::Somewhere;
                }
                if place.value.is_none_or(|value| value.low <= self.ceiling) {
                    open.push(ranked(place));
                }
            }
            let Some(Ranked { of: place, .. }) = open.pop() else { return Sought::Nowhere };
            if place.value.is_some() {
                // Its value and the ceiling are the same to rounding.
                return Sought::Unknown;
            }
            places = place.halves().map(|half| self.reduced(half));
        }
        Sought::Unknown
    }

    /// Whether the point that remains of a place, or one with its middle values, is below the ceiling, for certain.
    fn has_point_in(&self, place: &RootPlace) -> bool {
        let value = place.value.or_else(|| {
            let middle = place.values.map(Interval::middle);
            let point = point_with(&place.parameters, place.kind, &middle, self.ceiling)?;
            value_at(RootPart::Real, &point, [self.lower, self.upper])
        });
        value.is_some_and(|value| value.high <= self.ceiling)
    }

    /// The part of a place where a point with an extreme value may have its roots.
    fn reduced(&self, place: RootPlace) -> Option<RootPlace> {
        let narrowed = self.narrowed(place)?;
        let settled = self.settled(narrowed)?;
        if settled.value.is_some() {
            return Some(settled);
        }
        let is_changed = settled.parameters != narrowed.parameters;
        self.cut(if is_changed { self.narrowed(settled)? } else { settled })
    }

    /// k, m and m N/k over a place. The third root, −r k/(m N), is below the ceiling, and below the other two where these are real; and both
    /// equations leave m N/k = 1 − b N/(δ Q k) = (r² − a N/(δ k))/(r² + 2rX).
    fn machine(
        &self,
        place: &RootPlace,
        [sum, product]: [Interval; 2],
        delta: Interval,
    ) -> Option<[Interval; 3]> {
        let [a, b, _, k, m, _, _] = place.parameters;
        let rate = place.values[RATE];
        let mut share = m / k * product;
        let ceiling = match place.kind {
            TwoRoots::Pair => self.ceiling,
            TwoRoots::Real => self.ceiling.min(place.values[SECOND].high),
        };
        if ceiling < 0.0 {
            share = common(share, at_most((rate / Interval::point(-ceiling)).high))?;
        }
        let from_machine = product / (delta * k);
        share =
            common(share, Interval::point(1.0) - b * from_machine / place.kind.pole_product(&place.values))?;
        share = common(share, (rate.square() - a * from_machine) / (rate * (rate + sum)))?;
        let stiffness = common(k, m * product / share)?;
        let mass = common(m, stiffness * share / product)?;
        Some([stiffness, mass, share])
    }

    /// The variable with which the quantity changes most.
    const fn leading(&self) -> usize {
        if matches!(self.quantity, RootPart::Real) { FIRST } else { SECOND }
    }

    /// The end of that variable at which the search looks.
    fn end(&self, place: &RootPlace) -> f64 {
        let leading = place.values[self.leading()];
        if self.is_greatest { leading.high } else { leading.low }
    }

    /// A value that the quantity does not pass over a place.
    fn bound_over(&self, place: &RootPlace) -> f64 {
        if let Some(value) = place.value {
            return if self.is_greatest { value.high } else { value.low };
        }
        let [first, second, rate] = place.values;
        let value = match (self.quantity, place.kind) {
            (RootPart::Imaginary, _) => second.square_root(),
            (RootPart::Real, TwoRoots::Real) => first,
            (RootPart::Real, TwoRoots::Pair) => {
                let sum_and_product = place.kind.sum_and_product(&place.values);
                let machine = place.delta().and_then(|delta| self.machine(place, sum_and_product, delta));
                let third = machine.map_or(Interval::LINE, |[.., share]| -(rate / share));
                Interval { low: first.low.max(third.low), high: first.high.max(third.high.min(0.0)) }
            }
        };
        if self.is_greatest { value.high } else { value.low }
    }

    /// All places: a pair is slower than the slider on its spring alone, the third root is negative, and no root is beyond twice the
    /// greatest of c2/c3, √(|c1|/c3) and ∛(c0/c3). Real roots have no imaginary part. Where discs part one root from the others, these are
    /// known better.
    fn whole(&self) -> [Option<RootPlace>; 2] {
        let parameters: Values = std::array::from_fn(|i| self.lower[i].hull(self.upper[i]));
        let [.., d, k, m, _, v] = parameters;
        let [c0, c1, c2, c3] = cubic(&parameters);
        let size = |coefficient: Interval| (coefficient / c3).high.max(-(coefficient / c3).low).next_up();
        let reach = 2.0 * size(c2).max(size(c1).sqrt()).max(libm::cbrt(size(c0))).next_up();
        let within = Interval { low: -reach, high: reach };
        let of_kind = move |kind, [first, second]: [Interval; 2]| {
            let values = [first, second, v / d];
            RootPlace { kind, values, parameters, value: None }
        };
        let parted = RootDiscs::of(&parameters).and_then(|discs| discs.others);
        let [half_sum, square] = parted.unwrap_or([Interval::LINE; 2]);
        let slowest = common(Interval { low: -0.5 * size(c2), high: reach }, half_sum);
        let pair = slowest.zip(common(Interval { low: 0.0, high: (k / m).high }, -square));
        let pair = pair.map(|(x, w)| of_kind(TwoRoots::Pair, [x, w]));
        let has_real = self.quantity == RootPart::Real && square.high >= 0.0;
        let real = has_real.then(|| of_kind(TwoRoots::Real, [within; 2]));
        [pair, real].map(|place| self.reduced(place?))
    }

    /// The place with the parameters at their ends that a point with an extreme value has there; none where it has no such point.
    fn settled(&self, mut place: RootPlace) -> Option<RootPlace> {
        let [first, second, rate] = place.values;
        let [sum, product] = place.kind.sum_and_product(&place.values);
        let delta = place.delta()?;
        let [stiffness, mass, share] = self.machine(&place, [sum, positive(product)?], delta)?;
        let of_place = place.parameters;
        let friction = [of_place[A], of_place[B]];
        let known = Known { roots: [first, second], rate, delta, friction, stiffness, mass, share };
        let effects = self.effects(place.kind, &known);
        for (i, value) in place.parameters.iter_mut().enumerate() {
            let [mut rises, mut falls] = [effects.iter().any(Option::is_some); 2];
            for effects in effects.iter().flatten() {
                rises &= effects[i].low > 0.0;
                falls &= effects[i].high < 0.0;
            }
            if self.lower[i] != self.upper[i] && (rises || falls) {
                *value =
                    common(*value, if rises == self.is_greatest { self.upper[i] } else { self.lower[i] })?;
            }
        }
        let is_changed = place.parameters != of_place;
        if let Some(discs) = is_changed.then(|| RootDiscs::of(&place.parameters)).flatten() {
            if let (TwoRoots::Pair, Some([half_sum, square])) = (place.kind, discs.others) {
                place.values[FIRST] = common(place.values[FIRST], half_sum)?;
                place.values[SECOND] = common(place.values[SECOND], -square)?;
            }
            let is_one_point = (0..7).all(|i| [self.lower[i], self.upper[i]].contains(&place.parameters[i]));
            place.value = is_one_point.then(|| discs.largest(self.quantity));
        }
        Some(place)
    }

    /// What a parameter has to change, all in the same sense, so that no extreme value is where it can still be moved.
    ///
    /// Where the least growth is that of a double root, the pair may become two real roots there, too. A greatest value at a double root is that
    /// of two real roots.
    fn effects(&self, kind: TwoRoots, known: &Known) -> [Option<Values>; 3] {
        let ([first, second], third) = (known.roots, known.third());
        let may_be_double = !self.is_greatest && second.low <= 0.0;
        match (self.quantity, kind) {
            (RootPart::Imaginary, _) => [Some(known.effects_on_imaginary_part()), None, None],
            (RootPart::Real, TwoRoots::Real) => [Some(known.effects_on_real_root(first)), None, None],
            (RootPart::Real, TwoRoots::Pair) => {
                let (may_be_pair, may_be_third) = (third.low <= first.high, third.high >= first.low);
                [
                    may_be_pair.then(|| known.effects_on_real_part()),
                    (may_be_pair && may_be_double).then(|| known.effects_on_real_root(first)),
                    may_be_third.then(|| known.effects_on_real_root(third)),
                ]
            }
        }
    }

    /// The part of a place that the ceiling and each equation alone leave; none where no numbers of it are roots.
    fn narrowed(&self, mut place: RootPlace) -> Option<RootPlace> {
        let [a, b, ..] = place.parameters;
        let rate = place.values[RATE];
        let delta = place.delta()?;
        place.values[FIRST] = common(place.values[FIRST], at_most(self.ceiling))?;
        place = place.in_order()?;
        let [sum, product] = place.kind.sum_and_product(&place.values);
        let product = positive(product)?;
        let [k, m, _] = self.machine(&place, [sum, product], delta)?;
        let rate_square = rate.square();
        let from_pole = place.kind.pole_product(&place.values);
        // N by a, and 2X by what remains of both equations without k.
        let of_a = a / delta + m * (rate_square + rate * sum);
        let product = common(product, k * rate_square / positive(of_a)?)?;
        let sum = common(sum, (b / from_pole * rate_square - a) / (delta * m * rate))?;
        place.with(sum, product)
    }

    /// The part of a place that the five conditions leave, cut at the end at which the search looks; none where nothing is left.
    ///
    /// A condition that has one sign at this end keeps it as far inside as its derivative allows.
    fn cut(&self, mut place: RootPlace) -> Option<RootPlace> {
        let [a, b, ..] = place.parameters;
        let leading = self.leading();
        let [first, second, rate] = place.values;
        let [sum, product] = place.kind.sum_and_product(&place.values);
        let delta = place.delta()?;
        let [k, m, share] = self.machine(&place, [sum, positive(product)?], delta)?;
        let mut variables = [first, second, rate, delta, a, b, k, m, share];
        let of_place = variables;
        let slopes = Slopes::of(place.kind, &of_place);
        for _ in 0..CUTS {
            let end = self.end(&place);
            variables[leading] = Interval::point(end);
            let width = place.values[leading].width();
            let mut cut = 0.0;
            for (which, likely) in likely_cuts(place.kind, &variables, leading) {
                if likely <= f64::max(cut, LEAST_CUT * width) {
                    break;
                }
                cut = cut.max(certain_cut(&slopes, place.kind, &variables, leading, which));
            }
            if cut > width {
                return None;
            }
            let of_leading = &mut place.values[leading];
            if self.is_greatest {
                of_leading.high = (end - cut).next_up().min(end);
            } else {
                of_leading.low = (end + cut).next_down().max(end);
            }
            if cut < LEAST_CUT * width {
                break;
            }
        }
        Some(place)
    }
}

/// How far inside each condition is likely to keep its sign, the farthest first: by its value and derivatives in the middle.
fn likely_cuts(
    kind: TwoRoots,
    variables: &[Interval; VARIABLES],
    leading: usize,
) -> [(usize, f64); CONDITIONS] {
    let middle = variables.map(Interval::middle);
    let slopes = Slopes::of(kind, &middle);
    let mut likely = std::array::from_fn(|which| {
        let by_each = slopes.condition(which);
        let others = (0..VARIABLES).filter(|i| *i != leading);
        let effect: f64 = others.map(|i| by_each[i].abs() * 0.5 * variables[i].width()).sum();
        let margin = slopes.terms.condition(which).abs() - EFFECT * effect;
        (which, margin / by_each[leading].abs())
    });
    likely.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    likely
}

/// How far inside a condition keeps the sign that it has at an end, for certain: not farther than its derivative allows.
fn certain_cut(
    slopes: &Slopes<'_, Interval>,
    kind: TwoRoots,
    at_end: &[Interval; VARIABLES],
    leading: usize,
    which: usize,
) -> f64 {
    let slopes = slopes.condition(which);
    let steepest = Interval::point(slopes[leading].low.abs().max(slopes[leading].high.abs()));
    let middle = at_end.map(|variable| Interval::point(variable.middle()));
    let is_positive = Terms::of(kind, &middle).condition(which).low > 0.0;
    let nearest = extreme(kind, at_end, &slopes, which, !is_positive);
    let distance = if is_positive { nearest.low } else { -nearest.high };
    (Interval::point(distance) / steepest).low
}

/// The least or the greatest value of a condition, enclosed.
///
/// Variables in which it rises or falls stand at their ends, one after the other: with some there, the derivatives by others are narrower.
/// The rest stand in the middle, and change it as their derivatives say.
fn extreme(
    kind: TwoRoots,
    variables: &[Interval; VARIABLES],
    slopes: &[Interval; VARIABLES],
    which: usize,
    is_upper: bool,
) -> Interval {
    let (mut corner, mut slopes) = (*variables, *slopes);
    loop {
        let mut is_changed = false;
        for (variable, slope) in corner.iter_mut().zip(slopes) {
            if variable.low < variable.high && (slope.low >= 0.0 || slope.high <= 0.0) {
                let end = if (slope.low >= 0.0) == is_upper { variable.high } else { variable.low };
                *variable = Interval::point(end);
                is_changed = true;
            }
        }
        let is_point = corner.iter().all(|variable| variable.low == variable.high);
        if is_point || !is_changed {
            break;
        }
        slopes = Slopes::of(kind, &corner).condition(which);
    }
    let mut change = Interval::point(0.0);
    let middle = std::array::from_fn(|i| {
        let middle = if corner[i].low == corner[i].high { corner[i].low } else { corner[i].middle() };
        change = change + slopes[i] * (corner[i] - Interval::point(middle));
        Interval::point(middle)
    });
    Terms::of(kind, &middle).condition(which) + change
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

impl RootPlace {
    /// D_c/σ where V0/D_c has the values of the rate.
    fn delta(&self) -> Option<Interval> {
        let [_, _, d, _, _, s, v] = self.parameters;
        Some(common(d, v / self.values[RATE])? / s)
    }

    /// The part where the first of two real roots is the larger one.
    fn in_order(mut self) -> Option<Self> {
        if self.kind == TwoRoots::Real {
            let [first, second, _] = self.values;
            self.values[FIRST].low = first.low.max(second.low);
            self.values[SECOND] = common(second, at_most(first.high))?;
        }
        Some(self)
    }

    /// The part with such a sum and product of the roots.
    fn with(mut self, sum: Interval, product: Interval) -> Option<Self> {
        let [first, second] = &mut self.values[..RATE] else { return None };
        match self.kind {
            TwoRoots::Pair => {
                *first = common(*first, sum * 0.5)?;
                *second = common(*second, product - first.square())?;
            }
            TwoRoots::Real => {
                *first = common(common(*first, sum - *second)?, product / *second)?;
                *second = common(common(*second, sum - *first)?, product / *first)?;
            }
        }
        Some(self)
    }

    /// Both halves, by the variable that is the widest beside its size.
    fn halves(&self) -> [Self; 2] {
        let [first, second, rate] = self.values;
        let largest = |interval: Interval| interval.high.abs().max(interval.low.abs());
        let widths = match self.kind {
            TwoRoots::Pair => {
                let size = largest(first).max(second.high.sqrt());
                [first.width() / size, (second.high.sqrt() - second.low.sqrt()) / size]
            }
            TwoRoots::Real => [first, second].map(|root| root.width() / largest(root)),
        };
        let widths = [widths[0], widths[1], rate.width() / rate.high];
        let widest = (0..3).fold(FIRST, |widest, i| if widths[i] > widths[widest] { i } else { widest });
        let half = between(self.values[widest]);
        let mut halves = [*self; 2];
        halves[0].values[widest].high = half;
        halves[1].values[widest].low = half;
        halves
    }
}

/// A number inside: by its logarithm where the ends lie far apart.
fn between(interval: Interval) -> f64 {
    let Interval { low, high } = interval;
    let is_far = low * high > 0.0 && (low.abs() > 4.0 * high.abs() || high.abs() > 4.0 * low.abs());
    if is_far { (low.abs().sqrt() * high.abs().sqrt()).copysign(low) } else { interval.middle() }
}
