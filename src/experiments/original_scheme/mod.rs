//! The fixed-step scheme of the original simulations compared with converged runs.

pub(crate) mod figures;
pub(crate) mod least_peak;
pub(crate) mod run;
pub(crate) mod scheme;
pub(crate) mod section;
pub(crate) mod stability;
pub(crate) mod tables;

pub use least_peak::SchemeLeastPeak;
pub use run::{OriginalSchemeOutcome, SchemeSeries, SchemeStep, original_scheme};
pub use scheme::{AFFORDABLE_STEPS, SchemePeak};
pub use section::{ErrorBoundSection, OriginalSchemeSection, Place, WorkPrecisionSection};
pub use stability::{SchemeMapRow, SchemeTransition, critical_shift};
