//! How to cite a report: BibTeX, and the JSON of the Citation Style Language.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::view::{CitationView, InputView};
use crate::scene::ReportPlan;

/// What the page says of its edition.
pub(super) fn citation(plan: &ReportPlan, inputs: &[InputView]) -> CitationView {
    let program = concat!("slipmode ", env!("CARGO_PKG_VERSION"));
    let inputs_sha256 = digest(inputs);
    let note = format!("Made by {program} from inputs with the SHA-256 {inputs_sha256}");
    CitationView {
        authors: plan.authors.join(", "),
        date: plan.date.clone().unwrap_or_default(),
        program: program.into(),
        bibtex: bibtex(plan, &note),
        csl: format!("{:#}", csl(plan, &note)),
        inputs_sha256,
    }
}

/// The SHA-256 of the lines that `sha256sum` prints of the inputs, in the order of their paths.
fn digest(inputs: &[InputView]) -> String {
    let lines: BTreeMap<&str, &str> =
        inputs.iter().map(|input| (input.path.as_str(), input.sha256.as_str())).collect();
    let text: String = lines.iter().map(|(path, sha256)| format!("{sha256}  {path}\n")).collect();
    Sha256::digest(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn bibtex(plan: &ReportPlan, note: &str) -> String {
    let authors: Vec<String> = plan.authors.iter().map(|name| format!("{{{}}}", in_bibtex(name))).collect();
    let year = plan.date.as_deref().map(|date| &date[..4]).unwrap_or_default();
    let month = plan.date.as_deref().map(|date| date[5..7].trim_start_matches('0')).unwrap_or_default();
    let fields = [
        ("author", authors.join(" and ")),
        ("title", format!("{{{}}}", in_bibtex(&plan.title))),
        ("year", year.into()),
        ("month", month.into()),
        ("note", in_bibtex(note)),
    ];
    let fields = fields.iter().filter(|(_, value)| !value.is_empty());
    let lines: String = fields.map(|(name, value)| format!("  {name} = {{{value}}},\n")).collect();
    format!("@misc{{{},\n{lines}}}", plan.name)
}

/// A text in which BibTeX and LaTeX find no commands.
fn in_bibtex(text: &str) -> String {
    let escaped = |c| match c {
        '\\' => "\\textbackslash ".into(),
        '{' | '}' => String::new(),
        '&' | '%' | '$' | '#' | '_' => format!("\\{c}"),
        '~' | '^' => format!("\\{c}\\relax "),
        _ => String::from(c),
    };
    text.chars().map(escaped).collect()
}

fn csl(plan: &ReportPlan, note: &str) -> Value {
    let mut item = json!({ "id": plan.name, "type": "report", "title": plan.title, "note": note });
    if !plan.authors.is_empty() {
        item["author"] = plan.authors.iter().map(|name| json!({ "literal": name })).collect();
    }
    if let Some(date) = &plan.date {
        let parts: Vec<u32> = date.split('-').filter_map(|part| part.parse().ok()).collect();
        item["issued"] = json!({ "date-parts": [parts] });
    }
    json!([item])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_citation_has_what_the_report_states_and_no_commands() {
        let text = "name = \"r\"\ntitle = \"50 % of a_b \\\\x\"\nauthors = [\"A. B.\", \"C & D\"]\ndate = \"2026-03-09\"\n\
                    [[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n";
        let plan = ReportPlan::parse("report.toml", text.as_bytes()).unwrap();
        let input = |path: &str| InputView { path: path.into(), bytes: "1".into(), sha256: "00".into() };
        let made = citation(&plan, &[input("b"), input("a")]);
        let head = "@misc{r,\n  author = {{A. B.} and {C \\& D}},\n  title = {{50 \\% of a\\_b \\textbackslash x}},\n  \
                    year = {2026},\n  month = {3},\n  note = {Made by slipmode ";
        assert!(made.bibtex.starts_with(head) && made.bibtex.ends_with("},\n}"), "{}", made.bibtex);
        let csl: Value = serde_json::from_str(&made.csl).unwrap();
        assert_eq!(csl[0]["issued"]["date-parts"], json!([[2026, 3, 9]]));
        assert_eq!(csl[0]["author"][1]["literal"], "C & D");
        assert_eq!(made.inputs_sha256, citation(&plan, &[input("a"), input("b")]).inputs_sha256);
        assert!(made.inputs_sha256.starts_with(DIGEST_OF_TWO_LINES), "{}", made.inputs_sha256);
    }

    /// Of `printf '00  a\n00  b\n' | sha256sum`.
    const DIGEST_OF_TWO_LINES: &str = "cbddfb0116d7c732";
}
