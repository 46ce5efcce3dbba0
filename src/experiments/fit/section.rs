//! `[fit]`: a record of velocity steps, and what is known of the machine.

use crate::fitting::FitGiven;
use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::{AllowedRange, Quantity};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{Rational, nearest_f64};

/// `[fit]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FitSection {
    /// The record is NAME.csv.
    pub record: String,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// K, Pa/m; fitted where it is absent.
    pub stiffness_pa_per_m: Option<Rational>,
    /// M, kg/m²; no inertia where it is absent.
    pub mass_per_area_kg_per_m2: Option<Rational>,
    /// Whether a linear drift is fitted.
    pub has_drift: bool,
}

impl ReadSection for FitSection {
    fn read(section: &mut Section<'_>) -> Self {
        let given = |entry: &Entry<'_>| entry.decimal(AllowedRange::PHYSICAL);
        Self {
            record: section.name("record", "the name of the record NAME.csv"),
            laws: section.laws(),
            stiffness_pa_per_m: section.optionally(Quantity::Stiffness.as_str(), given),
            mass_per_area_kg_per_m2: section.optionally(Quantity::MassPerArea.as_str(), given),
            has_drift: section.optionally("drift", Entry::truth).unwrap_or_default(),
        }
    }
}

impl FitSection {
    /// What is known.
    #[must_use]
    pub fn given(&self) -> FitGiven {
        FitGiven {
            law: self.laws[0],
            stiffness_pa_per_m: self.stiffness_pa_per_m.as_ref().map(nearest_f64),
            mass_per_area_kg_per_m2: self.mass_per_area_kg_per_m2.as_ref().map(nearest_f64),
            has_drift: self.has_drift,
        }
    }
}
