//! Functions of rational functions in a normal form: as far as it is known, each value is written in one way.
//!
//! A logarithm of a product is a sum, that of a number one over primes. An exponential of a sum is a product. Roots of squares are taken.
//! Whatever remains is a generator that keeps its argument, with the square of a root, and of a sine, known.

use rug::Rational;

use super::conversion::Converter;
use super::squares::is_imaginary;
use super::{ConversionError, Expression, Function, Generator, Monomial, Polynomial, RationalFunction};

/// The largest prime that is looked for in a number: what is left of the number counts as one.
const LARGEST_PRIME: u32 = 1000;

/// The largest power of an exponential: beyond, the factor stays in the argument.
const LARGEST_POWER: u32 = 16;

impl Converter<'_> {
    pub(super) fn call(
        &mut self,
        function: Function,
        argument: &RationalFunction,
    ) -> Result<RationalFunction, ConversionError> {
        let reduced = self.without_squares(argument);
        if reduced.is_none_or(|reduced| reduced.generators().iter().any(is_imaginary)) {
            return Err(ConversionError::Imaginary(Expression::from(argument).to_string()));
        }
        match function {
            Function::Ln => self.logarithm(argument),
            Function::Abs => self.absolute(argument),
            Function::Sqrt => self.root(argument),
            Function::Exp => self.exponential(argument),
            Function::Sin | Function::Cos => Ok(self.of_angle(function, argument)),
            Function::Asinh if argument.is_zero() => Ok(argument.clone()),
            Function::Asinh => Ok(opaque(function, argument)),
        }
    }

    fn logarithm(&mut self, argument: &RationalFunction) -> Result<RationalFunction, ConversionError> {
        let upper = self.logarithm_of_polynomial(argument.numerator(), argument)?;
        let lower = self.logarithm_of_polynomial(argument.denominator(), argument)?;
        Ok(upper - lower)
    }

    /// The logarithm of a product of positive factors, which falls apart; that of an exponential is its argument. A positive sum stays.
    fn logarithm_of_polynomial(
        &mut self,
        polynomial: &Polynomial,
        whole: &RationalFunction,
    ) -> Result<RationalFunction, ConversionError> {
        let error = || ConversionError::Logarithm(Expression::from(whole).to_string());
        let shared = polynomial.common_monomial().ok_or_else(error)?;
        let is_positive = shared.factors().all(|(name, _)| self.is_positive(name));
        let shared = if is_positive { shared } else { Monomial::one() };
        let factor = Polynomial::term(Rational::from(1), shared.clone());
        let core = polynomial.divide_exact(&factor).ok_or_else(error)?;
        let primitive = core.with_integers();
        let content = core.leading_term().zip(primitive.leading_term());
        let content = content.map(|((_, all), (_, own))| Rational::from(all / own)).ok_or_else(error)?;
        let (content, core) = match primitive.as_constant() {
            Some(number) => (content * number, None),
            None => (content, Some(RationalFunction::from(primitive))),
        };
        if content <= 0 || core.as_ref().is_some_and(|core| self.sign_of(core) != Some(1)) {
            return Err(error());
        }
        let core = core.map(|core| opaque(Function::Ln, &core));
        let start = logarithm_of_number(&content) + core.unwrap_or_else(|| RationalFunction::from(0));
        shared.factors().try_fold(start, |sum, (name, exponent)| {
            let logarithm = match name.argument_of(Function::Exp) {
                Some(argument) => self.reduced(argument)?,
                None => RationalFunction::generator(&Generator::call(Function::Ln, Expression::from(name))),
            };
            Ok(sum + logarithm * RationalFunction::constant(Rational::from(*exponent)))
        })
    }

    /// e^(n t/d) = (e^(t/d))^n for each term of the argument; e^(n ln x) = x^n.
    fn exponential(&mut self, argument: &RationalFunction) -> Result<RationalFunction, ConversionError> {
        let below = argument.denominator();
        let mut product = RationalFunction::from(1);
        for (monomial, coefficient) in argument.numerator().terms() {
            let (power, divisor) = coefficient.clone().into_numer_denom();
            let power = power.to_i32().filter(|power| power.unsigned_abs() <= LARGEST_POWER);
            let (power, unit) = match power {
                Some(power) => (power, Rational::from((1, divisor))),
                None => (1, coefficient.clone()),
            };
            let unit = Polynomial::term(unit, monomial.clone());
            let unit = RationalFunction::new(unit, below.clone());
            let unit =
                unit.ok_or_else(|| ConversionError::DivisionByZero(Expression::from(argument).to_string()))?;
            let base = match single(&unit).and_then(|name| name.argument_of(Function::Ln).cloned()) {
                Some(inside) => self.reduced(&inside)?,
                None => opaque(Function::Exp, &unit),
            };
            let raised = base.pow(power.unsigned_abs());
            product = if power < 0 { &product / &raised } else { &product * &raised };
        }
        Ok(product)
    }

    /// The sine or cosine of an angle, whose first term is written with a positive sign.
    fn of_angle(&mut self, function: Function, angle: &RationalFunction) -> RationalFunction {
        if angle.is_zero() {
            return RationalFunction::from(i32::from(function == Function::Cos));
        }
        let is_negative = angle.numerator().leading_term().is_some_and(|(_, leading)| leading.is_negative());
        let angle = if is_negative { -angle.clone() } else { angle.clone() };
        let value = opaque(function, &angle);
        if function == Function::Cos {
            return value;
        }
        let cosine = opaque(Function::Cos, &angle);
        let sine = Generator::call(Function::Sin, Expression::from(&angle));
        self.squares.insert(sine, RationalFunction::from(1) - cosine.pow(2));
        if is_negative { -value } else { value }
    }

    fn absolute(&self, argument: &RationalFunction) -> Result<RationalFunction, ConversionError> {
        match self.sign_of(argument) {
            sign if sign == Some(1) || argument.is_zero() => Ok(argument.clone()),
            Some(_) => Ok(-argument.clone()),
            None => Err(ConversionError::OpenSign(Expression::from(argument).to_string())),
        }
    }

    fn root(&mut self, argument: &RationalFunction) -> Result<RationalFunction, ConversionError> {
        let possible_negative = || ConversionError::PossibleNegative(Expression::from(argument).to_string());
        let argument = self.without_squares(argument).ok_or_else(possible_negative)?;
        if argument.is_zero() {
            return Ok(argument);
        }
        let roots = argument.numerator().square_root().zip(argument.denominator().square_root());
        let root = roots.and_then(|(upper, lower)| RationalFunction::new(upper, lower));
        if let Some((sign, root)) = root.and_then(|root| Some((self.sign_of(&root)?, root))) {
            return Ok(if sign > 0 { root } else { -root });
        }
        // Of two roots of unknown sign neither is the non-negative one: the root stays a variable.
        if !self.never_negative(&argument) {
            return Err(possible_negative());
        }
        match argument.as_constant() {
            Some(number) => Ok(self.root_of_number(&number)),
            None => Ok(self.opaque_root(argument)),
        }
    }

    fn opaque_root(&mut self, argument: RationalFunction) -> RationalFunction {
        let root = Generator::call(Function::Sqrt, Expression::from(&argument));
        let function = RationalFunction::generator(&root);
        self.squares.insert(root, argument);
        function
    }

    /// The root of a positive number as a product of roots of primes.
    fn root_of_number(&mut self, number: &Rational) -> RationalFunction {
        let (above, below) = number.clone().into_numer_denom();
        let start = RationalFunction::constant(Rational::from((1, below.clone())));
        primes(&Rational::from(above * below)).into_iter().fold(start, |product, (prime, exponent)| {
            let prime = RationalFunction::constant(prime);
            let whole = prime.pow(exponent.unsigned_abs() / 2);
            let product = &product * &whole;
            if exponent % 2 == 0 { product } else { &product * &self.opaque_root(prime) }
        })
    }
}

/// The generator, if the function is nothing else.
fn single(function: &RationalFunction) -> Option<&Generator> {
    let (monomial, coefficient) = function.numerator().leading_term()?;
    let mut factors = monomial.factors();
    let (name, exponent) = factors.next()?;
    let is_single = function.numerator().term_count() == 1
        && *coefficient == 1
        && *exponent == 1
        && factors.next().is_none()
        && function.denominator().as_constant().is_some_and(|below| below == 1);
    is_single.then_some(name)
}

/// The logarithm of a positive number over those of its primes.
fn logarithm_of_number(number: &Rational) -> RationalFunction {
    primes(number).into_iter().fold(RationalFunction::from(0), |sum, (prime, exponent)| {
        let logarithm = Generator::call(Function::Ln, Expression::Number(prime));
        sum + RationalFunction::constant(Rational::from(exponent)) * RationalFunction::generator(&logarithm)
    })
}

/// A positive number as a product of powers of primes, and of what is left of it without small ones.
fn primes(number: &Rational) -> Vec<(Rational, i32)> {
    let (mut above, mut below) = number.clone().into_numer_denom();
    let mut found = Vec::new();
    for prime in 2..=LARGEST_PRIME {
        if above == 1 && below == 1 {
            break;
        }
        if !above.is_divisible_u(prime) && !below.is_divisible_u(prime) {
            continue;
        }
        let (up, down) = (above.remove_factor_mut(&prime.into()), below.remove_factor_mut(&prime.into()));
        // What has a composite divisor had a prime one before.
        found.push((Rational::from(prime), up as i32 - down as i32));
    }
    let rest = [(above, 1), (below, -1)].into_iter().filter(|(left, _)| *left != 1);
    found.extend(rest.map(|(left, exponent)| (Rational::from(left), exponent)));
    found
}

fn opaque(function: Function, argument: &RationalFunction) -> RationalFunction {
    RationalFunction::generator(&Generator::call(function, Expression::from(argument)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::Ball;
    use crate::{Domain, Relation, Symbol};

    /// Terms in x and y > x > 0 with whole numbers in the places of N, M and K.
    const TERMS: [&str; 34] = [
        "ln(N/M*x^3)",
        "ln(N*x^2/(M*y) + N*x/M)",
        "ln(1009*N/(M*x*exp(K*y)))",
        "ln(N*x*y + M*x)",
        "ln(sqrt(N*x)/M)",
        "ln(N*x/1013)",
        "sqrt(N/1013)",
        "ln(y - x)",
        "exp(N*ln(x)/M)",
        "exp(-N*ln(x) + K*y/M)",
        "exp(ln(x)^2/M)",
        "exp(ln(x)/(M*y))",
        "exp(ln(x)*ln(y)*N)",
        "exp(y*ln(x))",
        "exp(N*ln(2)/M - 17*x)",
        "exp(20*ln(x + y))",
        "exp(K/M)",
        "sin(K*x - M*y)",
        "cos(K*x - M*y)",
        "sin(K*x - K*x)",
        "cos(K*x - K*x)",
        "sin(y - x)^2",
        "abs(K*x + K*y)",
        "abs(N*(x - y))",
        "abs(x - x)",
        "sqrt(N/M)",
        "sqrt(4*N*M)",
        "sqrt(1009*N/M^3)",
        "sqrt(N*x^2/M)",
        "sqrt((N*x - N*y)^2)",
        "sqrt((x + y)^2/M^2)",
        "sqrt(x + N*y)",
        "asinh(K*x)",
        "asinh(x - x)",
    ];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(600))]

        /// Whatever is written in its normal form has the same value as before.
        #[test]
        fn a_normal_form_has_the_value_of_what_was_written(
            terms in prop::array::uniform2(0..TERMS.len()),
            numbers in prop::array::uniform2((1_u32..40, 1_u32..40, -4_i32..5)),
            joined in 0..JOINS.len(),
            (x, above) in (1_u32..30, 1_u32..30),
        ) {
            let [u, v] = [0, 1].map(|index| written(TERMS[terms[index]], numbers[index]));
            let whole = parse(JOINS[joined]).replaced(&[("u".into(), u), ("v".into(), v)].into());
            if let Ok(function) = domain().rational_function(&whole) {
                let (x, y) = (Rational::from((x, 8)), Rational::from((x + above, 8)));
                let at = [("x", x), ("y", y)].map(|(name, value)| (name.into(), Ball::from_rational(&value, 200)));
                let value = |one: &Expression| one.enclosed(&at.clone().into(), 200).expect("all have numbers");
                let (before, after) = (value(&whole), value(&Expression::from(&function)));
                prop_assert!((before - after).contains_zero(), "{} became {}", whole, Expression::from(&function));
            }
        }
    }

    #[test]
    fn what_may_have_no_value_is_refused() {
        for term in TERMS {
            assert!(domain().rational_function(&written(term, (6, 35, -2))).is_ok(), "{term}");
        }
        for text in [
            "ln(-2)",
            "ln(0)",
            "ln(-2*x)",
            "ln(x - y)",
            "ln(x - 1)",
            "ln(p)",
            "sqrt(-2)",
            "sqrt(x - y)",
            "abs(p)",
        ] {
            assert!(domain().rational_function(&parse(text)).is_err(), "{text}");
        }
    }

    /// How two terms are joined.
    const JOINS: [&str; 5] = ["u + v", "u*v", "u^2 - v", "u/(1 + v^2)", "u^3*v^2"];

    fn domain() -> Domain {
        Domain::positive("x y").given(parse("y - x"), Relation::Positive)
    }

    fn written(term: &str, (n, m, k): (u32, u32, i32)) -> Expression {
        let text = term.replace('N', &n.to_string()).replace('M', &m.to_string());
        parse(&text.replace('K', &format!("({k})")))
    }

    fn parse(text: &str) -> Expression {
        text.parse().expect("in the grammar")
    }

    fn same(left: &str, right: &str) -> bool {
        Domain::positive("x y").difference(&parse(left), &parse(right)).expect("rational").is_zero()
    }

    #[test]
    fn a_function_of_which_nothing_is_known_is_equal_to_itself_only() {
        let domain = Domain::positive("x y");
        let certified = |text: &str| Expression::try_from(text.to_owned()).expect("of a certificate");
        let same = |left: &str, right: &str| {
            domain.difference(&certified(left), &certified(right)).expect("rational").is_zero()
        };
        for (left, right) in [
            ("f(2*x/2)", "f(x)"),
            ("f(sqrt(x)^2) - f(sqrt(x^2))", "0"),
            ("(f(x) + f(y))^2", "f(x)^2 + 2*f(x)*f(y) + f(y)^2"),
            ("f(f(x + y - y))", "f(f(x))"),
            ("f(1 + 1)", "f(2)"),
        ] {
            assert!(same(left, right), "{left} = {right}");
        }
        for (left, right) in [
            ("f(x)", "f(y)"),
            ("f(x)", "f(-x)"),
            ("f(x)", "f'(x)"),
            ("f(x)", "g(x)"),
            ("f(x + y)", "f(x) + f(y)"),
            ("f(2*x)", "2*f(x)"),
            ("f(0)", "0"),
            ("f(f(x))", "f(x)"),
            ("sqrt(f(x)^2)", "f(x)"),
        ] {
            assert!(!same(left, right), "{left} = {right}");
        }
        let refused = |text: &str| domain.rational_function(&certified(text)).is_err();
        assert!(refused("sqrt(f(x))") && refused("ln(f(x))") && refused("1/f(x)") && refused("f(1/(x - y))"));
        assert!(refused("f(i*x)") && !refused("f(pm*x)") && !refused("1/(1 + f(x)^2)"));
    }

    #[test]
    fn a_condition_on_a_function_holds_at_its_own_argument_only() {
        let certified = |text: &str| Expression::try_from(text.to_owned()).expect("of a certificate");
        let domain = Domain::positive("x y").given(certified("f'(x)"), Relation::Positive);
        let sign = |text: &str| domain.sign(&certified(text)).ok().flatten();
        assert_eq!(sign("x*f'(x) + y"), Some(1));
        assert_eq!(sign("-2*f'(x)/y"), Some(-1));
        for text in ["f'(y)", "f(x)", "f''(x)", "g'(x)", "f'(2*x)", "f'(x) - y"] {
            assert_eq!(sign(text), None, "{text}");
        }
        // The condition is possible at a function that the example states.
        assert!(domain.check().is_err());
        let values = [("f", "0"), ("f'", "1")];
        let possible = values.into_iter().fold(domain, |domain, (name, value)| {
            domain.example(Symbol::at_zero(&name.into()), value.parse().expect("a number"))
        });
        assert_eq!(possible.check(), Ok(()));
    }

    #[test]
    fn numbers_fall_apart_into_primes() {
        assert!(same("ln(2) + ln(3)", "ln(6)") && same("ln(12*x)", "2*ln(2) + ln(3) + ln(x)"));
        assert!(same("ln(3/500)", "ln(3) - 2*ln(2) - 3*ln(5)") && !same("ln(6)", "ln(5)"));
        assert!(same("sqrt(8)", "2*sqrt(2)") && same("sqrt(2)*sqrt(3)", "sqrt(6)"));
        assert!(same("sqrt(1/2)", "sqrt(2)/2") && same("sqrt(9/4)", "3/2"));
        // A large prime is left as it is, and so is a product of two.
        assert!(same("ln(1009*1013)", "ln(1022117)") && same("ln(2*1009)", "ln(2) + ln(1009)"));
    }

    #[test]
    fn exponentials_and_logarithms_of_sums() {
        assert!(same("exp(x + y)", "exp(x)*exp(y)") && same("exp(-x)", "1/exp(x)"));
        assert!(same("exp(2*ln(x) - y)", "x^2/exp(y)") && !same("exp(p/2)^2", "exp(p)"));
        assert!(same("ln(2*x + 2*x*y)", "ln(2) + ln(x) + ln(1 + y)"));
        assert!(same("exp(ln(x + y))", "x + y") && same("ln(exp(p))", "p"));
    }

    #[test]
    fn sine_and_cosine_know_their_squares_and_signs() {
        assert!(same("sin(p)^2 + cos(p)^2", "1") && same("sin(p - x)", "-sin(x - p)"));
        assert!(same("cos(-p)", "cos(p)") && same("sin(0) + cos(0)", "1"));
        assert!(same("sin(p)^4", "(1 - cos(p)^2)^2") && !same("sin(p)", "cos(p)"));
    }
}
