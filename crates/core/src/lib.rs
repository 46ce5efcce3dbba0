//! When does a slider with rate-and-state friction stick, creep, oscillate or vibrate - and how sure are we?
//!
//! Exact signs over the rationals, certified roots, the exact stability boundary, proofs of the linear theory of
//! Im & Avouac, *Linear stability analysis of the condition for vibration during frictional slip*, and simulations
//! of the nonlinear slider with estimated errors.
//!
//! Modules stand on floors and import lower floors only (`cargo xtask tidy` enforces it):
//! `number` < `polynomial` < `roots` < `friction` < { `theory`, `stability`, `dynamics` }.

pub mod dynamics;
pub mod friction;
pub mod number;
pub mod polynomial;
pub mod roots;
pub mod stability;
pub mod theory;
