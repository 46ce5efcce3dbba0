//! `[swept]`: sweeps that ran elsewhere, and what running them took.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::{AllowedRange, Problem};
use slipmode_core::number::Rational;

/// `[swept]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweptSection {
    /// The sweeps, in the order of the file.
    pub sweeps: Vec<SweptEntry>,
}

/// `[[swept.sweep]]`: a sweep whose scene and merged summary are files of the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweptEntry {
    /// The files are NAME.toml, the scene, and NAME.csv, the merged summary.
    pub name: String,
    /// SHA-256 of the scene that ran, as its blocks state it.
    pub scene_sha256: String,
    /// The program that ran, as its blocks state it.
    pub version: String,
    /// CPU time of all shards, s.
    pub core_seconds: Rational,
    /// Peak memory of a shard, MiB.
    pub peak_memory_mib: Rational,
    /// On what and when.
    pub machine: String,
}

impl ReadSection for SweptSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let sweeps = section
            .required("sweep", "a list of sweeps, each under [[swept.sweep]]")
            .and_then(|entry| entry.list(SweptEntry::read));
        section.finish();
        Some(Self { sweeps: sweeps? })
    }
}

impl SweptEntry {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let name = section.name("name", "the name of NAME.toml and NAME.csv");
        let digest = section.text("scene_sha256", "the digest that blocks state");
        let version = section.text("version", "the version that blocks state");
        let machine = section.text("machine", "on what and when");
        let [core_seconds, peak_memory_mib] =
            ["core_seconds", "peak_memory_mib"].map(|key| section.decimal(key, AllowedRange::PHYSICAL));
        section.finish();
        let digest = digest?;
        if digest.len() != 64 || !digest.bytes().all(|byte| b"0123456789abcdef".contains(&byte)) {
            return entry.refuse(Problem::Needs("a scene_sha256 of 64 digits 0-9 a-f".into()));
        }
        Some(Self {
            name: name?,
            scene_sha256: digest,
            version: version?,
            core_seconds: core_seconds?,
            peak_memory_mib: peak_memory_mib?,
            machine: machine?,
        })
    }
}
