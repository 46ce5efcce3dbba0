//! `[certificates]`: files of certificates, and how many of them each run proves again.

use crate::scene::Problem;
use crate::scene::section::{Entry, ReadSection};

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
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let again = section.whole("prove_again", 1..=MOST_AGAIN);
        let files = section
            .required("file", "a list of files, each under [[certificates.file]]")
            .and_then(|entry| entry.list(CertificateFile::read));
        section.finish();
        Some(Self { prove_again: usize::try_from(again?).ok()?, files: files? })
    }
}

impl CertificateFile {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let name = section.name("name", "the name of NAME.csv");
        let sha256 = section.text("sha256", "the digest of the file");
        section.finish();
        let sha256 = sha256?;
        if sha256.len() != 64 || !sha256.bytes().all(|byte| b"0123456789abcdef".contains(&byte)) {
            return entry.refuse(Problem::Needs("a sha256 of 64 digits 0-9 a-f".into()));
        }
        Some(Self { name: name?, sha256 })
    }
}
