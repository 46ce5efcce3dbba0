//! Symbolic expressions: what an equation of the paper looks like before it becomes a polynomial.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::Rational;
use serde::{Deserialize, Serialize};

use super::{Monomial, Polynomial, RationalFunction, Symbol};

/// The functions of one argument that the paper's equations use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    /// Natural logarithm.
    Ln,
    /// Non-negative square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// Exponential.
    Exp,
    /// Inverse hyperbolic sine (regularised friction law).
    Asinh,
}

impl Function {
    /// The name in the text grammar.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Ln => "ln",
            Self::Sqrt => "sqrt",
            Self::Abs => "abs",
            Self::Exp => "exp",
            Self::Asinh => "asinh",
        }
    }

    /// The function of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Ln, Self::Sqrt, Self::Abs, Self::Exp, Self::Asinh].into_iter().find(|f| f.as_str() == name)
    }
}

/// An expression tree; serialised as its text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum Expression {
    /// A rational number.
    Number(Rational),
    /// A variable, perhaps with primes for time derivatives.
    Variable(Symbol),
    /// A sum.
    Sum(Vec<Expression>),
    /// A product.
    Product(Vec<Expression>),
    /// numerator/denominator.
    Quotient(Box<Expression>, Box<Expression>),
    /// The negative of an expression.
    Negation(Box<Expression>),
    /// An integer power.
    Power(Box<Expression>, i32),
    /// A function of one argument.
    Call(Function, Box<Expression>),
}

impl Expression {
    /// A whole number.
    #[must_use]
    pub fn integer(value: i32) -> Self {
        Self::Number(Rational::from(value))
    }

    /// A variable.
    #[must_use]
    pub fn variable(name: &str) -> Self {
        Self::Variable(Symbol::new(name))
    }

    /// An integer power of this expression.
    #[must_use]
    pub fn power(self, exponent: i32) -> Self {
        match exponent {
            0 => Self::integer(1),
            1 => self,
            _ => Self::Power(Box::new(self), exponent),
        }
    }

    /// A function of this expression.
    #[must_use]
    pub fn call(self, function: Function) -> Self {
        Self::Call(function, Box::new(self))
    }

    /// Is it the number zero as written?
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Number(value) if value.is_zero())
    }

    fn is_one(&self) -> bool {
        matches!(self, Self::Number(value) if *value == 1)
    }

    /// Does it begin with a minus sign? Products and quotients carry it in front.
    pub(super) fn is_negated(&self) -> bool {
        match self {
            Self::Number(value) => value.is_negative(),
            Self::Negation(_) => true,
            _ => false,
        }
    }

    /// The variables that occur.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<Symbol> {
        match self {
            Self::Number(_) => BTreeSet::new(),
            Self::Variable(name) => BTreeSet::from([name.clone()]),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().flat_map(Self::variables).collect(),
            Self::Quotient(left, right) => &left.variables() | &right.variables(),
            Self::Negation(inner) | Self::Power(inner, _) | Self::Call(_, inner) => inner.variables(),
        }
    }

    /// This expression with every variable of the map replaced, all at once.
    #[must_use]
    pub fn substitute(&self, values: &BTreeMap<Symbol, Expression>) -> Self {
        let go = |inner: &Self| inner.substitute(values);
        match self {
            Self::Number(_) => self.clone(),
            Self::Variable(name) => values.get(name).unwrap_or(self).clone(),
            Self::Sum(parts) => Self::Sum(parts.iter().map(go).collect()),
            Self::Product(parts) => Self::Product(parts.iter().map(go).collect()),
            Self::Quotient(left, right) => Self::Quotient(Box::new(go(left)), Box::new(go(right))),
            Self::Negation(inner) => Self::Negation(Box::new(go(inner))),
            Self::Power(inner, exponent) => Self::Power(Box::new(go(inner)), *exponent),
            Self::Call(function, inner) => Self::Call(*function, Box::new(go(inner))),
        }
    }

    /// This expression with one variable replaced.
    #[must_use]
    pub fn with(&self, name: &str, value: &Expression) -> Self {
        self.substitute(&BTreeMap::from([(Symbol::new(name), value.clone())]))
    }

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
    }
}

impl Add for Expression {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        match (self, other) {
            (left, right) if left.is_zero() => right,
            (left, right) if right.is_zero() => left,
            (Self::Sum(mut parts), right) => {
                parts.push(right);
                Self::Sum(parts)
            }
            (left, right) => Self::Sum(vec![left, right]),
        }
    }
}

impl Neg for Expression {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Number(value) => Self::Number(-value),
            Self::Negation(inner) => *inner,
            other => Self::Negation(Box::new(other)),
        }
    }
}

impl Sub for Expression {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Expression {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        match (self, other) {
            (left, right) if left.is_zero() || right.is_zero() => Self::integer(0),
            (left, right) if left.is_negated() => -(-left * right),
            (left, right) if right.is_negated() => -(left * -right),
            (left, right) if left.is_one() => right,
            (left, right) if right.is_one() => left,
            (Self::Product(mut parts), right) => {
                parts.push(right);
                Self::Product(parts)
            }
            (left, right) => Self::Product(vec![left, right]),
        }
    }
}

impl Div for Expression {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.is_one() || self.is_zero() {
            // 0/x stays 0 for every x at which the quotient means anything.
            return self;
        }
        if self.is_negated() {
            return -(-self / other);
        }
        Self::Quotient(Box::new(self), Box::new(other))
    }
}

impl From<&Monomial> for Expression {
    fn from(monomial: &Monomial) -> Self {
        monomial.factors().fold(Self::integer(1), |product, (name, exponent)| {
            // Exponents here stay far below i32's limit: they come from equations of a dozen terms.
            product * Self::Variable(name.clone()).power(*exponent as i32)
        })
    }
}

impl From<&Polynomial> for Expression {
    fn from(polynomial: &Polynomial) -> Self {
        let term = |(monomial, coefficient): (&Monomial, &Rational)| {
            let size = Self::Number(coefficient.clone().abs()) * Self::from(monomial);
            if coefficient.is_negative() { -size } else { size }
        };
        polynomial.terms().rev().map(term).fold(Self::integer(0), Add::add)
    }
}

impl From<&RationalFunction> for Expression {
    fn from(function: &RationalFunction) -> Self {
        Self::from(function.numerator()) / Self::from(function.denominator())
    }
}
