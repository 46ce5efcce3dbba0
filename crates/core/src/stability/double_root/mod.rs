//! The double root of eq 8 on a line of given σ or V0, and the other coordinate of the point: a few microseconds at 50 digits.
//!
//! With u = 1 + r and e = β − 1, the cubic of eq 8 has the double root r where
//!
//! * κ(1 + gr²) = r(e − r)/u with g = η/κ (eq 8 itself), and
//! * the derivative of this equation with respect to r, at fixed g or fixed κ, is zero.
//!
//! The second condition is a polynomial equation F(x) = 0 ([`equation`]) with x = r on the upper arc and x = −u on the lower one.
//! Its coefficients need no √β. The first equation then gives the unknown of κ and g. Its derivative is zero at the double root, so that an
//! error of r enters the unknown as its square: r is needed to half the digits only.
//!
//! 1. [`start`] finds the root in 64-bit arithmetic and improves it in double-double arithmetic. Nothing there is certain.
//! 2. [`enclosure`] doubles its bits up to half the digits by Newton steps. The last one is an interval Newton step: it proves that there is one root.
//! 3. [`unknown`] evaluates κ or g once, and adds the bound of the square.
//! 4. [`line`] decides which roots belong to the boundary.
//!
//! Where 64-bit numbers cannot follow, and at the cusp, [`mod@exactly`] isolates the roots of the same equation over ℚ.

mod enclosure;
mod equation;
mod exactly;
mod line;
mod start;
mod unknown;
mod work;

pub(super) use equation::GivenGroup;
pub(super) use exactly::exactly;
pub(super) use line::{Constants, DoubleRoot};
pub use work::Work;
