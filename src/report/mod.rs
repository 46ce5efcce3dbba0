//! Reports: a view of text in, one self-contained HTML page and one Markdown document out.
//!
//! Nothing here does arithmetic or reads files: numbers arrive formatted, figures arrive drawn, templates and fonts
//! are part of the program. The page asks for nothing over the network and needs no scripts.

mod error;
mod view;

pub use error::ReportError;
pub use view::{
    CardView, ChapterView, ClaimGroupView, ClaimView, EquationView, EvidenceView, FactView, FigureView,
    FindingView, InputView, ProvenanceView, ReportView, Standing,
};
