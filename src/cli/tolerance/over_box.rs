//! `slipmode tolerance` with error bars: where each formula may be used whatever the values within them.

use serde_json::{Value, json};
use slipmode::experiments::tolerance::place_of_limit;
use slipmode::scene::Quantity;
use slipmode_core::number::format::{certain_digits, rational_to_decimal};
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::tolerance::{LimitOverBox, limit_over_box};
use slipmode_core::stability::{Asymptote, ParameterBox};

use crate::cli::inputs::{SCHEMA, ranges_json};
use crate::cli::tolerance::{DIGITS, columns, formula, keys, unit};

/// Digits of each enclosure: more than are printed.
const CERTAIN_DIGITS: u32 = 20;

/// Characters of a formula with a range.
const WIDTH: usize = 48;

/// Why a formula has no limit.
const EQUAL_EFFECTS: &str = "a = b lies within the error bars, where this formula does not exist";

/// A formula and a relative error, and how far it is good to it.
struct Row<'e> {
    asymptote: Asymptote,
    relative_error: &'e Rational,
    found: Option<LimitOverBox>,
}

fn rows<'e>(region: &ParameterBox, relative: &'e [Rational]) -> Vec<Row<'e>> {
    let pairs = Asymptote::ALL.into_iter().flat_map(|it| relative.iter().map(move |error| (it, error)));
    let row = |(asymptote, relative_error)| {
        let found = limit_over_box(asymptote, region, relative_error, CERTAIN_DIGITS);
        Row { asymptote, relative_error, found }
    };
    pairs.map(row).collect()
}

/// A line for each formula and each error, and what the limits hold for.
pub fn text(region: &ParameterBox, relative: &[Rational]) -> String {
    let digits = |value: &Ball| certain_digits(value, DIGITS);
    let line = |Row { asymptote, relative_error, found }: &Row<'_>| {
        let error = rational_to_decimal(relative_error, DIGITS);
        let Some(found) = found else {
            return columns(WIDTH, [asymptote.as_str(), "", &error, "nowhere certain", EQUAL_EFFECTS]);
        };
        let [least, greatest] = found.values.each_ref().map(digits);
        let range = if least == greatest { least } else { format!("{least} to {greatest}") };
        let ([certain, best], unit) = (found.certain_and_best().map(digits), unit(*asymptote));
        let limit =
            format!("{certain} {unit}  ({best} {unit} for the values with which it is good farthest)");
        columns(WIDTH, [asymptote.as_str(), &formula(*asymptote, &range), &error, place(*asymptote), &limit])
    };
    let head =
        columns(WIDTH, ["formula", "", "good to", "where", "limit for all values within the error bars"]);
    let note = "Each limit and each end of a range is that of a corner of the error bars: it rises or falls with each value (proved by hand, not by Coq).\n";
    let lines = rows(region, relative);
    std::iter::once(head).chain(lines.iter().map(line)).chain([note.into()]).collect()
}

/// One object: the ends of the error bars, and every formula with the limit for each error; null where it is not good for all values.
pub fn json(region: &ParameterBox, relative: &[Rational]) -> Value {
    let row = |Row { asymptote, relative_error, found }: &Row<'_>| {
        let [value, limit] = keys(*asymptote);
        let [certain, best] = found
            .as_ref()
            .map_or([None; 2], |found| found.certain_and_best().map(|limit| Some(limit.to_f64())));
        json!({
            "formula": asymptote.as_str(),
            value: found.as_ref().map(|found| found.values.each_ref().map(Ball::to_f64)),
            "relative_error": nearest_f64(relative_error),
            "where": place(*asymptote),
            "limit": { limit: certain },
            "farthest_limit": { limit: best },
            "reason": found.is_none().then_some(EQUAL_EFFECTS),
        })
    };
    json!({
        "schema": SCHEMA,
        "inputs": ranges_json(region, &[Quantity::NormalStress, Quantity::LoadingVelocity]),
        "formulas": rows(region, relative).iter().map(row).collect::<Vec<_>>(),
    })
}

/// On which side of its limit a formula is good; the cusp is the limit of some sliders and not of others.
fn place(asymptote: Asymptote) -> &'static str {
    place_of_limit(asymptote, false)
}
