//! `[own_weight]`: a slider that its own weight presses on, in the plane of loading velocity and K/M.

use crate::scene::section::{ReadSection, Section};
use crate::scene::{AllowedRange, LogAxis};
use slipmode_core::number::Rational;

/// `[own_weight]`: the gravity that makes the normal stress M·g, and the plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OwnWeightSection {
    /// g, m/s².
    pub gravity_m_per_s2: Rational,
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
    /// K/M, 1/s².
    pub stiffness_over_mass_per_s2: LogAxis,
}

impl OwnWeightSection {
    /// The points of the plane.
    #[must_use]
    pub fn points(&self) -> u64 {
        u64::from(self.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(self.stiffness_over_mass_per_s2.points))
    }
}

impl ReadSection for OwnWeightSection {
    fn read(section: &mut Section<'_>) -> Self {
        let read = Self {
            gravity_m_per_s2: section.decimal("gravity_m_per_s2", AllowedRange::PHYSICAL),
            loading_velocity_m_per_s: section.axis("loading_velocity_m_per_s"),
            stiffness_over_mass_per_s2: section.axis("stiffness_over_mass_per_s2"),
        };
        section.check_points(read.points());
        read
    }
}
