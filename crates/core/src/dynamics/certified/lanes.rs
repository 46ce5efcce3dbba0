//! Coefficients of Taylor series in time with their derivatives by the initial state, as intervals.
//!
//! Lane 0 holds the value, the others its derivatives. Centres and radii lie apart, so that machines compute all lanes at once.

use std::ops::{Add, Neg, Sub};

use super::interval::{Interval, UNIT, generously_up};

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
