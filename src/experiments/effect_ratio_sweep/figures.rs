//! The figure of the asymptotes' largest errors.

use crate::experiments::effect_ratio_sweep::SweepRow;
use crate::experiments::{Drawer, Words};
use slipmode_core::number::{Ball, nearest_f64};

pub(crate) const FIGURES: &[Drawer] = &[("corners", |outcome, words| {
    worst_errors(outcome.scenes.iter().find_map(|scene| scene.effect_ratio_sweep.as_ref())?, words)
})];

fn worst_errors(sweep: &[SweepRow], words: &Words) -> Option<String> {
    let line = |worst: fn(&SweepRow) -> Option<&Ball>| {
        let place =
            |row: &SweepRow| (nearest_f64(&row.effect_ratio), worst(row).map_or(f64::NAN, Ball::to_f64));
        sweep.iter().map(place).collect()
    };
    let upper = line(|row| row.errors.upper_worst_log10.as_ref());
    words.line_chart([upper, line(|row| Some(&row.errors.lower_worst_log10))])
}
