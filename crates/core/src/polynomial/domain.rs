//! What is assumed of the variables of a proof, and how roots are made rational by positive substitution.

use std::collections::BTreeMap;
use std::fmt;

use super::conversion::Converter;
use super::{ConversionError, Expression, RationalFunction, Symbol};

/// Assumptions on variables: which are positive, and which are expressed by others.
///
/// Writing a = α², b = (α + γ)² with α, γ > 0 says a < b, makes √a and √b rational, and fixes the sign of b − a, all
/// at once. Identities and signs proved after the substitution hold for all values that it can take.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Domain {
    positive: Vec<String>,
    substitutions: Vec<(String, Expression)>,
}

impl Domain {
    /// A domain in which the variables of this space-separated list are positive; others are free.
    #[must_use]
    pub fn positive(names: &str) -> Self {
        Self { positive: names.split_whitespace().map(str::to_owned).collect(), substitutions: Vec::new() }
    }

    /// The same domain with one variable expressed by others (substitutions happen all at once, not in turn).
    #[must_use]
    pub fn with(mut self, name: &str, value: Expression) -> Self {
        self.substitutions.retain(|(known, _)| known != name);
        self.substitutions.push((name.to_owned(), value));
        self
    }

    /// Is this variable assumed positive? Values of the exponential always are.
    #[must_use]
    pub fn is_positive(&self, name: &Symbol) -> bool {
        name.as_str().starts_with("exp(") || self.positive.iter().any(|known| known == name.as_str())
    }

    /// The positive variables.
    #[must_use]
    pub fn positive_names(&self) -> &[String] {
        &self.positive
    }

    /// The substitutions, in the order given.
    #[must_use]
    pub fn substitutions(&self) -> &[(String, Expression)] {
        &self.substitutions
    }

    /// The expression after the substitutions.
    #[must_use]
    pub fn substituted(&self, expression: &Expression) -> Expression {
        let values: BTreeMap<Symbol, Expression> =
            self.substitutions.iter().map(|(name, value)| (Symbol::new(name), value.clone())).collect();
        expression.substitute(&values)
    }

    /// The expression as a rational function, after the substitutions; i² = −1 and pm² = 1 are used.
    ///
    /// # Errors
    /// When it divides by zero, or a logarithm or absolute value cannot be resolved under the assumptions.
    pub fn rational_function(&self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        Converter::new(self).convert(&self.substituted(expression))
    }

    /// left − right as a rational function: zero exactly when both sides are the same.
    ///
    /// # Errors
    /// As [`Domain::rational_function`].
    pub fn difference(
        &self,
        left: &Expression,
        right: &Expression,
    ) -> Result<RationalFunction, ConversionError> {
        self.rational_function(&(left.clone() - right.clone()))
    }

    /// The sign of an expression for all values of the domain, when coefficients of one sign decide it.
    ///
    /// # Errors
    /// As [`Domain::rational_function`].
    pub fn sign(&self, expression: &Expression) -> Result<Option<i8>, ConversionError> {
        Ok(self.sign_of(&self.rational_function(expression)?))
    }

    pub(super) fn sign_of(&self, function: &RationalFunction) -> Option<i8> {
        let variables = &function.numerator().variables() | &function.denominator().variables();
        let all_positive = variables.iter().all(|name| self.is_positive(name));
        all_positive.then(|| function.coefficient_sign()).flatten()
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        if !self.positive.is_empty() {
            parts.push(format!("{} > 0", self.positive.join(", ")));
        }
        parts.extend(self.substitutions.iter().map(|(name, value)| format!("{name} = {value}")));
        formatter.write_str(&parts.join("; "))
    }
}
