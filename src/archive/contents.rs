//! What an archive holds: inputs, results, and what is needed to run, cite, relicense and check them.

use std::collections::BTreeMap;

use serde_json::json;

use crate::claims::Ledger;

use super::crate_metadata::{CRATE_FILE, crate_metadata};
use super::digests::{DIGESTS_FILE, list};
use super::readme::readme;
use super::statement::statement;
use super::{Files, ReleaseTime};

/// The folder with the report's inputs: what `slipmode report` reads.
pub const INPUT_FOLDER: &str = "input";
/// The folder with what was made from them.
pub const REPORT_FOLDER: &str = "report";
/// The versions that computed it.
pub const VERSIONS_FILE: &str = "versions.json";
/// What is inside, and how each claim is checked again.
pub const README_FILE: &str = "README.md";
/// The unsigned in-toto statement.
pub const STATEMENT_FILE: &str = "provenance.intoto.json";

const CARGO_LOCK: &str = include_str!("../../Cargo.lock");
const CITATION: &str = include_str!("../../CITATION.cff");
const LICENSE_MIT: &str = include_str!("../../LICENSE-MIT");
const LICENSE_APACHE: &str = include_str!("../../LICENSE-APACHE");
const NOTICE: &str = "\
# Licences

The files of this archive were made by slipmode, whose own code is licensed under MIT or Apache-2.0, at your option; both texts are next to this file.
A binary of slipmode also contains rug, GMP, MPFR and MPC, which are under the GNU LGPL, version 3 or later (GMP also under the GNU GPL, version 2 or later).
This archive contains no binary; `Cargo.lock` names their exact versions and digests.
";

/// What is known of the program that computed the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Facts {
    /// The program's version.
    pub version: String,
    /// Names and versions of the program and of the libraries it computes with.
    pub versions: BTreeMap<String, String>,
    /// SHA-256 over the program's sources.
    pub source_sha256: String,
    /// The time that the archive states.
    pub time: ReleaseTime,
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
    /// The program.
    pub facts: &'p Facts,
}

/// All files of the archive of a report.
#[must_use]
pub fn contents(parts: &Parts<'_>) -> Files {
    let mut files = Files::new();
    files.extend(parts.inputs.iter().map(|(path, bytes)| (format!("{INPUT_FOLDER}/{path}"), bytes.clone())));
    let product = parts.product.iter();
    files.extend(product.map(|(path, text)| (format!("{REPORT_FOLDER}/{path}"), text.clone().into_bytes())));
    let texts = [
        ("Cargo.lock", CARGO_LOCK),
        ("CITATION.cff", CITATION),
        ("LICENSE-MIT", LICENSE_MIT),
        ("LICENSE-APACHE", LICENSE_APACHE),
        ("NOTICE.md", NOTICE),
    ];
    files.extend(texts.map(|(path, text)| (path.to_string(), text.as_bytes().to_vec())));
    let add = |files: &mut Files, path: &str, text: String| files.insert(path.into(), text.into_bytes());
    add(&mut files, VERSIONS_FILE, versions(parts.facts));
    add(&mut files, README_FILE, readme(parts));
    let provenance = statement(parts, &files);
    add(&mut files, STATEMENT_FILE, provenance);
    let metadata = crate_metadata(parts, &files);
    add(&mut files, CRATE_FILE, metadata);
    let sums = list(&files);
    add(&mut files, DIGESTS_FILE, sums);
    files
}

fn versions(facts: &Facts) -> String {
    format!("{:#}\n", json!({ "versions": facts.versions, "source_sha256": facts.source_sha256 }))
}
