//! The worst errors of the asymptotes against b/a.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use run::SweepRow;

use crate::experiments::work::certified_point_s;
use crate::experiments::{Work, experiment};
use crate::scene::section::Section;
use crate::scene::{AllowedRange, LogAxis};
use slipmode_core::number::Rational;

experiment! {
    /// `[effect_ratio_sweep]`: the asymptotes' worst errors against β = b/a.
    pub struct EffectRatioSweepSection {
        /// β.
        pub effect_ratio: LogAxis = Section::axis,
        /// Distances |β − 1| at which a → b is looked at from both sides; each strictly between 0 and 1.
        pub near_equal: Vec<Rational> = |section, key| section.any_decimals(key, AllowedRange::OPEN_UNIT),
    }
    requires: Nothing,
    outcome: Vec<SweepRow>,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| {
        let ratios = f64::from(section.effect_ratio.points) + 2.0 * section.near_equal.len() as f64;
        Work::points(ratios, 10.0 * certified_point_s(0.0))
    },
    run: |section, _, _| Some(run::sweep_effect_ratio(section)),
}
