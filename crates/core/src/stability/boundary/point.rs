//! One row of the table of the boundary.

use std::cmp::Ordering;

use crate::friction::{Groups, OperatingPoint};
use crate::number::{Ball, Real};
use crate::stability::logarithm::log10_one_plus;
use crate::stability::{Arc, ArcFrame, Asymptote};

slipmode_algebra::named! {
    /// What a point of the boundary is remarkable for.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Mark {
        /// The cusp of the lower arc: all three roots coincide.
        Cusp = "cusp",
        /// At the V0 of the corner of the arc's two asymptotes.
        CornerVelocity = "corner-velocity",
        /// At the σ of the corner of the lower arc's two asymptotes; the upper arc never comes down to it.
        CornerNormalStress = "corner-normal-stress",
    }
}

/// A point of the boundary, every number enclosed.
///
/// ```
/// use slipmode_core::stability::{BoundaryCurve, BoundaryPoint};
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let cusp: BoundaryPoint = BoundaryCurve::new(&slider, 20).cusp();
/// // At the cusp all three roots coincide; it lies near no asymptote.
/// assert!(cusp.relative_error.to_f64().abs() > 0.1);
/// ```
#[derive(Debug, Clone)]
pub struct BoundaryPoint {
    /// The arc it lies on.
    pub arc: Arc,
    /// The parameter λ of the arc: 0 at the inertial end, ∞ at the quasi-static one.
    pub parameter: Ball,
    /// The double root r of eq 8, in units of V0/D_c.
    pub double_root: Ball,
    /// σ, Pa.
    pub normal_stress_pa: Ball,
    /// V0, m/s.
    pub loading_velocity_m_per_s: Ball,
    /// η, κ, β.
    pub groups: Groups<Ball>,
    /// The nearer of the arc's two asymptotes by log10 distance (σ-distance at the same V0 for eqs 15 and 16,
    /// V0-distance at the same σ for eqs 18 and 20); the quasi-static one when the enclosures cannot tell.
    pub asymptote: Asymptote,
    /// The asymptote's σ at this V0 in Pa, or V0 at this σ in m/s.
    pub asymptote_value: Ball,
    /// exact/asymptote − 1.
    pub relative_error: Ball,
    /// log10(exact/asymptote).
    pub log10_distance: Ball,
    /// The largest relative change of the boundary's σ at given V0 per relative change of one of a, b, D_c, K, M, V0.
    pub condition_number: Ball,
    /// What is remarkable about it.
    pub mark: Option<Mark>,
}

/// σ_exact/σ_15,16 − 1 at the same V0 and V_exact/V_18,20 − 1 at the same σ, of one point.
#[derive(Debug, Clone)]
pub struct ErrorPair {
    /// Relative error of eq 15 or 16, in σ.
    pub quasi_static: Ball,
    /// Relative error of eq 18 or 20, in V0.
    pub inertial: Ball,
}

impl ErrorPair {
    /// The errors of both asymptotes of the arc at the parameter λ.
    #[must_use]
    pub fn at(frame: &ArcFrame<Ball>, arc: Arc, parameter: &Ball) -> Self {
        let of_square = frame.inertial_error_of_square(arc, parameter);
        // √(1+e) − 1 = e/(1 + √(1+e)) does not cancel for small e.
        let root = (Ball::from(1) + &of_square).sqrt();
        Self {
            quasi_static: frame.quasi_static_error(arc, parameter),
            inertial: of_square / (root + Ball::from(1)),
        }
    }

    /// The smaller of |log10(σ_exact/σ_asymptote)| and |log10(V_exact/V_asymptote)|.
    pub(crate) fn nearer_log10(&self) -> Ball {
        let nearer = if self.inertial_is_nearer() { &self.inertial } else { &self.quasi_static };
        log10_one_plus(&(stretch(nearer) - Ball::from(1)))
    }

    /// Whether eq 18 or 20 is certainly nearer in log10 distance than eq 15 or 16.
    ///
    /// |log10 x| < |log10 y| exactly when max(x, 1/x) < max(y, 1/y).
    pub(crate) fn inertial_is_nearer(&self) -> bool {
        stretch(&self.inertial).upper() < stretch(&self.quasi_static).lower()
    }
}

/// max(x, 1/x) of x = 1 + error.
pub(in crate::stability) fn stretch(error: &Ball) -> Ball {
    let ratio = Ball::from(1) + error;
    if error.centre().is_sign_negative() { Ball::from(1) / ratio } else { ratio }
}

impl BoundaryPoint {
    /// Puts the row together from the frame and the place on the arc.
    pub(super) fn new(
        frame: &ArcFrame<Ball>,
        (arc, parameter): (Arc, &Ball),
        OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }: OperatingPoint<Ball>,
        mark: Option<Mark>,
    ) -> Self {
        let place = frame.point(arc, parameter);
        let errors = ErrorPair::at(frame, arc, parameter);
        let (asymptote, relative_error, exact) = if errors.inertial_is_nearer() {
            (Asymptote::inertial(arc), errors.inertial, &loading_velocity_m_per_s)
        } else {
            (Asymptote::quasi_static(arc), errors.quasi_static, &normal_stress_pa)
        };
        Self {
            arc,
            parameter: parameter.clone(),
            double_root: place.double_root,
            groups: place.groups,
            asymptote,
            asymptote_value: exact.clone() / (Ball::from(1) + &relative_error),
            log10_distance: log10_one_plus(&relative_error),
            relative_error,
            condition_number: condition_number(frame, arc, parameter),
            normal_stress_pa,
            loading_velocity_m_per_s,
            mark,
        }
    }
}

/// The largest magnitude among the sensitivities of the boundary's σ.
fn condition_number(frame: &ArcFrame<Ball>, arc: Arc, parameter: &Ball) -> Ball {
    let larger = |x: &Ball, y: &Ball| x.centre().cmp_abs(y.centre()).unwrap_or(Ordering::Equal);
    let largest = frame.sensitivity(arc, parameter).into_iter().max_by(larger);
    let largest = largest.unwrap_or_else(|| Ball::from(0));
    if largest.centre().is_sign_negative() { -largest } else { largest }
}
