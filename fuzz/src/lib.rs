//! What the fuzz targets call: the promises of the tests, and the CSV readers of the command line, compiled once more.

#[path = "../../tests/suite/promises.rs"]
pub mod promises;

#[path = "../../src/cli/csv_promises.rs"]
pub mod csv_promises;

// The part of `src/cli` that reads CSV; the program's own files, most of which nothing here uses.
#[allow(dead_code, unused_imports)]
mod cli;
