//! `[effect_ratio_sweep]`: ratios b/a.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::{axis, open_unit_list};
use crate::scene::{Faults, Limits, LogAxis};
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
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let effect_ratio = axis(&mut section, "effect_ratio", limits, faults);
        let near_equal = match section.optional("near_equal") {
            Some(entry) => open_unit_list(&entry, faults),
            None => Some(Vec::new()),
        };
        section.finish(faults);
        Some(Self { effect_ratio: effect_ratio?, near_equal: near_equal? })
    }
}
