//! Roots in double-double arithmetic, with a rigorous forward error bound for each.

use super::Spectrum;
use super::forward::BoundedCubic;
use crate::number::Dd;

/// The roots of the cubic with exactly these coefficients; limits as for [`super::binary64::roots`].
#[must_use]
pub fn roots(cubic: [Dd; 4]) -> Spectrum<Dd> {
    let magnitudes = cubic.map(|coefficient| coefficient.hi().abs());
    // A coefficient may exceed its leading part by half a unit of it; the relative error has room for that.
    BoundedCubic { coefficients: cubic, magnitudes, relative_error: 0.0 }.spectrum()
}
