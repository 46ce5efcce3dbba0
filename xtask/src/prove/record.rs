//! What Coq said of each file before, as `proofs/checked.csv` records it: a file that is as it was then is not checked again.
//!
//! A digest covers the version of Coq, the file's text and the modules of the library on which it rests.

use super::{Digests, Said, Task, assumptions};
use crate::prelude::*;
use crate::repository;

/// The record.
pub const TABLE: &str = "proofs/checked.csv";
const HEADER: &str = "file,digest,commit,assumes\n";

/// What stands in the place of the axioms of a file that Coq did not accept.
const REFUSED: &str = "not accepted";

/// The files of earlier runs.
#[derive(Default)]
pub struct Record {
    /// Digest, commit and what it assumes, by file.
    rows: BTreeMap<String, [String; 3]>,
}

impl Record {
    /// Reads the table; there may be none yet.
    pub fn read() -> Self {
        let text = read(&root().join(TABLE)).unwrap_or_default();
        let row = |line: &str| {
            let [file, digest, commit, assumes] = line.splitn(4, ',').collect::<Vec<_>>().try_into().ok()?;
            Some((file.to_owned(), [digest, commit, assumes].map(str::to_owned)))
        };
        Self { rows: text.lines().skip(1).filter_map(row).collect() }
    }

    /// What Coq said of this file when it was as it is now, and at which commit.
    pub fn known(&self, file: &str, digest: &str) -> Option<(Said, &str)> {
        let [_, commit, assumes] = self.rows.get(file).filter(|[known, ..]| known == digest)?;
        let said = match assumes.as_str() {
            REFUSED => Err(format!("as recorded at {commit}")),
            "" => Ok("Closed under the global context\n".to_owned()),
            axioms => Ok(format!("Axioms:\n{}\n", axioms.replace(' ', "\n"))),
        };
        Some((said, commit))
    }

    /// The files of which the record knows what Coq says, and the others.
    pub fn split(&self, tasks: Vec<Task>, digests: &Digests) -> (Vec<(Task, Said)>, Vec<Task>) {
        let (mut known, mut left, mut commits) = (Vec::new(), Vec::new(), BTreeSet::new());
        for task in tasks {
            if let Some((said, commit)) = self.known(&task.file, &digests[&task.file]) {
                commits.insert(commit);
                known.push((task, said));
            } else {
                left.push(task);
            }
        }
        if !known.is_empty() {
            let (count, all) = (known.len(), known.len() + left.len());
            let commits = Vec::from_iter(commits).join(", ");
            println!(
                "prove: {count} of {all} files are as they were when Coq checked them, at commit {commits}; `prove --all` checks them again"
            );
        }
        (known, left)
    }

    /// The table with what Coq says now; a file that is as it was keeps its commit. Whether it differs from the one on disk.
    pub fn update(&self, checked: &[(Task, Said)], digests: &Digests) -> Result<bool> {
        let commit = repository::commit(&root())?;
        let row = |(task, said): &(Task, Said)| {
            let digest = digests.get(&task.file)?;
            let axioms = said.as_ref().map(|output| assumptions::listed(output).unwrap_or_default());
            let assumes = axioms.map_or(REFUSED.to_owned(), |axioms| axioms.join(" "));
            let known = self.known(&task.file, digest);
            let commit = known.as_ref().map_or(commit.as_str(), |(_, commit)| commit);
            Some(format!("{},{digest},{commit},{assumes}\n", task.file))
        };
        let rows = checked.iter().filter_map(row).collect::<BTreeSet<String>>();
        let text = format!("{HEADER}{}", rows.into_iter().collect::<String>());
        repository::rewrite(&root().join(TABLE), &text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_known_only_as_it_was() {
        let row = |assumes: &str| ["d1", "c1", assumes].map(str::to_owned);
        let rows = [("a", row("")), ("b", row("X.y Z.w")), ("c", row(REFUSED))];
        let record = Record { rows: rows.map(|(file, row)| (file.to_owned(), row)).into() };
        let said = |file: &str, digest: &str| record.known(file, digest).map(|(said, _)| said);
        assert_eq!(said("a", "d1"), Some(Ok("Closed under the global context\n".into())));
        let axioms = said("b", "d1").unwrap().unwrap();
        assert_eq!(super::super::assumptions::listed(&axioms), Some(vec!["X.y", "Z.w"]));
        assert!(said("c", "d1").is_some_and(|said| said.is_err()));
        assert!(said("a", "d2").is_none() && said("e", "d1").is_none());
    }
}
