//! `[hard_cases]`: files of points and of returns with references from independent programs.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::safe_name;
use crate::scene::{Faults, Limits};

/// `[hard_cases]`: a file of points with references from independent programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HardCasesSection {
    /// The file's name, safe by `check_name`; it has no folder.
    pub file: String,
    /// The name of a file of returns, if any.
    pub returns: Option<String>,
}

impl ReadSection for HardCasesSection {
    fn read(entry: &Entry<'_>, _: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let file = section
            .required("file", "the name of a file", faults)
            .and_then(|entry| safe_name(&entry, faults));
        let returns = section.optional("cycles").map(|entry| safe_name(&entry, faults));
        section.finish(faults);
        let returns = match returns {
            None => None,
            Some(name) => Some(name?),
        };
        Some(Self { file: file?, returns })
    }
}
