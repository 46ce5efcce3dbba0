//! Conversions have the values of what was written, and what has no value is refused.

use std::cmp::Ordering;

use proptest::prelude::*;

use super::*;

/// Terms of which the square or the sign is known under some of the conditions, and free ones.
const TERMS: [&str; 14] = [
    "1",
    "z",
    "z^2",
    "sqrt(x)",
    "sqrt(y)",
    "sqrt(x + y)",
    "sqrt(x - y)",
    "sqrt(x^2 + 1)",
    "sqrt(y + sqrt(x))",
    "sqrt(2)",
    "sin(z)",
    "exp(-x)",
    "ln(1 + x)",
    "asinh(y)",
];

/// A condition, and where it holds.
type Given = (&'static str, Relation, fn(Ordering) -> bool);

const CONDITIONS: [Given; 4] = [
    ("1", Relation::Positive, Ordering::is_gt),
    ("x - y", Relation::Positive, Ordering::is_gt),
    ("x - y", Relation::NonNegative, Ordering::is_ge),
    ("x - y", Relation::NonZero, Ordering::is_ne),
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// A decided sign is that of the value everywhere; what divides is never zero, and what has a root is never negative.
    #[test]
    fn decided_signs_are_those_of_values(
        factors in prop::collection::vec(-2_i32..3, 6),
        terms in prop::array::uniform2(0..TERMS.len()),
        condition in 0..CONDITIONS.len(),
        points in prop::collection::vec((1_u32..60, 1_u32..60, -9_i32..10), 6),
    ) {
        let parts = terms.iter().zip(factors.chunks(3)).map(|(term, factors)| {
            let [a, b, c] = factors[..] else { unreachable!() };
            format!("({a}*x + {b}*y + {c})*{}", TERMS[*term])
        });
        let text = parts.collect::<Vec<_>>().join(" + ");
        let (given, relation, holds) = CONDITIONS[condition];
        let (domain, expression) = (Domain::positive("x y").given(parse(given), relation), parse(&text));
        let points = points.iter().map(|(x, y, z)| {
            [("x", Rational::from((*x, 8))), ("y", Rational::from((*y, 8))), ("z", Rational::from((*z, 4)))]
                .map(|(name, value)| (Symbol::from(name), value)).into()
        });
        let points = points.filter(|point| parse(given).order_at(point).is_some_and(holds));
        // None: it may be zero without being rational.
        let orders: Vec<Option<Ordering>> = points.map(|point| expression.order_at(&point)).collect();
        let all = |holds: fn(Ordering) -> bool| orders.iter().all(|order| order.is_some_and(holds));
        if let Ok(Some(sign)) = domain.sign(&expression) {
            prop_assert!(all(if sign > 0 { Ordering::is_gt } else { Ordering::is_lt }), "{} has the sign {}", text, sign);
        }
        if domain.rational_function(&parse(&format!("1/({text})"))).is_ok() {
            prop_assert!(all(Ordering::is_ne), "1/({})", text);
        }
        if domain.rational_function(&parse(&format!("sqrt({text})"))).is_ok() {
            prop_assert!(orders.iter().all(|order| order.is_none_or(Ordering::is_ge)), "sqrt({})", text);
        }
    }
}

#[test]
fn signs_with_roots_are_decided_by_their_squares() {
    let domain = Domain::positive("x y");
    let sign = |text: &str| domain.sign(&parse(text)).ok().flatten();
    for (text, expected) in [
        ("x + 2 - sqrt(x)", Some(1)),
        ("sqrt(x) - x - 2", Some(-1)),
        ("sqrt(x^2 + 1) - x", Some(1)),
        ("x - sqrt(x^2 + 1)", Some(-1)),
        ("x - y + sqrt((x - y)^2 + x)", Some(1)),
        ("x - y - sqrt((x - y)^2 + x)", Some(-1)),
        ("x - y + sqrt((x - y)^2 - x + x^2 + 1/4)", None),
        // Zero: the two parts are of one size.
        ("sqrt(x^2 + 2*x + 1) - x - 1", None),
        ("sqrt((x - y)^2 + 4*x*y) - x - y", None),
        ("3*sqrt(2) - 4", Some(1)),
        ("-(z - x)^2 - y", Some(-1)),
        ("ln(x)", None),
        ("ln(1 + x)", Some(1)),
        ("1 - sqrt(x)", None),
        ("1 - 2*sin(x)", None),
        ("x - sqrt(x + y)", None),
    ] {
        assert_eq!(sign(text), expected, "{text}");
    }
    // The square of the inner root brings the outer one back: both signs follow from the conjugate.
    for (text, expected) in
        [("sqrt(x + y + sqrt(x)) - sqrt(x)", Some(1)), ("sqrt(x) - sqrt(x + y + sqrt(x))", Some(-1))]
    {
        assert_eq!(sign(text), expected, "{text}");
    }
    // What divides or multiplies without a known sign says nothing of the rest.
    let unknown = domain.clone().given(parse("x - y"), Relation::NonZero);
    for text in ["z/(x - y)", "z*(x - y)"] {
        let domain = unknown.clone().given(parse(text), Relation::Positive);
        assert_eq!(domain.sign(&parse("z")), Ok(None), "{text}");
    }
    for (text, has_value) in
        [("1/(x + 2 - sqrt(x))", true), ("1/(1 - sqrt(x))", false), ("1/(3*sqrt(2) - 4)", true)]
    {
        assert_eq!(domain.rational_function(&parse(text)).is_ok(), has_value, "{text}");
    }
}

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
    assert!(same(&domain, "ln(x*exp(-y/x)^2)", "ln(x) - 2*y/x"));
    assert!(domain.rational_function(&parse("ln(x - y)")).is_err());
    assert!(domain.rational_function(&parse("ln(z)")).is_err());
    let is_open = |text: &str| domain.rational_function(&parse(text)).is_err_and(|error| error.is_open());
    assert!(
        is_open("ln(x - y)") && is_open("abs(x - y)") && !is_open("1/(x - y)") && !is_open("sqrt(x - y)")
    );
}

#[test]
fn roots_of_squares_are_taken_and_others_keep_their_square() {
    let domain = Domain::positive("x y").with("a", parse("x^2"));
    assert!(same(&domain, "sqrt(4*a/y^2)", "2*x/y"));
    assert!(same(&domain, "sqrt(x + y)^2", "x + y"));
    let apart = domain.clone().given(parse("x + y - 1"), Relation::NonZero);
    assert!(same(&apart, "1/(1 + sqrt(x + y))", "(sqrt(x + y) - 1)/(x + y - 1)"));
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

/// exp(i π) + 1 is zero: what is said of exponentials, of roots and of even powers is said of real numbers.
#[test]
fn functions_of_imaginary_numbers_are_refused() {
    let domain = Domain::positive("x");
    for text in
        ["exp(i*x)", "1/(exp(i*x) + 1)", "cos(x + i)^2", "sin(exp(i))", "asinh(i/x)", "sqrt(2 + i)", "abs(i)"]
    {
        let found = domain.rational_function(&parse(text));
        assert!(matches!(found, Err(ConversionError::Imaginary(_))), "{text}: {found:?}");
    }
    assert!(same(&domain, "sqrt(-i^2*x^2) + (i*x)^2", "x - x^2"));
}

#[test]
fn identically_zero_denominators_are_refused() {
    assert!(Domain::default().rational_function(&parse("1/(x - x)")).is_err());
}

#[test]
fn a_divisor_must_be_proved_or_assumed_not_to_be_zero() {
    let free = Domain::positive("x y");
    let refused = |domain: &Domain, text: &str| domain.rational_function(&parse(text)).is_err();
    for text in [
        "1/(x - y)",
        "(x - y)/(x - y)",
        "(x - y)^-1",
        "(x - y)^0",
        "0/(x - y)",
        "0*(1/z)",
        "z/z",
        "1/(x + z)",
    ] {
        assert!(refused(&free, text), "{text}");
    }
    let apart = free.clone().given(parse("y - x"), Relation::NonZero);
    for text in ["1/(x - y)", "(x^2 - y^2)/(x - y)", "1/(x*y^2 - y^3)"] {
        assert!(!refused(&apart, text), "{text}");
    }
    for text in ["1/(z^2 + 1)", "1/(x*z^2 + x^2*w^4 + y)", "sqrt(z^2 + w^2)"] {
        assert!(!refused(&free, text), "{text}");
    }
    assert!(refused(&free, "1/(z^2 + w^2)") && refused(&free, "1/(z^3 + 1)"));
    for text in ["1/(x + y)", "1/(x + i*y)", "1/(1 + sqrt(x))", "x^0", "1/(2*x + pm*x)"] {
        assert!(!refused(&free, text), "{text}");
    }
    assert!(refused(&free, "1/(x + pm*x)") && refused(&free, "1/(sqrt(x)^2 - x)"));
}

#[test]
fn the_argument_of_a_root_must_not_be_negative() {
    let free = Domain::positive("x y");
    let refused = |domain: &Domain, text: &str| domain.rational_function(&parse(text)).is_err();
    for text in ["sqrt(1 - sin(z))", "sqrt(2 + cos(z)*sin(z))", "1/(2 + sin(z))"] {
        assert!(!refused(&free, text), "{text}");
    }
    for text in ["sqrt(x - y)", "sqrt(-x)", "sqrt(1 - z^2)", "sqrt(z)", "sqrt(sin(z))", "sqrt(1 - 2*sin(z))"]
    {
        assert!(refused(&free, text), "{text}");
    }
    let below = free.clone().given(parse("1 - z"), Relation::Positive);
    assert!(
        !refused(&below, "sqrt((y - sqrt(x + y^2))/(z - 1))")
            && !refused(&below, "sqrt((sin(w) - 1)/(z - 1))")
    );
    for text in ["sqrt((sqrt(x + y^2) - y)/(z - 1))", "sqrt((1 - sin(w))/(z - 1))", "sqrt(sqrt(x) - x - 1)"] {
        assert!(refused(&below, text), "{text}");
    }
    let above = free.clone().given(parse("x - y"), Relation::NonNegative);
    assert!(!refused(&above, "sqrt(x - y)") && !refused(&above, "sqrt((x - y)/y)"));
    // It may be zero: no division by its root.
    assert!(refused(&above, "1/sqrt(x - y)"));
    let less = free.given(parse("x - y"), Relation::Positive);
    assert!(!refused(&less, "1/sqrt(x - y)") && !refused(&less, "1/(sqrt(x) - sqrt(y))"));
}

#[test]
fn what_would_fill_the_memory_is_refused_before_it_is_multiplied_out() {
    let names = ["a", "b", "c", "d", "e", "f", "g", "h", "j", "k"].join(" + ");
    let bomb = format!("({names})^24");
    let error =
        Domain::default().rational_function(&parse(&format!("{bomb} - {bomb} + x"))).expect_err("a bomb");
    assert!(error.to_string().contains("allowed: 20000 terms, degree 256"), "{error}");
    assert!(Domain::default().rational_function(&parse("x^64*y^64*z^64*w^64*v^64")).is_err());
}
