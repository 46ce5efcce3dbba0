//! `[certificates]`: files of certificates, and how many of them each run proves again.

use crate::scene::section::{ReadSection, Section};

/// The most rows of a file that a run proves again.
const MOST_AGAIN: u64 = 1000;

/// `[certificates]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CertificatesSection {
    /// How many rows of each file, evenly chosen, a run proves again besides the extreme ones.
    pub prove_again: usize,
    /// The files, in the order of the scene.
    pub files: Vec<CertificateFile>,
}

/// `[[certificates.file]]`: the certificates of one law.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CertificateFile {
    /// The file is NAME.csv.
    pub name: String,
    /// SHA-256 of the file.
    pub sha256: String,
}

impl ReadSection for CertificatesSection {
    fn read(section: &mut Section<'_>) -> Self {
        Self {
            prove_again: section.whole("prove_again", 1..=MOST_AGAIN),
            files: section.list("file", "a list of files, each under [[certificates.file]]", |member| {
                member.table(CertificateFile::read)
            }),
        }
    }
}

impl CertificateFile {
    fn read(section: &mut Section<'_>) -> Self {
        Self {
            name: section.name("name", "the name of NAME.csv"),
            sha256: section.digest("sha256", "the digest of the file"),
        }
    }
}
