//! What `solve` says: as text for people, as one JSON object for programs.

use serde_json::{Value, json};
use slipmode::scene::Quantity;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::{certain_digits, exact_text, rational_to_decimal};
use slipmode_core::number::{Rational, parse_decimal};
use slipmode_core::stability::inverse::{Solution, SolutionKind, Target, Undecided};

use crate::cli::inputs::{SCHEMA, quantities_json};
use crate::cli::solve::Question;
use crate::cli::terminal::count_of;

/// A question with its answer.
pub struct View<'q> {
    question: &'q Question,
    inputs: [Rational; 7],
    solutions: Vec<Solution>,
}

/// A solution as text: exactly, where it is a decimal of no more digits; else its certain digits.
pub fn printed(solution: &Solution, digits: usize) -> (String, bool) {
    let text = solution.exact.as_ref().map(|exact| rational_to_decimal(exact, digits));
    let is_exact = |text: &String| parse_decimal(text).ok() == solution.exact;
    match text.filter(is_exact) {
        Some(text) => (text, true),
        None => (certain_digits(&solution.value, digits), false),
    }
}

impl Question {
    /// What the slider shall do, as one object.
    pub fn target_json(&self) -> Value {
        match &self.target {
            Target::Boundary => json!({ "max_imaginary_per_s": "0" }),
            Target::GrowthRate(rate) => json!({ "max_real_per_s": exact_text(rate) }),
            Target::AngularFrequency(frequency) => json!({ "max_imaginary_per_s": exact_text(frequency) }),
            Target::Frequency(frequency) => json!({ "frequency_hz": exact_text(frequency) }),
        }
    }

    /// What the slider shall do, in words.
    pub fn target_words(&self) -> String {
        match &self.target {
            Target::Boundary => "the boundary max Im(s) = 0".to_string(),
            Target::GrowthRate(rate) if rate.is_zero() => "the transition K = K_c".to_string(),
            Target::GrowthRate(rate) => format!("a growth rate of {} 1/s", exact_text(rate)),
            Target::AngularFrequency(frequency) => {
                format!("an angular frequency of {} 1/s", exact_text(frequency))
            }
            Target::Frequency(frequency) => format!("a frequency of {} Hz", exact_text(frequency)),
        }
    }
}

impl<'q> View<'q> {
    /// Answers the question.
    pub fn new(question: &'q Question, parameters: &Parameters<Rational>) -> Result<Self, Undecided> {
        let solutions = question.solve(parameters)?;
        Ok(Self { question, inputs: parameters.clone().into(), solutions })
    }

    /// One object: the question, the inputs in SI, and the solutions.
    pub fn json(&self) -> Value {
        let unknown = self.question.quantity();
        let given = Quantity::ALL.into_iter().zip(&self.inputs).filter(|(quantity, _)| *quantity != unknown);
        let solution = |solution: &Solution| {
            let (value, is_exact) = printed(solution, self.question.digits as usize);
            json!({
                "value": value,
                "is_exact": is_exact,
                "transition_sign": solution.transition_sign,
                "kind": solution.kind.as_str(),
            })
        };
        json!({
            "schema": SCHEMA,
            "inputs": quantities_json(given),
            "solved_for": unknown.key(),
            "target": self.question.target_json(),
            "solutions": self.solutions.iter().map(solution).collect::<Vec<_>>(),
        })
    }

    /// A line for the question, and one for each solution.
    pub fn text(&self) -> String {
        let unknown = self.question.quantity();
        let (name, unit) = (unknown.stem().replace('_', " "), unknown.unit());
        let target = self.question.target_words();
        if self.solutions.is_empty() {
            return format!("none: no {name} gives {target} (exact)\n");
        }
        let mut text = format!("{name} for {target}: {}\n", count_of(self.solutions.len(), "solution"));
        for solution in &self.solutions {
            let (value, is_exact) = printed(solution, self.question.digits as usize);
            let exact = if is_exact { " exactly" } else { "" };
            text += &format!("{value} {unit}{exact}  ({})\n", self.meaning(solution));
        }
        text
    }

    /// What the slider does at a solution.
    fn meaning(&self, solution: &Solution) -> String {
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
}
