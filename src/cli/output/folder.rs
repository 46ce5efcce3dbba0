//! Output folders: written next to their place and exchanged with it when complete.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use slipmode::scene::{check_name, same_name};

use crate::cli::environment::{self, ENVIRONMENT_FILE};
use crate::cli::failure::Failure;
use crate::cli::output::partial::{PartialFolder, folder_of};
use crate::cli::output::places;
use crate::cli::tree::{Files, list};

/// A folder under writing; what was written so far is removed unless it is committed.
#[derive(Debug)]
pub struct OutputFolder {
    place: PathBuf,
    partial: PartialFolder,
    own: &'static [&'static str],
    /// Dropped after the partial folder, which lies in it.
    above: MadeFolder,
}

/// Folders that were made for an output. Those that nothing was put into are removed when it is dropped.
#[derive(Debug)]
pub struct MadeFolder(Vec<PathBuf>);

impl MadeFolder {
    /// Makes a folder with those above it, where they are missing.
    ///
    /// # Errors
    /// When the file system refuses.
    pub fn at(place: &Path) -> Result<Self, Failure> {
        let missing = place.ancestors().take_while(|folder| !folder.exists());
        let made = Self(missing.map(Path::to_path_buf).collect());
        fs::create_dir_all(place).map_err(Failure::io(place, "cannot be created"))?;
        Ok(made)
    }
}

impl Drop for MadeFolder {
    fn drop(&mut self) {
        for folder in &self.0 {
            // A folder that holds something stays.
            let _ = fs::remove_dir(folder);
        }
    }
}

impl OutputFolder {
    /// Starts a folder, so that a place that cannot be written is known before anything is computed. It may replace an earlier
    /// output with these files besides tables and figures.
    ///
    /// # Errors
    /// When the place is a file or a link, holds something else than an earlier output or an input of the command, or cannot
    /// be created.
    pub fn create(place: &Path, own: &'static [&'static str]) -> Result<Self, Failure> {
        let Some(name) = place.file_name() else {
            return Err(Failure::place(place, "is not a name that can be written"));
        };
        let place = place.with_file_name(name);
        check_place(&place, own)?;
        let above = MadeFolder::at(folder_of(&place))?;
        places::note_output(&place, true).map_err(|why| Failure::place(&place, why))?;
        let partial = PartialFolder::beside(&place).map_err(Failure::io(&place, "cannot be written"))?;
        Ok(Self { place, partial, own, above })
    }

    /// Writes all files and puts the folder in its place, where it replaces an earlier output whole.
    ///
    /// # Errors
    /// When a name is not safe, two names differ in case only, or the file system refuses; the place is as it was then.
    pub fn commit(self, files: &Files) -> Result<(), Failure> {
        check_names(files)?;
        let Self { place, partial, own, above: _above } = self;
        for (name, text) in files {
            let written = partial.write(name, text.as_bytes());
            written.map_err(Failure::io(&place.join(name), "cannot be written"))?;
        }
        check_place(&place, own)?;
        places::check_output(&place, true).map_err(|why| Failure::place(&place, why))?;
        partial.persist(&place).map_err(Failure::io(&place, "cannot be put in place"))
    }
}

/// Only a new folder, an empty one or an earlier output of ours, to which nothing was added, may be written.
fn check_place(place: &Path, own: &[&str]) -> Result<(), Failure> {
    let Ok(metadata) = fs::symlink_metadata(place) else { return Ok(()) };
    let refuse = |why: &str| Err(Failure::place(place, why));
    if metadata.file_type().is_symlink() {
        return refuse("is a symbolic link; name the folder itself");
    }
    if !metadata.is_dir() {
        return refuse("is a file; name a folder");
    }
    let cannot = Failure::io(place, "cannot be read");
    if fs::read_dir(place).map_err(&cannot)?.next().is_none() {
        return Ok(());
    }
    if !environment::is_in(place) {
        return refuse(
            "is not empty and not an earlier output (it has no environment.json of slipmode); name another folder",
        );
    }
    let mut names = BTreeSet::new();
    list(place, "", &mut names).map_err(cannot)?;
    match names.into_iter().find(|name| !is_own(name, own)) {
        Some(name) => Err(Failure::place(
            &place.join(name),
            "is no file of an earlier output, which would be replaced whole; move it, or name another folder",
        )),
        None => Ok(()),
    }
}

/// Whether an output has such a file or folder. Unfinished files do not count as files of others.
fn is_own(name: &str, own: &[&str]) -> bool {
    match name.split_once('/') {
        Some(("tables" | "figures", "")) => true,
        Some(("tables", file)) => file.ends_with(".csv") && check_name(file).is_ok(),
        Some(("figures", file)) => file.ends_with(".svg") && check_name(file).is_ok(),
        Some(_) => false,
        None if name.starts_with('.') => name.ends_with(".partial"),
        None => name == ENVIRONMENT_FILE || own.contains(&name),
    }
}

fn check_names(files: &Files) -> Result<(), Failure> {
    let refuse = |name: &str, why: &str| Err(Failure::Refused(format!("output file {name:?}: {why}")));
    let mut earlier: Option<&String> = None;
    let mut by_folded: Vec<&String> = files.keys().collect();
    by_folded.sort_by_key(|name| name.to_ascii_lowercase());
    for name in by_folded {
        name.split('/').try_for_each(check_name).or_else(|error| refuse(name, &error.to_string()))?;
        if let Some(other) = earlier.replace(name).filter(|other| same_name(other, name)) {
            return refuse(name, &format!("the same as {other:?} when case is ignored"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_made_folder_stays_only_with_something_in_it() {
        let root = tempfile::tempdir().unwrap();
        let [above, deep] = ["a", "a/b/c"].map(|name| root.path().join(name));
        drop(MadeFolder::at(&deep).unwrap());
        assert!(!above.exists());
        let made = MadeFolder::at(&deep).unwrap();
        fs::write(above.join("f"), "f").unwrap();
        drop(made);
        assert!(above.join("f").exists() && !above.join("b").exists());
        drop(MadeFolder::at(&above).unwrap());
        assert!(above.exists(), "it was there before");
    }
}
