//! Sliders that the tests of this folder share.

use slipmode_core::friction::Slider;
use slipmode_core::number::{Rational, parse_decimal};

/// The paper's potentially unstable slider.
pub(crate) fn paper() -> Slider<Rational> {
    with_effects("0.004", "0.006")
}

/// The paper's machine with other friction parameters a and b.
pub(crate) fn with_effects(direct_effect: &str, evolution_effect: &str) -> Slider<Rational> {
    let values = [direct_effect, evolution_effect, "10e-6", "10e6", "1000"];
    Slider::from(values.map(|text| parse_decimal(text).unwrap()))
}
