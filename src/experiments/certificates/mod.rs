//! Certificates of runs, which were proved elsewhere and of which each run of the report proves some again.

pub(crate) mod grid;
pub(crate) mod run;
pub(crate) mod stored;
pub(crate) mod tables;

pub use grid::StoredFiles;
pub use run::{Certificates, ProvedAgain};
pub(crate) use run::{certify_grid, prove_again};
pub use stored::{BOUNDS, Stored, written};

use crate::experiments::certificates::run::EXTREMES;
use crate::experiments::{Work, experiment};
use crate::scene::section::keys;

/// The most rows of a file that a run proves again.
const MOST_AGAIN: u64 = 1000;

experiment! {
    /// `[certificates]`: files of certificates, and how many of them each run proves again.
    pub struct CertificatesSection {
        /// How many rows of each file, evenly chosen, a run proves again besides the extreme ones.
        pub prove_again: usize = |section, key| section.whole(key, 1..=MOST_AGAIN),
        /// The files, in the order of the scene.
        pub files: Vec<CertificateFile> = |section, _| {
            let allowed = "a list of files, each under [[certificates.file]]";
            section.list("file", allowed, |member| member.table(CertificateFile::read))
        },
    }
    outcome: Certificates,
    tables: [tables::TABLES],
    work: |section| Work::certificates(section.files.len() * (section.prove_again + EXTREMES)),
    run: |section, _, references| {
        let of = |file: &CertificateFile| references.certificates.get(&file.name).cloned();
        let files = section.files.iter().map(of).collect::<Option<_>>()?;
        Some(Certificates::of(files, section.prove_again))
    },
}

keys! {
    /// `[[certificates.file]]`: the certificates of one law.
    pub struct CertificateFile {
        /// The file is NAME.csv.
        pub name: String = |section, key| section.name(key, "the name of NAME.csv"),
        /// SHA-256 of the file.
        pub sha256: String = |section, key| section.digest(key, "the digest of the file"),
    }
}
