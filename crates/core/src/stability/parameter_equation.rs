//! Which parameters λ of an arc have a given velocity or a given stiffness group: polynomial equations over ℚ(√β).
//!
//! With q = √β, A = q + 1, d = q − 1, B = A + 2qλ and P = A + 2qAλ + 2q²λ² (`arc_point`):
//!
//! | arc | η/κ = g | κ given |
//! |---|---|---|
//! | upper | g d²λ²P = (1+λ)²B | d²λP = 2κ(1+λ)(1+qλ)² |
//! | lower | g A²(1+λ)²P = λ²B | A²(1+λ)P = 2κλ(A+qλ)² |
//!
//! Along the upper arc η/κ and κ are monotone (dκ/dη = −r² < 0), so there is at most one solution. Along the lower arc both
//! turn at the cusp and nowhere else, so there is at most one on either side of it.

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
    /// η/κ = (V0/D_c)²·M/K is given.
    pub(crate) fn at_velocity(effect_ratio: &Rational, arc: Arc, velocity_squared: Rational) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: GivenValue::VelocitySquared(velocity_squared) }
    }

    /// The V0 is that of the corner 15∩18 or 16∩20.
    pub(crate) fn at_corner_velocity(effect_ratio: &Rational, arc: Arc) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: GivenValue::CornerVelocity }
    }

    /// κ = K D_c/(a σ) is given.
    pub(crate) fn at_stiffness(effect_ratio: &Rational, arc: Arc, stiffness_group: Rational) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: GivenValue::StiffnessGroup(stiffness_group) }
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

    /// Eq 15 bounds the upper arc: κ < (√β − 1)², that is 1 + β − κ > 2√β; any velocity occurs.
    fn upper_has_solution(&self) -> bool {
        match &self.given {
            GivenValue::StiffnessGroup(kappa) => {
                let rest = Rational::from(&self.effect_ratio + 1_u32) - kappa;
                rest > 0 && rest.square() > Rational::from(&self.effect_ratio * 4_u32)
            }
            // Eq 18 is too large by a factor: the error −1 is reached nowhere.
            GivenValue::InertialError(tolerance) => *tolerance < 1,
            _ => true,
        }
    }

    /// Whether the branch between eq 16 and the cusp has κ low enough: κ < (√β + 1)²; any velocity below the cusp's occurs.
    fn quasi_static_branch_has_solution(&self) -> bool {
        match &self.given {
            GivenValue::StiffnessGroup(kappa) => {
                let rest = Rational::from(kappa - 1_u32) - &self.effect_ratio;
                rest <= 0 || rest.square() < Rational::from(&self.effect_ratio * 4_u32)
            }
            _ => true,
        }
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
        let quasi_static = self.quasi_static_branch_has_solution();
        let above = quasi_static.then(|| self.root_beyond(&start, Ordering::Less, 1, bits)).flatten();
        above.into_iter().chain(self.root_beyond(&start, Ordering::Less, -1, bits)).collect()
    }

    /// The root reached first from `start`, where the sign is known, towards larger (1) or smaller (−1) λ.
    fn root_beyond(&self, start: &Rational, at_start: Ordering, direction: i32, bits: u32) -> Option<Ball> {
        let place = |exponent: i32| scaled(start, direction * exponent);
        let precision = bits.saturating_add(self.lost_bits());
        let is_beyond =
            |exponent: i32| self.sign(&place(exponent), precision).is_some_and(|sign| sign != at_start);
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

    /// Bits that cancel in the leading coefficient, next to an asymptote's own κ: without them no sign far out is certain.
    ///
    /// With d² and A² for eqs 15 and 16, (d² − κ)(A² − κ) = (1 + β − κ)² − 4β exactly, and neither factor exceeds A² ≤ 2 + 2β or κ.
    fn lost_bits(&self) -> u32 {
        let GivenValue::StiffnessGroup(kappa) = &self.given else { return 0 };
        let rest = Rational::from(&self.effect_ratio + 1_u32) - kappa;
        let gap = rest.square() - Rational::from(&self.effect_ratio * 4_u32);
        if gap == 0 {
            return 0;
        }
        let largest = Rational::from(&self.effect_ratio + 1_u32).max(kappa.clone()) * 2_u32;
        let lost = largest * kappa / gap;
        lost.numer().significant_bits().saturating_sub(lost.denom().significant_bits()) + 1
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
