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

use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::{iter, thread};

use crate::prelude::*;
use crate::repository;
use crate::{machine, verify};
use files::{Library, library, names};
use record::{Record, TABLE};
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

/// The digest of each file with all on which it rests.
pub type Digests = BTreeMap<String, String>;

/// Checks all theorems, or all altered ones.
///
/// # Errors
/// With exit code 1 when a theorem assumes more than the real numbers' axioms, an altered one is not refused, or
/// the record of accepted theorems was another one; with 2 when Coq is missing.
pub fn run(option: &str) -> Result {
    let mode = if option == "--planted-faults" { Mode::Faults } else { Mode::Proofs };
    let record = if option.is_empty() { Record::read() } else { Record::default() };
    let start = Instant::now();
    machine::require(&["coqc", "coquelicot", "coq-interval"])?;
    let version = program("coqc", "--print-version").text()?.trim().to_owned();
    verify::build()?;
    let folder = root().join("target/proofs");
    let generated = generate(&folder)?;
    let coq = Coq { folder, version, library: library(&root().join("proofs"))? };
    let mut tasks = generated_tasks(&generated, mode)?;
    if mode == Mode::Proofs {
        by_hand::second_opinion()?;
        tasks.push(library_check(&coq.library));
    } else {
        tasks.extend(by_hand::altered(&coq.library, &read(&root().join("proofs/equations.csv"))?)?);
    }
    let digests = tasks.iter().map(|task| Ok((task.file.clone(), coq.digest(task)?)));
    let digests = digests.collect::<Result<Digests>>()?;
    let (mut checked, left) = record.split(tasks, &digests);
    if !left.is_empty() {
        coq.compile_library()?;
        checked.extend(coq.check_all(left, &digests)?);
    }
    let steps = Steps::read(&read(&generated.join("steps.tsv"))?, &read(&generated.join("files.tsv"))?)?;
    let result = summary::print(&steps, &checked, mode);
    println!("prove: {:.0} s", start.elapsed().as_secs_f64());
    let accepted = result?;
    if mode == Mode::Faults {
        return Ok(());
    }
    if record.update(&checked, &digests)? {
        println!("prove: {TABLE} records what was checked now: commit it, and nobody checks it again");
    }
    // From this record the ledger knows what Coq has checked.
    let differs = repository::rewrite(&root().join("proofs/accepted.txt"), &accepted)?;
    let wrong = "proofs/accepted.txt was not the list of accepted theorems; it is now: commit it";
    ensure(!differs, || Failure::check(wrong))
}

/// Has the program write the theorems of all published ledgers.
fn generate(folder: &Path) -> Result<PathBuf> {
    let generated = folder.join("generated");
    fs::remove_dir_all(&generated).ok();
    let mut command = verify::slipmode("theorems --out");
    command.arg(&generated);
    // A step of several ledgers becomes a theorem of the first one. Reports with theorems written by hand come first: they keep it
    // where Coq does not accept another file of a report without any.
    let tied = read(&root().join("proofs/claims.csv"))?;
    let mut reports = repository::reports()?;
    reports.sort_by_key(|report| !tied.lines().any(|line| line.starts_with(&format!("{report},"))));
    for folder in reports.iter().map(|report| format!("reports/{report}")) {
        if root().join(&folder).join("published/ledger.json").is_file() {
            command.arg(folder);
        } else {
            println!("prove: {folder} has no published ledger yet");
        }
    }
    command.check()?;
    Ok(generated)
}

/// The generated files of theorems, or of altered ones.
fn generated_tasks(generated: &Path, mode: Mode) -> Result<Vec<Task>> {
    let mut tasks = Vec::new();
    for (file, text) in repository::texts(generated, ".v")? {
        if file.ends_with("_faults") == (mode == Mode::Faults) {
            files::check_text(&file, &text)?;
            let theorems = names(&text, if mode == Mode::Faults { "Lemma fault_" } else { "Theorem " });
            tasks.push(Task { theorems: theorems.map(str::to_owned).collect(), file, text });
        }
    }
    Ok(tasks)
}

/// A file that asks what the lemmas of the library assume.
fn library_check(library: &Library) -> Task {
    let modules: Vec<&str> = library.iter().map(|(name, _)| name.as_str()).collect();
    let mut theorems = Vec::new();
    for word in ["Theorem ", "Lemma "] {
        for (module, text) in library {
            theorems.extend(names(text, word).map(|name| format!("{module}.{name}")));
        }
    }
    let text = format!(
        "From Slipmode Require Import {}.\nDefinition all_theorems := (@{}).\nPrint Assumptions all_theorems.\n",
        modules.join(" "),
        theorems.join(", @")
    );
    Task { file: "library".to_owned(), text, theorems }
}

/// Coq's version, the hand-written library, and the folder of what is compiled.
struct Coq {
    folder: PathBuf,
    version: String,
    library: Library,
}

impl Coq {
    fn compile(&self, path: &Path) -> Command {
        let mut command = program("coqc", "-q -noglob -w -all -R");
        // Some tactics leave a cache in the folder in which they run.
        command.current_dir(&self.folder).arg(self.folder.join("library")).arg("Slipmode").arg(path);
        command
    }

    /// The digest of a file with all on which it rests.
    fn digest(&self, task: &Task) -> Result<String> {
        let imported = files::imported(&self.library, &task.text);
        repository::digest(&format!("{}\n{imported}\n{}", self.version, task.text))
    }

    /// Compiles the library, unless the same text was compiled with the same version before.
    fn compile_library(&self) -> Result {
        let text: String = self.library.iter().map(|(_, text)| text.as_str()).collect();
        let key = format!("{}\n{text}", self.version);
        let place = self.folder.join("library");
        once(&place.join("compiled"), &key, || {
            println!("prove: compiling proofs/ with Coq {}", self.version);
            self.library.iter().try_for_each(|(name, text)| {
                files::check_text(&format!("proofs/{name}.v"), text)?;
                let path = place.join(format!("{name}.v"));
                write(&path, text)?;
                self.compile(&path).check()
            })
        })
    }

    /// Checks files, the largest first, as many side by side as there are processors.
    fn check_all(&self, mut tasks: Vec<Task>, digests: &Digests) -> Result<Vec<(Task, Said)>> {
        tasks.sort_by_key(|task| task.text.len());
        let waiting = Mutex::new(tasks);
        let next = || waiting.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let check = |task: Task| self.check(&task, &digests[&task.file]).map(|said| (task, said));
        let work = || iter::from_fn(next).map(check).collect::<Vec<_>>();
        thread::scope(|scope| {
            let processors = thread::available_parallelism().map_or(1, usize::from);
            let workers: Vec<_> = (0..processors).map(|_| scope.spawn(work)).collect();
            workers.into_iter().flat_map(|it| it.join().unwrap_or_else(|why| resume_unwind(why))).collect()
        })
    }

    /// Coq's output for this file, from the last run if its digest is as it was then.
    fn check(&self, task: &Task, digest: &str) -> Result<Said> {
        let path = self.folder.join("checked").join(format!("{}.v", task.file));
        let (seal, known) = (path.with_extension("seal"), path.with_extension("out"));
        if read(&seal).is_ok_and(|sealed| sealed == digest) {
            return read(&known).map(Ok);
        }
        write(&path, &task.text)?;
        let start = Instant::now();
        let output = self.compile(&path).output().map_err(at("coqc".as_ref()))?;
        println!("prove: {} {:.0} s", task.file, start.elapsed().as_secs_f64());
        if !output.status.success() {
            return Ok(by_hand::refusal(task, String::from_utf8_lossy(&output.stderr).trim().to_owned()));
        }
        let output = String::from_utf8_lossy(&output.stdout).into_owned();
        write(&known, &output)?;
        write(&seal, digest)?;
        Ok(Ok(output))
    }
}
