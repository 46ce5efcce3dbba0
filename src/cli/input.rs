//! Input files: opened, or named as a fault.

use std::fs::{self, File};
use std::io::{self, Read};
use std::os::fd::AsFd;
use std::path::{Path, PathBuf};

use slipmode::csv::{Dialect, Input, RowReader};
use slipmode::scene::{Fault, MAX_FILE_BYTES, Problem};

use crate::cli::output::note_input;

/// Opens a CSV file that the command line names, or standard input for `-`; a pipe may stand for a file.
///
/// # Errors
/// When the file is missing, a folder, not readable, or an output of the command.
pub fn open_csv(path: &Path, dialect: Dialect) -> Result<RowReader, Fault> {
    if path.as_os_str() != "-" {
        return rows_of(path, File::open(path), dialect);
    }
    let name = "standard input";
    // A stream that is closed has no file, and gives no bytes.
    if let Ok(stdin) = io::stdin().as_fd().try_clone_to_owned() {
        note_input(None, &File::from(stdin)).map_err(|error| unreadable(Path::new(name), &error))?;
    }
    Ok(RowReader::new(Input { name: name.into(), reader: Box::new(io::stdin()), size: None }, dialect))
}

/// Opens a CSV file that another file names: a regular one.
///
/// # Errors
/// When the file is missing, no regular file, not readable, or an output of the command.
pub fn open_named_csv(path: &Path, dialect: Dialect) -> Result<RowReader, Fault> {
    rows_of(path, open_regular(path), dialect)
}

fn rows_of(path: &Path, file: io::Result<File>, dialect: Dialect) -> Result<RowReader, Fault> {
    let open = || {
        let file = file?;
        let metadata = file.metadata()?;
        if metadata.is_dir() {
            return Err(io::Error::other("is a folder; name a file"));
        }
        note_input(Some(path), &file)?;
        let size = metadata.is_file().then_some(metadata.len());
        Ok(Input { name: path.display().to_string(), reader: Box::new(file), size })
    };
    Ok(RowReader::new(open().map_err(|error| unreadable(path, &error))?, dialect))
}

/// The bytes of a scene, report, claims or prose file.
///
/// # Errors
/// As [`read_file_up_to`].
pub fn read_small_file(path: &Path) -> Result<Vec<u8>, Fault> {
    read_file_up_to(path, MAX_FILE_BYTES)
}

/// The bytes of a regular file of at most `limit` bytes; a larger one is not read.
///
/// # Errors
/// When the file is missing, no regular file, not readable, larger, or an output of the command.
pub fn read_file_up_to(path: &Path, limit: u64) -> Result<Vec<u8>, Fault> {
    let cannot = |error: io::Error| unreadable(path, &error);
    let file = open_regular(path).map_err(cannot)?;
    note_input(Some(path), &file).map_err(cannot)?;
    let bytes = file.metadata().map_err(cannot)?.len();
    let mut content = Vec::new();
    // A file may grow while it is read.
    file.take(limit + 1).read_to_end(&mut content).map_err(cannot)?;
    let bytes = bytes.max(content.len() as u64);
    if bytes <= limit { Ok(content) } else { Err(fault_of(path, Problem::TooLarge { bytes, limit })) }
}

/// Opens a regular file; anything else could keep its reader waiting for ever.
///
/// # Errors
/// When it is missing, no regular file or not readable.
pub fn open_regular(path: &Path) -> io::Result<File> {
    let file = open_at_once(path)?;
    match file.metadata()?.file_type() {
        kind if kind.is_dir() => Err(io::Error::other("is a folder; name a file")),
        kind if !kind.is_file() => Err(io::Error::other("is a pipe or a device (wanted: a regular file)")),
        _ => Ok(file),
    }
}

/// The place of a file below a folder that another file names; no link may lead out of the folder.
///
/// # Errors
/// When there is no such file, or it lies elsewhere.
pub fn place_inside(folder: &Path, name: &str) -> io::Result<PathBuf> {
    let root = fs::canonicalize(folder)?;
    if fs::canonicalize(root.join(name))?.starts_with(&root) {
        return Ok(folder.join(name));
    }
    Err(io::Error::other(format!("is a link that leads out of {}", folder.display())))
}

/// Opens a file without waiting for the other end of a pipe.
#[cfg(unix)]
fn open_at_once(path: &Path) -> io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    let at_once = rustix::fs::OFlags::NONBLOCK.bits();
    File::options().read(true).custom_flags(at_once.cast_signed()).open(path)
}

/// Elsewhere no file is a pipe.
#[cfg(not(unix))]
fn open_at_once(path: &Path) -> io::Result<File> {
    File::open(path)
}

/// A file that cannot be read, as a fault.
pub fn unreadable(path: &Path, error: &io::Error) -> Fault {
    fault_of(path, error.into())
}

/// Names a section that a scene needs and lacks.
pub fn lacks(path: &Path, section: &str, allowed: &str) -> Fault {
    Fault { key: section.into(), ..fault_of(path, Problem::Missing { allowed: allowed.into() }) }
}

/// A fault of a whole file.
pub fn fault_of(path: &Path, problem: Problem) -> Fault {
    Fault::of(path.display().to_string(), "", problem)
}
