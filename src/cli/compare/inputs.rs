//! The files that a comparison read, with their digests, for its page.

use std::collections::BTreeSet;
use std::path::Path;

use slipmode::archive::sha256_of_reader;
use slipmode::report::InputView;

use crate::cli::compare::rows::ComparedRow;
use crate::cli::failure::Failure;
use crate::cli::input::open_regular;

/// The runs file and the trajectories; standard input cannot be read a second time and has no digest.
///
/// # Errors
/// When a file cannot be read any more.
pub fn inputs(runs: &Path, rows: &[ComparedRow]) -> Result<Vec<InputView>, Failure> {
    let folder = runs.parent().unwrap_or(Path::new(""));
    let mut views = Vec::new();
    if runs.as_os_str() != "-" {
        views.push(view(runs, &runs.file_name().unwrap_or_default().to_string_lossy())?);
    }
    let trajectories: BTreeSet<&String> =
        rows.iter().filter_map(|row| row.read.trajectory.as_ref()).collect();
    for name in trajectories {
        views.push(view(&folder.join(name), name)?);
    }
    Ok(views)
}

fn view(path: &Path, name: &str) -> Result<InputView, Failure> {
    let digest = open_regular(path).and_then(sha256_of_reader);
    let (bytes, sha256) = digest.map_err(Failure::io(path, "cannot be read again"))?;
    Ok(InputView { path: name.into(), bytes: bytes.to_string(), sha256 })
}
