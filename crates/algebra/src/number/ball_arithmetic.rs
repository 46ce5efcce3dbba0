//! Arithmetic on balls: centres rounded to nearest, radii rounded up.
//!
//! The precision of a result is the larger of its operands'.

use std::cmp::Ordering;
use std::ops::Neg;

use rug::Float;
use rug::float::Round;
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound, SubAssignRound};

use super::ball::half_unit;
use super::magnitude::{MAGNITUDE_BITS, Magnitude};
use super::{Ball, Field, Real};
use crate::implement_operators;

impl Ball {
    fn joint_precision(&self, other: &Self) -> u32 {
        self.centre.prec().max(other.centre.prec())
    }

    /// The centre rounded to nearest after an operation in place, at the joint precision; the memory is used again.
    fn lifted_centre(self, precision: u32) -> Float {
        let mut centre = self.centre;
        if centre.prec() < precision {
            centre.set_prec(precision);
        }
        centre
    }

    fn plus(self, other: &Self) -> Self {
        let (precision, radius) = (self.joint_precision(other), self.radius.plus(other.radius));
        let mut centre = self.lifted_centre(precision);
        let rounding = centre.add_assign_round(&other.centre, Round::Nearest);
        Self::rounded(centre, rounding, radius)
    }

    fn minus(self, other: &Self) -> Self {
        let (precision, radius) = (self.joint_precision(other), self.radius.plus(other.radius));
        let mut centre = self.lifted_centre(precision);
        let rounding = centre.sub_assign_round(&other.centre, Round::Nearest);
        Self::rounded(centre, rounding, radius)
    }

    /// |xy − x'y'| ≤ |x|·r_y + (|y| + r_y)·r_x.
    fn times(self, other: &Self) -> Self {
        let mut radius = Magnitude::ZERO;
        if !other.radius.is_zero() {
            radius = Magnitude::above(&self.centre).times(other.radius);
        }
        if !self.radius.is_zero() {
            let second = Magnitude::above(&other.centre).plus(other.radius);
            radius = radius.plus(second.times(self.radius));
        }
        let precision = self.joint_precision(other);
        let mut centre = self.lifted_centre(precision);
        let rounding = centre.mul_assign_round(&other.centre, Round::Nearest);
        Self::rounded(centre, rounding, radius)
    }

    /// The product with a small whole number, without memory for it.
    pub fn times_small(self, factor: u32) -> Self {
        let Self { mut centre, radius } = self;
        let rounding = centre.mul_assign_round(factor, Round::Nearest);
        Self::rounded(centre, rounding, radius.times(Magnitude::of_whole(factor)))
    }

    /// |x/y − x'/y'| ≤ (r_x + |x/y|·r_y)/(|y| − r_y).
    fn over(self, other: &Self) -> Self {
        let (precision, own_radius) = (self.joint_precision(other), self.radius);
        if other.contains_zero() {
            return Self::unbounded(precision);
        }
        let mut centre = self.lifted_centre(precision);
        let rounding = centre.div_assign_round(&other.centre, Round::Nearest);
        if own_radius.is_zero() && other.radius.is_zero() {
            return Self::rounded(centre, rounding, Magnitude::ZERO);
        }
        let smallest = Magnitude::below(&other.centre).minus_down(other.radius);
        if smallest.is_zero() {
            return Self::unbounded(precision);
        }
        // The quotient's own rounding is more than a unit of 32 bits when the centre has fewer; an exact one has none.
        let mut quotient = Magnitude::above(&centre);
        if rounding != Ordering::Equal {
            quotient = quotient.plus(half_unit(&centre));
        }
        let radius = quotient.times(other.radius).plus(own_radius).over(smallest);
        Self::rounded(centre, rounding, radius)
    }

    /// √ of a ball that lies above zero: |√x − √x'| ≤ r/(√x + √(x − r)).
    fn sqrt_of_positive(&self) -> Self {
        let (centre, rounding) =
            Float::with_val_round(self.centre.prec(), self.centre.sqrt_ref(), Round::Nearest);
        let smallest = Magnitude::below(&self.centre).minus_down(self.radius);
        let denominator = Magnitude::root_below(&self.centre).plus_down(smallest.root_down());
        Self::rounded(centre, rounding, self.radius.over(denominator))
    }

    /// √ of the part above zero of a ball that reaches below it: the ball over [0, √upper].
    fn sqrt_of_straddling(&self) -> Self {
        let half = Float::with_val_round(MAGNITUDE_BITS, self.upper().sqrt_ref(), Round::Up).0 / 2;
        let centre = Float::with_val(self.centre.prec().max(MAGNITUDE_BITS), &half);
        Self { centre, radius: Magnitude::above(&half) }
    }
}

// The left side's memory is used again.
implement_operators!(Ball, Add::add => plus, Sub::sub => minus, Mul::mul => times, Div::div => over);

impl Neg for Ball {
    type Output = Self;
    fn neg(self) -> Self {
        Self { centre: -self.centre, radius: self.radius }
    }
}

impl Field for Ball {
    /// |x² − x'²| ≤ r·(2|x| + r).
    fn square(&self) -> Self {
        let (centre, rounding) =
            Float::with_val_round(self.centre.prec(), self.centre.square_ref(), Round::Nearest);
        let radius = Magnitude::above(&self.centre).scaled(1).plus(self.radius).times(self.radius);
        Self::rounded(centre, rounding, radius)
    }
}

impl Real for Ball {
    /// √ of the part of the ball that is not negative; unbounded when there is none.
    fn sqrt(&self) -> Self {
        if !self.is_bounded() || self.centre.is_zero() && self.is_exact() {
            return self.clone();
        }
        if !self.contains_zero() && self.centre.is_sign_positive() {
            self.sqrt_of_positive()
        } else if self.upper().cmp0() == Some(Ordering::Less) {
            Self::unbounded(self.centre.prec())
        } else {
            self.sqrt_of_straddling()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::Rational;

    /// An expression tree over exact rationals.
    #[derive(Debug, Clone)]
    enum Expression {
        Number(i32, i32),
        Square(Box<Expression>),
        Binary(u8, Box<Expression>, Box<Expression>),
    }

    fn any_expression() -> impl Strategy<Value = Expression> {
        let leaf = (-1000i32..1000, 1i32..1000).prop_map(|(n, d)| Expression::Number(n, d));
        leaf.prop_recursive(6, 40, 2, |inner| {
            prop_oneof![
                inner.clone().prop_map(|e| Expression::Square(Box::new(e))),
                (0u8..4, inner.clone(), inner).prop_map(|(op, x, y)| Expression::Binary(
                    op,
                    Box::new(x),
                    Box::new(y)
                )),
            ]
        })
    }

    /// The value in ℚ and in balls, or `None` when the exact expression divides by zero.
    fn evaluate(expression: &Expression, bits: u32) -> Option<(Rational, Ball)> {
        Some(match expression {
            Expression::Number(n, d) => {
                let exact = Rational::from((*n, *d));
                let ball = Ball::from_rational(&exact, bits);
                (exact, ball)
            }
            Expression::Square(inner) => {
                let (exact, ball) = evaluate(inner, bits)?;
                (exact.square(), Field::square(&ball))
            }
            Expression::Binary(op, x, y) => {
                let ((p, x), (q, y)) = (evaluate(x, bits)?, evaluate(y, bits)?);
                match op {
                    0 => (p + q, x + y),
                    1 => (p - q, x - y),
                    2 => (p * q, x * y),
                    _ if q == 0 => return None,
                    _ => (p / q, x / y),
                }
            }
        })
    }

    proptest! {
        #[test]
        fn a_ball_contains_the_true_value_of_any_expression(tree in any_expression(), bits in 4u32..200) {
            if let Some((exact, ball)) = evaluate(&tree, bits) {
                prop_assert!(ball.contains(&exact), "{ball:?} misses {exact}");
            }
        }

        #[test]
        fn a_square_root_contains_the_root_of_every_point(n in 0u32..10_000, d in 1u32..10_000, width in 0u32..50) {
            let root = Rational::from((n, d));
            let square = root.clone().square();
            let radius = Float::with_val(32, width) / 64u32;
            let ball = Ball::new(Float::with_val(80, &square), radius);
            prop_assert!(ball.contains(&square) && ball.sqrt().contains(&root) || !ball.contains(&square));
        }
    }

    proptest! {
        #[test]
        fn a_ball_says_where_its_points_are(
            centre in -40_i32..41, radius in 0_i32..30, scale in -70_i32..70, share in -4_i32..5, gap in 0_i32..60, exponent in -80_i64..80
        ) {
            let exact = |value: i32| Rational::from(value) << scale;
            let ball = |centre: i32| Ball::new(Float::with_val(64, exact(centre)), Float::with_val(32, exact(radius)));
            let (x, other, whole) = (ball(centre), ball(centre + gap), Rational::from(&exact(centre)));
            let inside = exact(radius) * Rational::from((share, 4)) + &whole;
            let outside = exact(radius) * Rational::from((9, 8)) + &whole;
            prop_assert!(x.contains(&inside) && x.contains(&outside) == (radius == 0));
            prop_assert_eq!(x.overlaps(&other) && other.overlaps(&x), gap <= 2 * radius);
            prop_assert!(x.overlaps(&Ball::unbounded(64)) && Ball::unbounded(64).overlaps(&x));
            let power = |exponent: i64| Rational::from(1) << exponent as i32;
            let size = inside.clone().abs();
            prop_assert!(size == 0 || size <= power(x.exponent_above()) && exact(centre.abs() + radius) * 4_u32 >= power(x.exponent_above()));
            match x.exponent_below() {
                Some(least) => prop_assert!(power(least) <= size && power(least) * 4_u32 >= exact(centre.abs() - radius)),
                None => prop_assert!(centre.abs() <= radius),
            }
            prop_assert!(radius == 0 || power(x.radius_exponent()) >= exact(radius) && power(x.radius_exponent()) <= exact(radius) * 4_u32);
            let wider = x.clone().widened(exponent);
            prop_assert!(wider.contains(&(whole.clone() + exact(radius) + power(exponent))) && !wider.contains(&(whole.clone() + exact(2 * radius) + power(exponent) * 2_u32)));
            prop_assert_eq!(x.to_f64(), crate::number::nearest_f64(&whole));
            let certain = x.relative_radius_log2();
            prop_assert!(radius == 0 || centre == 0 || (certain - libm::log2(f64::from(radius) / f64::from(centre.abs()))).abs() < 1e-6);
            let (short, long) = (Ball::from_rational(&Rational::from((centre, 7)), 40), Ball::from_rational(&Rational::from((1, 3)), 90));
            prop_assert!([short.clone() + &long, long * &short].iter().all(|found| found.precision_bits() == 90));
            // The root of the part that is not negative.
            let square = Rational::from(share.abs()).square() / 16_u32;
            let straddling = Ball::new(Float::with_val(64, centre.min(radius)), Float::with_val(32, radius));
            prop_assert!(!straddling.contains(&square) || straddling.sqrt().contains(&Rational::from((share.abs(), 4))));
        }
    }

    #[test]
    fn radii_are_a_few_units_in_the_last_place_not_wildly_more() {
        let third = Ball::from_rational(&Rational::from((1, 3)), 200);
        let value = (third.clone() + &third) * &third / &third;
        assert!(value.relative_radius_log2() < -197.0, "{}", value.relative_radius_log2());
        assert!(value.sqrt().relative_radius_log2() < -197.0);
    }

    #[test]
    fn a_division_by_a_ball_that_contains_zero_is_unbounded_and_never_a_panic() {
        let around_zero = Ball::new(Float::with_val(64, 1e-3), Float::with_val(32, 1e-2));
        let quotient = Ball::from(1) / &around_zero;
        assert!(quotient.radius().is_infinite() && quotient.sign().is_none());
        let later = quotient * &Ball::from(0) + Ball::from(3);
        assert!(later.radius().is_infinite(), "unbounded stays unbounded");
    }

    #[test]
    fn quotients_of_few_bits_keep_their_own_rounding_in_the_radius() {
        // Two bits: 1/b is rounded by up to a quarter of itself, and the divisor's radius is multiplied by it.
        for (n, d) in (1..40).flat_map(|n| (1..40).map(move |d| (n, d))) {
            for bits in 2..6 {
                let [n, d] = [n, d].map(|value| Float::with_val(bits, value));
                let radius = Float::with_val(32, &d) / 4u32;
                let quotient = Ball::exact(n.clone()) / Ball::new(d.clone(), radius.clone());
                for end in [Float::with_val(60, &d - &radius), Float::with_val(60, &d + &radius)] {
                    let exact = n.to_rational().unwrap() / end.to_rational().unwrap();
                    assert!(quotient.contains(&exact), "{n}/{d} at {bits} bits");
                }
            }
        }
    }

    #[test]
    fn a_quotient_of_zero_stays_exact() {
        let three = Ball::new(Float::with_val(64, 3), Float::with_val(32, 1));
        assert!((Ball::from(0) / three).radius().is_zero());
    }

    #[test]
    fn the_sign_is_given_only_when_all_points_share_it() {
        use std::cmp::Ordering;
        assert_eq!(Ball::from(0).sign(), Some(Ordering::Equal));
        assert_eq!(Ball::from(-2).sign(), Some(Ordering::Less));
        assert_eq!(Ball::new(Float::with_val(64, 1), Float::with_val(32, 1)).sign(), None);
    }
}
