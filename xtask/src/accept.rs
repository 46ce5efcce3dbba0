//! `cargo xtask accept`: rewrites the published copy of every report from a new run.

use crate::prelude::*;
use crate::{repository, verify};

/// Runs every report again and replaces its `published/` folder.
///
/// # Errors
/// When the machine lacks a tool, a report cannot be made, or a file cannot be written.
pub fn run() -> Result {
    verify::build()?;
    for name in repository::reports()? {
        let code = verify::slipmode("report --for-publication").arg(format!("reports/{name}")).code()?;
        let message = || format!("report {name} exited with {code}; its published copy is unchanged");
        ensure(code == 0, || Failure { code, message: message() })?;
        let published = root().join("reports").join(&name).join("published");
        replace(&root().join("target/report").join(&name), &published)?;
        println!("accept: reports/{name}/published/ rewritten; check `git diff --text`");
        git(&root(), "diff --stat -- reports").check()?;
    }
    Ok(())
}

/// Writes the new copy next to the old one first, so that an error leaves the old one intact.
fn replace(fresh: &Path, published: &Path) -> Result {
    let new = published.with_extension("new");
    let _ = fs::remove_dir_all(&new);
    // That file describes the machine.
    for path in below(fresh)?.iter().filter(|path| *path != "environment.json") {
        copy(&fresh.join(path), &new.join(path))?;
    }
    let _ = fs::remove_dir_all(published);
    fs::rename(&new, published).map_err(at(published))
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
        replace(&fresh, &published).unwrap();
        assert_eq!(fs::read_to_string(published.join("tables/a.csv")).unwrap(), "new");
        assert!(!published.join("stale.csv").exists() && !published.join("environment.json").exists());
        assert!(replace(&scratch.join("absent"), &published).is_err());
        assert!(published.join("tables/a.csv").exists(), "an error leaves the old copy intact");
        fs::remove_dir_all(scratch).unwrap();
    }
}
