//! An archive compared with what is computed anew: what differs, and what no computation can verify.

use std::collections::BTreeSet;

use super::canonical::container_fault;
use super::compare::{byte_difference, same_text, text_differences};
use super::contents::{DERIVED, add_derived, contents};
use super::ledger_difference::ledger_differences;
use super::{
    Facts, Files, INPUT_FOLDER, LOCK_FILE, Parts, REPORT_FOLDER, ReleaseTime, THEOREMS_FOLDER, VERSIONS_FILE,
};

/// Which build made an archive, as its `versions.json` states.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Maker {
    /// This very build: all bytes are the same.
    ThisBuild,
    /// Another one, with what it states of itself.
    OtherBuild(Facts),
}

/// How an archive compares with what is computed anew.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Reproduction {
    /// What differs, one line each.
    pub differences: Vec<String>,
    /// What cannot be verified, one line each.
    pub not_verified: Vec<String>,
}

impl Maker {
    /// The build that made these files, compared with the facts of this one.
    ///
    /// # Errors
    /// When `versions.json` is missing or is not what a build writes.
    pub fn of(files: &Files, time: ReleaseTime, this: &Facts) -> Result<Self, String> {
        let stated = files.get(VERSIONS_FILE).ok_or_else(|| format!("{VERSIONS_FILE}: missing"))?;
        if stated == this.to_json().as_bytes() {
            return Ok(Self::ThisBuild);
        }
        Facts::parse(stated, time).map(Self::OtherBuild)
    }
}

/// Compares an archive with what this build makes of its inputs.
#[must_use]
pub fn reproduction(container: &[u8], archived: &Files, computed: &Parts<'_>, maker: &Maker) -> Reproduction {
    match maker {
        Maker::ThisBuild => {
            let mut differences = file_differences(archived, &contents(computed), |path, old, new| {
                byte_difference(path, old, new).into_iter().collect()
            });
            differences.extend(container_fault(container, archived, computed.facts.time));
            Reproduction { differences, not_verified: Vec::new() }
        }
        Maker::OtherBuild(facts) => other_build(container, archived, computed, facts),
    }
}

/// Another build may print other last digits; what it states of itself is taken as stated, and what follows from that must follow.
fn other_build(container: &[u8], archived: &Files, computed: &Parts<'_>, facts: &Facts) -> Reproduction {
    let stated = Parts { facts, ..*computed };
    let mut expected = archived.clone();
    expected.retain(|path, _| !DERIVED.contains(&path.as_str()));
    add_derived(&stated, &mut expected);
    let mut computed = contents(computed);
    for path in DERIVED {
        computed.extend(expected.remove_entry(path));
    }
    let mut not_verified = Vec::new();
    let mut compared = archived.clone();
    for files in [&mut compared, &mut computed] {
        files.retain(|path, _| !path.starts_with(&format!("{THEOREMS_FOLDER}/")));
    }
    if compared.len() < archived.len() {
        not_verified.push(format!("{THEOREMS_FOLDER}/: written by the other build; `sh check.sh` has Coq check the proofs, and nothing checks check.sh"));
    }
    let differences = file_differences(&compared, &computed, |path, old, new| match path {
        VERSIONS_FILE | LOCK_FILE => {
            let differs = byte_difference(path, old, new);
            not_verified.extend(differs.map(|_| format!("{path}: stated by the other build")));
            Vec::new()
        }
        _ => other_build_differences(path, old, new),
    });
    not_verified.extend(container_fault(container, archived, facts.time));
    Reproduction { differences, not_verified }
}

fn other_build_differences(path: &str, archived: &[u8], computed: &[u8]) -> Vec<String> {
    let made = path.strip_prefix(REPORT_FOLDER).and_then(|path| path.strip_prefix('/'));
    match made {
        None => byte_difference(path, archived, computed).into_iter().collect(),
        Some("ledger.json") => match ledger_differences(archived, computed, same_text) {
            // What a reader of JSON passes over: spaces.
            Ok(found) if found.is_empty() => text_differences(path, archived, computed),
            found => found.unwrap_or_else(|fault| vec![format!("{path}: {fault}")]),
        },
        Some(_) => text_differences(path, archived, computed),
    }
}

/// The differences of all files of both sets; a file that only one of them has is a difference.
fn file_differences(
    archived: &Files,
    computed: &Files,
    mut compare: impl FnMut(&str, &[u8], &[u8]) -> Vec<String>,
) -> Vec<String> {
    let mut found = Vec::new();
    for path in archived.keys().chain(computed.keys()).collect::<BTreeSet<_>>() {
        match (archived.get(path), computed.get(path)) {
            (Some(old), Some(new)) => found.extend(compare(path, old, new)),
            (Some(_), None) if path.starts_with(INPUT_FOLDER) => {
                found.push(format!("{path}: the report does not refer to it"));
            }
            (Some(_), None) => found.push(format!("{path}: archived, but not made by the report")),
            (None, _) => found.push(format!("{path}: made by the report, but not archived")),
        }
    }
    found
}
