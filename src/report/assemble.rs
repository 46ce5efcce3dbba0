//! From findings, figures and tables to the view: words are put in place, nothing is computed.

use std::collections::BTreeMap;

use crate::claims::{Entry, Evidence, Ledger, Part, Reading, Strength, Verdict};
use crate::experiments::Figure;
use crate::report::claims_picture::claims_picture;
use crate::report::{
    CardView, ChapterView, ClaimGroupView, ClaimView, EquationView, EvidenceView, FactView, FindingView,
    InputView, PartView, ProvenanceView, ReadingView, ReportView,
};
use crate::scene::{Chapter, ReportPlan};
use slipmode_core::theory::PaperEquations;
use slipmode_plot::table::Table;

/// Everything that a report puts before its reader.
#[derive(Debug)]
pub struct Material<'m> {
    /// What the report is called and how it is divided.
    pub plan: &'m ReportPlan,
    /// The report's folder in the commands that make the page and its verdicts again.
    pub place: &'m str,
    /// Prose by file name.
    pub prose: &'m BTreeMap<String, String>,
    /// The paper's equations.
    pub equations: &'m PaperEquations,
    /// The verdicts.
    pub ledger: &'m Ledger,
    /// The figures.
    pub figures: Vec<Figure>,
    /// The tables.
    pub tables: Vec<Table>,
    /// The files that went in.
    pub inputs: Vec<InputView>,
    /// Versions, machine: shown apart and not compared.
    pub environment: Vec<FactView>,
}

/// The groups of the ledger, by the letter of the claims' ids.
const GROUPS: [(char, &str); 7] = [
    ('F', "Friction law (F)"),
    ('L', "Linearisation (L)"),
    ('S', "Stability transition (S)"),
    ('B', "Boundary of oscillation (B)"),
    ('Q', "Frequency (Q)"),
    ('N', "Numerical runs (N)"),
    ('Z', "Maps and criteria (Z)"),
];

/// How many findings stand on the first screen.
const SHOWN_FINDINGS: usize = 3;

/// The view of a report.
#[must_use]
pub fn assemble(material: Material) -> ReportView {
    let Material { plan, place, prose, equations, ledger, figures, tables, inputs, environment } = material;
    let mut chapters = plan.chapters.iter();
    let introduction = chapters.next();
    ReportView {
        title: plan.title.clone(),
        subtitle: introduction.map_or_else(String::new, |chapter| chapter.title.clone()),
        summary_markdown: introduction.map_or_else(String::new, |chapter| chapter_text(chapter, prose)),
        cards: cards(ledger),
        findings: findings(ledger),
        chapters: chapters.map(|chapter| chapter_view(chapter, prose)).collect(),
        ledger: groups(ledger, place),
        claims_picture: claims_picture(ledger),
        equations: equations
            .iter()
            .map(|equation| EquationView {
                id: equation.number.clone(),
                caption_markdown: equation.note.clone(),
                latex: equation.latex(),
            })
            .collect(),
        figures,
        tables,
        provenance: ProvenanceView {
            text_markdown: "All numbers on this page are computed from the files below. The command makes the same page again, byte for byte.".into(),
            command: format!("slipmode report {place}"),
            inputs,
        },
        environment,
    }
}

fn chapter_view(chapter: &Chapter, prose: &BTreeMap<String, String>) -> ChapterView {
    ChapterView {
        id: chapter.id.clone(),
        title: chapter.title.clone(),
        part: chapter.part,
        text_markdown: chapter_text(chapter, prose),
    }
}

fn chapter_text(chapter: &Chapter, prose: &BTreeMap<String, String>) -> String {
    prose.get(&chapter.prose).cloned().unwrap_or_default()
}

fn cards(ledger: &Ledger) -> Vec<CardView> {
    [
        (Verdict::Holds, "as stated"),
        (Verdict::HoldsWithin, "inside a quantified limit"),
        (Verdict::Fails, "with a counter-example"),
        (Verdict::NotChecked, "in this report"),
    ]
    .into_iter()
    .map(|(verdict, note)| CardView { verdict, count: ledger.count(verdict).to_string(), note: note.into() })
    .collect()
}

/// The claims that fail, then those with a counter-example outside their limit, in the order of the ledger.
fn findings(ledger: &Ledger) -> Vec<FindingView> {
    let with = |verdict: Verdict| ledger.claims.iter().filter(move |entry| entry.finding.verdict == verdict);
    with(Verdict::Fails)
        .chain(with(Verdict::HoldsWithin))
        .filter(|entry| entry.finding.counter_example.is_some())
        .take(SHOWN_FINDINGS)
        .map(|entry| FindingView {
            headline: format!(
                "{} {}: {}",
                entry.id,
                entry.finding.verdict.word(),
                entry.words.trim_end_matches('.')
            ),
            text_markdown: plain(entry.finding.counter_example.as_deref().unwrap_or_default()),
            claims: vec![entry.id.clone()],
        })
        .collect()
}

fn groups(ledger: &Ledger, place: &str) -> Vec<ClaimGroupView> {
    GROUPS
        .iter()
        .map(|(letter, title)| ClaimGroupView {
            title: (*title).into(),
            claims: ledger
                .claims
                .iter()
                .filter(|entry| entry.id.starts_with(*letter))
                .map(|entry| claim_view(entry, ledger, place))
                .collect(),
        })
        .filter(|group| !group.claims.is_empty())
        .collect()
}

fn claim_view(entry: &Entry, ledger: &Ledger, folder: &str) -> ClaimView {
    let finding = &entry.finding;
    let listed = |id: &&str| ledger.claims.iter().any(|other| other.id == *id);
    ClaimView {
        id: entry.id.clone(),
        place: entry.place.clone(),
        statement_markdown: plain(&entry.words),
        acceptance_markdown: plain(entry.criterion),
        verdict: finding.verdict,
        verdict_markdown: plain(finding.limit.as_deref().unwrap_or_default()),
        strength: strength_of(finding.verdict, finding.strength),
        readings: finding.readings.iter().map(reading_view).collect(),
        evidence: finding.evidence.iter().map(evidence_view).collect(),
        counter_example_markdown: plain(finding.counter_example.as_deref().unwrap_or_default()),
        not_established_markdown: plain(entry.not_established),
        remark_markdown: finding.remarks.iter().map(|remark| plain(remark)).collect::<Vec<_>>().join("\n\n"),
        rests_on: entry.rests_on.iter().filter(|id| listed(id)).map(|&id| id.to_owned()).collect(),
        command: format!("slipmode verify {folder} --claim {}", entry.id),
    }
}

/// The word for a strength; empty for what was not checked.
fn strength_of(verdict: Verdict, strength: Strength) -> String {
    if verdict == Verdict::NotChecked { String::new() } else { strength.as_str().into() }
}

fn reading_view(reading: &Reading) -> ReadingView {
    ReadingView {
        words_markdown: plain(&reading.words),
        verdict: reading.verdict,
        strength: strength_of(reading.verdict, reading.strength),
        parts: reading.parts.iter().map(part_view).collect(),
    }
}

fn part_view(part: &Part) -> PartView {
    PartView {
        words_markdown: plain(&part.words),
        verdict: part.verdict,
        strength: strength_of(part.verdict, part.strength),
        result_markdown: plain(part.result()),
        evidence: part.evidence.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
    }
}

fn evidence_view(evidence: &Evidence) -> EvidenceView {
    let strength = evidence.strength().as_str().to_owned();
    let fact = |name: &str, value: &str| FactView { name: name.into(), value: value.into() };
    match evidence {
        Evidence::Proof { proof } => EvidenceView {
            kind: "Proof".into(),
            strength,
            text_markdown: plain(&proof.statement),
            numbers: Vec::new(),
            certificate: proof.to_string(),
        },
        Evidence::Enclosure { quantity, value } => EvidenceView {
            kind: "Enclosure".into(),
            strength,
            text_markdown: String::new(),
            numbers: vec![fact(quantity, value)],
            certificate: String::new(),
        },
        Evidence::Simulation { quantity, value, error, runs } => EvidenceView {
            kind: "Simulation".into(),
            strength,
            text_markdown: String::new(),
            numbers: vec![
                fact(quantity, value),
                fact("largest error estimate", error),
                fact("runs", &runs.to_string()),
            ],
            certificate: String::new(),
        },
        Evidence::Sample { quantity, value, points } => EvidenceView {
            kind: "Sample".into(),
            strength,
            text_markdown: String::new(),
            numbers: vec![fact(quantity, value), fact("points checked", &points.to_string())],
            certificate: String::new(),
        },
    }
}

/// Plain words as Markdown: characters that Markdown or mathematics would take as markup are escaped.
fn plain(text: &str) -> String {
    slipmode_plot::table::escape_markdown(text)
}
