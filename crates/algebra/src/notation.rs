//! Two ways to write formulas: as the parser reads them, or as LaTeX between `$` for a page.

use std::fmt;

use super::{Condition, Expression, Relation, Symbol};

/// How formulas are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// As the parser reads them.
    Plain,
    /// LaTeX between `$`.
    Latex,
}

impl Notation {
    pub(crate) fn set(self, expression: &Expression) -> String {
        match self {
            Self::Plain => expression.to_string(),
            Self::Latex => expression.latex(),
        }
    }

    pub(crate) fn name(self, name: &Symbol) -> String {
        match self {
            Self::Plain => name.to_string(),
            Self::Latex => Expression::variable(name).latex(),
        }
    }

    /// One of two spellings.
    pub(super) fn either(self, plain: &'static str, latex: &'static str) -> &'static str {
        match self {
            Self::Plain => plain,
            Self::Latex => latex,
        }
    }

    /// A whole formula.
    pub(crate) fn formula(self, text: impl fmt::Display) -> String {
        let mark = self.either("", "$");
        format!("{mark}{text}{mark}")
    }

    pub(crate) fn equal<'p>(self, pairs: impl IntoIterator<Item = &'p (Symbol, Expression)>) -> String {
        let equal = |(name, value): &(Symbol, Expression)| {
            self.formula(format_args!("{} = {}", self.name(name), self.set(value)))
        };
        pairs.into_iter().map(equal).collect::<Vec<_>>().join(", ")
    }

    pub(crate) fn condition(self, condition: &Condition) -> String {
        let relation = match condition.relation {
            Relation::Positive => ">",
            Relation::NonNegative => self.either(">=", "\\ge"),
            Relation::NonZero => self.either("!=", "\\ne"),
        };
        self.formula(format_args!("{} {relation} 0", self.set(&condition.expression)))
    }
}
