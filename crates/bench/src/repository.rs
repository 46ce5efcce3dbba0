//! Where the repository is, and which sources and reports it has.

use std::fs;
use std::path::{Path, PathBuf};

/// The packages whose sources are counted: their folders with a slash.
const PACKAGES: [&str; 3] = ["", "crates/core/", "crates/plot/"];

/// The repository's root, two folders above this package.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap_or(Path::new(".")).to_path_buf()
}

/// Paths of all Rust files of the program and its libraries, relative to the root, sorted.
///
/// # Errors
/// When a folder cannot be read.
pub fn sources() -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    for package in PACKAGES {
        collect(&format!("{package}src"), &mut found)?;
    }
    found.sort();
    Ok(found)
}

fn collect(folder: &str, found: &mut Vec<String>) -> Result<(), String> {
    for name in names(folder)? {
        let path = format!("{folder}/{name}");
        if root().join(&path).is_dir() {
            collect(&path, found)?;
        } else if path.ends_with(".rs") {
            found.push(path);
        }
    }
    Ok(())
}

/// The names of all folders below `reports/` that hold a report, sorted.
///
/// # Errors
/// When `reports/` cannot be read.
pub fn reports() -> Result<Vec<String>, String> {
    let mut found = names("reports")?;
    found.retain(|name| root().join("reports").join(name).join("report.toml").is_file());
    found.sort();
    Ok(found)
}

/// The path of a source file inside its package: `number/ball.rs` for `crates/core/src/number/ball.rs`.
pub fn inside_package(path: &str) -> Option<&str> {
    PACKAGES.iter().rev().find_map(|package| path.strip_prefix(package)?.strip_prefix("src/"))
}

fn names(folder: &str) -> Result<Vec<String>, String> {
    let cannot = |error: std::io::Error| format!("{folder}: {error}");
    let name = |entry: std::io::Result<fs::DirEntry>| {
        entry.map(|entry| entry.file_name().to_string_lossy().into_owned()).map_err(cannot)
    };
    fs::read_dir(root().join(folder)).map_err(cannot)?.map(name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_and_reports_are_found() {
        let sources = sources().unwrap();
        for path in ["src/main.rs", "crates/core/src/lib.rs", "crates/plot/src/lib.rs"] {
            assert!(sources.iter().any(|found| found == path), "{path}");
        }
        assert!(reports().unwrap().contains(&"im-avouac".to_string()));
    }

    #[test]
    fn a_path_is_shortened_inside_its_package_only() {
        assert_eq!(inside_package("crates/core/src/number/ball.rs"), Some("number/ball.rs"));
        assert_eq!(inside_package("src/cli/mod.rs"), Some("cli/mod.rs"));
        assert_eq!(inside_package("tests/suite/main.rs"), None);
    }
}
