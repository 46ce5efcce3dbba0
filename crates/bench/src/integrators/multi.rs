//! An MPFR number of fixed precision as a [`Scalar`], for reference trajectories.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::Float;

use slipmode_core::dynamics::Scalar;
use slipmode_core::number::{Field, Real};

/// A floating-point number with `BITS` bits of significand.
#[derive(Debug, Clone, PartialEq)]
pub struct Multi<const BITS: u32>(Float);

macro_rules! operator {
    ($trait:ident, $method:ident, $symbol:tt) => {
        impl<const BITS: u32> $trait for Multi<BITS> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0 $symbol other.0)
            }
        }
        impl<'r, const BITS: u32> $trait<&'r Self> for Multi<BITS> {
            type Output = Self;
            fn $method(self, other: &'r Self) -> Self {
                Self(self.0 $symbol &other.0)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl<const BITS: u32> Neg for Multi<BITS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const BITS: u32> From<i32> for Multi<BITS> {
    fn from(value: i32) -> Self {
        Self(Float::with_val(BITS, value))
    }
}

impl<const BITS: u32> PartialOrd for Multi<BITS> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl<const BITS: u32> Field for Multi<BITS> {}

impl<const BITS: u32> Real for Multi<BITS> {
    fn sqrt(&self) -> Self {
        Self(self.0.clone().sqrt())
    }
}

impl<const BITS: u32> Scalar for Multi<BITS> {
    // A power of two by repeated halving: the exponent stays in range up to 1000 bits.
    const UNIT_ROUNDOFF: f64 = {
        let mut unit = 1.0;
        let mut bit = 0;
        while bit < BITS {
            unit *= 0.5;
            bit += 1;
        }
        unit
    };

    fn from_f64(value: f64) -> Self {
        Self(Float::with_val(BITS, value))
    }

    fn from_float(value: &Float) -> Self {
        Self(Float::with_val(BITS, value))
    }

    fn to_f64(&self) -> f64 {
        self.0.to_f64()
    }

    fn exponentials(&self) -> (Self, Self) {
        // not f64: MPFR's own, correctly rounded.
        (Self(self.0.clone().exp()), Self(self.0.clone().exp_m1()))
    }

    fn logarithm(&self) -> Self {
        // not f64: MPFR's own, correctly rounded.
        Self(self.0.clone().ln())
    }

    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }
}
