//! `src/archive/Cargo.lock`: the packages of `Cargo.lock` that the program is built from.
//!
//! Cargo writes another `Cargo.lock` into a package than a clone has. An archive contains this file instead, so that both make the
//! same archives.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

/// Our packages and their manifests.
const OWN: [(&str, &str); 6] = [
    ("slipmode", "Cargo.toml"),
    ("slipmode-algebra", "crates/algebra/Cargo.toml"),
    ("slipmode-certified", "crates/certified/Cargo.toml"),
    ("slipmode-core", "crates/core/Cargo.toml"),
    ("slipmode-plot", "crates/plot/Cargo.toml"),
    ("slipmode-theory", "crates/theory/Cargo.toml"),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn read(path: &str) -> Table {
    fs::read_to_string(root().join(path)).unwrap().parse().unwrap()
}

/// What one of our packages needs to be built on any system, its tests left out.
fn built_from(manifest: &Table) -> BTreeSet<String> {
    let tables = [manifest.get("dependencies"), manifest.get("build-dependencies")];
    let targets = manifest.get("target").and_then(Value::as_table).into_iter().flat_map(Table::values);
    let tables = tables.into_iter().chain(targets.map(|target| target.get("dependencies")));
    tables.flatten().filter_map(Value::as_table).flat_map(Table::keys).cloned().collect()
}

/// The blocks of `Cargo.lock`: those of packages that the program reaches, without those that only tests use.
fn wanted() -> String {
    let lock = fs::read_to_string(root().join("Cargo.lock")).unwrap();
    let own: BTreeMap<&str, BTreeSet<String>> =
        OWN.iter().map(|(name, manifest)| (*name, built_from(&read(manifest)))).collect();
    let (head, blocks) = lock.split_once("[[package]]\n").unwrap();
    let blocks: Vec<(String, String)> = blocks
        .split("[[package]]\n")
        .map(|block| {
            let package: Table = block.parse().unwrap();
            let text = |key: &str| package[key].as_str().unwrap().to_string();
            let name = text("name");
            let is_needed = |line: &&str| match (own.get(name.as_str()), line.strip_prefix(" \"")) {
                (Some(needed), Some(dependency)) => {
                    needed.contains(dependency.split(['"', ' ']).next().unwrap())
                }
                _ => true,
            };
            let lines: Vec<&str> = block.trim_end().lines().filter(is_needed).collect();
            (format!("{name} {}", text("version")), lines.join("\n"))
        })
        .collect();
    let mut reached = BTreeSet::new();
    let mut open = vec!["slipmode".to_string()];
    while let Some(name) = open.pop() {
        // A dependency is "name", or "name version" where there are several.
        let is_meant = |full: &str| full == name || full.split(' ').next() == Some(name.as_str());
        for (full, block) in blocks.iter().filter(|(full, _)| is_meant(full)) {
            if reached.insert(full.clone()) {
                let package: Table = block.parse().unwrap();
                let dependencies = package.get("dependencies").and_then(Value::as_array);
                let names = dependencies.into_iter().flatten().filter_map(Value::as_str);
                open.extend(names.map(String::from));
            }
        }
    }
    let kept = blocks.iter().filter(|(full, _)| reached.contains(full));
    let kept: Vec<String> = kept.map(|(_, block)| format!("[[package]]\n{block}\n")).collect();
    format!("{head}{}", kept.join("\n"))
}

#[test]
fn archives_name_the_packages_that_the_program_is_built_from() {
    const VARIABLE: &str = "SLIPMODE_WRITE_LOCK";
    let (place, wanted) = (root().join("src/archive/Cargo.lock"), wanted());
    assert!(wanted.contains("name = \"rug\"") && !wanted.contains("name = \"proptest\""));
    if std::env::var_os(VARIABLE).is_some() {
        fs::write(&place, &wanted).unwrap();
    }
    let found = fs::read_to_string(&place).unwrap_or_default();
    assert!(
        found == wanted,
        "Cargo.lock changed: run this test with {VARIABLE}=1, and commit {}",
        place.display()
    );
}
