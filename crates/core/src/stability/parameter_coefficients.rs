//! The equations for λ as polynomials with coefficients in ℚ(√β), as balls.
//!
//! Each is negative at λ → 0 on the upper arc, and between its two solutions on the lower one.

use rug::Rational;

use crate::number::{Ball, Field};
use crate::stability::{Arc, ArcFrame};

/// What is given.
#[derive(Debug, Clone)]
pub(super) enum GivenValue {
    /// The V0 of the corner of the arc's asymptotes: g d² = A²/4 on the upper arc, g A² = 1/(4A²) on the lower one.
    CornerVelocity,
    /// The magnitude of the relative error of the arc's quasi-static asymptote (eq 15 or 16).
    QuasiStaticError(Rational),
    /// The magnitude of the relative error of the arc's inertial asymptote (eq 18 or 20).
    InertialError(Rational),
}

impl GivenValue {
    /// The coefficients by ascending power.
    pub(super) fn coefficients(&self, arc: Arc, frame: &ArcFrame<Ball>, precision_bits: u32) -> Vec<Ball> {
        let (q, sum) = (&frame.root_ratio, &frame.sum);
        let rational = |value: &Rational| Ball::from_rational(value, precision_bits);
        let quarter = rational(&Rational::from((1, 4)));
        match self {
            Self::CornerVelocity => {
                let scaled = match arc {
                    Arc::Upper => sum.square() * quarter,
                    Arc::Lower => quarter / sum.square(),
                };
                velocity_coefficients(arc, q, sum, &scaled)
            }
            Self::QuasiStaticError(tolerance) => {
                quasi_static_error_coefficients(arc, q, sum, &rational(tolerance))
            }
            Self::InertialError(tolerance) => {
                // Eq 18 gives too large a velocity, eq 20 too small a one: (1 ∓ ε)² − 1, exactly.
                let signed = if arc == Arc::Upper { Rational::from(-tolerance) } else { tolerance.clone() };
                let change = Rational::from(&signed + 2_u32) * signed;
                inertial_error_coefficients(arc, q, sum, &rational(&change))
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

/// εD − N of σ_exact/σ_15,16 − 1 = N/D (`arc_point`); `tolerance` is ε.
fn quasi_static_error_coefficients(arc: Arc, q: &Ball, sum: &Ball, tolerance: &Ball) -> Vec<Ball> {
    let int = |value: i32| Ball::from(value);
    let twice_q = int(2) * q;
    let [p0, p1, p2] = &[sum.clone(), int(2) * q * sum, int(2) * q.square()].map(|value| value * tolerance);
    match arc {
        Arc::Upper => vec![int(-2), p0.clone() - (int(1) + int(3) * q), p1.clone() - twice_q, p2.clone()],
        Arc::Lower => vec![p0.clone() + sum, p0.clone() + p1 - sum, p1.clone() + p2 - twice_q, p2.clone()],
    }
}

/// A²(1+qλ)⁴(1+e) − BP on the upper arc, (A+qλ)⁴(1+e) − A²BP on the lower one; `change` is e = (V_exact/V_asymptote)² − 1.
///
/// The constant coefficient is e·A² or e·A⁴: the large terms have cancelled before rounding.
fn inertial_error_coefficients(arc: Arc, q: &Ball, sum: &Ball, change: &Ball) -> Vec<Ball> {
    let int = |value: i32| Ball::from(value);
    let ratio = int(1) + change;
    let (square, q_squared) = (sum.square(), q.square());
    // BP = A² + 2qA(1+A)λ + 6q²Aλ² + 4q³λ³.
    let product = [int(2) * q * sum * (int(1) + sum), int(6) * &q_squared * sum, int(4) * &q_squared * q];
    let (base, weight) = match arc {
        Arc::Upper => (int(1), square.clone()),
        Arc::Lower => (sum.clone(), int(1)),
    };
    let scale = if arc == Arc::Upper { int(1) } else { square.clone() };
    let power = [
        int(4) * base.square() * &base * q,
        int(6) * base.square() * &q_squared,
        int(4) * &base * &q_squared * q,
    ];
    let mut coefficients = vec![square * change * &scale];
    coefficients.extend(
        power.into_iter().zip(product).map(|(power, product)| power * &ratio * &weight - product * &scale),
    );
    coefficients.push(q_squared.square() * ratio * weight);
    coefficients
}
