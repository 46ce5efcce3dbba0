//! Lines across the (V0, σ) plane and where they cross the boundary.

use rug::Rational;

use crate::friction::{Groups, Parameters};
use crate::number::Ball;
use crate::stability::Arc;

/// A line across the plane: one coordinate given, the other sought.
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
    /// The double root r of eq 8 there, in units of V0/D_c.
    pub double_root: Ball,
    /// σ, Pa.
    pub normal_stress_pa: Ball,
    /// V0, m/s.
    pub loading_velocity_m_per_s: Ball,
}

impl Section {
    /// η/κ = (V0/D_c)²·M/K on a section at given V0, which is the same at every σ.
    pub(super) fn velocity_squared(
        parameters: &Parameters<Rational>,
        velocity_m_per_s: &Rational,
    ) -> Rational {
        let rate = Rational::from(velocity_m_per_s / &parameters.critical_slip_distance_m);
        rate.square() / parameters.natural_angular_frequency_squared_per_s2()
    }

    /// κ on a section at given σ, which is the same at every V0.
    pub(super) fn stiffness_group(
        parameters: &Parameters<Rational>,
        normal_stress_pa: &Rational,
    ) -> Rational {
        stress_scale_pa(parameters) / normal_stress_pa
    }

    /// σ and V0 of the point of the section with these η and κ.
    pub(super) fn coordinates(
        &self,
        parameters: &Parameters<Rational>,
        groups: &Groups<Ball>,
        bits: u32,
    ) -> (Ball, Ball) {
        match self {
            Self::AtVelocity(velocity) => {
                let scale = Ball::from_rational(&stress_scale_pa(parameters), bits);
                (scale / &groups.stiffness_group, Ball::from_rational(velocity, bits))
            }
            Self::AtNormalStress(stress) => {
                let scale = velocity_scale_squared(parameters) / Self::stiffness_group(parameters, stress);
                let square = Ball::from_rational(&scale, bits) * &groups.inertial_parameter;
                (Ball::from_rational(stress, bits), crate::number::Real::sqrt(&square))
            }
        }
    }
}

/// K D_c/a, Pa: σ = (K D_c/a)/κ.
pub(super) fn stress_scale_pa(parameters: &Parameters<Rational>) -> Rational {
    parameters.stiffness_pa_per_m.clone() * &parameters.critical_slip_distance_m / &parameters.direct_effect
}

/// D_c²·K/M, m²/s²: V0² = (D_c² K/M)·η/κ.
pub(super) fn velocity_scale_squared(parameters: &Parameters<Rational>) -> Rational {
    parameters.critical_slip_distance_m.clone().square()
        * parameters.natural_angular_frequency_squared_per_s2()
}
