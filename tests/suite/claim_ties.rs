//! A theorem written by hand is about the claim that it was tied to: an altered system or definition ends the tie, and `verify` says so.

use std::fs;
use std::path::Path;

use crate::harness::{Ended, Workplace};

const REPORT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/rice-ruina-1983");

/// `verify` on a copy of the report with some texts of its equations in the place of others, and the ledger.
fn verified(changes: &[(&str, &str)]) -> (Ended, String) {
    let place = Workplace::new();
    let copy =
        |path: &str| place.write(&format!("copy/{path}"), fs::read(Path::new(REPORT).join(path)).unwrap());
    ["report.toml", "claims.toml", "equations.toml"].into_iter().for_each(copy);
    for entry in fs::read_dir(Path::new(REPORT).join("prose")).unwrap() {
        copy(&format!("prose/{}", entry.unwrap().file_name().to_string_lossy()));
    }
    for (from, to) in changes {
        let text = place.read("copy/equations.toml");
        assert!(text.contains(from), "{from}");
        place.write("copy/equations.toml", text.replacen(from, to, 1));
    }
    let ended = place.run(["verify", "copy", "-o", "out"]);
    (ended, place.read("out/ledger.json"))
}

/// The strength of a claim.
fn strength(ledger: &str, id: &str) -> String {
    let ledger: serde_json::Value = serde_json::from_str(ledger).unwrap();
    let claims = ledger["claims"].as_array().unwrap();
    claims.iter().find(|claim| claim["id"] == id).unwrap()["strength"].as_str().unwrap().to_owned()
}

#[test]
fn a_theorem_on_another_system_or_definition_is_reported_as_drift() {
    let (sound, ledger) = verified(&[]);
    assert_eq!((sound.code, strength(&ledger, "R6").as_str()), (0, "kernel-checked"), "{}", sound.stderr);
    // A stable polynomial: R6 holds as before, and is about something else.
    let definitions = [
        ("is = \"characteristic(aging, s)\"", "is = \"s + V/L\""),
        ("is = \"characteristic(aging_massless, s)\"", "is = \"s + V/L\""),
    ];
    let (altered, ledger) = verified(&definitions);
    assert_eq!(altered.code, 1, "{}", altered.stderr);
    assert!(altered.stderr.contains("R6: the theorem is about other equations"), "{}", altered.stderr);
    assert_ne!(strength(&ledger, "R6"), "kernel-checked");
    // The same motion in another time.
    let system = [(
        "rates = [\"right_5\", \"right_6\", \"right_2\"]",
        "rates = [\"2*right_5\", \"2*right_6\", \"2*right_2\"]",
    )];
    let (altered, ledger) = verified(&system);
    assert_eq!(altered.code, 1, "{}", altered.stderr);
    assert!(altered.stderr.contains("R6: the theorem is about other equations"), "{}", altered.stderr);
    assert_ne!(strength(&ledger, "R6"), "kernel-checked");
    // R3 is about the slider without mass, and stays.
    assert!(!altered.stderr.contains("R3: "), "{}", altered.stderr);
    assert_eq!(strength(&ledger, "R3"), "kernel-checked");
}
