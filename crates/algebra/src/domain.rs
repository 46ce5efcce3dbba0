//! What is assumed of the variables of a proof, and how roots are made rational by positive substitution.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use rug::Rational;

use super::rational_function::evaluate;
use super::{Condition, Expression, Notation, Relation, Sign, Symbol, TooLarge};

/// Assumptions on variables, and expressions put in their places.
///
/// What is proved in a domain holds for all values of the variables of which the positive ones are positive and which meet
/// the conditions. Writing a = α², b = (α + γ)² makes √a and √b rational and fixes the sign of b − a. Such a substitution
/// stands for an assumption on a and b, here a, b > 0 and b − a > 0, and must reach every point of it: α and γ are
/// parameters, each with its value in the original variables, and [`Domain::check`] computes that these values are
/// positive and give a and b back. A variable that carries no assumption is defined by its substitution.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Domain {
    positive: Vec<Symbol>,
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    given: Vec<Condition>,
    /// Variables with a known square: S² = 1 − C² says that (C, S) is a point of the unit circle.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    squares: Vec<(Symbol, Expression)>,
    substitutions: Vec<(Symbol, Expression)>,
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    parameters: Vec<(Symbol, Expression)>,
    /// Values at which all assumptions hold; a positive variable without a value is 1, any other 0.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    example: Vec<(Symbol, Expression)>,
}

/// Why an expression is not a rational function under the assumptions.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ConversionError {
    /// A denominator vanishes identically.
    #[error("division by zero in {0}")]
    DivisionByZero(String),
    /// A denominator may vanish.
    #[error("{0} is a divisor and may be zero: the assumptions do not exclude it")]
    PossibleZero(String),
    /// The argument of a square root may be negative.
    #[error("{0} is the argument of a square root and may be negative: the assumptions do not exclude it")]
    PossibleNegative(String),
    /// The logarithm of something that the assumptions do not make positive.
    #[error(
        "{0} is the argument of a logarithm and may be zero or negative: the assumptions do not exclude it"
    )]
    Logarithm(String),
    /// The absolute value of something whose sign the assumptions leave open.
    #[error("the sign of {0} is not decided by the assumptions")]
    OpenSign(String),
    /// A function of something that contains the imaginary unit.
    #[error("{0} is the argument of a function and contains i: functions are those of real numbers")]
    Imaginary(String),
    /// Multiplying out would take too long.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
}

impl ConversionError {
    /// Whether another form of the assumptions may decide it: the expression may still have a value.
    #[must_use]
    pub fn is_open(&self) -> bool {
        matches!(self, Self::Logarithm(_) | Self::OpenSign(_))
    }
}

/// Why a domain says nothing, or something else than what is computed in it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DomainError {
    /// A substitution misses a part of the assumption on its variable.
    #[error("{name} = {value} proves its image only: it does not reach every {name} of the assumptions")]
    NotCovered {
        /// The variable.
        name: Symbol,
        /// What is put in its place.
        value: Expression,
    },
    /// The value of a parameter is not positive under the assumptions.
    #[error("the parameter {name} = {value} is not positive under the assumptions")]
    Parameter {
        /// The parameter.
        name: Symbol,
        /// Its value in the original variables.
        value: Expression,
    },
    /// A name is used for two things.
    #[error("{0} stands for two things in one domain")]
    Ambiguous(Symbol),
    /// The assumptions do not hold where the domain says that they do.
    #[error("{0} does not hold at the example, so that the assumptions may be impossible")]
    Impossible(String),
    /// An assumption is no rational function.
    #[error(transparent)]
    Conversion(#[from] ConversionError),
}

impl Domain {
    /// A domain in which the variables of this space-separated list are positive; others are free.
    #[must_use]
    pub fn positive(names: &'static str) -> Self {
        Self::of_positive(names.split_whitespace().map(Symbol::from))
    }

    /// A domain in which these variables are positive; others are free.
    #[must_use]
    pub fn of_positive(names: impl IntoIterator<Item = Symbol>) -> Self {
        Self { positive: names.into_iter().collect(), ..Self::default() }
    }

    /// The same domain with one more positive variable.
    #[must_use]
    pub fn with_positive(mut self, name: Symbol) -> Self {
        self.positive.push(name);
        self
    }

    /// The same domain with one more condition.
    #[must_use]
    pub fn given(mut self, expression: Expression, relation: Relation) -> Self {
        self.given.push(Condition { expression, relation });
        self
    }

    /// The same domain in which the square of a variable is known.
    #[must_use]
    pub fn with_square(mut self, name: impl Into<Symbol>, square: Expression) -> Self {
        self.squares.push((name.into(), square));
        self
    }

    /// The same domain with one variable expressed by others (substitutions happen all at once, not in turn).
    #[must_use]
    pub fn with(mut self, name: impl Into<Symbol>, value: Expression) -> Self {
        let name = name.into();
        self.substitutions.retain(|(known, _)| *known != name);
        self.substitutions.push((name, value));
        self
    }

    /// The same domain with a positive parameter, which has this value in the variables that the assumptions are about.
    #[must_use]
    pub fn parameter(mut self, name: impl Into<Symbol>, value: Expression) -> Self {
        self.parameters.push((name.into(), value));
        self
    }

    /// The same domain with the value of one variable at which all assumptions hold.
    #[must_use]
    pub fn example(mut self, name: impl Into<Symbol>, value: Expression) -> Self {
        self.example.push((name.into(), value));
        self
    }

    /// The same domain without values at which all assumptions hold.
    #[must_use]
    pub fn without_example(mut self) -> Self {
        self.example.clear();
        self
    }

    /// Is this variable positive by assumption, or as a parameter?
    #[must_use]
    pub fn is_positive(&self, name: &Symbol) -> bool {
        let mut listed = self.positive.iter().chain(self.parameters.iter().map(|(name, _)| name));
        listed.any(|known| known == name)
    }

    /// The symbols that it speaks of.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let pairs = self.squares.iter().chain(&self.substitutions).chain(&self.parameters);
        let named = self.positive.iter().chain(pairs.map(|(name, _)| name)).cloned();
        named.chain(self.expressions().into_iter().flat_map(Expression::variables)).collect()
    }

    /// The expressions of its assumptions, substitutions and parameters.
    pub(super) fn expressions(&self) -> Vec<&Expression> {
        let pairs = self.squares.iter().chain(&self.substitutions).chain(&self.parameters);
        let given = self.given.iter().map(|condition| &condition.expression);
        given.chain(pairs.map(|(_, value)| value)).collect()
    }

    /// The conditions.
    #[must_use]
    pub fn conditions(&self) -> &[Condition] {
        &self.given
    }

    /// The variables with a known square.
    pub(super) fn squares(&self) -> &[(Symbol, Expression)] {
        &self.squares
    }

    /// The parameters, each with its value in the original variables.
    pub(super) fn parameters(&self) -> &[(Symbol, Expression)] {
        &self.parameters
    }

    /// The same assumptions without substitutions.
    #[must_use]
    pub fn original(&self) -> Self {
        Self { substitutions: Vec::new(), parameters: Vec::new(), ..self.clone() }
    }

    /// The same domain with no more than this many conditions.
    pub(super) fn with_conditions(&self, count: usize) -> Self {
        Self { given: self.given.iter().take(count).cloned().collect(), ..self.clone() }
    }

    /// The substitutions, in the order given.
    #[must_use]
    pub fn substitutions(&self) -> &[(Symbol, Expression)] {
        &self.substitutions
    }

    /// The expression after the substitutions.
    #[must_use]
    pub fn substituted(&self, expression: &Expression) -> Expression {
        expression.substitute(&values(&self.substitutions))
    }

    /// The expression after the substitutions with nothing simplified: a divisor stays where it may be zero.
    pub(super) fn as_written(&self, expression: &Expression) -> Expression {
        expression.replaced(&values(&self.substitutions))
    }

    /// Checks that the domain means what it says: every name stands for one thing, the assumptions can hold, and the
    /// substitutions reach every point at which they do.
    ///
    /// # Errors
    /// The first fault.
    pub fn check(&self) -> Result<(), DomainError> {
        self.check_names()?;
        self.check_example()?;
        let original = self.original();
        for (name, value) in &self.parameters {
            if original.sign(value)? != Some(1) {
                return Err(DomainError::Parameter { name: name.clone(), value: value.clone() });
            }
        }
        let parameters = values(&self.parameters);
        for (name, value) in self.substitutions.iter().filter(|(name, _)| self.is_assumed(name)) {
            let reached =
                original.difference(&value.replaced(&parameters), &Expression::Variable(name.clone()))?;
            if !reached.is_zero() {
                return Err(DomainError::NotCovered { name: name.clone(), value: value.clone() });
            }
        }
        Ok(())
    }

    /// Does an assumption speak of this variable?
    pub(super) fn is_assumed(&self, name: &Symbol) -> bool {
        self.positive.contains(name)
            || self.given.iter().any(|condition| condition.expression.variables().contains(name))
            || self.squares.iter().any(|(known, square)| known == name || square.variables().contains(name))
    }

    /// Substituted variables, parameters and other names must not be mixed up.
    fn check_names(&self) -> Result<(), DomainError> {
        let mut seen = BTreeSet::new();
        let mut named = self.substitutions.iter().chain(&self.parameters).map(|(name, _)| name);
        let doubled = named.find(|name| !seen.insert(*name));
        let substituted = |name: &Symbol| self.substitutions.iter().any(|(known, _)| known == name);
        let circular = self.substitutions.iter().flat_map(|(_, value)| value.variables()).find(substituted);
        let assumed = self.parameters.iter().map(|(name, _)| name).find(|name| self.is_assumed(name));
        let known = self.squares.iter().map(|(name, _)| name).find(|name| {
            self.positive.contains(name) || seen.contains(name) || ["i", "pm"].contains(&name.as_str())
        });
        let imaginary = self.positive.iter().find(|name| ["i", "pm"].contains(&name.as_str()));
        let ambiguous = doubled.or(circular.as_ref()).or(assumed).or(known).or(imaginary);
        ambiguous.map_or(Ok(()), |name| Err(DomainError::Ambiguous(name.clone())))
    }

    /// Every assumption must hold at the example.
    fn check_example(&self) -> Result<(), DomainError> {
        let original = self.original();
        let value = |expression: &Expression| -> Result<Option<Rational>, DomainError> {
            let function = original.rational_function(expression)?;
            let of_functions = self.example.iter().map(|(name, _)| name.clone());
            let of_functions = of_functions.filter(|name| name.function_at_zero().is_some());
            let names = function.variables().into_iter().chain(of_functions);
            Ok(evaluate(&function, &names.map(|name| (name.clone(), self.example_of(&name))).collect()))
        };
        for name in &self.positive {
            if !self.example_of(name).is_positive() {
                return Err(DomainError::Impossible(format!("{name} > 0")));
            }
        }
        for condition in &self.given {
            let expression = &condition.expression;
            let names = expression.variables().into_iter();
            let enclosed =
                || expression.order_at(&names.map(|name| (name.clone(), self.example_of(&name))).collect());
            let order = value(expression)?.map(|value| value.cmp0()).or_else(enclosed);
            if !order.is_some_and(|order| Sign::from(condition.relation).admits(order)) {
                return Err(DomainError::Impossible(condition.to_string()));
            }
        }
        for (name, square) in &self.squares {
            let given = self.example_of(name);
            if value(square)? != Some(Rational::from(&given * &given)) {
                return Err(DomainError::Impossible(format!("{name}^2 = {square}")));
            }
        }
        Ok(())
    }

    pub(super) fn example_of(&self, name: &Symbol) -> Rational {
        let given = self.example.iter().find(|(known, _)| known == name);
        let number =
            given.and_then(|(_, value)| Self::default().rational_function(value).ok()?.as_constant());
        number.unwrap_or_else(|| Rational::from(i32::from(self.is_positive(name))))
    }

    /// Are positive variables all there is?
    pub(super) fn is_orthant(&self) -> bool {
        self.expressions().is_empty()
    }

    /// Does no assumption, substitution or parameter speak of this variable?
    pub(super) fn is_unbound(&self, name: &Symbol) -> bool {
        let mut values = self.substitutions.iter().chain(&self.parameters);
        !values.any(|(known, value)| known == name || value.contains(name)) && !self.is_assumed(name)
    }

    /// May this variable be any positive number, whatever the others are?
    pub(super) fn leaves_free(&self, name: &Symbol) -> bool {
        self.moves_alone(name) && self.given.iter().all(|condition| !condition.expression.contains(name))
    }

    /// The same but for the conditions, which may contain it.
    pub(super) fn moves_alone(&self, name: &Symbol) -> bool {
        let mut bound = self.squares.iter().chain(&self.parameters);
        let substituted = self.substitutions.iter().any(|(known, _)| known == name);
        self.positive.contains(name) && !substituted && bound.all(|(_, value)| !value.contains(name))
    }
}

fn values(pairs: &[(Symbol, Expression)]) -> BTreeMap<Symbol, Expression> {
    pairs.iter().cloned().collect()
}

impl Domain {
    /// What is assumed, substituted and chosen.
    #[must_use]
    pub fn written(&self, notation: Notation) -> String {
        let mut parts = Vec::new();
        if !self.positive.is_empty() {
            let names: Vec<String> = self.positive.iter().map(|name| notation.name(name)).collect();
            parts.push(notation.formula(format_args!("{} > 0", names.join(", "))));
        }
        parts.extend(self.given.iter().map(|condition| notation.condition(condition)));
        let square = |(name, square): &(Symbol, Expression)| {
            notation.formula(format_args!("{}^2 = {}", notation.name(name), notation.set(square)))
        };
        parts.extend(self.squares.iter().map(square));
        parts.extend(self.substitutions.iter().map(|one| notation.equal([one])));
        for (word, pairs) in [("where", &self.parameters), ("possible at", &self.example)] {
            if !pairs.is_empty() {
                parts.push(format!("{word} {}", notation.equal(pairs)));
            }
        }
        parts.join("; ")
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.written(Notation::Plain))
    }
}

#[cfg(test)]
mod tests;
