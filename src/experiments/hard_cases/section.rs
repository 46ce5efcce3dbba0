//! `[hard_cases]`: a file of points with references from independent programs.

use crate::scene::section::{Entry, ReadSection};

/// `[hard_cases]`: a file of points with references from independent programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HardCasesSection {
    /// The file's name, safe by `check_name`; it has no folder.
    pub file: String,
}

impl ReadSection for HardCasesSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let file = section.name("file", "the name of a file");
        section.finish();
        Some(Self { file: file? })
    }
}
