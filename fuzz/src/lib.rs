//! What the fuzz targets call: the promises of the tests, compiled once more.

#[path = "../../tests/suite/promises.rs"]
pub mod promises;

#[path = "../../tests/suite/csv_promises.rs"]
pub mod csv_promises;
