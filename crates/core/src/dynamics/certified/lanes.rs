//! Coefficients of Taylor series in time with their derivatives by the initial state, as intervals.
//!
//! Lane 0 holds the value, the others its derivatives. Centres and radii lie apart, so that machines compute all lanes at once.

use std::ops::{Add, Neg, Sub};

use super::interval::{Interval, UNIT, generously_up, up};

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

    /// All lanes times one interval that does not depend on the initial state.
    #[inline(always)]
    pub fn scaled(&self, by: Interval) -> Self {
        Self::new(std::array::from_fn(|l| self.lane(l) * by))
    }

    /// The same with another number added to the value.
    pub fn plus(&self, value: Interval) -> Self {
        let mut sum = *self;
        let first = self.lane(0) + value;
        (sum.mid[0], sum.rad[0]) = (first.mid, first.rad);
        sum
    }
}

impl<const L: usize> Add for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mid: [f64; L] = std::array::from_fn(|l| self.mid[l] + other.mid[l]);
        let rad = std::array::from_fn(|l| up(self.rad[l] + other.rad[l] + UNIT * mid[l].abs()));
        Self { mid, rad }
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { mid: self.mid.map(|mid| -mid), rad: self.rad }
    }
}

impl<const L: usize> Sub for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Coefficient k of the product of two series: Σ a_i b_{k−i}.
///
/// A sum of n products of centres in any order errs by at most n u/(1 − n u) of the sum of their sizes; 2k + 4 counts the products
/// and the roundings of each derivative.
#[inline(always)]
pub(super) fn product<const L: usize>(a: &[Lanes<L>], b: &[Lanes<L>], k: usize) -> Lanes<L> {
    let (mut mid, mut size, mut rad) = ([0.0; L], [0.0; L], [0.0; L]);
    for i in 0..=k {
        let (a, b) = (&a[i], &b[k - i]);
        let (am, ar, bm, br) = (a.mid[0], a.rad[0], b.mid[0], b.rad[0]);
        // a b' + a' b, where lane 0 stands for b' and zero for a': the same operations in all lanes.
        let (mut am_lane, mut ar_lane) = (a.mid, a.rad);
        (am_lane[0], ar_lane[0]) = (0.0, 0.0);
        for l in 0..L {
            let (a_mid, a_rad, b_mid, b_rad) = (am_lane[l], ar_lane[l], b.mid[l], b.rad[l]);
            mid[l] += am * b_mid + a_mid * bm;
            size[l] += am.abs() * b_mid.abs() + a_mid.abs() * bm.abs();
            rad[l] +=
                am.abs() * b_rad + ar * (b_mid.abs() + b_rad) + a_mid.abs() * br + a_rad * (bm.abs() + br);
        }
    }
    let units = (2 * k + 4) as f64 * UNIT;
    Lanes { mid, rad: std::array::from_fn(|l| generously_up(rad[l] + units * size[l])) }
}
