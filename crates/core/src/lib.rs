//! Linear stability and nonlinear motion of a spring-slider with rate-and-state friction.
//!
//! The slider has friction parameters a and b, a critical slip distance D_c, a stiffness K and a mass M per unit area. It is
//! driven at velocity V_0 under normal stress σ. This crate decides exactly whether steady sliding is stable and whether it
//! oscillates, computes roots and the stability boundary to any number of certain digits, and simulates the nonlinear motion
//! with estimated errors. The theory is that of Im & Avouac, *Linear stability analysis of the condition for vibration
//! during frictional slip*.
//!
//! ```
//! use slipmode_core::{InertialThreshold, Slider, classify, parse_decimal};
//!
//! // a, b, D_c in m, K in Pa/m and M in kg/m²; decimals are exact: 0.004 is 1/250.
//! let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(|text| parse_decimal(text).unwrap()));
//! // σ = 1 MPa and V_0 = 10 µm/s.
//! let parameters = slider.at(parse_decimal("1e6").unwrap(), parse_decimal("1e-5").unwrap());
//!
//! let found = classify(&parameters, &InertialThreshold::default());
//! assert_eq!(found.transition_sign, -1); // K < K_c: steady sliding is unstable
//! assert_eq!(found.slip_mode.as_str(), "stick-slip");
//! ```
//!
//! # Entry points
//!
//! | question | item |
//! |---|---|
//! | Is steady sliding stable, does it oscillate, how fast does a disturbance grow? | [`classify`] |
//! | What are the three exponents s of a small disturbance, in 64-bit numbers? | [`three_roots`], [`stability::batch::three_roots_of_points`] |
//! | The same to any number of digits? | [`certified_roots`] of [`Parameters::characteristic_cubic_per_s`] |
//! | The classes of many points? | [`stability::batch`] |
//! | Where does oscillation begin in the (V_0, σ) plane? | [`BoundaryCurve`], [`Asymptote`] |
//! | What does the slider do when it is far from steady sliding? | [`simulate`] |
//!
//! # Modules
//!
//! A module imports lower ones only: `number` < `roots` < `friction` < {`theory`, `stability`, `dynamics`}.
//! `theory`, `stability` and `dynamics` do not import each other, so that a simulation is an independent check of the linear theory.
//!
//! # Features
//!
//! - `rayon` (default): grids are classified on all processors; without it, on one, with the same results.
//! - `serde`: `Serialize` for the names of slip modes, classes and precision levels, and `Deserialize` for the texts of equations.

// Tests compare with the system's elementary functions.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod dynamics;
pub mod friction;
pub mod number;
pub mod roots;
pub mod stability;
pub mod theory;

pub use dynamics::{Options as SimulationOptions, Simulation, simulate};
pub use friction::{EvolutionLaw, Groups, OperatingPoint, Parameters, Slider, SlipMode};
pub use number::{Ball, DecimalError, Rational, parse_decimal};
pub use roots::{CertifiedRoot, CertifiedRoots, PrecisionLevel, certified_roots};
pub use slipmode_algebra::nearest;
pub use stability::{
    Arc, Asymptote, BoundaryCurve, BoundaryPoint, Classification, InertialThreshold, RootsError,
    SpectralClass, ThreeRoots, classify, three_roots,
};
