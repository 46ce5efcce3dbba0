//! Output folders: written next to their place and renamed into it when complete; and the comparison with a published copy.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use slipmode::report::without_environment;
use slipmode::scene::{check_name, same_name};

use crate::cli::environment::ENVIRONMENT_FILE;
use crate::cli::failure::Failure;
use crate::cli::output::beside_name;

/// Texts by their path in a folder, `/` between the parts.
pub type Files = BTreeMap<String, String>;

/// A folder under writing; what was written so far is removed unless it is committed.
#[derive(Debug)]
pub struct OutputFolder {
    place: PathBuf,
    beside: PathBuf,
}

impl OutputFolder {
    /// Starts a folder, so that a place that cannot be written is known before anything is computed.
    ///
    /// # Errors
    /// When the place is a file or a link, holds something else than an earlier output, or cannot be created.
    pub fn create(place: &Path) -> Result<Self, Failure> {
        let beside = beside_name(place)?;
        let place = place.with_file_name(place.file_name().unwrap_or_default());
        check_place(&place)?;
        if let Some(parent) = place.parent() {
            fs::create_dir_all(parent).map_err(|error| Failure::io(parent, "cannot be created", &error))?;
        }
        fs::create_dir(&beside).map_err(|error| Failure::io(&place, "cannot be written", &error))?;
        Ok(Self { place, beside })
    }

    /// Writes all files and puts the folder in its place, where it replaces an earlier output whole.
    ///
    /// # Errors
    /// When a name is not safe, two names differ in case only, or the file system refuses; the place is as it was then.
    pub fn commit(self, files: &Files) -> Result<(), Failure> {
        check_names(files)?;
        for (name, text) in files {
            let path = self.beside.join(name);
            let written =
                path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, text));
            written.map_err(|error| Failure::io(&self.place.join(name), "cannot be written", &error))?;
        }
        let refused = |error: io::Error| Failure::io(&self.place, "cannot be put in place", &error);
        if !self.place.exists() {
            return fs::rename(&self.beside, &self.place).map_err(refused);
        }
        let old = self.beside.with_extension("old");
        fs::rename(&self.place, &old).map_err(refused)?;
        if let Err(error) = fs::rename(&self.beside, &self.place) {
            // The earlier output goes back; if even that fails, the message below is the one that matters.
            let _ = fs::rename(&old, &self.place);
            return Err(refused(error));
        }
        fs::remove_dir_all(&old).map_err(|error| Failure::io(&old, "cannot be removed", &error))
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        // Renamed into its place after a commit; otherwise there is nobody left to tell.
        let _ = fs::remove_dir_all(&self.beside);
    }
}

/// Only a new folder, an empty one or an earlier output of ours may be written.
fn check_place(place: &Path) -> Result<(), Failure> {
    let Ok(metadata) = fs::symlink_metadata(place) else { return Ok(()) };
    let refuse = |why: &str| Err(Failure::Refused(format!("{}: {why}", place.display())));
    if metadata.file_type().is_symlink() {
        return refuse("is a symbolic link; name the folder itself");
    }
    if !metadata.is_dir() {
        return refuse("is a file; name a folder");
    }
    let mut entries = fs::read_dir(place).map_err(|error| Failure::io(place, "cannot be read", &error))?;
    if entries.next().is_some() && !place.join(ENVIRONMENT_FILE).is_file() {
        return refuse(
            "is not empty and not an earlier output (it has no environment.json); name another folder",
        );
    }
    Ok(())
}

fn check_names(files: &Files) -> Result<(), Failure> {
    let refuse = |name: &str, why: &str| Err(Failure::Refused(format!("output file {name:?}: {why}")));
    let mut earlier: Option<&String> = None;
    let mut by_folded: Vec<&String> = files.keys().collect();
    by_folded.sort_by_key(|name| name.to_ascii_lowercase());
    for name in by_folded {
        if let Some(error) = name.split('/').find_map(|part| check_name(part).err()) {
            return refuse(name, &error.to_string());
        }
        if let Some(other) = earlier.filter(|other| same_name(other, name)) {
            return refuse(name, &format!("the same as {other:?} when case is ignored"));
        }
        earlier = Some(name);
    }
    Ok(())
}

/// How `files` differ from the folder `published`, one line a file; environment blocks are not compared.
///
/// # Errors
/// When the published folder cannot be read.
pub fn differences(files: &Files, published: &Path) -> Result<Vec<String>, Failure> {
    let mut names = BTreeSet::new();
    if published.exists() {
        list(published, "", &mut names).map_err(|error| Failure::io(published, "cannot be read", &error))?;
    }
    names.extend(files.keys().cloned());
    names.remove(ENVIRONMENT_FILE);
    let mut found = Vec::new();
    for name in names {
        let path = published.join(&name);
        let old = match fs::read(&path) {
            Ok(bytes) => Some(String::from_utf8_lossy(&bytes).into_owned()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(Failure::io(&path, "cannot be read", &error)),
        };
        found.extend(difference(&name, old.as_deref(), files.get(&name).map(String::as_str)));
    }
    Ok(found)
}

fn difference(name: &str, old: Option<&str>, new: Option<&str>) -> Option<String> {
    match (old, new) {
        (None, _) => Some(format!("{name}: not in the published copy")),
        (Some(_), None) => Some(format!("{name}: in the published copy, but not in the report")),
        (Some(old), Some(new)) if old == new => None,
        (Some(old), Some(new)) => {
            let (old, new) = (without_environment(old), without_environment(new));
            let line = first_difference(&old, &new)?;
            Some(format!("{name}:{line}: differs from the published copy"))
        }
    }
}

/// The first line, counted from 1, in which two texts differ.
fn first_difference(old: &str, new: &str) -> Option<usize> {
    if old == new {
        return None;
    }
    let same = old.split('\n').zip(new.split('\n')).take_while(|(old, new)| old == new).count();
    Some(same + 1)
}

fn list(folder: &Path, prefix: &str, names: &mut BTreeSet<String>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            list(&entry.path(), &format!("{name}/"), names)?;
        } else {
            names.insert(name);
        }
    }
    Ok(())
}
