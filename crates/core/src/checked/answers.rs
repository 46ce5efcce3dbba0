//! What a slider answers: plain records without numbers of other libraries.

use super::enclosed::Enclosed;
use super::exact::{Exact, NumberError};
use super::input_error::InputError;
use crate::friction::{self, Quantity, SlipMode};
use crate::number::Rational;
use crate::roots::CertifiedRoot;
use crate::stability::{self, Arc, Asymptote, BoundaryCurve, Section, SpectralClass};

/// How steady sliding responds to a small disturbance.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Classification {
    /// Sign of K − K_c, exact: 1 linearly stable, 0 on the transition, −1 unstable.
    pub transition_sign: i8,
    /// Sign of the discriminant of eq 8, exact: 1 all roots real, 0 on the boundary, −1 a complex pair.
    pub boundary_sign: i8,
    /// The class that both signs give.
    pub spectral_class: SpectralClass,
    /// The slip mode, exact.
    pub slip_mode: SlipMode,
    /// The largest real part of the roots of eq 8, 1/s; relative error at most 1e-14, exactly 0 on the transition. None where it is beyond
    /// the range of 64-bit numbers.
    pub growth_rate_per_s: Option<f64>,
    /// The largest imaginary part, 1/s; relative error at most 1e-14, exactly 0 without oscillation. None where it is beyond the range of
    /// 64-bit numbers.
    pub angular_frequency_per_s: Option<f64>,
}

impl Classification {
    pub(super) fn of(found: &stability::Classification) -> Self {
        Self {
            transition_sign: found.transition_sign,
            boundary_sign: found.boundary_sign,
            spectral_class: found.spectral_class,
            slip_mode: found.slip_mode,
            growth_rate_per_s: found.max_real_per_s.to_f64(),
            angular_frequency_per_s: found.max_imaginary_per_s.to_f64(),
        }
    }
}

/// A root s of eq 8, 1/s.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Root {
    /// Its real part.
    pub real_per_s: Enclosed,
    /// Its imaginary part.
    pub imaginary_per_s: Enclosed,
    /// How often it counts.
    pub multiplicity: u32,
}

impl Root {
    pub(super) fn of(root: &CertifiedRoot, digits: u32) -> Self {
        Self {
            real_per_s: Enclosed::new(root.re_ball(), digits),
            imaginary_per_s: Enclosed::new(root.im_ball(), digits),
            multiplicity: root.multiplicity,
        }
    }
}

/// A point of the boundary.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct BoundaryPoint {
    /// The arc it lies on.
    pub arc: Arc,
    /// σ, Pa.
    pub normal_stress_pa: Enclosed,
    /// V0, m/s.
    pub loading_velocity_m_per_s: Enclosed,
    /// The nearer of the arc's two asymptotes.
    pub asymptote: Asymptote,
    /// exact/asymptote − 1.
    pub relative_error: Enclosed,
}

/// The boundary max Im(s) = 0 of a slider in the plane of loading velocity and normal stress.
///
/// ```
/// use slipmode_core::Slider;
///
/// let slider = Slider::new("0.004", "0.006", "1e-5", "1e7", 1000)?;
/// let boundary = slider.boundary(20);
/// let crossings = boundary.at_loading_velocity("1e-3")?;
/// assert!(crossings.iter().all(|point| point.loading_velocity_m_per_s.to_f64() == 1e-3));
/// assert!(boundary.sampled(10).len() >= 20);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Boundary {
    curve: BoundaryCurve,
    digits: u32,
}

impl Boundary {
    pub(super) fn of(slider: &friction::Slider<Rational>, digits: u32) -> Self {
        Self { curve: BoundaryCurve::new(slider, digits), digits }
    }

    /// The points at this loading velocity in m/s.
    ///
    /// # Errors
    /// When the velocity is no number, not positive, or out of range.
    pub fn at_loading_velocity(
        &self,
        loading_velocity_m_per_s: impl TryInto<Exact, Error: Into<NumberError>>,
    ) -> Result<Vec<BoundaryPoint>, InputError> {
        Quantity::LoadingVelocity
            .checked(loading_velocity_m_per_s)
            .map(|value| self.on(&Section::AtVelocity(value)))
    }

    /// The points at this normal stress in Pa.
    ///
    /// # Errors
    /// When the stress is no number, not positive, or out of range.
    pub fn at_normal_stress(
        &self,
        normal_stress_pa: impl TryInto<Exact, Error: Into<NumberError>>,
    ) -> Result<Vec<BoundaryPoint>, InputError> {
        Quantity::NormalStress.checked(normal_stress_pa).map(|value| self.on(&Section::AtNormalStress(value)))
    }

    /// At least so many points on each arc, from its quasi-static end to its inertial one, with cusp and corners.
    #[must_use]
    pub fn sampled(&self, points_per_arc: usize) -> Vec<BoundaryPoint> {
        let points = self.curve.sample(points_per_arc.max(1), END_ERROR).into_iter();
        points.map(|one| self.point(one)).collect()
    }

    fn on(&self, section: &Section) -> Vec<BoundaryPoint> {
        self.curve.on_section(section).into_iter().map(|one| self.point(one)).collect()
    }

    fn point(&self, of_curve: stability::BoundaryPoint) -> BoundaryPoint {
        let enclosed = |ball| Enclosed::new(ball, self.digits);
        BoundaryPoint {
            arc: of_curve.arc,
            normal_stress_pa: enclosed(of_curve.normal_stress_pa),
            loading_velocity_m_per_s: enclosed(of_curve.loading_velocity_m_per_s),
            asymptote: of_curve.asymptote,
            relative_error: enclosed(of_curve.relative_error),
        }
    }
}

/// Relative error of the asymptotes at the ends of a sampled arc.
const END_ERROR: f64 = 1e-9;
