//! Lines across the (V0, σ) plane and where they cross the boundary.

use rug::Rational;

use crate::friction::{Groups, OperatingPoint, Slider};
use crate::number::{Ball, Real};
use crate::stability::Arc;

/// A line across the plane: one coordinate given, the other sought.
///
/// ```
/// use slipmode_core::stability::BoundaryCurve;
/// use slipmode_core::stability::Section;
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let section = Section::AtNormalStress(number("1e4"));
/// let velocities = BoundaryCurve::new(&slider, 20).on_section(&section);
/// assert!(velocities.iter().all(|point| point.loading_velocity_m_per_s.to_f64() > 0.0));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Section {
    /// Given V0 in m/s; σ is sought.
    AtVelocity(Rational),
    /// Given σ in Pa; V0 is sought.
    AtNormalStress(Rational),
}

/// Where a section crosses the boundary.
#[derive(Debug, Clone)]
pub struct Crossing {
    /// The arc that is crossed.
    pub arc: Arc,
    /// σ in Pa and V0 in m/s.
    pub position: OperatingPoint<Ball>,
}

impl Section {
    /// The coordinate that the section leaves open: σ at given V0, V0 at given σ.
    pub(super) fn sought(&self, position: OperatingPoint<Ball>) -> Ball {
        match self {
            Self::AtVelocity(_) => position.normal_stress_pa,
            Self::AtNormalStress(_) => position.loading_velocity_m_per_s,
        }
    }

    /// η/κ = (V0/D_c)²·M/K on a section at given V0, which is the same at every σ.
    pub(super) fn velocity_squared(slider: &Slider<Rational>, velocity_m_per_s: &Rational) -> Rational {
        let rate = Rational::from(velocity_m_per_s / &slider.critical_slip_distance_m);
        rate.square() / slider.natural_angular_frequency_squared_per_s2()
    }

    /// κ on a section at given σ, which is the same at every V0.
    pub(super) fn stiffness_group(slider: &Slider<Rational>, normal_stress_pa: &Rational) -> Rational {
        slider.stress_scale_pa() / normal_stress_pa
    }

    /// σ and V0 of the point of the section with these η and κ.
    pub(super) fn coordinates(
        &self,
        slider: &Slider<Rational>,
        groups: &Groups<Ball>,
        bits: u32,
    ) -> OperatingPoint<Ball> {
        match self {
            Self::AtVelocity(velocity) => {
                let scale = Ball::from_rational(&slider.stress_scale_pa(), bits);
                OperatingPoint {
                    normal_stress_pa: scale / &groups.stiffness_group,
                    loading_velocity_m_per_s: Ball::from_rational(velocity, bits),
                }
            }
            Self::AtNormalStress(stress) => {
                let scale = slider.velocity_scale_squared() / Self::stiffness_group(slider, stress);
                let square = Ball::from_rational(&scale, bits) * &groups.inertial_parameter;
                OperatingPoint {
                    normal_stress_pa: Ball::from_rational(stress, bits),
                    loading_velocity_m_per_s: square.sqrt(),
                }
            }
        }
    }
}
