//! `slipmode check`: one file with equations and claims is decided as a report with the same equations and claims is.

use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use crate::harness::Workplace;
use crate::independent::compared;

const GALLERY: &str = include_str!("../../docs/gallery.md");
const BRUSSELATOR: &str = include_str!("../../examples/check/brusselator.toml");

/// The examples, by name.
fn examples() -> Vec<(String, String)> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/check"));
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let named = |path: &PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        (name, fs::read_to_string(path).unwrap())
    };
    files.iter().map(named).collect()
}

#[test]
fn every_example_is_decided_as_it_was_derived_by_hand() {
    let place = Workplace::new();
    let examples = examples();
    assert!(examples.len() >= 12);
    for (name, text) in &examples {
        assert!(GALLERY.contains(&format!("/{name}.toml)")), "docs/gallery.md does not show {name}.toml");
        // What cannot fail says nothing: each file has a statement that does.
        assert!(text.contains("By hand:") || text.contains("By hand, "), "{name}");
        assert!(text.contains("expected = \"holds\"") && text.contains("expected = \"fails\""), "{name}");
        let file = format!("{name}.toml");
        place.write(&file, text);
        let ended = place.run(["check", &file]);
        let only_warnings = ended.stderr.lines().all(|line| line.starts_with("warning: "));
        assert!(ended.code == 0 && only_warnings, "{name}: {}{}", ended.stdout, ended.stderr);
    }
}

#[test]
fn an_independent_program_contradicts_no_verdict_on_the_examples() {
    let place = Workplace::new();
    let folders: Vec<String> = examples()
        .iter()
        .map(|(name, text)| {
            place.write(&format!("{name}/equations.toml"), text);
            place.write(&format!("{name}/claims.toml"), text);
            place.path(name).to_str().unwrap().to_owned()
        })
        .collect();
    let arguments = ["--points", "20", "--quiet"].into_iter().chain(folders.iter().map(String::as_str));
    let Some(ended) = compared(&arguments.collect::<Vec<_>>()) else { return };
    assert!(ended.code == 0 && ended.stdout.contains(" 0 contradictions "), "{}", ended.stdout);
}

#[test]
fn a_line_has_the_verdict_and_what_it_rests_on() {
    let place = Workplace::new();
    place.write("b.toml", BRUSSELATOR);
    let said = place.run(["check", "b.toml"]).expect_success();
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines[0], "B1   holds         exact");
    assert_eq!(lines[3], "B4   fails         exact           at A = 1: its slope in A is 2");
    assert_eq!(lines[4], "4 claims: 3 hold, 0 hold within a limit, 1 fails, 0 not checked");
    let proof = place.run(["check", "b.toml", "--claim", "B2"]).expect_success();
    for part in
        ["verdict          holds, exact", "evidence         proof, checked again: formula-b2:", "\n  1. "]
    {
        assert!(proof.contains(part), "{part} is not in {proof}");
    }
    place
        .run(["check", "b.toml", "--claim", "B9"])
        .expect_refusal(&["--claim = B9", "the file lists no such claim"]);
    assert_eq!(place.names(), ["b.toml"], "nothing is written");
}

#[test]
fn another_verdict_than_the_expected_one_is_an_error() {
    let place = Workplace::new();
    place.write("b.toml", BRUSSELATOR.replace("expected = \"fails\"", "expected = \"holds\""));
    let ended = place.run(["check", "b.toml"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (1, "B4: recorded holds, now fails\n"));
    let last = "leaves_out = \"nothing\"\nformula = \"B_c falls with A\"";
    let open = BRUSSELATOR.replace(last, "reason = \"Nobody asked.\"");
    place.write("b.toml", open.replace("expected = \"fails\"", "expected = \"not-checked\""));
    let said = place.run(["check", "b.toml"]).expect_success();
    assert!(said.contains("B4   not-checked                   Nobody asked.\n"), "{said}");
}

#[test]
fn all_faults_of_both_halves_are_named_at_once() {
    let place = Workplace::new();
    let wrong = BRUSSELATOR
        .replace("[[system]]", "[[sistem]]")
        .replace("place = \"a wrong version\"", "plaice = \"a wrong version\"")
        .replace("is = \"1 + A^2\"", "is = \"1 + A^\"");
    place.write("b.toml", wrong);
    place.run(["check", "b.toml"]).expect_refusal(&[
        "b.toml:7: sistem: unknown key; did you mean `system`?",
        "claim[4].plaice: unknown key; did you mean `place`?",
        "claim[4].place: missing",
        "b.toml: definition B_c: ",
    ]);
    let unknown = BRUSSELATOR.replace("[assumptions]", "[assumptions]\nnegative = [\"C\"]");
    place.write("b.toml", unknown);
    place.run(["check", "b.toml"]).expect_refusal(&["b.toml:5: ", "unknown field `negative`"]);
    place.write("b.toml", "[[claim]\n");
    place.run(["check", "b.toml"]).expect_refusal(&["b.toml:1: not valid TOML"]);
    place.write("b.toml", "");
    place.run(["check", "b.toml"]).expect_refusal(&["missing field `assumptions`", "claim: missing"]);
    place.run(["check", "none.toml"]).expect_refusal(&["none.toml: cannot be read"]);
    let rows = BRUSSELATOR
        .replace("formula = \"B_c falls with A\"", "rows = \"no-table\"\nformula = \"for every row: x > 1\"");
    place.write("b.toml", rows);
    place.run(["check", "b.toml"]).expect_refusal(&["claim B4: formula", "there is no table `no-table`"]);
}

#[test]
fn a_message_says_that_a_name_of_another_equation_is_a_variable() {
    let place = Workplace::new();
    let file = |equation: &str, units: &str| {
        let first = "[[equation]]\nnumber = \"1\"\nequation = \"q = k + 1\"\n";
        format!(
            "[assumptions]\npositive = [\"k\"]\n{units}{first}[[equation]]\nnumber = \"2\"\nequation = \"{equation}\"\n[[claim]]\nid = \"A1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\nformula = \"q > 1\"\n"
        )
    };
    place.write("a.toml", file("w = sqrt(k + q)", ""));
    place.run(["check", "a.toml"]).expect_refusal(&[
        "equation 2: ",
        "(assumed: k > 0; q may be of either sign); `given` may exclude this",
    ]);
    place.write("a.toml", file("w = k + q", "[units]\nk = \"1\"\n"));
    place.run(["check", "a.toml"]).expect_refusal(&[
        "equation 2: 'q' has no unit: write the right side of equation 1 in its place, or use a [[definition]]",
    ]);
}

#[test]
fn the_object_has_the_claims_of_the_ledger() {
    let at = BRUSSELATOR.find("[[claim]]").unwrap();
    let place = Workplace::with_report(&BRUSSELATOR[..at], &BRUSSELATOR[at..], "Words.\n");
    place.write("b.toml", BRUSSELATOR);
    place.run(["verify", "r", "-o", "out"]).expect_success();
    let ledger: Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    let said: Value =
        serde_json::from_str(&place.run(["check", "b.toml", "--json"]).expect_success()).unwrap();
    assert_eq!(said["claims"], ledger["claims"]);
    assert_eq!((&said["schema"], &said["inputs"]["file"]), (&1.into(), &"b.toml".into()));
    assert_eq!((&said["verdicts"]["holds"], &said["differences"]), (&3.into(), &Value::Array(Vec::new())));
}

#[test]
fn the_report_on_another_subject_says_no_word_of_sliders() {
    let at = BRUSSELATOR.find("[[claim]]").unwrap();
    let place = Workplace::with_report(&BRUSSELATOR[..at], &BRUSSELATOR[at..], "Words.\n");
    place.run(["report", "r", "-o", "out"]).expect_success();
    let page = place.page("out/index.html");
    let body = page.split("</head>").nth(1).unwrap().split("<script").next().unwrap().to_owned();
    for text in [body, place.read("out/report.md"), place.read("out/ledger.md")] {
        for word in ["slider", "friction", "slip mode", "stick-slip", "sliding", "normal stress", "stiffness"]
        {
            assert!(!text.to_lowercase().contains(word), "{word} is in:\n{text:.2000}");
        }
    }
}
