//! `[start_sensitivity]`: every completion of the start V_l/10 at a few points (V, σ).

use crate::experiments::linear_regime::section::product;
use crate::scene::section::{ReadSection, Section};
use crate::scene::{AllowedRange, PlanePoint};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[start_sensitivity]`: every completion of the start V_l/10.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StartSensitivitySection {
    /// V (m/s) and σ (Pa) of each point.
    pub points: Vec<PlanePoint>,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: Rational,
}

impl ReadSection for StartSensitivitySection {
    fn read(section: &mut Section<'_>) -> Self {
        let read = Self {
            points: section.places("points"),
            laws: section.laws(),
            tolerance: section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE),
        };
        section.check_points(product(&[read.points.len(), read.laws.len(), 4]));
        read
    }
}
