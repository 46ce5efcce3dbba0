//! `[test_experiment]`: normal stresses.

use crate::scene::AllowedRange;
use crate::scene::section::{Entry, ReadSection};
use slipmode_core::number::Rational;

/// `[test_experiment]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestExperimentSection {
    /// Normal stresses, Pa.
    pub normal_stress_pa: Vec<Rational>,
}

impl ReadSection for TestExperimentSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let allowed = "a list of normal stresses in Pa";
        let normal_stress_pa = section.decimals("normal_stress_pa", allowed, AllowedRange::PHYSICAL);
        section.finish();
        Some(Self { normal_stress_pa: normal_stress_pa? })
    }
}
