//! Where the repository is and which files it has.

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// The repository's root: the folder above this package.
pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.parent().unwrap_or(package).to_path_buf()
}

/// Paths of all files below the root, relative to it, with `/`, sorted; build products and version control left out.
///
/// # Errors
/// When a folder cannot be read.
pub fn files() -> Result<Vec<String>, Failure> {
    let root = root();
    let mut found = Vec::new();
    collect(&root, &root, &mut found)?;
    found.sort();
    Ok(found)
}

/// The names of all report folders: those below `reports/` that hold a `report.toml`, sorted.
///
/// # Errors
/// When `reports/` cannot be read or holds no report at all.
pub fn reports() -> Result<Vec<String>, Failure> {
    let folder = root().join("reports");
    let mut names = Vec::new();
    for path in entries(&folder)? {
        if path.join("report.toml").is_file() {
            names.push(file_name(&path));
        }
    }
    names.sort();
    if names.is_empty() {
        return Err(Failure::bad_input("reports/ holds no folder with a report.toml"));
    }
    Ok(names)
}

/// Whether a path is a source file of the program's own packages.
pub fn is_product(path: &str) -> bool {
    ["crates/algebra/src/", "crates/core/src/", "crates/plot/src/", "src/"]
        .iter()
        .any(|folder| path.starts_with(folder))
}

/// The paths in a folder, unsorted.
///
/// # Errors
/// When the folder cannot be read.
pub fn entries(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let cannot = |error: std::io::Error| Failure::bad_input(format!("{}: {error}", folder.display()));
    fs::read_dir(folder).map_err(cannot)?.map(|entry| entry.map(|e| e.path()).map_err(cannot)).collect()
}

/// The last component of a path as text.
pub fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn collect(root: &Path, folder: &Path, found: &mut Vec<String>) -> Result<(), Failure> {
    for path in entries(folder)? {
        let name = file_name(&path);
        if path.is_dir() {
            if !matches!(name.as_str(), "target" | ".git" | "__pycache__") {
                collect(root, &path, found)?;
            }
        } else if name != ".git"
            && let Ok(relative) = path.strip_prefix(root)
        {
            found.push(relative.to_string_lossy().replace('\\', "/"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_listing_has_this_file_and_no_build_products() {
        let files = files().unwrap();
        assert!(files.contains(&"xtask/src/repository.rs".to_string()));
        assert!(files.iter().all(|path| !path.starts_with("target/") && !path.starts_with(".git/")));
    }
}
