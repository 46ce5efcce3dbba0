//! Comparisons of numbers with errors, and their correlation.

use std::cmp::Ordering;

use slipmode_core::number::{Ball, Rational, Real};

use slipmode_algebra::Comparison;

/// Bits of the values.
pub(super) const BITS: u32 = 96;

/// How a difference compares with zero; none where its error could turn it.
pub(super) fn compared(difference: &Ball, comparison: Comparison) -> Option<bool> {
    let below = (difference.lower() < 0).then_some(Ordering::Less);
    let above = (difference.upper() > 0).then_some(Ordering::Greater);
    let zero = difference.contains_zero().then_some(Ordering::Equal);
    let mut found = [below, zero, above].into_iter().flatten().map(|order| comparison.holds(order));
    let first = found.next()?;
    found.all(|other| other == first).then_some(first)
}

/// The absolute value.
pub(super) fn magnitude(value: &Ball) -> Ball {
    match value.sign() {
        Some(Ordering::Less) => -value.clone(),
        Some(_) => value.clone(),
        None => {
            let [low, high] = [value.lower().abs(), value.upper().abs()];
            let half = Ball::exact(if low > high { low } else { high }) / Ball::from(2);
            Ball::new(half.centre().clone(), half.upper())
        }
    }
}

/// Pearson's correlation.
///
/// # Errors
/// Why there is none.
pub(super) fn correlation(x: &[Ball], y: &[Ball]) -> Result<Ball, &'static str> {
    let number = |count: usize| Ball::from_rational(&Rational::from(count), BITS);
    let centred = |values: &[Ball]| -> Vec<Ball> {
        let mean = values.iter().fold(number(0), |sum, value| sum + value) / number(values.len());
        values.iter().map(|value| value.clone() - &mean).collect()
    };
    let product = |one: &[Ball], other: &[Ball]| {
        one.iter().zip(other).fold(number(0), |sum, (one, other)| sum + one.clone() * other)
    };
    if x.len() < 3 {
        return Err("fewer than 3 values");
    }
    let (x, y) = (centred(x), centred(y));
    let spread = product(&x, &x) * product(&y, &y);
    match spread.sign() {
        Some(Ordering::Greater) => Ok(product(&x, &y) / spread.sqrt()),
        _ => Err("one side has no certainly different values"),
    }
}

/// The ball around a value with at least this radius.
pub(super) fn around(value: &Rational, width: &Rational) -> Ball {
    let [zero, radius] = [&Rational::new(), width].map(|one| Ball::from_rational(one, BITS).upper());
    Ball::from_rational(value, BITS) + Ball::new(zero, radius)
}
