//! Input files: opened, or named as a fault.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use slipmode::csv::{Input, RowReader};
use slipmode::scene::{Fault, MAX_FILE_BYTES, Problem};

/// Opens a CSV file, or standard input for `-`.
///
/// # Errors
/// When the file is missing, a folder, or not readable.
pub fn open_csv(path: &Path) -> Result<RowReader, Fault> {
    let input = if path.as_os_str() == "-" {
        Input { name: "standard input".into(), reader: Box::new(io::stdin()), size: None }
    } else {
        let (file, size) = open_file(path)?;
        Input { name: path.display().to_string(), reader: Box::new(file), size }
    };
    Ok(RowReader::new(input))
}

/// The bytes of a scene, report, claims or prose file; one byte more than the cap is read, never more.
///
/// # Errors
/// When the file is missing, a folder, or not readable.
pub fn read_small_file(path: &Path) -> Result<Vec<u8>, Fault> {
    let (file, _) = open_file(path)?;
    let mut bytes = Vec::new();
    file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes).map_err(|error| unreadable(path, &error))?;
    Ok(bytes)
}

/// The bytes of a file of at most `most` bytes; one more is read, never more.
///
/// # Errors
/// When the file is missing, a folder, not readable, or larger.
pub fn read_file_up_to(path: &Path, most: u64) -> Result<Vec<u8>, Fault> {
    let (file, _) = open_file(path)?;
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes).map_err(|error| unreadable(path, &error))?;
    if bytes.len() as u64 > most {
        let error = io::Error::new(io::ErrorKind::FileTooLarge, format!("more than {most} bytes"));
        return Err(unreadable(path, &error));
    }
    Ok(bytes)
}

fn open_file(path: &Path) -> Result<(File, Option<u64>), Fault> {
    let file = File::open(path).map_err(|error| unreadable(path, &error))?;
    let metadata = file.metadata().map_err(|error| unreadable(path, &error))?;
    if metadata.is_dir() {
        return Err(unreadable(path, &io::Error::other("is a folder; name a file")));
    }
    Ok((file, metadata.is_file().then_some(metadata.len())))
}

/// A file that cannot be read, as a fault.
pub fn unreadable(path: &Path, error: &io::Error) -> Fault {
    Fault {
        file: path.display().to_string(),
        line: None,
        key: String::new(),
        value: None,
        problem: Problem::Unreadable(error.to_string()),
    }
}
