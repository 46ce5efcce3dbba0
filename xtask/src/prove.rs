//! `cargo xtask prove`: every certified step of every published ledger as a theorem that Coq checks.
//!
//! The program writes one file a claim below `target/proofs/generated`. Coq compiles it with the library in `proofs/`. A file
//! whose text, library and version of Coq are as before is not checked again.

mod assumptions;
mod files;
mod summary;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use crate::failure::Failure;
use crate::{machine, process, repository, verify};
use files::{library, read, write};

/// Debian's packages, each with what shows that it is installed.
const PACKAGES: [(&str, &str); 2] = [
    ("coq", "From Coq Require Import Reals."),
    ("libcoq-coquelicot", "From Coquelicot Require Import Coquelicot."),
];

/// Processes of Coq that run side by side.
const PROCESSES: usize = 2;

/// What is checked of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Every theorem is proved, and what it assumes is listed.
    Proofs,
    /// Every altered theorem is refused; with `true` the first of each file only.
    Faults(bool),
}

/// Checks all theorems, or all altered ones.
///
/// # Errors
/// With exit code 1 when a theorem is not proved, assumes more than the real numbers' axioms, or an altered one is not refused;
/// with 2 when Coq is missing.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let mode = match words[..] {
        [] => Mode::Proofs,
        ["--planted-faults"] => Mode::Faults(false),
        ["--planted-faults", "sample"] => Mode::Faults(true),
        _ => {
            return Err(Failure::bad_input(
                "prove takes no argument, `--planted-faults` or `--planted-faults sample`",
            ));
        }
    };
    let folder = repository::root().join("target/proofs");
    let version = require_coq(&folder)?;
    machine::run()?;
    verify::build_release()?;
    let generated = generate(&folder)?;
    let library = compile_library(&folder, &version)?;
    let start = Instant::now();
    let checked = check_all(&folder, &generated, mode, &format!("{version}\n{library}"))?;
    let steps = read(&generated.join("steps.tsv"))?;
    summary::print(&steps, &checked, mode, start.elapsed())
}

/// The version of Coq, which is installed where that is possible.
fn require_coq(folder: &Path) -> Result<String, Failure> {
    let missing = || -> Result<Vec<&str>, Failure> {
        let mut missing = Vec::new();
        for (package, text) in PACKAGES {
            let probe = folder.join("probe/probe.v");
            write(&probe, text)?;
            let found = Command::new("coqc")
                .arg("-q")
                .arg(&probe)
                .output()
                .is_ok_and(|output| output.status.success());
            if !found {
                missing.push(package);
            }
        }
        Ok(missing)
    };
    let before = missing()?;
    if !before.is_empty() && machine::can_install() {
        machine::install_packages(&before)?;
    }
    let still = if before.is_empty() { before } else { missing()? };
    if !still.is_empty() {
        let list = still.join(" ");
        return Err(Failure::bad_input(format!("missing {list}; Debian, Ubuntu: apt-get install {list}")));
    }
    Ok(process::output(Command::new("coqc").arg("--print-version"))?.trim().to_owned())
}

/// Has the program write the theorems of all published ledgers.
fn generate(folder: &Path) -> Result<PathBuf, Failure> {
    let generated = folder.join("generated");
    if generated.exists() {
        fs::remove_dir_all(&generated).map_err(|error| files::failure(&generated, &error))?;
    }
    let run = ["run", "--release", "--locked", "--quiet", "--bin", "slipmode", "--", "theorems", "--out"];
    let mut command = process::cargo(&run);
    command.arg(&generated);
    for report in repository::reports()? {
        let ledger = format!("reports/{report}/published/ledger.json");
        if repository::root().join(&ledger).is_file() {
            command.arg(format!("{report}={ledger}"));
        } else {
            println!("prove: reports/{report} has no published ledger yet");
        }
    }
    process::check(&mut command)?;
    Ok(generated)
}

/// Compiles the hand-written library, unless the same text was compiled with the same version before. Its text.
fn compile_library(folder: &Path, version: &str) -> Result<String, Failure> {
    let modules = library(&repository::root().join("proofs"))?;
    let text: String = modules.iter().map(|(_, text)| text.as_str()).collect();
    let key = format!("{version}\n{text}");
    let (place, seal) = (folder.join("library"), folder.join("library/compiled"));
    if read(&seal).is_ok_and(|known| known == key) {
        return Ok(text);
    }
    println!("prove: compiling proofs/ with Coq {version}");
    for (name, text) in &modules {
        files::check_text(&format!("proofs/{name}.v"), text)?;
        let path = place.join(format!("{name}.v"));
        write(&path, text)?;
        process::check(&mut coqc(folder, &path))?;
    }
    write(&seal, &key)?;
    Ok(text)
}

fn coqc(folder: &Path, path: &Path) -> Command {
    let mut command = Command::new("coqc");
    command.args(["-q", "-w", "-all", "-R"]).arg(folder.join("library")).arg("Slipmode").arg(path);
    command
}

/// What Coq said of one file.
pub struct Checked {
    /// The path below the folder of generated files, without its ending.
    pub file: String,
    /// Standard output, when Coq accepted the file; its message otherwise.
    pub output: Result<String, String>,
    /// Names of the theorems in the file.
    pub theorems: Vec<String>,
}

/// Checks all generated files, the largest first.
fn check_all(folder: &Path, generated: &Path, mode: Mode, base: &str) -> Result<Vec<Checked>, Failure> {
    let mut queue: Vec<(String, String)> = Vec::new();
    for path in files::below(generated)? {
        let Some(name) = path.strip_suffix(".v") else { continue };
        if name.ends_with("_faults") == (mode != Mode::Proofs) {
            let text = read(&generated.join(&path))?;
            files::check_text(name, &text)?;
            queue.push((
                name.to_owned(),
                if mode == Mode::Faults(true) { files::first_lemma(&text) } else { text },
            ));
        }
    }
    queue.sort_by_key(|(_, text)| std::cmp::Reverse(text.len()));
    let (next, found) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    let work = || -> Result<(), Failure> {
        while let Some((name, text)) = queue.get(next.fetch_add(1, Ordering::Relaxed)) {
            let output = check(folder, name, text, base)?;
            let theorems = files::names(text, if mode == Mode::Proofs { "Theorem " } else { "Lemma " });
            let checked = Checked { file: name.clone(), output, theorems };
            if let Ok(mut found) = found.lock() {
                found.insert(name.clone(), checked);
            }
        }
        Ok(())
    };
    let ended = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..PROCESSES).map(|_| scope.spawn(work)).collect();
        threads.into_iter().map(|thread| thread.join()).collect::<Vec<_>>()
    });
    for end in ended {
        end.map_err(|_| Failure::check("a thread ended early"))??;
    }
    Ok(found.into_inner().map_err(|_| Failure::check("a thread ended early"))?.into_values().collect())
}

/// Coq's output for this text, from the last run if nothing has changed since.
fn check(folder: &Path, name: &str, text: &str, base: &str) -> Result<Result<String, String>, Failure> {
    let path = folder.join("checked").join(format!("{name}.v"));
    let (seal, said) = (path.with_extension("seal"), path.with_extension("out"));
    let key = format!("{base}\n{text}");
    if read(&seal).is_ok_and(|known| known == key) {
        return Ok(Ok(read(&said)?));
    }
    write(&path, text)?;
    let start = Instant::now();
    let output = coqc(folder, &path).output();
    let output = output.map_err(|error| Failure::bad_input(format!("coqc cannot be run: {error}")))?;
    println!("prove: {name} {:.0} s", start.elapsed().as_secs_f64());
    if !output.status.success() {
        return Ok(Err(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    let output = String::from_utf8_lossy(&output.stdout).into_owned();
    write(&said, &output)?;
    write(&seal, &key)?;
    Ok(Ok(output))
}
