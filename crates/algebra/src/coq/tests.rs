//! What Coq receives: statements, and proofs where a test follows them.

use proptest::prelude::*;

use super::*;
use crate::expression::tests::{Of, expressions, points, value};
use crate::{Function, Relation};

fn parsed(text: &str) -> Expression {
    text.parse().expect("an expression")
}

#[test]
fn a_linearised_system_states_its_rates_derivatives_and_determinant() {
    let system = crate::Linearisation {
        state: vec!["v".into()],
        rates: vec![parsed("k - k*v/u")],
        steady: vec![parsed("u")],
        slopes: vec![vec![parsed("-k/u")]],
    };
    let domain = Domain::positive("k u v");
    let theorem =
        Theorem::of(&system.clone().certificate(&"s".into(), parsed("s + k/u"), domain.clone())).unwrap();
    let statement = "(k - ((k * u) / u)) = 0 /\\ \
        is_derive (fun v : R => (k - ((k * v) / u))) u (- (k / u)) /\\ (s + (k / u)) = (s + (k / u)).";
    assert!(theorem.text.contains(statement), "{}", theorem.text);
    assert!(!theorem.text.contains("v'pos") && theorem.text.contains("u'pos"), "{}", theorem.text);
    let moving = domain.given(parsed("v - u"), Relation::NonNegative).example("v", parsed("2"));
    let obstacle = Theorem::of(&system.certificate(&"s".into(), parsed("s + k/u"), moving)).unwrap_err();
    assert!(obstacle.to_string().contains("contains v"), "{obstacle}");
}

#[test]
fn a_root_is_written_with_forms_that_are_positive_where_the_theorem_holds() {
    let domain = Domain::positive("a b").given(parsed("b - a"), Relation::Positive);
    let domain = domain.example("a", parsed("9/4")).example("b", parsed("13/4"));
    let root = parsed("a/(b - a)").call(Function::Sqrt);
    let left = root.clone().power(2) * parsed("b - a");
    let of = |right: &str, domain: &Domain| {
        let certificate =
            Certificate::Identity { left: left.clone(), right: parsed(right), domain: domain.clone() };
        Theorem::of(&certificate).expect("a theorem")
    };
    let theorem = of("a", &domain);
    assert!(theorem.text.contains("sqrt (a / ((- a) + b))"), "{}", theorem.text);
    assert!(!theorem.text.contains("(a / (a - b))"), "{}", theorem.text);
    // The roots that the conditions have at the example are named, so that Coq can compute there.
    let domain = domain.given(parsed("b") - root, Relation::Positive);
    let witness = of("a", &domain).lemmas.pop().expect("a lemma").text;
    assert!(witness.contains("try root_is (3 / 2); possible"), "{witness}");
}

#[test]
fn signs_rest_on_squares_on_variables_that_are_not_negative_and_on_the_parts_of_a_sum_with_a_root() {
    let sign = |text: &str, domain: Domain| {
        Theorem::of(&Certificate::Sign { expression: parsed(text), sign: 1, domain }).expect("a theorem")
    };
    let theorem = sign("x + (x - z)^2", Domain::positive("x"));
    assert!(theorem.text.contains("apply pow2_ge_0") && theorem.lemmas.len() == 1, "{}", theorem.text);
    let domain = Domain::positive("x").given(parsed("z"), Relation::NonNegative);
    let theorem = sign("x/(x + z)", domain);
    assert!(theorem.text.contains("apply Rplus_lt_le_0_compat"), "{}", theorem.text);
    // The root is the larger part: (x - y)^2 + 4 y z is more than (x - y)^2.
    let theorem = sign("x - y + sqrt((x - y)^2 + 4*y*z)", Domain::positive("x y z"));
    assert!(theorem.text.contains("apply (root_part_other_lt ("), "{}", theorem.text);
    assert_eq!(theorem.lemmas[0].name, "root_part");
}

#[test]
fn an_irrational_root_of_a_condition_has_rational_bounds_at_the_example() {
    let domain = Domain::positive("x y").given(parsed("y - sqrt(2)*x"), Relation::Positive);
    let domain = domain.example("y", parsed("2"));
    let certificate = Certificate::Sign { expression: parsed("x"), sign: 1, domain };
    let witness = Theorem::of(&certificate).expect("a theorem").lemmas.pop().expect("a lemma").text;
    assert!(witness.contains("(1414213562373 / 1000000000000) < sqrt x"), "{witness}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// The text that Coq reads has the value of the expression.
    #[test]
    fn what_coq_reads_has_the_value_of_the_expression(expression in expressions(Of::Functions), point in points()) {
        let names = [("ln", "ln"), ("sqrt", "sqrt"), ("Rabs", "abs"), ("exp", "exp"), ("arcsinh", "asinh"), ("sin", "sin"), ("cos", "cos")];
        let names = names.into_iter().chain(["f", "f'", "f''", "f'''"].map(|name| (name, name)));
        let written = names.fold(term::real(&expression).replace("(/ ", "(1 / "), |text, (coq, name)| {
            text.replace(&format!("({coq} "), &format!("{name}("))
        });
        let read = Expression::try_from(written.clone()).expect("in the grammar");
        match (value(&expression, &point), value(&read, &point)) {
            (Ok(wanted), Ok(found)) => prop_assert!(found.is(&wanted), "{} for {}", written, expression),
            (wanted, found) => prop_assert_eq!(wanted.err(), found.err(), "{} for {}", written, expression),
        }
    }
}

fn certificate(kind: &str, fields: &str, domain: &str) -> Certificate {
    let domain = if domain.is_empty() { String::new() } else { format!(r#", "domain": {{{domain}}}"#) };
    serde_json::from_str(&format!(r#"{{"kind": "{kind}", {fields}{domain}}}"#)).expect("a certificate")
}

/// What stands between a name and its proof, for the theorem, what it is altered to, and each lemma.
fn statements(theorem: &Theorem) -> Vec<String> {
    let statement = |text: &str| text.split(".\nProof").next().map(str::to_owned).unwrap_or_default();
    let theorems = theorem.text.split("\n\n").chain([theorem.fault.as_str()]);
    theorems.chain(theorem.lemmas.iter().map(|lemma| lemma.text.as_str())).map(statement).collect()
}

#[test]
fn statements_are_those_of_their_certificates() {
    let free = r#""positive": ["x", "y"], "substitutions": []"#;
    let cover = r#""positive": ["a", "b"], "given": ["b - a > 0"], "substitutions": [["b", "a + g"], ["w", "a*b"]],
        "parameters": [["g", "b - a"]], "example": [["b", "2"]]"#;
    let defined = cover.replace("a*b", "a*(a + g)");
    let squares =
        r#""positive": ["x"], "squares": [["q", "x"]], "substitutions": [], "example": [["q", "1"]]"#;
    let given = r#""positive": [], "given": ["x - 1 >= 0", "y != 0"], "substitutions": [],
        "example": [["x", "1"], ["y", "3"]]"#;
    assert_eq!(super::text(&parsed("x/2")), "(x / 2)");
    let mut text = String::new();
    for (kind, fields, domain) in [
        ("identity", r#""left": "(x + y)^2", "right": "x^2 + 2*x*y + y^2""#, free),
        ("identity", r#""left": "sqrt(x)^2", "right": "x""#, free),
        (
            "identity",
            r#""left": "x - y/2", "right": "x - y/2""#,
            r#""positive": [], "substitutions": [["x", "y/2"]]"#,
        ),
        ("identity", r#""left": "(z + i*x)*(z - i*x)/i^2", "right": "-z^2 - x^2*i^-4""#, free),
        (
            "identity",
            r#""left": "c*d*i^0", "right": "-x*i*d""#,
            r#""positive": ["x"], "substitutions": [["c", "-i*x"]]"#,
        ),
        (
            "identity",
            r#""left": "i*ln(v)*e", "right": "2*z*i*ln(v)""#,
            r#""positive": ["v"], "substitutions": [["e", "2*z"]]"#,
        ),
        (
            "identity",
            r#""left": "i*exp(u)*i", "right": "-exp(u)*z/z""#,
            r#""positive": ["z"], "substitutions": []"#,
        ),
        ("identity", r#""left": "w/a", "right": "a + g""#, &defined),
        ("identity", r#""left": "q^3 + pm*pm", "right": "q*x + 1""#, squares),
        (
            "value",
            r#""expression": "x^-2 + if - 0.5", "point": [["x", "2"], ["if", "4"]], "value": "15/4""#,
            "",
        ),
        ("difference", r#""left": "x^2", "right": "2*x", "point": [["x", "3"]], "values": ["9", "6"]"#, ""),
        ("sign", r#""expression": "x + y", "sign": 1"#, free),
        ("sign", r#""expression": "a - b", "sign": -1"#, cover),
        ("sign", r#""expression": "x^2 + 1", "sign": 1"#, given),
        (
            "limit",
            r#""expression": "(x + y)/(1 + x)", "variable": "x", "toward": "zero", "value": "y""#,
            free,
        ),
        (
            "limit",
            r#""expression": "x*y/(1 + x^2)", "variable": "x", "toward": "infinity", "value": "0""#,
            free,
        ),
        ("derivative", r#""expression": "y*ln(x)", "variable": "x", "value": "y/x""#, free),
        ("derivative", r#""expression": "y", "variable": "x", "value": "0""#, free),
        ("root", r#""polynomial": "s^3 + x*s + y", "variable": "s", "between": [null, "0"]"#, free),
        ("root", r#""polynomial": "s^2 - x", "variable": "s", "between": ["0", null]"#, free),
        ("root", r#""polynomial": "s^3 - x", "variable": "s", "between": ["0", "x + 1"]"#, free),
        ("root", r#""polynomial": "s^3 + x*s + y", "variable": "s", "between": [null, null]"#, free),
        ("growth", r#""expression": "exp(y) - 1 - y", "variable": "y", "order": 2"#, free),
        (
            "series",
            r#""relation": "v - x - u*v", "variable": "u", "unknown": "v", "coefficients": ["x", "x"]"#,
            free,
        ),
        (
            "series",
            r#""relation": "z*v - z*x - u*v", "variable": "u", "unknown": "v", "coefficients": ["x"]"#,
            free,
        ),
        (
            "connected",
            r#""image": [["X", "s/(1 + t)"], ["Y", "t"]]"#,
            r#""positive": ["s", "t"], "substitutions": []"#,
        ),
    ] {
        let certificate = certificate(kind, fields, domain);
        let theorem =
            Theorem::of(&certificate).unwrap_or_else(|obstacle| panic!("{certificate}: {obstacle}"));
        text += &format!("{}\n", theorem.variables.join(" "));
        for statement in statements(&theorem) {
            // The digest in a name is that of the certificate.
            let (name, statement) = statement
                .split_once([' ', '\n'])
                .map_or(("", ""), |(_, rest)| rest.split_once([' ', '\n']).unwrap_or((rest, "")));
            let kind: String = name.split('_').filter(|word| word.len() != 16).collect::<Vec<_>>().join("_");
            text += &format!("  {kind} {}\n", statement.split_whitespace().collect::<Vec<_>>().join(" "));
        }
    }
    assert_eq!(text, include_str!("statements.txt"));
}

#[test]
fn no_substitution_contains_the_variable_of_a_derivative() {
    let theorem = |name: &str, image: &str| {
        let domain = format!(r#""positive": [], "substitutions": [["{name}", "{image}"]]"#);
        Theorem::of(&certificate(
            "derivative",
            r#""expression": "w*x", "variable": "x", "value": "w""#,
            &domain,
        ))
    };
    assert!(theorem("w", "v").is_ok() && theorem("w", "x + 1").is_err() && theorem("x", "v").is_err());
}
