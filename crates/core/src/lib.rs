//! Linear stability and nonlinear motion of a spring-slider with rate-and-state friction.
//!
//! The slider has friction parameters a and b, a critical slip distance D_c, a stiffness K and a mass M per unit area. It is
//! driven at velocity V_0 under normal stress σ. This crate decides exactly whether steady sliding is stable and whether it
//! oscillates, computes roots and the stability boundary to any number of certain digits, and simulates the nonlinear motion
//! with estimated errors. The theory is that of Im & Avouac, *Linear stability analysis of the condition for vibration
//! during frictional slip*.
//!
//! ```
//! use slipmode_core::{EvolutionLaw, OperatingPoint, Slider};
//!
//! // a, b, D_c in m, K in Pa/m and M in kg/m². Texts are exact: "0.004" is 1/250.
//! let slider = Slider::new("0.004", "0.006", "1e-5", "1e7", "1000")?;
//! // σ = 1 MPa and V_0 = 10 µm/s.
//! let point = OperatingPoint::new("1e6", "1e-5")?;
//!
//! let found = slider.classify(&point);
//! assert_eq!(found.transition_sign, -1); // K < K_c: steady sliding is unstable
//! assert_eq!(found.slip_mode.to_string(), "stick-slip");
//!
//! let roots = slider.roots(&point, 30);
//! assert!(roots[2].real_per_s.to_f64() > 0.0);
//! let crossings = slider.boundary(20).at_loading_velocity("1e-5")?;
//! assert_eq!(crossings.len(), 3);
//! let run = slider.simulate(&point, EvolutionLaw::Aging, 1e-3)?;
//! assert!(run.peak_velocity_m_per_s > 1e-3 && run.peak_relative_error < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is checked, and where
//!
//! [`Slider::new`] and [`OperatingPoint::new`] refuse what is no number, not positive or out of range, all faults at once. What they
//! make is a slider, so that its answers need no further check: none of them panics.
//!
//! | question | item |
//! |---|---|
//! | Is steady sliding stable, does it oscillate, how fast does a disturbance grow? | [`Slider::classify`] |
//! | What are the three exponents s of a small disturbance, to any number of digits? | [`Slider::roots`] |
//! | Where does oscillation begin in the (V_0, σ) plane? | [`Slider::boundary`] |
//! | What does the slider do when it is far from steady sliding? | [`Slider::simulate`] |
//!
//! # Modules
//!
//! The modules of this crate are the machinery of the program slipmode. They are public because other packages of the program use them;
//! they are not part of the interface, and may change with any version.
//! A module imports lower ones only: `number` < `roots` < `friction` < {`stability`, `dynamics`} < `checked`.
//! `stability` and `dynamics` do not import each other, so that a simulation is an independent check of the linear theory.
//!
//! # Features
//!
//! - `rayon` (default): grids are classified on all processors; without it, on one, with the same results.
//! - `serde`: names of modes and classes, numbers, sliders and operating points can be written and read.

// Tests compare with the system's elementary functions.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

mod checked;
#[doc(hidden)]
pub mod dynamics;
#[doc(hidden)]
pub mod friction;
#[doc(hidden)]
pub mod number;
#[doc(hidden)]
pub mod roots;
#[doc(hidden)]
pub mod stability;

pub use checked::{
    Boundary, BoundaryPoint, Classification, Enclosed, Exact, InputError, InputErrors, NumberError,
    OperatingPoint, QuantityError, Root, Slider,
};
pub use dynamics::{Behaviour, Failure as SimulationError, Simulation};
pub use friction::{EvolutionLaw, Quantity, SlipMode};
pub use stability::{Arc, Asymptote, SpectralClass};
