//! Texts by their place in a folder, and how they differ from a published copy.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, Read};
use std::path::Path;

use slipmode::archive::first_different_line;
use slipmode::report::without_environment;

use crate::cli::environment::{self, ENVIRONMENT_FILE};
use crate::cli::failure::Failure;
use crate::cli::input::open_regular;
use crate::cli::path_text::shown_path;

/// Texts by their path in a folder, `/` between the parts.
pub type Files = BTreeMap<String, String>;

/// The files as they lie in a folder, one a line.
pub fn listing(files: &Files, folder: &Path) -> String {
    files.keys().map(|name| format!("{}\n", shown_path(&folder.join(name)))).collect()
}

/// How `files` differ from the folder `published`, one line a file; environment blocks are not compared.
///
/// # Errors
/// When the published folder cannot be read.
pub fn differences(files: &Files, published: &Path) -> Result<Vec<String>, Failure> {
    let mut names = BTreeSet::new();
    list(published, "", &mut names).map_err(Failure::io(published, "cannot be read"))?;
    names.extend(files.keys().cloned());
    names.retain(|name| name != ENVIRONMENT_FILE && !name.ends_with('/'));
    let mut found = Vec::new();
    if published.join(ENVIRONMENT_FILE).exists() && !environment::is_in(published) {
        found.push(format!("{ENVIRONMENT_FILE}: not as slipmode writes it"));
    }
    for name in names {
        let path = published.join(&name);
        let mut bytes = Vec::new();
        let old = match open_regular(&path).and_then(|mut file| file.read_to_end(&mut bytes)) {
            Ok(_) => Some(String::from_utf8_lossy(&bytes)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(Failure::io(&path, "cannot be read")(error)),
        };
        found.extend(difference(&name, old.as_deref(), files.get(&name).map(String::as_str)));
    }
    Ok(found)
}

fn difference(name: &str, old: Option<&str>, new: Option<&str>) -> Option<String> {
    let name = shown_path(name.as_ref());
    match (old, new) {
        (None, Some(_)) => Some(format!("{name}: not in the published copy")),
        // A name that is not UTF-8 is listed, and not found.
        (_, None) => Some(format!("{name}: in the published copy, but not in the report")),
        (Some(old), Some(new)) => {
            let (old, new) = (without_environment(old), without_environment(new));
            let line = first_different_line(old.as_bytes(), new.as_bytes())?;
            Some(format!("{name}:{line}: differs from the published copy"))
        }
    }
}

/// Lists all files of a folder by their path in it, and its folders, with `/` at the end.
///
/// # Errors
/// When a folder cannot be read.
pub fn list(folder: &Path, prefix: &str, names: &mut BTreeSet<String>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            let name = format!("{name}/");
            list(&entry.path(), &name, names)?;
            names.insert(name);
        } else {
            names.insert(name);
        }
    }
    Ok(())
}
