//! Coefficients of Taylor series in time with their derivatives by the initial state, as intervals.
//!
//! Lane 0 holds the value, the others its derivatives. Centres and radii lie apart, so that machines compute all lanes at once.

use std::ops::{Add, Neg, Sub};

use crate::interval::{Interval, UNIT, generously_up};

/// A value and its L − 1 derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lanes<const L: usize> {
    pub mid: [f64; L],
    pub rad: [f64; L],
}

impl<const L: usize> Lanes<L> {
    pub const ZERO: Self = Self { mid: [0.0; L], rad: [0.0; L] };

    /// From intervals.
    pub fn new(lanes: [Interval; L]) -> Self {
        Self { mid: lanes.map(|lane| lane.mid), rad: lanes.map(|lane| lane.rad) }
    }

    /// A value whose derivatives are the multiples `slope` of those of another quantity.
    pub fn following(value: Interval, slope: Interval, other: &Self) -> Self {
        Self::new(std::array::from_fn(|l| if l == 0 { value } else { slope * other.lane(l) }))
    }

    /// One lane.
    #[inline(always)]
    pub const fn lane(&self, l: usize) -> Interval {
        Interval { mid: self.mid[l], rad: self.rad[l] }
    }

    /// The same interval in all lanes.
    #[inline(always)]
    pub const fn all(value: Interval) -> Self {
        Self { mid: [value.mid; L], rad: [value.rad; L] }
    }

    /// Each lane times the same lane of another: no derivative of a product.
    #[inline(always)]
    pub fn times(mut self, by: &Self) -> Self {
        for l in 0..L {
            let lane = self.lane(l) * by.lane(l);
            (self.mid[l], self.rad[l]) = (lane.mid, lane.rad);
        }
        self
    }

    /// All lanes times one interval that does not depend on the initial state.
    #[inline(always)]
    pub fn scaled(self, by: Interval) -> Self {
        self.times(&Self::all(by))
    }

    /// The same with another number added to the value.
    pub fn plus(&self, value: Interval) -> Self {
        let mut sum = *self;
        let first = self.lane(0) + value;
        (sum.mid[0], sum.rad[0]) = (first.mid, first.rad);
        sum
    }
}

// Loops rather than closures, which the compiler leaves as calls.
impl<const L: usize> Add for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        for l in 0..L {
            let lane = self.lane(l) + other.lane(l);
            (self.mid[l], self.rad[l]) = (lane.mid, lane.rad);
        }
        self
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for mid in &mut self.mid {
            *mid = -*mid;
        }
        self
    }
}

impl<const L: usize> Sub for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// A coefficient with what its products take from it, made once: a series of n coefficients has n²/2 products.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factor<const L: usize> {
    all: Lanes<L>,
    /// The derivatives: zero in lane 0, so that all lanes of a product are the same operations.
    tail: Lanes<L>,
    /// |centre| + radius.
    reach: [f64; L],
}

impl<const L: usize> Factor<L> {
    pub const ZERO: Self = Self { all: Lanes::ZERO, tail: Lanes::ZERO, reach: [0.0; L] };
}

impl<const L: usize> From<Lanes<L>> for Factor<L> {
    #[inline(always)]
    fn from(all: Lanes<L>) -> Self {
        let (mut tail, mut reach) = (all, all.rad);
        (tail.mid[0], tail.rad[0]) = (0.0, 0.0);
        for (reach, mid) in reach.iter_mut().zip(&all.mid) {
            *reach += mid.abs();
        }
        Self { all, tail, reach }
    }
}

/// Coefficient k of the product of two series: Σ a_i b_{k−i}.
///
/// A lane is a b' + a' b, where lane 0 stands for b' and zero for a'. A sum of n products of centres in any order errs by at most
/// n u/(1 − n u) of the sum of their sizes; 2k + 4 counts the products and the roundings of each derivative.
#[inline(always)]
pub(super) fn product<const L: usize>(a: &[Factor<L>], b: &[Factor<L>], k: usize) -> Lanes<L> {
    let (mut mid, mut size, mut rad) = ([0.0; L], [0.0; L], [0.0; L]);
    let (a, b) = (&a[..=k], &b[..=k]);
    // One lane has no derivatives. In two loops, since the compiler mixes the lanes of one.
    for (a, b) in a.iter().zip(b.iter().rev()) {
        let (am, bm) = (a.all.mid[0], b.all.mid[0]);
        for l in 0..L {
            let along = am * b.all.mid[l];
            let across = a.tail.mid[l] * bm;
            mid[l] += if L == 1 { along } else { along + across };
            size[l] += if L == 1 { along.abs() } else { along.abs() + across.abs() };
        }
    }
    for (a, b) in a.iter().zip(b.iter().rev()) {
        let (am, ar, br, b_reach) = (a.all.mid[0].abs(), a.all.rad[0], b.all.rad[0], b.reach[0]);
        for (l, rad) in rad.iter_mut().enumerate() {
            let along = am * b.all.rad[l] + ar * b.reach[l];
            let across = a.tail.mid[l].abs() * br;
            *rad += if L == 1 { along } else { along + across + a.tail.rad[l] * b_reach };
        }
    }
    let units = (2 * k + 4) as f64 * UNIT;
    for (rad, size) in rad.iter_mut().zip(size) {
        *rad = generously_up(*rad + units * size);
    }
    Lanes { mid, rad }
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::tests::exact::{exact, holds};
    use slipmode_core::number::split_mix::SplitMix64;

    /// Σ a_i b_{k−i} and its derivatives Σ a_i b'_{k−i} + a'_i b_{k−i}, exactly, at ends of all intervals; also of points, where rounding is all.
    #[test]
    fn a_product_of_series_holds_the_exact_one() {
        let mut random = SplitMix64(13);
        for case in 0..400 {
            let mut number = || 2.0 * random.unit() - 1.0;
            let k = case % 23;
            // Only some of the four radii are not zero: values and derivatives of both factors.
            let of = |bit: usize| if case >> bit & 1 == 0 { 0.0 } else { 0.1 };
            let mut series = |of_value: f64, of_slope: f64| -> Vec<Lanes<3>> {
                let lane = |number: &mut dyn FnMut() -> f64, l: usize| Interval {
                    mid: number(),
                    rad: if l == 0 { of_value } else { of_slope },
                };
                (0..=k).map(|_| Lanes::new([0, 1, 2].map(|l| lane(&mut number, l)))).collect()
            };
            let (a, b) = (series(of(0), of(1)), series(of(2), of(3)));
            let factors = |series: &[Lanes<3>]| -> Vec<Factor<3>> {
                series.iter().map(|&lanes| lanes.into()).collect()
            };
            let found = product(&factors(&a), &factors(&b), k);
            let values = |series: &[Lanes<3>]| -> Vec<Factor<1>> {
                series.iter().map(|c| Lanes::new([c.lane(0)]).into()).collect()
            };
            let alone = product(&values(&a), &values(&b), k).lane(0);
            // Each interval at the end that makes a lane largest, or smallest.
            for (lane, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)] {
                let end = |c: Interval, by: f64| {
                    exact(c.mid) + exact(c.rad) * exact(if by * sign > 0.0 { 1.0 } else { -1.0 })
                };
                let sign_of = |value: &Rational| if *value > 0 { 1.0 } else { -1.0 };
                let mut sum = Rational::new();
                for i in 0..=k {
                    let (first, second) = (&a[i], &b[k - i]);
                    if lane == 0 {
                        let x = end(first.lane(0), second.lane(0).mid);
                        sum += x.clone() * end(second.lane(0), sign_of(&x));
                    } else {
                        let x = end(first.lane(0), second.lane(lane).mid);
                        let y = end(second.lane(0), first.lane(lane).mid);
                        let along = end(second.lane(lane), sign_of(&x));
                        let across = end(first.lane(lane), sign_of(&y));
                        sum += x * along + across * y;
                    }
                }
                assert!(holds(found.lane(lane), &sum), "{case} {lane} {sign} {:?}", found.lane(lane));
                assert!(lane > 0 || holds(alone, &sum), "{case} {sign} {alone:?}");
            }
        }
    }

    /// Sums in which every rounding is in the same direction: 1 + Σ of numbers that are each rounded away.
    #[test]
    fn roundings_in_one_direction_are_enclosed() {
        const K: usize = 22;
        let lost = 0.95 * UNIT;
        let sum = exact(1.0) + exact(lost) * Rational::from(K);
        let ones = [Factor::<1>::from(Lanes::new([Interval::ONE])); K + 1];
        let mut small = [Factor::from(Lanes::new([Interval::point(lost)])); K + 1];
        small[K] = Lanes::new([Interval::ONE]).into();
        assert!(holds(product(&ones, &small, K).lane(0), &sum));
        // The same in a derivative of either factor.
        let derivative = |value: f64| Factor::<2>::from(Lanes::new([Interval::ZERO, Interval::point(value)]));
        let ones = [Factor::<2>::from(Lanes::new([Interval::ONE, Interval::ZERO])); K + 1];
        let mut small = [derivative(lost); K + 1];
        small[K] = derivative(1.0);
        assert!(holds(product(&ones, &small, K).lane(1), &sum));
        small.reverse();
        assert!(holds(product(&small, &ones, K).lane(1), &sum));
    }

    /// Sums, multiples, additions to the value and chains keep the errors of all lanes.
    #[test]
    fn lanes_keep_their_errors() {
        let around = |mid: f64| Interval { mid, rad: 0.25 };
        let (a, b) = (Lanes::new([around(1.0), around(-2.0)]), Lanes::new([around(0.5), around(3.0)]));
        let holds = |c: Interval, ends: [f64; 2]| ends.iter().all(|&end| c.may_contain(end));
        let (sum, difference, times) = (a + b, a - b, a.times(&b));
        assert!(holds(sum.lane(0), [1.0, 2.0]) && holds(sum.lane(1), [0.5, 1.5]));
        assert!(holds(difference.lane(0), [0.0, 1.0]) && holds(difference.lane(1), [-5.5, -4.5]));
        assert!(holds(times.lane(0), [0.1875, 0.9375]) && holds(times.lane(1), [-7.3125, -4.8125]));
        let scaled = a.scaled(around(2.0));
        assert!(holds(scaled.lane(0), [1.3125, 2.8125]) && holds(scaled.lane(1), [-5.0625, -3.0625]));
        let plus = a.plus(around(1.0));
        assert!(holds(plus.lane(0), [1.5, 2.5]) && plus.lane(1) == a.lane(1));
        let following = Lanes::following(around(7.0), around(2.0), &a);
        assert!(following.lane(0) == around(7.0) && holds(following.lane(1), [-5.0625, -3.0625]));
    }
}
