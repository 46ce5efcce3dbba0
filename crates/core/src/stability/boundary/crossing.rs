//! Lines across the (V0, σ) plane and where they cross the boundary.

use rug::Rational;

use crate::friction::{OperatingPoint, Parameters, Slider};
use crate::number::Ball;
use crate::stability::Arc;
use crate::stability::inverse::Unknown;

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
pub struct BoundaryCrossing {
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

    /// What is sought, and the parameters with another number in its place.
    pub(in crate::stability) fn unknown(&self, slider: &Slider<Rational>) -> (Unknown, Parameters<Rational>) {
        let any = Rational::from(1);
        match self {
            Self::AtVelocity(velocity) => (Unknown::NormalStress, slider.at(any, velocity.clone())),
            Self::AtNormalStress(stress) => (Unknown::LoadingVelocity, slider.at(stress.clone(), any)),
        }
    }
}
