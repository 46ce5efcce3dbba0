//! Friction parameters from a record of velocity steps: least squares over the nonlinear slider, intervals by profile likelihood.
//!
//! A record states the path of the load point and the spring stress. The model is the slider of [`slipmode_core::dynamics::drive`]; its
//! derivatives are those of the discrete run. Nothing here opens a file.

mod estimate;
mod least_squares;
mod load_path;
mod parameter;
mod peak_profile;
mod peak_rows;
mod peaks;
mod problem;
mod profile;
mod record;
mod record_faults;
mod residuals;
mod sampled_modes;
mod start;
mod words;

pub use estimate::{Estimate, Fit, FitFailure, Fits, LawComparison};
pub use load_path::LoadPath;
pub use parameter::{Parameter, slider};
pub use peak_profile::CaseFit;
pub use peak_rows::{LEAST_ROWS, PeakFailure, PeakGiven, PeakRow};
pub use peaks::{EFFECT_RATIOS, PeakComparison, PeakFit, PeakFits, fit_peaks, hidden_part};
pub use problem::FitGiven;
pub use profile::ProfilePoint;
pub use record::{Load, Measured, Response, StepRecord};
pub use record_faults::{Column, RecordFault};
pub use residuals::Residuals;
pub(crate) use sampled_modes::{SAMPLES, sampled_modes};
pub(crate) use words::{advice, comparison_words};
