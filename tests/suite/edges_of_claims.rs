//! Claims at the edges of what the rules decide, found by people who tried to make the program say something false: each has the verdict
//! that a reader can find by hand, or is refused.

use crate::harness::Workplace;

const EQUATIONS: &str = r#"
[assumptions]
positive = ["x", "y", "a", "V"]
free = ["p", "q"]
"#;

/// A claim on one formula with more keys.
fn claim(id: &str, formula: &str, more: &str) -> String {
    format!(
        "[[claim]]\nid = \"{id}\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\nformula = \"{formula}\"\n{more}\n"
    )
}

/// The lines that `check` prints on these claims.
fn checked(text: &str) -> String {
    let place = Workplace::new();
    place.write("c.toml", text);
    place.run(["check", "c.toml"]).stdout
}

/// Checks that each formula with its scope is decided so: by a verdict, by a verdict with its strength, or not at all.
fn decides(rows: &[(&str, &str, &str)]) {
    let claims =
        rows.iter().zip(1..).map(|((formula, more, _), number)| claim(&format!("C{number}"), formula, more));
    let said = checked(&(EQUATIONS.to_owned() + &claims.collect::<String>()));
    let lines: Vec<&str> = said.lines().filter(|line| line.starts_with('C')).collect();
    assert_eq!(lines.len(), rows.len(), "{said}");
    for (line, (formula, _, verdict)) in lines.iter().zip(rows) {
        let found: Vec<&str> = line.split_whitespace().skip(1).collect();
        let wanted: Vec<&str> = verdict.split_whitespace().collect();
        assert!(found.starts_with(&wanted), "{formula}: {line}, wanted: {verdict}");
    }
}

#[test]
fn a_limit_that_is_another_one_at_single_values_does_not_hold() {
    decides(&[
        ("x/(x + a) -> 0 as x -> 0", "", "holds exact"),
        ("x/(x + (p - q)^2) -> 0 as x -> 0", "", "not-checked"),
        ("x/(x + (p - 1/7)^2) -> 0 as x -> 0", "", "not-checked"),
        ("x/(x + p^2 + q^2) -> 0 as x -> 0", "", "not-checked"),
        ("x/(x + (p - q)^2)^2 -> 0 as x -> 0", "", "not-checked"),
        ("x/sqrt(x^2 + (p - q)^2) -> 0 as x -> 0", "", "not-checked"),
        ("cos(x/(x + (p - q)^2)) -> 1 as x -> 0", "", "not-checked"),
        ("x/(x + (p - q)^2) -> 0 as x -> 0", "given = [\"p > q\"]", "holds exact"),
    ]);
    let place = Workplace::new();
    for operation in ["limit", "series"] {
        let definition =
            format!("[[definition]]\nname = \"g\"\nis = \"{operation}(a/V + x/(x + (p - q)^2), x, 0)\"\n");
        place.write("c.toml", EQUATIONS.to_owned() + &definition + &claim("C1", "V*g = a", ""));
        place.run(["check", "c.toml"]).expect_refusal(&["definition g", "no certified limit"]);
    }
}

#[test]
fn a_refutation_by_rounded_numbers_is_certified_and_one_by_rational_numbers_exact() {
    let at = "at = { x = \"2\" }";
    decides(&[
        ("exp(x) > 7.38905609894", at, "fails certified"),
        ("exp(x) < 7.38905609894", at, "holds certified"),
        ("x^2 > 4", at, "fails exact"),
        ("x + y > 1", "", "fails exact"),
        ("exp(x) = 7", "", "fails certified"),
    ]);
}

#[test]
fn what_moves_has_no_value_and_no_single_one_that_is_sought() {
    let refused = |formula: &str, more: &str, says: &str| {
        let place = Workplace::new();
        place.write("c.toml", EQUATIONS.to_owned() + &claim("C1", formula, more));
        place.run(["check", "c.toml"]).expect_refusal(&[says]);
    };
    let there_is = "there_is = [\"p\"]\nwitness = { p = \"1\" }";
    for formula in ["p*x rises with x", "p*x does not depend on x", "p + x -> 1 as x -> 0"] {
        refused(formula, there_is, "`there_is` is for comparisons");
    }
    refused("x^2 rises with x", "at = { x = \"3\" }", "x moves, and `at` gives it a value");
}

#[test]
fn a_variable_that_an_equation_does_not_define_is_told() {
    let assumed = EQUATIONS.replace("\"x\",", "\"x\", \"K_c\",")
        + "[[equation]]\nnumber = \"1\"\nequation = \"K_c = p/x\"\n[[equation]]\nnumber = \"2\"\nequation = \"u = pm*x\"\n";
    let place = Workplace::new();
    let claims = claim("C1", "K_c > 0", "given = [\"p < 0\"]") + &claim("C2", "u^2 = x^2", "");
    place.write("c.toml", assumed + &claims);
    let said = place.run(["check", "c.toml"]);
    for part in [
        "K_c is a variable in 'K_c > 0': equation 1 does not define it",
        "u is a variable in 'u^2 = x^2': equation 2 does not define it",
    ] {
        assert!(
            (said.stdout.clone() + &said.stderr).contains(part),
            "{part} is not in:\n{}{}",
            said.stdout,
            said.stderr
        );
    }
}

#[test]
fn a_part_that_is_open_does_not_weaken_what_a_false_part_decides() {
    let parts = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"fails\"\nleaves_out = \"nothing\"\n\
        [[claim.part]]\nwords = \"false\"\nformula = \"x > y\"\n\
        [[claim.part]]\nwords = \"open\"\nformula = \"x^4 + y^4 + a^4 + 1 - 4*x*y*a + exp(x) > -1\"\n";
    let said = checked(&(EQUATIONS.to_owned() + parts));
    assert!(said.contains("fails         exact") && said.contains("false: at"), "{said}");
}

#[test]
fn claims_refer_to_claims_that_are_there() {
    let place = Workplace::new();
    let text = EQUATIONS.to_owned()
        + &claim("C1", "x > 0", "rests_on = [\"C2\"]\nsame_as = \"C2\"")
        + &claim("C2", "y > 0", "rests_on = [\"C1\", \"C9\"]\nsame_as = \"C1\"")
        + &claim("C3", "a > 0", "rests_on = [\"C3\"]\nsame_as = \"C3\"");
    place.write("c.toml", text);
    place.run(["check", "c.toml"]).expect_refusal(&[
        "claim C1: rests_on: needs claims that do not rest on this one",
        "claim C1: same_as: C2: needs the id of an earlier claim",
        "claim C2: rests_on: C9: needs the id of a claim",
        "claim C3: rests_on: needs claims that do not rest on this one",
        "claim C3: same_as: C3: needs the id of an earlier claim",
    ]);
    // A chain of premises that is too long is refused in time, forwards and backwards.
    let chain = |ids: Vec<u32>| {
        let claims = ids.into_iter().map(|id| match id {
            0 => claim("C0", "x > 0", ""),
            _ => claim(&format!("C{id}"), "x > 0", "")
                .replace("formula = \"x > 0\"", &format!("premises = [\"C{}\"]", id - 1)),
        });
        EQUATIONS.to_owned() + &claims.collect::<String>()
    };
    for ids in [(0..1500).collect::<Vec<_>>(), (0..1500).rev().collect()] {
        place.write("c.toml", chain(ids));
        place.run(["check", "c.toml"]).expect_refusal(&["at most 256 stand behind a claim"]);
    }
}

#[test]
fn a_limit_of_a_premise_limits_the_claim() {
    let within = "given = [\"x > y\"]\nlimit = \"x > y only\"\ndecided_for = \"the slip law\"\n\
        outside = { words = \"Else not.\", formula = \"x <= y\", given = [\"x <= y\"] }";
    let premises = |list: &str| claim("C1", "x > 0", "").replace("formula = \"x > 0\"", list);
    let text = EQUATIONS.to_owned()
        + &claim("C2", "x > y", within)
        + &claim("C3", "x > 0", "decided_for = \"one state\"")
        + &premises("premises = [\"C2\", \"C3\"]\ndecided_for = \"the slip law\"");
    let said = checked(&text);
    assert_eq!(said.matches("x > y only; the slip law").count(), 2, "{said}");
    assert!(said.contains("x > y only; the slip law; one state\n"), "{said}");
    let text = EQUATIONS.to_owned()
        + &claim("C1", "x > 0", "decided_for = \"the slip law\"")
        + &claim("C2", "x > 0", "").replace("formula = \"x > 0\"", "premises = [\"C1\"]");
    let said = checked(&text);
    assert!(
        said.lines().filter(|line| line.contains("holds-within") && line.contains("the slip law")).count()
            == 2,
        "{said}"
    );
}

#[test]
fn an_approximate_sentence_states_its_tolerance() {
    let approximate = "kind = \"approximate\"\nbox = { x = [\"1/100\", \"1/20\"] }";
    decides(&[("exp(x) < 1.1*(1 + x) and exp(x) > 0.9*(1 + x)", approximate, "holds")]);
    let place = Workplace::new();
    place.write("c.toml", EQUATIONS.to_owned() + &claim("C1", "exp(x) = 1 + x", approximate));
    place.run(["check", "c.toml"]).expect_refusal(&["c.toml:12", "kind", "an equation is decided exactly"]);
}

#[test]
fn a_wrong_witness_is_named_and_one_that_is_no_allowed_value_is_refused() {
    let witness =
        |name: &str, value: &str| format!("there_is = [\"{name}\"]\nwitness = {{ {name} = \"{value}\" }}");
    decides(&[
        ("x > 5", &witness("x", "1"), "holds exact"),
        ("x > 5", &witness("x", "6"), "holds exact"),
        ("p > 5", &witness("p", "-1"), "holds exact"),
        ("x > y", &witness("x", "y/2"), "not-checked"),
        ("x > y", &witness("x", "y + 1"), "holds exact"),
    ]);
    let place = Workplace::new();
    for (name, value, needle) in
        [("x", "x", "contains x"), ("p", "1 - p", "contains p"), ("x", "-1", "not positive")]
    {
        place.write(
            "c.toml",
            EQUATIONS.to_owned() + &claim("C1", &format!("{name} = 1"), &witness(name, value)),
        );
        place.run(["check", "c.toml"]).expect_refusal(&["c.toml:11", "the witness", needle]);
    }
}
