//! `[near_transition]`: the nonlinear slider close to K = K_c, by η and K/K_c instead of V and σ.

use crate::experiments::linear_regime::section::product;
use crate::scene::AllowedRange;
use crate::scene::section::{ReadSection, Section};
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
    fn read(section: &mut Section<'_>) -> Self {
        let (allowed, range) = ("a list of ratios > 1", AllowedRange::ABOVE_ONE);
        Self {
            inertial_parameter: section.decimal("inertial_parameter", AllowedRange::PHYSICAL),
            stiffness_over_critical: section.decimals("stiffness_over_critical", allowed, range),
        }
    }
}

impl ReadSection for NearTransitionSection {
    fn read(section: &mut Section<'_>) -> Self {
        let (allowed, range) = ("a list of ratios > 0", AllowedRange::PHYSICAL);
        let read = Self {
            inertial_parameter: section.decimals("inertial_parameter", allowed, range),
            stiffness_over_critical: section.decimals("stiffness_over_critical", allowed, range),
            edge_inertial_parameter: section.decimals("edge_inertial_parameter", allowed, range),
            tolerance: section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE),
            kicks: section.optionally("kicks", |entry| entry.table(KicksSection::read)),
        };
        let runs = product(&[read.inertial_parameter.len(), read.stiffness_over_critical.len()]);
        let kicks = read.kicks.as_ref().map_or(0, |kicks| kicks.stiffness_over_critical.len());
        let others = (read.edge_inertial_parameter.len() + kicks) as u64;
        section.check_points(runs.saturating_add(others));
        read
    }
}
