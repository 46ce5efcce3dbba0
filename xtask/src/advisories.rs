//! `cargo xtask advisories`: the locked packages against the RustSec database.
//!
//! The check needs the program `cargo-deny` and its database, which comes over the network. Where one of them is missing the check is
//! skipped with a message.

use std::process::Command;

use crate::failure::Failure;
use crate::process;

/// Checks every locked package.
///
/// # Errors
/// With exit code 1 when there is an advisory against a locked package.
pub fn run() -> Result<(), Failure> {
    if process::find_program("cargo-deny").is_none() {
        println!("advisories: skipped: no cargo-deny (cargo install cargo-deny)");
        return Ok(());
    }
    if process::status(&mut deny(&["fetch", "db"]))? != 0 {
        println!("advisories: skipped: the database cannot be fetched");
        return Ok(());
    }
    process::check(&mut deny(&["check", "--disable-fetch", "advisories"]))?;
    println!("advisories: none against the locked packages");
    Ok(())
}

fn deny(arguments: &[&str]) -> Command {
    process::cargo(&[&["deny", "--workspace", "--locked"], arguments].concat())
}
