//! `[onset]`: where oscillation begins along lines of constant normal stress, and runs on either side of it (fig 4).

use crate::scene::AllowedRange;
use crate::scene::section::{Entry, ReadSection, Section};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[onset]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnsetSection {
    /// Normal stresses, Pa.
    pub normal_stress_pa: Vec<Rational>,
    /// Loading velocities of the lines across eq 16, m/s; may be absent.
    pub loading_velocity_m_per_s: Vec<Rational>,
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
    fn read(section: &mut Section<'_>) -> Self {
        let physical = AllowedRange::PHYSICAL;
        let across = |entry: &Entry<'_>| entry.list(|member| member.decimal(physical));
        let read = Self {
            normal_stress_pa: section.decimals(
                "normal_stress_pa",
                "a list of normal stresses in Pa",
                physical,
            ),
            velocity_over_asymptote: section.decimals(
                "velocity_over_asymptote",
                "a list of ratios > 0",
                physical,
            ),
            loading_velocity_m_per_s: section
                .optionally("loading_velocity_m_per_s", across)
                .unwrap_or_default(),
            laws: section.laws(),
            tolerance: section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE),
            visible: section.decimal("visible", AllowedRange::OPEN_UNIT),
            other_unit_pa: section.optionally("other_unit_pa", |entry| entry.decimal(physical)),
        };
        let lines = read.normal_stress_pa.len() + read.loading_velocity_m_per_s.len();
        let runs = (RUNS_OF_A_SEARCH.saturating_mul(read.laws.len() as u64))
            .saturating_add(read.velocity_over_asymptote.len() as u64)
            .saturating_mul(lines as u64);
        section.check_points(runs);
        read
    }
}
