//! The worst errors of the asymptotes against b/a.

pub(crate) mod run;

pub use run::{SweepOutcome, SweepRow, sweep_effect_ratio};
