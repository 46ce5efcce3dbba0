//! `cargo xtask gated STEP`: runs a long step of continuous integration, unless its inputs are as they were when it last passed.
//!
//! The inputs of a step are all files that git tracks, without those that `.ci/not_inputs.csv` lists with a reason. So a new file is
//! an input of every step. `.ci/green.csv` has the digest of the inputs of each step's last run that passed.
//! Whatever cannot be read, or is not committed, makes the step run.

use crate::prelude::*;
use crate::repository::{commit, digest};
use crate::test::Step;
use crate::{machine, validate, wheel};

const NOT_INPUTS: &str = ".ci/not_inputs.csv";
const GREEN: &str = ".ci/green.csv";
const HEADER: &str = "step,digest,commit,date\n";

/// The steps, each with what it runs.
const STEPS: &[Step] = &[
    #[cfg(target_os = "linux")]
    ("cluster-test", crate::cluster_test::run),
    ("package", || program(root().join(".ci/package"), "").check()),
    ("sources", crate::sources::try_out),
    ("validate", validate::run),
    ("wheel", || wheel::run("--test")),
];

/// Runs a step whose inputs have changed, or any with `--all`; `--record` writes down that it passed.
///
/// # Errors
/// Those of the step; with exit code 2 when nothing can be recorded.
pub fn run(arguments: &[String]) -> Result {
    let wrong = |message: String| Err(Failure::bad_input(message));
    let (options, names): (Vec<&str>, Vec<&str>) =
        arguments.iter().map(String::as_str).partition(|word| ["--all", "--record"].contains(word));
    let Some((step, action)) = STEPS.iter().find(|(step, _)| names == [*step]) else {
        let steps = STEPS.iter().map(|(step, _)| *step).collect::<Vec<_>>().join(", ");
        return wrong(format!("`gated` takes one of {steps}, and `--all` or `--record`"));
    };
    let is_recorded = options.contains(&"--record");
    if is_recorded && !machine::is_continuous_integration() {
        return wrong("`--record` needs CI to be set: other runs may skip a part of a step".into());
    }
    let before = inputs(&root(), step);
    match &before {
        _ if options.contains(&"--all") => println!("{step}: runs, as `--all` says"),
        Err(reason) => println!("{step}: runs: {}", reason.message),
        Ok(digest) => match passed(&root(), step, digest) {
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
    let reason = match (before, inputs(&root(), step)) {
        (Ok(before), Ok(after)) if before == after => return record(&root(), step, &after),
        (_, Err(reason)) => reason.message,
        _ => "its inputs changed meanwhile".into(),
    };
    wrong(format!("{step}: passed, but is not recorded: {reason}"))
}

/// The digest of a step's inputs; a failure says why it is not known.
fn inputs(root: &Path, step: &str) -> Result<String> {
    let mut paths = vec![":/".to_owned()];
    for row in read(&root.join(NOT_INPUTS))?.lines().skip(1) {
        let [of, path, _reason] = row.splitn(3, ',').collect::<Vec<_>>()[..] else {
            return Err(Failure::check(format!("{NOT_INPUTS}: `{row}` is not step,path,reason")));
        };
        if of == "*" || of == step {
            paths.push(format!(":(top,exclude,glob){path}"));
        }
    }
    let ask = |words: &str| git(root, words).arg("--").args(&paths).text();
    match ask("status --porcelain --untracked-files=all")?.lines().next() {
        None => digest(&ask("ls-files --stage")?),
        Some(change) => Err(Failure::check(format!(
            "its inputs have changes that are not committed, such as `{}`",
            change.trim()
        ))),
    }
}

/// Commit and date of the step's run that passed with these inputs.
fn passed(root: &Path, step: &str, digest: &str) -> Option<String> {
    let run = |row: &str| {
        let [of, recorded, commit, date] = row.split(',').collect::<Vec<_>>()[..] else { return None };
        ((of, recorded) == (step, digest)).then(|| format!("{commit} ({date})"))
    };
    read(&root.join(GREEN)).ok()?.lines().find_map(run)
}

/// Writes the step's row.
fn record(root: &Path, step: &str, digest: &str) -> Result {
    let date = program("date", "-u +%F").text()?;
    let row = format!("{step},{digest},{},{}", commit(root)?, date.trim());
    let known = read(&root.join(GREEN)).unwrap_or_default();
    let others = known.lines().skip(1).filter(|row| !row.starts_with(&format!("{step},")));
    let mut rows: Vec<String> = others.chain([&*row]).map(|row| format!("{row}\n")).collect();
    rows.sort();
    println!("{step}: {GREEN} records this run: commit it");
    write(&root.join(GREEN), &format!("{HEADER}{}", rows.concat()))
}

#[cfg(test)]
mod tests {
    use super::*;

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
        git(&place, "init --quiet").text().unwrap();
        commit_all(&place);
        place
    }

    fn commit_all(place: &Path) {
        git(place, "add --all").text().unwrap();
        let who = "-c user.name=t -c user.email=t@t -c commit.gpgsign=false";
        git(place, &format!("{who} commit --quiet --message m")).text().unwrap();
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
        assert!(inputs(&place, "validate").unwrap_err().message.contains("src/a.rs"), "not committed");
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
        git(&place, "clone --quiet --depth 1").args([from, to]).text().unwrap();
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
                git(&root(), "ls-files --").arg(format!(":(top,glob){}", fields[1])).output().unwrap();
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
