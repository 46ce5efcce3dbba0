//! A claim stated as a formula: what the user writes beside the claim's words.
//!
//! ```text
//! formula := side ('=' | '!=' | '<' | '>') side                 for all values that the conditions allow
//!          | side '->' side 'as' name '->' ('0' | 'infinity')   a limit, the other variables fixed
//!          | side ('rises' | 'falls') 'with' name               strictly, the other variables fixed
//!          | side ['does not'] 'depend' 'on' name
//! ```
//! A side is an expression of `equations.toml`. A name that stands alone on the left of exactly one equation, such as `K_c`, means
//! the right side of that equation; `left_8`, `right_15` and `residual_8` mean the sides of an equation and their difference.

use slipmode_core::polynomial::{ConversionError, Domain, Expression, Extent, Relation, Symbol, Toward};
use slipmode_core::theory::Equations;

use crate::scene::claim_names::Names;

/// What a side may come to when it is multiplied out: it bounds the work of a decision.
const LARGEST: Extent = Extent { terms: 1000, degree: 64, bits: 4096 };

/// A formula and the conditions under which it is claimed, as written and parsed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimFormula {
    /// The formula as written.
    pub text: String,
    /// What it says.
    pub statement: Statement,
    /// The conditions besides the positive variables of `equations.toml`.
    pub given: Vec<FormulaCondition>,
}

/// What a formula says, in the names of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Statement {
    /// Both sides compare so everywhere.
    Compare(Expression, Comparison, Expression),
    /// The first expression tends to the second as the variable goes there.
    Limit(Expression, Expression, String, Toward),
    /// The expression rises (or falls) strictly with the variable.
    Monotone(Expression, Comparison, String),
    /// Whether the variable changes the expression.
    Depends(Expression, bool, String),
}

slipmode_core::named! {
    /// How two sides compare.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Comparison {
        /// Never equal.
        Unequal = "!=",
        /// Everywhere equal.
        Equal = "=",
        /// The left side is smaller.
        Less = "<",
        /// The left side is larger.
        Greater = ">",
    }
}

impl Comparison {
    fn latex(self) -> &'static str {
        if self == Self::Unequal { "\\ne" } else { self.as_str() }
    }
}

/// A condition: left minus right compares so with zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormulaCondition {
    /// As written.
    pub text: String,
    /// In LaTeX.
    pub latex: String,
    /// What is compared with zero.
    pub expression: Expression,
    /// How.
    pub relation: Relation,
}

impl ClaimFormula {
    /// Reads a formula and its conditions.
    ///
    /// # Errors
    /// What is wrong with the formula: its grammar, an unknown name, or that both sides are the same text.
    pub fn read(text: &str, given: Vec<FormulaCondition>, equations: &Equations) -> Result<Self, String> {
        let statement = read_statement(text, equations)?;
        let formula = Self { text: text.trim().to_owned(), statement, given };
        let (names, domain) = (Names::of(equations), formula.domain(equations));
        let no_value = |side: &Expression| match domain.rational_function(&names.resolved(side)) {
            // A logarithm or an open sign may still be decided with a substitution.
            Err(ConversionError::Logarithm(_) | ConversionError::OpenSign(_)) | Ok(_) => None,
            Err(error) => Some(format!("'{side}' has no value under the conditions: {error}")),
        };
        let too_large = |side: &Expression| {
            let error = names.resolved(side).check_extent(LARGEST).err()?;
            Some(format!("'{side}' is too large: {error}"))
        };
        let conditions = formula.given.iter().map(|condition| &condition.expression);
        let mut parts = formula.statement.sides().into_iter().chain(conditions);
        let fault = parts.find_map(|part| too_large(part).or_else(|| no_value(part)));
        fault.map_or(Ok(()), Err)?;
        Ok(formula)
    }

    /// The positive variables of the equations and the conditions, with the definitions in place of their names.
    #[must_use]
    pub fn domain(&self, equations: &Equations) -> Domain {
        let names = Names::of(equations);
        let all = Domain::positive(&equations.positive().join(" "));
        let given = |domain: Domain, condition: &FormulaCondition| {
            domain.given(names.resolved(&condition.expression), condition.relation)
        };
        self.given.iter().fold(all, given)
    }
}

impl ClaimFormula {
    /// The formula and its conditions in words and LaTeX between `$`.
    #[must_use]
    pub fn markdown(&self) -> String {
        let given: Vec<String> =
            self.given.iter().map(|condition| format!("${}$", condition.latex)).collect();
        let given = if given.is_empty() { given.concat() } else { format!(" for all {}", given.join(", ")) };
        self.statement.markdown() + &given
    }
}

impl Statement {
    fn markdown(&self) -> String {
        let set = Expression::latex;
        let variable = |name: &str| Expression::variable(name).latex();
        match self {
            Self::Compare(left, comparison, right) => {
                format!("${} {} {}$", set(left), comparison.latex(), set(right))
            }
            Self::Limit(left, value, name, toward) => {
                let toward = if *toward == Toward::Zero { "0" } else { "\\infty" };
                let name = variable(name);
                format!("${} \\to {}$ as ${name} \\to {toward}$", set(left), set(value))
            }
            Self::Monotone(expression, comparison, name) => {
                let word = if *comparison == Comparison::Greater { "rises" } else { "falls" };
                format!("${}$ {word} with ${}$", set(expression), variable(name))
            }
            Self::Depends(expression, depends, name) => {
                let words = if *depends { "depends on" } else { "does not depend on" };
                format!("${}$ {words} ${}$", set(expression), variable(name))
            }
        }
    }

    /// The expressions in it.
    #[must_use]
    pub fn sides(&self) -> Vec<&Expression> {
        match self {
            Self::Compare(left, _, right) | Self::Limit(left, right, ..) => vec![left, right],
            Self::Monotone(expression, ..) | Self::Depends(expression, ..) => vec![expression],
        }
    }
}

impl FormulaCondition {
    /// Reads a condition: two sides with `<`, `>` or `!=` between them.
    ///
    /// # Errors
    /// As [`ClaimFormula::read`].
    pub fn read(text: &str, equations: &Equations) -> Result<Self, String> {
        let (left, comparison, right) =
            compared(text, equations)?.ok_or("a condition has one '<', '>' or '!=' between two sides")?;
        let latex = format!("{} {} {}", left.latex(), comparison.latex(), right.latex());
        let (expression, relation) = match comparison {
            Comparison::Greater => (left - right, Relation::Positive),
            Comparison::Less => (right - left, Relation::Positive),
            Comparison::Unequal => (left - right, Relation::NonZero),
            Comparison::Equal => return Err("a condition has one '<', '>' or '!=', not '='".into()),
        };
        Ok(Self { text: text.trim().to_owned(), latex, expression, relation })
    }
}

fn read_statement(text: &str, equations: &Equations) -> Result<Statement, String> {
    let side = |text: &str| read_side(text, equations);
    let name = |text: &str| read_variable(text, equations);
    if let Some((left, rest)) = text.split_once("->") {
        let form = "a limit has the form `side -> side as name -> 0` or `-> infinity`";
        let (value, rest) = rest.split_once(" as ").ok_or(form)?;
        let (variable, end) = rest.split_once("->").ok_or(form)?;
        let toward = match end.trim() {
            "0" => Toward::Zero,
            "infinity" => Toward::Infinity,
            _ => return Err(form.into()),
        };
        return Ok(Statement::Limit(side(left)?, side(value)?, name(variable)?, toward));
    }
    for (word, comparison) in [(" rises with ", Comparison::Greater), (" falls with ", Comparison::Less)] {
        if let Some((expression, variable)) = text.split_once(word) {
            return Ok(Statement::Monotone(side(expression)?, comparison, name(variable)?));
        }
    }
    for (words, depends) in [(" does not depend on ", false), (" depends on ", true)] {
        if let Some((expression, variable)) = text.split_once(words) {
            return Ok(Statement::Depends(side(expression)?, depends, name(variable)?));
        }
    }
    let (left, comparison, right) = compared(text, equations)?.ok_or(
        "a formula has '=', '!=', '<' or '>' once, or '->', 'rises with', 'falls with', 'depends on' or 'does not depend on'",
    )?;
    if left == right {
        return Err("both sides are the same by construction".into());
    }
    Ok(Statement::Compare(left, comparison, right))
}

/// The two sides of the one comparison in a text, if there is one.
fn compared(
    text: &str,
    equations: &Equations,
) -> Result<Option<(Expression, Comparison, Expression)>, String> {
    let marks = text.matches(['=', '<', '>']).count();
    let found = Comparison::ALL
        .into_iter()
        .find_map(|comparison| Some((text.split_once(comparison.as_str())?, comparison)));
    match found {
        Some(((left, right), comparison)) if marks == 1 => {
            Ok(Some((read_side(left, equations)?, comparison, read_side(right, equations)?)))
        }
        _ => Ok(None),
    }
}

fn read_side(text: &str, equations: &Equations) -> Result<Expression, String> {
    let (expression, _) =
        Expression::read(text.trim()).map_err(|error| format!("'{}', {error}", text.trim()))?;
    let known = Names::of(equations);
    match expression.variables().iter().find(|name| !known.has(name)) {
        Some(unknown) => Err(known.refusal(unknown.as_str())),
        None => Ok(expression),
    }
}

fn read_variable(text: &str, equations: &Equations) -> Result<String, String> {
    let (text, known) = (text.trim(), Names::of(equations));
    match known.variables.contains(&Symbol::new(text)) {
        true => Ok(text.to_owned()),
        false => Err(known.refusal(text)),
    }
}
