//! Texts by their place in a folder, and how they differ from a published copy.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, Read};
use std::path::Path;

use slipmode::archive::first_different_line;
use slipmode::report::without_environment;

use crate::cli::environment::ENVIRONMENT_FILE;
use crate::cli::failure::Failure;
use crate::cli::input::open_regular;

/// Texts by their path in a folder, `/` between the parts.
pub type Files = BTreeMap<String, String>;

/// The files as they lie in a folder, one a line.
pub fn listing(files: &Files, folder: &Path) -> String {
    files.keys().map(|name| format!("{}\n", folder.join(name).display())).collect()
}

/// How `files` differ from the folder `published`, one line a file; environment blocks are not compared.
///
/// # Errors
/// When the published folder cannot be read.
pub fn differences(files: &Files, published: &Path) -> Result<Vec<String>, Failure> {
    let mut names = BTreeSet::new();
    list(published, "", &mut names).map_err(|error| Failure::io(published, "cannot be read", &error))?;
    names.extend(files.keys().cloned());
    names.remove(ENVIRONMENT_FILE);
    let mut found = Vec::new();
    for name in names {
        let path = published.join(&name);
        let mut bytes = Vec::new();
        let old = match open_regular(&path).and_then(|mut file| file.read_to_end(&mut bytes)) {
            Ok(_) => Some(String::from_utf8_lossy(&bytes)),
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
        (Some(old), Some(new)) => {
            let (old, new) = (without_environment(old), without_environment(new));
            let line = first_different_line(old.as_bytes(), new.as_bytes())?;
            Some(format!("{name}:{line}: differs from the published copy"))
        }
    }
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
