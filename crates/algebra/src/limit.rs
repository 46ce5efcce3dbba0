//! Limits of expressions as one variable goes to zero or infinity, the others fixed.
//!
//! The limits of parts give that of the whole where they decide it. Where they do not, the whole is a quotient: a root in the numerator is
//! moved by its conjugate, or numerator and denominator are differentiated (l'Hôpital). That rule needs a denominator whose slope is not
//! zero near the end. Quotients, roots, logarithms and exponentials have that: their slopes are zero everywhere or nowhere near the end. So
//! have the sine and cosine of what tends to a finite value; those of what goes beyond all bounds are refused. A function of which nothing is
//! known may have any slope: it is refused in a denominator that is differentiated.

use std::cell::Cell;
use std::fmt;

use super::conversion::{Converter, norm, split_by_parity};
use super::{
    Condition, Domain, Expression, Function, Notation, Polynomial, RationalFunction, Relation, Symbol,
};

/// How often a quotient is differentiated, and how many parts are looked at.
const MOST_SLOPES: usize = 6;
const MOST_PARTS: usize = 400;

crate::named! {
    /// Which way a variable goes in a limit; the others are held fixed.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    pub enum Toward {
        /// Down to zero.
        #[default]
        Zero = "0",
        /// Up to infinity.
        Infinity = "infinity",
    }
}

/// Where an expression goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum End {
    /// To this value.
    Finite(Expression),
    /// Beyond all bounds: +1 up, −1 down.
    Infinite(i8),
}

impl fmt::Display for End {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&Notation::Plain.end(self))
    }
}

impl Domain {
    /// Where an expression goes as a variable goes to an end, the others fixed.
    ///
    /// # Errors
    /// When the variable is not free to go there alone, or the rules do not decide it for all values of the others.
    pub fn end(&self, expression: &Expression, variable: &Symbol, toward: Toward) -> Result<End, String> {
        if !self.moves_alone(variable) {
            return Err(format!("{variable} is not free to move alone: an assumption contains it"));
        }
        let search = Search { domain: self, variable, toward, left: Cell::new(MOST_PARTS) };
        if let Some(open) = self.conditions().iter().find(|condition| !search.allows(condition)) {
            return Err(format!(
                "{variable} may not be free to go to {toward}: nothing says that {open} there"
            ));
        }
        let function = self.rational_function(expression).map_err(|error| error.to_string())?;
        let written = self.substituted(expression);
        let found = search.quotient(&function, MOST_SLOPES).or_else(|| search.end(&written, MOST_SLOPES));
        found.ok_or_else(|| format!("{} has no certified limit in {variable}", Expression::from(&function)))
    }
}

struct Search<'s> {
    domain: &'s Domain,
    variable: &'s Symbol,
    toward: Toward,
    left: Cell<usize>,
}

impl Search<'_> {
    /// The end of an expression from those of its parts.
    fn end(&self, expression: &Expression, slopes: usize) -> Option<End> {
        self.left.set(self.left.get().checked_sub(1)?);
        if !expression.variables().contains(self.variable) {
            return Some(End::Finite(expression.clone()));
        }
        let go = |part: &Expression| self.end(part, slopes);
        let direct = match expression {
            Expression::Number(_) => None,
            Expression::Variable(_) => Some(match self.toward {
                Toward::Zero => End::Finite(Expression::integer(0)),
                Toward::Infinity => End::Infinite(1),
            }),
            Expression::Negation(inner) => return go(inner).map(negated),
            Expression::Sum(parts) => {
                let ends: Option<Vec<End>> = parts.iter().map(go).collect();
                ends.and_then(sum)
            }
            Expression::Product(parts) => {
                let one = End::Finite(Expression::integer(1));
                parts.iter().try_fold(one, |product, part| self.product(product, go(part)?))
            }
            Expression::Quotient(above, below) => self.divided(go(above)?, below, slopes),
            Expression::Power(inner, exponent) => {
                let base = (**inner).clone();
                let one = End::Finite(Expression::integer(1));
                match exponent {
                    ..0 => self.divided(one, &base.power(-exponent), slopes),
                    _ => (0..*exponent).try_fold(one, |power, _| self.product(power, go(inner)?)),
                }
            }
            Expression::Call(function, inner) => return self.call(*function, go(inner)?),
            // A function of which is known that it is continuous everywhere.
            Expression::Generic(function, inner) => {
                return match go(inner)? {
                    End::Finite(inner) => {
                        Some(End::Finite(Expression::Generic(function.clone(), Box::new(inner))))
                    }
                    End::Infinite(_) => None,
                };
            }
        };
        direct.or_else(|| {
            let function = self.domain.rational_function(expression).ok()?;
            self.quotient(&function, slopes)
        })
    }

    fn sign(&self, expression: &Expression) -> Option<i8> {
        self.domain.sign(expression).ok()?
    }

    fn is_zero(&self, expression: &Expression) -> bool {
        self.domain.rational_function(expression).is_ok_and(|value| value.is_zero())
    }

    fn product(&self, one: End, other: End) -> Option<End> {
        match (one, other) {
            (End::Finite(one), End::Finite(other)) => Some(End::Finite(one * other)),
            (End::Infinite(one), End::Infinite(other)) => Some(End::Infinite(one * other)),
            (End::Infinite(infinite), End::Finite(finite))
            | (End::Finite(finite), End::Infinite(infinite)) => {
                Some(End::Infinite(infinite * self.sign(&finite)?))
            }
        }
    }

    /// The end of a quotient from that of its numerator. A denominator that goes to zero has a sign everywhere.
    fn divided(&self, above: End, below: &Expression, slopes: usize) -> Option<End> {
        match (above, self.end(below, slopes)?) {
            (End::Finite(_), End::Infinite(_)) => Some(End::Finite(Expression::integer(0))),
            (End::Infinite(_), End::Infinite(_)) => None,
            (End::Finite(above), End::Finite(end)) if !self.is_zero(&end) => {
                // Asked of 1/end: 0/end is 0 without a look at the end, which may be zero for some values.
                let inverse = Expression::integer(1) / end.clone();
                self.domain.rational_function(&inverse).is_ok().then(|| End::Finite(above / end))
            }
            (above, End::Finite(end)) => {
                let sign = if self.is_zero(&end) { self.sign(below)? } else { self.sign(&end)? };
                let above = match above {
                    End::Finite(above) => self.sign(&above)?,
                    End::Infinite(above) => above,
                };
                Some(End::Infinite(above * sign))
            }
        }
    }

    /// The end of a function, which is continuous where it is defined.
    fn call(&self, function: Function, inner: End) -> Option<End> {
        match (function, inner) {
            (Function::Exp, End::Infinite(-1)) => Some(End::Finite(Expression::integer(0))),
            (Function::Ln | Function::Sqrt, End::Infinite(-1))
            | (Function::Sin | Function::Cos, End::Infinite(_)) => None,
            (Function::Abs, End::Infinite(_)) => Some(End::Infinite(1)),
            (_, End::Infinite(sign)) => Some(End::Infinite(sign)),
            (Function::Ln, End::Finite(inner)) if self.is_zero(&inner) => Some(End::Infinite(-1)),
            (_, End::Finite(inner)) => {
                let value = inner.call(function);
                self.domain.rational_function(&value).is_ok().then_some(End::Finite(value))
            }
        }
    }

    /// The end of a quotient of polynomials in the variable and in functions of it.
    fn quotient(&self, function: &RationalFunction, slopes: usize) -> Option<End> {
        self.left.set(self.left.get().checked_sub(1)?);
        if function.hides(self.variable).is_none() {
            return self.of_powers(function);
        }
        let [above, below] = [function.numerator(), function.denominator()].map(Expression::from);
        self.by_conjugate(function, slopes)
            .or_else(|| self.by_slopes(&above, &below, slopes))
            .or_else(|| self.by_turned_factor(function, slopes))
    }

    /// Whether a condition that is met somewhere is met from some value of the variable on: the term that decides makes it true.
    fn allows(&self, condition: &Condition) -> bool {
        let Ok(function) = self.domain.rational_function(&condition.expression) else {
            return !condition.expression.contains(self.variable);
        };
        if !function.variables().contains(self.variable) {
            return true;
        }
        let sign = |polynomial| {
            let (_, term) = self.deciding(polynomial).filter(|_| function.hides(self.variable).is_none())?;
            self.domain.sign_of(&RationalFunction::from(term))
        };
        let sign = sign(function.numerator()).zip(sign(function.denominator()));
        sign.is_some_and(|(above, below)| above == below || condition.relation == Relation::NonZero)
    }

    /// The term that decides, as the power of the variable and its factor: of the lowest power as the variable goes to zero, of the
    /// highest one as it goes to infinity.
    fn deciding(&self, polynomial: &Polynomial) -> Option<(i64, Polynomial)> {
        let parts = polynomial.coefficients(self.variable).into_iter().zip(0_i64..);
        let mut parts = parts.filter(|(part, _)| !part.is_zero());
        let (part, power) = match self.toward {
            Toward::Zero => parts.next()?,
            Toward::Infinity => parts.last()?,
        };
        Some((power, part))
    }

    /// The end from the terms that decide.
    fn of_powers(&self, function: &RationalFunction) -> Option<End> {
        let (below, divisor) = self.deciding(function.denominator())?;
        let divisor = RationalFunction::from(divisor);
        let sign = self.domain.sign_of(&divisor)?;
        let Some((above, leading)) = self.deciding(function.numerator()) else {
            return Some(End::Finite(Expression::integer(0)));
        };
        let larger = if self.toward == Toward::Zero { below - above } else { above - below };
        match larger {
            ..0 => Some(End::Finite(Expression::integer(0))),
            0 => Some(End::Finite(Expression::from(&(&RationalFunction::from(leading) / &divisor)))),
            _ => Some(End::Infinite(sign * self.domain.sign_of(&RationalFunction::from(leading))?)),
        }
    }

    /// (e + o w)/d = (e² − o² w²)/((e − o w) d) for a root w in the numerator.
    fn by_conjugate(&self, function: &RationalFunction, slopes: usize) -> Option<End> {
        let converter = Converter::for_sign_of(self.domain, function);
        let numerator = function.numerator();
        let (name, square) = converter.squares.iter().find(|(name, _)| {
            name.argument_of(Function::Sqrt).is_some()
                && name.hides(self.variable)
                && numerator.degree(*name) > 0
        })?;
        let (even, odd) = split_by_parity(numerator, name, square);
        let norm = converter.without_squares(&norm(&even, &odd, square))?;
        let conjugate = &even - &(&odd * &RationalFunction::generator(name));
        let denominator = RationalFunction::from(function.denominator().clone());
        let [above, below, conjugate] = [&norm, &denominator, &conjugate].map(Expression::from);
        // Powers of the variable cancel without the root. The whole is not brought to its normal form, which would move the root up again.
        let cancelled = norm.checked_div(&denominator).and_then(|part| self.quotient(&part, slopes));
        cancelled
            .and_then(|end| self.divided(end, &conjugate, slopes))
            .or_else(|| self.divided(self.end(&above, slopes)?, &(conjugate * below), slopes))
    }

    /// Numerator and denominator both go to zero, or both beyond all bounds: the quotient of their slopes has the same end.
    fn by_slopes(&self, above: &Expression, below: &Expression, slopes: usize) -> Option<End> {
        let slopes = slopes.checked_sub(1).filter(|_| !below.has_function_of(self.variable))?;
        let ends = [self.end(above, slopes)?, self.end(below, slopes)?];
        let is_open = match &ends {
            [End::Finite(above), End::Finite(below)] => self.is_zero(above) && self.is_zero(below),
            [End::Infinite(_), End::Infinite(_)] => true,
            _ => false,
        };
        if !is_open {
            let [above, _] = ends;
            return self.divided(above, below, slopes);
        }
        let [above, below] = [above, below].map(|side| side.derivative(self.variable));
        self.end(&(above / below), slopes)
    }

    /// f g = g/(1/f) for a function g that is a factor and goes beyond all bounds.
    fn by_turned_factor(&self, function: &RationalFunction, slopes: usize) -> Option<End> {
        let numerator = function.numerator();
        numerator.generators().into_iter().filter(|name| name.hides(self.variable)).find_map(|name| {
            let rest = numerator.divide_exact(&Polynomial::generator(&name))?;
            let alone = Expression::from(&name);
            if rest.degree(&name) > 0 || !matches!(self.end(&alone, slopes)?, End::Infinite(_)) {
                return None;
            }
            let turned = Expression::from(function.denominator()) / Expression::from(&rest);
            self.by_slopes(&alone, &turned, slopes)
        })
    }
}

fn negated(end: End) -> End {
    match end {
        End::Finite(value) => End::Finite(-value),
        End::Infinite(sign) => End::Infinite(-sign),
    }
}

/// The end of a sum; none where some parts go up and others down without bound.
fn sum(ends: Vec<End>) -> Option<End> {
    let zero = End::Finite(Expression::integer(0));
    ends.into_iter().try_fold(zero, |sum, end| match (sum, end) {
        (End::Finite(sum), End::Finite(value)) => Some(End::Finite(sum + value)),
        (End::Infinite(one), End::Infinite(other)) => (one == other).then_some(End::Infinite(one)),
        (End::Infinite(sign), End::Finite(_)) | (End::Finite(_), End::Infinite(sign)) => {
            Some(End::Infinite(sign))
        }
    })
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use proptest::prelude::*;
    use rug::Rational;

    use super::*;
    use crate::number::{Ball, Field};

    /// What the parts of an expression are, and how four of them are joined.
    const PARTS: [&str; 30] = [
        "1",
        "a",
        "-b",
        "a - 2*b",
        "x",
        "-x^2",
        "a*x + b",
        "1/x",
        "x^-2",
        "sqrt(x)",
        "sqrt(x^2 + a)",
        "sqrt(a*x + b)",
        "exp(x)",
        "exp(-a*x)",
        "exp(-1/x)",
        "ln(x)",
        "ln(1 + a*x)",
        "asinh(b*x)",
        "sin(a/x)",
        "cos(b*x)",
        "sin(x/(1 + x))",
        "abs(-x)",
        "x/(x + a)",
        "exp(b/(1 + x))",
        "p",
        "p^2 + x",
        "(p - a)^2",
        "(p + b)^2*x",
        "1/(a - x)",
        "sqrt(x - b)",
    ];
    /// What is positive besides x, a and b.
    const GIVEN: [&str; 7] = ["a", "a - x", "b - a*x^2", "x - b", "a*x - p", "b - 1 - x", "x*(p + x)"];
    const JOINS: [&str; 7] = [
        "(u + v)/(w + z)",
        "u*v - w*z",
        "(u - v)*w/z",
        "u/v + w/z",
        "(u - v)/w^2 + z",
        "u^-2*v*(w - z)",
        "x*u/(x + (p - a)^2*v) + w/z",
    ];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(600))]

        /// The value comes nearer to an end that is decided, or grows on its side, between two points far out.
        #[test]
        fn values_go_where_the_end_is(
            parts in prop::array::uniform4(0..PARTS.len()),
            joined in 0..JOINS.len(),
            given in 0..GIVEN.len(),
            up in any::<bool>(),
            (a, b, p) in (1_i32..20, 1_i32..20, 0..4_usize),
        ) {
            // Three of four values of p are those at which a part vanishes.
            let p = [0, a, -b, 7][p];
            let toward = if up { Toward::Infinity } else { Toward::Zero };
            let parts = ["u", "v", "w", "z"].into_iter().zip(parts.map(|part| parse(PARTS[part])));
            let whole = parse(JOINS[joined]).replaced(&parts.map(|(name, part)| (name.into(), part)).collect());
            let value = |expression: &Expression, exponent: i64| {
                let x = Rational::from(1) << (if up { exponent } else { -exponent }) as i32;
                let at = [("x", x), ("a", Rational::from((a, 8))), ("b", Rational::from((b, 8))), ("p", Rational::from((p, 8)))];
                let at = at.map(|(name, value)| (name.into(), Ball::from_rational(&value, 400)));
                expression.enclosed(&at.into(), 400)
            };
            let is_below = |one: Ball, other: Ball| (one - other).sign() == Some(Ordering::Less);
            let given = parse(GIVEN[given]);
            let is_met = |exponent| value(&given, exponent).and_then(|value| value.sign()) == Some(Ordering::Greater);
            if ![12, 20].into_iter().all(is_met) {
                return Ok(());
            }
            let domain = Domain::positive("x a b").given(given, Relation::Positive);
            // A divisor may be zero at one of the points.
            let [Some(near), Some(far)] = [12, 20].map(|exponent| value(&whole, exponent)) else { return Ok(()) };
            let refuted = match domain.end(&whole, &"x".into(), toward) {
                Ok(End::Finite(end)) => {
                    let end = value(&end, 20).expect("all have numbers");
                    let [near, far] = [near, far].map(|one| (one - &end).square());
                    is_below(near.clone() * Ball::from(2) / Ball::from(3), far.clone()) && is_below(Ball::from(1) / Ball::from(1 << 20), far)
                }
                Ok(End::Infinite(sign)) => {
                    let [near, far] = [near, far].map(|one| one * Ball::from(i32::from(sign)));
                    is_below(far, near + Ball::from(1) / Ball::from(1 << 10))
                }
                Err(_) => false,
            };
            prop_assert!(!refuted, "{} does not go there as x -> {} where {}: {:?}", whole, toward, domain, domain.end(&whole, &"x".into(), toward));
        }
    }

    fn parse(text: &str) -> Expression {
        text.parse().expect("in the grammar")
    }

    fn end(text: &str, toward: Toward) -> Option<End> {
        let expression: Expression = text.parse().expect("in the grammar");
        Domain::positive("x a b").end(&expression, &"x".into(), toward).ok()
    }

    fn finite(text: &str, toward: Toward, value: &str) -> bool {
        let value: Expression = value.parse().expect("in the grammar");
        matches!(end(text, toward), Some(End::Finite(found))
            if Domain::positive("x a b").difference(&found, &value).expect("rational").is_zero())
    }

    #[test]
    fn a_condition_that_is_met_near_the_end_binds_nothing_and_another_one_is_named() {
        use Toward::{Infinity, Zero};
        for (given, text, toward, wanted) in [
            ("b - x", "(b - x)/a", Zero, Some("b/a")),
            ("b - x", "1/(b - x)", Zero, Some("1/b")),
            ("b - x^2", "x/(b - x^2)", Zero, Some("0")),
            ("x - a - b", "x/(x - a - b)", Infinity, Some("1")),
            ("1/x - a", "x", Zero, Some("0")),
            ("b - x", "1/x", Infinity, None),
            ("x - b", "x", Zero, None),
            ("a - b - x", "x", Zero, None),
            ("a - exp(x)", "x", Zero, None),
        ] {
            let domain = Domain::positive("x a b").given(parse(given), Relation::Positive);
            match (domain.end(&parse(text), &"x".into(), toward), wanted) {
                (Ok(End::Finite(end)), Some(wanted)) => {
                    assert!(
                        domain.difference(&end, &parse(wanted)).expect("rational").is_zero(),
                        "{text}: {end}"
                    );
                }
                (Err(why), None) => {
                    assert!(why.contains(&format!("nothing says that {} > 0 there", parse(given))), "{why}")
                }
                (found, _) => panic!("{given}: {text}: {found:?}"),
            }
        }
        let moved = Domain::positive("x a b").given(parse("a - b"), Relation::Positive);
        let moved = moved.given(parse("a - b - x"), Relation::Positive).end(&parse("x"), &"x".into(), Zero);
        assert_eq!(moved, Ok(End::Finite(Expression::integer(0))));
    }

    #[test]
    fn limits_that_every_textbook_has() {
        use Toward::{Infinity, Zero};
        for (text, toward, value) in [
            ("exp(-x)", Infinity, "0"),
            ("exp(-x)", Zero, "1"),
            ("sqrt(x^2 + a) - x", Infinity, "0"),
            ("x*exp(-x)", Infinity, "0"),
            ("x^3*exp(-x)", Infinity, "0"),
            ("(exp(a*x) - 1)/x", Zero, "a"),
            ("ln(1 + x)/x", Zero, "1"),
            ("x*ln(x)", Zero, "0"),
            ("ln(x)/x", Infinity, "0"),
            ("sqrt(x)/(1 + x)", Infinity, "0"),
            ("(a*x^2 + 1)/(b*x^2 + x)", Infinity, "a/b"),
            ("exp(-1/x)", Zero, "0"),
            ("asinh(x)/x", Zero, "1"),
            ("a + b*exp(-x/a)", Infinity, "a"),
            ("p/(1 + x)", Infinity, "0"),
            ("(1 - exp(-x))/(1 + exp(-x))", Infinity, "1"),
            ("sin(a)*x/(1 + x)", Infinity, "sin(a)"),
            ("sin(x)/x", Zero, "1"),
            ("(1 - cos(a*x))/x^2", Zero, "a^2/2"),
            ("(sqrt(a + x) - sqrt(a) - x/(2*sqrt(a)))/x^2", Zero, "-1/(8*a*sqrt(a))"),
            ("(sqrt(1 + x) - 1 - x/2 + x^2/8 - x^3/16)/x^4", Zero, "-5/128"),
            ("(exp(x)*sqrt(1 + x) - 1 - 3*x/2 - 7*x^2/8)/x^3", Zero, "17/48"),
        ] {
            assert!(finite(text, toward, value), "{text}: {:?}", end(text, toward));
        }
        for (text, toward, sign) in [
            ("x^2 + a", Infinity, 1),
            ("1/x", Zero, 1),
            ("ln(x)", Zero, -1),
            ("exp(x)/x^2", Infinity, 1),
            ("-a*x/(1 + ln(1 + x))", Infinity, -1),
            ("(a - 1/x)", Zero, -1),
        ] {
            assert_eq!(end(text, toward), Some(End::Infinite(sign)), "{text}");
        }
    }

    #[test]
    fn a_smooth_function_is_continuous_and_may_do_anything_far_away_or_in_a_divisor() {
        let end = |text: &str, toward| {
            let expression = Expression::try_from(text.to_owned()).expect("of a certificate");
            Domain::positive("x a").end(&expression, &"x".into(), toward).ok().map(|end| end.to_string())
        };
        for (text, value) in [
            ("f(x)", "f(0)"),
            ("f(a + x)*x", "0"),
            ("(f(x) - f(0))/x", "f'(0)"),
            ("(f(a + x) - f(a) - x*f'(a))/x^2", "1/2*f''(a)"),
        ] {
            assert_eq!(end(text, Toward::Zero).as_deref(), Some(value), "{text}");
        }
        for (text, toward) in [
            ("f(x)", Toward::Infinity),
            ("f(1/x)", Toward::Zero),
            ("f(x)/x", Toward::Infinity),
            ("x/(1 + f(x)^2)", Toward::Infinity),
            ("f(x)/(1 + f(x)^2)", Toward::Infinity),
            ("exp(-x)*f(x)", Toward::Infinity),
        ] {
            assert_eq!(end(text, toward), None, "{text}");
        }
    }

    #[test]
    fn what_has_no_limit_or_another_one_for_other_values_is_not_decided() {
        use Toward::{Infinity, Zero};
        for (text, toward) in [
            ("sin(x)", Infinity),
            ("sin(x)/x", Infinity),
            ("x*sin(1/x)", Zero),
            ("p*x", Infinity),
            ("exp(p*x)", Infinity),
            ("(a - b)/x", Zero),
            ("x/(a - b + x)", Infinity),
            ("x^2 - a*x^3*exp(p)", Zero),
            // 0 and 1: another end where p is q.
            ("x/(x + (p - q)^2)", Zero),
            ("x/(x + p^2 + q^2)", Zero),
            ("sqrt(x)/(sqrt(x) + (p - 1/7)^2)", Zero),
            ("exp(-x)/(exp(-x) + (p^2 - 2)^2)", Infinity),
            ("x*(p - q)/(x^2 + x*(p - q))", Zero),
        ] {
            let found = end(text, toward);
            let is_right = found.is_none()
                || text.starts_with("x/(a") && found == Some(End::Finite(Expression::integer(1)))
                || text.starts_with("x^2") && finite(text, toward, "0");
            assert!(is_right, "{text}: {found:?}");
        }
        assert!(Domain::positive("x").end(&"y".parse().expect("a name"), &"y".into(), Zero).is_err());
    }
}
