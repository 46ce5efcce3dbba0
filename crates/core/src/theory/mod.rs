//! The paper's derivations as proofs over ℚ.
//!
//! The numbered equations are input data ([`PaperEquations`]). Each function derives its result from eqs 1-4 (or from
//! what was derived from them), compares it with what the paper states, and returns the proof or the refutation:
//! an equation with a wrong sign is refuted by name, with the exact remainder.

pub mod areas;
pub mod asymptote_series;
pub mod boundary;
pub mod characteristic;
pub mod criteria;
pub mod emergence;
mod equations;
pub mod exchange;
pub mod frequency;
pub mod hopf;
pub mod inertial;
pub mod linearisation;
pub mod non_inertial;
mod notation;
pub mod period;
pub mod quasi_static;
mod reading;
pub mod regularised;
pub mod steady_state;
pub mod third_order;
pub mod transition;

pub use equations::{Equation, EquationFault, EquationsError, PaperEquations};
pub use reading::{AssumptionsText, EquationText, EquationsText};

#[cfg(test)]
mod tests;
