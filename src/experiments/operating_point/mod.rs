//! A scene's own operating point: its slip mode, the smallest changes that leave it, and which error bar decides it.

pub(crate) mod error_bars;
pub(crate) mod figures;
pub(crate) mod mark;
pub(crate) mod reach;
pub(crate) mod run;
pub(crate) mod tables;
pub(crate) mod words;

pub use error_bars::Bar;
pub use run::{Change, OperatingPointOutcome};
pub(crate) use words::{
    error_bars, first_point, operating_point_words, range_words, what_decides_words, what_leaves_words,
};

use crate::experiments::{Work, experiment};

/// Core-seconds of an operating point with error bars.
const SECONDS: f64 = 1.0;

experiment! {
    /// `[operating_point]`: the point of `[parameters]`; the section has no keys.
    pub struct OperatingPointSection {}
    requires: OperatingPoint,
    outcome: OperatingPointOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |_| Work::points(1.0, SECONDS),
    run: |_, earlier, _| OperatingPointOutcome::of(earlier),
}
