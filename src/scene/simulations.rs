//! `[simulations]`: the nonlinear slider on a (V, σ) grid.

use crate::scene::section::Entry;
use crate::scene::sections::{axis, check_points};
use crate::scene::{AllowedRange, Faults, Limits, Problem, Rectangle, nearest};
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

impl SimulationsSection {
    pub(super) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
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

/// A list of evolution laws, each at most once.
pub(super) fn read_laws(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<EvolutionLaw>> {
    let mut seen = Vec::new();
    entry.list(faults, |member, faults| {
        let word = member.text(faults)?;
        let Some(law) = EvolutionLaw::from_word(&word) else {
            let words = EvolutionLaw::ALL.map(EvolutionLaw::as_str);
            let near = nearest(&word, words).map(str::to_string);
            faults.push(member.fault(Problem::UnknownWord { nearest: near, allowed: words.join(", ") }));
            return None;
        };
        if seen.contains(&law) {
            let of = format!("an earlier law `{word}`");
            faults.push(member.fault(Problem::Duplicate { of, folded: false }));
            return None;
        }
        seen.push(law);
        Some(law)
    })
}
