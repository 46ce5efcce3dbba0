//! `[near_transition]`: the nonlinear slider close to K = K_c, by η and K/K_c instead of V and σ.

use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::sections::check_points;
use crate::scene::{AllowedRange, Faults, Limits};
use slipmode_core::number::Rational;

/// `[near_transition]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NearTransitionSection {
    /// η of the runs.
    pub inertial_parameter: Vec<Rational>,
    /// K/K_c of the runs, each taken at every η.
    pub stiffness_over_critical: Vec<Rational>,
    /// η at which the largest K/K_c with a cycle is sought.
    pub edge_inertial_parameter: Vec<Rational>,
    /// Permitted relative error of peak velocity and period of the runs.
    pub tolerance: Rational,
}

impl ReadSection for NearTransitionSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let inertial = ratios(&mut section, "inertial_parameter", faults);
        let stiffness = ratios(&mut section, "stiffness_over_critical", faults);
        let edge = ratios(&mut section, "edge_inertial_parameter", faults);
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerance = section
            .required("tolerance", &range.text(), faults)
            .and_then(|entry| entry.decimal(range, faults));
        section.finish(faults);
        let near = Self {
            inertial_parameter: inertial?,
            stiffness_over_critical: stiffness?,
            edge_inertial_parameter: edge?,
            tolerance: tolerance?,
        };
        let runs = near.inertial_parameter.len().saturating_mul(near.stiffness_over_critical.len());
        let points = runs.saturating_add(near.edge_inertial_parameter.len());
        check_points(entry, u64::try_from(points).unwrap_or(u64::MAX), limits, faults)?;
        Some(near)
    }
}

fn ratios(section: &mut Section<'_>, key: &'static str, faults: &mut Faults) -> Option<Vec<Rational>> {
    let range = AllowedRange::PHYSICAL;
    section
        .required(key, "a list of ratios > 0", faults)
        .and_then(|entry| entry.list(faults, |member, faults| member.decimal(range, faults)))
}
