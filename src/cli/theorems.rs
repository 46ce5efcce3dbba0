//! `slipmode theorems`: the published proofs of reports as files for Coq. `cargo xtask prove` has them checked.

use std::path::PathBuf;

use clap::Args;
use slipmode::scene::{Limits, library_proofs};
use slipmode::theorems::{Published, file_list, files, ties};
use slipmode_algebra::{Proof, Refutation};
use slipmode_theory::Role;

use crate::cli::diff::ledger;
use crate::cli::failure::Failure;
use crate::cli::folder::read_report;
use crate::cli::output::OutputFolder;

/// The list of the files of archives, with what they state.
const FILE_LIST: &str = "files.tsv";

/// The proofs that decide a box of parameters: on the areas, on K < K_c, and on thresholds of the frequency.
const OF_A_BOX: [&str; 6] = [
    "unstable-real-area-is-monotone",
    "upper-area-is-monotone",
    "unstable-side-is-monotone",
    "lower-area-by-a-path",
    "lower-area-between-two-corners",
    "frequency-threshold-is-crossed-once",
];

/// Options of `theorems`.
#[derive(Debug, Args)]
pub struct Options {
    /// Folders of reports with a published copy; a step of several ledgers becomes one theorem
    #[arg(value_name = "DIR", required = true)]
    reports: Vec<PathBuf>,
    /// The folder to write
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Writes the theorems of reports.
///
/// # Errors
/// When a report or its ledger cannot be read, or the folder cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let folder = OutputFolder::create(&options.out, &[])?;
    let published = options.reports.iter().map(|root| {
        let report = read_report(root, Limits::default())?;
        Ok(Published {
            name: root.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            ledger: ledger(&root.join("published/ledger.json"))?,
            claims: report.claims,
            equations: report.equations,
        })
    });
    let published = published.collect::<Result<Vec<_>, Failure>>()?;
    // What decides a slider with error bars is about the equations of the first report for which it goes through.
    let has_all = |report: &&Published| {
        report.equations.missing(&[Role::Characteristic]).is_empty()
            && OF_A_BOX.iter().all(|id| library_proofs().missing(id, &report.equations).is_empty())
    };
    let of_a_box = |report: &Published| -> Result<Vec<Proof>, Refutation> {
        OF_A_BOX.map(|id| library_proofs().prove(id, &report.equations)).into_iter().collect()
    };
    let mut tried = published.iter().filter(has_all).map(of_a_box);
    let first = tried.next().unwrap_or_else(|| Ok(Vec::new()));
    let found = first.or_else(|refutation| tried.find(Result::is_ok).unwrap_or(Err(refutation)));
    let of_a_box = found.map_err(|refutation| Failure::Refused(refutation.to_string()))?;
    let mut made = files(&published, ("error-bars", of_a_box)).map_err(Failure::Refused)?;
    made.insert(FILE_LIST.to_owned(), file_list(&published).map_err(Failure::Refused)?);
    let moved = ties(&published).map_err(Failure::Refused)?;
    made.extend(moved.into_iter().map(|(line, text)| (format!("ties/{line}.txt"), text)));
    folder.commit(&made)
}
