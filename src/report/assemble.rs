//! From findings, figures and tables to the view: words are put in place, nothing is computed.

use std::collections::BTreeMap;

use crate::claims::{DecidedFor, Entry, Evidence, Ledger, Part, Reading, Strength, Verdict};
use crate::experiments::{Figure, Outcome, Scene};
use crate::explorer::{LiveMap, Window, live_map, points};
use crate::report::answer::answer;
use crate::report::blocks::{BlockKind, Piece, pieces};
use crate::report::certificates::Certificates;
use crate::report::changes::{changes, decided_by, looked_at};
use crate::report::citation::citation;
use crate::report::claim_text::{code_span, plain};
use crate::report::claims_picture::claims_picture;
use crate::report::math::check_size;
use crate::report::parts::words_of_source;
use crate::report::{
    CardView, ChapterView, ClaimGroupView, ClaimView, EquationView, EvidenceView, FactView, InputView,
    PartView, ProofLineView, ProvenanceView, ReadingView, ReportView,
};
use crate::scene::{Chapter, LogAxis, ReportPlan, Sentence, Source, StatedClaim};
use slipmode_algebra::{Certificate, Line, Notation};
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::Table;
use slipmode_theory::Equations;

/// Everything that a report puts before its reader.
#[derive(Debug)]
pub struct Material<'m> {
    /// What the report is called and how it is divided.
    pub plan: &'m ReportPlan,
    /// Prose by file name.
    pub prose: &'m BTreeMap<String, String>,
    /// The paper's equations.
    pub equations: &'m Equations,
    /// What was computed.
    pub outcome: &'m Outcome,
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

/// The view of a report.
pub(crate) fn assemble(material: Material) -> ReportView {
    let Material { plan, prose, equations, outcome, ledger, figures, tables, inputs, environment } = material;
    let mut chapters = plan.chapters.iter();
    let introduction = chapters.next();
    ReportView {
        title: plan.title.clone(),
        subtitle: introduction
            .filter(|chapter| chapter.title != plan.title)
            .map_or_else(String::new, |chapter| chapter.title.clone()),
        citation: citation(plan, &inputs),
        answer: answer(plan.question, ledger, outcome),
        live: live(outcome),
        summary_markdown: introduction.map_or_else(String::new, |chapter| chapter_text(chapter, prose)),
        changes: changes(ledger),
        cards: cards(ledger),
        chapters: chapters.map(|chapter| chapter_view(chapter, prose)).collect(),
        ledger: groups(ledger, &plan.folder),
        claims_picture: claims_picture(ledger),
        equations: equations
            .iter()
            .map(|equation| EquationView {
                id: equation.number.clone(),
                caption_markdown: equation.note.clone(),
                latex: equation.latex(),
            })
            .collect(),
        figures: numbered(figures, plan, prose),
        tables,
        provenance: ProvenanceView {
            text_markdown: "All numbers on this page are computed from the files below. The command makes the same page again, byte for byte.".into(),
            command: format!("slipmode report {}", plan.folder),
            inputs,
        },
        environment,
    }
}

/// The live map of the first scene with a slider and a map.
fn live(outcome: &Outcome) -> Option<LiveMap> {
    let of = |scene: &Scene| {
        let (parameters, map) = (scene.parameters.as_ref()?, scene.map.as_ref()?);
        let ends = |axis: &LogAxis| (nearest_f64(&axis.from), nearest_f64(&axis.to));
        let window = Window {
            velocity: ends(&map.rectangle.loading_velocity_m_per_s),
            stress: ends(&map.rectangle.normal_stress_pa),
        };
        let (points, _) = points(scene, parameters, None, window);
        live_map(parameters, &points, window, &scene.threshold())
    };
    outcome.scenes.iter().find_map(|computed| of(&computed.scene))
}

/// The figures in the order in which prose places them. A figure of the paper keeps the paper's number; the others are numbered R1,
/// R2 and so on.
fn numbered(mut figures: Vec<Figure>, plan: &ReportPlan, prose: &BTreeMap<String, String>) -> Vec<Figure> {
    let texts: Vec<String> = plan.chapters.iter().map(|chapter| chapter_text(chapter, prose)).collect();
    let placed: Vec<Piece> = texts.iter().flat_map(|text| pieces(text)).collect();
    let place = |figure: &Figure| {
        placed
            .iter()
            .position(|piece| matches!(piece, Piece::Block(BlockKind::Figure, id) if *id == figure.id))
    };
    figures.sort_by_key(place);
    let own = figures.iter_mut().filter(|figure| !figure.has_number_of_the_paper());
    own.zip(1_usize..).for_each(|(figure, number)| figure.label = format!("Figure R{number}"));
    figures
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

/// Counts of the paper's claims; none where a report has no paper.
fn cards(ledger: &Ledger) -> Vec<CardView> {
    if ledger.claims.iter().all(|entry| entry.sentence.source != Source::Paper) {
        return Vec::new();
    }
    [
        (Verdict::Fails, "with a counter-example"),
        (Verdict::HoldsWithin, "inside a quantified limit"),
        (Verdict::Holds, "as stated"),
        (Verdict::NotChecked, "in this report"),
    ]
    .into_iter()
    .map(|(verdict, note)| CardView {
        verdict,
        count: ledger.count(Source::Paper, verdict).to_string(),
        note: note.into(),
    })
    .collect()
}

fn groups(ledger: &Ledger, place: &str) -> Vec<ClaimGroupView> {
    let certificates = Certificates::of(ledger);
    let subjects = ledger.subjects();
    let view = |entry: &Entry| claim_view(entry, ledger, &certificates, place);
    let group = |title: &str, belongs: &dyn Fn(&Entry) -> bool| ClaimGroupView {
        title: title.into(),
        claims: ledger.claims.iter().filter(|entry| belongs(entry)).map(view).collect(),
    };
    let of_paper = |entry: &Entry| entry.sentence.source == Source::Paper;
    // Claims that a report states as formulas may have any letter.
    let title = if subjects.is_empty() { "Claims of the paper" } else { "Claims stated as formulas" };
    let unknown = group(title, &|entry| of_paper(entry) && entry.subject.is_none());
    let known = subjects
        .iter()
        .map(|subject| group(&subject.title, &|one| of_paper(one) && one.subject.as_ref() == Some(*subject)));
    let others = Source::ALL.into_iter().filter(|source| *source != Source::Paper);
    let others = others.map(|source| {
        let title = words_of_source(source).map_or("", |words| &words.title);
        group(title, &|entry| entry.sentence.source == source)
    });
    known.chain([unknown]).chain(others).filter(|group| !group.claims.is_empty()).collect()
}

/// The kind of a sentence, with the words that make it so.
fn kind_words(sentence: &Sentence) -> String {
    let kind = sentence.kind.as_str();
    if sentence.quote.is_empty() { kind.into() } else { format!("{kind} (“{}”)", plain(&sentence.quote)) }
}

/// Of a claim that is proved.
const FOR_ALL_VALUES: &str = "Error bars: the verdict holds for all values within them that meet the assumptions of the proofs. Numbers are those of the middle values.";
/// Of any other claim.
const FOR_MIDDLE_VALUES: &str =
    "Other values within the error bars: the verdict was decided for the middle values.";

/// What is not established: what the formulas leave out, with a sentence behind it. That they leave out nothing says something of a
/// verdict only.
fn not_established(entry: &Entry, sentence: Option<&str>) -> String {
    let left_out = plain(&entry.not_established);
    let is_nothing = left_out.trim_end_matches('.').eq_ignore_ascii_case("nothing");
    match sentence {
        _ if is_nothing && (sentence.is_some() || entry.finding.verdict == Verdict::NotChecked) => {
            sentence.unwrap_or_default().to_owned()
        }
        Some(sentence) if left_out.is_empty() => sentence.to_owned(),
        Some(sentence) => format!("{}. {sentence}", left_out.trim_end_matches('.')),
        None => left_out,
    }
}

fn claim_view(entry: &Entry, ledger: &Ledger, certificates: &Certificates<'_>, folder: &str) -> ClaimView {
    let finding = &entry.finding;
    let listed = |id: &&String| ledger.claims.iter().any(|other| other.id == **id);
    let [all, middle] = match entry.error_bars {
        Some(DecidedFor::AllValues) => [Some(FOR_ALL_VALUES), None],
        Some(DecidedFor::MiddleValues) => [None, Some(FOR_MIDDLE_VALUES)],
        None => [None, None],
    };
    let remarks = finding.remarks.iter().map(String::as_str).chain(all).map(plain);
    ClaimView {
        id: entry.id.clone(),
        place: entry.place.clone(),
        source: entry.sentence.source,
        kind_markdown: kind_words(&entry.sentence),
        decided_markdown: decided_by(entry),
        statement_markdown: plain(&entry.words),
        acceptance_markdown: acceptance(entry),
        verdict: finding.verdict,
        verdict_markdown: plain(finding.limit.as_deref().unwrap_or_default()),
        strength: strength_of(finding.strength),
        readings: readings(entry),
        evidence: finding.evidence.iter().map(|one| evidence_view(one, entry, certificates)).collect(),
        counter_example_markdown: plain(finding.counter_example.as_deref().unwrap_or_default()),
        not_established_markdown: not_established(entry, middle),
        remark_markdown: remarks.collect::<Vec<_>>().join("\n\n"),
        rests_on: entry.rests_on.iter().filter(|id| listed(id)).cloned().collect(),
        command: format!("slipmode verify {folder} --claim {}", entry.id),
    }
}

/// The word for a strength; empty for what was not checked.
fn strength_of(strength: Option<Strength>) -> String {
    strength.map_or("", Strength::as_str).into()
}

/// What has to be found: the formulas with their conditions, where formulas decide; several stand with their parts.
fn acceptance(entry: &Entry) -> String {
    let mut parts = entry.stated.iter().flat_map(StatedClaim::parts);
    let says_itself = entry.stated.as_ref().is_some_and(|stated| stated.criterion.is_some());
    match (parts.next(), parts.next()) {
        (None, _) => plain(&entry.criterion),
        _ if says_itself => plain(&entry.criterion),
        (Some((_, formula)), None) => formula.markdown(),
        _ => "all parts below hold".into(),
    }
}

fn readings(entry: &Entry) -> Vec<ReadingView> {
    let stated: Vec<_> = entry.stated.iter().flat_map(StatedClaim::parts).collect();
    // A procedure that decides a whole claim may find readings and parts of its own.
    let parts = entry.finding.readings.iter().map(|reading| reading.parts.len()).sum::<usize>();
    let is_stated = stated.len() == parts;
    let mut formulas = stated.iter().filter(|_| is_stated).map(|(_, formula)| formula.markdown());
    let mut part = |part: &Part| PartView {
        words_markdown: plain(&part.words),
        formula_markdown: formulas.next().unwrap_or_default(),
        verdict: part.verdict,
        strength: strength_of(part.strength),
        result_markdown: plain(part.result()),
        evidence: part.evidence.clone(),
    };
    let mut reading = |reading: &Reading| ReadingView {
        words_markdown: plain(&reading.words),
        verdict: reading.verdict,
        strength: strength_of(reading.strength),
        parts: reading.parts.iter().map(&mut part).collect(),
    };
    entry.finding.readings.iter().map(&mut reading).collect()
}

fn evidence_view(evidence: &Evidence, entry: &Entry, certificates: &Certificates<'_>) -> EvidenceView {
    let fact = |name: &str, value: &str| FactView { name: name.into(), value: value.into() };
    let numbers = |kind: &str, numbers: Vec<FactView>| EvidenceView {
        kind: kind.into(),
        strength: evidence.strength().as_str().into(),
        numbers,
        ..EvidenceView::default()
    };
    match evidence {
        Evidence::Proof { proof } => {
            let home = certificates.home(proof);
            let is_here = home == entry.id;
            EvidenceView {
                text_markdown: plain(&proof.statement),
                certificate: if is_here { certificates.text(proof) } else { String::new() },
                lines: if is_here { proof_lines(&certificates.lines(proof)) } else { Vec::new() },
                theorem: proof.theorem.clone().unwrap_or_default(),
                certificate_at: if is_here { "" } else { home }.into(),
                ..numbers("Proof", Vec::new())
            }
        }
        Evidence::Enclosure { quantity, value } => {
            numbers("Enclosure", vec![fact(&looked_at(quantity, entry), value)])
        }
        Evidence::Simulation { quantity, value, error, runs } => {
            let looked_at = fact(&looked_at(quantity, entry), value);
            let error = fact("largest error estimate", error);
            numbers("Simulation", vec![looked_at, error, fact("runs", &runs.to_string())])
        }
        Evidence::Sample { quantity, value, points } => {
            let looked_at = fact(&looked_at(quantity, entry), value);
            numbers("Sample", vec![looked_at, fact("points checked", &points.to_string())])
        }
    }
}

/// A proof for the page.
fn proof_lines(lines: &[Line<'_>]) -> Vec<ProofLineView> {
    let mut conditions = String::new();
    let mut view = |line: &Line<'_>| match line {
        Line::Lemma(words) => {
            ProofLineView { words_markdown: format!("Lemma: {}", plain(words)), ..Default::default() }
        }
        Line::Elsewhere { numbers, words } => {
            ProofLineView { number: Some(numbers[0]), words_markdown: plain(words), ..Default::default() }
        }
        Line::Step { number, step } => {
            let certificate = step.certificate.as_ref();
            let domain = certificate.and_then(Certificate::domain);
            let found = domain.map(|domain| set(|notation| domain.written(notation))).unwrap_or_default();
            let is_new = found != conditions;
            conditions = found;
            ProofLineView {
                number: Some(*number),
                words_markdown: plain(&step.says),
                is_argued: certificate.is_none(),
                fact_markdown: certificate.map(|one| set(|notation| one.fact(notation))).unwrap_or_default(),
                conditions_markdown: if is_new { conditions.clone() } else { String::new() },
            }
        }
    };
    lines.iter().map(&mut view).collect()
}

/// Mathematics where it can be set, and what the parser reads where a formula is too long for a page.
fn set(written: impl Fn(Notation) -> String) -> String {
    let latex = written(Notation::Latex);
    if latex.split('$').skip(1).step_by(2).all(|formula| check_size(formula).is_ok()) {
        latex
    } else {
        code_span(&written(Notation::Plain))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_our_own_are_numbered_in_the_order_of_the_prose() {
        let figure = |id: &str, label: &str| Figure {
            id: id.into(),
            label: label.into(),
            caption_markdown: String::new(),
            description: String::new(),
            svg: String::new(),
            data: Vec::new(),
        };
        let chapter =
            |file: &str| Chapter { id: file.into(), title: String::new(), prose: file.into(), part: None };
        let plan = ReportPlan {
            name: String::new(),
            folder: String::new(),
            title: String::new(),
            authors: Vec::new(),
            date: None,
            publish_page: true,
            question: crate::scene::Question::Claims,
            scenes: Vec::new(),
            proofs: Vec::new(),
            charts: Vec::new(),
            measured: None,
            paper: Default::default(),
            chapters: vec![chapter("one"), chapter("two")],
        };
        let prose = [("one", "[[figure:x]]\n[[figure:fig-3a]]"), ("two", "[[figure:times]]\n")];
        let prose = prose.map(|(file, text)| (file.to_owned(), text.to_owned())).into();
        let made = vec![figure("times", "Figure N1"), figure("fig-3a", "Figure 3a"), figure("x", "")];
        let labels: Vec<(String, String)> =
            numbered(made, &plan, &prose).into_iter().map(|figure| (figure.id, figure.label)).collect();
        let expected = [("x", "Figure R1"), ("fig-3a", "Figure 3a"), ("times", "Figure R2")];
        assert_eq!(labels, expected.map(|(id, label)| (id.to_owned(), label.to_owned())));
    }
}
