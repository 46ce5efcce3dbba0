//! What the Markdown templates ask for, field by field; names ending in `_md` are Markdown of our own.

use serde::Serialize;

use super::claim_text::ClaimText;

/// What `report.md` asks for.
#[derive(Serialize)]
pub(crate) struct ReportContext<'a> {
    pub title: &'a str,
    pub subtitle: &'a str,
    pub summary_md: String,
    pub cards: Vec<Card<'a>>,
    pub findings: Vec<Finding<'a>>,
    pub groups: Vec<Group<'a>>,
    pub picture_md: String,
    pub parts: Vec<Part<'a>>,
    pub appendix_md: String,
    pub provenance: Provenance,
    pub environment: Vec<Fact>,
}

/// A row of the verdicts table.
#[derive(Serialize)]
pub(crate) struct Card<'a> {
    pub symbol: &'static str,
    pub word: &'static str,
    pub count: &'a str,
    pub note: &'a str,
}

/// A finding that matters most.
#[derive(Serialize)]
pub(crate) struct Finding<'a> {
    pub headline: &'a str,
    pub text_md: String,
    pub claims_md: String,
}

/// A group of claims.
#[derive(Serialize)]
pub(crate) struct Group<'a> {
    pub title: &'a str,
    pub claims: Vec<ClaimText<'a>>,
    pub claims_md: Vec<String>,
}

/// Consecutive chapters of one part, or of none: then without title.
#[derive(Serialize)]
pub(crate) struct Part<'a> {
    pub title: &'static str,
    pub lead: &'static str,
    pub chapters: Vec<Chapter<'a>>,
}

/// A chapter.
#[derive(Serialize)]
pub(crate) struct Chapter<'a> {
    pub title: &'a str,
    pub body_md: String,
}

/// Inputs and how to repeat the work.
#[derive(Serialize)]
pub(crate) struct Provenance {
    pub text_md: String,
    pub command_md: String,
    pub inputs: Vec<Input>,
}

/// A row of a table of facts.
#[derive(Serialize)]
pub(crate) struct Fact {
    pub name_md: String,
    pub value_md: String,
}

/// A row of the table of inputs.
#[derive(Serialize)]
pub(crate) struct Input {
    pub path_md: String,
    pub bytes_md: String,
    pub sha256_md: String,
}
