//! Hands the compiler's version and a digest of the sources to the program, which name them in what it writes.
//!
//! The digest is the same for a clone and for the packages that cargo makes of it. So it leaves out what cargo rewrites there:
//! `Cargo.toml` and `Cargo.lock`. `src/archive/Cargo.lock` has the packages that the program is built from.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use sha2::{Digest, Sha256};

/// What this package is built from, besides its dependencies.
const SOURCES: [&str; 10] = [
    "CITATION.cff",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "build.rs",
    "proofs",
    "reports/im-avouac/claims.toml",
    "reports/im-avouac/equations.toml",
    "reports/im-avouac/proofs",
    "src",
    "templates",
];
/// Our other packages, in `crates`; the variable `DEP_SLIPMODE_<NAME>_ROOT` says where the sources of each are.
const LIBRARIES: [&str; 5] = ["algebra", "certified", "core", "plot", "theory"];

fn main() {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(compiler)
        .arg("--version")
        .output()
        .ok()
        .and_then(|output| String::from_utf8(output.stdout).ok())
        .unwrap_or_else(|| "rustc of unknown version".into());
    println!("cargo:rustc-env=SLIPMODE_RUSTC={}", version.trim());
    println!("cargo:rustc-env=SLIPMODE_SOURCE_SHA256={}", source_digest());
    let out = PathBuf::from(std::env::var_os("OUT_DIR").unwrap_or_default());
    for (name, folder, extension) in
        [("library.rs", "proofs", ".v"), ("stated_proofs.rs", "reports/im-avouac/proofs", ".toml")]
    {
        if let Err(error) = fs::write(out.join(name), library(folder, extension)) {
            println!("cargo:error={name}: {error}");
        }
    }
}

/// The files of a folder with an extension as an expression: their names without it and their texts, in the order of the names.
fn library(folder: &str, extension: &str) -> String {
    let root = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let mut files = Vec::new();
    collect(&root.join(folder), Path::new(""), &mut files);
    files.sort();
    let module = |(name, path): &(PathBuf, PathBuf)| {
        let module = name.to_str()?.strip_suffix(extension)?;
        Some(format!("({module:?}, include_str!({:?})),\n", path.to_str()?))
    };
    format!("[{}]", files.iter().filter_map(module).collect::<String>())
}

/// SHA-256 over the version, and over path, length and content of every source file in the order of their paths.
fn source_digest() -> String {
    let mut files = Vec::new();
    for source in SOURCES {
        collect(Path::new(source), Path::new(source), &mut files);
    }
    for library in LIBRARIES {
        let variable = format!("DEP_SLIPMODE_{}_ROOT", library.to_uppercase());
        println!("cargo:rerun-if-env-changed={variable}");
        let root = PathBuf::from(std::env::var_os(&variable).unwrap_or_default());
        for source in ["build.rs", "src"] {
            collect(&root.join(source), &Path::new("crates").join(library).join(source), &mut files);
        }
    }
    files.sort();
    let mut digest = Sha256::new();
    digest.update(std::env::var("CARGO_PKG_VERSION").unwrap_or_default());
    for (name, path) in files {
        println!("cargo:rerun-if-changed={}", path.display());
        let content = fs::read(&path).unwrap_or_default();
        digest.update(format!("{} {}\n", name.display(), content.len()));
        digest.update(content);
    }
    digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Adds the files of a path, each with its name in the repository.
fn collect(path: &Path, name: &Path, files: &mut Vec<(PathBuf, PathBuf)>) {
    let Ok(entries) = fs::read_dir(path) else {
        files.push((name.to_path_buf(), path.to_path_buf()));
        return;
    };
    // A file that is added or removed changes its folder.
    println!("cargo:rerun-if-changed={}", path.display());
    entries.flatten().for_each(|entry| collect(&entry.path(), &name.join(entry.file_name()), files));
}
