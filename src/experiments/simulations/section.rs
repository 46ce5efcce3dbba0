//! `[simulations]`: the nonlinear slider on a (V, σ) grid.

use crate::scene::laws::read_laws;
use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::{axis, check_points};
use crate::scene::{AllowedRange, Faults, Limits, Rectangle};
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
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let velocity = axis(&mut section, "loading_velocity_m_per_s", limits, faults);
        let stress = axis(&mut section, "normal_stress_pa", limits, faults);
        let laws = section
            .required("laws", "a list of \"slip\" and \"aging\"", faults)
            .and_then(|entry| read_laws(&entry, faults));
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerance = section
            .required("tolerance", &range.text(), faults)
            .and_then(|entry| entry.decimal(range, faults));
        section.finish(faults);
        let rectangle = Rectangle { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? };
        let laws = laws?;
        let runs = u64::from(rectangle.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(rectangle.normal_stress_pa.points))
            .saturating_mul(laws.len() as u64);
        check_points(entry, runs, limits, faults)?;
        Some(Self { rectangle, laws, tolerance: tolerance? })
    }
}
