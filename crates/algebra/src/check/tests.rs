//! Certificates that a forger would write, and honest ones beside them.

use crate::Proof;

/// What the check says of a certificate as a file would state it.
fn checked(certificate: &str) -> Result<(), String> {
    let step = format!(r#"{{"says": "s", "equations": [], "certificate": {certificate}}}"#);
    let text = format!(r#"{{"id": "forged", "statement": "A forged proof.", "steps": [{step}]}}"#);
    let proof: Proof = serde_json::from_str(&text).expect("readable");
    proof.recheck().map_err(|refutation| refutation.remainder)
}

fn sign(expression: &str, domain: &str) -> Result<(), String> {
    checked(&format!(r#"{{"kind": "sign", "expression": "{expression}", "sign": 1, "domain": {domain}}}"#))
}

fn identity(left: &str, right: &str, domain: &str) -> Result<(), String> {
    checked(&format!(r#"{{"kind": "identity", "left": "{left}", "right": "{right}", "domain": {domain}}}"#))
}

#[test]
fn forged_sign_of_a_positive_variable_replaced_by_a_negative_one_is_refused() {
    let forged = r#"{"positive": ["T", "w"], "substitutions": [["T", "-w"]]}"#;
    let error = sign("-T", forged).expect_err("no positive T is −w");
    assert!(error.contains("T = -w proves its image only"), "{error}");
    let with_value = r#"{"positive": ["T"], "substitutions": [["T", "-w"]], "parameters": [["w", "-T"]]}"#;
    assert!(sign("-T", with_value).expect_err("−T < 0").contains("w = -T is not positive"));
    let honest = r#"{"positive": [], "given": ["-T > 0"], "substitutions": [["T", "-w"]],
        "parameters": [["w", "-T"]], "example": [["T", "-1"]]}"#;
    assert_eq!(sign("-T", honest), Ok(()));
    assert_eq!(sign("1 - T", honest), Ok(()));
}

#[test]
fn forged_identity_without_its_hypothesis_is_refused() {
    let free = r#"{"positive": ["y"], "substitutions": []}"#;
    for (left, right) in [
        ("x/x", "1"),
        ("(x - x)/(x - x)", "0"),
        ("0/x", "0"),
        ("0*(1/x)", "0"),
        ("x^0", "1"),
        ("0^0", "1"),
        ("(x - y)^-1*(x - y)", "1"),
        ("sqrt(1 - x^2)^2", "1 - x^2"),
        ("ln(x) - ln(x)", "0"),
        ("y + 0/0", "y"),
    ] {
        assert!(identity(left, right, free).is_err(), "{left} = {right}");
    }
    let stated = r#"{"positive": ["y"], "given": ["x != 0", "1 - x^2 >= 0"], "substitutions": [],
        "example": [["x", "1/2"]]}"#;
    assert_eq!(identity("x/x", "1", stated), Ok(()));
    assert_eq!(identity("sqrt(1 - x^2)^2", "1 - x^2", stated), Ok(()));
    assert!(identity("(x - x)/(x - x)", "0", stated).is_err());
    // A substitution does not remove the divisor it makes zero.
    let zero = r#"{"positive": ["y"], "substitutions": [["x", "0"]]}"#;
    assert!(identity("x/(x*y)", "0", zero).is_err());
}

#[test]
fn forged_substitution_that_misses_a_part_of_its_assumption_is_refused() {
    let missing = r#"{"positive": ["a", "b"], "given": ["b - a > 0"],
        "substitutions": [["b", "2*a + g"]], "parameters": [["g", "b - a"]], "example": [["b", "2"]]}"#;
    let error = sign("b - 2*a", missing).expect_err("b = 3a/2 is not reached");
    assert!(error.contains("does not reach every b"), "{error}");
    let unproved = missing.replace(r#"["g", "b - a"]"#, r#"["g", "b - 2*a"]"#);
    assert!(sign("b - 2*a", &unproved).expect_err("b < 2a").contains("g = b - 2*a is not positive"));
    let bare = r#"{"positive": ["a", "b", "g"], "substitutions": [["b", "a + g"]]}"#;
    assert!(sign("b - a", bare).expect_err("b < a is positive too").contains("proves its image only"));
    let covering = missing.replace("2*a + g", "a + g");
    assert_eq!(sign("b - a", &covering), Ok(()));
    let by_roots = r#"{"positive": ["a", "b"], "given": ["b - a > 0"], "example": [["b", "2"]],
        "substitutions": [["a", "p^2"], ["b", "(p + g)^2"]],
        "parameters": [["p", "sqrt(a)"], ["g", "sqrt(b) - sqrt(a)"]]}"#;
    assert_eq!(sign("sqrt(b) - sqrt(a)", by_roots), Ok(()));
}

#[test]
fn forged_hypotheses_that_cannot_hold_are_refused() {
    let contradiction = r#"{"positive": ["a", "b"], "given": ["b - a > 0", "a - b > 0"], "substitutions": [],
        "example": [["b", "2"]]}"#;
    assert!(
        sign("1", contradiction).expect_err("nowhere").contains("a - b > 0 does not hold at the example")
    );
    let ambiguous = r#"{"positive": ["a"], "substitutions": [["x", "y"], ["y", "-x"]]}"#;
    assert!(sign("a", ambiguous).expect_err("circular").contains("stands for two things"));
}

#[test]
fn forged_root_without_a_change_of_sign_is_refused() {
    let root = |polynomial: &str, between: &str, positive: &str| {
        checked(&format!(
            r#"{{"kind": "root", "polynomial": "{polynomial}", "variable": "s", "between": {between},
            "domain": {{"positive": [{positive}], "substitutions": []}}}}"#
        ))
    };
    let left = r#"[null, "0"]"#;
    assert_eq!(root("c*s^3 + k*s + d", left, r#""c", "d""#), Ok(()));
    assert_eq!(root("s^2 - c", r#"["0", null]"#, r#""c""#), Ok(()));
    let even = root("c*s^2 + d", left, r#""c", "d""#).expect_err("no root");
    assert!(even.contains("no certified change of sign"), "{even}");
    assert!(root("c*s^3 - d", left, r#""c", "d""#).is_err(), "the root is right of 0");
    assert!(root("c*s^3 + k*s + d", left, r#""c""#).is_err(), "d may be negative");
    // 1/s changes its sign without a root, and from 1 to -1 nothing lies between.
    assert!(root("1/s", r#"["-1", "1"]"#, "").is_err());
    assert!(root("s", r#"["1", "-1"]"#, "").is_err());
    assert!(root("s + c", left, r#""c", "s""#).is_err(), "a positive s is never −c");
    assert_eq!(root("s", r#"["-1", "1"]"#, ""), Ok(()));
    // A root at an end is not between the ends.
    assert!(root("s", r#"["0", "1"]"#, "").is_err() && root("s", r#"["-1", "0"]"#, "").is_err());
    assert!(root("s/(s^2 + 1)", r#"["-1", "1"]"#, "").expect_err("a quotient").contains("no polynomial"));
    // With a constant in the place of exp(-s) it had one.
    assert!(root("s + exp(-s)", "[null, null]", "").expect_err("at least 1").contains("depends on s"));
}

#[test]
fn forged_connected_set_with_a_gap_is_refused() {
    let connected = |image: &str, domain: &str| {
        checked(&format!(r#"{{"kind": "connected", "image": [["X", "{image}"]], "domain": {domain}}}"#))
    };
    let orthant = r#"{"positive": ["s", "t"], "substitutions": []}"#;
    assert_eq!(connected("s/(1 + t)", orthant), Ok(()));
    assert!(connected("s/(1 - t)", orthant).expect_err("a pole at t = 1").contains("may be zero"));
    assert!(connected("s/q", orthant).is_err() && connected("s*q", orthant).is_err());
    let cut = r#"{"positive": ["s", "t"], "given": ["1 - s != 0"], "substitutions": [],
        "example": [["s", "2"]]}"#;
    assert!(connected("s", cut).expect_err("two parts").contains("other than being positive"));
}

#[test]
fn forged_derivative_is_refused() {
    let derivative = |expression: &str, value: &str| {
        checked(&format!(
            r#"{{"kind": "derivative", "expression": "{expression}", "variable": "x", "value": "{value}",
            "domain": {{"positive": ["x", "y"], "substitutions": []}}}}"#
        ))
    };
    assert_eq!(derivative("y*ln(x/y) + x^2", "y/x + 2*x"), Ok(()));
    assert!(derivative("y*ln(x/y) + x^2", "y/x + x").is_err());
    assert!(derivative("y*ln(x - y)", "y/(x - y)").is_err(), "no value at x = y");
}

#[test]
fn forged_linearisation_is_refused() {
    let checked = |rates: &str, steady: &str, slopes: &str, polynomial: &str| {
        checked(&format!(
            r#"{{"kind": "characteristic", "system": {{"state": ["x", "v"], "rates": {rates}, "steady": {steady},
            "slopes": {slopes}}}, "variable": "s", "polynomial": "{polynomial}",
            "domain": {{"positive": ["k", "u"], "substitutions": []}}}}"#
        ))
    };
    let (rates, steady) = (r#"["v - u", "k - k*x - ln(v/u)"]"#, r#"["1", "u"]"#);
    let slopes = r#"[["0", "1"], ["-k", "-1/u"]]"#;
    assert_eq!(checked(rates, steady, slopes, "s^2 + s/u + k"), Ok(()));
    for (rates, steady, slopes, polynomial) in [
        (rates, steady, slopes, "s^2 - s/u + k"),
        (rates, steady, r#"[["0", "1"], ["-k", "-2/u"]]"#, "s^2 + 2*s/u + k"),
        (rates, r#"["2", "u"]"#, slopes, "s^2 + s/u + k"),
        (rates, r#"["1", "v"]"#, slopes, "s^2 + s/u + k"),
        (rates, r#"["1"]"#, slopes, "s^2 + s/u + k"),
        (r#"["v - u", "k - k*x - ln(v/u) + (s - s)"]"#, steady, slopes, "s^2 + s/u + k"),
    ] {
        assert!(
            checked(rates, steady, slopes, polynomial).is_err(),
            "{rates} {steady} {slopes} {polynomial}"
        );
    }
}

#[test]
fn forged_growth_of_what_does_not_grow_from_zero_is_refused() {
    let growth = |expression: &str, order: u32| {
        checked(&format!(
            r#"{{"kind": "growth", "expression": "{expression}", "variable": "y", "order": {order},
            "domain": {{"positive": ["y"], "substitutions": []}}}}"#
        ))
    };
    assert_eq!(growth("exp(y) - 1 - y - y^2/2", 3), Ok(()));
    assert!(growth("exp(y) - 2 - y", 2).is_err(), "negative at 0");
    assert!(growth("exp(y) - 1 - y - y^2", 3).is_err(), "its second derivative is negative at 0");
    assert!(growth("exp(y) - 1 - y", 1).is_err(), "its first derivative has no certified sign");
}

#[test]
fn forged_limit_of_a_function_that_hides_its_variable_is_refused() {
    let limit = |expression: &str, value: &str| {
        checked(&format!(
            r#"{{"kind": "limit", "expression": "{expression}", "variable": "x", "toward": "zero", "value": "{value}",
            "domain": {{"positive": ["x", "y"], "substitutions": []}}}}"#
        ))
    };
    assert_eq!(limit("x*y", "0"), Ok(()));
    assert!(limit("x*exp(1/x)", "0").expect_err("it grows").contains("tends to infinity"));
    assert!(limit("x*exp(-1/x)", "0").is_ok() && limit("x*exp(-1/x)", "1").is_err());
    assert!(limit("sin(1/x)", "0").expect_err("it turns").contains("no certified limit"));
}

#[test]
fn forged_limit_beyond_all_bounds_is_refused() {
    let divergence = |expression: &str, sign: i8| {
        checked(&format!(
            r#"{{"kind": "divergence", "expression": "{expression}", "variable": "x", "toward": "zero", "sign": {sign},
            "domain": {{"positive": ["x", "y"], "substitutions": []}}}}"#
        ))
    };
    assert_eq!(divergence("y*exp(1/x)", 1), Ok(()));
    assert_eq!(divergence("y - 1/x", -1), Ok(()));
    assert!(divergence("y*exp(1/x)", -1).expect_err("it goes up").contains("tends to infinity"));
    assert!(divergence("x*y", 1).is_err() && divergence("x*y", -1).is_err());
}

#[test]
fn forged_series_is_refused() {
    let series = |relation: &str, coefficients: &str| {
        checked(&format!(
            r#"{{"kind": "series", "relation": "{relation}", "variable": "x", "unknown": "y", "coefficients": {coefficients},
            "domain": {{"positive": ["c"], "substitutions": []}}}}"#
        ))
    };
    assert_eq!(series("y - c - x*y", r#"["c", "c", "c"]"#), Ok(()));
    assert_eq!(series("y - c - x*y", r#"["c", "c", "2*c"]"#).expect_err("the third is c"), "c");
    assert!(series("y - c - x*y", r#"["2*c", "2*c"]"#).is_err(), "it begins with c");
    assert!(series("y^2 - x", r#"["0"]"#).expect_err("two roots").contains("no single root"));
    // As constants, both functions would be right coefficients.
    assert!(series("y - c - x*exp(x)", r#"["c", "exp(x)"]"#).expect_err("in x").contains("depends on x"));
    assert!(series("y - c - x*exp(y)", r#"["c", "exp(y)"]"#).expect_err("in y").contains("depends on y"));
}

const FREE: &str = r#"{"positive": [], "substitutions": []}"#;

#[test]
fn functions_of_which_nothing_is_known_are_read_and_checked() {
    assert_eq!(identity("f(2*x/2) + f'(y)", "f'(y) + f(x)", FREE), Ok(()));
    for (left, right) in
        [("f(x)", "f(y)"), ("f(x)", "f(-x)"), ("f(x)", "f'(x)"), ("f(0)", "0"), ("f(f(x))", "f(x)")]
    {
        assert!(identity(left, right, FREE).is_err(), "{left} = {right}");
    }
    let derivative = |value: &str| {
        checked(&format!(
            r#"{{"kind": "derivative", "expression": "x*f(2*x)", "variable": "x", "value": "{value}", "domain": {FREE}}}"#
        ))
    };
    assert_eq!(derivative("f(2*x) + 2*x*f'(2*x)"), Ok(()));
    assert!(derivative("f(2*x) + x*f'(2*x)").is_err());
}

#[test]
fn forged_values_of_a_function_as_assumptions_are_refused_or_of_no_use() {
    // A substitution, a square or a sign of f, or of its value at 0, says nothing of f(x).
    for domain in [
        r#"{"positive": [], "substitutions": [["f", "1"]]}"#,
        r#"{"positive": [], "substitutions": [["f(0)", "1"]]}"#,
        r#"{"positive": [], "substitutions": [["f(0)", "1"], ["f'(0)", "0"]]}"#,
        r#"{"positive": ["f"], "substitutions": []}"#,
        r#"{"positive": [], "squares": [["f", "1"]], "substitutions": [], "example": [["f", "1"]]}"#,
    ] {
        assert!(identity("f(x)", "f(y)", domain).is_err(), "{domain}");
        assert!(identity("f(x)^2", "1", domain).is_err(), "{domain}");
        assert!(sign("f(x)", domain).is_err(), "{domain}");
    }
    let given = |example: &str| {
        format!(
            r#"{{"positive": ["x"], "given": ["f'(x) > 0"], "substitutions": [], "example": [{example}]}}"#
        )
    };
    assert_eq!(sign("x*f'(x)", &given(r#"["f(0)", "0"], ["f'(0)", "3"]"#)), Ok(()));
    assert!(sign("f'(2*x)", &given(r#"["f(0)", "0"], ["f'(0)", "3"]"#)).is_err());
    for impossible in [r#"["f(0)", "0"], ["f'(0)", "-3"]"#, r#"["f(0)", "5"]"#, ""] {
        let error = sign("x*f'(x)", &given(impossible)).expect_err("no such function");
        assert!(error.contains("does not hold at the example"), "{error}");
    }
}

#[test]
fn a_value_with_a_function_is_that_of_the_polynomial_at_its_point() {
    let value = |value: &str, point: &str| {
        checked(&format!(
            r#"{{"kind": "value", "expression": "f(x) + f''(x)", "point": [{point}], "value": "{value}"}}"#
        ))
    };
    let point = r#"["x", "2"], ["f(0)", "3"], ["f'(0)", "-2"], ["f''(0)", "5"]"#;
    assert_eq!(value("14", point), Ok(()));
    assert!(value("13", point).is_err() && value("14", r#"["x", "2"]"#).is_err());
    let difference = |point: &str| {
        checked(&format!(
            r#"{{"kind": "difference", "left": "f(x)", "right": "f(y)", "point": [{point}], "values": ["1", "2"]}}"#
        ))
    };
    assert_eq!(difference(r#"["x", "0"], ["y", "1"], ["f(0)", "1"], ["f'(0)", "1"]"#), Ok(()));
    assert!(difference(r#"["x", "0"], ["y", "1"], ["f(0)", "1"]"#).is_err());
    assert!(difference(r#"["x", "0"], ["y", "1"], ["f", "1"], ["f'", "1"]"#).is_err());
}

#[test]
fn forged_growth_of_a_function_needs_a_sign_everywhere() {
    let growth = |expression: &str, domain: &str| {
        checked(&format!(
            r#"{{"kind": "growth", "expression": "{expression}", "variable": "x", "order": 1, "domain": {domain}}}"#
        ))
    };
    assert_eq!(growth("x + x*f(y)^2", r#"{"positive": ["x"], "substitutions": []}"#), Ok(()));
    assert!(growth("f(x) - f(0)", r#"{"positive": ["x"], "substitutions": []}"#).is_err());
    // Of one x only.
    let given = r#"{"positive": ["x"], "given": ["f'(x) > 0"], "substitutions": [], "example": [["f(0)", "0"], ["f'(0)", "1"]]}"#;
    assert!(growth("f(x) - f(0)", given).is_err());
}

#[test]
fn a_certificate_with_a_function_has_no_theorem() {
    let of = |certificate: &str| {
        let certificate: crate::Certificate = serde_json::from_str(certificate).expect("readable");
        crate::coq::Theorem::of(&certificate).expect_err("no theorem").to_string()
    };
    let wanted = "no tactic for the function f, of which nothing is known";
    assert_eq!(
        of(&format!(r#"{{"kind": "identity", "left": "f(x)", "right": "f(x)", "domain": {FREE}}}"#)),
        wanted
    );
    let given = r#"{"positive": [], "given": ["f'(0) > 0"], "substitutions": []}"#;
    assert_eq!(
        of(&format!(r#"{{"kind": "identity", "left": "x", "right": "x", "domain": {given}}}"#)),
        wanted
    );
}
