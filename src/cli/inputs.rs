//! The inputs of a command as its JSON object repeats them: in SI, as numbers.

use serde_json::{Map, Value, json};
use slipmode::scene::{Quantity, Uncertain};
use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::ParameterBox;

use crate::cli::options::SliderOptions;

/// The version of the JSON objects.
pub const SCHEMA: u32 = 1;

/// The seven values under their names; each is the 64-bit number nearest to the exact value.
pub fn inputs_json(parameters: &Parameters<Rational>) -> Value {
    let values: [Rational; 7] = parameters.clone().into();
    quantities_json(Quantity::ALL.into_iter().zip(&values))
}

/// The ends of the seven error bars under their names, but for those that are not given.
pub fn ranges_json(region: &ParameterBox, without: &[Quantity]) -> Value {
    let [lower, upper]: [[Rational; 7]; 2] = [region.lower().into(), region.upper().into()];
    let ends = Quantity::ALL
        .into_iter()
        .zip(lower.iter().zip(&upper))
        .filter(|(quantity, _)| !without.contains(quantity));
    let range = |(lower, upper)| json!([nearest_f64(lower), nearest_f64(upper)]);
    ends.map(|(quantity, ends)| (quantity.key().to_string(), range(ends))).collect::<Map<_, _>>().into()
}

/// The exact values of a point under their names, as decimals or fractions, but for one that plays no part.
pub fn exact_json(parameters: &Parameters<Rational>, without: Option<Quantity>) -> Value {
    let values: [Rational; 7] = parameters.clone().into();
    let pairs = Quantity::ALL.into_iter().zip(&values).filter(|(quantity, _)| Some(*quantity) != without);
    pairs
        .map(|(quantity, value)| (quantity.key().to_string(), json!(exact_text(value))))
        .collect::<Map<_, _>>()
        .into()
}

/// The five values of the material and the machine.
pub fn slider_json(slider: &Slider<Rational>) -> Value {
    let values: [Rational; 5] = slider.clone().into();
    quantities_json(Quantity::OF_THE_SLIDER.into_iter().zip(&values))
}

/// The numbers that were given, valid, under their names: a value, or the ends of its error bar.
pub fn given_json(slider: &SliderOptions) -> Map<String, Value> {
    let given = |quantity: Quantity| {
        let ends = Uncertain::parse(slider.text(quantity)?, |number| quantity.parse(number)).ok()?;
        let [lower, upper] = [&ends.lower, &ends.upper].map(nearest_f64);
        let value = if ends.is_certain() { json!(lower) } else { json!([lower, upper]) };
        Some((quantity.key().to_string(), value))
    };
    Quantity::ALL.into_iter().filter_map(given).collect()
}

/// Values under their names.
pub fn quantities_json<'v>(values: impl Iterator<Item = (Quantity, &'v Rational)>) -> Value {
    let number = |value: &Rational| json!(nearest_f64(value));
    values.map(|(quantity, value)| (quantity.key().to_string(), number(value))).collect::<Map<_, _>>().into()
}
