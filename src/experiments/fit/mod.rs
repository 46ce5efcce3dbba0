//! Friction parameters fitted to a record of velocity steps.

pub(crate) mod figures;
mod peaks;
pub(crate) mod run;
pub(crate) mod tables;
pub(crate) mod words;

pub(crate) use figures::fit_picture;
pub(crate) use peaks::peak_picture;
pub use run::FitOutcome;
pub use words::estimate_words;
pub(crate) use words::{fit_words, shares_of_modes};

use crate::experiments::{Work, experiment};
use crate::fitting::FitGiven;
use crate::scene::AllowedRange;
use crate::scene::section::Entry;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{Rational, nearest_f64};

/// Core-seconds of a fit with one law.
const SECONDS: f64 = 1.0;

experiment! {
    /// `[fit]`: a record of velocity steps, and what is known of the machine.
    pub struct FitSection {
        /// The record is NAME.csv.
        pub record: String = |section, key| section.name(key, "the name of the record NAME.csv"),
        /// The evolution laws, each once.
        pub laws: Vec<EvolutionLaw> = |section, _| section.laws(),
        /// K, Pa/m; fitted where it is absent.
        pub stiffness_pa_per_m: Option<Rational> = |section, key| section.optionally(key, given),
        /// M, kg/m²; no inertia where it is absent.
        pub mass_per_area_kg_per_m2: Option<Rational> = |section, key| section.optionally(key, given),
        /// Whether a linear drift is fitted.
        pub has_drift: bool = |section, _| section.optionally("drift", Entry::truth).unwrap_or_default(),
    }
    requires: Nothing,
    outcome: FitOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| Work::points(section.laws.len() as f64, SECONDS),
    run: FitOutcome::of,
}

fn given(entry: &Entry<'_>) -> Option<Rational> {
    entry.decimal(AllowedRange::PHYSICAL)
}

impl FitSection {
    /// What is known.
    pub(crate) fn given(&self) -> FitGiven {
        FitGiven {
            law: self.laws[0],
            stiffness_pa_per_m: self.stiffness_pa_per_m.as_ref().map(nearest_f64),
            mass_per_area_kg_per_m2: self.mass_per_area_kg_per_m2.as_ref().map(nearest_f64),
            has_drift: self.has_drift,
        }
    }
}
