//! `theorems.md`: the theorems that Coq has accepted of each claim, as Coq states them and in words.

use std::collections::BTreeSet;

use crate::claims::{Entry, Ledger, Tie, definitions, statement, verdict_words, whole_statements};
use slipmode_plot::table::escape_markdown as plain;
use slipmode_theory::Equations;

/// The file's name.
pub(super) const THEOREMS_FILE: &str = "theorems.md";

/// The text of the file; none where Coq has accepted no theorem on a claim of the ledger.
pub(super) fn theorems(ledger: &Ledger, equations: &Equations) -> Option<String> {
    let sections: String = ledger.claims.iter().filter_map(|entry| section(entry, equations)).collect();
    let ties = ledger.claims.iter().filter_map(|entry| entry.tie(equations));
    let modules: BTreeSet<&str> =
        ties.flat_map(Tie::names).filter_map(|name| Some(name.split_once('.')?.0)).collect();
    let defined: String = modules.into_iter().map(module).collect();
    let definitions = if defined.is_empty() { String::new() } else { format!("\n## Definitions\n{defined}") };
    (!sections.is_empty()).then(|| format!("# Theorems\n\n{HEAD}{sections}{definitions}"))
}

const HEAD: &str = "Coq has accepted each of these theorems. A theorem named `formula_…` was written by the program from the formula \
                    before it. The others were written by hand; the sentences before them say what they state, and they stand with \
                    their variables, hypotheses and definitions at the end. The archive of the report has all proofs. `R` are the real \
                    numbers and `C` the complex ones. `fst` and `snd` are the real and the imaginary part. `horner [c0; c1; …] s` is \
                    c0 + c1 s + …. Of this polynomial `all_left` says that all complex roots lie left of the imaginary axis, `one_right` \
                    that one lies right of it, and `all_real` that none has an imaginary part.\n";

fn section(entry: &Entry, equations: &Equations) -> Option<String> {
    let generated = entry.stated.iter().flat_map(|stated| whole_statements(stated, equations)).map(|whole| {
        let colon = if whole.words.is_empty() { "" } else { ": " };
        let text = format!("Theorem {}{}.", whole.name, whole.statement);
        format!("\n{}{colon}{}\n{}", plain(whole.words), whole.formula.markdown(), coq(&text))
    });
    let by_hand = entry.tie(equations).map(|tie| {
        let stated = tie.names().filter_map(|name| {
            let module = name.split_once('.')?.0;
            Some(coq(&format!("(* {module}.v *)\n{}", statement(name)?)))
        });
        format!("\nBy hand: {}\n{}", plain(&tie.says), stated.collect::<String>())
    });
    let all: String = generated.chain(by_hand).collect();
    let (words, finding) = (plain(&entry.words), &entry.finding);
    let result = verdict_words(finding.verdict, finding.strength);
    (!all.is_empty()).then(|| format!("\n## {}\n\n{words} ({result})\n{all}", entry.id))
}

fn module(name: &str) -> String {
    format!("\n### {name}.v\n{}", coq(&definitions(name).join("\n")))
}

fn coq(text: &str) -> String {
    format!("\n```coq\n{text}\n```\n")
}
