//! The files that scenes name: hard cases, times, and what sweeps that ran elsewhere came to.

use std::collections::BTreeSet;
use std::path::Path;

use slipmode::archive::sha256_hex;
use slipmode::experiments::References;
use slipmode::experiments::Scene;
use slipmode::experiments::hard_cases::{read_hard_cases, read_hard_returns};
use slipmode::experiments::swept::SweptEntry;
use slipmode::experiments::swept::{Swept, read_swept};
use slipmode::experiments::timings::TimingsSection;
use slipmode::experiments::timings::{Timings, read_cost, read_coverage, read_machine, read_peers};
use slipmode::scene::file_text;

use crate::cli::folder::Reader;

/// The folders of the files that scenes name, each with its slash.
#[derive(Clone, Copy, Debug)]
pub struct Places {
    vectors: &'static str,
    timings: &'static str,
}

impl Places {
    /// Below a report's folder.
    pub const IN_REPORT: Self = Self { vectors: "vectors/", timings: "timings/" };
    /// Beside a scene that belongs to no report.
    pub const BESIDE: Self = Self { vectors: "", timings: "" };

    /// Whether `report` has one of these folders.
    pub fn is_in(self, report: &Path) -> bool {
        [self.vectors, self.timings].iter().any(|folder| report.join(folder).is_dir())
    }
}

impl Reader {
    /// Reads all files that `scenes` name; their faults are kept.
    pub fn references(&mut self, scenes: &[Scene], places: Places) -> References {
        let mut references = References::default();
        let named = scenes.iter().filter_map(|scene| scene.hard_cases.as_ref());
        for file in named.map(|section| section.file.clone()).collect::<BTreeSet<_>>() {
            let cases = self.read_text(&format!("{}{file}", places.vectors), read_hard_cases);
            references.hard_cases.extend(cases.map(|cases| (file, cases)));
        }
        let named = scenes.iter().filter_map(|scene| scene.hard_cases.as_ref()?.returns.clone());
        for file in named.collect::<BTreeSet<_>>() {
            let returns = self.read_text(&format!("{}{file}", places.vectors), read_hard_returns);
            references.hard_returns.extend(returns.map(|returns| (file, returns)));
        }
        for section in scenes.iter().filter_map(|scene| scene.timings.as_ref()) {
            let found = self.timings(section, places.timings);
            references.timings.extend(found.map(|found| (section.clone(), found)));
        }
        for entry in
            scenes.iter().filter_map(|scene| scene.swept.as_ref()).flat_map(|section| &section.sweeps)
        {
            let found = self.swept(entry, places.vectors);
            references.swept.extend(found.map(|found| (entry.name.clone(), found)));
        }
        references
    }

    /// The files of times, and that of coverage where it is named.
    fn timings(&mut self, section: &TimingsSection, folder: &str) -> Option<Timings> {
        let peers = self.read_text(&format!("{folder}{}", section.peers), read_peers);
        let cost = self.read_text(&format!("{folder}{}", section.cost), read_cost);
        let machine = self.read_text(&format!("{folder}{}", section.machine), read_machine);
        let coverage = match &section.coverage {
            None => None,
            Some(file) => Some((file.clone(), self.read_text(&format!("{folder}{file}"), read_coverage)?)),
        };
        let (peers_file, cost_file) = (section.peers.clone(), section.cost.clone());
        Some(Timings { peers_file, peers: peers?, cost_file, cost: cost?, machine: machine?, coverage })
    }

    /// A sweep's scene and its summary.
    fn swept(&mut self, entry: &SweptEntry, folder: &str) -> Option<Swept> {
        let place = |end: &str| format!("{folder}{}.{end}", entry.name);
        let scene = self.read(&place("toml"), |name, bytes, limits| {
            Ok((name.to_string(), sha256_hex(bytes), Scene::parse(name, bytes, limits)?))
        });
        let summary = self.read(&place("csv"), |name, bytes, _| {
            let text = file_text(name, bytes).map_err(|fault| vec![fault])?;
            Ok((name.to_string(), text.to_string()))
        });
        let (csv, text) = summary?;
        read_swept(entry, scene?, (&csv, &text)).map_err(|fault| self.faults.push(fault)).ok()
    }
}
