//! Decimal logarithms of balls.

use rug::Float;
use rug::float::Round;

use crate::number::Ball;

/// log10(1 + x), without loss for small x; unbounded when 1 + x may be zero or negative.
pub(crate) fn log10_one_plus(x: &Ball) -> Ball {
    let precision = x.precision_bits();
    // d ln(1+x) = dx/(1+x), largest at the lower end of the ball.
    let smallest = Ball::from(1) + Ball::exact(x.lower());
    if smallest.lower().cmp0() != Some(std::cmp::Ordering::Greater) {
        return Ball::unbounded(precision);
    }
    let spread = Ball::exact(x.radius()) / smallest;
    let (logarithm, _) = Float::with_val_round(precision, x.centre().ln_1p_ref(), Round::Nearest);
    let rounding = unit_in_the_last_place(&logarithm);
    let ten = Float::with_val(precision, 10).ln();
    let ln_ten = Ball::new(ten.clone(), unit_in_the_last_place(&ten));
    (Ball::new(logarithm, spread.upper()) + Ball::new(Float::new(32), rounding)) / ln_ten
}

/// A bound of the rounding error of a float.
fn unit_in_the_last_place(value: &Float) -> Float {
    // ln 1 = 0 is exact.
    let exact = || Float::new(32);
    value.get_exp().map_or_else(exact, |exponent| Float::with_val(32, 1) << exponent >> value.prec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Rational, parse_decimal};

    #[test]
    fn powers_of_ten_and_tiny_arguments() {
        let two = log10_one_plus(&Ball::from_rational(&Rational::from(99), 200));
        assert!(two.contains(&Rational::from(2)) && two.relative_radius_log2() < -195.0);
        let tiny = parse_decimal("1e-40").unwrap();
        let ball = log10_one_plus(&Ball::from_rational(&tiny, 100));
        assert!(ball.relative_radius_log2() < -95.0);
        assert!((ball.to_f64() - 4.342_944_819_032_518e-41).abs() < 1e-55);
        assert!(log10_one_plus(&Ball::from(-1)).radius().is_infinite());
        assert!(log10_one_plus(&Ball::from(0)).radius().is_zero());
    }
}
