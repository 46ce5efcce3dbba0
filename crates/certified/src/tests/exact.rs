//! Intervals beside rational numbers.

use super::Interval;
use slipmode_core::number::Rational;

pub fn exact(value: f64) -> Rational {
    Rational::from_f64(value).unwrap()
}

pub fn holds(interval: Interval, value: &Rational) -> bool {
    (exact(interval.mid) - value).abs() <= exact(interval.rad)
}
