//! Equations of another paper: any numbers and names, and what may be claimed of them.

use crate::harness::Workplace;

/// Equations of another paper, in its own names.
const EQUATIONS: &str = r#"
[assumptions]
positive = ["A", "B", "L", "K", "M", "V"]
[[equation]]
number = "3.2"
equation = "K_cr = (B - A)/L"
[[equation]]
number = "mass"
equation = "K_m = K_cr*(1 + M*V^2/(A*L))"
"#;

fn claim(id: &str, expected: &str, rest: &str) -> String {
    format!("[[claim]]\nid = \"{id}\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"{expected}\"\n{rest}\n")
}

fn formula(id: &str, expected: &str, formula: &str) -> String {
    claim(id, expected, &format!("leaves_out = \"nothing\"\nformula = {formula:?}"))
}

#[test]
fn equations_of_another_paper_decide_claims_of_any_letter() {
    let claims = formula("Q1", "holds", "K_cr = (B - A)/L")
        + &formula("S1", "fails", "right_3_2 > 0")
        + &claim("X1", "not-checked", "reason = \"Two blocks are outside this theory.\"");
    let place = Workplace::with_report(EQUATIONS, &claims, "[[equation:3.2]]\n\n[[table:equations]]\n");
    place.run(["verify", "r"]).expect_warnings();
    let said = place.run(["verify", "r", "--claim", "X1"]).expect_success();
    assert!(said.contains("not-checked") && said.contains("Two blocks are outside this theory."), "{said}");
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    let page = place.read("out/ledger.md");
    // The letters are those of the first paper: here they name nothing.
    assert!(!page.contains("Frequency (Q)") && page.contains("Of the 3 claims of the paper"), "{page}");
}

#[test]
fn a_claim_with_a_check_and_a_table_of_the_paper_ask_for_its_equations() {
    let place = Workplace::with_report(EQUATIONS, &claim("B1", "holds", ""), "Words.\n");
    let refused = place.run(["verify", "r"]);
    refused.expect_refusal(&[
        "r/claims.toml: claim B1: there is no equation for the name `residual_8`",
        "r/claims.toml: claim B1: there is no equation for the name `right_9`",
    ]);
    for (table, role) in [("series", "quasi-static-upper"), ("hopf-coefficient", "friction")] {
        let place = Workplace::with_report(
            EQUATIONS,
            &formula("S1", "holds", "K_cr = (B - A)/L"),
            &format!("[[table:{table}]]\n"),
        );
        let fault = format!("the table `{table}` needs other equations: no equation has the role `");
        let missing = format!("no equation has the role `{role}`");
        place.run(["report", "r", "-o", "out"]).expect_refusal(&[&fault, &missing]);
    }
}

#[test]
fn a_claim_out_of_reach_has_no_formula_and_no_other_verdict() {
    let claims = claim("R1", "holds", "reason = \"r\"")
        + &claim("R2", "not-checked", "reason = \"r\"\nleaves_out = \"nothing\"\nformula = \"K_cr = 1\"");
    Workplace::with_report(EQUATIONS, &claims, "Words.\n").run(["verify", "r"]).expect_refusal(&[
        "needs `expected = \"not-checked\"`",
        "reason = \"r\": needs no formula beside it",
    ]);
}

#[test]
fn equations_with_faults_are_refused_all_at_once() {
    let faulty = EQUATIONS
        .replace("\"A\", \"B\"", "\"A\", \"i\", \"2x\", \"infinity\", \"B\"")
        .replace("number = \"mass\"", "number = \"3.2\"");
    let more = "[[equation]]\nnumber = \"a b\"\nequation = \"x = 1\"\n[[equation]]\nnumber = \"4\"\nequation = \"x = 1/(K - M)\"\n\
        [[equation]]\nnumber = \"5\"\nequation = \"x + 1\"\n";
    Workplace::with_report(&(faulty + more), &formula("S1", "holds", "K_cr = 1"), "Words.\n")
        .run(["verify", "r"])
        .expect_refusal(&[
            "assumptions.positive: 'i' is no variable",
            "assumptions.positive: '2x' is not a name: a name has 1 to 40 characters",
            "assumptions.positive: 'infinity' is not a name",
            "equation 3.2: occurs twice",
            "equation a b: a number has 1 to 40 characters",
            "equation 4: right side '1/(K - M)', column 3: 'K - M' may be zero",
            "equation 5: needs one '='",
        ]);
}

/// The slider with mass and a general law of one state, and what is derived of it.
const SLIDER: &str = r#"
[assumptions]
positive = ["A", "B", "L", "K", "M", "V", "v", "theta", "omega"]
free = ["x", "mu_0"]
[[system]]
name = "aging"
state = ["x", "v", "theta"]
rates = ["V - v", "(K*x - mu_0 - A*ln(v/V) - B*ln(V*theta/L))/M", "1 - v*theta/L"]
steady = ["mu_0/K", "V", "L/V"]
[[system]]
name = "slip"
state = ["x", "v", "theta"]
rates = ["V - v", "(K*x - mu_0 - A*ln(v/V) - B*ln(V*theta/L))/M", "-v*theta/L*ln(v*theta/L)"]
steady = ["mu_0/K", "V", "L/V"]
[[definition]]
name = "P"
is = "characteristic(aging, s)"
[[definition]]
name = "P_slip"
is = "characteristic(slip, s)"
[[definition]]
name = "H"
is = "hurwitz(P, s, 2)"
[[definition]]
name = "K_cr"
is = "solve(H, K)"
[[definition]]
name = "K_qs"
is = "limit(K_cr, M, 0)"
[[definition]]
name = "square"
is = "at(coefficient_1, K = K_cr)"
given = ["A < B"]
[[definition]]
name = "coefficient_1"
is = "coefficient(P, s, 1)"
[[definition]]
name = "w"
is = "solve(omega^2 - square, omega)"
[[definition]]
name = "rapid"
is = "limit(K_per_square, V, infinity)"
[[definition]]
name = "K_per_square"
is = "K_cr/V^2"
"#;

#[test]
fn claims_about_derived_names_are_decided_with_the_proofs_of_their_definitions() {
    let given = |condition: &str| format!("\ngiven = [\"{condition}\"]");
    let stated = |id: &str, verdict: &str, text: &str, given: &str| {
        claim(id, verdict, &format!("leaves_out = \"nothing\"\nformula = {text:?}{given}"))
    };
    let weakening = given("A < B");
    let claims = stated("R2", "holds", "K_qs = (B - A)/L", "")
        + &stated("R3", "holds", "w = V/L*sqrt((B - A)/A)", &weakening)
        + &stated("R4", "holds", "K_cr rises with M", &weakening)
        + &stated("R5", "fails", "square depends on M", &weakening)
        + &stated("R7", "holds", "P = P_slip", "")
        + &stated("R8", "fails", "K_cr = K_qs", &weakening)
        + &stated("R9", "holds", "rapid = M*(B - A)/(A*L^2)", "");
    let place = Workplace::with_report(SLIDER, &claims, "Words.\n");
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    for found in ledger["claims"].as_array().unwrap() {
        assert_eq!(found["verdict"], found["expected"], "{found:#}");
    }
    let proof = serde_json::to_string(&ledger["claims"][0]["evidence"][0]["proof"]).unwrap();
    for step in [
        "the rate of theta is zero at the steady state of aging",
        "determinant of s − J with the slopes J of aging",
        "put back for K, it gives zero",
        "its limit as M -> 0",
        "system aging",
    ] {
        assert!(proof.contains(step), "{step} is not in {proof}");
    }
}

#[test]
fn a_claim_states_what_its_definitions_are_given_for_and_the_conditions_of_the_file_hold_for_all() {
    let claims = formula("R3", "holds", "w > 0");
    Workplace::with_report(SLIDER, &claims, "Words.\n")
        .run(["verify", "r"])
        .expect_refusal(&["'w' is defined for B - A > 0 only: add this to `given`"]);
    let of_file = SLIDER.replace("free =", "conditions = [\"A < B\"]\nfree =");
    let place = Workplace::with_report(&of_file, &claims, "Words.\n");
    place.run(["verify", "r"]).expect_success();
    let said = place.run(["verify", "r", "--claim", "R3"]).expect_success();
    assert!(said.contains("A < B"), "{said}");
}

#[test]
fn definitions_and_systems_at_fault_are_named_by_file_and_key() {
    let more = "[[definition]]\nname = \"c\"\nis = \"2*c\"\n[[definition]]\nname = \"d\"\nis = \"solve(PP, K)\"\n\
        [[definition]]\nname = \"e\"\nis = \"coefficient(P, s)\"\n";
    let faulty = SLIDER.replace("\"1 - v*theta/L\"", "\"2 - v*theta/L\"") + more;
    Workplace::with_report(&faulty, &formula("R1", "holds", "K > 0"), "Words.\n").run(["verify", "r"]).expect_refusal(&[
        "r/equations.toml: definition c: is defined by itself: c -> c",
        "r/equations.toml: definition d: 'PP' is no variable and no defined name of equations.toml; did you mean `P`?",
        "r/equations.toml: definition e: `coefficient(P, s, n)` has 3 arguments, not 2",
        "r/equations.toml: system aging: the rate of theta is not zero at the steady state: 1",
    ]);
}

/// The units of the slider's variables.
const UNITS: &str = "[units]\nA = \"Pa\"\nB = \"Pa\"\nL = \"m\"\nK = \"Pa/m\"\nM = \"kg/m^2\"\nV = \"m/s\"\nv = \"m/s\"\n\
    theta = \"s\"\nomega = \"Hz\"\nx = \"m\"\nmu_0 = \"Pa\"\ns = \"1/s\"\n";

#[test]
fn units_of_equations_systems_definitions_and_formulas_are_checked() {
    let sound =
        format!("{UNITS}{SLIDER}\n[[equation]]\nnumber = \"1\"\nequation = \"F = K*L + A*ln(v/V)\"\n");
    let holds = formula("R1", "holds", "K_cr = K_qs*(1 + M*V^2/(A*L))")
        + &formula("R2", "holds", "F - A*ln(v/V) = K*L");
    Workplace::with_report(&sound, &holds, "Words.\n").run(["verify", "r"]).expect_success();
    let wrong = [
        formula("R1", "holds", "K_cr = B - A"),
        formula("R2", "holds", "K_cr -> B as M -> 0"),
        formula("R3", "holds", "P rises with K").replace("formula", "given = [\"K < B\"]\nformula"),
        formula("R4", "holds", "ln(K) + K > F"),
    ];
    Workplace::with_report(&sound, &wrong.concat(), "Words.\n").run(["verify", "r"]).expect_refusal(&[
        "'K_cr' is kg m^-2 s^-2 and 'B - A' is kg m^-1 s^-2",
        "'K_cr' is kg m^-2 s^-2 and 'B' is kg m^-1 s^-2",
        "'K' is kg m^-2 s^-2 and 'B' is kg m^-1 s^-2",
        "the argument of ln(K) is kg m^-2 s^-2, and must be 1",
    ]);
    let faulty = sound
        .replace("A = \"Pa\"", "A = \"mPa\"")
        .replace("mu_0 = \"Pa\"\n", "")
        .replace("omega = \"Hz\"", "omega = \"Hz\"\nomeg = \"Hz\"");
    Workplace::with_report(&faulty, &holds, "Words.\n").run(["verify", "r"]).expect_refusal(&[
        "r/equations.toml: units.A: 'mPa' is no unit",
        "r/equations.toml: units.mu_0: missing: every variable of the file has a unit",
        "r/equations.toml: units.omeg: 'omeg' is no variable",
    ]);
    let wrong = sound
        .replace("F = K*L", "F = K")
        .replace(
            "(K*x - mu_0 - A*ln(v/V) - B*ln(V*theta/L))/M\", \"-v",
            "(K*x - mu_0 - A*ln(v/V) - B*ln(V*theta/L))*M/M^2/V*V^2\", \"-v",
        )
        .replace("omega^2 - square", "omega - square")
        .replace("K_cr/V^2", "exchange(K_cr, M, L)");
    Workplace::with_report(&wrong, &holds, "Words.\n").run(["verify", "r"]).expect_refusal(&[
        "equation 1: in 'K + A*ln(v/V)', 'K' is kg m^-2 s^-2 and 'A*ln(v/V)' is kg m^-1 s^-2",
        "system slip: the rate",
        "definition w: in 'omega - square', 'omega' is s^-1 and 'square' is s^-2",
        "definition K_per_square: 'M' is kg m^-2 and 'L' is m",
    ]);
}

/// A slider with two state variables, in letters that the test exchanges. Its roots solve P s/R + Q = Σ B_i (s/R)/(L_i s/R + 1). On the
/// imaginary axis the real part of the right side is below S/T + U/W. So no root crosses the axis where Q is at least that large.
const TWO_STATES: &str = r#"
[assumptions]
positive = ["P", "Q", "R", "S", "T", "U", "W", "v", "th_1", "th_2"]
[[system]]
name = "two"
state = ["v", "th_1", "th_2"]
rates = ["v/P*(Q*(R - v) - S*(1/th_1 - v/T) - U*(1/th_2 - v/W))", "1 - v*th_1/T", "1 - v*th_2/W"]
steady = ["R", "T/R", "W/R"]
[[definition]]
name = "cubic"
is = "characteristic(two, s)"
"#;

#[test]
fn a_verdict_does_not_depend_on_the_names_of_variables() {
    const LETTERS: &str = "PQRSTUW";
    let claim = formula("A1", "holds", "stable(cubic, s)") + "given = [\"Q >= S/T + U/W\"]";
    let (heading, said_of_it) = claim.split_once("formula").unwrap();
    for shift in 0..LETTERS.len() {
        for step in [1, 2, 3] {
            let renamed = |text: &str| -> String {
                let name = |letter: char| match LETTERS.find(letter) {
                    Some(at) => char::from(LETTERS.as_bytes()[(at * step + shift) % LETTERS.len()]),
                    None => letter,
                };
                text.chars().map(name).collect()
            };
            let place = Workplace::new();
            let equations = renamed(TWO_STATES);
            place.write("claims.toml", format!("{equations}{heading}formula{}", renamed(said_of_it)));
            let said = place.run(["check", "claims.toml"]).expect_success();
            assert!(said.contains("A1   holds         exact"), "{equations}{said}");
        }
    }
}
