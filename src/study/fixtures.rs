//! Sliders that the tests of this folder share.

use crate::number::parse_decimal;
use crate::scene::SceneParameters;

/// The paper's potentially unstable slider.
pub(super) fn paper() -> SceneParameters {
    with_effects("0.004", "0.006")
}

/// The paper's machine with other friction parameters a and b.
pub(super) fn with_effects(direct_effect: &str, evolution_effect: &str) -> SceneParameters {
    let decimal = |text| parse_decimal(text).unwrap();
    SceneParameters {
        direct_effect: decimal(direct_effect),
        evolution_effect: decimal(evolution_effect),
        critical_slip_distance_m: decimal("10e-6"),
        stiffness_pa_per_m: decimal("10e6"),
        mass_per_area_kg_per_m2: decimal("1000"),
        normal_stress_pa: None,
        loading_velocity_m_per_s: None,
    }
}
