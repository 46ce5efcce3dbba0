//! `slipmode theorems`: the certified steps of ledgers as files for Coq. `cargo xtask prove` has them checked.

use std::path::PathBuf;

use clap::Args;
use slipmode::theorems::files;

use crate::cli::diff::ledger;
use crate::cli::failure::Failure;
use crate::cli::output::OutputFolder;

/// Options of `theorems`.
#[derive(Debug, Args)]
pub struct Options {
    /// A report's name and its ledger.json or archive, as NAME=PATH; a step of several ledgers becomes one theorem
    #[arg(value_name = "NAME=PATH", required = true)]
    ledgers: Vec<String>,
    /// The folder to write
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Writes the theorems of ledgers.
///
/// # Errors
/// When a ledger cannot be read, or the folder cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let folder = OutputFolder::create(&options.out)?;
    let mut ledgers = Vec::new();
    for given in &options.ledgers {
        let (name, path) = given
            .split_once('=')
            .ok_or_else(|| Failure::Refused(format!("{given}: expected a report's name, '=' and a path")))?;
        ledgers.push((name.to_owned(), ledger(path.as_ref())?));
    }
    folder.commit(&files(&ledgers).map_err(Failure::Refused)?)
}
