//! What counts as refuted: true steps never do, and false ones do with a point.

use super::*;
use crate::{Certificate, Proof, Relation, Toward};

fn parse(text: &str) -> Expression {
    Expression::try_from(text.to_owned()).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Whether a step holds, and whether it counts as false.
fn decided(certificate: Certificate) -> [bool; 2] {
    match Proof::new("p", "A step.").certify("s", &[], certificate) {
        Ok(_) => [true, false],
        Err(refutation) => [false, refutation.is_false],
    }
}

fn identity(sides: &str, domain: &Domain) -> [bool; 2] {
    let (left, right) = sides.split_once(" = ").expect("two sides");
    decided(Certificate::Identity { left: parse(left), right: parse(right), domain: domain.clone() })
}

/// Identities for x, y > 0. Some have normal forms that differ.
const TRUE: [&str; 42] = [
    "sqrt(x*y) = sqrt(x)*sqrt(y)",
    "sqrt(x/y) = sqrt(x)/sqrt(y)",
    "sqrt(4*x) = 2*sqrt(x)",
    "sqrt(8*x) = 2*sqrt(2*x)",
    "2*sqrt(x/4) = sqrt(x)",
    "sqrt(2*x)*sqrt(2*y) = 2*sqrt(x*y)",
    "sqrt(x^3) = x*sqrt(x)",
    "sqrt(x^2*y) = x*sqrt(y)",
    "sqrt(p^2*x) = sqrt(p^2)*sqrt(x)",
    "sqrt(1/x) = 1/sqrt(x)",
    "sqrt(p^4) = p^2",
    "sqrt(p^4 + 2*p^2 + 1) = p^2 + 1",
    "sqrt(x + 2*sqrt(x*y) + y) = sqrt(x) + sqrt(y)",
    "sqrt(3 + 2*sqrt(2)) = 1 + sqrt(2)",
    "sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)",
    "sqrt(12) = 2*sqrt(3)",
    "sqrt(2)*sqrt(3) = sqrt(6)",
    "sqrt(sqrt(x))^4 = x",
    "1/(sqrt(x + 1) + sqrt(x)) = sqrt(x + 1) - sqrt(x)",
    "ln(sqrt(x)) = ln(x)/2",
    "ln((x + y)^2) = 2*ln(x + y)",
    "ln(6) = ln(2) + ln(3)",
    "exp(p/2)^2 = exp(p)",
    "exp(ln(x)/2) = sqrt(x)",
    "exp(p - q)*exp(q) = exp(p)",
    "sqrt(exp(p)) = exp(p/2)",
    "sqrt(exp(2*p)) = exp(p)",
    "sin(2*p) = 2*sin(p)*cos(p)",
    "sin(3*p) = 3*sin(p) - 4*sin(p)^3",
    "cos(2*p) = cos(p)^2 - sin(p)^2",
    "cos(2*p) = 1 - 2*sin(p)^2",
    "sin(p + q) = sin(p)*cos(q) + cos(p)*sin(q)",
    "sin(p)^2 + cos(p)^2 = 1",
    "asinh(-p) = -asinh(p)",
    "asinh(p) = ln(p + sqrt(p^2 + 1))",
    "exp(asinh(p)) = p + sqrt(p^2 + 1)",
    "i*sqrt(x)*i*sqrt(y) = -sqrt(x*y)",
    "pm*sqrt(x*y)/pm = sqrt(x)*sqrt(y)",
    "f(sqrt(x)*sqrt(y)) = f(sqrt(x*y))",
    "abs(-x) = x",
    "(x + y)^2 = x^2 + 2*x*y + y^2",
    "x/(x + y) = 1 - y/(x + y)",
];

#[test]
fn a_true_step_never_counts_as_false_and_what_differs_a_little_does() {
    let domain = Domain::positive("x y t");
    let mut held = 0;
    for sides in TRUE {
        let (left, right) = sides.split_once(" = ").expect("two sides");
        let tends = |right: &str| {
            let (expression, value) = (parse(&format!("t + ({left})")), parse(right));
            let (variable, toward, domain) = (Symbol::read("t"), Toward::Zero, domain.clone());
            decided(Certificate::Limit { expression, variable, toward, value, domain })
        };
        let grows = |more: &str| {
            let expression = parse(&format!("t + ({left}) - ({right}) + {more}"));
            let (variable, domain) = (Symbol::read("t"), domain.clone());
            decided(Certificate::Growth { expression, variable, order: 1, domain })
        };
        held += usize::from(identity(sides, &domain)[0]);
        for [_, is_false] in [identity(sides, &domain), tends(right), grows("0")] {
            assert!(!is_false, "{sides}");
        }
        for wrong in [format!("{right} + 10^-30"), format!("{right} - x/10^20"), format!("1 + {right}")] {
            assert_eq!(identity(&format!("{left} = {wrong}"), &domain), [false, true], "{left} = {wrong}");
            assert!(!tends(&wrong)[0], "{left} -> {wrong}");
        }
        assert!(!grows("10^-30")[0], "{sides}");
    }
    assert!(held >= 12, "{held}");
}

#[test]
fn a_step_is_refuted_only_where_the_assumptions_hold() {
    let domain = |positive: &'static str, given: &[&str], example: &[(&'static str, &str)]| {
        let given = given.iter().fold(Domain::positive(positive), |domain, text| {
            let (text, relation) = match text.strip_suffix(" >= 0") {
                Some(text) => (text, Relation::NonNegative),
                None => (*text, Relation::Positive),
            };
            domain.given(parse(text), relation)
        });
        example.iter().fold(given, |domain, (name, value)| domain.example(*name, parse(value)))
    };
    let narrow = domain("x y", &["x - y", "y - x + 10^-6"], &[("x", "1 + 10^-7"), ("y", "1")]);
    assert_eq!(identity("x = y", &narrow), [false, true]);
    assert_eq!(identity("sqrt(x) = sqrt(y)", &narrow), [false, true]);
    let equal = domain("x y", &["-(x - y)^2 >= 0"], &[]);
    assert_eq!(identity("x = y", &equal), [false, false]);
    assert_eq!(identity("sqrt(x) = sqrt(y)", &equal), [false, false]);
    // A parameter has the value that the domain gives it: alpha > 1.
    let shifted = Domain::positive("a").with("a", parse("(alpha - 1)^2"));
    let shifted = shifted.parameter("alpha", parse("1 + sqrt(a)"));
    assert!(!identity("sqrt(a) = alpha - 1", &shifted)[1]);
    assert!(identity("sqrt(a) = alpha - 2", &shifted)[1]);
    // A half of the unit circle.
    let circle = domain("", &["-C"], &[("C", "-3/5"), ("S", "4/5")]).with_square("S", parse("1 - C^2"));
    assert_eq!(identity("S^2 + C^2 = 1", &circle), [true, false]);
    assert_eq!(identity("S = 1 + C", &circle), [false, true]);
    assert_eq!(identity("i*S = i*C", &circle), [false, true]);
}

#[test]
fn growth_has_the_stated_order() {
    let domain = Domain::positive("x y a");
    for (text, order, holds) in [
        ("x", 1, true),
        ("x^2", 2, true),
        ("a*x + x^2", 1, true),
        ("exp(x) - 1 - x", 2, true),
        ("sqrt(x)", 1, false),
        ("x^2", 1, false),
        ("x*sqrt(x)", 1, false),
        ("p^2*x + x^2", 1, false),
        ("(y - a)^2*x + x^2", 1, false),
        ("x^4 + y*x^2", 4, false),
        ("x^3*exp(x)", 2, false),
        ("x + x*(1/x)", 1, false),
    ] {
        let (expression, variable, domain) = (parse(text), Symbol::read("x"), domain.clone());
        let found = decided(Certificate::Growth { expression, variable, order, domain });
        assert_eq!(found[0], holds, "{text}, {order}");
    }
}
