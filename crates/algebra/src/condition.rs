//! Conditions on expressions: what a proof assumes, and what must hold for an expression to be defined.

use std::fmt;

use super::{Expression, ParseError};

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

impl TryFrom<String> for Condition {
    type Error = ParseError;

    fn try_from(text: String) -> Result<Self, ParseError> {
        let parts = Relation::ALL
            .iter()
            .find_map(|&relation| Some((text.strip_suffix(relation.as_str())?, relation)));
        let (expression, relation) = parts.ok_or_else(|| ParseError {
            column: text.chars().count(),
            message: "a condition ends with '> 0', '>= 0' or '!= 0'".to_owned(),
        })?;
        Ok(Self { expression: expression.to_owned().try_into()?, relation })
    }
}
