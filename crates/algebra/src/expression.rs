//! Symbolic expressions: what an equation of the paper looks like before it becomes a polynomial.

pub(super) mod symbol;

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;
use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::Rational;
use symbol::{Generator, Symbol};

crate::named! {
    /// The functions of one argument that the paper's equations use.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Function {
        /// Natural logarithm.
        Ln = "ln",
        /// Non-negative square root.
        Sqrt = "sqrt",
        /// Absolute value.
        Abs = "abs",
        /// Exponential.
        Exp = "exp",
        /// Inverse hyperbolic sine (regularised friction law).
        Asinh = "asinh",
        /// Sine.
        Sin = "sin",
        /// Cosine.
        Cos = "cos",
    }
}

/// An expression tree; serialised as its text.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "String", into = "String"))]
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
    /// A smooth function of one argument of which nothing else is known, or one of its derivatives: f, f′, f″, ….
    Generic(Symbol, Box<Expression>),
}

impl Expression {
    /// A whole number.
    #[must_use]
    pub fn integer(value: i32) -> Self {
        Self::Number(Rational::from(value))
    }

    /// A variable.
    #[must_use]
    pub fn variable(name: impl Into<Symbol>) -> Self {
        Self::Variable(name.into())
    }

    /// An integer power of this expression; the power 0 of anything but the number zero is 1.
    #[must_use]
    pub fn power(self, exponent: i32) -> Self {
        match exponent {
            0 if !self.is_zero() => Self::integer(1),
            1 => self,
            _ if self.is_one() || (self.is_zero() && exponent > 0) => self,
            _ => Self::Power(Box::new(self), exponent),
        }
    }

    /// A function of this expression.
    #[must_use]
    pub fn call(self, function: Function) -> Self {
        Self::Call(function, Box::new(self))
    }

    /// The quotient as it is written.
    pub(super) fn quotient(above: Self, below: Self) -> Self {
        Self::Quotient(Box::new(above), Box::new(below))
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
    /// What stands below a square root, if this is one.
    pub(super) fn below_root(&self) -> Option<&Self> {
        match self {
            Self::Call(Function::Sqrt, inner) => Some(inner),
            _ => None,
        }
    }

    pub(super) fn is_negated(&self) -> bool {
        match self {
            Self::Number(value) => value.is_negative(),
            Self::Negation(_) => true,
            _ => false,
        }
    }

    /// The expressions that it is made of.
    pub fn parts(&self) -> impl Iterator<Item = &Self> {
        let (many, [first, second]): (&[Self], [Option<&Self>; 2]) = match self {
            Self::Number(_) | Self::Variable(_) => (&[], [None; 2]),
            Self::Sum(parts) | Self::Product(parts) => (parts, [None; 2]),
            Self::Quotient(left, right) => (&[], [Some(left), Some(right)]),
            Self::Negation(inner)
            | Self::Power(inner, _)
            | Self::Call(_, inner)
            | Self::Generic(_, inner) => (&[], [Some(inner), None]),
        };
        many.iter().chain(first).chain(second)
    }

    /// Whether this variable is in it.
    #[must_use]
    pub fn contains(&self, variable: &Symbol) -> bool {
        matches!(self, Self::Variable(name) if name == variable)
            || self.parts().any(|part| part.contains(variable))
    }

    /// Whether a call of this function is in it.
    #[must_use]
    pub fn calls(&self, function: Function) -> bool {
        matches!(self, Self::Call(own, _) if *own == function)
            || self.parts().any(|part| part.calls(function))
    }

    /// The variables that occur.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<Symbol> {
        let mut found = BTreeSet::new();
        self.add_variables(&mut found);
        found
    }

    fn add_variables(&self, found: &mut BTreeSet<Symbol>) {
        if let Self::Variable(name) = self {
            found.insert(name.clone());
        }
        self.parts().for_each(|part| part.add_variables(found));
    }

    /// Adds the functions in it of which nothing is known, each as often as it has different arguments.
    pub(super) fn add_generics(&self, found: &mut BTreeSet<Generator>) {
        if let Self::Generic(function, inner) = self {
            found.insert(Generator::generic(function, (**inner).clone()));
        }
        self.parts().for_each(|part| part.add_generics(found));
    }

    /// The names, without primes, of the functions in it of which nothing is known.
    #[must_use]
    pub fn functions(&self) -> BTreeSet<Symbol> {
        let mut found = BTreeSet::new();
        self.add_generics(&mut found);
        found.iter().filter_map(Generator::generic_function).map(Symbol::undifferentiated).collect()
    }

    /// Whether it has a function of this variable of which nothing is known.
    pub(super) fn has_function_of(&self, variable: &Symbol) -> bool {
        let mut found = BTreeSet::new();
        self.add_generics(&mut found);
        found.iter().any(|generator| generator.hides(variable))
    }

    /// Is it, as can be seen at once, positive where these variables are?
    #[must_use]
    pub fn is_positive_by_form(&self, is_positive: &impl Fn(&Symbol) -> bool) -> bool {
        let go = |inner: &Self| inner.is_positive_by_form(is_positive);
        match self {
            Self::Number(value) => value.is_positive(),
            Self::Variable(name) => is_positive(name),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().all(go),
            Self::Quotient(above, below) => go(above) && go(below),
            Self::Negation(_) => false,
            Self::Power(inner, _) | Self::Call(Function::Sqrt, inner) => go(inner),
            Self::Call(..) | Self::Generic(..) => false,
        }
    }

    /// Has it a value for all values of its variables, as far as can be seen at once?
    pub(super) fn is_total(&self) -> bool {
        match self {
            Self::Number(_) | Self::Variable(_) => true,
            Self::Sum(parts) | Self::Product(parts) => parts.iter().all(Self::is_total),
            Self::Quotient(above, below) => above.is_total() && below.is_never_zero(),
            Self::Negation(inner) | Self::Generic(_, inner) => inner.is_total(),
            Self::Power(inner, exponent) => *exponent > 0 && inner.is_total(),
            Self::Call(function, inner) => {
                !matches!(function, Function::Ln | Function::Sqrt) && inner.is_total()
            }
        }
    }

    /// Is it, as far as can be seen at once, not zero whatever its variables are?
    fn is_never_zero(&self) -> bool {
        match self {
            Self::Number(value) => !value.is_zero(),
            Self::Call(Function::Exp, inner) => inner.is_total(),
            Self::Negation(inner) | Self::Power(inner, _) => inner.is_never_zero(),
            Self::Product(parts) => parts.iter().all(Self::is_never_zero),
            _ => false,
        }
    }

    /// This expression with every variable of the map replaced, all at once.
    ///
    /// Zero times a factor is zero, and zero over a divisor too, only where the replacement leaves the factor or divisor as it
    /// was, or it has a value everywhere: else it may have none where the new expression is used.
    #[must_use]
    pub fn substitute(&self, values: &BTreeMap<Symbol, Expression>) -> Self {
        let go = |inner: &Self| inner.substitute(values);
        match self {
            Self::Variable(name) => values.get(name).unwrap_or(self).clone(),
            Self::Sum(parts) => parts.iter().map(go).fold(Self::integer(0), Add::add),
            Self::Product(parts) => {
                let replaced: Vec<Self> = parts.iter().map(go).collect();
                let kept = |(new, old): (&Self, &Self)| new == old || new.is_total();
                let may_vanish = replaced.iter().any(Self::is_zero);
                if may_vanish && !replaced.iter().zip(parts).all(kept) {
                    return Self::Product(replaced);
                }
                replaced.into_iter().fold(Self::integer(1), Mul::mul)
            }
            Self::Quotient(left, right) => {
                let (above, below) = (go(left), go(right));
                if above.is_zero() && below != **right && !below.is_never_zero() {
                    return Self::quotient(above, below);
                }
                above / below
            }
            Self::Negation(inner) => -go(inner),
            Self::Power(inner, exponent) if *exponent != 0 => go(inner).power(*exponent),
            Self::Number(_) | Self::Power(..) | Self::Call(..) | Self::Generic(..) => self.with_parts(&go),
        }
    }

    /// This expression with every variable of the map replaced and nothing else changed.
    #[must_use]
    pub fn replaced(&self, values: &BTreeMap<Symbol, Expression>) -> Self {
        match self {
            Self::Variable(name) => values.get(name).unwrap_or(self).clone(),
            other => other.with_parts(&|part| part.replaced(values)),
        }
    }

    /// The same with each part that it is directly made of replaced, and nothing simplified.
    pub(super) fn with_parts(&self, new: &dyn Fn(&Self) -> Self) -> Self {
        let Ok(expression) = self.try_with_parts(|part| Ok::<_, Infallible>(new(part)));
        expression
    }

    /// The same with parts that may be refused.
    pub(super) fn try_with_parts<E>(&self, new: impl Fn(&Self) -> Result<Self, E>) -> Result<Self, E> {
        let boxed = |inner: &Self| new(inner).map(Box::new);
        Ok(match self {
            Self::Number(_) | Self::Variable(_) => self.clone(),
            Self::Sum(parts) => Self::Sum(parts.iter().map(&new).collect::<Result<_, _>>()?),
            Self::Product(parts) => Self::Product(parts.iter().map(&new).collect::<Result<_, _>>()?),
            Self::Quotient(left, right) => Self::Quotient(boxed(left)?, boxed(right)?),
            Self::Negation(inner) => Self::Negation(boxed(inner)?),
            Self::Power(inner, exponent) => Self::Power(boxed(inner)?, *exponent),
            Self::Call(function, inner) => Self::Call(*function, boxed(inner)?),
            Self::Generic(function, inner) => Self::Generic(function.clone(), boxed(inner)?),
        })
    }

    /// This expression with one variable replaced.
    #[must_use]
    pub fn with(&self, name: impl Into<Symbol>, value: &Expression) -> Self {
        self.substitute(&BTreeMap::from([(name.into(), value.clone())]))
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
        // 0/x stays 0 for every x at which the quotient means anything; 0/0 means nothing.
        if other.is_one() || (self.is_zero() && !other.is_zero()) {
            return self;
        }
        if self.is_negated() {
            return -(-self / other);
        }
        Self::quotient(self, other)
    }
}

#[cfg(test)]
pub(super) mod tests;
