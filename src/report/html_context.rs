//! What the page's templates ask for, field by field; names ending in `_html`, `_svg` and `_css` are markup of our own.

use serde::Serialize;

use super::claim_html::Chip;
use super::view::{FactView, InputView};
use slipmode_plot::table::{Cell, Column};

/// What `report.html` asks for.
#[derive(Serialize)]
pub(crate) struct PageContext<'a> {
    pub title: &'a str,
    pub subtitle: &'a str,
    pub policy: String,
    pub style_css: String,
    pub summary_html: String,
    pub cards: Vec<CardContext<'a>>,
    pub findings: Vec<FindingContext<'a>>,
    pub groups: Vec<GroupContext<'a>>,
    pub picture_html: String,
    pub parts: Vec<PartContext<'a>>,
    pub script_js: &'static str,
    pub appendix_html: String,
    pub provenance: ProvenanceContext<'a>,
    pub environment_html: String,
}

/// A summary card.
#[derive(Serialize)]
pub(crate) struct CardContext<'a> {
    pub class: &'static str,
    pub symbol: &'static str,
    pub word: &'static str,
    pub count: &'a str,
    pub note: &'a str,
}

/// A finding of the first screen.
#[derive(Serialize)]
pub(crate) struct FindingContext<'a> {
    pub headline: &'a str,
    pub text_html: String,
    pub chips: Vec<Chip<'a>>,
}

/// A group of claims.
#[derive(Serialize)]
pub(crate) struct GroupContext<'a> {
    pub anchor: String,
    pub title: &'a str,
    pub chips: Vec<Chip<'a>>,
    pub claims_html: Vec<String>,
}

/// Consecutive chapters of one part, or of none: then without title.
#[derive(Serialize)]
pub(crate) struct PartContext<'a> {
    pub anchor: &'static str,
    pub title: &'static str,
    pub lead: &'static str,
    pub chapters: Vec<ChapterContext<'a>>,
}

/// A chapter.
#[derive(Serialize)]
pub(crate) struct ChapterContext<'a> {
    pub id: &'a str,
    pub title: &'a str,
    pub body_html: String,
}

/// Inputs and how to repeat the work.
#[derive(Serialize)]
pub(crate) struct ProvenanceContext<'a> {
    pub text_html: String,
    pub command: &'a str,
    pub inputs: &'a [InputView],
}

/// What `figure.html` asks for.
#[derive(Serialize)]
pub(crate) struct FigureContext<'a> {
    pub id: &'a str,
    pub label: &'a str,
    pub drawing_svg: String,
    pub caption_html: String,
    pub data: &'a [String],
}

/// What `table.html` asks for.
#[derive(Serialize)]
pub(crate) struct TableContext<'a> {
    pub id: &'a str,
    pub title: &'a str,
    pub file: &'a str,
    pub texts: String,
    pub columns: &'a [Column],
    pub rows: &'a [Vec<Cell>],
    pub cut: String,
    pub note_html: String,
}

/// What `equation.html` asks for.
#[derive(Serialize)]
pub(crate) struct EquationContext<'a> {
    pub id: &'a str,
    pub formula_html: String,
    pub caption_html: String,
}

/// What `environment.html` asks for.
#[derive(Serialize)]
pub(crate) struct EnvironmentContext<'a> {
    pub facts: &'a [FactView],
}
