//! Whether a condition is true in a row: true, false, or open where an estimated error could turn it; and how sure that is.

use std::cmp::Ordering;

use slipmode_algebra::{Comparison, Expression, Function};
use slipmode_core::number::Ball;

use super::arithmetic::{BITS, compared, magnitude};
use super::statement::RowStatement;
use super::values::Row;
use crate::claims::Strength;
use crate::scene::Formula;

/// Whether something is true, none where it is open, and how sure that is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Truth {
    pub is: Option<bool>,
    pub strength: Strength,
}

impl Truth {
    pub fn not(self) -> Self {
        Self { is: self.is.map(|is| !is), ..self }
    }

    /// A conjunction, or with `wanted` a disjunction: one part that is surely `wanted` decides alone.
    pub fn joined(parts: impl IntoIterator<Item = Self>, wanted: bool) -> Self {
        let parts: Vec<Self> = parts.into_iter().collect();
        let strengths = |is| parts.iter().filter(move |part| part.is == is).map(|part| part.strength);
        match strengths(Some(wanted)).min() {
            Some(strength) => Self { is: Some(wanted), strength },
            None => Self {
                is: strengths(None).next().is_none().then_some(!wanted),
                strength: strengths(Some(!wanted)).max().unwrap_or(Strength::Certified),
            },
        }
    }

    /// Whether the second is true where the first one is.
    pub fn implies(self, other: Self) -> Self {
        Self::joined([self.not(), other], true)
    }
}

/// The rows of a table, in which conditions have a truth and expressions a value.
pub(super) struct Rows<'a> {
    pub statement: &'a RowStatement,
    pub rows: Vec<Row>,
}

impl Rows<'_> {
    /// Whether a formula is true in a row.
    pub fn truth(&self, formula: &Formula, at: usize) -> Truth {
        let go = |part: &Formula| self.truth(part, at);
        match formula {
            Formula::Compare(left, comparison, right) => self.comparison([left, right], *comparison, at),
            Formula::Not(inner) => go(inner).not(),
            Formula::All(parts) => Truth::joined(parts.iter().map(go), false),
            Formula::Any(parts) => Truth::joined(parts.iter().map(go), true),
            Formula::Implies(parts) => go(&parts[0]).implies(go(&parts[1])),
            Formula::Iff(parts) => {
                let [left, right] = [go(&parts[0]), go(&parts[1])];
                let is = left.is.zip(right.is).map(|(left, right)| left == right);
                Truth { is, strength: left.strength.max(right.strength) }
            }
            Formula::Roots(..) | Formula::Crossing(_) => Truth { is: None, strength: Strength::Sampled },
        }
    }

    fn comparison(&self, sides: [&Expression; 2], comparison: Comparison, at: usize) -> Truth {
        let row = &self.rows[at];
        let (difference, strength) = self.difference(sides.map(|side| (side, at)));
        if let Some(column) = self.statement.compared_with_nothing(sides) {
            let is_empty = row.is_empty(column);
            let is = (!is_empty || !row.has_failed).then_some(is_empty == (comparison == Comparison::Equal));
            return Truth { is, strength };
        }
        if let Comparison::Equal | Comparison::Unequal = comparison
            && let [Some(left), Some(right)] = sides.map(|side| side.enclosed(&row.names, BITS))
        {
            let is_equal = (left - right).sign().is_none_or(Ordering::is_eq);
            return Truth { is: Some(is_equal == (comparison == Comparison::Equal)), strength };
        }
        let is = difference.and_then(|difference| compared(&difference, comparison));
        Truth { is, strength }
    }

    /// How sure the value of an expression in a row is: as the least sure column that it names.
    pub fn strength(&self, side: &Expression, at: usize) -> Strength {
        let row = &self.rows[at];
        let columns = side.variables().into_iter().filter(|name| !RowStatement::is_word(name));
        columns.map(|name| row.strength(&name)).max().unwrap_or(Strength::Certified)
    }

    /// The value of an expression in a row; none where a column has none there.
    pub fn value(&self, side: &Expression, at: usize) -> Option<Ball> {
        match side {
            Expression::Call(Function::Abs, inner) => self.value(inner, at).map(|inner| magnitude(&inner)),
            _ => side.enclosed(&self.rows[at].values, BITS),
        }
    }

    /// The difference of two expressions, each in a row, and how sure it is.
    fn difference(&self, sides: [(&Expression, usize); 2]) -> (Option<Ball>, Strength) {
        let [left, right] = sides.map(|(side, at)| self.value(side, at));
        let [one, other] = sides.map(|(side, at)| self.strength(side, at));
        (left.zip(right).map(|(left, right)| left - right), one.max(other))
    }

    /// The values of two expressions in rows.
    ///
    /// # Errors
    /// Where one is missing.
    pub fn values(&self, group: &[usize], sides: &[Expression; 2]) -> Result<[Vec<Ball>; 2], &'static str> {
        let of = |side: &Expression| group.iter().map(|&at| self.value(side, at)).collect::<Option<_>>();
        of(&sides[0]).zip(of(&sides[1])).map(Into::into).ok_or("a value is missing")
    }

    /// Whether two values differ by no more than their errors.
    pub fn agree(&self, sides: &[Expression; 2], at: usize) -> Truth {
        let (difference, strength) = self.difference(sides.each_ref().map(|side| (side, at)));
        let difference = difference.filter(Ball::is_bounded);
        let is = difference.map(|difference| difference.sign().is_none_or(Ordering::is_eq));
        Truth { is, strength }
    }

    /// Whether an expression rises (or falls) from one row to another.
    pub fn changes(&self, side: &Expression, rises: bool, [from, to]: [usize; 2]) -> Truth {
        let wanted = if rises { Comparison::Greater } else { Comparison::Less };
        let (difference, strength) = self.difference([(side, to), (side, from)]);
        Truth { is: difference.and_then(|difference| compared(&difference, wanted)), strength }
    }
}
