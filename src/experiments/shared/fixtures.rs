//! Sliders that the tests of this folder share.

use crate::scene::SceneParameters;
use slipmode_core::number::parse_decimal;

/// The paper's potentially unstable slider.
pub(crate) fn paper() -> SceneParameters {
    with_effects("0.004", "0.006")
}

/// The paper's machine with other friction parameters a and b.
pub(crate) fn with_effects(direct_effect: &str, evolution_effect: &str) -> SceneParameters {
    let values = [direct_effect, evolution_effect, "10e-6", "10e6", "1000"];
    SceneParameters::of_slider(values.map(|text| parse_decimal(text).unwrap()))
}
