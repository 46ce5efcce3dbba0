//! Random expressions are compared with their values as numbers.

use std::cmp::Ordering;

use proptest::prelude::*;
use rug::Float;

use super::*;
use crate::number::{Ball, Interval, nearest_f64};
use crate::{Comparison, Domain, Extent};
use crate::{Condition, Relation};

/// A value by the rules of arithmetic: exact until the first function, with rounding errors from there on.
#[derive(Debug, Clone)]
pub(crate) struct Value {
    near: f64,
    exact: Option<Rational>,
}

/// Why there is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gap {
    /// It does not exist.
    Undefined,
    /// Rounding errors hide whether it exists, or most of its digits.
    Unsure,
}

impl Value {
    fn exact(value: Rational) -> Self {
        Self { near: nearest_f64(&value), exact: Some(value) }
    }

    fn near(near: f64) -> Result<Self, Gap> {
        if near.abs() < 1e4 { Ok(Self { near, exact: None }) } else { Err(Gap::Unsure) }
    }

    fn order(&self) -> Result<Ordering, Gap> {
        match &self.exact {
            Some(value) => Ok(value.cmp0()),
            None if self.near.abs() < 1e-4 => Err(Gap::Unsure),
            None => Ok(self.near.total_cmp(&0.0)),
        }
    }

    fn combined(
        self,
        other: &Self,
        near: fn(f64, f64) -> f64,
        exact: fn(Rational, &Rational) -> Rational,
    ) -> Result<Self, Gap> {
        match (self.exact, &other.exact) {
            (Some(one), Some(other)) => Ok(Self::exact(exact(one, other))),
            _ => Self::near(near(self.near, other.near)),
        }
    }

    fn times(self, other: &Self) -> Result<Self, Gap> {
        self.combined(other, |one, other| one * other, |one, other| one * other)
    }

    pub fn is(&self, other: &Self) -> bool {
        match (&self.exact, &other.exact) {
            (Some(one), Some(other)) => one == other,
            _ => (self.near - other.near).abs() < 1e-5 * (1.0 + self.near.abs()),
        }
    }
}

pub(crate) type Point = BTreeMap<Symbol, Rational>;

/// The value at a point, where f(x) = 3 − 2x + 5x²/2.
pub(crate) fn value(expression: &Expression, point: &Point) -> Result<Value, Gap> {
    let go = |inner: &Expression| value(inner, point);
    let number = |numerator: i32| Value::exact(Rational::from((numerator, 2)));
    let sum =
        |one: Value, other: &Value| one.combined(other, |one, other| one + other, |one, other| one + other);
    let inverse = |inner: &Expression| {
        let below = go(inner)?;
        if below.order()?.is_eq() {
            return Err(Gap::Undefined);
        }
        number(2).combined(&below, |one, other| one / other, |one, other| one / other)
    };
    match expression {
        Expression::Number(value) => Ok(Value::exact(value.clone())),
        Expression::Variable(name) => point.get(name).cloned().map(Value::exact).ok_or(Gap::Undefined),
        Expression::Sum(parts) => parts.iter().try_fold(number(0), |total, part| sum(total, &go(part)?)),
        Expression::Product(parts) => {
            parts.iter().try_fold(number(2), |product, part| product.times(&go(part)?))
        }
        Expression::Quotient(above, below) => go(above)?.times(&inverse(below)?),
        Expression::Negation(inner) => number(-2).times(&go(inner)?),
        Expression::Power(inner, exponent) => {
            let base = if *exponent > 0 { go(inner)? } else { inverse(inner)? };
            let one = if base.exact.is_some() { number(2) } else { Value::near(1.0)? };
            (0..exponent.abs()).try_fold(one, |power, _| power.times(&base))
        }
        Expression::Generic(function, inner) => {
            let at = go(inner)?;
            let [a, b, c] =
                [[6, -4, 5], [-4, 10, 0], [10, 0, 0], [0, 0, 0]][function.derivative_order().min(3)];
            sum(number(a), &sum(number(b), &number(c).times(&at)?)?.times(&at)?)
        }
        Expression::Call(function, inner) => {
            let at = go(inner)?;
            match function {
                Function::Ln if at.order()?.is_le() => Err(Gap::Undefined),
                Function::Ln => Value::near(libm::log(at.near)),
                Function::Sqrt if at.order()?.is_lt() => Err(Gap::Undefined),
                Function::Sqrt => Value::near(at.near.sqrt()),
                Function::Abs => Value::near(at.near.abs()),
                Function::Exp => Value::near(libm::exp(at.near)),
                Function::Asinh => Value::near(libm::asinh(at.near)),
                Function::Sin => Value::near(libm::sin(at.near)),
                Function::Cos => Value::near(libm::cos(at.near)),
            }
        }
    }
}

/// Whether a condition holds at a point.
fn met(demand: &Condition, point: &Point) -> Result<bool, Gap> {
    let order = value(&demand.expression, point)?.order()?;
    Ok(match demand.relation {
        Relation::Positive => order.is_gt(),
        Relation::NonNegative => order.is_ge(),
        Relation::NonZero => order.is_ne(),
    })
}

/// What an expression may be made of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    Quotients,
    Functions,
}

pub(crate) fn expressions(of: Of) -> impl Strategy<Value = Expression> {
    let number = (-2_i32..4, 1_i32..3).prop_map(|value| Expression::Number(Rational::from(value)));
    let leaf = prop_oneof![number, prop::sample::select(vec!["x", "y"]).prop_map(Expression::variable)];
    leaf.prop_recursive(3, 12, 3, move |inner| {
        let parts = || prop::collection::vec(inner.clone(), 2..4);
        let boxed = || inner.clone().prop_map(Box::new);
        let call = prop::sample::select(Function::ALL.to_vec());
        let generic = prop::sample::select(vec!["f", "f'", "f''", "f'''"]);
        let functions = if of == Of::Functions { 2 } else { 0 };
        prop_oneof![
            2 => parts().prop_map(Expression::Sum),
            2 => parts().prop_map(Expression::Product),
            1 => (boxed(), boxed()).prop_map(|(above, below)| Expression::Quotient(above, below)),
            1 => boxed().prop_map(Expression::Negation),
            1 => (boxed(), -2..4).prop_map(|(base, exponent)| Expression::Power(base, exponent)),
            functions => (call, boxed()).prop_map(|(function, inner)| Expression::Call(function, inner)),
            functions => (generic, boxed()).prop_map(|(function, inner)| Expression::Generic(function.into(), inner)),
        ]
    })
}

pub(crate) fn points() -> impl Strategy<Value = Point> {
    ((-4_i32..7, 1_i32..3), (-4_i32..7, 1_i32..3)).prop_map(|(x, y)| {
        let function = [("f", 3), ("f'", -2), ("f''", 5)]
            .map(|(name, value)| (Symbol::at_zero(&name.into()), value.into()));
        [("x", x), ("y", y)]
            .map(|(name, value)| (name.into(), Rational::from(value)))
            .into_iter()
            .chain(function)
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn exact_values_enclosures_and_orders_are_those_of_arithmetic(
        expression in expressions(Of::Functions), point in points(), width in prop::sample::select(vec![0.0, 0.25, 3.0])
    ) {
        let (exact, order) = (expression.rational_value(&point), expression.order_at(&point));
        let own = |name: &Symbol, width: f64| point.get(name).map(|value| (nearest_f64(value), if name.as_str().len() == 1 { width } else { 0.0 }));
        let ball = |name: &Symbol| {
            own(name, width).map(|(centre, width)| Ball::new(Float::with_val(128, centre), Float::with_val(64, width)))
        };
        let interval = |name: &Symbol| own(name, width).map(|(centre, width)| Interval::about(centre, width));
        let (ball, interval) = (expression.enclosed_with(&ball, 128), expression.enclosed_with(&interval, 53));
        match value(&expression, &point) {
            Ok(wanted) => {
                let holds = |low: f64, high: f64| {
                    low - 1e-5 * (1.0 + low.abs()) <= wanted.near && wanted.near <= high + 1e-5 * (1.0 + high.abs())
                };
                prop_assert!(interval.is_none_or(|interval| holds(interval.low, interval.high)));
                prop_assert!(ball.as_ref().is_none_or(|ball| holds(ball.lower().to_f64(), ball.upper().to_f64())));
                prop_assert!(width > 0.0 || ball.is_some_and(|ball| ball.radius() < 1e-9));
                prop_assert!(exact.as_ref().is_none_or(|exact| wanted.is(&Value::exact(exact.clone()))));
                prop_assert!(exact.is_some() || wanted.exact.is_none());
                prop_assert!(order == wanted.order().ok() || wanted.exact.is_none() && wanted.near.abs() < 1e-4);
            }
            Err(Gap::Undefined) => prop_assert!(exact.is_none() && order.is_none() && interval.is_none() && (ball.is_none() || width > 0.0)),
            Err(Gap::Unsure) => {}
        }
    }

    #[test]
    fn derivatives_are_the_slopes_between_near_points(expression in expressions(Of::Functions), point in points()) {
        let x = Symbol::from("x");
        let derivative = expression.derivative(&x);
        let at = |step: i32| {
            let moved = point.iter().map(|(name, own)| (name.clone(), if *name == x { own + Rational::from((step, 1 << 20)) } else { own.clone() }));
            value(&expression, &moved.collect())
        };
        if let (Ok(after), Ok(before), Ok(found)) = (at(1), at(-1), value(&derivative, &point)) {
            let slope = (after.near - before.near) * f64::from(1 << 19);
            prop_assert!((slope - found.near).abs() < 1e-3 * (1.0 + slope.abs()), "{} for {}", derivative, expression);
        }
    }

    #[test]
    fn the_demands_of_an_expression_hold_exactly_where_it_has_a_value(expression in expressions(Of::Functions), point in points()) {
        let met: Vec<Result<bool, Gap>> = expression.demands().iter().map(|demand| met(demand, &point)).collect();
        match value(&expression, &point) {
            Ok(_) => prop_assert!(met.iter().all(|met| *met == Ok(true))),
            Err(Gap::Undefined) => prop_assert!(met.iter().any(|met| *met != Ok(true))),
            Err(Gap::Unsure) => {}
        }
        prop_assert!(!expression.is_total() || value(&expression, &point).err() != Some(Gap::Undefined));
        let is_positive = |name: &Symbol| point[name] > 0;
        if expression.is_positive_by_form(&is_positive) {
            prop_assert!(value(&expression, &point).map_or(true, |value| value.near > 0.0));
        }
    }

    #[test]
    fn a_text_is_read_as_it_is_written_and_demands_what_gives_it_a_value(expression in expressions(Of::Functions), point in points()) {
        let text = expression.to_string();
        let (read, demands) = Expression::read_in(&text, &["f".into()].into()).expect("in the grammar");
        let demands: Vec<Condition> = demands.into_iter().map(|demand| demand.condition).collect();
        match (value(&expression, &point), value(&read, &point)) {
            (Ok(wanted), Ok(found)) => prop_assert!(found.is(&wanted) && demands.iter().all(|demand| met(demand, &point) == Ok(true)), "{}", text),
            // A factor zero hides a part without value, which is demanded all the same.
            (Err(Gap::Undefined), _) => prop_assert!(demands.iter().any(|demand| met(demand, &point) != Ok(true)), "{}", text),
            (_, found) => prop_assert!(found.is_ok() || found.is_err_and(|gap| gap == Gap::Unsure), "{}", text),
        }
    }

    #[test]
    fn comparisons_hold_as_their_literals_do(left in -3_i32..4, right in -3_i32..4) {
        let orders = [left <= right, left >= right, left != right, left == right, left < right, left > right];
        for (comparison, holds) in Comparison::ALL.iter().zip(orders) {
            prop_assert_eq!(comparison.holds(left.cmp(&right)), holds);
            let literal = comparison.literal(Expression::integer(left), Expression::integer(right));
            prop_assert_eq!(literal.holds_at(&Point::new()), Some(holds));
            prop_assert_eq!(literal.negated().holds_at(&Point::new()), Some(!holds));
        }
    }

    #[test]
    fn arithmetic_with_expressions_is_that_of_their_values(
        one in expressions(Of::Functions), other in expressions(Of::Functions), exponent in -2..4, point in points()
    ) {
        let parts = [value(&one, &point), value(&other, &point)];
        let [a, b] = [&one, &other].map(|part| Box::new(part.clone()));
        for (simple, plain) in [
            (one.clone() + other.clone(), Expression::Sum(vec![one.clone(), other.clone()])),
            (one.clone() - other.clone(), Expression::Sum(vec![one.clone(), Expression::Negation(b.clone())])),
            (one.clone() * other.clone(), Expression::Product(vec![one.clone(), other.clone()])),
            (one.clone() / other.clone(), Expression::Quotient(a.clone(), b)),
            (-one.clone(), Expression::Negation(a.clone())),
            (one.clone().power(exponent), Expression::Power(a, exponent)),
        ] {
            // Zero times or over anything is written as zero.
            if let (Ok(wanted), [Ok(_), Ok(_)]) = (value(&plain, &point), &parts) {
                prop_assert!(value(&simple, &point).is_ok_and(|found| found.is(&wanted)), "{} for {}", simple, plain);
            }
        }
    }

    #[test]
    fn what_is_put_in_for_variables_has_its_value(
        expression in expressions(Of::Functions), x in expressions(Of::Quotients), point in points()
    ) {
        let replacement = BTreeMap::from([("x".into(), x.clone())]);
        let Ok(Value { exact: Some(at), .. }) = value(&x, &point) else { return Ok(()) };
        let moved = point.iter().map(|(name, own)| (name.clone(), if name.as_str() == "x" { at.clone() } else { own.clone() })).collect();
        let wanted = value(&expression, &moved);
        let same = |found: &Expression| match (&wanted, value(found, &point)) {
            (Ok(wanted), Ok(found)) => found.is(wanted),
            (Ok(_), found) | (Err(Gap::Undefined), found) => found.err() == wanted.as_ref().err().copied(),
            (Err(Gap::Unsure), _) => true,
        };
        prop_assert!(same(&expression.replaced(&replacement)));
        // What stays as it is may be left out of a product that is zero.
        let numbers = moved.iter().filter(|(name, _)| name.as_str().len() == 1).map(|(name, own)| (name.clone(), Expression::Number(own.clone())));
        let has_constant_gap = expression.demands().iter().any(|demand| demand.expression.variables().is_empty());
        if has_constant_gap || wanted.is_ok() {
            prop_assert!(wanted.is_err() || same(&expression.substitute(&replacement)) && same(&expression.with("x", &x)));
        } else {
            prop_assert!(same(&expression.substitute(&numbers.collect())));
        }
        // With all numbers put in, nothing is left but functions of numbers.
        let whole = expression.at_point(&point);
        let along = expression.along(&"x".into(), &point);
        let own = value(&expression, &point);
        for found in [&whole, &along] {
            if let (Ok(own), Ok(found)) = (&own, value(found, &point)) {
                prop_assert!(found.is(own));
            }
        }
        prop_assert!(whole.variables().is_empty());
    }

    #[test]
    fn names_roots_and_functions_are_those_of_the_text(expression in expressions(Of::Functions)) {
        let text = expression.to_string();
        let words: BTreeSet<&str> = text.split(|c: char| !c.is_alphanumeric() && c != '\'').collect();
        let functions: BTreeSet<Symbol> = words.iter().any(|word| word.starts_with('f')).then(|| "f".into()).into_iter().collect();
        let names: BTreeSet<Symbol> = ["x", "y"].into_iter().filter(|name| words.contains(name)).map(Symbol::from).collect();
        prop_assert_eq!(expression.calls(Function::Sqrt), words.contains("sqrt"));
        prop_assert_eq!(["x", "y"].map(Symbol::from).map(|name| expression.contains(&name) == names.contains(&name)), [true; 2]);
        prop_assert_eq!(expression.functions(), functions);
        prop_assert_eq!(expression.variables(), names);
    }

    /// Converted, written again and estimated.
    #[test]
    fn quotients_of_polynomials_have_the_values_and_extents_of_what_was_written(
        expression in expressions(Of::Quotients), point in points()
    ) {
        let domain = Domain::positive("x y");
        let Ok(function) = domain.rational_function(&expression) else { return Ok(()) };
        let written = Expression::from(&function);
        if let Ok(wanted) = value(&expression, &point)
            && let Ok(found) = value(&written, &point)
        {
            prop_assert!(found.is(&wanted), "{} for {}", written, expression);
            let [above, below] = [function.numerator(), function.denominator()].map(|side| side.evaluate(&point).expect("numbers"));
            prop_assert_eq!(Some(above / below), wanted.exact);
        }
        let sides = [function.numerator(), function.denominator()];
        let most = sides.map(Extent::of).into_iter().reduce(|one, other| Extent { terms: one.terms.max(other.terms), degree: one.degree.max(other.degree), bits: 1 << 40 }).expect("two");
        for less in [Extent { terms: most.terms - 1, ..most }, Extent { degree: most.degree.saturating_sub(1), ..most }] {
            prop_assert!(less == most || expression.check_extent(less).is_err(), "{:?} {}", less, expression);
        }
    }
}

fn parse(text: &str) -> Expression {
    Expression::try_from(text.to_owned()).expect("of a certificate")
}

#[test]
fn zeros_and_ones_are_simplified_where_nothing_without_value_is_lost() {
    let [zero, one, x] = [Expression::integer(0), Expression::integer(1), Expression::variable("x")];
    for gap in [zero.clone().power(0), zero.clone().power(-1), zero.clone() / zero.clone()] {
        assert_eq!(gap.rational_value(&Point::new()), None, "{gap}");
    }
    assert_eq!(
        [one.clone().power(-5), zero.clone().power(3), x.clone().power(0)],
        [one.clone(), zero.clone(), one]
    );
    assert_eq!([x.clone() * -x.clone(), zero.clone() / x.clone()], [-(x.clone() * x), zero]);
    for (text, replacements, expected) in [
        ("z/x", vec![("z", "0")], "0"),
        ("z/x", vec![("z", "0"), ("x", "y")], "0/y"),
        ("z/x", vec![("z", "0"), ("x", "-exp(y)^2")], "0"),
        ("z/x", vec![("z", "0"), ("x", "2*exp(y)")], "0"),
        ("z/x", vec![("x", "y")], "z/y"),
        ("z*ln(x)", vec![("z", "0")], "0"),
        ("z*ln(x)", vec![("z", "0"), ("x", "y")], "0*ln(y)"),
        ("z*x^2", vec![("z", "0"), ("x", "y")], "0"),
        ("1*x*ln(y)", vec![("x", "1"), ("y", "x")], "ln(x)"),
    ] {
        let values = replacements.into_iter().map(|(name, value)| (name.into(), parse(value))).collect();
        assert_eq!(parse(text).substitute(&values).to_string(), expected, "{text}");
    }
}

#[test]
fn roots_functions_and_positive_forms_are_seen() {
    assert!(parse("sqrt(x)/y").calls(Function::Sqrt) && parse("y/sqrt(x)").calls(Function::Sqrt));
    let [x, y] = ["x", "y"].map(Symbol::from);
    assert!(parse("f(x)*y").has_function_of(&x) && !parse("f(x)*y").has_function_of(&y));
    let is_positive = |text: &str| parse(text).is_positive_by_form(&|name| *name == x);
    assert!(is_positive("x/(x + 2)^2*sqrt(x) + 1"));
    assert!(["y", "-x", "0", "1/y", "x - 1"].iter().all(|text| !is_positive(text)));
}
