//! What a cycle shows, quantity by quantity: values, differences, errors or derivatives of the same five.

use super::{Return, Scalar};
use crate::number::fields;

fields! {
    /// One value for each quantity that a return shows.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub(super) struct Observables<T>[5] {
        /// Of ln(V_peak/V_l).
        pub log_peak,
        /// Of ln(duration).
        pub log_duration,
        /// Of ln(V_min/V_l).
        pub log_trough,
        /// Of the largest ζ on V = V_l.
        pub highest_stress,
        /// Of the least ζ on V = V_l.
        pub lowest_stress,
    }
}

impl Observables<f64> {
    /// The values that a return shows.
    pub fn of<R: Scalar>(orbit: &Return<R>) -> Self {
        Self {
            log_peak: orbit.peak.to_f64(),
            log_duration: orbit.duration.logarithm().to_f64(),
            log_trough: orbit.trough.to_f64(),
            highest_stress: orbit.highest_stress.to_f64(),
            lowest_stress: orbit.lowest_stress.to_f64(),
        }
    }

    /// What one return shows less what another one shows, formed in the returns' own digits.
    pub fn differences<R: Scalar>(one: &Return<R>, other: &Return<R>) -> Self {
        let difference = |a: &R, b: &R| (a.clone() - b).to_f64();
        let ratio = difference(&one.duration, &other.duration) / other.duration.to_f64();
        Self {
            log_peak: difference(&one.peak, &other.peak),
            log_duration: libm::log1p(ratio),
            log_trough: difference(&one.trough, &other.trough),
            highest_stress: difference(&one.highest_stress, &other.highest_stress),
            lowest_stress: difference(&one.lowest_stress, &other.lowest_stress),
        }
    }

    /// The largest of the values, at least 0.
    pub fn largest(self) -> f64 {
        <[f64; 5]>::from(self).into_iter().fold(0.0f64, f64::max)
    }

    /// The larger error of peak and duration, which the requested tolerance bounds.
    pub fn peak_or_duration(self) -> f64 {
        self.log_peak.max(self.log_duration)
    }
}

impl<T: Copy> Observables<T> {
    /// The same value for all.
    pub fn all(value: T) -> Self {
        [value; 5].into()
    }

    /// `stress` for the quantities that a stick phase carries on, the least velocity and both stresses, and `other` for the rest.
    pub fn held(held: T, other: T) -> Self {
        Self { log_trough: held, highest_stress: held, lowest_stress: held, ..Self::all(other) }
    }

    /// Joins each with its counterpart.
    pub fn zip<S: Copy>(self, other: Observables<S>) -> Observables<(T, S)> {
        let (own, others): ([T; 5], [S; 5]) = (self.into(), other.into());
        std::array::from_fn(|n| (own[n], others[n])).into()
    }
}

impl std::ops::Add for Observables<f64> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other).map(|&(a, b)| a + b)
    }
}
