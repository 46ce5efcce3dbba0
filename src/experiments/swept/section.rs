//! `[swept]`: sweeps that ran elsewhere, and what running them took.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::safe_name;
use crate::scene::{AllowedRange, Faults, Limits, Problem};
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
    fn read(entry: &Entry<'_>, _: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let sweeps = section
            .required("sweep", "a list of sweeps, each under [[swept.sweep]]", faults)
            .and_then(|entry| entry.list(faults, SweptEntry::read));
        section.finish(faults);
        Some(Self { sweeps: sweeps? })
    }
}

impl SweptEntry {
    fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let name = section
            .required("name", "the name of NAME.toml and NAME.csv", faults)
            .and_then(|entry| safe_name(&entry, faults));
        let mut text =
            |key, allowed: &str| section.required(key, allowed, faults).and_then(|entry| entry.text(faults));
        let digest = text("scene_sha256", "the digest that blocks state");
        let version = text("version", "the version that blocks state");
        let machine = text("machine", "on what and when");
        let range = AllowedRange::PHYSICAL;
        let mut positive =
            |key| section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults));
        let core_seconds = positive("core_seconds");
        let peak_memory_mib = positive("peak_memory_mib");
        section.finish(faults);
        let digest = digest?;
        if digest.len() != 64 || !digest.bytes().all(|byte| b"0123456789abcdef".contains(&byte)) {
            let wanted = "a scene_sha256 of 64 digits 0-9 a-f".into();
            faults.push(entry.fault(Problem::Needs(wanted)));
            return None;
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
