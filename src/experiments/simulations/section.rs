//! `[simulations]`: the nonlinear slider on a (V, σ) grid.

use crate::scene::section::{ReadSection, Section};
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
    fn read(section: &mut Section<'_>) -> Self {
        let read = Self {
            rectangle: section.rectangle(),
            laws: section.laws(),
            tolerance: section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE),
        };
        section.check_points(read.rectangle.points().saturating_mul(read.laws.len() as u64));
        read
    }
}
