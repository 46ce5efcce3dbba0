//! `solve --stable-for-box`: the stiffness above which the slider is stable at all values within the error bars.
//!
//! A point is stable where K > K_c, and K_c is largest at a corner of the box. So the answer is a rational number.

use serde_json::{Value, json};
use slipmode::scene::Quantity;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::{exact_text, rational_to_decimal};
use slipmode_core::number::{Rational, parse_decimal};
use slipmode_core::stability::{ParameterBox, extremes_of_critical_stiffness};

use crate::cli::inputs::{SCHEMA, exact_json, ranges_json};

/// The answer.
pub struct StableForBox {
    region: ParameterBox,
    /// The largest K_c, or 0 where none is positive.
    least: Rational,
    /// Where K_c is largest, when it is positive.
    witness: Option<Parameters<Rational>>,
    digits: usize,
}

impl StableForBox {
    /// Answers the question for a box; its stiffness plays no part.
    pub fn new(region: ParameterBox, digits: u32) -> Self {
        let [_, witness] = extremes_of_critical_stiffness(&region);
        let critical = witness.critical_stiffness();
        let is_positive = critical > 0;
        Self {
            region,
            least: if is_positive { critical } else { Rational::new() },
            witness: is_positive.then_some(witness),
            digits: digits as usize,
        }
    }

    /// The value, or a decimal above it by at most ten units of its last digit.
    pub fn printed(&self) -> (String, bool) {
        let nearest = rational_to_decimal(&self.least, self.digits);
        if parse_decimal(&nearest).as_ref() == Ok(&self.least) {
            return (nearest, true);
        }
        let unit = (1..self.digits).fold(Rational::from(1), |unit, _| unit / 10u32);
        (rational_to_decimal(&((unit + 1u32) * &self.least), self.digits), false)
    }

    /// One object: the question, the ends of the error bars, and the value with where it is reached.
    pub fn json(&self) -> Value {
        let unknown = Some(Quantity::Stiffness);
        let (value, is_exact) = self.printed();
        json!({
            "schema": SCHEMA,
            "inputs": ranges_json(&self.region, unknown.as_slice()),
            "solved_for": Quantity::Stiffness.key(),
            "target": { "stable_for_box": true },
            "solutions": [{
                "value": value,
                "is_exact": is_exact,
                "exact": exact_text(&self.least),
                "witness": self.witness.as_ref().map(|witness| exact_json(witness, unknown)),
            }],
        })
    }

    /// A line for the answer, and one for where it is reached.
    pub fn text(&self) -> String {
        let Some(witness) = &self.witness else {
            return "every stiffness: the slider is stable at all values within the error bars, because b <= a (exact)\n".into();
        };
        let (value, is_exact) = self.printed();
        let exact = if is_exact { "exactly" } else { "(rounded up)" };
        let values: [Rational; 7] = witness.clone().into();
        let places =
            Quantity::ALL.into_iter().zip(&values).filter(|(quantity, _)| *quantity != Quantity::Stiffness);
        let places: Vec<String> =
            places.map(|(quantity, value)| format!("{} = {}", quantity.key(), exact_text(value))).collect();
        format!(
            "stable at all values within the error bars: every stiffness above {value} Pa/m {exact}\nlargest K_c (eq 9): at {}\n",
            places.join(", ")
        )
    }
}
