//! Which parameters λ of an arc have the velocity of the asymptotes' corner or a given error of an asymptote: polynomial equations over ℚ(√β).
//!
//! With q = √β, A = q + 1, d = q − 1, B = A + 2qλ and P = A + 2qAλ + 2q²λ² (`arc_point`):
//!
//! * upper: η/κ = g where g d²λ²P = (1+λ)²B;
//! * lower: η/κ = g where g A²(1+λ)²P = λ²B.
//!
//! Along the upper arc η/κ and both errors are monotone (dκ/dη = −r² < 0), so there is at most one solution. Along the lower arc η/κ
//! turns at the cusp and nowhere else, so there is at most one on either side of it.

use std::cmp::Ordering;

use rug::Rational;

use crate::number::Ball;
use crate::stability::cusp::cusp_abscissa;
use crate::stability::parameter_coefficients::GivenValue;
use crate::stability::{Arc, ArcFrame, Asymptote};
use slipmode_algebra::{enclose_root, horner};

/// An equation for λ on one arc.
#[derive(Debug, Clone)]
pub(crate) struct ParameterEquation {
    effect_ratio: Rational,
    arc: Arc,
    given: GivenValue,
}

impl ParameterEquation {
    /// The V0 is that of the corner 15∩18 or 16∩20.
    pub(crate) fn at_corner_velocity(effect_ratio: &Rational, arc: Arc) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: GivenValue::CornerVelocity }
    }

    /// The asymptote is off by the relative amount ±`tolerance`, with the sign of its leading error.
    pub(crate) fn at_error(effect_ratio: &Rational, asymptote: Asymptote, tolerance: Rational) -> Self {
        let given = if asymptote.is_quasi_static() {
            GivenValue::QuasiStaticError(tolerance)
        } else {
            GivenValue::InertialError(tolerance)
        };
        Self { effect_ratio: effect_ratio.clone(), arc: asymptote.arc(), given }
    }

    /// All positive solutions, descending, each with a relative radius of at most 2^−bits.
    ///
    /// A lower-arc equation that the cusp itself satisfies to four times the bits is answered with the cusp alone.
    pub(crate) fn roots(&self, bits: u32) -> Vec<Ball> {
        match self.arc {
            Arc::Upper if self.effect_ratio == 1 || !self.upper_has_solution() => Vec::new(),
            Arc::Upper => {
                // The one root can spoil the sign at one of two starts only.
                [Rational::from(1), Rational::from((3, 2))]
                    .iter()
                    .find_map(|start| {
                        let sign = self.sign(start, bits)?;
                        let direction = if sign == Ordering::Less { 1 } else { -1 };
                        self.root_beyond(start, sign, direction, bits)
                    })
                    .into_iter()
                    .collect()
            }
            Arc::Lower => self.roots_beside_the_cusp(bits),
        }
    }

    /// Eq 18 is too large by a factor: the error −1 is reached nowhere.
    fn upper_has_solution(&self) -> bool {
        !matches!(&self.given, GivenValue::InertialError(tolerance) if *tolerance >= 1)
    }

    fn roots_beside_the_cusp(&self, bits: u32) -> Vec<Ball> {
        let mut precision = bits;
        while precision <= bits.saturating_mul(4) {
            let cusp = cusp_parameter(&self.effect_ratio, precision);
            match horner(self.coefficients(precision), &cusp).sign() {
                Some(Ordering::Less) => return self.both_branches(&cusp, bits),
                Some(Ordering::Greater) => return Vec::new(),
                Some(Ordering::Equal) => break,
                None => precision *= 2,
            }
        }
        vec![cusp_parameter(&self.effect_ratio, bits)]
    }

    /// The solutions on either side of the cusp, where the equation's left side exceeds its right.
    fn both_branches(&self, cusp: &Ball, bits: u32) -> Vec<Ball> {
        let Some(start) = cusp.centre().to_rational() else { return Vec::new() };
        let above = self.root_beyond(&start, Ordering::Less, 1, bits);
        above.into_iter().chain(self.root_beyond(&start, Ordering::Less, -1, bits)).collect()
    }

    /// The root reached first from `start`, where the sign is known, towards larger (1) or smaller (−1) λ.
    fn root_beyond(&self, start: &Rational, at_start: Ordering, direction: i32, bits: u32) -> Option<Ball> {
        let place = |exponent: i32| scaled(start, direction * exponent);
        let is_beyond =
            |exponent: i32| self.sign(&place(exponent), bits).is_some_and(|sign| sign != at_start);
        let (mut inside, mut beyond) = (0, 1);
        while !is_beyond(beyond) {
            (inside, beyond) = (beyond, beyond.checked_mul(2).filter(|next| *next < 1 << 24)?);
        }
        while beyond - inside > 1 {
            let middle = inside + (beyond - inside) / 2;
            *(if is_beyond(middle) { &mut beyond } else { &mut inside }) = middle;
        }
        // `inside` may be where the sign was not certain; one step back it was, or is the start's own.
        let (near, far) = (place((inside - 1).max(0)), place(beyond));
        let (lower, upper) = if direction > 0 { (near, far) } else { (far, near) };
        Some(enclose_root(&|precision: u32| self.coefficients(precision), &lower, &upper, bits))
    }

    /// The sign of left minus right side at λ, when it is certain.
    fn sign(&self, parameter: &Rational, bits: u32) -> Option<Ordering> {
        horner(self.coefficients(bits), &Ball::from_rational(parameter, bits)).sign()
    }

    /// Left minus right side as a polynomial in λ.
    fn coefficients(&self, precision_bits: u32) -> Vec<Ball> {
        let frame = ArcFrame::of_rational(&self.effect_ratio, precision_bits);
        self.given.coefficients(self.arc, &frame, precision_bits)
    }
}

/// λ of the cusp: x = −1 − r = √β + A/λ.
pub(crate) fn cusp_parameter(effect_ratio: &Rational, bits: u32) -> Ball {
    let bits = bits + 8;
    let frame = ArcFrame::of_rational(effect_ratio, bits);
    frame.sum / (cusp_abscissa(effect_ratio, bits) - frame.root_ratio)
}

/// value·2^exponent.
fn scaled(value: &Rational, exponent: i32) -> Rational {
    if exponent < 0 {
        value.clone() >> exponent.unsigned_abs()
    } else {
        value.clone() << exponent.unsigned_abs()
    }
}
