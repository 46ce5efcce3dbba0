//! `[swept]`: sweeps that ran elsewhere, and what running them took.

use crate::scene::AllowedRange;
use crate::scene::section::{ReadSection, Section};
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
    fn read(section: &mut Section<'_>) -> Self {
        let allowed = "a list of sweeps, each under [[swept.sweep]]";
        Self { sweeps: section.list("sweep", allowed, |member| member.table(SweptEntry::read)) }
    }
}

impl SweptEntry {
    fn read(section: &mut Section<'_>) -> Self {
        Self {
            name: section.name("name", "the name of NAME.toml and NAME.csv"),
            scene_sha256: section.digest("scene_sha256", "the digest that blocks state"),
            version: section.text("version", "the version that blocks state"),
            machine: section.text("machine", "on what and when"),
            core_seconds: section.decimal("core_seconds", AllowedRange::PHYSICAL),
            peak_memory_mib: section.decimal("peak_memory_mib", AllowedRange::PHYSICAL),
        }
    }
}
