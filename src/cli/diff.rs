//! `slipmode diff`: two ledgers, or the ledgers of two archives, compared claim by claim.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;
use slipmode::archive::{REPORT_FOLDER, digest_faults, ledger_differences};

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::input::read_file_up_to;
use crate::cli::path_text::{json_path, shown_path};
use crate::cli::replay::open;
use crate::cli::terminal::count_of;

/// The most bytes that are read of a ledger.
const MOST_LEDGER_BYTES: u64 = 1 << 26;

/// Options of `diff`.
#[derive(Debug, Args)]
pub struct Options {
    /// A ledger.json or an archive
    #[arg(value_name = "A")]
    first: PathBuf,
    /// Another ledger.json or archive
    #[arg(value_name = "B")]
    second: PathBuf,
    /// One JSON object instead of text: the differences
    #[arg(long)]
    json: bool,
}

/// Compares two ledgers.
///
/// # Errors
/// When one cannot be read, or they differ.
pub fn run(options: &Options) -> Result<(), Failure> {
    let (first, second) = (ledger(&options.first)?, ledger(&options.second)?);
    let (one, other) = (shown_path(&options.first), shown_path(&options.second));
    let differences = ledger_differences(&first, &second, |old, new| old == new)
        .map_err(|fault| Failure::Refused(format!("{one}, {other}: {fault}")))?;
    let lines: String = differences.iter().map(|line| format!("{line}\n")).collect();
    Answer::to(json!({ "first": json_path(&options.first), "second": json_path(&options.second) }))
        .with("differences", &differences)
        .text(if differences.is_empty() { "no differences\n" } else { &lines })
        .print(options.json)?;
    let count = count_of(differences.len(), "difference");
    if differences.is_empty() { Ok(()) } else { Err(Failure::Check(count)) }
}

/// The ledger's bytes: of the file itself, or out of the archive that it is.
///
/// # Errors
/// When it cannot be read, or an archive holds none or is not as its digests state.
pub fn ledger(path: &Path) -> Result<Vec<u8>, Failure> {
    let bytes = read_file_up_to(path, MOST_LEDGER_BYTES)?;
    // Every zip file with an entry begins with these letters, and no JSON text does.
    if !bytes.starts_with(b"PK") {
        return Ok(bytes);
    }
    let inside = format!("{REPORT_FOLDER}/ledger.json");
    let mut files = open(path)?.files;
    let faults = digest_faults(&files);
    if !faults.is_empty() {
        return Err(Failure::place_lines(path, faults));
    }
    files.remove(&inside).ok_or_else(|| Failure::place(path, &format!("holds no {inside}")))
}
