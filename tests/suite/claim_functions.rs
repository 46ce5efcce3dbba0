//! Functions of which nothing is known: claims that hold for every one of them, and declarations at fault.

use crate::harness::{Ended, Workplace};
use crate::independent::compared;

/// A slider with mass whose friction is any function of the slip rate.
const EQUATIONS: &str = r#"
[assumptions]
positive = ["K", "M", "V", "v"]
free = ["x", "y"]
[[function]]
name = "f"
note = "Friction force at slip rate v, any smooth function."
[[function]]
name = "tau_s"
[[equation]]
number = "1"
equation = "force = K*x - f(v)"
[[system]]
name = "slider"
state = ["x", "v"]
rates = ["V - v", "force/M"]
steady = ["f(V)/K", "V"]
[[definition]]
name = "P"
is = "characteristic(slider, s)"
[[definition]]
name = "D"
is = "derivative(f(2*x), x)"
[[definition]]
name = "N"
is = "derivative(f(f(x)), x)"
[[definition]]
name = "S"
is = "series(f(V + M), M, 2)"
[[definition]]
name = "J"
is = "linearised(slider, v, v)"
[[definition]]
name = "R"
is = "rate(f(v)^2, slider)"
"#;

fn claim(number: usize, expected: &str, formula: &str, keys: &str) -> String {
    format!(
        "[[claim]]\nid = \"C{number}\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"{expected}\"\nleaves_out = \"nothing\"\n\
         formula = {formula:?}\n{keys}\n\n"
    )
}

/// A formula, its other keys, and the verdict.
type Row = (&'static str, &'static str, &'static str);

const ROWS: [Row; 46] = [
    ("stable(P, s) iff f'(V) > 0", "", "holds"),
    ("stable(P, s)", "", "fails"),
    ("stable(P, s)", "given = [\"f'(V) >= 0\"]", "fails"),
    ("stable(P, s)", "given = [\"f'(V + M) > 0\"]", "fails"),
    ("unstable(P, s)", "given = [\"f'(V) < 0\"]", "holds"),
    ("all_real(P, s) iff f'(V)^2 >= 4*K*M", "", "holds"),
    ("J = -f'(V)/M", "", "holds"),
    ("R = 2*f(v)*f'(v)*(K*x - f(v))/M", "", "holds"),
    // Equal arguments, and others.
    ("f(x) = f(y)", "given = [\"x = y\"]", "holds"),
    ("f(x) = f(y)", "", "fails"),
    ("f(x) = f(-x)", "", "fails"),
    ("f(x) = tau_s(x)", "", "fails"),
    ("f(2*V/2) - f(sqrt(V^2)) = x - x", "", "holds"),
    ("f(x)*(y - y) = 0", "", "holds"),
    ("x = y implies f'(x) = f'(y)", "", "holds"),
    ("f(x) = f(y) implies x = y", "", "fails"),
    ("f(f(x)) = x", "", "fails"),
    ("f(0) = 0", "", "fails"),
    ("f(1 + 1) = f(2)", "", "holds"),
    ("f(x + y) = f(x) + f(y)", "", "fails"),
    // Signs.
    ("f(x)^2 >= 0", "", "holds"),
    ("f(x)^2 > 0", "", "fails"),
    ("not [f(x) > 0 and f(y) < 0]", "given = [\"x = y\"]", "holds"),
    ("not [f(x) > 0 and f(y) < 0]", "", "fails"),
    ("K*f'(V) + M > 0", "given = [\"f'(V) > 0\"]", "holds"),
    ("f'(x) > 0", "given = [\"f'(y) > 0\"]", "fails"),
    ("f(x) > 0", "given = [\"f'(x) > 0\"]", "fails"),
    ("f''(x) > 0", "given = [\"f'(x) > 0\"]", "fails"),
    ("sqrt(1 + f(x)^2)^2 = 1 + f(x)^2", "", "holds"),
    ("ln(1 + f(x)^2) >= 0", "", "not-checked"),
    // Derivatives, limits and series.
    ("D = 2*f'(2*x)", "", "holds"),
    ("D = f'(2*x)", "", "fails"),
    ("N = f'(x)*f'(f(x))", "", "holds"),
    ("S = f(V) + M*f'(V) + M^2*f''(V)/2", "", "holds"),
    ("f(K) -> f(0) as K -> 0", "", "holds"),
    ("f(K) -> 0 as K -> infinity", "", "not-checked"),
    ("f(K)/(1 + f(K)^2) -> 0 as K -> infinity", "", "not-checked"),
    // What moves.
    ("f(x) rises with x", "given = [\"f'(x) > 0\"]", "not-checked"),
    ("f(x) rises with x", "", "fails"),
    ("x*f'(V) rises with x", "given = [\"f'(V) > 0\"]", "holds"),
    ("f(x) depends on x", "", "not-checked"),
    ("f(x) does not depend on x", "", "fails"),
    ("K + f(V) depends on K", "", "holds"),
    // Existence, for every function.
    ("f(x) = f(V)", "there_is = ['x']\nwitness = { x = 'V' }", "holds"),
    ("f(x) = 0", "there_is = ['x']", "fails"),
    ("K*x = f(V)", "there_is = ['x']\nwitness = { x = 'f(V)/K' }", "holds"),
];

fn all_rows() -> String {
    (1..).zip(ROWS).map(|(number, (formula, keys, verdict))| claim(number, verdict, formula, keys)).collect()
}

#[test]
fn claims_hold_for_every_function_or_fail_at_one_that_is_named() {
    let place = Workplace::with_report(EQUATIONS, &all_rows(), "[[claim:C1]]\n\n[[claim:C2]]\n");
    let ended = place.run(["verify", "r", "-o", "out"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    for (entry, (formula, keys, verdict)) in ledger["claims"].as_array().unwrap().iter().zip(ROWS) {
        let example = entry["counter_example"].as_str().unwrap_or_default();
        assert!(verdict != "fails" || example.contains("f("), "{formula} {keys}: {example}");
        assert!(!example.contains("(0) ="), "{formula} {keys}: {example}");
    }
    std::fs::copy(place.path("out/ledger.json"), place.path("r/ledger.json")).unwrap();
    let Some(ended) = compared(&[place.path("r").to_str().unwrap(), "--points", "20", "--quiet"]) else {
        return;
    };
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
}

#[test]
fn a_report_shows_functions_and_its_archive_is_decided_again() {
    let claims = claim(1, "holds", ROWS[0].0, "") + &claim(2, "fails", ROWS[1].0, "");
    let place =
        Workplace::with_report(EQUATIONS, &claims, "[[equation:1]]\n\n[[claim:C1]]\n\n[[claim:C2]]\n");
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    let page = place.page("out/index.html");
    assert!(
        page.contains("<msup><mi>f</mi><mo>′</mo></msup>") && page.contains("stable(P, s) is false"),
        "{page}"
    );
    place.run(["archive", "r", "-o", "a.zip"]).expect_warnings();
    let replayed = place.run(["replay", "a.zip"]);
    assert_eq!(replayed.code, 0, "{replayed:?}");
    let planted = place.run(["verify", "r", "--planted-faults"]).expect_success();
    assert!(planted.contains("wrong versions noticed"), "{planted}");
}

/// What the program says of `equations.toml`, beside a claim that needs none of it.
fn refused(equations: &str) -> Ended {
    Workplace::with_report(equations, &claim(1, "holds", "a + 1 > a", ""), "Words.\n").run(["verify", "r"])
}

#[test]
fn declarations_at_fault_are_refused_all_at_once() {
    let equations = r#"
[assumptions]
positive = ["a", "b", "c"]
[[function]]
name = "c"
[[function]]
name = "g"
[[function]]
name = "g"
[[function]]
name = "f'"
[[function]]
name = "sqrt"
[[function]]
name = "solve"
[[function]]
name = "D"
[[function]]
name = "s"
[[function]]
name = "left_1"
[[function]]
name = "u"
of = "w"
[[equation]]
number = "1"
equation = "d = a + b"
[[system]]
name = "z"
state = ["b"]
rates = ["a - b"]
steady = ["a"]
[[definition]]
name = "D"
is = "characteristic(z, s)"
[[definition]]
name = "E"
is = "2*u"
[[definition]]
name = "F"
is = "h(b)"
"#;
    refused(equations).expect_refusal(&[
        "r/equations.toml: function c: the name has a meaning by an assumption, a state or a derivation",
        "r/equations.toml: function g: occurs twice",
        "r/equations.toml: function f': a name has 1 to 40 characters",
        "r/equations.toml: function sqrt: a name has 1 to 40 characters",
        "r/equations.toml: function solve: a name has 1 to 40 characters",
        "r/equations.toml: function D: the name has a meaning by a definition",
        "r/equations.toml: function s: the name has a meaning by an assumption, a state or a derivation",
        "r/equations.toml: function left_1: the name has a meaning by equation 1",
        "r/equations.toml: function u: `of`: 'w' is no variable",
        "r/equations.toml: definition E: column 3: u is a function: write u(...)",
        "r/equations.toml: definition F: column 2: 'h' is not a function (write * for products)",
    ]);
    let equation = "[[equation]]\nnumber = \"1\"\nequation = \"and = 1\"\n[[equation]]\nnumber = \"2\"\nequation = \"g = a\"\n";
    let names =
        ["and", "is_stable", "limit", "g"].map(|name| format!("[[function]]\nname = \"{name}\"\n")).concat();
    refused(&format!("[assumptions]\npositive = [\"a\"]\n{names}{equation}")).expect_refusal(&[
        "r/equations.toml: function and: a name has 1 to 40 characters",
        "r/equations.toml: function is_stable: a name has 1 to 40 characters",
        "r/equations.toml: function limit: a name has 1 to 40 characters",
        "r/equations.toml: equation 2: left side 'g', column 1: g is a function: write g(...)",
    ]);
    let unknown = "[assumptions]\npositive = [\"a\"]\n[[function]]\nname = \"f\"\narguments = 2\n";
    refused(unknown).expect_refusal(&["r/equations.toml:5", "arguments"]);
}

#[test]
fn texts_that_misuse_a_function_are_refused_with_their_place() {
    for (formula, keys, words) in [
        ("f > 0", "", "column 1: 'f': f is a function: write f(...)"),
        ("x + f' > 0", "", "f is a function: write f'(...)"),
        ("g(x) > 0", "", "'g' is not a function (write * for products)"),
        ("f'''''''(x) > 0", "", "f has at most 6 primes"),
        ("f(x, y) > 0", "", "expected ')'"),
        ("x > 0", "given = ['f > 0']", "f is a function: write f(...)"),
        ("x > 0", "at = { f = 1 }", "'f' is no variable"),
        ("x > 0", "box = { f = [1, 2] }", "'f' is no variable"),
        ("x > 0", "there_is = ['f']", "'f' is no variable"),
        ("x rises with f", "", "'f' is no variable"),
        ("stable(s + K, f)", "", "f is a function, and no name for the roots"),
        ("stable(s + f(s), s)", "", "is no real polynomial of degree 1 to 6 in s"),
        ("sqrt(f(x)) >= 0", "", "may be negative"),
        ("ln(f(x)) > 0", "", "may be zero or negative"),
        ("1/f(x) > 0", "", "may be zero"),
        ("f(1/x) > 0", "", "may be zero"),
        ("f(i*x)^2 >= 0", "", "'i' is no variable"),
        ("f(f(f(f(x)))) = x", "", "is too large: multiplied out it may have 1 terms and degree 121"),
        ("f(x) > 0", "given = ['f(x) = f(y)']", "is not linear in one of its variables"),
    ] {
        let place = Workplace::with_report(EQUATIONS, &claim(1, "holds", formula, keys), "Words.\n");
        let ended = place.run(["verify", "r"]);
        assert!(ended.code == 2 && ended.stderr.contains(words), "{formula} {keys}: {ended:?}");
        assert!(ended.stderr.contains("r/claims.toml:"), "{ended:?}");
    }
    for (is, words) in [
        ("eliminate(f(x) - y, x - K, x)", "is no polynomial in x"),
        ("solve(f(x) - K, x)", "is no polynomial in x"),
        ("coefficient(x*f(x), x, 1)", "is no polynomial in x"),
        ("limit(f(V), V, infinity)", "has no certified limit in V"),
        ("series(f(1/V), V, 1)", "has no certified limit in V"),
        ("f(i*x)^2", "i*x is the argument of a function and contains i: functions are those of real numbers"),
        ("derivative(f(x), f)", "'f' is no variable"),
        ("at(K, f = 1)", "'f' is no variable"),
        ("characteristic(slider, f)", "the name has a meaning by an assumption, a state or a derivation"),
    ] {
        let equations = format!("{EQUATIONS}[[definition]]\nname = \"Q\"\nis = \"{is}\"\n");
        let ended = Workplace::with_report(&equations, &claim(1, "holds", "K + 1 > K", ""), "Words.\n")
            .run(["verify", "r"]);
        assert!(ended.code == 2 && ended.stderr.contains(words), "{is}: {ended:?}");
    }
    let motion = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\n\
        [claim.motion]\nlemma = \"periodic\"\nsystem = \"slider\"\nquantity = \"v + x\"\n";
    let ended = Workplace::with_report(EQUATIONS, motion, "Words.\n").run(["verify", "r"]);
    let words = "no lemma on motions is for functions of which nothing is known";
    assert!(ended.code == 2 && ended.stderr.contains(words), "{ended:?}");
}

#[test]
fn a_condition_of_the_file_on_a_function_is_met_by_some_function_and_holds_for_every_claim() {
    let equations = |condition: &str| {
        let with = format!("free = [\"x\", \"y\"]\nconditions = [\"{condition}\"]");
        EQUATIONS.replace("free = [\"x\", \"y\"]", &with)
    };
    let claims = claim(1, "holds", "stable(P, s)", "") + &claim(2, "fails", "f'(K) > 0", "");
    let ended = Workplace::with_report(&equations("f'(V) > 0"), &claims, "Words.\n").run(["verify", "r"]);
    assert_eq!(ended.code, 0, "{ended:?}");
    let ended = Workplace::with_report(&equations("f(x)^2 < 0"), &claims, "Words.\n").run(["verify", "r"]);
    ended.expect_refusal(&["assumptions.conditions: none of 4096 points meets"]);
}

#[test]
fn units_of_a_function_are_those_of_its_value_and_of_its_argument() {
    let equations = |of: &str, force: &str| {
        format!(
            "[assumptions]\npositive = [\"K\", \"M\", \"V\", \"v\"]\nfree = [\"x\"]\n\
             [units]\nK = \"N/m\"\nM = \"kg\"\nV = \"m/s\"\nv = \"m/s\"\nx = \"m\"\n{force}\
             [[function]]\nname = \"f\"\n{of}\
             [[system]]\nname = \"slider\"\nstate = [\"x\", \"v\"]\nrates = [\"V - v\", \"(K*x - f(v))/M\"]\n\
             steady = [\"f(V)/K\", \"V\"]\n"
        )
    };
    let decided = |equations: &str, formula: &str| {
        Workplace::with_report(equations, &claim(1, "fails", formula, ""), "Words.\n").run(["verify", "r"])
    };
    let sound = equations("of = \"v\"\n", "f = \"N\"\n");
    let ended = decided(&sound, "f(V) + V*f'(V) > K*x");
    assert_eq!(ended.code, 0, "{ended:?}");
    for (formula, words) in [
        ("f(V) > V", "'f(V)' is kg m s^-2 and 'V' is m s^-1"),
        ("f'(V) > f(V)", "'f'(V)' is kg s^-1"),
        ("f(x) > 0", "the argument of f(x) is m, and must be m s^-1"),
    ] {
        let ended = decided(&sound, formula);
        assert!(ended.code == 2 && ended.stderr.contains(words), "{formula}: {ended:?}");
    }
    let ended = decided(&equations("", "f = \"N\"\n"), "f(V) > 0");
    ended.expect_refusal(&[
        "function f: the file states units: `of` names a variable with the unit of the argument",
    ]);
    decided(&equations("of = \"v\"\n", ""), "f(V) > 0").expect_refusal(&["units.f: missing"]);
    let ended = decided(&equations("of = \"x\"\n", "f = \"N\"\n"), "f(x) > 0");
    assert!(
        ended.code == 2 && ended.stderr.contains("the argument of f(V) is m s^-1, and must be m"),
        "{ended:?}"
    );
}
