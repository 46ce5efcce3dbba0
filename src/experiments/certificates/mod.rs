//! Certificates of runs, which were proved elsewhere and of which each run of the report proves some again.

pub(crate) mod grid;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod stored;
pub(crate) mod tables;

pub use grid::StoredFiles;
pub use run::{Certificates, ProvedAgain, certify_grid, prove_again};
pub use section::{CertificateFile, CertificatesSection};
pub use stored::{BOUNDS, Stored, written};

use crate::experiments::certificates::run::EXTREMES;
use crate::experiments::{Experiment, Setting, TableMaker, Work};

impl Experiment for CertificatesSection {
    type Outcome = Certificates;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        Work::certificates(self.files.len() * (self.prove_again + EXTREMES))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        let of = |file: &CertificateFile| setting.references.certificates.get(&file.name).cloned();
        let files = self.files.iter().map(of).collect::<Option<Vec<Vec<Stored>>>>()?;
        Some(Certificates::of(files, self.prove_again))
    }
}
