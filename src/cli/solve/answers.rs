//! The answers of `solve`: solutions at a point, enclosures of all solutions within error bars, or the stiffness above which
//! the slider is stable at all values within them.

use serde_json::{Value, json};
use slipmode::scene::{Quantity, cited, stem_of_key, unit_of};
use slipmode_core::number::format::{
    Side, ends_around, ends_within, exact_text, nearest_digits, rational_to_decimal, rounded,
};
use slipmode_core::number::{Rational, parse_decimal};
use slipmode_core::stability::inverse::{
    Solution, SolutionKind, SolutionRange, Target, Undecided, solve, solve_over_box,
};
use slipmode_core::stability::{ParameterBox, extremes_of_critical_stiffness};

use crate::cli::answer::Answer;
use crate::cli::inputs::{exact_json, exact_values, quantities_json, ranges_json};
use crate::cli::solve::Question;
use crate::cli::terminal::count_of;

/// Digits computed beyond those printed, so that the last one is certain.
const GUARD_DIGITS: u32 = 12;
/// These words begin the answers that hold for all values.
const STABLE: &str = "the slider is stable at all values within the error bars";
const ABOVE: &str = "stable at all values within the error bars: every stiffness above";
/// Significant digits of ranges in the text for people.
const SHOWN_DIGITS: usize = 10;

impl Question {
    /// Answers for the values of a box, which has 1 for the unknown; the ends of a point agree.
    ///
    /// # Errors
    /// When no precision separates the solutions.
    pub fn answer(&self, region: &ParameterBox, is_point: bool) -> Result<Answer, Undecided> {
        match &self.target {
            None => Ok(self.stable_for_box(region)),
            Some(target) if is_point => self.at_point(target, region),
            Some(target) => Ok(self.over_box(target, region)),
        }
    }

    /// Solves at a point, and gives the digits that are certain.
    fn at_point(&self, target: &Target, region: &ParameterBox) -> Result<Answer, Undecided> {
        let point = region.lower();
        let solutions = solve(&point, self.unknown, target, self.digits + GUARD_DIGITS)?;
        let part = |solution: &Solution| {
            let (value, is_exact) = self.printed(solution);
            let exact = if is_exact { " exactly" } else { "" };
            Answer::line(&format!("{value} {}{exact}  ({})", unit_of(self.quantity()), meaning(solution)))
                .with("value", value)
                .with("is_exact", is_exact)
                .with("transition_sign", solution.transition_sign)
                .with("kind", solution.kind.as_str())
        };
        let words = [" (exact)", "", "solution"];
        let inputs = quantities_json(exact_values(&point, Some(self.quantity())));
        Ok(self.about(target, inputs, words, solutions.iter().map(part).collect()))
    }

    /// Encloses all solutions over a box; an end without bound is null.
    fn over_box(&self, target: &Target, region: &ParameterBox) -> Answer {
        let shown = |value: f64, side| rounded(value, SHOWN_DIGITS, side);
        let unit = unit_of(self.quantity());
        let part = |SolutionRange { enclosure: [low, high], certain }: &SolutionRange| {
            let ends = match (*low > 0.0, high.is_finite()) {
                (true, true) => format!("{} {unit}", ends_around([*low, *high], SHOWN_DIGITS).join(" to ")),
                (true, false) => format!("from {} {unit} on, without a bound", shown(*low, Side::Below)),
                (false, true) => format!("up to {} {unit}, from 0 on", shown(*high, Side::Above)),
                (false, false) => "any value, without a bound".to_string(),
            };
            let attained = match certain {
                Some(ends) => format!("{} occur", ends_within(*ends, SHOWN_DIGITS).join(" and ")),
                None => "whether one occurs is not decided".to_string(),
            };
            Answer::line(&format!("{ends}  (enclosed; {attained})"))
                .with("range", [low, high])
                .with("attained", certain)
        };
        let words =
            [" at any values within the error bars (certain)", ", all values within the error bars", "range"];
        let inputs = ranges_json(region, &[self.quantity()]);
        let ranges = solve_over_box(region, self.unknown, target);
        self.about(target, inputs, words, ranges.iter().map(part).collect())
    }

    /// Heads the answer; `words` are where it holds when there is no solution, where otherwise, and what is counted.
    fn about(&self, of: &Target, inputs: Value, words: [&str; 3], solutions: Vec<Answer>) -> Answer {
        let name = stem_of_key(self.quantity().as_str()).replace('_', " ");
        let (target, target_words) = target(of);
        let [where_none, where_some, thing] = words;
        let heading = match solutions.len() {
            0 => format!("none: no {name} gives {target_words}{where_none}\n"),
            count => format!("{name} for {target_words}{where_some}: {}\n", count_of(count, thing)),
        };
        self.answered(inputs, target).text(&heading).list("solutions", solutions)
    }

    fn answered(&self, inputs: Value, target: Value) -> Answer {
        Answer::to(inputs).with("solved_for", self.quantity().as_str()).with("target", target)
    }

    /// Finds the stiffness above which the slider is stable at all values. A point is stable where K > K_c, and K_c is largest at a
    /// corner of the box: the answer is a rational number, and 0 where no K_c is positive.
    fn stable_for_box(&self, region: &ParameterBox) -> Answer {
        let [_, witness] = extremes_of_critical_stiffness(region);
        let critical = witness.critical_stiffness();
        let witness = (critical > 0).then_some(witness);
        let least = if witness.is_some() { critical } else { Rational::new() };
        let (value, is_exact) = self.printed_from_above(&least);
        let exact = if is_exact { "exactly" } else { "(rounded up)" };
        let text = witness.as_ref().map_or_else(
            || format!("every stiffness: {STABLE}, because b <= a (exact)"),
            |witness| {
                let values = exact_values(witness, Some(Quantity::Stiffness));
                let place = values.map(|(of, value)| format!("{} = {}", of.as_str(), exact_text(&value)));
                let place = place.collect::<Vec<_>>().join(", ");
                cited(&format!("{ABOVE} {value} Pa/m {exact}\nlargest K_c ({{transition}}): at {place}"))
            },
        );
        let solution = Answer::line(&text)
            .with("value", value)
            .with("is_exact", is_exact)
            .with("exact", exact_text(&least))
            .with("witness", witness.map(|witness| exact_json(&witness, Some(Quantity::Stiffness))));
        self.answered(ranges_json(region, &[Quantity::Stiffness]), json!({ "stable_for_box": true }))
            .list("solutions", [solution])
    }

    /// Writes a solution: exactly, where it is a decimal of no more digits; else its certain digits.
    fn printed(&self, solution: &Solution) -> (String, bool) {
        match solution.exact.as_ref().and_then(|value| self.exactly(value)) {
            Some(text) => (text, true),
            None => (nearest_digits(&solution.value, self.digits as usize), false),
        }
    }

    /// Writes a value, or a decimal above it by at most ten units of its last digit.
    fn printed_from_above(&self, value: &Rational) -> (String, bool) {
        if let Some(text) = self.exactly(value) {
            return (text, true);
        }
        let unit = (1..self.digits).fold(Rational::from(1), |unit, _| unit / 10u32);
        (rational_to_decimal(&((unit + 1u32) * value), self.digits as usize), false)
    }

    /// Writes a value that is a decimal of no more digits.
    fn exactly(&self, value: &Rational) -> Option<String> {
        let text = rational_to_decimal(value, self.digits as usize);
        (parse_decimal(&text).as_ref() == Ok(value)).then_some(text)
    }
}

/// States what the slider shall do, as an object and in words.
fn target(target: &Target) -> (Value, String) {
    let (key, value, name, unit) = match target {
        Target::Boundary => {
            return (json!({ "max_imaginary_per_s": "0" }), "the boundary max Im(s) = 0".into());
        }
        Target::GrowthRate(rate) if rate.is_zero() => {
            return (json!({ "max_real_per_s": "0" }), "the transition K = K_c".into());
        }
        Target::GrowthRate(rate) => ("max_real_per_s", rate, "a growth rate", "1/s"),
        Target::AngularFrequency(value) => ("max_imaginary_per_s", value, "an angular frequency", "1/s"),
        Target::Frequency(value) => ("frequency_hz", value, "a frequency", "Hz"),
        Target::FrequencyRatio(threshold) => {
            let square = exact_text(threshold.squared_ratio());
            return (json!({ "frequency_over_natural_squared": square }), format!("(ω/ω_n)² = {square}"));
        }
    };
    let value = exact_text(value);
    let words = format!("{name} of {value} {unit}");
    (json!({ key: value }), words)
}

/// States what the slider does at a solution.
fn meaning(solution: &Solution) -> String {
    let stability = match solution.transition_sign {
        1.. => "stable",
        0 => "neutral",
        _ => "unstable",
    };
    let roots = match solution.kind {
        SolutionKind::ComplexPair => "complex pair",
        SolutionKind::RealRoot => "real root",
        SolutionKind::UpperArc => "upper arc",
        SolutionKind::LowerArc => "lower arc",
    };
    format!("{stability}, {roots}")
}
