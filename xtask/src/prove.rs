//! `cargo xtask prove`: every certified step of every published ledger as a theorem that Coq checks.
//!
//! The program writes one file a claim below `target/proofs/generated`. Coq compiles it with the library in `proofs/`. A file
//! whose text, library and version of Coq are as before is not checked again, be it before on this machine or in the record
//! `proofs/checked.csv`; `--all` does without the record.

mod assumptions;
mod by_hand;
mod files;
mod record;
mod summary;
mod tie;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use crate::failure::Failure;
use crate::repository::{self, read, write};
use crate::{machine, process, verify};
use files::{library, names};
use record::Record;
use summary::Steps;
pub use tie::run as tie;

/// What is checked of each file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Every theorem is proved, and what it assumes is listed.
    Proofs,
    /// Every altered theorem is refused.
    Faults,
}

/// Checks all theorems, or all altered ones.
///
/// # Errors
/// With exit code 1 when a theorem assumes more than the real numbers' axioms, an altered one is not refused, or
/// the record of accepted theorems was another one; with 2 when Coq is missing.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (mode, record) = match words[..] {
        [] => (Mode::Proofs, Record::read()),
        ["--all"] => (Mode::Proofs, Record::default()),
        ["--planted-faults"] => (Mode::Faults, Record::default()),
        _ => return Err(Failure::bad_input("prove takes `--all`, `--planted-faults` or nothing")),
    };
    let start = Instant::now();
    let folder = repository::root().join("target/proofs");
    machine::require(&["coqc", "coquelicot", "coq-interval"])?;
    let version = process::output(Command::new("coqc").arg("--print-version"))?.trim().to_owned();
    machine::run()?;
    verify::build()?;
    let generated = generate(&folder)?;
    let library = library(&repository::root().join("proofs"))?;
    let mut files = generated_files(&generated, mode)?;
    match mode {
        Mode::Proofs => {
            by_hand::second_opinion()?;
            files.push(library_check(&library));
        }
        Mode::Faults => {
            files.extend(by_hand::altered(
                &library,
                &read(&repository::root().join("proofs/equations.csv"))?,
            )?);
        }
    }
    let digests = digests(&files, &version, &library)?;
    let (mut checked, left) = as_recorded(files, &record, &digests);
    if !left.is_empty() {
        compile_library(&folder, &version, &library)?;
        checked.extend(check_all(&folder, left, &version, &library)?);
    }
    let steps = Steps::read(&read(&generated.join("steps.tsv"))?, &read(&generated.join("files.tsv"))?)?;
    let result = summary::print(&steps, &checked, mode);
    println!("prove: {:.0} s", start.elapsed().as_secs_f64());
    let accepted = result?;
    if mode == Mode::Faults {
        return Ok(());
    }
    if record.update(&checked, &digests)? {
        println!(
            "prove: proofs/checked.csv records what was checked now: commit it, and nobody checks it again"
        );
    }
    write_accepted(&accepted)
}

/// The digest of each file with all on which it rests.
fn digests(
    tasks: &[Task],
    version: &str,
    library: &[(String, String)],
) -> Result<BTreeMap<String, String>, Failure> {
    let digest = |task: &Task| {
        let text = format!("{version}\n{}\n{}", files::imported(library, &task.text), task.text);
        Ok((task.file.clone(), repository::digest(&text)?))
    };
    tasks.iter().map(digest).collect()
}

/// The files of which the record knows what Coq says, and the others.
fn as_recorded(
    tasks: Vec<Task>,
    record: &Record,
    digests: &BTreeMap<String, String>,
) -> (Vec<(Task, Said)>, Vec<Task>) {
    let (mut known, mut left, mut commits) = (Vec::new(), Vec::new(), BTreeSet::new());
    for task in tasks {
        if let Some((said, commit)) = record.known(&task.file, &digests[&task.file]) {
            commits.insert(commit);
            known.push((task, said));
        } else {
            left.push(task);
        }
    }
    if !known.is_empty() {
        println!(
            "prove: {} of {} files are as they were when Coq checked them, at commit {}; `prove --all` checks them again",
            known.len(),
            known.len() + left.len(),
            Vec::from_iter(commits).join(", ")
        );
    }
    (known, left)
}

/// Writes the record of accepted theorems, from which the ledger knows what Coq has checked.
fn write_accepted(text: &str) -> Result<(), Failure> {
    let path = repository::root().join("proofs/accepted.txt");
    if read(&path).is_ok_and(|known| known == text) {
        return Ok(());
    }
    write(&path, text)?;
    Err(Failure::check("proofs/accepted.txt was not the list of accepted theorems; it is now: commit it"))
}

/// Has the program write the theorems of all published ledgers.
fn generate(folder: &Path) -> Result<PathBuf, Failure> {
    let generated = folder.join("generated");
    if generated.exists() {
        fs::remove_dir_all(&generated).map_err(|error| repository::failure(&generated, &error))?;
    }
    let mut command = verify::slipmode(&["theorems", "--out"]);
    command.arg(&generated);
    // A step of several ledgers becomes a theorem of the first one. Reports with theorems written by hand come first: they keep it
    // where Coq does not accept another file of a report without any.
    let tied = read(&repository::root().join("proofs/claims.csv"))?;
    let mut reports = repository::reports()?;
    reports.sort_by_key(|report| !tied.lines().any(|line| line.starts_with(&format!("{report},"))));
    for report in reports {
        let ledger = format!("reports/{report}/published/ledger.json");
        if repository::root().join(&ledger).is_file() {
            command.arg(format!("reports/{report}"));
        } else {
            println!("prove: reports/{report} has no published ledger yet");
        }
    }
    process::check(&mut command)?;
    Ok(generated)
}

/// Compiles the hand-written library, unless the same text was compiled with the same version before.
fn compile_library(folder: &Path, version: &str, modules: &[(String, String)]) -> Result<(), Failure> {
    let text: String = modules.iter().map(|(_, text)| text.as_str()).collect();
    let key = format!("{version}\n{text}");
    let (place, seal) = (folder.join("library"), folder.join("library/compiled"));
    if read(&seal).is_ok_and(|known| known == key) {
        return Ok(());
    }
    println!("prove: compiling proofs/ with Coq {version}");
    for (name, text) in modules {
        files::check_text(&format!("proofs/{name}.v"), text)?;
        let path = place.join(format!("{name}.v"));
        write(&path, text)?;
        process::check(&mut coqc(folder, &path))?;
    }
    write(&seal, &key)
}

/// A file that asks what the lemmas of the library assume.
fn library_check(library: &[(String, String)]) -> Task {
    let modules: Vec<&str> = library.iter().map(|(name, _)| name.as_str()).collect();
    let stated = |word| {
        let modules = library.iter();
        modules.flat_map(move |(module, text)| {
            names(text, word).into_iter().map(move |name| format!("{module}.{name}"))
        })
    };
    let theorems: Vec<String> = stated("Theorem ").chain(stated("Lemma ")).collect();
    let text = format!(
        "From Slipmode Require Import {}.\nDefinition all_theorems := (@{}).\nPrint Assumptions all_theorems.\n",
        modules.join(" "),
        theorems.join(", @")
    );
    Task { file: "library".to_owned(), text, theorems }
}

fn coqc(folder: &Path, path: &Path) -> Command {
    let mut command = Command::new("coqc");
    // Some tactics leave a cache in the folder in which they run.
    command.current_dir(folder);
    command.args(["-q", "-noglob", "-w", "-all", "-R"]).arg(folder.join("library")).arg("Slipmode").arg(path);
    command
}

/// A file for Coq.
pub struct Task {
    /// The path below the folder of generated files, without its ending.
    pub file: String,
    text: String,
    /// Names of the theorems, or of the altered ones.
    pub theorems: Vec<String>,
}

/// What Coq said of a file: standard output when Coq accepted it; its message otherwise.
pub type Said = Result<String, String>;

/// The generated files of theorems, or of altered ones.
fn generated_files(generated: &Path, mode: Mode) -> Result<Vec<Task>, Failure> {
    let mut tasks = Vec::new();
    for path in repository::below(generated)? {
        let Some(file) = path.strip_suffix(".v") else { continue };
        if file.ends_with("_faults") == (mode == Mode::Faults) {
            let text = read(&generated.join(&path))?;
            files::check_text(file, &text)?;
            let theorems = names(&text, if mode == Mode::Faults { "Lemma fault_" } else { "Theorem " });
            tasks.push(Task { file: file.to_owned(), text, theorems });
        }
    }
    Ok(tasks)
}

/// Checks files, the largest first, as many side by side as there are processors.
fn check_all(
    folder: &Path,
    mut tasks: Vec<Task>,
    version: &str,
    library: &[(String, String)],
) -> Result<Vec<(Task, Said)>, Failure> {
    tasks.sort_by_key(|task| task.text.len());
    let (waiting, checked) = (Mutex::new(tasks), Mutex::new(Vec::new()));
    let next = || waiting.lock().unwrap_or_else(PoisonError::into_inner).pop();
    let work = || {
        while let Some(task) = next() {
            let base = format!("{version}\n{}", files::imported(library, &task.text));
            let said = check(folder, &task, &base);
            checked.lock().unwrap_or_else(PoisonError::into_inner).push(said.map(|said| (task, said)));
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    checked.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().collect()
}

/// Coq's output for this file, from the last run if nothing has changed since.
fn check(folder: &Path, task: &Task, base: &str) -> Result<Said, Failure> {
    let path = folder.join("checked").join(format!("{}.v", task.file));
    let (seal, known) = (path.with_extension("seal"), path.with_extension("out"));
    let key = format!("{base}\n{}", task.text);
    if read(&seal).is_ok_and(|sealed| sealed == key) {
        return Ok(Ok(read(&known)?));
    }
    write(&path, &task.text)?;
    let start = Instant::now();
    let output = coqc(folder, &path).output();
    let output = output.map_err(|error| Failure::bad_input(format!("coqc cannot be run: {error}")))?;
    println!("prove: {} {:.0} s", task.file, start.elapsed().as_secs_f64());
    if !output.status.success() {
        return Ok(by_hand::refusal(task, String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    let output = String::from_utf8_lossy(&output.stdout).into_owned();
    write(&known, &output)?;
    write(&seal, &key)?;
    Ok(Ok(output))
}
