//! Archives: everything a report rests on in one file that can be run again elsewhere.
//!
//! An archive is a set of named files ([`Files`]) in a zip container: the report's inputs, what was made from them, what is needed to
//! cite and to relicense them, their digests, and the same said for machines (RO-Crate, in-toto). The container has the same bytes for
//! the same files. Reading trusts nothing: names, sizes and digests are checked, and what is archived as a result is only ever
//! compared with new results. Nothing here opens files or computes a verdict.

mod bill_of_materials;
mod budget;
mod canonical;
mod codecheck;
mod compare;
mod container;
mod contents;
mod crate_metadata;
mod digests;
mod ledger_difference;
mod names;
mod readme;
mod reproduction;
mod statement;
mod unpack;
mod untrusted;

use std::collections::BTreeMap;

pub use budget::{Budget, Request, requests};
pub use codecheck::{CODECHECK_FILE, open_fields};
pub use container::{ReleaseTime, pack};
pub use contents::{
    Facts, INPUT_FOLDER, Parts, README_FILE, REPORT_FOLDER, SOURCES_FILE, STATEMENT_FILE, THEOREMS_FOLDER,
    VERSIONS_FILE, contents,
};
pub use digests::{DIGESTS_FILE, digest_faults, finished_hex, sha256_hex, sha256_of_reader};
pub use ledger_difference::ledger_differences;
pub use names::check_path;
pub use reproduction::{Maker, Reproduction, reproduction};
pub use unpack::{Caps, unpack};
pub use untrusted::shown;

/// Files by their path, `/` between the parts, in the order of the paths.
pub type Files = BTreeMap<String, Vec<u8>>;
