//! Reports: a view of text in, one self-contained HTML page and one Markdown document out.
//!
//! Nothing here does arithmetic or reads files: numbers arrive formatted, figures arrive drawn, templates and fonts
//! are part of the program. The page makes no network requests. Its one script unpacks what is opened, sorts, finds and reads out; without
//! it, links lead to the files beside the page.

mod answer;
mod assemble;
mod blocks;
mod catalogue;
mod certificates;
mod changes;
mod citation;
mod claim_html;
mod claim_text;
mod claims_picture;
mod error;
mod explorer;
mod html;
mod junit;
mod markdown;
mod math;
mod packed;
mod page_style;
mod parts;
mod produce;
mod symbols;
mod templates;
#[cfg(test)]
mod tests;
mod text;
mod theorems;
mod view;

pub use error::ReportError;
pub use explorer::{ExplorerPage, render_explorer};
pub use html::render_html;
pub use junit::junit;
pub(crate) use markdown::formula_faults;
pub use produce::{Folder, Product, produce};
pub(crate) use produce::{decide, figure_and_table_files, produce_scene};
pub use text::{render_edition, render_markdown};
pub use view::{
    AnswerView, CardView, ChangeView, ChapterView, CitationView, ClaimGroupView, ClaimView, EquationView,
    EvidenceView, FactView, FigureView, InputView, PartView, ProofLineView, ProvenanceView, ReadingView,
    ReportView,
};

use slipmode_plot::table::Table;

/// A table with more rows is shown on the page and in the Markdown report by its first [`EXCERPT_ROWS`]; the CSV file has all.
pub const MAX_SHOWN_ROWS: usize = 24;

/// Rows shown of a table that is not shown whole.
pub const EXCERPT_ROWS: usize = 8;

/// Size to which the paper's page is held, in bytes.
pub const PAGE_BUDGET_BYTES: usize = 1 << 20;

const ENVIRONMENT_BEGIN: &str = "<!-- environment:begin -->";
const ENVIRONMENT_END: &str = "<!-- environment:end -->";

/// A page or Markdown report without its environment block: the part that has the same bytes on every machine.
pub(crate) fn without_environment(text: &str) -> String {
    let Some((before, rest)) = text.rsplit_once(ENVIRONMENT_BEGIN) else { return text.into() };
    let after = rest.split_once(ENVIRONMENT_END).map_or("", |(_, after)| after);
    format!("{}\n{}", before.trim_end(), after.trim_start())
}

/// How many rows of a table are shown.
fn shown_rows(table: &Table) -> usize {
    let rows = table.rows.len();
    if rows <= MAX_SHOWN_ROWS { rows } else { EXCERPT_ROWS }
}

/// What is written below a table that is not shown whole; empty for one that is.
fn cut_note(table: &Table) -> String {
    let rows = table.rows.len();
    if rows <= MAX_SHOWN_ROWS {
        return String::new();
    }
    format!(
        "The first {EXCERPT_ROWS} of {rows} rows, in the order of tables/{}.csv, which has all of them.",
        table.id
    )
}
