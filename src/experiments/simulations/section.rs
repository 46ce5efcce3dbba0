//! `[simulations]`: the nonlinear slider on a (V, σ) grid.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::{AllowedRange, Rectangle};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[simulations]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SimulationsSection {
    /// The points to simulate.
    pub rectangle: Rectangle,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: Rational,
}

impl ReadSection for SimulationsSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let rectangle = section.rectangle();
        let laws = section.laws();
        let tolerance = section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE);
        section.finish();
        let (rectangle, laws) = (rectangle?, laws?);
        entry.check_points(rectangle.points().saturating_mul(laws.len() as u64))?;
        Some(Self { rectangle, laws, tolerance: tolerance? })
    }
}
