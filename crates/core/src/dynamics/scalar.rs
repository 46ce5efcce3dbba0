//! What an integrator asks of a number, beyond the field: exponentials, comparisons, constants.
//!
//! Elementary functions come from `libm`, MPFR or this file, never from the system's C library.

use rug::Float;

use super::double_double_exp::double_double_exponentials;
use super::quick_exp::exponentials;
use crate::number::{Dd, Real};

/// A number that a trajectory can be computed in: `f64` or double-double.
pub trait Scalar: Real + PartialOrd + Send + Sync + std::fmt::Debug + 'static {
    /// Bound on the relative error of one operation.
    const UNIT_ROUNDOFF: f64;

    /// The nearest number of this type to an f64 (exact in all types here).
    #[must_use]
    fn from_f64(value: f64) -> Self;

    /// The number of this type nearest to a constant computed with MPFR.
    #[must_use]
    fn from_float(value: &Float) -> Self;

    /// The nearest f64.
    #[must_use]
    fn to_f64(&self) -> f64;

    /// e^x and e^x − 1, each accurate relative to itself, so that a small perturbation keeps its digits.
    #[must_use]
    fn exponentials(&self) -> (Self, Self);

    /// The natural logarithm.
    #[must_use]
    fn logarithm(&self) -> Self;

    /// The absolute value.
    #[must_use]
    fn abs(&self) -> Self {
        if *self < Self::from(0) { -self.clone() } else { self.clone() }
    }

    /// Whether the number is finite.
    #[must_use]
    fn is_finite(&self) -> bool {
        self.to_f64().is_finite()
    }
}

impl Scalar for f64 {
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }

    fn from_float(value: &Float) -> Self {
        value.to_f64()
    }

    #[inline(always)]
    fn to_f64(&self) -> f64 {
        *self
    }

    #[inline]
    fn exponentials(&self) -> (Self, Self) {
        exponentials(*self)
    }

    fn logarithm(&self) -> Self {
        libm::log(*self)
    }

    #[inline(always)]
    fn abs(&self) -> Self {
        f64::abs(*self)
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
}

impl Scalar for Dd {
    const UNIT_ROUNDOFF: f64 = Dd::UNIT;

    fn from_f64(value: f64) -> Self {
        Dd::from(value)
    }

    fn from_float(value: &Float) -> Self {
        let head = value.to_f64();
        Dd::exact_sum(head, Float::with_val(value.prec(), value - head).to_f64())
    }

    fn to_f64(&self) -> f64 {
        self.hi()
    }

    fn exponentials(&self) -> (Self, Self) {
        double_double_exponentials(*self)
    }

    fn logarithm(&self) -> Self {
        // Two Newton steps on the exponential double the 53 correct bits twice.
        let mut logarithm = Dd::from(libm::log(self.hi()));
        for _ in 0..2 {
            let (inverse, _) = (-logarithm).exponentials();
            logarithm = logarithm + (*self * inverse - Dd::from(1));
        }
        logarithm
    }

    fn abs(&self) -> Self {
        Dd::abs(*self)
    }

    fn is_finite(&self) -> bool {
        Dd::is_finite(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn exponentials_in_f64_keep_two_units_in_the_last_place(x in -700.0f64..700.0) {
            let (exponential, excess) = x.exponentials();
            let exact = Float::with_val(200, x).exp();
            let exact_excess = Float::with_val(200, x).exp_m1();
            prop_assert!((exponential / exact.to_f64() - 1.0).abs() < 4.0 * f64::EPSILON);
            prop_assert!((excess / exact_excess.to_f64() - 1.0).abs() < 8.0 * f64::EPSILON);
        }

        #[test]
        fn the_logarithm_of_a_double_double_inverts_its_exponential(x in 0.1f64..300.0) {
            let (exponential, _) = Dd::from(x).exponentials();
            let error = exponential.logarithm() - Dd::from(x);
            // The exponential's relative error is the logarithm's absolute one.
            prop_assert!(Scalar::abs(&error).to_f64() < 64.0 * Dd::UNIT * x.max(1.0));
        }
    }
}
