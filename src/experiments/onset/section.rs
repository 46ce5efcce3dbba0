//! `[onset]`: where oscillation begins along lines of constant normal stress, and runs on either side of it (fig 4).

use crate::scene::laws::read_laws;
use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::check_points;
use crate::scene::{AllowedRange, Faults, Limits};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[onset]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnsetSection {
    /// Normal stresses, Pa.
    pub normal_stress_pa: Vec<Rational>,
    /// Velocities of the runs to show, in units of the asymptote's velocity (eq 20, or eq 18 on the upper arc).
    pub velocity_over_asymptote: Vec<Rational>,
    /// The evolution laws, each once; the runs to show take the first.
    pub laws: Vec<EvolutionLaw>,
    /// Permitted relative error of a run.
    pub tolerance: Rational,
    /// Depth of an undershoot below V_l, relative to V_l, from which on a reader sees it.
    pub visible: Rational,
    /// A unit in which the normal stresses might have been meant instead, in Pa; absent when the unit is clear.
    pub other_unit_pa: Option<Rational>,
}

/// Runs that one search needs at most: the count that is compared with the limit of points.
const RUNS_OF_A_SEARCH: u64 = 200;

impl ReadSection for OnsetSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let physical = AllowedRange::PHYSICAL;
        let mut list = |key, allowed: &str, faults: &mut Faults| {
            section
                .required(key, allowed, faults)
                .and_then(|entry| entry.list(faults, |member, faults| member.decimal(physical, faults)))
        };
        let stresses = list("normal_stress_pa", "a list of normal stresses in Pa", faults);
        let velocities = list("velocity_over_asymptote", "a list of ratios > 0", faults);
        let laws = section
            .required("laws", "a list of \"slip\" and \"aging\"", faults)
            .and_then(|entry| read_laws(&entry, faults));
        let mut decimal = |key, range: AllowedRange, faults: &mut Faults| {
            section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults))
        };
        let tolerance = decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE, faults);
        let visible = decimal("visible", AllowedRange::OPEN_UNIT, faults);
        let other_unit = section.optional("other_unit_pa").map(|entry| entry.decimal(physical, faults));
        section.finish(faults);
        let (stresses, velocities, laws) = (stresses?, velocities?, laws?);
        let runs = (RUNS_OF_A_SEARCH.saturating_mul(laws.len() as u64))
            .saturating_add(velocities.len() as u64)
            .saturating_mul(stresses.len() as u64);
        check_points(entry, runs, limits, faults)?;
        Some(Self {
            normal_stress_pa: stresses,
            velocity_over_asymptote: velocities,
            laws,
            tolerance: tolerance?,
            visible: visible?,
            other_unit_pa: match other_unit {
                None => None,
                Some(read) => Some(read?),
            },
        })
    }
}
