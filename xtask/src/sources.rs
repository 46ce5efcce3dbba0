//! `cargo xtask sources`: the sources of the program with all packages that it is built from, as one file that builds without a network.
//!
//! The step `sources` of continuous integration then does what the README of an archive says, in an empty folder, with an empty folder of
//! cargo and, where the system allows it, without a network.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::failure::Failure;
use crate::repository::{failure, read, root, write};
use crate::{machine, process, verify};

/// The folder in the file.
const NAME: &str = "slipmode-sources";

/// The packages of the program, each with its folder.
const PACKAGES: [[&str; 2]; 4] = [
    ["slipmode", ""],
    ["slipmode-algebra", "crates/algebra/"],
    ["slipmode-core", "crates/core/"],
    ["slipmode-plot", "crates/plot/"],
];

/// Files besides those of the packages.
const OTHERS: [&str; 2] = ["Cargo.lock", "Dockerfile"];

const VENDORED: &str =
    "[source.crates-io]\nreplace-with = \"vendored\"\n\n[source.vendored]\ndirectory = \"vendor\"\n";

/// Writes `target/sources/sources.tar.xz`.
///
/// # Errors
/// When a program is missing or a package cannot be listed or copied.
pub fn run() -> Result<(), Failure> {
    let file = make()?;
    let bytes = fs::metadata(&file).map_err(|error| failure(&file, &error))?.len();
    println!("{}: {bytes} bytes", file.display());
    Ok(())
}

fn workshop() -> PathBuf {
    root().join("target/sources")
}

fn make() -> Result<PathBuf, Failure> {
    machine::require(&["tar", "xz"])?;
    let staging = workshop().join(NAME);
    fs::remove_dir_all(&staging).ok();
    for [package, folder] in PACKAGES {
        let listing = ["package", "--list", "--allow-dirty", "--package", package];
        let listed = process::output(Command::new("cargo").args(listing).current_dir(root()))?;
        for path in listed.lines().map(|line| format!("{folder}{line}")) {
            // Cargo itself adds files to a package: those that the repository has are enough.
            if root().join(&path).is_file() {
                copy(&path, &staging)?;
            }
        }
        manifest(&staging.join(format!("{folder}Cargo.toml")))?;
    }
    OTHERS.iter().try_for_each(|path| copy(path, &staging))?;
    // Leaves the packages out of the lock that nothing needs any more, and moves no version.
    process::output(Command::new("cargo").args(["metadata", "--format-version", "1"]).current_dir(&staging))?;
    process::output(
        Command::new("cargo").args(["vendor", "--locked", "--quiet", "vendor"]).current_dir(&staging),
    )?;
    write(&staging.join(".cargo/config.toml"), VENDORED)?;
    let file = workshop().join("sources.tar.xz");
    let fixed =
        ["--sort=name", "--mtime=@0", "--owner=0", "--group=0", "--numeric-owner", "--mode=u+rw,go-w,a+rX"];
    process::check(
        Command::new("tar")
            .args(fixed)
            .args(["--create", "--xz", "--file"])
            .arg(&file)
            .arg(NAME)
            .env("XZ_OPT", "-6 -T1")
            .current_dir(workshop()),
    )?;
    Ok(file)
}

fn copy(path: &str, staging: &Path) -> Result<(), Failure> {
    let (from, to) = (root().join(path), staging.join(path));
    let folder = to.parent().unwrap_or(staging);
    fs::create_dir_all(folder).and_then(|()| fs::copy(&from, &to)).map_err(|error| failure(&from, &error))?;
    Ok(())
}

/// A manifest without what only tests and benchmarks need, and the workspace without the packages that are not here.
fn manifest(path: &Path) -> Result<(), Failure> {
    let text = read(path)?;
    let (mut kept, mut is_kept) = (String::new(), true);
    for line in text.lines() {
        if line.starts_with('[') {
            is_kept = !["[dev-dependencies", "[[bench", "[[test", "[[example"]
                .iter()
                .any(|section| line.starts_with(section));
        }
        if is_kept {
            let members = "members = [\"crates/algebra\", \"crates/core\", \"crates/plot\"]";
            kept += if line.starts_with("members = ") { members } else { line };
            kept.push('\n');
        }
    }
    write(path, &kept)
}

/// Archives a report with the sources, builds the program from the archive alone, and has it compute the report again.
///
/// # Errors
/// With exit code 1 when the program does not build, or finds another result.
pub fn try_out() -> Result<(), Failure> {
    let is_requested = std::env::args().any(|word| ["--all", "--record"].contains(&word.as_str()));
    if machine::is_continuous_integration() && !is_requested {
        println!("sources: left out: everything would be compiled once more; `--all` and `--record` run it");
        return Ok(());
    }
    let sources = make()?;
    verify::build()?;
    let place = workshop().join("trial");
    fs::remove_dir_all(&place).ok();
    fs::create_dir_all(&place).map_err(|error| failure(&place, &error))?;
    let archive = place.join("report.zip");
    process::check(
        verify::slipmode(&["archive", "reports/rice-ruina-1983", "--with-sources"])
            .arg(&sources)
            .arg("--output")
            .arg(&archive),
    )?;
    process::check(Command::new("python3").args(["-m", "zipfile", "-e"]).arg(&archive).arg(&place))?;
    let without_network = ["unshare", "--map-root-user", "--net"];
    let is_allowed = process::output(Command::new("unshare").args(&without_network[1..]).arg("true")).is_ok();
    let prefix = if is_allowed { without_network.join(" ") } else { String::new() };
    println!(
        "sources: building {}",
        if is_allowed {
            "without a network"
        } else {
            "with `--offline` alone: this system does not allow less"
        }
    );
    let steps = commands_of(&read(&place.join("README.md"))?)?;
    let home = place.join("cargo");
    let said = format!("set -e; {steps}\ncd ..\nprogram/bin/slipmode replay report.zip");
    let shell = if prefix.is_empty() { "sh -c \"$0\"".to_owned() } else { format!("{prefix} sh -c \"$0\"") };
    process::check(
        Command::new("sh")
            .args(["-c", &shell, &said])
            .current_dir(&place)
            .env("CARGO_HOME", &home)
            .env_remove("CARGO_TARGET_DIR")
            .env("CARGO_NET_OFFLINE", "true"),
    )?;
    fs::remove_dir_all(&place).map_err(|error| failure(&place, &error))
}

/// The commands of the first block for a shell.
fn commands_of(readme: &str) -> Result<String, Failure> {
    let block = readme.split("```sh\n").nth(1).and_then(|rest| rest.split("```").next());
    block.map(str::to_owned).ok_or_else(|| Failure::check("the README of the archive has no commands"))
}
