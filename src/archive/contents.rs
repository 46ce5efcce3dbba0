//! What an archive holds: inputs, results, and what is needed to run, cite, relicense and check them.

use super::bill_of_materials::bill_of_materials;
use super::codecheck::{CODECHECK_FILE, LICENCE_FILE, LICENCES, codecheck};
use super::crate_metadata::{CRATE_FILE, crate_metadata};
use super::digests::{DIGESTS_FILE, list};
use super::readme::readme;
use super::statement::statement;
use super::{
    CHECKER_FILE, Files, INPUT_FOLDER, LOCK_FILE, Parts, README_FILE, REPORT_FOLDER, SOURCES_FILE,
    STATEMENT_FILE, THEOREMS_FOLDER, VERSIONS_FILE,
};

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

/// All files of the archive of a report.
#[must_use]
pub fn contents(parts: &Parts<'_>) -> Files {
    let mut files = Files::new();
    files.extend(parts.inputs.iter().map(|(path, bytes)| (format!("{INPUT_FOLDER}/{path}"), bytes.clone())));
    for (folder, made) in [(REPORT_FOLDER, parts.product), (THEOREMS_FOLDER, parts.theorems)] {
        files.extend(made.iter().map(|(path, text)| (format!("{folder}/{path}"), text.clone().into_bytes())));
    }
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
    let materials = bill_of_materials(&lock, parts.facts.version());
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
