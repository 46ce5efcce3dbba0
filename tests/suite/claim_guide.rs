//! The pages on claims: docs/claims.md works as written, each form is decided as its example says, and the gallery shows what
//! `check` decides.

use serde_json::Value;

use crate::harness::Workplace;
use crate::readme::check_examples;

const GUIDE: &str = include_str!("../../docs/claims.md");
const FORMS: &str = include_str!("../../docs/claims-forms.md");
const GALLERY: &str = include_str!("../../docs/gallery.md");

#[test]
fn ten_minutes_with_claims_work_as_written() {
    let place = Workplace::new();
    check_examples(GUIDE, 7, &place);
    let claims = place.read("mine/claims.toml");
    let proof = place.run(["verify", "mine", "--claim", "C1"]).expect_warnings();
    assert!(proof.contains("\n  1. ") && proof.contains("= det(s - J), J = "), "{proof}");
    // Without its condition the second part fails, and the counter-example has B <= A.
    let open =
        claims.replacen("formula = \"K_c > K_cr\"\ngiven = [\"B > A\"]", "formula = \"K_c > K_cr\"", 1);
    assert_ne!(open, claims);
    place.write("mine/claims.toml", open);
    let ended = place.run(["verify", "mine", "--claim", "C1"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stdout.contains("left minus right is 0"), "{}", ended.stdout);
}

/// The cells of the rows of all tables whose last column is *verdict*, in pairs: example and verdict.
fn decided_rows() -> Vec<(&'static str, &'static str)> {
    let mut rows = Vec::new();
    for table in FORMS.split("\n\n").filter(|table| table.contains("| example | verdict |\n")) {
        for row in table.lines().filter(|line| line.starts_with("| `")) {
            let (rest, verdict) = row.strip_suffix(" |").unwrap().rsplit_once(" | ").unwrap();
            rows.push((rest.rsplit_once(" | ").unwrap().1.trim_matches('`'), verdict));
        }
    }
    rows
}

#[test]
fn every_form_is_decided_as_its_example_says() {
    let (_, equations) = GUIDE.split_once("This is `mine/equations.toml`:\n\n```toml\n").unwrap();
    let rows = decided_rows();
    assert_eq!(rows.len(), 15);
    let claim = |(number, (example, verdict)): (usize, &(&str, &str))| {
        format!(
            "{{ id = \"E{number}\", place = \"a form\", words = \"An example.\", expected = \"{verdict}\", leaves_out = \"nothing\", {example} }}"
        )
    };
    let claims: Vec<String> = (1..).zip(&rows).map(claim).collect();
    let text = format!("claim = [{}]\n{}", claims.join(", "), equations.split_once("```").unwrap().0);
    let place = Workplace::new();
    place.write("forms.toml", text);
    let ended = place.run(["check", "forms.toml"]);
    assert!(ended.code == 0, "{}{}", ended.stdout, ended.stderr);
}

/// What the gallery has to show of a claim, as `check` decides it.
fn entry(file: &str, id: &str) -> String {
    let path = format!("{}/examples/check/{file}.toml", env!("CARGO_MANIFEST_DIR"));
    let said = Workplace::new().run(["check", &path, "--claim", id, "--json"]);
    let said: Value = serde_json::from_str(&said.stdout).unwrap();
    let claim = &said["claims"][0];
    let text = |key: &str| claim[key].as_str().unwrap_or_default().trim_end_matches('.').to_owned();
    let formula =
        if text("criterion").is_empty() { String::new() } else { format!("`{}`: ", text("criterion")) };
    let reason = [text("counter_example"), text("limit")].into_iter().find(|it| !it.is_empty());
    let reason = reason.map_or_else(String::new, |reason| format!(" {reason}"));
    format!("{}.\n\n{formula}**{}, {}**{reason}.\n", text("words"), text("verdict"), text("strength"))
}

#[test]
fn the_gallery_shows_what_check_decides() {
    let entries: Vec<&str> = GALLERY.split("\n## ").skip(1).collect();
    assert_eq!(entries.len(), 12);
    for shown in entries {
        let (heading, rest) = shown.split_once("\n\n[").unwrap();
        let (link, body) = rest.split_once("\n\n").unwrap();
        let (file, id) = link.split_once(".toml").unwrap();
        let id = id.trim_start_matches(", ").split(']').next().unwrap();
        let expected = entry(file, id);
        assert!(body.starts_with(&expected), "{heading}: {body}: {expected}");
    }
}
