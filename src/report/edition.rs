//! The reader's edition in Markdown: answer, sentences to change, verdicts with what decides them, and the paper's figures.

use super::text::Report;
use super::{ReportError, ReportView};

/// Renders what a reader needs in a quarter of an hour. The whole report is [`super::render_markdown`].
///
/// # Errors
/// Those of the whole report.
pub fn render_edition(view: &ReportView) -> Result<String, ReportError> {
    Report::rendered(view, "report.md", "ledger.md", |report| report.edition())
}
