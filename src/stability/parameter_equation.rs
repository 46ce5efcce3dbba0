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

use crate::number::{Ball, Field};
use crate::polynomial::{enclose_root, horner};
use crate::stability::cusp::cusp;
use crate::stability::{Arc, ArcFrame};

/// What is given.
#[derive(Debug, Clone)]
enum Given {
    /// g = η/κ.
    VelocitySquared(Rational),
    /// The V0 of the corner of the arc's asymptotes: g d² = A²/4 on the upper arc, g A² = 1/(4A²) on the lower one.
    CornerVelocity,
    /// κ.
    StiffnessGroup(Rational),
}

/// An equation for λ on one arc.
#[derive(Debug, Clone)]
pub(crate) struct ParameterEquation {
    effect_ratio: Rational,
    arc: Arc,
    given: Given,
}

impl ParameterEquation {
    /// η/κ = (V0/D_c)²·M/K is given.
    pub(crate) fn at_velocity(effect_ratio: &Rational, arc: Arc, velocity_squared: Rational) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: Given::VelocitySquared(velocity_squared) }
    }

    /// The V0 is that of the corner 15∩18 or 16∩20.
    pub(crate) fn at_corner_velocity(effect_ratio: &Rational, arc: Arc) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: Given::CornerVelocity }
    }

    /// κ = K D_c/(a σ) is given.
    pub(crate) fn at_stiffness(effect_ratio: &Rational, arc: Arc, stiffness_group: Rational) -> Self {
        Self { effect_ratio: effect_ratio.clone(), arc, given: Given::StiffnessGroup(stiffness_group) }
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
            Given::StiffnessGroup(kappa) => {
                let rest = Rational::from(&self.effect_ratio + 1_u32) - kappa;
                rest > 0 && rest.square() > Rational::from(&self.effect_ratio * 4_u32)
            }
            _ => true,
        }
    }

    /// Whether the branch between eq 16 and the cusp has κ as low as asked: κ < (√β + 1)²; any velocity below the cusp's occurs.
    fn quasi_static_branch_has_solution(&self) -> bool {
        match &self.given {
            Given::StiffnessGroup(kappa) => {
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
                Some(_) => return Vec::new(),
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

    /// The equation as a polynomial in λ, by ascending power: positive where λ is too large (upper arc), negative between the
    /// two solutions (lower arc).
    fn coefficients(&self, precision_bits: u32) -> Vec<Ball> {
        let frame = ArcFrame::of_rational(&self.effect_ratio, precision_bits);
        let (q, sum) = (&frame.root_ratio, &frame.sum);
        let rational = |value: &Rational| Ball::from_rational(value, precision_bits);
        let end = match self.arc {
            Arc::Upper => frame.difference.clone(),
            Arc::Lower => sum.clone(),
        };
        let end = end.square();
        let quarter = rational(&Rational::from((1, 4)));
        match (&self.given, self.arc) {
            (Given::VelocitySquared(g), arc) => velocity_coefficients(arc, q, sum, &(rational(g) * end)),
            (Given::CornerVelocity, Arc::Upper) => {
                velocity_coefficients(Arc::Upper, q, sum, &(sum.square() * quarter))
            }
            (Given::CornerVelocity, Arc::Lower) => {
                velocity_coefficients(Arc::Lower, q, sum, &(quarter / sum.square()))
            }
            (Given::StiffnessGroup(kappa), arc) => {
                stiffness_coefficients(arc, q, sum, &end, &rational(kappa))
            }
        }
    }
}

/// gd²·λ²P − (1+λ)²B on the upper arc, gA²·(1+λ)²P − λ²B on the lower one; `scaled` is gd² or gA².
fn velocity_coefficients(arc: Arc, q: &Ball, sum: &Ball, scaled: &Ball) -> Vec<Ball> {
    let int = |value: i32| Ball::from(value);
    let linear = int(2) * q;
    let cubic = [sum.clone(), int(2) * q * sum, int(2) * q.square()];
    let scaled_cubic = cubic.map(|coefficient| coefficient * scaled);
    let [s0, s1, s2] = &scaled_cubic;
    match arc {
        Arc::Upper => vec![
            -sum.clone(),
            -(linear.clone() + int(2) * sum),
            s0.clone() - (int(2) * &linear + sum),
            s1.clone() - linear,
            s2.clone(),
        ],
        Arc::Lower => vec![
            s0.clone(),
            int(2) * s0 + s1,
            s0.clone() + int(2) * s1 + s2 - sum,
            s1.clone() + int(2) * s2 - linear,
            s2.clone(),
        ],
    }
}

/// d²λP − 2κ(1+λ)(1+qλ)² on the upper arc, A²(1+λ)P − 2κλ(A+qλ)² on the lower one; `end` is d² or A².
fn stiffness_coefficients(arc: Arc, q: &Ball, sum: &Ball, end: &Ball, kappa: &Ball) -> Vec<Ball> {
    let int = |value: i32| Ball::from(value);
    let twice_kappa = int(2) * kappa;
    let cubic = [sum.clone(), int(2) * q * sum, int(2) * q.square()];
    let [p0, p1, p2] = &cubic.map(|coefficient| coefficient * end);
    let q_squared = q.square();
    match arc {
        Arc::Upper => vec![
            -twice_kappa.clone(),
            p0.clone() - twice_kappa.clone() * (int(1) + int(2) * q),
            p1.clone() - twice_kappa.clone() * (int(2) * q + &q_squared),
            p2.clone() - twice_kappa * q_squared,
        ],
        Arc::Lower => vec![
            p0.clone(),
            p0.clone() + p1 - twice_kappa.clone() * sum.square(),
            p1.clone() + p2 - int(2) * &twice_kappa * q * sum,
            p2.clone() - twice_kappa * q_squared,
        ],
    }
}

/// λ of the cusp: r = −A(1+λ)/λ gives λ = A/(−r − A).
pub(crate) fn cusp_parameter(effect_ratio: &Rational, bits: u32) -> Ball {
    let bits = bits + 8;
    let sum = ArcFrame::of_rational(effect_ratio, bits).sum;
    let (_, triple_root) = cusp(effect_ratio, bits);
    sum.clone() / (-triple_root - sum)
}

/// value·2^exponent.
fn scaled(value: &Rational, exponent: i32) -> Rational {
    if exponent < 0 {
        value.clone() >> exponent.unsigned_abs()
    } else {
        value.clone() << exponent.unsigned_abs()
    }
}
