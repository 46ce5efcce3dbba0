//! `[simulations]`: the nonlinear slider on a (V, σ) grid, and next to the transition.

use crate::friction::EvolutionLaw;
use crate::number::Rational;
use crate::scene::section::{Entry, Section};
use crate::scene::sections::{axis, check_points};
use crate::scene::{AllowedRange, Faults, Limits, Problem, Rectangle, nearest};

/// `[simulations]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SimulationsSection {
    /// The points to simulate.
    pub rectangle: Rectangle,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: Rational,
    /// Runs at a given η and K/K_c besides those of the grid.
    pub near_transition: Option<NearTransition>,
}

/// `[simulations.near_transition]`: finite starts close to K = K_c.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NearTransition {
    /// η.
    pub inertial_parameter: Rational,
    /// K/K_c of each run.
    pub stiffness_over_critical: Vec<Rational>,
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
        let near_transition = section.optional("near_transition").map(|entry| read_near(&entry, faults));
        section.finish(faults);
        let rectangle = Rectangle { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? };
        let laws = laws?;
        let runs = u64::from(rectangle.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(rectangle.normal_stress_pa.points))
            .saturating_mul(laws.len() as u64);
        check_points(entry, runs, limits, faults)?;
        let near_transition = match near_transition {
            None => None,
            Some(read) => Some(read?),
        };
        Some(Self { rectangle, laws, tolerance: tolerance?, near_transition })
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

fn read_near(entry: &Entry<'_>, faults: &mut Faults) -> Option<NearTransition> {
    let mut section: Section<'_> = entry.section(faults)?;
    let range = AllowedRange::PHYSICAL;
    let inertial = section
        .required("inertial_parameter", &range.text(), faults)
        .and_then(|entry| entry.decimal(range, faults));
    let ratios = section
        .required("stiffness_over_critical", "a list of ratios > 0", faults)
        .and_then(|entry| entry.list(faults, |member, faults| member.decimal(range, faults)));
    section.finish(faults);
    Some(NearTransition { inertial_parameter: inertial?, stiffness_over_critical: ratios? })
}
