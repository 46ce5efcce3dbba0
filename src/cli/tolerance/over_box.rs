//! `slipmode tolerance` with error bars: where each formula may be used whatever the values within them.

use serde_json::json;
use slipmode::experiments::tolerance::place_of_limit;
use slipmode::scene::Quantity;
use slipmode_core::number::format::certain_digits;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::tolerance::{LimitOverBox, limit_over_box};
use slipmode_core::stability::{Asymptote, ParameterBox};

use crate::cli::answer::Answer;
use crate::cli::inputs::ranges_json;
use crate::cli::tolerance::{CERTAIN_DIGITS, DIGITS, columns, formula, keys, part};

/// Characters of a formula with a range.
const WIDTH: usize = 48;

/// Why a formula has no limit.
const EQUAL_EFFECTS: &str = "a = b lies within the error bars, where this formula does not exist";

/// Computes the limit of every formula for each error; it is null where the formula is not good for all values.
pub fn answer(region: &ParameterBox, relative: &[Rational]) -> Answer {
    let head =
        columns(WIDTH, ["formula", "", "good to", "where", "limit for all values within the error bars"]);
    let note = "Each limit and each end of a range is that of a corner of the error bars: it rises or falls with each value (proved by hand, not by Coq).\n";
    let pairs = Asymptote::ALL.into_iter().flat_map(|it| relative.iter().map(move |error| (it, error)));
    Answer::to(ranges_json(region, &[Quantity::NormalStress, Quantity::LoadingVelocity]))
        .text(&head)
        .list("formulas", pairs.map(|(asymptote, error)| row(region, asymptote, error)))
        .text(note)
}

fn row(region: &ParameterBox, asymptote: Asymptote, relative_error: &Rational) -> Answer {
    let found = limit_over_box(asymptote, region, relative_error, CERTAIN_DIGITS);
    let limits = found.as_ref().map(LimitOverBox::certain_and_best);
    let digits = |value: &Ball| certain_digits(value, DIGITS);
    let [value_key, limit_key, unit] = keys(asymptote);
    // The cusp is the limit of some sliders and not of others.
    let place = place_of_limit(asymptote, false);
    let words = found.as_ref().zip(limits).map(|(found, limits)| {
        let [least, greatest] = found.values.each_ref().map(digits);
        let range = if least == greatest { least } else { format!("{least} to {greatest}") };
        let [certain, best] = limits.map(digits);
        let limit =
            format!("{certain} {unit}  ({best} {unit} for the values with which it is good farthest)");
        (formula(asymptote, &range), place, limit)
    });
    let (formula, where_good, limit) =
        words.unwrap_or_else(|| (String::new(), "nowhere certain", EQUAL_EFFECTS.to_string()));
    let [certain, best] = limits.map_or([None; 2], |limits| limits.map(|limit| Some(limit.to_f64())));
    part(asymptote, relative_error, WIDTH, [&formula, where_good, &limit])
        .with("where", place)
        .with(value_key, found.as_ref().map(|found| found.values.each_ref().map(Ball::to_f64)))
        .with("limit", json!({ limit_key: certain }))
        .with("farthest_limit", json!({ limit_key: best }))
        .with("reason", found.is_none().then_some(EQUAL_EFFECTS))
}
