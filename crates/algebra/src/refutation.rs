//! What remains when a proof fails.

use std::collections::BTreeMap;
use std::fmt;

use super::rational_function::evaluate;
use super::{Domain, Expression, Notation, RationalFunction, Symbol};
use rug::Rational;

/// A rational point at which a statement is false, with what both sides are there.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CounterExample {
    /// Names and values.
    pub point: Vec<(Symbol, Expression)>,
    /// The value of the side that was derived.
    pub left: Expression,
    /// The value of the side that was claimed.
    pub right: Expression,
}

/// A step that could not be proved: it is false, or the rules do not decide it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Refutation {
    /// The identity of the proof that was attempted.
    pub id: String,
    /// The equations of the paper that enter the step which fails.
    pub equations: Vec<String>,
    /// The step that fails, in words.
    pub statement: String,
    /// The exact non-zero remainder, or why there is none.
    pub remainder: String,
    /// Whether the step is false; else the rules do not decide it.
    pub is_false: bool,
    /// A rational point at which both sides differ, when the step compares two sides.
    pub counter_example: Option<Box<CounterExample>>,
}

impl fmt::Display for Refutation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = if self.is_false { "refuted" } else { "not proved" };
        write!(formatter, "{}: {found}: {}", self.id, self.statement)?;
        if !self.equations.is_empty() {
            write!(formatter, " (equations {})", self.equations.join(", "))?;
        }
        write!(formatter, "; remainder: {}", self.remainder)?;
        if let Some(example) = &self.counter_example {
            let point = Notation::Plain.equal(&example.point);
            // Two constants differ everywhere: there is no point to name.
            let place = if point.is_empty() { point } else { format!("at {point}: ") };
            write!(formatter, "; {place}{} instead of {}", example.left, example.right)?;
        }
        Ok(())
    }
}

impl std::error::Error for Refutation {}

impl CounterExample {
    /// A point at which the two sides differ, searched among small primes; `None` when they are the same.
    #[must_use]
    pub(super) fn search(left: &RationalFunction, right: &RationalFunction, domain: &Domain) -> Option<Self> {
        const VALUES: [i32; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
        let variables = &left.variables() | &right.variables();
        // A polynomial of degree d that is not zero cannot vanish on all shifts of more than d distinct values.
        (0..VALUES.len()).find_map(|shift| {
            let value = |index: usize| Rational::from(VALUES[(index * (shift + 1) + shift) % VALUES.len()]);
            let point: BTreeMap<Symbol, Rational> =
                variables.iter().enumerate().map(|(index, name)| (name.clone(), value(index))).collect();
            let (left, right) = (evaluate(left, &point)?, evaluate(right, &point)?);
            (left != right).then(|| Self {
                point: original_point(&point, domain),
                left: Expression::Number(left),
                right: Expression::Number(right),
            })
        })
    }
}

/// The point in the variables of the paper: values of the substituted variables are computed, the others kept.
fn original_point(point: &BTreeMap<Symbol, Rational>, domain: &Domain) -> Vec<(Symbol, Expression)> {
    let hidden =
        |name: &Symbol| domain.substitutions().iter().any(|(_, value)| value.variables().contains(name));
    let kept = point.iter().filter(|(name, _)| !hidden(name));
    let kept = kept.map(|(name, value)| (name.clone(), Expression::Number(value.clone())));
    let computed = domain.substitutions().iter().filter_map(|(name, value)| {
        let value = evaluate(&Domain::default().rational_function(value).ok()?, point)?;
        Some((name.clone(), Expression::Number(value)))
    });
    kept.chain(computed).collect()
}
