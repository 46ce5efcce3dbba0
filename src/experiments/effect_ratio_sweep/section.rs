//! `[effect_ratio_sweep]`: ratios b/a.

use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::{AllowedRange, LogAxis};
use slipmode_core::number::Rational;

/// `[effect_ratio_sweep]`: the asymptotes' worst errors against β = b/a.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EffectRatioSweepSection {
    /// β.
    pub effect_ratio: LogAxis,
    /// Distances |β − 1| at which a → b is looked at from both sides; each strictly between 0 and 1.
    pub near_equal: Vec<Rational>,
}

impl ReadSection for EffectRatioSweepSection {
    fn read(section: &mut Section<'_>) -> Self {
        let near_equal = |entry: &Entry<'_>| entry.list(|member| member.decimal(AllowedRange::OPEN_UNIT));
        Self {
            effect_ratio: section.axis("effect_ratio"),
            near_equal: section.optionally("near_equal", near_equal).unwrap_or_default(),
        }
    }
}
