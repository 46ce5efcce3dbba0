//! One claim of the ledger as the Markdown templates see it.

use serde_json::{Value, json};

use super::view::{ClaimView, EvidenceView, FactView, PartView, ReadingView};
use crate::scene::Source;
use slipmode_plot::table::{escape_cell, escape_markdown, printable};

/// What the templates show of a claim; its prose goes through `prose`.
pub(crate) fn claim_text(
    claim: &ClaimView,
    link: &dyn Fn(&str) -> String,
    prose: &dyn Fn(&str) -> String,
) -> Value {
    let rests_on = claim.rests_on.iter().map(|id| link(id)).collect::<Vec<_>>().join(", ");
    let item = |markdown: &str| line(&prose(markdown));
    json!({
        "id_md": escape_markdown(&claim.id),
        "link_md": link(&claim.id),
        "kind_md": item(&claim.kind_markdown),
        "decided_md": cell(&item(&claim.decided_markdown)),
        "cell_md": cell(&item(&claim.statement_markdown)),
        "is_of_paper": claim.source == Source::Paper,
        "place_md": escape_cell(&claim.place),
        "symbol": claim.verdict.symbol(),
        "word": claim.verdict.word(),
        "strength": claim.strength,
        "statement_md": item(&claim.statement_markdown),
        "acceptance_md": item(&claim.acceptance_markdown),
        "verdict_md": item(&claim.verdict_markdown),
        "readings": claim.readings.iter().map(|one| reading(one, &item)).collect::<Vec<_>>(),
        "evidence": claim.evidence.iter().map(|one| evidence(one, link, &item)).collect::<Vec<_>>(),
        "counter_example_md": item(&claim.counter_example_markdown),
        "not_established_md": item(&claim.not_established_markdown),
        "remark_md": item(&claim.remark_markdown),
        "rests_on_md": rests_on,
        "command_md": code_span(&claim.command),
    })
}

fn reading(reading: &ReadingView, item: &dyn Fn(&str) -> String) -> Value {
    let part = |part: &PartView| {
        json!({
            "words_md": item(&part.words_markdown),
            "formula_md": item(&part.formula_markdown),
            "symbol": part.verdict.symbol(),
            "word": part.verdict.word(),
            "strength": part.strength,
            "result_md": item(&part.result_markdown),
            "evidence": part.positions(),
        })
    };
    json!({
        "words_md": item(&reading.words_markdown),
        "symbol": reading.verdict.symbol(),
        "word": reading.verdict.word(),
        "strength": reading.strength,
        "parts": reading.parts.iter().map(part).collect::<Vec<_>>(),
    })
}

fn evidence(evidence: &EvidenceView, link: &dyn Fn(&str) -> String, item: &dyn Fn(&str) -> String) -> Value {
    let home = &evidence.certificate_at;
    let fact = |fact: &FactView| format!("{}: {}", escape_cell(&fact.name), escape_cell(&fact.value));
    let numbers = evidence.numbers.iter().map(fact).collect::<Vec<_>>().join("; ");
    json!({
        "kind": evidence.kind,
        "strength": evidence.strength,
        "text_md": item(&evidence.text_markdown),
        "numbers_md": if numbers.is_empty() { numbers } else { format!("({numbers})") },
        "certificate_md": code_block(&evidence.certificate),
        "certificate_at_md": if home.is_empty() { String::new() } else { link(home) },
    })
}

/// Prose on one line, so that it can stand in a list item.
pub(crate) fn line(markdown: &str) -> String {
    markdown.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A line of Markdown as one cell of a table: a `|` in it does not end the cell.
pub(crate) fn cell(line: &str) -> String {
    let mut cell = String::with_capacity(line.len());
    let mut escaped = false;
    for c in line.chars() {
        if c == '|' && !escaped {
            cell.push('\\');
        }
        cell.push(c);
        escaped = c == '\\' && !escaped;
    }
    cell
}

/// Plain text as Markdown: words between backticks are code, and everything else shows exactly its characters.
pub(crate) fn plain(text: &str) -> String {
    let escaped = escape_markdown(text);
    // Both have the same pieces, every second one between backticks.
    let pieces: Vec<(&str, &str)> = escaped.split("\\`").zip(text.split('`')).collect();
    let is_code = |(_, code): &(&str, &str)| !code.contains('|') && !code.trim().is_empty();
    if pieces.len().is_multiple_of(2) || !pieces.iter().skip(1).step_by(2).all(is_code) {
        return escaped;
    }
    let code = |pair: &[(&str, &str)]| pair.get(1).map_or_else(String::new, |(_, code)| code_span(code));
    pieces.chunks(2).map(|pair| pair[0].0.to_owned() + &code(pair)).collect()
}

/// Text as an inline code span that shows exactly these characters, on one line; empty for empty text.
pub(crate) fn code_span(text: &str) -> String {
    let one_line: String =
        text.chars().map(|c| if c == '\n' || c == '|' { ' ' } else { printable(c) }).collect();
    let fence = "`".repeat(longest_run(&one_line) + 1);
    let pad = if one_line.starts_with('`') || one_line.ends_with('`') { " " } else { "" };
    if one_line.trim().is_empty() { String::new() } else { format!("{fence}{pad}{one_line}{pad}{fence}") }
}

/// Text as a fenced block inside a list item; empty for empty text.
fn code_block(text: &str) -> String {
    if text.trim().is_empty() {
        return String::new();
    }
    let fence = "`".repeat((longest_run(text) + 1).max(3));
    let lines =
        text.trim_end().lines().map(|row| format!("  {}", row.chars().map(printable).collect::<String>()));
    format!("  {fence}text\n{}\n  {fence}", lines.collect::<Vec<_>>().join("\n"))
}

/// Length of the longest run of backticks.
fn longest_run(text: &str) -> usize {
    text.split(|c| c != '`').map(str::len).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_does_not_end_a_cell() {
        assert_eq!(cell(r"|s| = 1"), r"\|s\| = 1");
        assert_eq!(cell(r"\|s\| = \\\\|"), r"\|s\| = \\\\\|");
    }

    #[test]
    fn words_between_two_backticks_are_code_and_others_stay_text() {
        let mut prose = crate::report::markdown::Prose::default();
        for (text, html) in [
            (
                "a further condition in `given`, or `of`",
                "a further condition in <code>given</code>, or <code>of</code>",
            ),
            ("*x* with `a*b_c <i>`: *no*", "*x* with <code>a*b_c &lt;i&gt;</code>: *no*"),
            (r"`a\` and \`b`", r"<code>a\</code> and \<code>b</code>"),
            ("`a", "`a"),
            ("``a", "``a"),
            ("`|x|`", "`|x|`"),
            ("- `a`", "- <code>a</code>"),
        ] {
            assert_eq!(prose.inline(&plain(text), "here"), html);
        }
    }

    #[test]
    fn code_cannot_be_left() {
        assert_eq!(code_span("a ` b"), "``a ` b``");
        assert_eq!(code_span("`"), "`` ` ``");
        assert_eq!(code_span(""), "");
        assert_eq!(code_block("x\n```\n# y"), "  ````text\n  x\n  ```\n  # y\n  ````");
    }
}
