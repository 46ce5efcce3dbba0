//! A slider that its own weight presses on: slip modes over loading velocity and K/M.

pub(crate) mod figures;
pub(crate) mod run;

pub use run::OwnWeightOutcome;

use crate::experiments::work::DECISION_S;
use crate::experiments::{Work, experiment};
use crate::scene::section::Section;
use crate::scene::{AllowedRange, LogAxis};
use slipmode_core::number::Rational;

experiment! {
    /// `[own_weight]`: the gravity that makes the normal stress M·g, and the plane.
    pub struct OwnWeightSection {
        /// g, m/s².
        pub gravity_m_per_s2: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
        /// Loading velocities, m/s.
        pub loading_velocity_m_per_s: LogAxis = Section::axis,
        /// K/M, 1/s².
        pub stiffness_over_mass_per_s2: LogAxis = Section::axis,
    }
    points: Self::points,
    outcome: OwnWeightOutcome,
    figures: [figures::FIGURES],
    work: |section| Work::points(section.points() as f64, DECISION_S),
    run: |section, earlier, _| Some(run::own_weight(earlier.slider()?, section, &earlier.scene.threshold())),
}

impl OwnWeightSection {
    /// The points of the plane.
    fn points(&self) -> u64 {
        u64::from(self.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(self.stiffness_over_mass_per_s2.points))
    }
}
