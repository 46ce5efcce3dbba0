//! The paper's equations as input data.

use std::collections::BTreeMap;
use std::fmt;

use super::reading::{self, EquationsText};
use crate::polynomial::Expression;

/// One equation of the paper.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// Its number in the paper, or a name where the paper gives none.
    pub number: String,
    /// The left side.
    pub left: Expression,
    /// The right side.
    pub right: Expression,
    /// Both sides as the page at hand shows them, where that differs from what is meant.
    pub printed: Option<(Expression, Expression)>,
    /// Why it differs, or what it is.
    pub note: String,
}

impl Equation {
    /// left − right, which the equation says is zero.
    #[must_use]
    pub fn residual(&self) -> Expression {
        self.left.clone() - self.right.clone()
    }

    /// The equation in LaTeX.
    #[must_use]
    pub fn latex(&self) -> String {
        format!("{} = {}", self.left.latex(), self.right.latex())
    }
}

impl fmt::Display for Equation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} = {}", self.left, self.right)
    }
}

/// What is wrong with one equation of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EquationFault {
    /// The key at fault, such as `equation 16`.
    pub key: String,
    /// What is wrong with it.
    pub message: String,
}

/// All faults of a file of equations at once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EquationsError {
    /// At least one.
    pub faults: Vec<EquationFault>,
}

impl fmt::Display for EquationsError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, EquationFault { key, message }) in self.faults.iter().enumerate() {
            let separator = if index > 0 { "\n" } else { "" };
            write!(formatter, "{separator}{key}: {message}")?;
        }
        Ok(())
    }
}

impl std::error::Error for EquationsError {}

/// The equations of the paper, complete: each required one is there once, in known variables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PaperEquations {
    equations: BTreeMap<String, Equation>,
    positive: Vec<String>,
}

impl PaperEquations {
    /// Reads the equations of a paper from their texts.
    ///
    /// # Errors
    /// All faults at once: missing, repeated or unknown numbers, text outside the grammar, unknown variables, a left
    /// side that should be one name and is not.
    pub fn read(text: EquationsText) -> Result<Self, EquationsError> {
        let (equations, positive) = reading::read(text)?;
        Ok(Self { equations, positive })
    }

    /// The equation of this number.
    ///
    /// # Panics
    /// For a number that is not required of every file of equations.
    #[must_use]
    pub fn equation(&self, number: &str) -> &Equation {
        &self.equations[number]
    }

    /// All equations: the numbered ones in order, then the named ones.
    pub fn iter(&self) -> impl Iterator<Item = &Equation> {
        reading::REQUIRED.iter().map(|(number, _)| self.equation(number))
    }

    /// The variables that are assumed to be positive.
    #[must_use]
    pub fn positive(&self) -> &[String] {
        &self.positive
    }

    /// The right side of the equation of this number.
    pub(super) fn right(&self, number: &str) -> Expression {
        self.equation(number).right.clone()
    }

    /// left − right of the equation of this number.
    pub(super) fn residual(&self, number: &str) -> Expression {
        self.equation(number).residual()
    }

    /// The same equations with one of them replaced: what a sabotaged claim is tested with.
    ///
    /// # Errors
    /// As [`PaperEquations::read`], and for a number that is not there.
    pub fn altered(&self, number: &str, text: &str) -> Result<Self, EquationsError> {
        let fault = |message| EquationsError {
            faults: vec![EquationFault { key: format!("equation {number}"), message }],
        };
        let known =
            self.equations.get(number).ok_or_else(|| fault("there is no such equation".to_owned()))?;
        let mut changed = reading::read_equation(number, text, &self.positive).map_err(fault)?;
        changed.printed.clone_from(&known.printed);
        let mut altered = self.clone();
        altered.equations.insert(number.to_owned(), changed);
        Ok(altered)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    const FILE: &str = include_str!("../../../../reports/im-avouac/equations.toml");

    fn read(text: &str) -> Result<PaperEquations, EquationsError> {
        PaperEquations::read(toml::from_str(text).expect("TOML with known keys"))
    }

    pub(in crate::theory) fn paper() -> PaperEquations {
        read(FILE).expect("the report's own equations")
    }

    #[test]
    fn all_equations_of_the_paper_are_read() {
        assert_eq!(paper().iter().count(), 28);
        assert!(paper().equation("7").printed.is_some());
    }

    #[test]
    fn all_faults_are_told_at_once() {
        let text = FILE
            .replace("number = \"3\"", "number = \"2\"")
            .replace("a/V_0*s^2 + (K/", "a/V_0*s^2 + (Q/")
            .replace("number = \"16\"", "number = \"61\"")
            .replace("sigma_c = K*D_c", "sigma = K*D_c")
            .replace("omega_n = sqrt(K/M)", "omega_n = sqrt(K/M");
        let error = read(&text).expect_err("five faults").to_string();
        for part in [
            "equation 2: occurs twice",
            "equation 3: is missing",
            "equation 14: left side: 'Q' is not a variable of the paper",
            "equation 61: is not an equation of the paper",
            "equation 12: the left side must be sigma_c, not sigma",
            "equation natural-frequency: right side 'sqrt(K/M', column 9: expected ')'",
        ] {
            assert!(error.contains(part), "{part} is not in:\n{error}");
        }
    }
}
