//! How proofs are read, what they name, and the proofs of the paper's report.

use super::*;
use crate::equations::tests::paper;

/// The proofs of the paper's report.
pub(crate) fn library() -> StatedProofs {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../reports/im-avouac/proofs");
    let files = std::fs::read_dir(folder).expect("the folder").map(|entry| {
        let text = std::fs::read_to_string(entry.expect("an entry").path()).expect("a text");
        toml::from_str::<ProofsText>(&text).expect("TOML")
    });
    StatedProofs::read(files).expect("sound proofs")
}

fn read(text: &str) -> Result<StatedProofs, String> {
    let text = toml::from_str(text).map_err(|error| error.to_string())?;
    StatedProofs::read([text])
        .map_err(|faults| faults.iter().map(|fault| format!("{}: {}\n", fault.key, fault.message)).collect())
}

#[test]
fn a_proof_names_the_equations_that_it_reaches_and_is_refuted_by_wrong_ones() {
    let (all, equations) = (library(), paper());
    let id = "small-slip-distance";
    assert_eq!(all.reached(id, &equations), ["8", "17", "18"]);
    let proof = all.prove(id, &equations).expect("the paper's equations");
    assert_eq!(proof.steps[0].equations, ["8", "17"]);
    let wrong = equations.altered("17", "M/sigma*s^2 + 2*a/V_0*s + K/sigma = 0").expect("readable");
    let refuted = all.prove(id, &wrong).expect_err("another limit");
    assert_eq!(refuted.equations, ["8", "17"]);
}

#[test]
fn names_blocks_lemmas_and_domains_are_put_in() {
    let all = read(
        r#"
[let]
square = "(x + 1)^2"
slope = "derivative(square, x)"
[[domain]]
name = "x > 0"
positive = ["x"]
[[domain]]
name = "x > 1"
of = "x > 0"
given = ["x - 1 > 0"]
with = ["x = 1 + d where d = x - 1"]
example = ["x = 2"]
[[block]]
id = "square"
[[block.step]]
says = "written out"
identity = "square = x^2 + 2*x + 1"
[[proof]]
id = "lemma"
says = "The slope {slope} is positive."
over = "x > 0"
[[proof.step]]
says = "it is"
positive = "slope"
[[proof]]
id = "whole"
says = "All of it."
over = "x > 1"
[[proof.step]]
block = "square"
[[proof.step]]
lemma = "lemma"
[[proof.step]]
says = "above 4"
positive = "at(square - 4, x = x)"
"#,
    )
    .expect("sound");
    let proof = all.prove("whole", &paper()).expect("true");
    assert_eq!(proof.steps.len(), 3);
    assert_eq!(proof.steps[1].begins, ["The slope 2*(x + 1) is positive."]);
    assert!(proof.is_certified() && proof.recheck().is_ok());
}

#[test]
fn all_faults_of_a_file_are_told_at_once() {
    let text = r#"
[let]
one = "two + 1"
two = "one + 1"
left_9 = "x"
[[domain]]
name = "x"
given = ["x"]
with = ["x"]
[[proof]]
id = "p"
says = "P."
over = "y"
[[proof.step]]
says = "two kinds"
positive = "x"
negative = "x"
[[proof.step]]
identity = "x + 1"
[[proof.step]]
lemma = "q"
[[proof.step]]
says = "a limit"
limit = { of = "x", in = "x", to = "1", is = "0" }
[[proof]]
id = "p"
says = "No step."
"#;
    let faults = read(text).expect_err("faults");
    for part in [
        "let: the names go round in a circle: one -> two -> one",
        "let, left_9: it is no name that a proof can bring in",
        "domain x: a condition has one of",
        "domain x: 'x' is not of the form `x = value`",
        "proof p, step 1: it has 2 kinds",
        "proof p, step 2: 'x + 1' is not of the form `left = right`",
        "proof p, step 2: `says` is missing",
        "proof p, step 4: to = '1' (allowed: 0 or infinity)",
        "proof p: occurs twice",
        "proof p: it has no step",
    ] {
        assert!(faults.contains(part), "{part} is not in:\n{faults}");
    }
    assert!(read("[[proof]]\nid = \"p\"\nsaid = \"P.\"\n").expect_err("an unknown key").contains("said"));
}

#[test]
fn what_is_not_there_is_told_by_name() {
    let text = r#"
[[proof]]
id = "p"
says = "P."
over = "somewhere"
[[proof.step]]
lemma = "q"
[[proof.step]]
says = "a side"
positive = "right_99"
over = "none"
"#;
    let faults = read(text).expect_err("faults");
    assert!(faults.contains("proof p: there is no domain `somewhere`"), "{faults}");
    assert!(faults.contains("proof p: there is no block and no proof `q`"), "{faults}");
    let text = text.replace("over = \"somewhere\"\n", "").replace("[[proof.step]]\nlemma = \"q\"\n", "");
    let refused = read(&text).expect("sound").prove("p", &paper()).expect_err("no such equation");
    assert_eq!(refused.remainder, "there is no equation for the name `right_99`");
}

#[test]
fn what_rests_on_itself_is_refused() {
    let text = r#"
[let]
one = "two"
[[domain]]
name = "x"
of = "y"
[[domain]]
name = "y"
of = "x"
[[block]]
id = "b"
[[block.step]]
lemma = "p"
[[proof]]
id = "p"
says = "P."
let = { two = "one" }
[[proof.step]]
block = "b"
[[proof]]
id = "q"
says = "Q."
[[proof.step]]
lemma = "q"
[[proof]]
id = "sound"
says = "It uses one that is not."
[[proof.step]]
lemma = "q"
"#;
    let faults = read(text).expect_err("faults");
    for part in [
        "block b: it rests on itself: block b -> proof p -> block b",
        "domain y: it rests on itself: domain y -> domain x -> domain y",
        "proof p: it rests on itself: proof p -> block b -> proof p",
        "proof p: the names go round in a circle: one -> two -> one",
        "proof q: it rests on itself: proof q -> proof q",
    ] {
        assert!(faults.contains(part), "{part} is not in:\n{faults}");
    }
    assert!(!faults.contains("sound"), "{faults}");
}

#[test]
fn the_example_of_the_documentation_is_a_proof() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/claims-derivations.md");
    let text = std::fs::read_to_string(page).expect("the page");
    let start = text.find("```toml\n[let]\n").expect("the example") + "```toml\n".len();
    let example = &text[start..start + text[start..].find("```").expect("its end")];
    let proof = read(example).expect("sound").prove("frequency-bound", &paper()).expect("true");
    assert_eq!(proof.steps.len(), 2);
}

#[test]
fn a_sign_of_what_is_exactly_zero_ends_after_a_number_of_steps() {
    for (base, says, step) in [
        ("1", "S.", "root = { of = \"(F)*p + 1\", in = \"p\" }"),
        ("1", "S.", "positive = \"x*(F) + y\""),
        ("1", "S.", "limit = { of = \"x*(F)\", in = \"x\", to = \"infinity\", is = \"0\" }"),
        ("limit(x*y*F, y, infinity)", "It is {G}.", "argued = true"),
    ] {
        let text = format!(
            "[let]\nF = \"sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2)\"\nG = \"{base}\"\n[[domain]]\nname = \"d\"\n\
             positive = [\"x\", \"y\"]\n[[proof]]\nid = \"p\"\nsays = \"{says}\"\nover = \"d\"\n\
             [[proof.step]]\nsays = \"t\"\n{step}\n"
        );
        let refused = read(&text).expect("sound").prove("p", &paper()).expect_err("too much work");
        assert!(!refused.is_false && refused.remainder.contains("more than 6000000 steps"), "{refused}");
    }
}
