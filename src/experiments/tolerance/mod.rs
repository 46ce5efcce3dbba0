//! Where each asymptote is good to a given relative error.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;
pub(crate) mod words;

pub use run::{ToleranceOutcome, ToleranceRow};
pub(crate) use tables::place_of_limit;
pub(crate) use words::accuracy_of_asymptotes;

use crate::experiments::work::certified_point_s;
use crate::experiments::{Work, experiment};
use crate::scene::AllowedRange;
use slipmode_core::number::Rational;

experiment! {
    /// `[tolerance]`: where each asymptote is good to a relative error.
    pub struct ToleranceSection {
        /// Relative errors, each strictly between 0 and 1.
        pub relative: Vec<Rational> = |section, key| {
            section.decimals(key, "a list of relative errors, each 0 < value < 1", AllowedRange::OPEN_UNIT)
        },
    }
    outcome: ToleranceOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| Work::points(section.relative.len() as f64, 100.0 * certified_point_s(0.0)),
    run: |section, earlier, _| Some(run::tolerance_limits(earlier.slider()?, section)),
}
