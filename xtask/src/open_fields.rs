//! `cargo xtask open-fields`: what only a person can state about the program and its paper, and has not stated yet.

use crate::failure::Failure;
use crate::process;
use crate::repository::{git, root};

/// Lists the open fields with file and line.
///
/// # Errors
/// When git cannot be run, or there is none.
pub fn run() -> Result<(), Failure> {
    let words = ["grep", "--line-number", "OPEN FIELD: ", "--", "metadata.toml", "paper.md", "paper.bib"];
    process::check(&mut git(&root(), &words))
}
