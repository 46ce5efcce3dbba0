//! A derivation at work: its assumptions, and the proof of what was found so far.

use crate::notation::polynomial_coefficients;
use slipmode_algebra::{
    Certificate, Condition, Domain, Expression, Proof, RationalFunction, Relation, Symbol,
};

/// The assumptions and the proof of one definition.
pub(crate) struct Work<'e> {
    /// The positive variables and the conditions, with an example of them.
    pub domain: Domain,
    /// What was proved so far.
    pub proof: Proof,
    /// The equations that enter.
    pub equations: &'e [String],
}

impl Work<'_> {
    /// The expression as a rational function.
    ///
    /// # Errors
    /// When it has no value under the assumptions, or is none.
    pub fn rational(&self, expression: &Expression) -> Result<RationalFunction, String> {
        self.domain.rational_function(expression).map_err(|error| error.to_string())
    }

    /// Refuses what has no value under the assumptions; an open sign or logarithm is no refusal.
    pub fn has_value(&self, expression: &Expression) -> Result<(), String> {
        match self.domain.rational_function(expression) {
            Err(error) if !error.is_open() => Err(error.to_string()),
            _ => Ok(()),
        }
    }

    /// Adds the step left = right.
    ///
    /// # Errors
    /// With what remains when both sides differ.
    pub fn identity(&mut self, says: &str, left: &Expression, right: &Expression) -> Result<(), String> {
        self.step(|proof, equations, domain| proof.identity(says, equations, left, right, domain))
    }

    /// Adds a certified step.
    ///
    /// # Errors
    /// With what remains when it does not hold.
    pub fn step(
        &mut self,
        add: impl FnOnce(Proof, &[&str], &Domain) -> Result<Proof, slipmode_algebra::Refutation>,
    ) -> Result<(), String> {
        let equations: Vec<&str> = self.equations.iter().map(String::as_str).collect();
        let added = add(self.proof.clone(), &equations, &self.domain);
        self.proof = added.map_err(|refutation| refutation.remainder)?;
        Ok(())
    }

    /// The derivative of an expression in a variable, the others fixed, with the step that it is the derivative. Where the expression
    /// or the derivative is no rational function, the step is argued.
    ///
    /// # Errors
    /// When it has no value under the assumptions.
    pub fn derivative(&mut self, what: &str, f: &Expression, x: &Symbol) -> Result<Expression, String> {
        let value = f.derivative(x);
        if !f.variables().contains(x) {
            return Ok(value);
        }
        let is_open =
            |side: &Expression| matches!(self.domain.rational_function(side), Err(error) if error.is_open());
        let says = format!("derivative of {what} in {x}");
        if is_open(f) || is_open(&value) {
            let proof = self.proof.clone();
            self.proof = proof.reason(format!("The {says} is {value}, by the rules of differentiation."));
            return Ok(value);
        }
        self.step(|proof, equations, domain| {
            let (expression, value, domain) = (f.clone(), value.clone(), domain.clone());
            let variable = x.clone();
            proof.certify(&says, equations, Certificate::Derivative { expression, variable, value, domain })
        })?;
        Ok(value)
    }

    /// The expression in lowest terms, with the step that it is the same. What is no rational function stays as it is.
    ///
    /// # Errors
    /// When it has no value under the assumptions.
    pub fn simplified(&mut self, says: &str, raw: &Expression) -> Result<Expression, String> {
        let function = match self.domain.rational_function(raw) {
            Ok(function) => function,
            Err(error) if error.is_open() => return Ok(raw.clone()),
            Err(error) => return Err(error.to_string()),
        };
        let simple = expression(&function);
        if simple != *raw {
            self.identity(says, raw, &simple)?;
        }
        Ok(simple)
    }

    /// The coefficients of a polynomial by ascending power of a variable, the last one not zero.
    ///
    /// # Errors
    /// When it is no polynomial in that variable, or of another degree than allowed.
    pub fn coefficients(
        &self,
        polynomial: &Expression,
        variable: &Symbol,
        degrees: std::ops::RangeInclusive<usize>,
    ) -> Result<Vec<RationalFunction>, String> {
        let function = self.rational(polynomial)?;
        let parts = polynomial_coefficients(&function, variable)
            .ok_or_else(|| format!("'{polynomial}' is no polynomial in {variable}"))?;
        let degree = parts.len() - 1;
        if !degrees.contains(&degree) {
            let (low, high) = degrees.into_inner();
            return Err(format!(
                "'{polynomial}' has degree {degree} in {variable} (allowed: {low} to {high})"
            ));
        }
        Ok(parts)
    }

    /// Adds the step that an expression is not zero: positive, negative, or by an assumption.
    ///
    /// # Errors
    /// When the assumptions do not exclude that it is zero.
    pub fn not_zero(&mut self, says: &str, found: &Expression) -> Result<(), String> {
        let expression = found.clone();
        if let Ok(Some(sign)) = self.domain.sign(found) {
            let certificate = Certificate::Sign { expression, sign, domain: self.domain.clone() };
            return self.step(|proof, equations, _| proof.certify(says, equations, certificate));
        }
        if self.domain.proves(&Condition { expression, relation: Relation::NonZero }) != Ok(true) {
            return Err(format!("'{found}' may be zero: the assumptions do not exclude it"));
        }
        // x·(1/x) = 1 is refused where x may be zero.
        let one = found.clone() * (Expression::integer(1) / found.clone());
        self.identity(says, &one, &Expression::integer(1))
    }
}

/// A rational function as an expression. Roots, logarithms and the like are written out again.
pub(crate) fn expression(function: &RationalFunction) -> Expression {
    Expression::from(function)
}
