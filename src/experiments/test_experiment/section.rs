//! `[test_experiment]`: normal stresses.

use crate::scene::AllowedRange;
use crate::scene::section::{ReadSection, Section};
use slipmode_core::number::Rational;

/// `[test_experiment]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestExperimentSection {
    /// Normal stresses, Pa.
    pub normal_stress_pa: Vec<Rational>,
}

impl ReadSection for TestExperimentSection {
    fn read(section: &mut Section<'_>) -> Self {
        let allowed = "a list of normal stresses in Pa";
        Self { normal_stress_pa: section.decimals("normal_stress_pa", allowed, AllowedRange::PHYSICAL) }
    }
}
