//! The result of a verification in the form of JUnit, which programs for continuous integration read.

use serde_json::{Value, json};

use super::ReportError;
use super::templates::Templates;
use crate::claims::{Entry, Ledger, Verdict, verdict_words};

/// A test for every claim, and one for every file that moved, with the name that its line in `moved` begins with.
///
/// A claim fails when something is said of it in `drift`, lines that begin with its id and a colon: that its verdict is not the recorded one. One
/// that is not checked, as recorded, is skipped. A verdict `fails` that is the recorded one passes: the claim is decided as before.
///
/// # Errors
/// When the template is at fault: an error of this program.
pub fn junit(ledger: &Ledger, drift: &[String], moved: &[String]) -> Result<String, ReportError> {
    let claims: Vec<Value> = ledger.claims.iter().map(|entry| claim(entry, drift)).collect();
    let files: Vec<Value> = match moved {
        [] => vec![json!({ "name": "every file is as published" })],
        moved => {
            moved.iter().map(|line| json!({ "name": line.split(':').next(), "failure": line })).collect()
        }
    };
    let count = |cases: &[Value], key: &str| {
        cases.iter().filter(|case| case.get(key).is_some_and(Value::is_string)).count()
    };
    let suite = |name: String, cases: Vec<Value>| json!({ "name": name, "failures": count(&cases, "failure"), "skipped": count(&cases, "skipped"), "cases": cases });
    let all: Vec<Value> = claims.iter().chain(&files).cloned().collect();
    let context = json!({
        "tests": all.len(),
        "failures": count(&all, "failure"),
        "skipped": count(&all, "skipped"),
        "suites": [
            suite(format!("{}: claims", ledger.report), claims),
            suite(format!("{}: published copy", ledger.report), files),
        ],
    });
    Templates::html()?.render("junit.xml", &context)
}

fn claim(entry: &Entry, drift: &[String]) -> Value {
    let finding = &entry.finding;
    let own = format!("{}: ", entry.id);
    let faults: Vec<&str> = drift.iter().filter_map(|line| line.strip_prefix(&own)).collect();
    let is_skipped = faults.is_empty() && finding.verdict == Verdict::NotChecked;
    json!({
        "name": format!("{} {}", entry.id, entry.words),
        "failure": (!faults.is_empty()).then(|| faults.join("; ")),
        "skipped": is_skipped.then(|| finding.verdict.as_str()),
        "said": verdict_words(finding.verdict, finding.strength),
    })
}
