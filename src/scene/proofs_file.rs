//! `proofs/NAME.toml`: the proofs that a report states.

use std::sync::Arc;

use slipmode_theory::stated_proofs::{ProofsText, StatedProofs};

use crate::scene::Faults;
use crate::scene::claim_library::library_proofs;
use crate::scene::equations_file::{equation_fault, read_toml};

/// Reads one file of proofs.
///
/// # Errors
/// TOML that does not parse, and unknown keys.
pub fn read_proofs(file: &str, bytes: &[u8]) -> Result<ProofsText, Faults> {
    read_toml(file, bytes)
}

/// The proofs of all files of a folder, which share their names. Those of the first paper's report are the library's own, which were
/// reviewed with the program.
///
/// # Errors
/// All the faults at once.
pub fn join_proofs(folder: &str, files: Vec<ProofsText>) -> Result<Arc<StatedProofs>, Faults> {
    let proofs = StatedProofs::read(files).map_err(|faults| {
        faults.iter().map(|fault| equation_fault(folder, &fault.key, &fault.message)).collect::<Faults>()
    })?;
    let library = library_proofs();
    Ok(if proofs == **library { library.clone() } else { Arc::new(proofs) })
}
