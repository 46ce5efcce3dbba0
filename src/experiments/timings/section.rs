//! `[timings]`: the files with times that other commands measured.

use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::sections::{NAME_RULE, safe_name};
use crate::scene::{Faults, Limits};

/// `[timings]`: files in the folder `timings` that `cargo xtask bench --peers`, `cost` and `coverage` wrote.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct TimingsSection {
    /// Times of slipmode and its peers.
    pub peers: String,
    /// How time and memory grow.
    pub cost: String,
    /// On which machine, on which day, with which versions.
    pub machine: String,
    /// Which lines of the program the tests ran, from `cargo xtask coverage`.
    pub coverage: Option<String>,
}

impl ReadSection for TimingsSection {
    fn read(entry: &Entry<'_>, _: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let mut name = |section: &mut Section<'_>, key| {
            section.required(key, NAME_RULE, faults).and_then(|entry| safe_name(&entry, faults))
        };
        let peers = name(&mut section, "peers");
        let cost = name(&mut section, "cost");
        let machine = name(&mut section, "machine");
        let coverage = section.optional("coverage").map(|entry| safe_name(&entry, faults));
        section.finish(faults);
        Some(Self {
            peers: peers?,
            cost: cost?,
            machine: machine?,
            coverage: coverage.map_or(Some(None), |name| name.map(Some))?,
        })
    }
}
