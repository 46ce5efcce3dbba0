//! From expressions to rational functions.
//!
//! Logarithms of monomials fall apart into logarithms of positive variables, roots of square monomials are taken, signs
//! of absolute values are decided; whatever remains (an exponential, the root of a sum) becomes a variable named by its
//! own text, with the square of a root known.

use std::collections::BTreeMap;

use rug::Rational;
use thiserror::Error;

use super::{Domain, Expression, Function, Monomial, Polynomial, RationalFunction, Symbol};

/// Why an expression is not a rational function under the assumptions.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ConversionError {
    /// A denominator vanishes identically.
    #[error("division by zero in {0}")]
    DivisionByZero(String),
    /// The logarithm of something that is not a product of positive variables.
    #[error("ln({0}) is not the logarithm of a product of positive variables")]
    Logarithm(String),
    /// The absolute value of something whose sign the assumptions leave open.
    #[error("the sign of {0} is not decided by the assumptions")]
    OpenSign(String),
}

pub(super) struct Converter<'d> {
    domain: &'d Domain,
    squares: BTreeMap<Symbol, RationalFunction>,
}

impl<'d> Converter<'d> {
    pub(super) fn new(domain: &'d Domain) -> Self {
        let imaginary = (Symbol::new("i"), RationalFunction::from(-1));
        let either_sign = (Symbol::new("pm"), RationalFunction::from(1));
        Self { domain, squares: BTreeMap::from([imaginary, either_sign]) }
    }

    pub(super) fn convert(mut self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        let function = self.function(expression)?;
        let mut reduced = function;
        for (name, square) in &self.squares {
            reduced = reduce_square(&reduced, name, square)
                .ok_or_else(|| ConversionError::DivisionByZero(expression.to_string()))?;
        }
        Ok(reduced)
    }

    fn function(&mut self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        match expression {
            Expression::Number(value) => Ok(RationalFunction::constant(value.clone())),
            Expression::Variable(name) => Ok(RationalFunction::variable(name.as_str())),
            Expression::Sum(parts) => self.fold(parts, RationalFunction::from(0), |sum, part| &sum + &part),
            Expression::Product(parts) => {
                self.fold(parts, RationalFunction::from(1), |product, part| &product * &part)
            }
            Expression::Negation(inner) => Ok(-self.function(inner)?),
            Expression::Quotient(left, right) => {
                let (left, right) = (self.function(left)?, self.function(right)?);
                left.checked_div(&right)
                    .ok_or_else(|| ConversionError::DivisionByZero(expression.to_string()))
            }
            Expression::Power(inner, exponent) => {
                let power = self.function(inner)?.checked_pow(*exponent);
                power.ok_or_else(|| ConversionError::DivisionByZero(expression.to_string()))
            }
            Expression::Call(function, inner) => {
                let argument = self.function(inner)?;
                self.call(*function, &argument)
            }
        }
    }

    fn fold(
        &mut self,
        parts: &[Expression],
        start: RationalFunction,
        combine: impl Fn(RationalFunction, RationalFunction) -> RationalFunction,
    ) -> Result<RationalFunction, ConversionError> {
        parts.iter().try_fold(start, |total, part| Ok(combine(total, self.function(part)?)))
    }

    fn call(
        &mut self,
        function: Function,
        argument: &RationalFunction,
    ) -> Result<RationalFunction, ConversionError> {
        match function {
            Function::Ln => self.logarithm(argument),
            Function::Abs => self.absolute(argument),
            Function::Sqrt => Ok(self.root(argument)),
            Function::Exp if argument.is_zero() => Ok(RationalFunction::from(1)),
            Function::Exp | Function::Asinh => Ok(opaque(function, argument)),
        }
    }

    fn logarithm(&self, argument: &RationalFunction) -> Result<RationalFunction, ConversionError> {
        let error = || ConversionError::Logarithm(Expression::from(argument).to_string());
        let upper = self.logarithm_of_term(argument.numerator()).ok_or_else(error)?;
        let lower = self.logarithm_of_term(argument.denominator()).ok_or_else(error)?;
        Ok((&upper - &lower).into())
    }

    fn logarithm_of_term(&self, polynomial: &Polynomial) -> Option<Polynomial> {
        let (monomial, coefficient) = self.positive_term(polynomial)?;
        let constant = match *coefficient == 1 {
            true => Polynomial::zero(),
            false => Polynomial::variable(&format!("ln({coefficient})")),
        };
        Some(monomial.factors().fold(constant, |sum, (name, exponent)| {
            let logarithm = Polynomial::variable(&format!("ln({name})"));
            &sum + &logarithm.scale(&Rational::from(*exponent))
        }))
    }

    /// The only term, when its coefficient and all its variables are positive.
    fn positive_term<'p>(&self, polynomial: &'p Polynomial) -> Option<(&'p Monomial, &'p Rational)> {
        let (monomial, coefficient) = polynomial.leading_term().filter(|_| polynomial.term_count() == 1)?;
        let positive =
            coefficient.is_positive() && monomial.factors().all(|(name, _)| self.domain.is_positive(name));
        positive.then_some((monomial, coefficient))
    }

    fn absolute(&self, argument: &RationalFunction) -> Result<RationalFunction, ConversionError> {
        match self.domain.sign_of(argument) {
            _ if argument.is_zero() => Ok(argument.clone()),
            Some(1) => Ok(argument.clone()),
            Some(_) => Ok(-argument.clone()),
            None => Err(ConversionError::OpenSign(Expression::from(argument).to_string())),
        }
    }

    fn root(&mut self, argument: &RationalFunction) -> RationalFunction {
        if argument.is_zero() {
            return argument.clone();
        }
        let roots = argument.numerator().square_root().zip(argument.denominator().square_root());
        if let Some(root) = roots.and_then(|(upper, lower)| RationalFunction::new(upper, lower)) {
            match self.domain.sign_of(&root) {
                Some(1) => return root,
                Some(_) => return -root,
                // Of two roots of unknown sign neither is the non-negative one: the root stays a variable.
                None => {}
            }
        }
        let name = format!("sqrt({})", Expression::from(argument));
        self.squares.insert(Symbol::new(&name), argument.clone());
        RationalFunction::variable(&name)
    }
}

fn opaque(function: Function, argument: &RationalFunction) -> RationalFunction {
    RationalFunction::variable(&format!("{}({})", function.as_str(), Expression::from(argument)))
}

/// The function with variable² = square used until the variable is gone from the denominator and at most linear above.
fn reduce_square(
    function: &RationalFunction,
    name: &Symbol,
    square: &RationalFunction,
) -> Option<RationalFunction> {
    if function.numerator().degree(name) == 0 && function.denominator().degree(name) == 0 {
        return Some(function.clone());
    }
    let (even, odd) = split_by_parity(function.numerator(), name, square);
    let (lower_even, lower_odd) = split_by_parity(function.denominator(), name, square);
    let root = RationalFunction::variable(name.as_str());
    // (e + o·w)/(f + g·w) = (e + o·w)(f − g·w)/(f² − g²·w²).
    let constant = &(&even * &lower_even) - &(&(&odd * &lower_odd) * square);
    let linear = &(&odd * &lower_even) - &(&even * &lower_odd);
    let norm = &(&lower_even * &lower_even) - &(&(&lower_odd * &lower_odd) * square);
    (&constant + &(&linear * &root)).checked_div(&norm)
}

fn split_by_parity(
    polynomial: &Polynomial,
    name: &Symbol,
    square: &RationalFunction,
) -> (RationalFunction, RationalFunction) {
    let mut sides = [RationalFunction::from(0), RationalFunction::from(0)];
    let mut power = RationalFunction::from(1);
    for (exponent, coefficient) in polynomial.coefficients(name).into_iter().enumerate() {
        sides[exponent % 2] = &sides[exponent % 2] + &(&RationalFunction::from(coefficient) * &power);
        if exponent % 2 == 1 {
            power = &power * square;
        }
    }
    let [even, odd] = sides;
    (even, odd)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Expression {
        text.parse().expect("in the grammar")
    }

    fn same(domain: &Domain, left: &str, right: &str) -> bool {
        domain.difference(&parse(left), &parse(right)).expect("rational").is_zero()
    }

    #[test]
    fn logarithms_of_products_fall_apart() {
        let domain = Domain::positive("x y");
        assert!(same(&domain, "ln(x^2/y)", "2*ln(x) - ln(y)"));
        assert!(domain.rational_function(&parse("ln(x + y)")).is_err());
        assert!(domain.rational_function(&parse("ln(z)")).is_err());
    }

    #[test]
    fn roots_of_squares_are_taken_and_others_keep_their_square() {
        let domain = Domain::positive("x y").with("a", parse("x^2"));
        assert!(same(&domain, "sqrt(4*a/y^2)", "2*x/y"));
        assert!(same(&domain, "sqrt(x + y)^2", "x + y"));
        assert!(same(&domain, "1/(1 + sqrt(x + y))", "(sqrt(x + y) - 1)/(x + y - 1)"));
        assert!(!same(&domain, "sqrt(x + y)", "x + y"));
    }

    #[test]
    fn absolute_values_need_a_decided_sign() {
        let less = Domain::positive("a d").with("b", parse("a + d"));
        assert!(same(&less, "abs(a - b)", "d"));
        assert!(Domain::positive("a b").rational_function(&parse("abs(a - b)")).is_err());
    }

    #[test]
    fn imaginary_unit_squares_to_minus_one() {
        assert!(same(&Domain::default(), "(±i*x)^2", "-x^2"));
    }

    #[test]
    fn identically_zero_denominators_are_refused() {
        assert!(Domain::default().rational_function(&parse("1/(x - x)")).is_err());
    }
}
