//! The paper's derivations as proofs over ℚ.
//!
//! The numbered equations are input data ([`Equations`]). Each function derives its result from eqs 1-4 (or from
//! what was derived from them), compares it with what the paper states, and returns the proof or the refutation:
//! an equation with a wrong sign is refuted by name, with the exact remainder.
//!
//! ```
//! use slipmode_core::theory::{AssumptionsText, EquationsText, Equations};
//!
//! // The equations are input. A list without eq 1 is one of another paper: the derivations here cannot start from it.
//! let text = EquationsText { assumptions: AssumptionsText { positive: vec!["K".into()], ..Default::default() }, ..Default::default() };
//! let error = Equations::read(text).unwrap().demand_paper().unwrap_err();
//! assert!(error.faults.iter().any(|fault| fault.key == "equation 1"), "{error}");
//! ```

#[doc(hidden)]
pub mod asymptote_series;
#[doc(hidden)]
pub mod boundary;
mod definedness;
mod definitions;
#[doc(hidden)]
pub mod derivation;
#[doc(hidden)]
pub mod emergence;
mod equations;
#[doc(hidden)]
pub mod frequency_turns;
#[doc(hidden)]
pub mod hopf;
mod names;
mod notation;
mod paper;
#[doc(hidden)]
pub mod period;
pub mod planar;
mod reached;
mod reading;
#[doc(hidden)]
pub mod regularised;
pub mod root_location;
pub mod stated_proofs;
#[doc(hidden)]
pub mod strip_frequency;
#[doc(hidden)]
pub mod sufficient_inertia;
mod units;
pub mod weak_instability;

pub use derivation::{Form as Derivation, Operation, System};
pub use equations::{Equation, EquationFault, Equations, EquationsError};
pub use names::{Meaning, Names};
pub use reached::{Start, without_layout};
pub use reading::{AssumptionsText, DefinitionText, EquationText, EquationsText, FunctionText, SystemText};
pub use units::Dimension;

#[cfg(test)]
mod tests;
