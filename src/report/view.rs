//! The view of a report: everything a page shows, as text.
//!
//! Fields called `*_markdown` hold Markdown with `$…$` mathematics (raw HTML is dropped, links are filtered); all
//! others are plain text that is escaped wherever it appears. Nothing here is computed from anything else here.

use serde::Serialize;

pub use crate::experiments::Figure as FigureView;
use crate::explorer::LiveMap;
use crate::scene::{Part, Source, Verdict};
use slipmode_plot::table::Table;

/// A whole report.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReportView {
    /// Name of the page.
    pub title: String,
    /// One line below the title: what was checked, against what.
    pub subtitle: String,
    /// Whose it is, of which day, and how to cite it.
    pub citation: CitationView,
    /// The answer, sentence by sentence.
    pub answer: Vec<AnswerView>,
    /// What would be true in the place of the sentences that fail, in the order in which it matters to a reader of the paper.
    pub changes: Vec<ChangeView>,
    /// The map on which a reader changes all values; none where no scene has a slider and a map.
    pub live: Option<LiveMap>,
    /// What was checked, how, and how to read the answer. A figure that it places stands beside the answer.
    pub summary_markdown: String,
    /// Counts of verdicts, in the order in which they are shown.
    pub cards: Vec<CardView>,
    /// Chapters; their prose places equations, figures and tables.
    pub chapters: Vec<ChapterView>,
    /// Groups of claims in the order of the ledger.
    pub ledger: Vec<ClaimGroupView>,
    /// The picture of which claims rest on which, shown with the ledger.
    pub claims_picture: Option<FigureView>,
    /// Equations that chapters and claims may place.
    pub equations: Vec<EquationView>,
    /// Figures; those that no chapter places are shown in an appendix.
    pub figures: Vec<FigureView>,
    /// Tables; those that no chapter places are shown in an appendix.
    pub tables: Vec<Table>,
    /// Where the numbers come from.
    pub provenance: ProvenanceView,
    /// Machine, versions, times: shown in a block of their own, outside what is compared. Empty for no block.
    pub environment: Vec<FactView>,
}

/// What a reader cites.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct CitationView {
    /// The authors of the report; may be empty.
    pub authors: String,
    /// The day of this edition; may be empty.
    pub date: String,
    /// The program with its version.
    pub program: String,
    /// A digest over the digests of all inputs.
    pub inputs_sha256: String,
    /// An entry for BibTeX.
    pub bibtex: String,
    /// The same as JSON of the Citation Style Language.
    pub csl: String,
}

/// A summary card: how many claims have one verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct CardView {
    /// Which verdict is counted.
    pub verdict: Verdict,
    /// How many, formatted.
    pub count: String,
    /// A few words below the count; may be empty.
    pub note: String,
}

/// A sentence of the answer.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AnswerView {
    /// The sentence.
    pub text_markdown: String,
    /// Ids of the claims it rests on; each must be in the ledger.
    pub claims: Vec<String>,
    /// Whether the claims stand below the sentence with their words.
    pub is_list: bool,
}

impl AnswerView {
    /// A sentence that rests on these claims.
    pub fn new<'i>(text_markdown: impl Into<String>, claims: impl IntoIterator<Item = &'i String>) -> Self {
        let claims = claims.into_iter().cloned().collect();
        Self { text_markdown: text_markdown.into(), claims, is_list: false }
    }
}

/// What would be true in the place of a sentence that fails.
#[derive(Debug, Clone, PartialEq)]
pub struct ChangeView {
    /// The claim; it must be in the ledger.
    pub claim: String,
    /// What is true instead.
    pub instead_markdown: String,
    /// What in the paper depends on the sentence.
    pub affects_markdown: String,
}

/// A chapter of prose.
#[derive(Debug, Clone, PartialEq)]
pub struct ChapterView {
    /// Deep link.
    pub id: String,
    /// Heading.
    pub title: String,
    /// The part that it belongs to; consecutive chapters of one part stand under its heading.
    pub part: Option<Part>,
    /// Prose. A line `[[figure:ID]]`, `[[table:ID]]`, `[[equation:ID]]` or `[[claim:ID]]` places that block; headings
    /// start at level 1 below the chapter's own.
    pub text_markdown: String,
}

/// Claims that belong together, such as those of one letter.
#[derive(Debug, Clone, PartialEq)]
pub struct ClaimGroupView {
    /// Heading, such as `Stability (S)`.
    pub title: String,
    /// Claims in order.
    pub claims: Vec<ClaimView>,
}

/// One claim of the ledger.
#[derive(Debug, Clone, PartialEq)]
pub struct ClaimView {
    /// Id, such as `R2`; the deep link is `claim-R2`.
    pub id: String,
    /// Place in the paper, such as `3.2, fig. 6`.
    pub place: String,
    /// Whose sentence it is.
    pub source: Source,
    /// What kind of sentence it is, with the words that make it so.
    pub kind_markdown: String,
    /// The claim in our words.
    pub statement_markdown: String,
    /// What had to be found for the claim to hold, stated before the result.
    pub acceptance_markdown: String,
    /// How it fared.
    pub verdict: Verdict,
    /// The limit within which it holds, or the reason why it fails or was not checked, in a few words; may be empty.
    pub verdict_markdown: String,
    /// kernel-checked, exact, argued, certified, converged or sampled; empty when not checked.
    pub strength: String,
    /// The ways to read the claim, each with its parts; empty where it has one reading of one part.
    pub readings: Vec<ReadingView>,
    /// What decides it, in one sentence.
    pub decided_markdown: String,
    /// What the verdict rests on.
    pub evidence: Vec<EvidenceView>,
    /// The counter-example, exact where it can be; empty when there is none.
    pub counter_example_markdown: String,
    /// What the verdict does not establish.
    pub not_established_markdown: String,
    /// Remarks: ambiguous words, captions that disagree, why it is not decided; may be empty.
    pub remark_markdown: String,
    /// Ids of claims that this one rests on.
    pub rests_on: Vec<String>,
    /// The command that decides this claim again.
    pub command: String,
}

/// One way to read a claim.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadingView {
    /// What the claim says in this reading.
    pub words_markdown: String,
    /// The verdict in this reading.
    pub verdict: Verdict,
    /// The strength of its weakest part.
    pub strength: String,
    /// Its parts.
    pub parts: Vec<PartView>,
}

/// A part of a reading.
#[derive(Debug, Clone, PartialEq)]
pub struct PartView {
    /// The statement.
    pub words_markdown: String,
    /// The statement as a formula with its conditions; may be empty.
    pub formula_markdown: String,
    /// Its verdict.
    pub verdict: Verdict,
    /// The strength of its weakest evidence.
    pub strength: String,
    /// Its limit or its counter-example; may be empty.
    pub result_markdown: String,
    /// Positions of its evidence in the claim's list, from 1.
    pub evidence: Vec<usize>,
}

impl PartView {
    /// The positions of its evidence as a text, such as `1, 3`.
    pub(crate) fn positions(&self) -> String {
        self.evidence.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
    }
}

/// One piece of evidence.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EvidenceView {
    /// `Proof`, `Enclosure` or `Simulation`.
    pub kind: String,
    /// kernel-checked, exact, argued, certified, converged or sampled.
    pub strength: String,
    /// What was done and found.
    pub text_markdown: String,
    /// Named numbers: error bounds, counts, digits.
    pub numbers: Vec<FactView>,
    /// A certificate or a series as plain text, set in a fixed-width block; empty where there is none, or where another claim has it.
    pub certificate: String,
    /// The same certificate line by line, with its formulas as mathematics.
    pub lines: Vec<ProofLineView>,
    /// The theorem that states what is proved and that Coq has accepted; empty for none.
    pub theorem: String,
    /// The other claim that has the certificate; may be empty.
    pub certificate_at: String,
}

/// A line of a proof.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ProofLineView {
    /// The number of its step; none for the statement of a lemma.
    pub number: Option<usize>,
    /// The step in words.
    pub words_markdown: String,
    /// Whether nothing but the words shows it.
    pub is_argued: bool,
    /// The fact that was checked.
    pub fact_markdown: String,
    /// Its conditions where they differ from those of the line before; may be empty.
    pub conditions_markdown: String,
}

/// A name and its value.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FactView {
    /// Name.
    pub name: String,
    /// Value, formatted.
    pub value: String,
}

/// An equation of the paper.
#[derive(Debug, Clone, PartialEq)]
pub struct EquationView {
    /// Number or name, such as `16`; the deep link is `eq-16`.
    pub id: String,
    /// What it says in a few words; may be empty.
    pub caption_markdown: String,
    /// The formula in LaTeX, without a number.
    pub latex: String,
}

/// Inputs and how to repeat the work.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ProvenanceView {
    /// How to repeat the report, sentence by sentence; may be empty.
    pub text_markdown: String,
    /// The command that makes this report.
    pub command: String,
    /// Files that went in.
    pub inputs: Vec<InputView>,
}

/// A file that went into the report.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InputView {
    /// Path relative to the report's folder.
    pub path: String,
    /// Size in bytes, formatted.
    pub bytes: String,
    /// SHA-256 in hexadecimal.
    pub sha256: String,
}
