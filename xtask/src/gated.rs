//! `cargo xtask gated STEP`: runs a long step of continuous integration, unless its inputs are as they were when it last passed.
//!
//! The inputs of a step are all files that git tracks, without those that `.ci/not_inputs.csv` lists with a reason. So a new file is
//! an input of every step. `.ci/green.csv` has the digest of the inputs of each step's last run that passed.
//! Whatever cannot be read, or is not committed, makes the step run.

use std::path::Path;
use std::process::Command;

use crate::failure::Failure;
use crate::repository::{commit, digest, git, read, root, write};
use crate::test::Step;
use crate::{machine, process, validate, wheel};

const NOT_INPUTS: &str = ".ci/not_inputs.csv";
const GREEN: &str = ".ci/green.csv";
const HEADER: &str = "step,digest,commit,date\n";

/// The steps, each with what it runs.
const STEPS: &[Step] = &[
    #[cfg(target_os = "linux")]
    ("cluster-test", crate::cluster_test::run),
    ("package", || process::check(&mut Command::new(root().join(".ci/package")))),
    ("sources", crate::sources::try_out),
    ("validate", validate::run),
    ("wheel", || wheel::run(&["--test".into()])),
];

/// Runs a step whose inputs have changed, or any with `--all`; `--record` writes down that it passed.
///
/// # Errors
/// Those of the step; with exit code 2 when nothing can be recorded.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    let (options, names): (Vec<&str>, Vec<&str>) =
        arguments.iter().map(String::as_str).partition(|word| word.starts_with("--"));
    let known = |name: &str| STEPS.iter().find(|(step, _)| *step == name);
    let (Some((step, action)), [_]) = (names.first().and_then(|name| known(name)), &names[..]) else {
        let steps: Vec<&str> = STEPS.iter().map(|(step, _)| *step).collect();
        let steps = steps.join(", ");
        return Err(Failure::bad_input(format!("`gated` takes one of {steps}, and `--all` or `--record`")));
    };
    if let Some(unknown) = options.iter().find(|option| !["--all", "--record"].contains(option)) {
        return Err(Failure::bad_input(format!("`gated` does not know `{unknown}`")));
    }
    let is_recorded = options.contains(&"--record");
    if is_recorded && !machine::is_continuous_integration() {
        return Err(Failure::bad_input(
            "`--record` needs CI to be set: other runs may skip a part of a step",
        ));
    }
    let before = inputs(&root(), step);
    match (&before, options.contains(&"--all")) {
        (_, true) => println!("{step}: runs, as `--all` says"),
        (Err(reason), _) => println!("{step}: runs: {reason}"),
        (Ok(digest), _) => match passed(&root(), step, digest) {
            Some(run) => {
                println!("{step}: left out: it passed with the same inputs at {run}; `--all` runs it");
                return Ok(());
            }
            None => println!("{step}: runs: no passed run with these inputs is recorded in {GREEN}"),
        },
    }
    action()?;
    if !is_recorded {
        return Ok(());
    }
    match (before, inputs(&root(), step)) {
        (Ok(before), Ok(after)) if before == after => record(&root(), step, &after),
        (_, Err(reason)) => Err(Failure::bad_input(format!("{step}: passed, but is not recorded: {reason}"))),
        _ => Err(Failure::bad_input(format!(
            "{step}: passed, but is not recorded: its inputs changed meanwhile"
        ))),
    }
}

/// The digest of a step's inputs, or why it is not known.
fn inputs(root: &Path, step: &str) -> Result<String, String> {
    let text = read(&root.join(NOT_INPUTS)).map_err(|failure| failure.message)?;
    let mut paths = vec![":/".to_owned()];
    for row in text.lines().skip(1) {
        let [of, path, _reason] = row.splitn(3, ',').collect::<Vec<_>>()[..] else {
            return Err(format!("{NOT_INPUTS}: `{row}` is not step,path,reason"));
        };
        if of == "*" || of == step {
            paths.push(format!(":(top,exclude,glob){path}"));
        }
    }
    let ask = |words: &[&str]| {
        process::output(git(root, words).arg("--").args(&paths)).map_err(|failure| failure.message)
    };
    let changes = ask(&["status", "--porcelain", "--untracked-files=all"])?;
    if let Some(change) = changes.lines().next() {
        return Err(format!("its inputs have changes that are not committed, such as `{}`", change.trim()));
    }
    digest(&ask(&["ls-files", "--stage"])?).map_err(|failure| failure.message)
}

/// Commit and date of the step's run that passed with these inputs.
fn passed(root: &Path, step: &str, digest: &str) -> Option<String> {
    let table = read(&root.join(GREEN)).ok()?;
    table.lines().find_map(|row| match row.split(',').collect::<Vec<_>>()[..] {
        [of, recorded, commit, date] if of == step && recorded == digest => {
            Some(format!("{commit} ({date})"))
        }
        _ => None,
    })
}

/// Writes the step's row.
fn record(root: &Path, step: &str, digest: &str) -> Result<(), Failure> {
    let known = read(&root.join(GREEN)).unwrap_or_default();
    let is_other = |row: &&str| !row.starts_with(&format!("{step},"));
    let mut rows: Vec<String> =
        known.lines().skip(1).filter(is_other).map(|row| format!("{row}\n")).collect();
    let date = process::output(Command::new("date").args(["-u", "+%F"]))?;
    rows.push(format!("{step},{digest},{},{}\n", commit(root)?, date.trim()));
    rows.sort();
    println!("{step}: {GREEN} records this run: commit it");
    write(&root.join(GREEN), &format!("{HEADER}{}", rows.concat()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    /// A repository with a source, a document that is no input, and both tables.
    fn repository(name: &str) -> std::path::PathBuf {
        let place = std::env::temp_dir().join(format!("slipmode-gated-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&place);
        write(&place.join("src/a.rs"), "a").unwrap();
        write(&place.join("docs/a.md"), "a").unwrap();
        write(
            &place.join(NOT_INPUTS),
            "step,path,reason\n*,docs/**,for readers\nwheel,src/a*,x\n*,.ci/*.csv,x\n",
        )
        .unwrap();
        process::output(&mut git(&place, &["init", "--quiet"])).unwrap();
        commit_all(&place);
        place
    }

    fn commit_all(place: &Path) {
        process::output(&mut git(place, &["add", "--all"])).unwrap();
        let who = ["-c", "user.name=t", "-c", "user.email=t@t", "-c", "commit.gpgsign=false"];
        process::output(git(place, &who).args(["commit", "--quiet", "--message", "m"])).unwrap();
    }

    fn is_left_out(place: &Path, step: &str) -> bool {
        inputs(place, step).is_ok_and(|digest| passed(place, step, &digest).is_some())
    }

    #[test]
    fn a_step_is_left_out_only_while_its_inputs_are_as_they_were() {
        let place = repository("left-out");
        assert!(!is_left_out(&place, "validate"), "without a record every step runs");
        record(&place, "validate", &inputs(&place, "validate").unwrap()).unwrap();
        record(&place, "wheel", &inputs(&place, "wheel").unwrap()).unwrap();
        assert!(is_left_out(&place, "validate") && is_left_out(&place, "wheel"));
        assert!(!is_left_out(&place, "package"), "the record of another step does not count");
        write(&place.join("docs/a.md"), "b").unwrap();
        assert!(is_left_out(&place, "validate"), "a document is no input");
        write(&place.join("src/a.rs"), "b").unwrap();
        assert!(inputs(&place, "validate").unwrap_err().contains("src/a.rs"), "not committed");
        assert!(is_left_out(&place, "wheel"));
        commit_all(&place);
        assert!(!is_left_out(&place, "validate") && is_left_out(&place, "wheel"));
        record(&place, "validate", &inputs(&place, "validate").unwrap()).unwrap();
        assert_eq!(read(&place.join(GREEN)).unwrap().matches("validate,").count(), 1, "one row a step");
        write(&place.join("src/b/new.rs"), "").unwrap();
        assert!(inputs(&place, "validate").is_err(), "a file that git does not track yet is an input");
        fs::remove_dir_all(place).unwrap();
    }

    #[test]
    fn without_tables_or_git_every_step_runs() {
        let place = repository("broken");
        record(&place, "validate", &inputs(&place, "validate").unwrap()).unwrap();
        let green = read(&place.join(GREEN)).unwrap();
        write(&place.join(GREEN), &green.replace(',', ";")).unwrap();
        assert!(!is_left_out(&place, "validate"));
        write(&place.join(GREEN), &format!("<<<<<<<\n{green}=======\n{green}>>>>>>>\n")).unwrap();
        assert!(is_left_out(&place, "validate"), "a whole row counts wherever it stands");
        write(&place.join(NOT_INPUTS), "step,path,reason\n*,docs\n").unwrap();
        assert!(inputs(&place, "validate").is_err());
        fs::remove_file(place.join(NOT_INPUTS)).unwrap();
        assert!(inputs(&place, "validate").is_err());
        fs::remove_dir_all(place.join(".git")).unwrap();
        assert!(inputs(&place, "validate").is_err());
        fs::remove_dir_all(place).unwrap();
    }

    #[test]
    fn a_clone_without_history_has_the_same_digests() {
        let (place, clone) = (repository("whole"), repository("clone"));
        write(&place.join("src/a.rs"), "b").unwrap();
        commit_all(&place);
        fs::remove_dir_all(&clone).unwrap();
        let from = format!("file://{}", place.display());
        let to = clone.display().to_string();
        process::output(&mut git(&place, &["clone", "--quiet", "--depth", "1", &from, &to])).unwrap();
        assert_eq!(inputs(&place, "validate").unwrap(), inputs(&clone, "validate").unwrap());
        fs::remove_dir_all(place).unwrap();
        fs::remove_dir_all(clone).unwrap();
    }

    #[test]
    fn every_row_names_a_step_and_files_that_exist_and_gives_a_reason() {
        for row in read(&root().join(NOT_INPUTS)).unwrap().lines().skip(1) {
            let fields: Vec<&str> = row.splitn(3, ',').collect();
            assert!(fields[0] == "*" || STEPS.iter().any(|(step, _)| *step == fields[0]), "{row}");
            assert!(fields[2].len() > 10, "{row}");
            let found =
                git(&root(), &["ls-files", "--", &format!(":(top,glob){}", fields[1])]).output().unwrap();
            assert!(!found.stdout.is_empty() || fields[1] == GREEN, "no file: {row}");
        }
    }

    #[test]
    fn an_unknown_step_or_option_is_bad_usage() {
        for words in [&["verify"][..], &[], &["wheel", "package"], &["wheel", "--fast"]] {
            let words: Vec<String> = words.iter().map(ToString::to_string).collect();
            assert_eq!(run(&words).unwrap_err().code, 2);
        }
    }
}
