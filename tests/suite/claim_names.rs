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

/// A report with these equations and claims, whose only chapter is this prose.
fn report(equations: &str, claims: &str, prose: &str) -> Workplace {
    let place = Workplace::new();
    place.write(
        "r/report.toml",
        "name = \"r\"\ntitle = \"R\"\nscenes = [\"a\"]\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n",
    );
    place.write("r/claims.toml", claims);
    place.write("r/equations.toml", equations);
    place.write("r/scenes/a.toml", "name = \"a\"\ntitle = \"A\"\n");
    place.write("r/prose/c.md", prose);
    place
}

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
    let place = report(EQUATIONS, &claims, "[[equation:3.2]]\n\n[[table:equations]]\n");
    place.run(["verify", "r"]).expect_success();
    let said = place.run(["verify", "r", "--claim", "X1"]).expect_success();
    assert!(said.contains("not-checked") && said.contains("Two blocks are outside this theory."), "{said}");
    place.run(["report", "r", "-o", "out"]).expect_success();
    let page = place.read("out/report.md");
    // The letters are those of the first paper: here they name nothing.
    assert!(!page.contains("Frequency (Q)") && page.contains("Of the 3 claims of the paper"), "{page}");
}

#[test]
fn a_claim_with_a_check_and_a_table_of_the_paper_ask_for_its_equations() {
    let place = report(EQUATIONS, &claim("S1", "holds", ""), "Words.\n");
    let refused = place.run(["verify", "r"]);
    refused.expect_refusal(&[
        "r/equations.toml: equation 9: is missing",
        "r/equations.toml: equation 3.2: is not an equation of the paper",
        "r/equations.toml: assumptions.positive: 'theta' must be positive",
    ]);
    for table in ["series", "hopf-coefficient"] {
        let place =
            report(EQUATIONS, &formula("S1", "holds", "K_cr = (B - A)/L"), &format!("[[table:{table}]]\n"));
        let fault = format!("the table `{table}` needs the equations of the paper: ");
        place.run(["report", "r", "-o", "out"]).expect_refusal(&[&fault, "equation 8: is missing"]);
    }
}

#[test]
fn a_claim_out_of_reach_has_no_formula_and_no_other_verdict() {
    let claims = claim("R1", "holds", "reason = \"r\"")
        + &claim("R2", "not-checked", "reason = \"r\"\nleaves_out = \"nothing\"\nformula = \"K_cr = 1\"");
    report(EQUATIONS, &claims, "Words.\n").run(["verify", "r"]).expect_refusal(&[
        "needs `expected = \"not-checked\"`",
        "reason = \"r\": needs no formula beside it",
    ]);
}

#[test]
fn equations_with_faults_are_refused_all_at_once() {
    let faulty = EQUATIONS
        .replace("\"A\", \"B\"", "\"A\", \"i\", \"2x\", \"B\"")
        .replace("number = \"mass\"", "number = \"3.2\"");
    let more = "[[equation]]\nnumber = \"a b\"\nequation = \"x = 1\"\n[[equation]]\nnumber = \"4\"\nequation = \"x = 1/(K - M)\"\n\
        [[equation]]\nnumber = \"5\"\nequation = \"x + 1\"\n";
    report(&(faulty + more), &formula("S1", "holds", "K_cr = 1"), "Words.\n")
        .run(["verify", "r"])
        .expect_refusal(&[
            "assumptions.positive: 'i' is no variable",
            "assumptions.positive: '2x' is not a name",
            "equation 3.2: occurs twice",
            "equation a b: a number has 1 to 40 characters",
            "equation 4: right side '1/(K - M)', column 3: 'K - M' may be zero",
            "equation 5: needs one '='",
        ]);
}
