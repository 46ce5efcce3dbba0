//! `[start_sensitivity]`: every completion of the start V_l/10 at a few points (V, σ).

use crate::experiments::linear_regime::section::product;
use crate::scene::section::{Entry, ReadSection};
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
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let points = section.places("points");
        let laws = section.laws();
        let tolerance = section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE);
        section.finish();
        let read = Self { points: points?, laws: laws?, tolerance: tolerance? };
        entry.check_points(product(&[read.points.len(), read.laws.len(), 4]))?;
        Some(read)
    }
}
