//! `[operating_point]`: the slip mode at σ and V0 of `[parameters]`, what leaves it, and which error bar decides it.

use crate::scene::section::{ReadSection, Section};

/// `[operating_point]`; it has no keys.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OperatingPointSection;

impl ReadSection for OperatingPointSection {
    fn read(_: &mut Section<'_>) -> Self {
        Self
    }
}
