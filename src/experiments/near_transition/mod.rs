//! The nonlinear slider close to K = K_c.

pub(crate) mod bistability;
pub(crate) mod cycle_families;
mod edge_law;
pub(crate) mod figures;
pub(crate) mod kicks;
pub(crate) mod run;
pub(crate) mod tables;

pub use bistability::{Edge, Threshold};
pub use cycle_families::{AmplitudeDeviation, CycleFamilyOutcome, FamilyCycle};
pub use edge_law::EdgeLaw;
pub use kicks::{Border, SmallestKick};
pub use run::{NearRun, NearTransitionOutcome};

use crate::experiments::linear_regime::product;
use crate::experiments::{Work, experiment};
use crate::scene::AllowedRange;
use crate::scene::section::{Section, keys};
use slipmode_core::number::{Rational, nearest_f64};

experiment! {
    /// `[near_transition]`: the nonlinear slider close to K = K_c, by η and K/K_c instead of V and σ.
    pub struct NearTransitionSection {
        /// η of the runs.
        pub inertial_parameter: Vec<Rational> = ratios,
        /// K/K_c of the runs, each taken at every η.
        pub stiffness_over_critical: Vec<Rational> = ratios,
        /// η at which the largest K/K_c with a cycle is sought.
        pub edge_inertial_parameter: Vec<Rational> = ratios,
        /// Permitted relative error of peak velocity and period of the runs.
        pub tolerance: Rational = |section, key| section.decimal(key, AllowedRange::SIMULATION_TOLERANCE),
        /// Where the smallest kicks that end steady sliding are sought.
        pub kicks: Option<KicksSection> = |section, key| {
            section.optionally(key, |entry| entry.table(KicksSection::read))
        },
    }
    points: |section| {
        let runs = product(&[section.inertial_parameter.len(), section.stiffness_over_critical.len()]);
        let kicks = section.kicks.as_ref().map_or(0, |kicks| kicks.stiffness_over_critical.len());
        runs.saturating_add((section.edge_inertial_parameter.len() + kicks) as u64)
    },
    requires: CriticalNormalStress,
    outcome: NearTransitionOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| {
        let grid = section.inertial_parameter.len() as f64 * section.stiffness_over_critical.len() as f64;
        let runs = (grid + section.edge_inertial_parameter.len() as f64) * 10.0;
        Work::simulations(runs, nearest_f64(&section.tolerance))
    },
    run: |section, earlier, _| Some(run::near_transition(earlier.slider()?, section)),
}

keys! {
    /// `[near_transition.kicks]`.
    pub struct KicksSection {
        /// η.
        pub inertial_parameter: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
        /// K/K_c, each taken with both laws.
        pub stiffness_over_critical: Vec<Rational> = |section, key| {
            section.decimals(key, "a list of ratios > 1", AllowedRange::ABOVE_ONE)
        },
    }
}

fn ratios(section: &mut Section<'_>, key: &'static str) -> Vec<Rational> {
    section.decimals(key, "a list of ratios > 0", AllowedRange::PHYSICAL)
}
