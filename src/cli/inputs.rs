//! The inputs of a command as its JSON object repeats them: in SI, as numbers.

use serde_json::{Map, Value, json};
use slipmode::scene::{Quantity, Uncertain};
use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::ParameterBox;

use crate::cli::answer::Answer;
use crate::cli::options::SliderOptions;

/// The seven values under their names; each is the 64-bit number nearest to the exact value.
pub fn inputs_json(parameters: &Parameters<Rational>) -> Value {
    quantities_json(exact_values(parameters, None))
}

/// The seven values under their names; the ends of all error bars where one has one.
pub fn region_json(region: &ParameterBox) -> Value {
    let lower = region.lower();
    if lower == region.upper() { inputs_json(&lower) } else { ranges_json(region, &[]) }
}

/// The ends of the seven error bars under their names, but for those that are not given.
pub fn ranges_json(region: &ParameterBox, without: &[Quantity]) -> Value {
    let [lower, upper]: [[Rational; 7]; 2] = [region.lower().into(), region.upper().into()];
    let ends = Quantity::ALL.into_iter().zip(lower.iter().zip(&upper));
    let given = ends.filter(|(quantity, _)| !without.contains(quantity));
    object(given.map(|(quantity, (lower, upper))| (quantity, json!([lower, upper].map(nearest_f64)))))
}

/// The exact values of a point, but for one that plays no part.
pub fn exact_values(
    parameters: &Parameters<Rational>,
    without: Option<Quantity>,
) -> impl Iterator<Item = (Quantity, Rational)> {
    let values: [Rational; 7] = parameters.clone().into();
    Quantity::ALL.into_iter().zip(values).filter(move |(quantity, _)| Some(*quantity) != without)
}

/// [`exact_values`] under their names, as decimals or fractions.
pub fn exact_json(parameters: &Parameters<Rational>, without: Option<Quantity>) -> Value {
    object(exact_values(parameters, without).map(|(quantity, value)| (quantity, json!(exact_text(&value)))))
}

/// The five values of the material and the machine.
pub fn slider_json(slider: &Slider<Rational>) -> Value {
    let values: [Rational; 5] = slider.clone().into();
    quantities_json(Quantity::OF_THE_SLIDER.into_iter().zip(values))
}

/// The numbers that were given, valid, under their names: a value, or the ends of its error bar.
pub fn given_json(slider: &SliderOptions) -> Answer {
    let given = |quantity: Quantity| {
        let ends = Uncertain::of(quantity, slider.text(quantity)?).ok()?;
        let [lower, upper] = [&ends.lower, &ends.upper].map(nearest_f64);
        Some((quantity, if ends.is_certain() { json!(lower) } else { json!([lower, upper]) }))
    };
    let given = Quantity::ALL.into_iter().filter_map(given);
    given.fold(Answer::default(), |answer, (quantity, value)| answer.with(quantity.as_str(), value))
}

/// Values under their names.
pub fn quantities_json(values: impl Iterator<Item = (Quantity, Rational)>) -> Value {
    object(values.map(|(quantity, value)| (quantity, json!(nearest_f64(&value)))))
}

fn object(values: impl Iterator<Item = (Quantity, Value)>) -> Value {
    values.map(|(quantity, value)| (quantity.as_str().to_string(), value)).collect::<Map<_, _>>().into()
}
