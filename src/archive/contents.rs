//! What an archive holds: inputs, results, and what is needed to run, cite, relicense and check them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::claims::Ledger;
use crate::scene::Paper;

use super::bill_of_materials::bill_of_materials;
use super::codecheck::{CODECHECK_FILE, LICENCE_FILE, LICENCES, codecheck};
use super::crate_metadata::{CRATE_FILE, crate_metadata};
use super::digests::{DIGESTS_FILE, list};
use super::readme::readme;
use super::statement::statement;
use super::{Files, ReleaseTime};

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
/// The same as a CycloneDX bill of materials.
pub(super) const MATERIALS_FILE: &str = "sbom.cdx.json";
/// The files that follow from the others.
pub(super) const DERIVED: [&str; 6] =
    [MATERIALS_FILE, README_FILE, CODECHECK_FILE, STATEMENT_FILE, CRATE_FILE, DIGESTS_FILE];

const CARGO_LOCK: &str = include_str!("Cargo.lock");
const CITATION: &str = include_str!("../../CITATION.cff");
const CHECKER: &str = include_str!("../../proofs/certified_cycle.py");
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

/// All files of the archive of a report.
#[must_use]
pub fn contents(parts: &Parts<'_>) -> Files {
    let mut files = Files::new();
    files.extend(parts.inputs.iter().map(|(path, bytes)| (format!("{INPUT_FOLDER}/{path}"), bytes.clone())));
    let product = parts.product.iter();
    files.extend(product.map(|(path, text)| (format!("{REPORT_FOLDER}/{path}"), text.clone().into_bytes())));
    let theorems = parts.theorems.iter();
    files.extend(
        theorems.map(|(path, text)| (format!("{THEOREMS_FOLDER}/{path}"), text.clone().into_bytes())),
    );
    let texts = [
        (LOCK_FILE, CARGO_LOCK),
        ("CITATION.cff", CITATION),
        ("LICENSE-MIT", LICENSE_MIT),
        ("LICENSE-APACHE", LICENSE_APACHE),
        ("NOTICE.md", NOTICE),
    ];
    files.extend(texts.map(|(path, text)| (path.to_string(), text.as_bytes().to_vec())));
    if parts.certificate_files().next().is_some() {
        files.insert(CHECKER_FILE.into(), CHECKER.into());
    }
    if let Some(sources) = parts.sources {
        files.insert(SOURCES_FILE.into(), sources.to_vec());
    }
    if parts.codecheck.is_some() {
        files.insert(LICENCE_FILE.into(), LICENCES.as_bytes().to_vec());
    }
    files.insert(VERSIONS_FILE.into(), parts.facts.to_json().into_bytes());
    add_derived(parts, &mut files);
    files
}

/// Adds the files that follow from the others, in the order in which they follow.
pub(super) fn add_derived(parts: &Parts<'_>, files: &mut Files) {
    let lock = files.get(LOCK_FILE).map(|lock| String::from_utf8_lossy(lock)).unwrap_or_default();
    let materials = bill_of_materials(&lock, &parts.facts.version);
    let add = |files: &mut Files, path: &str, text: String| files.insert(path.into(), text.into_bytes());
    add(files, MATERIALS_FILE, materials);
    add(files, README_FILE, readme(parts));
    if let Some(paper) = parts.codecheck {
        add(files, CODECHECK_FILE, codecheck(parts, paper, files));
    }
    add(files, STATEMENT_FILE, statement(parts, files));
    add(files, CRATE_FILE, crate_metadata(parts, files));
    add(files, DIGESTS_FILE, list(files));
}

/// The form of `versions.json`.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Versions {
    source_sha256: String,
    versions: BTreeMap<String, String>,
}

impl Facts {
    /// As `versions.json`.
    #[must_use]
    pub fn to_json(&self) -> String {
        let (source_sha256, versions) = (self.source_sha256.clone(), self.versions.clone());
        format!("{:#}\n", serde_json::json!(Versions { source_sha256, versions }))
    }

    /// What the `versions.json` of an archive states, which nothing proves.
    ///
    /// # Errors
    /// When it is not what a build of this program writes.
    pub fn parse(json: &[u8], time: ReleaseTime) -> Result<Self, String> {
        let refuse = |why: &str| format!("{VERSIONS_FILE}: {why}");
        let Versions { source_sha256, versions } =
            serde_json::from_slice(json).map_err(|error| refuse(&error.to_string()))?;
        let is_word = |text: &String| {
            text.len() <= 100
                && text
                    .chars()
                    .all(|c| c.is_ascii_alphanumeric() || matches!(c, ' ' | '.' | '+' | '-' | '(' | ')'))
        };
        let is_digest =
            source_sha256.len() == 64 && source_sha256.bytes().all(|byte| byte.is_ascii_hexdigit());
        let version =
            versions.get("slipmode").cloned().ok_or_else(|| refuse("states no version of slipmode"))?;
        let facts = Self { version, versions, source_sha256, time };
        let is_plain = facts.versions.iter().all(|(name, version)| is_word(name) && is_word(version));
        if is_digest && is_plain && facts.to_json().as_bytes() == json {
            Ok(facts)
        } else {
            Err(refuse("is not what a build of slipmode writes"))
        }
    }
}
