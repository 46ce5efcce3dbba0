//! The value of an expression at given numbers: exact where it is rational, or enclosed.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Add;

use super::division::square_root_of;
use super::enclosure::Enclosure;
use super::{Expression, Function, Generator, Symbol};
use crate::number::{Ball, Field, Interval, Rational};

/// Bits of the numbers in which a value that is not rational is enclosed, in turn.
const PRECISIONS: [u32; 2] = [96, 512];

impl Expression {
    /// The exact value with these numbers for the variables; none when a variable has no number, when the value does not exist, and
    /// when a step of it is not rational.
    #[must_use]
    pub fn rational_value(&self, values: &BTreeMap<Symbol, Rational>) -> Option<Rational> {
        let go = |inner: &Self| inner.rational_value(values);
        Some(match self {
            Self::Number(value) => value.clone(),
            Self::Variable(name) => values.get(name)?.clone(),
            Self::Sum(parts) => parts.iter().try_fold(Rational::new(), |sum, part| {
                Some(match part {
                    Self::Number(value) => sum + value,
                    Self::Variable(name) => sum + values.get(name)?,
                    Self::Negation(inner) => sum - go(inner)?,
                    _ => sum + go(part)?,
                })
            })?,
            Self::Product(parts) => parts.iter().try_fold(Rational::from(1), |product, part| {
                Some(match part {
                    Self::Number(value) => product * value,
                    Self::Variable(name) => product * values.get(name)?,
                    _ => product * go(part)?,
                })
            })?,
            Self::Quotient(left, right) => go(left)? / Some(go(right)?).filter(|below| !below.is_zero())?,
            Self::Negation(inner) => -go(inner)?,
            Self::Power(inner, exponent) => {
                let base = Some(go(inner)?).filter(|base| *exponent > 0 || !base.is_zero())?;
                rug::ops::Pow::pow(base, *exponent)
            }
            Self::Generic(function, inner) => {
                horner(&taylor(function, &|name| values.get(name).cloned()), &go(inner)?)?
            }
            Self::Call(Function::Abs, inner) => go(inner)?.abs(),
            Self::Call(Function::Sqrt, inner) => square_root_of(&go(inner)?)?,
            Self::Call(Function::Ln, inner) => {
                Some(Rational::new()).filter(|_| go(inner).is_some_and(|one| one == 1))?
            }
            Self::Call(Function::Asinh | Function::Sin, inner) => go(inner).filter(Rational::is_zero)?,
            Self::Call(Function::Exp | Function::Cos, inner) => {
                Some(Rational::from(1)).filter(|_| go(inner).is_some_and(|zero| zero.is_zero()))?
            }
        })
    }

    /// The expression with its value at these numbers in the place of each part without this variable.
    #[must_use]
    pub fn along(&self, variable: &Symbol, values: &BTreeMap<Symbol, Rational>) -> Self {
        if self.contains(variable) {
            return self.with_parts(&|part| part.along(variable, values));
        }
        self.rational_value(values).map_or_else(|| self.clone(), Self::Number)
    }

    /// How the value at these numbers compares with zero: exactly where it is rational, else enclosed; none where the value does not
    /// exist, and where it may be zero without being rational.
    #[must_use]
    pub fn order_at(&self, values: &BTreeMap<Symbol, Rational>) -> Option<Ordering> {
        // Most values are seen to be away from zero in 64 bits.
        let near = |name: &Symbol| values.get(name).map(Interval::enclosing);
        if let Some(order) = self.enclosed_with(&near, f64::MANTISSA_DIGITS).and_then(Interval::sign)
            && order.is_ne()
        {
            return Some(order);
        }
        if let Some(value) = self.rational_value(values) {
            return Some(value.cmp0());
        }
        let enclosed = |bits: u32| {
            let ball = |name: &Symbol| Some(Ball::from_rational(values.get(name)?, bits));
            self.enclosed_with(&ball, bits)?.sign()
        };
        PRECISIONS.into_iter().find_map(enclosed).filter(|order| order.is_ne())
    }

    /// The expression with the numbers of a point in the place of variables, and with its polynomials in the place of functions. A
    /// function of something that has a function of no known value stays as it is, so that nothing grows with each level.
    #[must_use]
    pub fn at_point(&self, point: &BTreeMap<Symbol, Rational>) -> Self {
        let numbers = point.iter().map(|(name, value)| (name.clone(), Self::Number(value.clone())));
        self.substitute(&numbers.collect()).with_polynomials(point)
    }

    /// The polynomial that a point gives for a function, in a variable or in something else; none where the point gives nothing for it.
    #[must_use]
    pub fn polynomial(function: &Symbol, inner: &Self, point: &BTreeMap<Symbol, Rational>) -> Option<Self> {
        let factors =
            Some(taylor(function, &|name| point.get(name).cloned())).filter(|factors| !factors.is_empty())?;
        let term = |(factor, power): (Rational, i32)| Self::Number(factor) * inner.clone().power(power);
        Some(factors.into_iter().zip(0..).map(term).fold(Self::integer(0), Add::add))
    }

    fn with_polynomials(&self, point: &BTreeMap<Symbol, Rational>) -> Self {
        let inside = || self.with_parts(&|part| part.with_polynomials(point));
        let Self::Generic(function, inner) = self else { return inside() };
        if let Some(value) = self.rational_value(point) {
            return Self::Number(value);
        }
        // A constant function would hide that its argument may have no value.
        let is_plain = inner.is_total() && inner.functions().is_empty();
        let polynomial = || Self::polynomial(function, inner, point).unwrap_or_else(|| self.clone());
        if is_plain { polynomial() } else { inside() }
    }

    /// The value with these numbers for the variables; none when a variable has no number, and where there may be no value.
    #[must_use]
    pub fn enclosed<N: Enclosure>(&self, values: &BTreeMap<Symbol, N>, precision_bits: u32) -> Option<N> {
        self.enclosed_with(&|name| values.get(name).cloned(), precision_bits)
    }

    /// The same with a function that gives the numbers.
    #[must_use]
    pub fn enclosed_with<N: Enclosure>(
        &self,
        value_of: &impl Fn(&Symbol) -> Option<N>,
        precision_bits: u32,
    ) -> Option<N> {
        let go = |inner: &Self| inner.enclosed_with(value_of, precision_bits);
        let number = |value: &Rational| N::of_rational(value, precision_bits);
        Some(match self {
            Self::Number(value) => number(value),
            Self::Variable(name) => value_of(name)?,
            Self::Sum(parts) => {
                let Some((first, others)) = parts.split_first() else {
                    return Some(number(&Rational::new()));
                };
                others.iter().map(go).try_fold(go(first)?, |sum, part| Some(sum + part?))?
            }
            Self::Product(parts) => {
                let Some((first, others)) = parts.split_first() else {
                    return Some(number(&Rational::from(1)));
                };
                others.iter().map(go).try_fold(go(first)?, |product, part| Some(product * part?))?
            }
            Self::Quotient(left, right) => go(left)?.over(&go(right)?)?,
            Self::Negation(inner) => -go(inner)?,
            Self::Power(inner, exponent) => {
                let (base, one) = (go(inner)?, number(&Rational::from(1)));
                let power = (0..exponent.unsigned_abs()).fold(one.clone(), |product, _| product * &base);
                match *exponent {
                    1.. => power,
                    0 => one.over(&base).map(|_| power)?,
                    _ => one.over(&power)?,
                }
            }
            Self::Generic(function, inner) => horner(&taylor(function, value_of), &go(inner)?)?,
            Self::Call(function, inner) => go(inner)?.call(*function)?,
        })
    }
}

/// The most different arguments of one function for which a point gives it independent values.
const MOST_ARGUMENTS: usize = 8;

/// What a point gives values to: the variables of these expressions, and of each function in them of which nothing is known the values
/// at 0 of it and of its derivatives. There are enough of them for independent values of all that occurs.
#[must_use]
pub fn unknowns<'e>(expressions: impl IntoIterator<Item = &'e Expression>) -> BTreeSet<Symbol> {
    let (mut found, mut calls) = (BTreeSet::new(), BTreeSet::new());
    for expression in expressions {
        found.extend(expression.variables());
        expression.add_generics(&mut calls);
    }
    let mut counts: BTreeMap<Symbol, (usize, usize)> = BTreeMap::new();
    for function in calls.iter().filter_map(Generator::generic_function) {
        let (highest, arguments) = counts.entry(function.undifferentiated()).or_default();
        *highest = function.derivative_order().max(*highest);
        *arguments += 1;
    }
    for (mut function, (highest, arguments)) in counts {
        for _ in 0..(highest + 2).max(arguments.min(MOST_ARGUMENTS)) {
            found.insert(Symbol::at_zero(&function));
            function = function.time_derivative();
        }
    }
    found
}

/// The coefficients, by ascending power, of the polynomial that a point gives for a function: f(0), f′(0), f″(0)/2, …; none where the
/// point gives nothing for it.
fn taylor<N: Field>(function: &Symbol, value_of: &impl Fn(&Symbol) -> Option<N>) -> Vec<N> {
    let (mut found, mut function, mut factorial) = (Vec::new(), function.clone(), N::from(1));
    while let Some(value) = value_of(&Symbol::at_zero(&function)) {
        found.push(value / &factorial);
        factorial = factorial * N::from(i32::try_from(found.len()).unwrap_or(i32::MAX));
        function = function.time_derivative();
    }
    let is_past_the_last =
        found.is_empty() && value_of(&Symbol::at_zero(&function.undifferentiated())).is_some();
    found.extend(is_past_the_last.then(|| N::from(0)));
    found
}

/// The value at x of the polynomial with these coefficients; none without coefficients.
fn horner<N: Field>(coefficients: &[N], x: &N) -> Option<N> {
    coefficients.iter().rev().cloned().reduce(|value, coefficient| value * x + coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Option<Ball> {
        let numbers = [("x", 3), ("y", -4)];
        let values = numbers
            .map(|(name, value)| (Symbol::from(name), Ball::from_rational(&Rational::from(value), 128)));
        text.parse::<Expression>().unwrap().enclosed(&values.into(), 128)
    }

    #[test]
    fn values_are_those_of_arithmetic() {
        for (text, expected) in
            [("2*x - y/2", (8, 1)), ("sqrt(x^2 + y^2)", (5, 1)), ("1/abs(y)^2 + 1/16", (1, 8))]
        {
            let found = value(text).unwrap();
            assert!(found.contains(&Rational::from(expected)), "{text}");
            assert!(found.relative_radius_log2() < -100.0, "{text}");
        }
    }

    #[test]
    fn rational_values_are_exact_or_none() {
        let values = [("x", (2, 3)), ("y", (-4, 1)), ("z", (0, 1))];
        let values = values.map(|(name, value)| (Symbol::from(name), Rational::from(value))).into();
        let at = |text: &str| text.parse::<Expression>().unwrap().rational_value(&values);
        for (text, expected) in [
            ("3*x*y", (-8, 1)),
            ("x - y/x + 1", (23, 3)),
            ("-x^-2", (-9, 4)),
            ("z^2 + x^0", (1, 1)),
            ("sqrt(x^2/y^2)", (1, 6)),
            ("abs(y)*ln(x - y - 11/3) + asinh(z) + sin(z)", (0, 1)),
            ("exp(z) + 2*cos(z*x)", (3, 1)),
        ] {
            assert_eq!(at(text), Some(Rational::from(expected)), "{text}");
        }
        for text in
            ["x/z", "z^0", "z^-1", "sqrt(x)", "sqrt(x^2*3)", "ln(x)", "exp(x)", "cos(x)", "sin(x)", "w"]
        {
            assert_eq!(at(text), None, "{text}");
        }
    }

    #[test]
    fn values_that_are_not_rational_are_compared_with_zero_by_enclosures() {
        let order = |text: &str| {
            let values =
                [("x", 2), ("y", -4)].map(|(name, value)| (Symbol::from(name), Rational::from(value)));
            text.parse::<Expression>().unwrap().order_at(&values.into())
        };
        assert_eq!(order("exp(x) - 7"), Some(Ordering::Greater));
        assert_eq!(order("sqrt(x) - 3/2"), Some(Ordering::Less));
        assert_eq!(order("x + y + 2"), Some(Ordering::Equal));
        // A zero that is not rational, a root and a logarithm of negative numbers, and an unknown name.
        for text in
            ["sqrt(x)^2 - x", "sqrt(y)", "0*ln(y)", "1/(x + y/2)", "exp(x)*z", "(x - 2)^0", "1/(x - 2)^2 + 1"]
        {
            assert_eq!(order(text), None, "{text}");
        }
    }

    fn certified(text: &str) -> Expression {
        Expression::try_from(text.to_owned()).expect("of a certificate")
    }

    /// f = 3 − 2x + 5x²/2, and x and y.
    fn point_with_function() -> BTreeMap<Symbol, Rational> {
        let values = [("f", 3), ("f'", -2), ("f''", 5)];
        let values = values.map(|(name, value)| (Symbol::at_zero(&name.into()), Rational::from(value)));
        let others = [("x", 2), ("y", 4)].map(|(name, value)| (Symbol::from(name), Rational::from(value)));
        values.into_iter().chain(others).collect()
    }

    #[test]
    fn a_function_is_the_polynomial_that_the_point_gives() {
        let point = point_with_function();
        for (text, expected) in [
            ("f(x)", 9),
            ("f'(x)", 8),
            ("f''(x)", 5),
            ("f'''(x)", 0),
            ("f''''''(x)", 0),
            ("f(sqrt(y)) - f(x)", 0),
            ("f(0) + f'(0) + f''(0)", 6),
        ] {
            assert_eq!(certified(text).rational_value(&point), Some(Rational::from(expected)), "{text}");
        }
        assert_eq!(certified("f(f(0))").rational_value(&point), Some(Rational::from((39, 2))));
        assert_eq!(certified("g(x)").rational_value(&point), None);
        assert_eq!(certified("f(sqrt(x)) - 4").order_at(&point), Some(Ordering::Greater));
        let shown = Expression::polynomial(&"f".into(), &Expression::variable("x"), &point);
        assert_eq!(shown.map(|shown| shown.to_string()).as_deref(), Some("3 - 2*x + 5/2*x^2"));
    }

    #[test]
    fn numbers_and_polynomials_of_a_point_are_put_in() {
        let mut point = point_with_function();
        point.remove(&Symbol::from("x"));
        for (text, expected) in [
            ("f(x) + f(y)", "3 - 2*x + 5/2*x^2 + 35"),
            ("f(x/y)", "3 - 2*(x/4) + 5/2*(x/4)^2"),
            ("f(1/x)", "f(1/x)"),
            ("f(f(x))", "f(3 - 2*x + 5/2*x^2)"),
            ("g(x*y)", "g(x*4)"),
        ] {
            assert_eq!(certified(text).at_point(&point).to_string(), expected, "{text}");
        }
        let mut nested = "x".to_owned();
        (0..30).for_each(|_| nested = format!("f({nested})"));
        assert!(certified(&nested).at_point(&point).to_string().len() < 1000);
    }

    #[test]
    fn a_point_has_free_values_for_all_that_occurs() {
        let names = |texts: &[&str]| {
            let all: Vec<Expression> = texts.iter().map(|text| certified(text)).collect();
            unknowns(&all).iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(names(&["x + y"]), "x y");
        assert_eq!(names(&["f'(V)/M"]), "M V f''(0) f'(0) f(0)");
        assert_eq!(
            names(&["f(x)*f(y)", "f(z) + f(2) + g(f(1))"]),
            "f''''(0) f'''(0) f''(0) f'(0) f(0) g'(0) g(0) x y z"
        );
    }

    #[test]
    fn what_has_no_number_has_no_value() {
        assert!(value("x + z").is_none() && value("ln(x)").is_some_and(|ball| ball.is_bounded()));
        for text in ["ln(y)", "ln(x - 3)", "1/(x - 3)", "sqrt(y)", "(x - 3)^0", "(x - 3)^-2", "0*ln(y)"] {
            assert!(value(text).is_none(), "{text}");
        }
    }

    #[test]
    fn logarithms_and_exponentials_enclose_their_values_and_are_inverse() {
        for (text, expected) in
            [("ln(exp(x))", 3), ("exp(ln(x))", 3), ("asinh((exp(x) - exp(-x))/2)", 3), ("exp(y + 4)", 1)]
        {
            let found = value(text).unwrap();
            assert!(
                found.contains(&Rational::from(expected)) && found.relative_radius_log2() < -100.0,
                "{text}"
            );
        }
        // ln 3 = 1.09861228866810969…
        let digits = value("ln(x)").unwrap();
        let exact = |text: &str| crate::number::parse_decimal(text).unwrap();
        assert!(digits.lower() > exact("1.0986122886681096") && digits.upper() < exact("1.0986122886681098"));
    }
}
