//! `slipmode check FILE.toml`: assumptions, equations and claims in one file, decided as `verify` decides those of a report.

use std::path::PathBuf;
use std::slice;

use clap::Args;
use serde_json::json;
use slipmode::claims::{Entry, Ledger, procedures};
use slipmode::experiments::{Context, Outcome};
use slipmode::scene::{ClaimEntry, Faults, read_equations_and_claims};
use slipmode_theory::Equations;

use crate::cli::answer::Answer;
use crate::cli::claim::{account, listed, print_warnings, problems};
use crate::cli::failure::Failure;
use crate::cli::folder::claim_faults;
use crate::cli::input::read_small_file;
use crate::cli::path_text::json_path;
use crate::cli::report::{claim_line, verdicts};

/// Options of `check`.
#[derive(Debug, Args)]
pub struct Options {
    /// The file, with the sections of equations.toml and claims.toml (docs/claims.md)
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,
    /// Decides only this claim, and prints the steps of its proofs
    #[arg(long, value_name = "ID")]
    claim: Option<String>,
    /// One JSON object instead of text: the claims as in ledger.json
    #[arg(long)]
    json: bool,
}

/// Decides the claims of one file and prints a line for each; writes nothing.
///
/// # Errors
/// Every fault of the file; and when a verdict is not the expected one or does not pass the last gate.
pub fn run(options: &Options) -> Result<(), Failure> {
    let (equations, claims) = read(options)?;
    let wanted = match &options.claim {
        Some(id) => slice::from_ref(listed("file", &claims, id)?),
        None => &claims[..],
    };
    let outcome = Outcome::default();
    let name = json_path(&options.file);
    let ledger = Ledger::decide(&name, wanted, &Context::new(&equations, &outcome));
    print_warnings(&ledger);
    let text = |entry: &Entry| if options.claim.is_some() { account(entry) } else { claim_line(entry) };
    let problems = problems(&ledger);
    Answer::to(json!({ "file": json_path(&options.file), "claim": options.claim }))
        .text(&ledger.claims.iter().map(text).collect::<String>())
        .and(verdicts(&ledger))
        .with("claims", &ledger.claims)
        .with("differences", &problems)
        .print(options.json)?;
    Failure::check_none(problems)
}

fn read(options: &Options) -> Result<(Equations, Vec<ClaimEntry>), Faults> {
    let bytes = read_small_file(&options.file).map_err(|fault| vec![fault])?;
    let file = json_path(&options.file);
    let (equations, claims) = read_equations_and_claims(&file, &bytes, &procedures())?;
    let faults = claim_faults(&file, &claims, Some(&equations));
    if faults.is_empty() { Ok((equations, claims)) } else { Err(faults) }
}
