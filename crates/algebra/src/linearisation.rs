//! A system of differential equations of first order near its steady state: its slopes, and the polynomial det(s − J) of their matrix J.

use std::collections::BTreeMap;

use super::{Expression, Symbol};

/// A system with its slopes at its steady state.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Linearisation {
    /// The variables that move.
    pub state: Vec<Symbol>,
    /// Their rates.
    pub rates: Vec<Expression>,
    /// Their values at which all rates are zero.
    pub steady: Vec<Expression>,
    /// The slopes there: a row for each rate, a column for each variable.
    pub slopes: Vec<Vec<Expression>>,
}

impl Linearisation {
    /// An expression at the steady state.
    #[must_use]
    pub fn at_rest(&self, expression: &Expression) -> Expression {
        expression.replaced(&self.state.iter().cloned().zip(self.steady.iter().cloned()).collect())
    }

    /// A rate as a function of one variable: all others have their steady values.
    #[must_use]
    pub fn along(&self, rate: usize, by: usize) -> Expression {
        let others = self.state.iter().cloned().zip(self.steady.iter().cloned()).enumerate();
        let others: BTreeMap<Symbol, Expression> =
            others.filter(|(place, _)| *place != by).map(|(_, known)| known).collect();
        self.rates[rate].replaced(&others)
    }

    /// The derivative of a rate in one variable at the steady state, by the rules of differentiation.
    #[must_use]
    pub fn derivative(&self, rate: usize, by: usize) -> Expression {
        self.at_rest(&self.rates[rate].derivative(&self.state[by]))
    }

    /// The pairs of a rate and a variable.
    pub fn places(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let count = self.state.len();
        (0..count).flat_map(move |rate| (0..count).map(move |by| (rate, by)))
    }

    /// det(s − J), written out.
    #[must_use]
    pub fn determinant(&self, variable: &Symbol) -> Expression {
        let s = Expression::variable(variable);
        let entry = |row: usize, (column, slope): (usize, &Expression)| {
            let diagonal = if row == column { s.clone() } else { Expression::integer(0) };
            diagonal - slope.clone()
        };
        let row = |(row, slopes): (usize, &Vec<Expression>)| {
            slopes.iter().enumerate().map(|one| entry(row, one)).collect()
        };
        written_out(&self.slopes.iter().enumerate().map(row).collect::<Vec<_>>())
    }

    /// What has to be equal: rates and zero, derivatives and slopes, the determinant and the polynomial.
    ///
    /// # Errors
    /// Why the lists do not make a system.
    pub(super) fn identities(
        &self,
        variable: &Symbol,
        polynomial: &Expression,
    ) -> Result<Vec<[Expression; 2]>, String> {
        self.check_form(variable)?;
        let rest = self.rates.iter().map(|rate| [self.at_rest(rate), Expression::integer(0)]);
        let slopes =
            self.places().map(|(rate, by)| [self.derivative(rate, by), self.slopes[rate][by].clone()]);
        let whole = [self.determinant(variable), polynomial.clone()];
        Ok(rest.chain(slopes).chain([whole]).collect())
    }

    /// As many of each, and no moving variable in what is fixed.
    fn check_form(&self, variable: &Symbol) -> Result<(), String> {
        let count = self.state.len();
        let is_square = self.slopes.len() == count && self.slopes.iter().all(|row| row.len() == count);
        if self.rates.len() != count || self.steady.len() != count || !is_square {
            return Err(format!("{count} variables need as many rates, steady values and rows of slopes"));
        }
        for (place, name) in self.state.iter().enumerate() {
            let mut fixed = self.steady.iter().chain(self.slopes.iter().flatten());
            if self.state[..place].contains(name) || name == variable {
                return Err(format!("{name} stands for two things"));
            }
            if fixed.any(|value| value.variables().contains(name)) {
                return Err(format!("a steady value or a slope contains {name}, which moves"));
            }
        }
        match self.rates.iter().chain(&self.steady).any(|one| one.variables().contains(variable)) {
            true => Err(format!("a rate or a steady value contains {variable}")),
            false => Ok(()),
        }
    }
}

/// A determinant written out along its first row.
#[must_use]
pub fn written_out(rows: &[Vec<Expression>]) -> Expression {
    let Some((first, below)) = rows.split_first() else { return Expression::integer(1) };
    let minor = |column: usize| {
        let without = |row: &Vec<Expression>| {
            let kept = row.iter().enumerate().filter(|(place, _)| *place != column);
            kept.map(|(_, entry)| entry.clone()).collect()
        };
        written_out(&below.iter().map(without).collect::<Vec<_>>())
    };
    first.iter().enumerate().filter(|(_, entry)| !entry.is_zero()).fold(
        Expression::integer(0),
        |sum, (column, entry)| {
            let term = entry.clone() * minor(column);
            if column % 2 == 0 { sum + term } else { sum - term }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_other_lengths_and_names_for_two_things_make_no_system() {
        let list = |texts: &str| {
            texts.split_whitespace().map(|text| text.parse().expect("in the grammar")).collect::<Vec<_>>()
        };
        let found = |state: &str, rates: &str, steady: &str, slopes: &[&str]| {
            let state = state.split_whitespace().map(|name| name.parse().expect("a name")).collect();
            let slopes = slopes.iter().map(|row| list(row)).collect();
            Linearisation { state, rates: list(rates), steady: list(steady), slopes }
                .identities(&"s".into(), &Expression::variable("p"))
                .map(|identities| identities.len())
        };
        assert_eq!(found("x v", "v -x", "0 0", &["0 1", "-1 0"]), Ok(7));
        for (state, rates, steady, slopes) in [
            ("x v", "v -x 0", "0 0", ["0 1", "-1 0"]),
            ("x v", "v -x", "0 0 0", ["0 1", "-1 0"]),
            ("x v", "v -x", "0 0", ["0 1", "-1 0 0"]),
            ("x x", "v -x", "0 0", ["0 1", "-1 0"]),
            ("x s", "s -x", "0 0", ["0 1", "-1 0"]),
            ("x v", "v s", "0 0", ["0 1", "-1 0"]),
            ("x v", "v -x", "0 s", ["0 1", "-1 0"]),
            ("x v", "v -x", "0 x", ["0 1", "-1 0"]),
            ("x v", "v -x", "0 0", ["0 1", "-1 v"]),
        ] {
            assert!(found(state, rates, steady, &slopes).is_err(), "{state} {rates} {steady} {slopes:?}");
        }
        assert!(found("x", "-x", "0", &["-1", "0"]).is_err());
    }
}
