//! Limits, remarks and premises of claims with formulas, and claims of the first paper that a report lists by their id.

use crate::claim_formulas::{claim, report};

fn limited(outside: &str, given: &str) -> String {
    claim(1, "K_c rises with V_0", "given = [\"a < b\"]\n", "holds-within")
        + &format!(
            "limit = \"a < b only\"\noutside = {{ words = \"For a > b it falls.\", formula = \"{outside}\", given = [\"{given}\"] }}\n\
             remarks = [\"A remark.\"]\nrests_on = [\"C2\"]\n"
        )
        + &claim(2, "K_c_qs > 0", "given = [\"a < b\"]\n", "holds")
}

#[test]
fn a_formula_holds_within_its_limit_only_if_what_is_said_of_the_outside_is_true() {
    let place = report(&limited("K_c falls with V_0", "a > b"));
    let said = place.run(["verify", "r", "--claim", "C1"]).expect_success();
    for part in ["holds-within, exact", "a < b only", "For a > b it falls.", "A remark."] {
        assert!(said.contains(part), "{part} is not in:\n{said}");
    }
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    assert!(place.read("out/ledger.md").contains("- **Depends on:** [C2](#c2)"));
    let wrong = report(&limited("K_c rises with V_0", "a > b")).run(["verify", "r", "--claim", "C1"]);
    assert!(
        wrong.code == 1 && wrong.stderr.contains("C1: recorded holds-within, now not-checked"),
        "{}",
        wrong.stderr
    );
    let lone = claim(1, "K_c > 0", "given = [\"a < b\"]\n", "holds") + "limit = \"a < b\"\n";
    report(&lone).run(["report", "r"]).expect_refusal(&["needs `limit` and `outside` beside each other"]);
}
