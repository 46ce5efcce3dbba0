//! What can be wrong with a view: every fault names the place.

use thiserror::Error;

/// Why a view cannot be rendered; each message names the chapter, claim or block.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ReportError {
    /// One or more faults in the view, all of them.
    #[error("{}", .0.join("\n"))]
    Faults(Vec<String>),
    /// A template does not fit the view: an error of this program.
    #[error("template {template}: {reason}")]
    Template {
        /// Name of the template.
        template: String,
        /// What the template engine says.
        reason: String,
    },
}
