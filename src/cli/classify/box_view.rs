//! The answer of `classify` for values with error bars.

use serde_json::{Value, json};
use slipmode::scene::{Quantity, cited};
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::{rational_ends_around, rational_to_decimal};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::{
    InertialThreshold, OverBox, ParameterBox, Possible, SlipMode, SpectralClass, over_box, transition_sign,
};

use crate::cli::answer::{Answer, Item, SHOWN_DIGITS};
use crate::cli::classify::ranges::{RootRanges, outward};
use crate::cli::classify::rows::NEUTRAL;
use crate::cli::classify::sample::Sample;
use crate::cli::inputs::{exact_json, exact_values, ranges_json};

/// Classifies all values within the error bars: what is certain, what is possible at which point, and ranges. None for a
/// threshold that is not allowed.
pub fn answer(
    region: &ParameterBox,
    threshold: &InertialThreshold,
    sample: Option<&Sample>,
) -> Option<Answer> {
    let found = over_box(region, threshold)?;
    let class = |possible: &Possible<SpectralClass>| {
        Answer::default()
            .item("spectral_class", "spectral class", possible.what.as_str())
            .with("witness", witness(possible))
    };
    let signs = |[least, greatest]: [i8; 2]| {
        let text = if least == greatest { least.to_string() } else { format!("{least} to {greatest}") };
        Item::new(json!([least, greatest]), text)
    };
    let critical = &found.critical_stiffness_pa_per_m;
    let answer = Answer::to(ranges_json(region, &[]))
        .and(modes(region, &found))
        .list("spectral_classes", found.spectral_classes.iter().map(class))
        .item("transition_signs", "sign of K - K_c", signs(found.transition_signs))
        .item("boundary_signs", "sign of discriminant", signs(found.boundary_signs))
        .and(RootRanges::new(region, &found).answer())
        .with("critical_stiffness_pa_per_m", outward(critical))
        .named("K_c", &format!("{} Pa/m", rational_ends_around(critical, SHOWN_DIGITS).join(" to ")))
        .note(&cited("({transition})"));
    Some(match sample {
        Some(sample) => answer.part("sampled", sample.answer(region, threshold)),
        None => answer.with("sampled", Value::Null),
    })
}

/// The slip modes that are possible, each with a point, and those that are not decided.
pub fn modes(region: &ParameterBox, found: &OverBox) -> Answer {
    let is_certain = found.certain_mode().is_some();
    let name = if is_certain { "slip mode" } else { "possible slip mode" };
    let mode = |possible: &Possible<SlipMode>| {
        let meaning = match &possible.witness {
            _ if is_certain => "(certain: all values within the error bars)".to_string(),
            Some(point) => format!("(at {})", place(region, point)),
            None => "(at values that are not rational)".to_string(),
        };
        Answer::default()
            .item("mode", name, mode_word(possible))
            .note(&meaning)
            .with("witness", witness(possible))
    };
    let undecided = |(mode, share): &(SlipMode, Rational)| {
        let percent = rational_to_decimal(&(share.clone() * 100u32), 3);
        Answer::default()
            .item("mode", "undecided slip mode", mode.as_str())
            .note(&format!("(in at most {percent} % of the box)"))
            .with("share", nearest_f64(share))
    };
    Answer::default()
        .with("certain", is_certain)
        .list("slip_modes", found.slip_modes.iter().map(mode))
        .list("undecided", found.undecided.iter().map(undecided))
        .with("undecided_share", nearest_f64(&found.undecided_share()))
}

/// The uncertain values of a point.
fn place(region: &ParameterBox, point: &Parameters<Rational>) -> String {
    let [lower, upper]: [[Rational; 7]; 2] = [region.lower().into(), region.upper().into()];
    let is_uncertain =
        |(quantity, _): &(Quantity, Rational)| lower[*quantity as usize] != upper[*quantity as usize];
    let of = |(quantity, value): (Quantity, Rational)| format!("{} = {}", quantity.as_str(), shown(&value));
    let uncertain: Vec<String> = exact_values(point, None).filter(is_uncertain).map(of).collect();
    if uncertain.is_empty() { "the given values".to_string() } else { uncertain.join(", ") }
}

/// The mode as the classification of its witness states it: neutral on K = K_c.
fn mode_word(possible: &Possible<SlipMode>) -> &'static str {
    let is_neutral = possible.witness.as_ref().is_some_and(|point| transition_sign(&point.groups()) == 0);
    if is_neutral { NEUTRAL } else { possible.what.as_str() }
}

fn witness<T>(possible: &Possible<T>) -> Option<Value> {
    possible.witness.as_ref().map(|point| exact_json(point, None))
}

fn shown(value: &Rational) -> String {
    rational_to_decimal(value, SHOWN_DIGITS)
}
