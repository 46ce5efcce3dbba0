//! Proofs over ℚ about the equations of a paper.
//!
//! The numbered equations are input data ([`Equations`]), and so are most proofs about them ([`stated_proofs`]). A procedure derives
//! its result from them, compares it with what the paper states, and returns the proof or the refutation: an equation with a wrong
//! sign is refuted by name, with the exact remainder.
//!
//! ```
//! use slipmode_theory::{AssumptionsText, EquationsText, Equations, Role};
//!
//! // The equations are input. A procedure finds those that it needs by their roles; here there are none.
//! let text = EquationsText { assumptions: AssumptionsText { positive: vec!["K".into()], ..Default::default() }, ..Default::default() };
//! let equations = Equations::read(text).unwrap();
//! assert_eq!(equations.missing(&[Role::Friction]), ["no equation has the role `friction`"]);
//! ```

// Tests compare with the system's elementary functions.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

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
mod equation;
mod equations;
mod equations_text;
#[doc(hidden)]
pub mod frequency_turns;
#[doc(hidden)]
pub mod hopf;
pub mod lyapunov_sign;
mod names;
mod notation;
pub mod planar;
mod quantities;
mod reached;
mod reading;
#[doc(hidden)]
pub mod regularised;
pub mod root_location;
pub mod stated_proofs;
#[doc(hidden)]
pub mod strip_frequency;
mod units;

pub use derivation::{Form as Derivation, Operation, System};
pub use equation::{Equation, EquationFault, Role};
pub use equations::{Equations, EquationsError};
pub use equations_text::{
    AssumptionsText, DefinitionText, EquationText, EquationsText, FunctionText, SystemText,
};
pub use names::{Meaning, Names, circle};
pub use quantities::QUANTITIES;
pub use reached::{Start, without_layout};
pub use units::Dimension;

#[cfg(test)]
mod tests;
