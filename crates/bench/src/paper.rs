//! The paper's slider, and places in its plane of velocity and stress.

use slipmode::experiments::shared::cells::Digits;
use slipmode::scene::PlanePoint;
use slipmode_core::dynamics::Model;
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
use slipmode_plot::table::{Cell, Column};

/// The paper's potentially unstable slider: a, b, D_c in m, K in Pa/m and M in kg/m².
pub(crate) fn paper() -> Slider<Rational> {
    Slider::from(["0.004", "0.006", "10e-6", "10e6", "1000"].map(decimal))
}

/// A number as written.
pub(crate) fn decimal(text: &str) -> Rational {
    // Every caller writes a decimal.
    parse_decimal(text).unwrap_or_default()
}

/// V_l in m/s and σ in Pa, as written.
pub(crate) fn place([loading_velocity_m_per_s, normal_stress_pa]: [&str; 2]) -> PlanePoint {
    PlanePoint {
        loading_velocity_m_per_s: decimal(loading_velocity_m_per_s),
        normal_stress_pa: decimal(normal_stress_pa),
    }
}

/// A 64-bit number without rounding.
pub(crate) fn exactly(value: f64) -> Rational {
    Rational::from_f64(value).unwrap_or_default()
}

/// The slider at a place of the plane.
pub(crate) fn model_at(parameters: &Slider<Rational>, place: &PlanePoint, law: EvolutionLaw) -> Model<f64> {
    let (velocity, stress) = (place.loading_velocity_m_per_s.clone(), place.normal_stress_pa.clone());
    Model::new(parameters.at(stress, velocity).groups().map(nearest_f64), law)
}

/// Columns of a place.
pub(crate) fn place_columns() -> [Column; 2] {
    [
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
    ]
}

/// Their cells.
pub(crate) fn place_cells(place: &PlanePoint) -> [Cell; 2] {
    [&place.normal_stress_pa, &place.loading_velocity_m_per_s].map(|value| nearest_f64(value).cell(4))
}
