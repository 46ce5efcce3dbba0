//! A point of a box with nearly the greatest or the least value of a quantity, by 64-bit numbers. Nothing is certain here.
//!
//! Most extremes are at a corner, or near one along an edge. The least of the largest real part is often where a pair and the real root have
//! one real part, or roots meet. No single parameter leads along such a place; differences of other points do (differential evolution,
//! Storn and Price 1997).

use super::root_discs::{RootPart, beside, cubic};
use crate::number::search::golden_section;
use crate::number::split_mix::SplitMix64;
use crate::roots::{Pair, Spectrum, bounded_roots};

/// How often the point is moved along every parameter, how near to the best place, and what gain of the value ends it.
const CLIMBS: u32 = 8;
const NEAR: f64 = 1e-3;
const LEAST_GAIN: f64 = 1e-9;

/// Points of a generation, how many generations there are, the share of a difference, and how often a parameter takes part in it.
const POINTS: usize = 24;
const GENERATIONS: u32 = 120;
const SHARE: f64 = 0.6;
const CROSSING: f64 = 0.8;

type Point = [f64; 7];

/// A search for the greatest value over a box, or for the least.
pub(super) struct Summit {
    /// The ends of the box, in its units.
    pub lower: Point,
    pub upper: Point,
    /// Of what the value is sought.
    pub quantity: RootPart,
    /// Whether the greatest value is sought.
    pub is_greatest: bool,
}

/// A value, negated in a search for the least, and where it is.
type Valued = (f64, Point);

impl Summit {
    /// The best corner, moved along one parameter after another.
    pub(super) fn near_a_corner(&self) -> Point {
        let corner = |bits: u32| {
            self.valued(std::array::from_fn(|i| [self.lower, self.upper][(bits >> i & 1) as usize][i]))
        };
        self.climbed((0..1 << 7).map(corner).fold((f64::NEG_INFINITY, self.lower), better)).1
    }

    /// The best point of some generations, the first of which has a point beside random ones.
    pub(super) fn evolved(&self, from: Point) -> Point {
        let mut random = SplitMix64(1);
        let mut points: [Valued; POINTS] = std::array::from_fn(|_| {
            self.valued(std::array::from_fn(|i| random.between(self.lower[i], self.upper[i])))
        });
        let mut best = self.valued(from);
        points[0] = best;
        for place in (0..GENERATIONS).flat_map(|_| 0..POINTS) {
            let [one, other] = [(); 2].map(|()| points[(random.unit() * POINTS as f64) as usize].1);
            let share = SHARE * (0.5 + random.unit());
            let at = points[place].1;
            let moved = std::array::from_fn(|i| {
                let difference = best.1[i] - at[i] + one[i] - other[i];
                let step = if random.unit() < CROSSING { share * difference } else { 0.0 };
                (at[i] + step).clamp(self.lower[i], self.upper[i])
            });
            points[place] = better(points[place], self.valued(moved));
            best = better(best, points[place]);
        }
        self.climbed(best).1
    }

    /// A point moved along one parameter after another.
    fn climbed(&self, mut best: Valued) -> Valued {
        for _ in 0..CLIMBS {
            let before = best.0;
            for i in 0..7 {
                let [low, high] = [self.lower[i], self.upper[i]];
                let from = best.1;
                let moved = |place: f64| {
                    let mut moved = from;
                    moved[i] = place;
                    self.valued(moved)
                };
                let depth = |place: f64| Some(-moved(place).0);
                let summit = golden_section(depth, (low, high), NEAR * (high - low));
                best = [low, high, summit.unwrap_or(low)].map(moved).into_iter().fold(best, better);
            }
            if best.0 <= before + LEAST_GAIN * before.abs() {
                break;
            }
        }
        best
    }

    /// A point with its value. The imaginary part counts by its square, which is negative for real roots, so that it falls there, too.
    fn valued(&self, point: Point) -> Valued {
        let cubic = cubic(&point);
        let Spectrum { real, pair } = bounded_roots(cubic);
        let [largest, square] = match pair {
            Pair::Real([low, high]) => {
                let half = 0.5 * (high.value - low.value);
                [high.value, -half * half]
            }
            Pair::Complex { re, im } => [re.value, im.value * im.value],
            Pair::NotSeparated => [beside(cubic, real.value)[0], 0.0],
        };
        let value = if self.quantity == RootPart::Real { largest.max(real.value) } else { square };
        (if self.is_greatest { value } else { -value }, point)
    }
}

fn better(one: Valued, other: Valued) -> Valued {
    if other.0 > one.0 { other } else { one }
}

#[cfg(test)]
mod tests {
    use super::super::root_discs::RootDiscs;
    use super::*;
    use crate::number::Interval;

    /// Boxes around a laboratory's slider, with ends up to a factor of three apart.
    fn any_box(random: &mut SplitMix64) -> [Point; 2] {
        let lower = [0.01, 0.014, 1.0, 0.005, 1e-4, 1.0, 1.0]
            .map(|x: f64| x * libm::exp10(2.0 * random.unit() - 1.0));
        [lower, lower.map(|low| low * (1.0 + 2.0 * random.unit()))]
    }

    #[test]
    fn no_random_point_is_better_and_values_are_those_of_the_roots() {
        let mut random = SplitMix64(3);
        let mut evolved_further = 0;
        for round in 0..40 {
            let [lower, upper] = any_box(&mut random);
            for (quantity, is_greatest) in
                [RootPart::Real, RootPart::Imaginary].into_iter().flat_map(|q| [(q, false), (q, true)])
            {
                let summit = Summit { lower, upper, quantity, is_greatest };
                let near = summit.near_a_corner();
                let found = summit.evolved(near);
                let in_box = |point: &Point| (0..7).all(|i| lower[i] <= point[i] && point[i] <= upper[i]);
                assert!(in_box(&near) && in_box(&found));
                let best = summit.valued(found).0;
                evolved_further += u32::from(best > summit.valued(near).0 + 1e-3 * best.abs());
                for _ in 0..500 {
                    let point = std::array::from_fn(|i| random.between(lower[i], upper[i]));
                    let value = summit.valued(point).0;
                    assert!(
                        value <= best + 1e-9 * best.abs(),
                        "{round} {quantity:?} {is_greatest} {point:?}"
                    );
                    let roots = RootDiscs::of(&point.map(Interval::point)).unwrap().largest(quantity);
                    let value = if is_greatest { value } else { -value };
                    let value = if quantity == RootPart::Real { value } else { value.max(0.0).sqrt() };
                    assert!(
                        roots.low - 1e-6 * value.abs() <= value && value <= roots.high + 1e-6 * value.abs()
                    );
                }
            }
        }
        // Single parameters do not always lead there.
        assert!(evolved_further > 0);
    }
}
