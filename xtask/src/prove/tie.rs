//! `cargo xtask tie`: the rows of `proofs/claims.csv` whose digests are no longer those of their claims.
//!
//! That theorems state a claim is a person's judgement. The task therefore shows the claim as resolved, what was found on it and the
//! theorems, and writes only the rows that it is given.

use super::generate;
use crate::prelude::*;
use crate::{repository, verify};

const TABLE: &str = "proofs/claims.csv";

/// A row that has moved: the number of its line, and a text. Its first line is the row as it would be; a person reads the others before.
type Moved = (usize, String);

/// Prints the rows that have moved, and writes those of a report, or of its claims that are named.
///
/// # Errors
/// When the program cannot list them, or a claim has none.
pub fn run(arguments: &[String]) -> Result {
    verify::build()?;
    let mut moved = Vec::new();
    for (path, text) in repository::texts(&generate(&root().join("target/proofs"))?, ".txt")? {
        let Some(line) = path.strip_prefix("ties/") else { continue };
        let wrong = |_| Failure::check(format!("{path}.txt: no number of a line"));
        moved.push((line.parse().map_err(wrong)?, text));
    }
    let Some((report, ids)) = arguments.split_first() else {
        for (line, text) in &moved {
            println!("{TABLE}:{line}: {}", claim_of(text).join(" "));
        }
        println!("tie: {} rows have other digests than their claims", moved.len());
        println!("tie: `cargo xtask tie REPORT [CLAIM...]` shows and writes them");
        return Ok(());
    };
    let path = root().join(TABLE);
    write(&path, &rewritten(&read(&path)?, &moved, report, ids)?)?;
    println!("tie: {TABLE} is written; `cargo xtask prove` has Coq accept the theorems for these claims");
    Ok(())
}

/// The report and the claim of a row.
fn claim_of(row: &str) -> [&str; 2] {
    let mut fields = row.split(',');
    [fields.next().unwrap_or_default(), fields.next().unwrap_or_default()]
}

/// The table with the rows of these claims as they would be, or with all of the report; each is shown.
fn rewritten(table: &str, moved: &[Moved], report: &str, ids: &[String]) -> Result<String> {
    let has_moved = |id: &String| moved.iter().any(|(_, text)| claim_of(text) == [report, id]);
    if let Some(id) = ids.iter().find(|id| !has_moved(id)) {
        return Err(Failure::bad_input(format!("{report} {id}: no row of {TABLE} has moved")));
    }
    let mut lines: Vec<&str> = table.lines().collect();
    for (line, text) in moved {
        let (row, to_read) = text.split_once('\n').unwrap_or((text, ""));
        let claim @ [name, id] = claim_of(row);
        if name != report || !ids.is_empty() && !ids.iter().any(|known| known == id) {
            continue;
        }
        let wrong = || Failure::check(format!("{TABLE}:{line}: not the row of {id}"));
        let place = lines.get_mut(line - 1).filter(|known| claim_of(known) == claim).ok_or_else(wrong)?;
        println!("--- {report} {id}\n{to_read}");
        *place = row;
    }
    Ok(lines.iter().map(|line| format!("{line}\n")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_rows_of_named_claims_are_written() {
        let table = "report,claim,claim_digest,digest\nr,S1,0,0\nr,S2,0,0\n";
        let moved = |line, row: &str| (line, row.to_owned());
        let all = [moved(2, "r,S1,1,1"), moved(3, "r,S2,1,1")];
        let written = |id: &str| rewritten(table, &all, "r", &[id.to_owned()]);
        assert_eq!(written("S2").unwrap(), "report,claim,claim_digest,digest\nr,S1,0,0\nr,S2,1,1\n");
        assert!(written("S3").is_err());
        let every = rewritten(table, &all, "r", &[]).unwrap();
        assert_eq!(every, "report,claim,claim_digest,digest\nr,S1,1,1\nr,S2,1,1\n");
        assert_eq!(rewritten(table, &all, "q", &[]).unwrap(), table);
        let elsewhere = [moved(2, "r,S2,1,1")];
        assert!(rewritten(table, &elsewhere, "r", &["S2".to_owned()]).is_err());
    }
}
