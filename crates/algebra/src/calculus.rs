//! Derivatives of expressions.

use std::ops::Add;

use super::{Expression, Function, Symbol};

impl Expression {
    /// The derivative with respect to one variable; the others, primed ones too, are held fixed.
    #[must_use]
    pub fn derivative(&self, variable: &Symbol) -> Self {
        let d = |inner: &Self| inner.derivative(variable);
        match self {
            Self::Number(_) => Self::integer(0),
            Self::Variable(name) => Self::integer(i32::from(name == variable)),
            Self::Sum(parts) => parts.iter().map(d).fold(Self::integer(0), Add::add),
            Self::Product(parts) => product_rule(parts, variable),
            Self::Quotient(left, right) if !right.variables().contains(variable) => {
                d(left) / (**right).clone()
            }
            Self::Quotient(left, right) => {
                (d(left) * (**right).clone() - (**left).clone() * d(right)) / (**right).clone().power(2)
            }
            Self::Negation(inner) => -d(inner),
            Self::Power(inner, exponent) => {
                Self::integer(*exponent) * (**inner).clone().power(exponent - 1) * d(inner)
            }
            Self::Call(function, inner) => chain_rule(*function, inner) * d(inner),
            Self::Generic(function, inner) => {
                Self::Generic(function.time_derivative(), inner.clone()) * d(inner)
            }
        }
    }

    /// The derivative with respect to time: every variable of `moving` gains a prime by the chain rule.
    #[must_use]
    pub fn time_derivative(&self, moving: &[&str]) -> Self {
        self.variables()
            .iter()
            .filter(|name| moving.contains(&name.base()))
            .map(|name| self.derivative(name) * Self::Variable(name.time_derivative()))
            .fold(Self::integer(0), Add::add)
    }
}

fn product_rule(parts: &[Expression], variable: &Symbol) -> Expression {
    let term = |index: usize| {
        parts.iter().enumerate().fold(Expression::integer(1), |product, (position, factor)| {
            product * if position == index { factor.derivative(variable) } else { factor.clone() }
        })
    };
    (0..parts.len()).map(term).fold(Expression::integer(0), Add::add)
}

/// The derivative of a function at its argument.
fn chain_rule(function: Function, argument: &Expression) -> Expression {
    let (one, two) = (Expression::integer(1), Expression::integer(2));
    let argument = argument.clone();
    match function {
        Function::Ln => one / argument,
        Function::Sqrt => one / (two * argument.call(Function::Sqrt)),
        Function::Abs => argument.clone() / argument.call(Function::Abs),
        Function::Exp => argument.call(Function::Exp),
        Function::Asinh => one.clone() / (one + argument.power(2)).call(Function::Sqrt),
        Function::Sin => argument.call(Function::Cos),
        Function::Cos => -argument.call(Function::Sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_moves_gains_a_prime() {
        let expression: Expression = "x^2*y/z".parse().expect("in the grammar");
        assert_eq!(expression.time_derivative(&["x", "y"]).to_string(), "2*x*y/z*x' + x^2/z*y'");
    }
}
