//! `cargo xtask accept`: rewrites the published copy of every report from a new run.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::failure::Failure;
use crate::{machine, process, repository, verify};

/// Files of a run that `published/` does not keep: they describe the machine.
const NOT_PUBLISHED: [&str; 1] = ["environment.json"];

/// Runs every report again and replaces its `published/` folder.
///
/// # Errors
/// When the machine lacks a tool, a report cannot be made, or a file cannot be written.
pub fn run() -> Result<(), Failure> {
    machine::run()?;
    verify::build()?;
    for name in repository::reports()? {
        let report = format!("reports/{name}");
        let code = process::status(&mut verify::slipmode(&["report", "--for-publication", &report]))?;
        if code != 0 {
            let message = format!("report {name} exited with {code}; its published copy is unchanged");
            return Err(Failure { code, message });
        }
        publish(&name)?;
    }
    Ok(())
}

fn publish(name: &str) -> Result<(), Failure> {
    let root = repository::root();
    let published = root.join("reports").join(name).join("published");
    let files = replace(&root.join("target/report").join(name), &published)
        .map_err(|error| Failure::bad_input(format!("reports/{name}/published: {error}")))?;
    println!("accept: reports/{name}/published/ rewritten, {files} files; check `git diff --text`");
    process::check(Command::new("git").current_dir(&root).args(["diff", "--stat", "--", "reports"]))
}

/// Writes the new copy next to the old one first, so that an error leaves the old one intact.
fn replace(fresh: &Path, published: &Path) -> std::io::Result<usize> {
    let new = published.with_extension("new");
    if new.exists() {
        fs::remove_dir_all(&new)?;
    }
    let files = copy(fresh, &new)?;
    if published.exists() {
        fs::remove_dir_all(published)?;
    }
    fs::rename(&new, published)?;
    Ok(files)
}

fn copy(from: &Path, to: &Path) -> std::io::Result<usize> {
    fs::create_dir_all(to)?;
    let mut files = 0;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let name = repository::file_name(&path);
        if path.is_dir() {
            files += copy(&path, &to.join(&name))?;
        } else if !NOT_PUBLISHED.contains(&name.as_str()) {
            fs::copy(&path, to.join(&name))?;
            files += 1;
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_published_copy_is_replaced_completely_and_without_the_machine() {
        let scratch = std::env::temp_dir().join(format!("slipmode-accept-{}", std::process::id()));
        let _ = fs::remove_dir_all(&scratch);
        let (fresh, published) = (scratch.join("fresh"), scratch.join("published"));
        fs::create_dir_all(fresh.join("tables")).unwrap();
        fs::create_dir_all(&published).unwrap();
        fs::write(fresh.join("tables/a.csv"), "new").unwrap();
        fs::write(fresh.join("environment.json"), "{}").unwrap();
        fs::write(published.join("stale.csv"), "old").unwrap();
        assert_eq!(replace(&fresh, &published).unwrap(), 1);
        assert_eq!(fs::read_to_string(published.join("tables/a.csv")).unwrap(), "new");
        assert!(!published.join("stale.csv").exists() && !published.join("environment.json").exists());
        assert!(replace(&scratch.join("absent"), &published).is_err());
        assert!(published.join("tables/a.csv").exists(), "an error leaves the old copy intact");
        fs::remove_dir_all(scratch).unwrap();
    }
}
