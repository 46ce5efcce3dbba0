//! Claims that proofs of the report's own folder, other claims and procedures decide.

use crate::harness::Workplace;

const EQUATIONS: &str = r#"
[assumptions]
positive = ["A", "B", "K", "L", "M", "V"]

[[equation]]
number = "1"
equation = "K_cr = (B - A)/L"

[[equation]]
number = "2"
equation = "M*s^2 + (A - B)/V*s + K = 0"
"#;

const PROOFS: &str = r#"
[let]
friction = "coefficient(left_2, s, 1)"

[[domain]]
name = "strengthening"
positive = ["A", "B", "K", "L", "M", "V"]
given = ["A - B > 0"]
with = ["A = B + d where d = A - B"]
example = ["A = 2"]

[[proof]]
id = "friction-damps"
says = "The factor of s in eq 2 is {friction}, positive for A > B."
over = "strengthening"

[[proof.step]]
says = "it is positive"
positive = "friction"

[[proof]]
id = "stiffness-is-no-friction"
says = "The constant term of eq 2 is K, positive everywhere."
over = "strengthening"

[[proof.step]]
says = "the constant term"
identity = "at(left_2, s = 0) = K"
"#;

fn claim(id: &str, expected: &str, rest: &str) -> String {
    format!(
        "[[claim]]\nid = \"{id}\"\nplace = \"p\"\nwords = \"Words.\"\nexpected = \"{expected}\"\ncriterion = \"What must be.\"\nleaves_out = \"nothing\"\n{rest}\n"
    )
}

fn report(claims: &str, proofs: &str) -> Workplace {
    let place = Workplace::with_report(EQUATIONS, claims, "# Words\n\n[[claim:C1]]\n");
    let plan = place.read("r/report.toml");
    place.write("r/report.toml", format!("proofs = [\"own\"]\n{plan}"));
    place.write("r/proofs/own.toml", proofs);
    place
}

#[test]
fn a_claim_holds_by_the_proofs_of_its_own_folder_and_fails_when_an_equation_is_wrong() {
    let claims = claim("C1", "holds", "proofs = [\"friction-damps\"]\npremises = [\"C2\"]")
        + &claim("C2", "holds", "formula = \"K_cr <= 0\"\ngiven = [\"A >= B\"]");
    let place = report(&claims, PROOFS);
    let said = place.run(["verify", "r", "--claim", "C1"]).expect_success();
    for part in [
        "holds, argued",
        "the certified steps of a stated proof imply",
        "What must be.",
        "(A - B)/V, positive for A > B",
    ] {
        assert!(said.contains(part), "{part} is not in:\n{said}");
    }
    place.run(["report", "r", "-o", "out"]).expect_success();
    let ledger = place.read("out/ledger.md");
    assert!(ledger.contains("it is positive"), "{ledger}");
    place.run(["archive", "r", "-o", "r.tar.gz"]).expect_success();
    place.run(["replay", "r.tar.gz"]).expect_success();
    place.write("r/equations.toml", EQUATIONS.replace("(A - B)/V*s", "(B - A)/V*s"));
    let ended = place.run(["verify", "r", "--claim", "C1"]);
    assert!(ended.code == 1 && ended.stderr.contains("C1: recorded holds, now fails"), "{}", ended.stderr);
}

#[test]
fn a_proof_may_refute_a_claim() {
    let refuted = "proofs = [\"stiffness-is-no-friction\"]\ncounter_example = \"at s = 0 only K is left\"";
    let place = report(&claim("C1", "fails", refuted), PROOFS);
    let said = place.run(["verify", "r", "--claim", "C1"]).expect_success();
    assert!(said.contains("fails, argued") && said.contains("at s = 0 only K is left"), "{said}");
}

#[test]
fn faults_of_proofs_and_of_what_names_them_are_told_with_their_file() {
    let own = claim("C1", "holds", "proofs = [\"friction-damps\"]");
    report(&own.replace("friction-damps", "frictions-damp"), PROOFS)
        .run(["report", "r"])
        .expect_refusal(&["claims.toml", "there is no `frictions-damp`"]);
    report(&claim("C1", "holds", "premises = [\"C2\"]"), PROOFS)
        .run(["report", "r"])
        .expect_refusal(&["claims.toml", "claim C1: premises: C2"]);
    let circle = claim("C1", "holds", "premises = [\"C2\"]") + &claim("C2", "holds", "premises = [\"C1\"]");
    report(&circle, PROOFS).run(["report", "r"]).expect_refusal(&["C1: premises: C2", "C2: premises: C1"]);
    report(&own, &PROOFS.replace("positive = \"friction\"", "positive = \"friction +\""))
        .run(["report", "r"])
        .expect_refusal(&["r/proofs: proof friction-damps, step 1"]);
    report(&own, &PROOFS.replace("says = \"it is", "say = \"it is"))
        .run(["report", "r"])
        .expect_refusal(&["own.toml:", "say"]);
    report(&claim("C1", "holds", "check = \"error-serie\"\nof = [\"15\"]"), PROOFS)
        .run(["report", "r"])
        .expect_refusal(&["claims.toml", "check = \"error-serie\"", "did you mean `error-series`?"]);
    let both = claim("C1", "holds", "proofs = [\"friction-damps\"]\nformula = \"K_cr < 0\"");
    report(&both, PROOFS).run(["report", "r"]).expect_refusal(&["no formula beside it"]);
}

#[test]
fn a_procedure_finds_its_equations_by_their_roles() {
    let place = report(&claim("C1", "holds", "check = \"error-series\"\nof = [\"15\"]"), PROOFS);
    place.run(["report", "r"]).expect_refusal(&[
        "claim C1: of the `equations` for `error-series`, no equation has the role `characteristic`",
    ]);
}

#[test]
fn a_procedure_that_is_asked_about_something_unknown_decides_nothing() {
    let asked =
        "check = \"error-series\"\nof = [\"17\"]\nequations = [\"8\", \"15\", \"16\", \"18\", \"20\"]";
    let place = crate::claim_formulas::report(&claim("C1", "not-checked", asked));
    let said = place.run(["verify", "r", "--claim", "C1"]).expect_success();
    assert!(said.contains("not-checked"), "{said}");
}
