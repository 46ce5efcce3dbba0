//! `[start_sensitivity]`: every completion of the start V_l/10 at a few points (V, σ).

use crate::experiments::linear_regime::section::{laws, points, product};
use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::check_points;
use crate::scene::{AllowedRange, Faults, Limits};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[start_sensitivity]`: every completion of the start V_l/10.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StartSensitivitySection {
    /// V (m/s) and σ (Pa) of each point.
    pub points: Vec<[Rational; 2]>,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: Rational,
}

impl ReadSection for StartSensitivitySection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let points = points(&mut section, faults);
        let laws = laws(&mut section, faults);
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerance = section
            .required("tolerance", &range.text(), faults)
            .and_then(|entry| entry.decimal(range, faults));
        section.finish(faults);
        let read = Self { points: points?, laws: laws?, tolerance: tolerance? };
        check_points(entry, product(&[read.points.len(), read.laws.len(), 4]), limits, faults)?;
        Some(read)
    }
}
