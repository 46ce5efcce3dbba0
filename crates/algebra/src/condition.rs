//! Conditions on expressions: what a proof assumes, and what must hold for an expression to be defined.

use std::fmt;

use super::{Expression, Function};

crate::named! {
    /// How an expression compares with zero.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Relation {
        /// Greater than zero.
        Positive = " > 0",
        /// Zero or greater.
        NonNegative = " >= 0",
        /// Not zero.
        NonZero = " != 0",
    }
}

/// One condition, such as `b - a > 0`; serialised as its text.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "String", into = "String"))]
pub struct Condition {
    /// What is compared with zero.
    pub expression: Expression,
    /// How.
    pub relation: Relation,
}

impl fmt::Display for Condition {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}{}", self.expression, self.relation.as_str())
    }
}

impl From<Condition> for String {
    fn from(condition: Condition) -> Self {
        condition.to_string()
    }
}

impl Expression {
    /// What must hold for the expression to have a value, as it is written: of each divisor, base of a power that divides, argument of
    /// a logarithm and of a root.
    #[must_use]
    pub fn demands(&self) -> Vec<Condition> {
        let mut found = Vec::new();
        self.add_demands(&mut found);
        found
    }

    fn add_demands(&self, found: &mut Vec<Condition>) {
        let mut demand = |expression: &Self, relation| {
            let condition = Condition { expression: expression.clone(), relation };
            if !found.contains(&condition) {
                found.push(condition);
            }
        };
        match self {
            Self::Quotient(_, below) => demand(below, Relation::NonZero),
            Self::Power(base, exponent) if *exponent <= 0 => demand(base, Relation::NonZero),
            Self::Call(Function::Ln, argument) => demand(argument, Relation::Positive),
            Self::Call(Function::Sqrt, argument) => demand(argument, Relation::NonNegative),
            _ => {}
        }
        self.parts().for_each(|part| part.add_demands(found));
    }
}
