//! From expressions to rational functions.
//!
//! Signs are decided by the assumptions, by coefficients of one sign, by sums of squares, and by the conjugate of a root.

use std::collections::BTreeMap;

use rug::Rational;

use super::budget::{Memory, remembered, spend};
use super::squares::{Known, as_squares, is_imaginary};
use super::{
    Condition, ConversionError, Domain, Expression, Extent, Function, Generator, Monomial, Polynomial,
    RationalFunction, Relation, Symbol,
};

/// What a numerator or denominator may come to when it is multiplied out.
const LARGEST: Extent = Extent { terms: 20_000, degree: 256, bits: 1 << 20 };

/// What a converter knows of a domain: squares, and polynomials with the relation that a condition states.
type Assumptions = (BTreeMap<Generator, RationalFunction>, Vec<(Polynomial, Relation)>);

thread_local! {
    /// Searches and checks ask for the same functions and signs many times.
    static FUNCTIONS: Memory<(Domain, Expression), Result<RationalFunction, ConversionError>> = Memory::default();
    static SIGNS: Memory<(Domain, RationalFunction), Option<i8>> = Memory::default();
    static ASSUMPTIONS: Memory<Domain, Assumptions> = Memory::default();
}

impl Domain {
    /// The expression as a rational function, after the substitutions; i² = −1 and pm² = 1 are used.
    ///
    /// # Errors
    /// When the assumptions do not exclude that it divides by zero or takes the root of a negative number, when a logarithm
    /// or absolute value cannot be resolved under them, and when it is too large to be expanded.
    pub fn rational_function(&self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        let question = (self.clone().without_example(), expression.clone());
        FUNCTIONS.with(|known| {
            remembered(known, question, || Converter::new(self).convert(&self.as_written(expression)))
        })
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

    /// Do the assumptions prove this condition?
    ///
    /// # Errors
    /// When its expression divides by what may be zero, or cannot be converted for another reason.
    pub fn proves(&self, condition: &Condition) -> Result<bool, ConversionError> {
        let expression = condition.expression.clone();
        let refuted = |error: ConversionError| match error {
            ConversionError::PossibleZero(_)
            | ConversionError::PossibleNegative(_)
            | ConversionError::DivisionByZero(_) => Ok(false),
            other => Err(other),
        };
        self.rational_function(&expression)?;
        match condition.relation {
            Relation::Positive => Ok(self.sign(&expression)? == Some(1)),
            Relation::NonNegative => {
                self.rational_function(&expression.call(Function::Sqrt)).map_or_else(refuted, |_| Ok(true))
            }
            Relation::NonZero => {
                self.rational_function(&expression.power(-1)).map_or_else(refuted, |_| Ok(true))
            }
        }
    }

    pub(super) fn sign_of(&self, function: &RationalFunction) -> Option<i8> {
        let question = (self.clone().without_example(), function.clone());
        SIGNS.with(|known| {
            remembered(known, question, || Converter::for_sign_of(self, function).sign_of(function))
        })
    }
}

/// Converts expressions to rational functions and decides their signs, under the assumptions of a domain.
pub(super) struct Converter<'d> {
    domain: &'d Domain,
    pub(super) squares: BTreeMap<Generator, RationalFunction>,
    /// Polynomials of which a condition says that they are positive, not negative, or not zero.
    conditions: Vec<(Polynomial, Relation)>,
}

impl<'d> Converter<'d> {
    pub(super) fn new(domain: &'d Domain) -> Self {
        let question = domain.clone().without_example();
        let (squares, conditions) = ASSUMPTIONS.with(|known| {
            remembered(known, question, || {
                let Self { squares, conditions, .. } = Self::of_assumptions(domain);
                (squares, conditions)
            })
        });
        Self { domain, squares, conditions }
    }

    fn of_assumptions(domain: &'d Domain) -> Self {
        let imaginary = (Symbol::read("i").into(), RationalFunction::from(-1));
        let either_sign = (Symbol::read("pm").into(), RationalFunction::from(1));
        let squares = BTreeMap::from([imaginary, either_sign]);
        let mut converter = Self { domain, squares, conditions: Vec::new() };
        for (name, square) in domain.squares() {
            if let Ok(square) = converter.reduced(&domain.as_written(square)) {
                converter.squares.insert(name.clone().into(), square);
            }
        }
        // A condition that is no rational function is of no use here; the check of the domain refuses it.
        for condition in domain.conditions() {
            if let Ok(function) = converter.reduced(&domain.as_written(&condition.expression))
                && let Some(fact) = converter.fact(&function, condition.relation)
            {
                converter.conditions.push(fact);
            }
        }
        converter
    }

    /// A converter that knows the squares of the roots in a function that was converted before.
    pub(super) fn for_sign_of(domain: &'d Domain, function: &RationalFunction) -> Self {
        let mut converter = Self::new(domain);
        for name in function.generators() {
            let root = name.argument_of(Function::Sqrt);
            let square = root.and_then(|argument| converter.reduced(argument).ok());
            converter.squares.extend(square.map(|square| (name, square)));
        }
        converter
    }

    pub(super) fn convert(mut self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        self.reduced(expression)
    }

    pub(super) fn reduced(&mut self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        let function = self.function(expression)?;
        self.without_squares(&function).ok_or_else(|| ConversionError::DivisionByZero(expression.to_string()))
    }

    /// The function with every known square used.
    pub(super) fn without_squares(&self, function: &RationalFunction) -> Option<RationalFunction> {
        self.squares
            .iter()
            .try_fold(function.clone(), |reduced, (name, square)| reduce_square(&reduced, name, square))
    }

    fn function(&mut self, expression: &Expression) -> Result<RationalFunction, ConversionError> {
        spend(1);
        match expression {
            Expression::Number(value) => Ok(RationalFunction::constant(value.clone())),
            Expression::Variable(name) => Ok(RationalFunction::variable(name)),
            Expression::Sum(parts) => self.fold(parts, RationalFunction::from(0), sum),
            Expression::Product(parts) => self.fold(parts, RationalFunction::from(1), product),
            Expression::Negation(inner) => Ok(-self.function(inner)?),
            Expression::Quotient(left, right) => {
                let (left, right) = (self.function(left)?, self.function(right)?);
                product(&left, &self.reciprocal(&right, expression)?)
            }
            Expression::Power(inner, exponent) => {
                let inner = self.function(inner)?;
                let base = if *exponent <= 0 { self.reciprocal(&inner, expression)? } else { inner };
                power(&base, exponent.unsigned_abs())
            }
            Expression::Call(function, inner) => {
                let argument = self.function(inner)?;
                self.call(*function, &argument)
            }
            Expression::Generic(function, inner) => {
                let argument = self.reduced(inner)?;
                let is_real = !argument.generators().iter().any(is_imaginary);
                let argument = Expression::from(&argument);
                let value = || RationalFunction::generator(&Generator::generic(function, argument.clone()));
                is_real.then(value).ok_or_else(|| ConversionError::Imaginary(argument.to_string()))
            }
        }
    }

    fn fold(
        &mut self,
        parts: &[Expression],
        start: RationalFunction,
        combine: fn(&RationalFunction, &RationalFunction) -> Result<RationalFunction, ConversionError>,
    ) -> Result<RationalFunction, ConversionError> {
        parts.iter().try_fold(start, |total, part| combine(&total, &self.function(part)?))
    }

    /// 1/divisor, if the assumptions exclude that the divisor is zero.
    fn reciprocal(
        &self,
        divisor: &RationalFunction,
        place: &Expression,
    ) -> Result<RationalFunction, ConversionError> {
        let zero = || ConversionError::DivisionByZero(place.to_string());
        let reduced = self.without_squares(divisor).filter(|reduced| !reduced.is_zero()).ok_or_else(zero)?;
        if self.never_zero(reduced.numerator()) {
            RationalFunction::from(1).checked_div(divisor).ok_or_else(zero)
        } else {
            Err(ConversionError::PossibleZero(Expression::from(&reduced).to_string()))
        }
    }

    /// Do the assumptions exclude that this polynomial is zero? With w² = t known, (e + o·w)(e − o·w) = e² − o²·t decides.
    fn never_zero(&self, polynomial: &Polynomial) -> bool {
        let rest = self.factors(polynomial, |relation| relation != Relation::NonNegative).1;
        if self.coefficient_sign(&rest).is_some() {
            return true;
        }
        let known = self.squares.iter().find(|(name, _)| rest.degree(name) > 0);
        known.is_some_and(|(name, square)| {
            let (even, odd) = split_by_parity(&rest, name, square);
            let norm = self.without_squares(&norm(&even, &odd, square)).filter(|norm| !norm.is_zero());
            norm.is_some_and(|norm| norm.numerator().degree(name) == 0 && self.never_zero(norm.numerator()))
        })
    }

    /// +1 or −1 when the assumptions and coefficients of one sign decide the sign; `None` otherwise.
    pub(super) fn sign_of(&self, function: &RationalFunction) -> Option<i8> {
        Some(self.polynomial_sign(function.numerator())? * self.polynomial_sign(function.denominator())?)
    }

    fn polynomial_sign(&self, polynomial: &Polynomial) -> Option<i8> {
        let (_, rest) = self.factors(polynomial, |relation| relation == Relation::Positive);
        self.coefficient_sign(&rest).or_else(|| self.sign_with_root(&rest))
    }

    /// The sign of e + o·w with w² = t: that of e where e² − o²·t is positive, that of o where it is negative and w a square root; else
    /// from those of e − o·w and of the product.
    fn sign_with_root(&self, polynomial: &Polynomial) -> Option<i8> {
        let (name, square) = self.real_root(polynomial)?;
        let (even, odd) = split_by_parity(polynomial, name, square);
        let norm = self.without_squares(&norm(&even, &odd, square))?;
        let larger = match self.sign_of(&norm).filter(|_| !norm.generators().contains(name)) {
            Some(1) => self.sign_of(&even),
            Some(-1) if name.argument_of(Function::Sqrt).is_some() => self.sign_of(&odd),
            _ => None,
        };
        if larger.is_some() {
            return larger;
        }
        let conjugate = &even - &(&odd * &RationalFunction::generator(name));
        let signs = [conjugate.numerator(), conjugate.denominator()].map(|side| self.coefficient_sign(side));
        Some(signs[0]? * signs[1]? * self.sign_of(&norm)?)
    }

    /// A real generator of the polynomial whose square is known.
    pub(super) fn real_root(&self, polynomial: &Polynomial) -> Option<(&Generator, &RationalFunction)> {
        let is_real = |name: &Generator| matches!(name.function(), Some((Function::Sqrt | Function::Sin, _)));
        self.squares.iter().find(|(name, _)| is_real(name) && polynomial.degree(*name) > 0)
    }

    /// The sign that coefficients of one sign give a polynomial in variables that are not negative, one of its terms in positive ones,
    /// or the form of a sum of squares.
    fn coefficient_sign(&self, polynomial: &Polynomial) -> Option<i8> {
        let is_positive =
            |(monomial, _): (&Monomial, _)| monomial.factors().all(|(name, _)| self.is_positive(name));
        let sign = self.term_sign(polynomial).filter(|_| polynomial.terms().any(is_positive));
        sign.or_else(|| {
            self.sign_of_squares(polynomial).and_then(|(sign, is_strict)| is_strict.then_some(sign))
        })
    }

    /// The sign that a polynomial has unless it is zero.
    fn weak_sign(&self, polynomial: &Polynomial) -> Option<i8> {
        self.term_sign(polynomial).or_else(|| self.sign_of_squares(polynomial).map(|(sign, _)| sign))
    }

    /// The sign that all terms have unless they are zero. An even power is not negative.
    fn term_sign(&self, polynomial: &Polynomial) -> Option<i8> {
        let sign = polynomial.coefficient_sign()?;
        let mut factors = polynomial.terms().flat_map(|(monomial, _)| monomial.factors());
        factors.all(|(name, exponent)| exponent % 2 == 0 || self.is_not_negative(name)).then_some(sign)
    }

    /// The sign of a sum of squares or of its opposite, and whether it is never zero.
    fn sign_of_squares(&self, polynomial: &Polynomial) -> Option<(i8, bool)> {
        let known = Known {
            positive: &|name| self.is_positive(name),
            not_negative: &|name| self.is_not_negative(name),
        };
        let (_, leading) = polynomial.leading_term()?;
        match leading.is_positive() {
            true => as_squares(polynomial, &known).map(|is_strict| (1, is_strict)),
            false => as_squares(&-polynomial, &known).map(|is_strict| (-1, is_strict)),
        }
    }

    /// Is this positive or, as a condition says, not negative?
    pub(super) fn is_not_negative(&self, name: &Generator) -> bool {
        let says = |(known, relation): &(Polynomial, Relation)| {
            *relation != Relation::NonZero && *known == Polynomial::generator(name)
        };
        self.is_positive(name) || self.conditions.iter().any(says)
    }

    /// The factors of a polynomial that a usable condition speaks of, as often as they divide it, and what remains.
    pub(super) fn factors(
        &self,
        polynomial: &Polynomial,
        usable: fn(Relation) -> bool,
    ) -> (Vec<Polynomial>, Polynomial) {
        let (mut rest, mut factors) = (polynomial.clone(), Vec::new());
        for (factor, _) in self.conditions.iter().filter(|(_, relation)| usable(*relation)) {
            while let Some(quotient) = rest.divide_exact(factor).filter(|_| !rest.is_zero()) {
                factors.push(factor.clone());
                rest = quotient;
            }
        }
        (factors, rest)
    }

    /// The polynomial of which this condition says something, when it is of use.
    pub(super) fn core_of(&mut self, condition: &Condition) -> Option<Polynomial> {
        let function = self.reduced(&self.domain.as_written(&condition.expression)).ok()?;
        Some(self.fact(&function, condition.relation)?.0)
    }

    /// A condition as one on a polynomial without a factor of known sign: the numerator, if the denominator is positive.
    fn fact(&self, function: &RationalFunction, relation: Relation) -> Option<(Polynomial, Relation)> {
        let positive = self.polynomial_sign(function.denominator()) == Some(1);
        if !positive && relation != Relation::NonZero {
            return None;
        }
        let numerator = function.numerator();
        let shared = numerator.common_monomial()?;
        let positive = shared.factors().all(|(name, _)| self.is_positive(name));
        let shared = Polynomial::term(Rational::from(1), shared);
        let core = if positive { numerator.divide_exact(&shared)? } else { numerator.clone() };
        let usable: fn(Relation) -> bool = match relation {
            Relation::NonZero => |relation| relation != Relation::NonNegative,
            Relation::Positive | Relation::NonNegative => |relation| relation == Relation::Positive,
        };
        let (_, core) = self.factors(&core, usable);
        core.as_constant().is_none().then_some((core, relation))
    }

    /// Is this positive? A function of which nothing is known is where a condition says so. Values of the exponential are, and so is the root of something positive and the logarithm of what is above 1.
    pub(super) fn is_positive(&self, name: &Generator) -> bool {
        match name.function() {
            None => match name.symbol() {
                Some(symbol) => self.domain.is_positive(&symbol),
                None => self.conditions.contains(&(Polynomial::generator(name), Relation::Positive)),
            },
            Some((Function::Exp, _)) => true,
            Some((Function::Sqrt | Function::Asinh, argument)) => self.is_positive_expression(argument),
            Some((Function::Ln, argument)) => {
                self.is_positive_expression(&(argument.clone() - Expression::integer(1)))
            }
            Some(_) => false,
        }
    }

    pub(super) fn copy(&self) -> Self {
        Self { domain: self.domain, squares: self.squares.clone(), conditions: self.conditions.clone() }
    }

    fn is_positive_expression(&self, expression: &Expression) -> bool {
        let mut inner = self.copy();
        inner.reduced(expression).is_ok_and(|function| inner.sign_of(&function) == Some(1))
    }

    /// Do the assumptions exclude that the function is negative?
    pub(super) fn never_negative(&self, function: &RationalFunction) -> bool {
        let (_, rest) = self.factors(function.numerator(), |relation| relation != Relation::NonZero);
        let Some(lower) = self.polynomial_sign(function.denominator()) else { return false };
        let signed =
            |polynomial: &Polynomial| self.weak_sign(polynomial).is_some_and(|upper| upper * lower > 0);
        signed(&rest) || self.never_negative_with_root(&rest, lower)
    }

    /// The same of e + o·w with w² = t, from e and e² − o²·t, or from the sign of e − o·w and that of their product.
    fn never_negative_with_root(&self, polynomial: &Polynomial, divisor: i8) -> bool {
        let Some((name, square)) = self.real_root(polynomial) else { return false };
        let (even, odd) = split_by_parity(polynomial, name, square);
        let norm = self.without_squares(&norm(&even, &odd, square));
        let Some(norm) = norm.filter(|norm| !norm.generators().contains(name)) else { return false };
        // |e| >= |o·w|, and e has the sign of the divisor or is zero; or the other way round with a square root w.
        let upward = |part: &RationalFunction| if divisor > 0 { part.clone() } else { -part.clone() };
        let is_root = name.argument_of(Function::Sqrt).is_some();
        let is_larger = |norm: &RationalFunction, part: &RationalFunction| {
            self.never_negative(norm) && self.never_negative(&upward(part))
        };
        if is_larger(&norm, &even) || is_root && is_larger(&-norm.clone(), &odd) {
            return true;
        }
        let Some(sign) = self.sign_of(&(&even - &(&odd * &RationalFunction::generator(name)))) else {
            return false;
        };
        // A conjugate of the other sign than the divisor's turns the sign of the product.
        let norm = if sign * divisor > 0 { norm } else { -norm };
        self.never_negative(&norm)
    }
}

/// left + right, unless it is too large.
fn sum(left: &RationalFunction, right: &RationalFunction) -> Result<RationalFunction, ConversionError> {
    Ok(left.checked_sum(right, |extent| extent.within(LARGEST))?)
}

/// left·right, unless it is too large.
fn product(left: &RationalFunction, right: &RationalFunction) -> Result<RationalFunction, ConversionError> {
    Extent::of_product(left.numerator(), right.numerator()).within(LARGEST)?;
    Extent::of_product(left.denominator(), right.denominator()).within(LARGEST)?;
    Ok(left * right)
}

/// base^exponent, unless it is too large.
fn power(base: &RationalFunction, exponent: u32) -> Result<RationalFunction, ConversionError> {
    Extent::of(base.numerator()).power(exponent).within(LARGEST)?;
    Extent::of(base.denominator()).power(exponent).within(LARGEST)?;
    Ok(base.pow(exponent))
}

/// The function with variable² = square used until the variable is gone from the denominator and at most linear above.
fn reduce_square(
    function: &RationalFunction,
    name: &Generator,
    square: &RationalFunction,
) -> Option<RationalFunction> {
    if function.numerator().degree(name) == 0 && function.denominator().degree(name) == 0 {
        return Some(function.clone());
    }
    let (even, odd) = split_by_parity(function.numerator(), name, square);
    let (lower_even, lower_odd) = split_by_parity(function.denominator(), name, square);
    let root = RationalFunction::generator(name);
    // (e + o·w)/(f + g·w) = (e + o·w)(f − g·w)/(f² − g²·w²).
    let constant = &(&even * &lower_even) - &(&(&odd * &lower_odd) * square);
    let linear = &(&odd * &lower_even) - &(&even * &lower_odd);
    (&constant + &(&linear * &root)).checked_div(&norm(&lower_even, &lower_odd, square))
}

pub(super) fn split_by_parity(
    polynomial: &Polynomial,
    name: &Generator,
    square: &RationalFunction,
) -> (RationalFunction, RationalFunction) {
    let (mut even, mut odd) = (RationalFunction::from(0), RationalFunction::from(0));
    let mut power = RationalFunction::from(1);
    for (exponent, coefficient) in polynomial.coefficients(name).into_iter().enumerate() {
        let term = &RationalFunction::from(coefficient) * &power;
        if exponent % 2 == 0 {
            even = even + term;
        } else {
            (odd, power) = (odd + term, &power * square);
        }
    }
    (even, odd)
}

/// e² − o²·t, which is (e + o·w)(e − o·w) with w² = t.
pub(super) fn norm(
    even: &RationalFunction,
    odd: &RationalFunction,
    square: &RationalFunction,
) -> RationalFunction {
    &(even * even) - &(&(odd * odd) * square)
}

#[cfg(test)]
mod tests;
