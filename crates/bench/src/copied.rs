//! `cargo xtask timings`: what `bench --peers`, `cost` and `coverage` wrote becomes an input of the report on the paper, deliberately.
//!
//! The report never measures: `cargo xtask tables` computes what it shows from the rows of these files.

use std::fs;

use crate::times::FILES;
use crate::{measured_on, repository};

/// Copies every file that was measured; the others stay as they are, by name.
///
/// # Errors
/// When there is nothing to copy, or the report's folder cannot be written.
pub fn run() -> Result<(), String> {
    let place = repository::root().join("reports/im-avouac/timings");
    let mut copied = 0;
    for name in FILES {
        let from = measured_on::folder().join(name);
        if !from.is_file() {
            println!("crates/bench/results/{name} is not there: the report keeps the one it has");
            continue;
        }
        let failed = |error| format!("{}: {error}", place.join(name).display());
        fs::create_dir_all(&place).and_then(|()| fs::copy(&from, place.join(name))).map_err(failed)?;
        println!("copied: reports/im-avouac/timings/{name}");
        copied += 1;
    }
    if copied == 0 {
        return Err("measure first: `cargo xtask bench --peers`, `cargo xtask cost`".to_string());
    }
    Ok(())
}
