//! The files that scenes and reports name: what sweeps that ran elsewhere came to, and what was measured apart.

use std::io::Cursor;
use std::sync::Arc;

use slipmode::archive::sha256_hex;
use slipmode::csv::{Dialect, Input, RowReader, read_step_record};
use slipmode::experiments::certificates::{CertificateFile, Stored, StoredFiles};
use slipmode::experiments::swept::{Swept, SweptEntry, read_swept};
use slipmode::experiments::{References, Scene};
use slipmode::scene::{Measured, file_text, with_rows};

use crate::cli::folder::Reader;

/// The folder of the files that scenes name, with its slash, below a report's folder.
pub const VECTORS: &str = "vectors/";

impl Reader {
    /// Reads all files that `scenes` name, in this folder; their faults are kept.
    pub fn references(&mut self, scenes: &[Scene], folder: &str) -> References {
        let mut references = References::default();
        for entry in scenes.iter().flat_map(|scene| &scene.swept).flat_map(|section| &section.sweeps) {
            let found = self.swept(entry, folder);
            references.swept.extend(found.map(|found| (entry.name.clone(), found)));
        }
        for scene in scenes {
            let mut files = StoredFiles::of(scene);
            for entry in scene.certificates.iter().flat_map(|section| &section.files) {
                let found = self.certificates(entry, &mut files, folder);
                references.certificates.extend(found.map(|found| (entry.name.clone(), found)));
            }
        }
        for section in scenes.iter().flat_map(|scene| &scene.fit) {
            let found = self.read(&format!("{folder}{}.csv", section.record), |name, bytes, _| {
                let reader = Box::new(Cursor::new(bytes.to_vec()));
                let input = Input { name: name.into(), reader, size: Some(bytes.len() as u64) };
                read_step_record(RowReader::new(input, Dialect::default()), None).map(|(record, _)| record)
            });
            references.records.extend(found.map(|found| (section.record.clone(), Arc::new(found))));
        }
        references
    }

    /// A file of certificates, with the points of the scene's grid.
    fn certificates(
        &mut self,
        entry: &CertificateFile,
        files: &mut StoredFiles,
        folder: &str,
    ) -> Option<Vec<Stored>> {
        self.read(&format!("{folder}{}.csv", entry.name), |name, bytes, _| {
            let text = file_text(name, bytes).map_err(|fault| vec![fault])?;
            files.read(entry, &sha256_hex(bytes), (name, text))
        })
    }

    /// The folder of what was measured apart, with all its files; their faults are kept.
    pub fn measured(&mut self, folder: &str) -> Option<Measured> {
        let contents = format!("{folder}/contents.toml");
        let mut measured = self.read(&contents, |name, bytes, _| Measured::parse(name, bytes))?;
        for source in &measured.sources {
            self.read(&format!("{folder}/{source}"), |_, _, _| Ok(()));
        }
        let tables = std::mem::take(&mut measured.tables).into_iter();
        let filled = tables.map(|table| {
            let place = format!("{folder}/tables/{}.csv", table.id);
            self.read(&place, |name, bytes, _| {
                with_rows(table, name, file_text(name, bytes).map_err(|fault| vec![fault])?)
            })
        });
        measured.tables = filled.collect::<Option<_>>()?;
        Some(measured)
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
