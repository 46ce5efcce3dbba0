//! What a command reads and what it writes: nothing may be both, under whatever name, and no two outputs may be one.

use std::fs::{self, File, Metadata};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::cli::output::partial::folder_of;

/// The files and folders of this process.
static PLACES: Mutex<CommandPaths> = Mutex::new(CommandPaths { inputs: Vec::new(), outputs: Vec::new() });

#[derive(Debug)]
struct CommandPaths {
    inputs: Vec<Target>,
    outputs: Vec<Target>,
}

/// A file or folder, or a standard stream.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Target {
    /// Its full path without links; none of standard streams.
    path: Option<PathBuf>,
    /// Its device and number there, of regular files: what hard links and redirections share.
    identity: Option<(u64, u64)>,
    /// A folder stands for all it holds.
    is_folder: bool,
}

const BOTH: &str = "is read and written by this command; name another output";
const TWICE: &str = "is or holds another output of this command; name another place";

/// Notes a file that is read.
///
/// # Errors
/// When it is an output of this command too.
pub fn note_input(path: Option<&Path>, file: &File) -> io::Result<()> {
    let path = path.and_then(|path| fs::canonicalize(path).ok());
    note_read(Target { path, identity: identity_of(file), is_folder: false }).map_err(io::Error::other)
}

/// Notes a folder of which all files may be read.
///
/// # Errors
/// When an output of this command lies in it.
pub fn note_input_folder(folder: &Path) -> Result<(), &'static str> {
    note_read(Target { path: fs::canonicalize(folder).ok(), identity: None, is_folder: true })
}

/// Notes a file or folder that is going to be written.
///
/// # Errors
/// When it is an input of this command, or another of its outputs, or holds one.
pub fn note_output(place: &Path, is_folder: bool) -> Result<(), &'static str> {
    note_written(Target::of_output(place, is_folder))
}

/// Checks again that nothing that was read since an output was noted is replaced by it.
///
/// # Errors
/// When the command has read it, or a file in it.
pub fn check_output(place: &Path, is_folder: bool) -> Result<(), &'static str> {
    check(&Target::of_output(place, is_folder), &places().inputs, BOTH)
}

/// Notes standard output: a file that it is redirected to must not be read.
///
/// # Errors
/// When it is an input of this command.
pub fn note_standard_output(file: &File) -> Result<(), &'static str> {
    note_written(Target { path: None, identity: identity_of(file), is_folder: false })
}

fn note_read(place: Target) -> Result<(), &'static str> {
    let mut places = places();
    let checked = check(&place, &places.outputs, BOTH);
    places.inputs.push(place);
    checked
}

/// Checks one of millions of inputs, for all of which an output was noted before.
///
/// # Errors
/// When it is an output of this command too.
pub fn check_input(file: &File) -> io::Result<()> {
    let input = Target { path: None, identity: identity_of(file), is_folder: false };
    check(&input, &places().outputs, BOTH).map_err(io::Error::other)
}

/// Refuses a place that meets one of these, and says why.
fn check(place: &Target, others: &[Target], why: &'static str) -> Result<(), &'static str> {
    if others.iter().any(|other| other.meets(place)) { Err(why) } else { Ok(()) }
}

fn places() -> MutexGuard<'static, CommandPaths> {
    PLACES.lock().unwrap_or_else(PoisonError::into_inner)
}

fn note_written(place: Target) -> Result<(), &'static str> {
    let mut places = places();
    check(&place, &places.inputs, BOTH)?;
    check(&place, &places.outputs, TWICE)?;
    places.outputs.push(place);
    Ok(())
}

impl Target {
    fn of_output(place: &Path, is_folder: bool) -> Self {
        let name = place.file_name().unwrap_or_default();
        Self {
            path: fs::canonicalize(folder_of(place)).ok().map(|folder| folder.join(name)),
            identity: fs::metadata(place).ok().and_then(|metadata| identity(&metadata)),
            is_folder,
        }
    }

    /// Whether the two are one file, or one lies in the other.
    fn meets(&self, other: &Self) -> bool {
        let is_same = self.identity.is_some() && self.identity == other.identity;
        let (Some(path), Some(other_path)) = (&self.path, &other.path) else { return is_same };
        is_same
            || path == other_path
            || (self.is_folder && other_path.starts_with(path))
            || (other.is_folder && path.starts_with(other_path))
    }
}

fn identity_of(file: &File) -> Option<(u64, u64)> {
    file.metadata().ok().and_then(|metadata| identity(&metadata))
}

/// What tells a regular file from all others, whatever its names are.
#[cfg(unix)]
fn identity(metadata: &Metadata) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt;
    metadata.is_file().then(|| (metadata.dev(), metadata.ino()))
}

/// Elsewhere paths have to do.
#[cfg(not(unix))]
fn identity(_metadata: &Metadata) -> Option<(u64, u64)> {
    None
}
