//! Checking certificates: every fact is computed anew.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use rug::Rational;

use crate::refutation::CounterExample;
use crate::{Certificate, Domain, DomainError, End, Expression, RationalFunction, Series, Symbol, Toward};

/// Why a certificate does not hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Failure {
    pub remainder: String,
    /// Whether the fact is false; else it is not decided.
    pub is_false: bool,
    pub counter_example: Option<Box<CounterExample>>,
}

impl<E: Into<DomainError>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::remainder(error.into().to_string())
    }
}

impl Failure {
    fn remainder(remainder: impl Into<String>) -> Self {
        Self { remainder: remainder.into(), is_false: false, counter_example: None }
    }

    fn of_a_false_fact(remainder: String) -> Self {
        Self { is_false: true, ..Self::remainder(remainder) }
    }
}

impl Certificate {
    /// Computes the certificate's fact anew.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        if let Some(domain) = self.domain() {
            domain.check()?;
        }
        match self {
            Self::Identity { left, right, domain } => check_identity(left, right, domain),
            Self::Sign { expression, sign, domain } => check_sign(expression, *sign, domain),
            Self::Limit { expression, variable, toward, value, domain } => {
                check_end(expression, variable, *toward, &End::Finite(value.clone()), domain)
            }
            Self::Divergence { expression, variable, toward, sign, domain } => {
                check_end(expression, variable, *toward, &End::Infinite(*sign), domain)
            }
            Self::Derivative { expression, variable, value, domain } => {
                // What is differentiated has a value everywhere.
                domain.rational_function(expression)?;
                check_identity(&expression.derivative(variable), value, domain)
            }
            Self::Characteristic { system, variable, polynomial, domain } => {
                let identities = system.identities(variable, polynomial).map_err(Failure::remainder)?;
                identities.iter().try_for_each(|[left, right]| check_identity(left, right, domain))
            }
            Self::Difference { left, right, point, values } => {
                let left = check_value(left, point, &values[0])?;
                if left == check_value(right, point, &values[1])? {
                    return Err(Failure::of_a_false_fact(format!("both sides are {left} there")));
                }
                Ok(())
            }
            Self::Value { expression, point, value } => check_value(expression, point, value).map(|_| ()),
            Self::Series { relation, variable, unknown, coefficients, domain } => {
                check_series(relation, variable, unknown, coefficients, domain)
            }
            Self::Root { polynomial, variable, between, domain } => {
                check_root(polynomial, variable, between, domain)
            }
            Self::Connected { image, domain } => check_connected(image, domain),
            Self::Growth { expression, variable, order, domain } => {
                check_growth(expression, variable, *order, domain)
            }
        }
    }
}

/// Sides of different normal forms are the same or not: a point at which they differ decides it.
fn check_identity(left: &Expression, right: &Expression, domain: &Domain) -> Result<(), Failure> {
    // The difference is reduced as a whole, because a root may vanish only between the two sides.
    let difference = domain.difference(left, right)?;
    if difference.is_zero() {
        return Ok(());
    }
    let sides = [domain.rational_function(left)?, domain.rational_function(right)?];
    let remainder = Expression::from(&(&sides[0] - &sides[1])).to_string();
    match CounterExample::search(&sides, &difference, domain) {
        Some(found) => {
            Err(Failure { counter_example: Some(found.into()), ..Failure::of_a_false_fact(remainder) })
        }
        None => Err(Failure::remainder(format!("it is not decided whether {remainder} is zero"))),
    }
}

fn check_sign(expression: &Expression, sign: i8, domain: &Domain) -> Result<(), Failure> {
    let function = domain.rational_function(expression)?;
    let written = || Expression::from(&function);
    match domain.sign_of(&function) {
        Some(found) if found == sign => Ok(()),
        Some(found) => {
            Err(Failure::of_a_false_fact(format!("{} has the sign {found:+} everywhere", written())))
        }
        None => Err(Failure::remainder(format!("{} has no certified sign {sign:+}", written()))),
    }
}

fn check_end(
    expression: &Expression,
    variable: &Symbol,
    toward: Toward,
    stated: &End,
    domain: &Domain,
) -> Result<(), Failure> {
    match (domain.end(expression, variable, toward).map_err(Failure::remainder)?, stated) {
        (End::Finite(end), End::Finite(value)) => check_identity(&end, value, domain),
        (found, stated) if found == *stated => Ok(()),
        (found, _) => {
            Err(Failure::of_a_false_fact(format!("{expression} tends to {found} as {variable} -> {toward}")))
        }
    }
}

/// A function of the variable that stays opaque, such as exp(1/V), would count as a constant.
fn no_hidden(function: &RationalFunction, name: &Symbol) -> Result<(), Failure> {
    let hidden = function.hides(name);
    hidden.map_or(Ok(()), |hidden| Err(Failure::remainder(format!("{hidden} depends on {name}"))))
}

/// The number that the value comes to, if the expression has it at the point: one number can be written in several ways.
fn check_value(
    expression: &Expression,
    point: &[(Symbol, Expression)],
    value: &Expression,
) -> Result<Rational, Failure> {
    let values: BTreeMap<Symbol, Expression> = point.iter().cloned().collect();
    let numbers = point
        .iter()
        .filter_map(|(name, value)| Some((name.clone(), value.rational_value(&BTreeMap::new())?)));
    let domain = Domain::default();
    let stated = domain.rational_function(value)?;
    let there = expression.at_point(&numbers.collect()).substitute(&values);
    check_identity(&there, value, &domain)?;
    stated.as_constant().ok_or_else(|| Failure::remainder(format!("the value {value} is not a number")))
}

fn check_series(
    relation: &Expression,
    variable: &Symbol,
    unknown: &Symbol,
    coefficients: &[Expression],
    domain: &Domain,
) -> Result<(), Failure> {
    let relation = domain.rational_function(relation)?;
    let coefficients: Result<Vec<_>, _> =
        coefficients.iter().map(|value| domain.rational_function(value)).collect();
    let series = Series::new(coefficients?);
    no_hidden(&relation, variable)?;
    no_hidden(&relation, unknown)?;
    match series.residual(relation.numerator(), variable, unknown) {
        None => {
            Err(Failure::remainder(format!("the relation has no single root in {unknown} at {variable} = 0")))
        }
        Some(rest) if rest.is_zero() => Ok(()),
        Some(rest) => Err(Failure::remainder(Expression::from(&rest).to_string())),
    }
}

/// A polynomial is continuous: between two ends at which it has opposite signs it has a root.
fn check_root(
    polynomial: &Expression,
    name: &Symbol,
    between: &[Option<Expression>; 2],
    domain: &Domain,
) -> Result<(), Failure> {
    let function = domain.rational_function(polynomial)?;
    no_hidden(&function, name)?;
    if function.denominator().degree(name) > 0 || !domain.is_unbound(name) {
        return Err(Failure::remainder(format!("no polynomial in a {name} that may have any value")));
    }
    let degree = function.numerator().degree(name);
    let at_infinity = |below: bool| {
        let leading = function.numerator().coefficients(name).pop()?;
        let sign = domain.sign_of(&RationalFunction::new(leading, function.denominator().clone())?)?;
        Some(if below && degree % 2 == 1 { -sign } else { sign })
    };
    let at = |end: &Option<Expression>, below: bool| match end {
        Some(end) => domain.sign(&polynomial.with(name, end)),
        None => Ok(at_infinity(below)),
    };
    let [low, high] = between;
    let signs = [at(low, true)?, at(high, false)?];
    let ordered = match between {
        [Some(low), Some(high)] => domain.sign(&(high.clone() - low.clone()))? == Some(1),
        _ => true,
    };
    match signs {
        [Some(one), Some(other)] if one * other < 0 && ordered => Ok(()),
        _ => Err(Failure::remainder(format!("{polynomial} has no certified change of sign in {name}"))),
    }
}

/// An orthant is connected, and so is its image under continuous functions.
fn check_connected(image: &[(Symbol, Expression)], domain: &Domain) -> Result<(), Failure> {
    if !domain.is_orthant() {
        return Err(Failure::remainder("the variables have assumptions other than being positive"));
    }
    image.iter().try_for_each(|(_, coordinate)| {
        // A divisor that may be zero is refused here.
        domain.rational_function(coordinate)?;
        let free = coordinate.variables().into_iter().find(|name| !domain.is_positive(name));
        free.map_or(Ok(()), |name| Err(Failure::remainder(format!("{name} is not positive"))))
    })
}

/// What vanishes at 0 and has a positive slope is positive; so is what has such a slope and vanishes there, and so on. The order is the
/// stated one if the last slope is positive at 0, too.
fn check_growth(expression: &Expression, name: &Symbol, order: u32, domain: &Domain) -> Result<(), Failure> {
    if !domain.leaves_free(name) {
        return Err(Failure::remainder(format!("{name} is not free to be any positive number")));
    }
    let zero = Expression::integer(0);
    let mut derivative = expression.clone();
    for _ in 0..order {
        check_identity(&derivative.with(name, &zero), &zero, domain)?;
        derivative = derivative.derivative(name);
    }
    let at_zero = derivative.with(name, &zero);
    if domain.rational_function(&at_zero)?.is_zero() {
        let which = format!("derivative {order} of {expression} is zero at {name} = 0, too");
        return Err(Failure::of_a_false_fact(format!("{which}: the order is another one")));
    }
    check_sign(&derivative, 1, domain)?;
    check_sign(&at_zero, 1, domain)
}
