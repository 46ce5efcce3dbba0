//! The inputs of a command as its JSON object repeats them: in SI, as numbers.

use serde_json::{Map, Value, json};
use slipmode::scene::Quantity;
use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::{Rational, nearest_f64};

/// The version of the JSON objects.
pub const SCHEMA: u32 = 1;

/// The seven values under their names; each is the 64-bit number nearest to the exact value.
pub fn inputs_json(parameters: &Parameters<Rational>) -> Value {
    let values: [Rational; 7] = parameters.clone().into();
    quantities_json(Quantity::ALL.into_iter().zip(&values))
}

/// The five values of the material and the machine.
pub fn slider_json(slider: &Slider<Rational>) -> Value {
    let Slider {
        direct_effect,
        evolution_effect,
        critical_slip_distance_m,
        stiffness_pa_per_m,
        mass_per_area_kg_per_m2,
    } = slider;
    let values = [
        direct_effect,
        evolution_effect,
        critical_slip_distance_m,
        stiffness_pa_per_m,
        mass_per_area_kg_per_m2,
    ];
    quantities_json(Quantity::OF_THE_SLIDER.into_iter().zip(values))
}

/// Values under their names.
pub fn quantities_json<'v>(values: impl Iterator<Item = (Quantity, &'v Rational)>) -> Value {
    let number = |value: &Rational| json!(nearest_f64(value));
    values.map(|(quantity, value)| (quantity.key().to_string(), number(value))).collect::<Map<_, _>>().into()
}
