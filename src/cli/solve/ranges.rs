//! What `solve` says of values with error bars: enclosures of all solutions, as text, JSON and cells.

use serde_json::{Value, json};
use slipmode_core::number::Wide;
use slipmode_core::number::format::round_digits;
use slipmode_core::stability::ParameterBox;
use slipmode_core::stability::inverse::{SolutionRange, solve_over_box};

use crate::cli::inputs::{SCHEMA, ranges_json};
use crate::cli::solve::Question;
use crate::cli::terminal::count_of;

/// Significant digits in the text for people.
const SHOWN_DIGITS: usize = 10;

/// A question about all values within error bars, with its answer.
pub struct RangesView<'q> {
    question: &'q Question,
    region: ParameterBox,
    ranges: Vec<SolutionRange>,
}

/// The enclosures of all solutions over a box.
pub fn ranges(question: &Question, region: &ParameterBox) -> Vec<SolutionRange> {
    solve_over_box(region, question.unknown, &question.target)
}

impl<'q> RangesView<'q> {
    /// Answers the question.
    pub fn new(question: &'q Question, region: ParameterBox) -> Self {
        let ranges = ranges(question, &region);
        Self { question, region, ranges }
    }

    /// One object: the question, the ends of the error bars, and the ranges of solutions; an end without bound is null.
    pub fn json(&self) -> Value {
        let unknown = self.question.quantity();
        let range = |range: &SolutionRange| {
            let [low, high] = range.enclosure;
            json!({
                "range": [low, high.is_finite().then_some(high)],
                "attained": range.certain,
            })
        };
        json!({
            "schema": SCHEMA,
            "inputs": ranges_json(&self.region, &[unknown]),
            "solved_for": unknown.key(),
            "target": self.question.target_json(),
            "solutions": self.ranges.iter().map(range).collect::<Vec<_>>(),
        })
    }

    /// A line for the question, and one for each range.
    pub fn text(&self) -> String {
        let unknown = self.question.quantity();
        let (name, unit) = (unknown.stem().replace('_', " "), unknown.unit());
        let target = self.question.target_words();
        if self.ranges.is_empty() {
            return format!("none: no {name} gives {target} at any values within the error bars (certain)\n");
        }
        let count = count_of(self.ranges.len(), "range");
        let mut text = format!("{name} for {target}, all values within the error bars: {count}\n");
        for SolutionRange { enclosure: [low, high], certain } in &self.ranges {
            let shown = |value: f64| round_digits(value, SHOWN_DIGITS);
            let ends = match (*low > 0.0, high.is_finite()) {
                (true, true) => format!("{} to {} {unit}", shown(*low), shown(*high)),
                (true, false) => format!("from {} {unit} on, without a bound", shown(*low)),
                (false, true) => format!("up to {} {unit}, from 0 on", shown(*high)),
                (false, false) => "any value, without a bound".to_string(),
            };
            let attained = match certain {
                Some([low, high]) => format!("{} and {} occur", shown(*low), shown(*high)),
                None => "whether one occurs is not decided".to_string(),
            };
            text += &format!("{ends}  (enclosed; {attained})\n");
        }
        text
    }
}

/// A range as a cell: as it is typed as an input, with `inf` where there is no bound.
pub fn cell(range: &SolutionRange) -> String {
    let text = |end: f64| Wide::from_f64(end).map_or_else(|| "inf".to_string(), |end| end.to_string());
    let [low, high] = range.enclosure.map(text);
    format!("[{low}, {high}]")
}
