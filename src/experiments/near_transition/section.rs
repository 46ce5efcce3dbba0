//! `[near_transition]`: the nonlinear slider close to K = K_c, by η and K/K_c instead of V and σ.

use crate::scene::AllowedRange;
use crate::scene::section::{Entry, ReadSection};
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
    /// Where the smallest kicks that end steady sliding are sought.
    pub kicks: Option<KicksSection>,
}

/// `[near_transition.kicks]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KicksSection {
    /// η.
    pub inertial_parameter: Rational,
    /// K/K_c, each taken with both laws.
    pub stiffness_over_critical: Vec<Rational>,
}

impl ReadSection for KicksSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let inertial_parameter = section.decimal("inertial_parameter", AllowedRange::PHYSICAL);
        let stiffness =
            section.decimals("stiffness_over_critical", "a list of ratios > 1", AllowedRange::ABOVE_ONE);
        section.finish();
        Some(Self { inertial_parameter: inertial_parameter?, stiffness_over_critical: stiffness? })
    }
}

impl ReadSection for NearTransitionSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let [inertial, stiffness, edge] =
            ["inertial_parameter", "stiffness_over_critical", "edge_inertial_parameter"]
                .map(|key| section.decimals(key, "a list of ratios > 0", AllowedRange::PHYSICAL));
        let tolerance = section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE);
        let kicks = section.optionally("kicks", KicksSection::read);
        section.finish();
        let near = Self {
            inertial_parameter: inertial?,
            stiffness_over_critical: stiffness?,
            edge_inertial_parameter: edge?,
            tolerance: tolerance?,
            kicks: kicks?,
        };
        let runs = near.inertial_parameter.len().saturating_mul(near.stiffness_over_critical.len());
        let kicks = near.kicks.as_ref().map_or(0, |kicks| kicks.stiffness_over_critical.len());
        let points = runs.saturating_add(near.edge_inertial_parameter.len()).saturating_add(kicks);
        entry.check_points(u64::try_from(points).unwrap_or(u64::MAX))?;
        Some(near)
    }
}
