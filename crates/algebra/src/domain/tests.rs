//! What a domain assumes, what it refuses, and what its assumptions prove.

use super::*;

fn parse(text: &str) -> Expression {
    text.parse().expect("in the grammar")
}

fn condition(text: &str) -> Condition {
    Condition::try_from(text.to_owned()).expect("a condition")
}

/// Every kind of assumption at once: S is a root of 1 − C², b > 1, and p = α² with α = √p.
fn full() -> Domain {
    Domain::positive("a")
        .with_positive("b".into())
        .with_positive("p".into())
        .given(parse("b - 1"), Relation::Positive)
        .given(parse("d"), Relation::NonZero)
        .with_square("S", parse("1 - C^2"))
        .with("q", parse("g"))
        .with("p", parse("z"))
        .with("p", parse("alpha^2"))
        .parameter("alpha", parse("sqrt(p)"))
        .example("b", parse("2"))
        .example("d", parse("-3"))
        .example("C", parse("3/5"))
        .example("S", parse("4/5"))
}

#[test]
fn every_assumption_that_is_added_is_kept_and_named() {
    let domain = full();
    assert_eq!(
        domain.to_string(),
        "a, b, p > 0; b - 1 > 0; d != 0; S^2 = 1 - C^2; q = g; p = alpha^2; where alpha = sqrt(p); \
         possible at b = 2, d = -3, C = 3/5, S = 4/5"
    );
    let names: Vec<String> = domain.symbols().iter().map(|name| name.as_str().to_owned()).collect();
    assert_eq!(names, ["C", "S", "a", "alpha", "b", "d", "g", "p", "q"]);
    assert_eq!(domain.conditions(), [condition("b - 1 > 0"), condition("d != 0")]);
    assert_eq!(domain.squares(), [("S".into(), parse("1 - C^2"))]);
    assert_eq!(domain.parameters(), [("alpha".into(), parse("sqrt(p)"))]);
    assert_eq!(domain.substitutions(), [("q".into(), parse("g")), ("p".into(), parse("alpha^2"))]);
    assert_eq!(
        domain.original().to_string(),
        full().to_string().replace("; q = g; p = alpha^2; where alpha = sqrt(p)", "")
    );
    assert_eq!(domain.with_conditions(1).conditions(), [condition("b - 1 > 0")]);
    assert_eq!(
        domain.clone().without_example().to_string(),
        domain.to_string().split("; possible").next().unwrap()
    );
    assert_eq!(domain.check(), Ok(()));
}

#[test]
fn a_substitution_and_a_difference_are_computed() {
    let domain = full();
    for (text, value) in [("p + q", "alpha^2 + g"), ("a", "a")] {
        assert_eq!(domain.substituted(&parse(text)), parse(value));
        assert_eq!(domain.as_written(&parse(text)), parse(value));
    }
    assert!(domain.difference(&parse("p*S^2"), &parse("alpha^2*(1 - C^2)")).unwrap().is_zero());
    let difference = domain.difference(&parse("7*b"), &parse("3*b")).unwrap();
    assert_eq!(difference, domain.rational_function(&parse("4*b")).unwrap());
}

#[test]
fn a_name_has_the_part_that_the_domain_gives_it() {
    let domain = full();
    let named = |holds: &dyn Fn(&Symbol) -> bool| {
        let names = ["a", "b", "d", "C", "S", "p", "alpha", "q", "g", "free"];
        names.into_iter().filter(|name| holds(&Symbol::from(*name))).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(named(&|name| domain.is_positive(name)), "a b p alpha");
    assert_eq!(named(&|name| domain.is_assumed(name)), "a b d C S p");
    assert_eq!(named(&|name| domain.is_unbound(name)), "free");
    // b is in a condition, p is substituted and alpha is a parameter: none of them moves alone.
    assert_eq!(named(&|name| domain.leaves_free(name)), "a");
    let in_values = Domain::positive("a b c").with_square("S", parse("a")).parameter("g", parse("b"));
    let free = |name: &'static str| in_values.leaves_free(&name.into());
    assert!(!free("a") && !free("b") && free("c"));
}

#[test]
fn an_orthant_has_positive_variables_only() {
    assert!(Domain::positive("x y").is_orthant() && Domain::default().is_orthant());
    for more in [
        Domain::positive("x").given(parse("x - 1"), Relation::Positive),
        Domain::positive("x").with_square("S", parse("1 - C^2")),
        Domain::positive("x").with("y", parse("x")),
        Domain::positive("x").parameter("g", parse("x")),
    ] {
        assert!(!more.is_orthant(), "{more}");
    }
}

#[test]
fn a_condition_is_proved_only_where_it_holds_everywhere() {
    let domain = Domain::positive("x y").given(parse("y - x"), Relation::Positive);
    for text in ["x > 0", "y - x > 0", "x*y - x^2 >= 0", "(z - 1)^2 >= 0", "x - y != 0", "-1 - x != 0"] {
        assert_eq!(domain.proves(&condition(text)), Ok(true), "{text}");
    }
    for text in
        ["x - y > 0", "x - 1 > 0", "z^2 > 0", "x - 1 >= 0", "-x >= 0", "x - 1 != 0", "z != 0", "0 != 0"]
    {
        assert_eq!(domain.proves(&condition(text)), Ok(false), "{text}");
    }
    for text in ["1/z > 0", "ln(z) != 0"] {
        assert!(domain.proves(&condition(text)).is_err(), "{text}");
    }
    let signs = ["x + y", "x - y", "x - 1"].map(|text| domain.sign(&parse(text)));
    assert_eq!(signs, [Ok(Some(1)), Ok(Some(-1)), Ok(None)]);
}

#[test]
fn a_name_that_stands_for_two_things_is_refused() {
    let square = || Domain::positive("a").with_square("S", parse("1"));
    let named = |name: &str| Err(DomainError::Ambiguous(Symbol::read(name)));
    for (domain, name) in [
        (Domain::default().with("x", parse("y")).parameter("x", parse("1")), "x"),
        (Domain::default().parameter("g", parse("1")).parameter("g", parse("2")), "g"),
        (Domain::default().with("x", parse("y")).with("y", parse("2")), "y"),
        (Domain::positive("a").parameter("a", parse("1")), "a"),
        (square().with_positive("S".into()), "S"),
        (square().with("S", parse("1")), "S"),
        (Domain::default().with_square(Symbol::read("i"), parse("1")), "i"),
        (Domain::default().with_square(Symbol::read("pm"), parse("1")), "pm"),
        (Domain::of_positive([Symbol::read("i")]), "i"),
        (Domain::of_positive([Symbol::read("pm")]), "pm"),
    ] {
        assert_eq!(domain.check(), named(name), "{domain}");
    }
}

#[test]
fn assumptions_must_hold_at_the_example() {
    let given = |text: &str, value: &str| {
        let Condition { expression, relation } = condition(text);
        Domain::default().given(expression, relation).example("x", parse(value)).example("y", parse("9"))
    };
    let circle = |sine: &str| {
        let domain = Domain::default().with_square("S", parse("1 - C^2"));
        domain.example("C", parse("3/5")).example("S", parse(sine))
    };
    let positive = |value: &str| Domain::positive("a").example("a", parse(value));
    for domain in [
        given("x - 1 > 0", "2"),
        given("x >= 0", "0"),
        given("x >= 0", "1"),
        given("x != 0", "-1"),
        circle("4/5"),
        circle("-4/5"),
        positive("1/2"),
        Domain::positive("a"),
    ] {
        assert_eq!(domain.check(), Ok(()), "{domain}");
    }
    for (domain, refused) in [
        (given("x - 1 > 0", "1"), "x - 1 > 0"),
        (given("x >= 0", "-1"), "x >= 0"),
        (given("x != 0", "0"), "x != 0"),
        (circle("3/5"), "S^2 = 1 - C^2"),
        (circle("1"), "S^2 = 1 - C^2"),
        (positive("0"), "a > 0"),
        (positive("-1"), "a > 0"),
    ] {
        assert_eq!(domain.check(), Err(DomainError::Impossible(refused.to_owned())), "{domain}");
    }
}

#[test]
fn a_substitution_must_reach_every_point_of_the_assumptions() {
    let reached = |value: &str, parameter: &str| {
        let domain = Domain::positive("a b").given(parse("b - a"), Relation::Positive);
        let domain = domain.with("b", parse(value)).parameter("g", parse(parameter)).example("b", parse("2"));
        domain.check()
    };
    assert_eq!(reached("a + g", "b - a"), Ok(()));
    assert!(matches!(reached("a + 2*g", "b - a"), Err(DomainError::NotCovered { .. })));
    assert!(matches!(reached("a - g", "a - b"), Err(DomainError::Parameter { .. })));
    // A variable without an assumption is defined by its substitution.
    assert_eq!(Domain::positive("a").with("x", parse("a^2")).check(), Ok(()));
    let on_circle = Domain::default().with_square("S", parse("1 - C^2")).example("S", parse("1"));
    assert!(matches!(on_circle.with("C", parse("c^2")).check(), Err(DomainError::NotCovered { .. })));
}

#[test]
fn a_condition_with_an_irrational_number_holds_at_an_example() {
    let domain = |at: &str| {
        let condition = parse("x - sqrt(2)");
        Domain::positive("x").given(condition, Relation::Positive).example("x", parse(at)).check()
    };
    assert_eq!(domain("3/2"), Ok(()));
    assert!(matches!(domain("7/5"), Err(DomainError::Impossible(_))));
}
