//! Sweeps that ran elsewhere, and what running them took.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use run::{Swept, read_swept};

use crate::experiments::{Work, experiment};
use crate::scene::AllowedRange;
use crate::scene::section::keys;
use slipmode_core::number::Rational;

experiment! {
    /// `[swept]`: sweeps that ran elsewhere, and what running them took.
    pub struct SweptSection {
        /// The sweeps, in the order of the file.
        pub sweeps: Vec<SweptEntry> = |section, _| {
            let allowed = "a list of sweeps, each under [[swept.sweep]]";
            section.list("sweep", allowed, |member| member.table(SweptEntry::read))
        },
    }
    requires: Nothing,
    outcome: Vec<Swept>,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |_| Work::on_a_file(),
    run: |section, _, references| {
        let of = |entry: &SweptEntry| references.swept.get(&entry.name).cloned();
        Some(section.sweeps.iter().filter_map(of).collect())
    },
}

keys! {
    /// `[[swept.sweep]]`: a sweep whose scene and merged summary are files of the report.
    pub struct SweptEntry {
        /// The files are NAME.toml, the scene, and NAME.csv, the merged summary.
        pub name: String = |section, key| section.name(key, "the name of NAME.toml and NAME.csv"),
        /// SHA-256 of the scene that ran, as its blocks state it.
        pub scene_sha256: String = |section, key| section.digest(key, "the digest that blocks state"),
        /// The program that ran, as its blocks state it.
        pub version: String = |section, key| section.text(key, "the version that blocks state"),
        /// On what and when.
        pub machine: String = |section, key| section.text(key, "on what and when"),
        /// CPU time of all shards, s.
        pub core_seconds: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
        /// Peak memory of a shard, MiB.
        pub peak_memory_mib: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
    }
}
