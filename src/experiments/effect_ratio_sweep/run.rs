//! The asymptotes' worst errors against β = b/a, on which alone they depend.

use crate::parallel;

use crate::experiments::effect_ratio_sweep::EffectRatioSweepSection;
use crate::experiments::map::run::exactly;
use slipmode_core::number::Rational;
use slipmode_core::stability::deviation::{CornerErrors, corner_errors};

/// The worst errors at one ratio of effects.
#[derive(Debug, Clone)]
pub struct SweepRow {
    /// β, exact.
    pub effect_ratio: Rational,
    /// The errors that bound all others.
    pub errors: CornerErrors,
}

/// Digits of each enclosure: more than any table or figure shows.
const DIGITS: u32 = 20;

/// Computes the worst errors along the axis, and at β = 1 ± each near-equal distance: rows by ascending β.
pub(super) fn sweep_effect_ratio(section: &EffectRatioSweepSection) -> Vec<SweepRow> {
    let one = || Rational::from(1);
    let near = section.near_equal.iter().flat_map(|distance| [one() - distance, one() + distance]);
    let mut ratios: Vec<Rational> =
        section.effect_ratio.coordinates().into_iter().map(exactly).chain(near).collect();
    ratios.sort();
    ratios.dedup();
    let row =
        |ratio: &Rational| SweepRow { errors: corner_errors(ratio, DIGITS), effect_ratio: ratio.clone() };
    parallel::map(&ratios, row)
}
