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
pub use compare::first_different_line;
pub use container::{ReleaseTime, pack};
pub use contents::contents;
pub use digests::{DIGESTS_FILE, digest_faults, finished_hex, sha256_hex, sha256_of_reader};
pub use ledger_difference::ledger_differences;
pub use names::check_path;
pub use reproduction::{Maker, Reproduction, reproduction};
pub use unpack::{Caps, unpack};
pub use untrusted::shown;

use crate::claims::Ledger;
use crate::scene::Paper;
use serde::{Deserialize, Serialize};

/// Files by their path, `/` between the parts, in the order of the paths.
pub type Files = BTreeMap<String, Vec<u8>>;

/// The folder with the report's inputs: what `slipmode report` reads.
pub const INPUT_FOLDER: &str = "input";
/// The folder with what was made from them.
pub const REPORT_FOLDER: &str = "report";
/// The folder with the theorems on the ledger's proofs, for Coq.
pub const THEOREMS_FOLDER: &str = "theorems";
/// The versions that computed it.
pub const VERSIONS_FILE: &str = "versions.json";
/// What is inside, and how each claim is checked again.
pub const README_FILE: &str = "README.md";
/// The unsigned in-toto statement.
pub const STATEMENT_FILE: &str = "provenance.intoto.json";
/// The program that proves certified cycles again without slipmode.
pub const CHECKER_FILE: &str = "certified_cycle.py";
/// The exact versions and digests of the packages that the program is built from.
pub const LOCK_FILE: &str = "Cargo.lock";
/// The sources of the program with all packages, from which it builds without a network.
pub const SOURCES_FILE: &str = "sources.tar.xz";

/// The files below a folder, each with its path, that within the folder, and its bytes.
pub fn below<'f>(
    files: &'f Files,
    folder: &'f str,
) -> impl Iterator<Item = (&'f String, &'f str, &'f Vec<u8>)> {
    let within = move |path: &'f str| path.strip_prefix(folder)?.strip_prefix('/');
    files.iter().filter_map(move |(path, bytes)| Some((path, within(path)?, bytes)))
}

/// What is known of the program that computed the report.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Versions")]
pub struct Facts {
    /// SHA-256 over the program's sources.
    pub source_sha256: String,
    /// Names and versions of the program and of the libraries it computes with.
    pub versions: BTreeMap<String, String>,
    /// The time that the archive states.
    #[serde(skip)]
    pub time: ReleaseTime,
}

impl Facts {
    /// The program's version.
    #[must_use]
    pub fn version(&self) -> &str {
        self.versions.get("slipmode").map_or("", String::as_str)
    }

    /// As `versions.json`.
    pub(crate) fn to_json(&self) -> String {
        format!("{:#}\n", serde_json::json!(self))
    }

    /// What the `versions.json` of an archive states, which nothing proves.
    ///
    /// # Errors
    /// When it is not what a build of this program writes.
    pub fn parse(json: &[u8], time: ReleaseTime) -> Result<Self, String> {
        let refuse = |why: &str| format!("{VERSIONS_FILE}: {why}");
        let stated: Self = serde_json::from_slice(json).map_err(|error| refuse(&error.to_string()))?;
        let facts = Self { time, ..stated };
        let is_of_a_word = |c: char| c.is_ascii_alphanumeric() || " .+-()".contains(c);
        let is_word = |text: &String| text.len() <= 100 && text.chars().all(is_of_a_word);
        if !facts.versions.contains_key("slipmode") {
            return Err(refuse("states no version of slipmode"));
        }
        let is_plain = facts.versions.iter().all(|(name, version)| is_word(name) && is_word(version));
        if digests::is_digest(&facts.source_sha256) && is_plain && facts.to_json().as_bytes() == json {
            Ok(facts)
        } else {
            Err(refuse("is not what a build of slipmode writes"))
        }
    }
}

/// What is archived.
#[derive(Debug)]
pub struct Parts<'p> {
    /// The report's name.
    pub name: &'p str,
    /// The report's title.
    pub title: &'p str,
    /// The report's inputs by their path in its folder.
    pub inputs: &'p Files,
    /// What was made from them, without anything that depends on the machine.
    pub product: &'p BTreeMap<String, String>,
    /// The verdicts.
    pub ledger: &'p Ledger,
    /// The theorems on the proofs of the ledger, and how Coq checks them, by their path in their folder.
    pub theorems: &'p BTreeMap<String, String>,
    /// The program.
    pub facts: &'p Facts,
    /// The file of [`SOURCES_FILE`], where the archive has one.
    pub sources: Option<&'p [u8]>,
    /// The paper, where the archive is prepared for a CODECHECK certificate.
    pub codecheck: Option<&'p Paper>,
}

impl<'p> Parts<'p> {
    /// The inputs that are files of certificates, by their header.
    pub(super) fn certificate_files(&self) -> impl Iterator<Item = (&'p str, &'p [u8])> {
        let is_named = |header: &[u8]| header.split(|byte| *byte == b',').any(|name| name == b"certificate");
        let files = self.inputs.iter().filter(|(path, _)| path.ends_with(".csv"));
        files
            .filter(move |(_, bytes)| bytes.split(|byte| *byte == b'\n').next().is_some_and(is_named))
            .map(|(path, bytes)| (path.as_str(), bytes.as_slice()))
    }
}
