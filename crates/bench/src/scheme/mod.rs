//! The fixed-step scheme of the original simulations compared with converged runs: its bias, its order, and what becomes of figs 3a and 5.

mod figures;
mod least_peak;
mod long_term;
mod run;
mod stability;
mod stepping;
mod tables;

pub use figures::figure;
pub use least_peak::SchemeLeastPeak;
pub(crate) use long_term::highest;
pub use long_term::{AFFORDABLE_STEPS, SchemePeak};
pub use run::{Asked, SchemeOutcome, SchemeSeries, SchemeStep, original_scheme};
pub use stability::{SchemeMapRow, SchemeTransition, critical_shift};
pub use stepping::OriginalScheme;
pub use tables::tables;
