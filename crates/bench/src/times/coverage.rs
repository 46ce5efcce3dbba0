//! Which lines of the program the tests ran: the file that `cargo xtask coverage` wrote.

use super::sheet::{SheetRow, rows};
use slipmode::scene::Faults;

/// The lines of one module that can be run, its own tests left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CoverageRow {
    /// The module, a folder or a file of the program's sources.
    pub module: String,
    /// Its lines.
    pub lines: u64,
    /// How many of them some test ran; at most those of the next field.
    pub by_tests: u64,
    /// How many some test or `verify` of a report ran; at most all.
    pub with_verify: u64,
    /// The files with the most lines that nothing ran, each with their number; empty where all were run.
    pub most_left_in: String,
}

impl CoverageRow {
    /// So many of the lines, in per cent times ten and rounded down, so that 1000 means every line; none of no lines.
    #[must_use]
    pub fn per_mille(&self, run: u64) -> Option<u64> {
        (1000 * u128::from(run))
            .checked_div(u128::from(self.lines))
            .and_then(|share| u64::try_from(share).ok())
    }

    fn read(row: &SheetRow<'_>) -> Result<Self, Faults> {
        let (lines, by_tests, with_verify) = (row.whole(1)?, row.whole(2)?, row.whole(3)?);
        if by_tests > with_verify {
            return Err(row.fault(2, "at most `with_verify`"));
        }
        if with_verify > lines {
            return Err(row.fault(3, "at most the module's lines"));
        }
        Ok(Self { module: row.text(0), lines, by_tests, with_verify, most_left_in: row.text(4) })
    }
}

/// Reads what `cargo xtask coverage` wrote.
///
/// # Errors
/// Every fault of the header, or the first of a row.
pub fn read_coverage(file: &str, text: &str) -> Result<Vec<CoverageRow>, Faults> {
    const COLUMNS: [&str; 5] = ["module", "lines", "by_tests", "with_verify", "most_left_in"];
    rows(file, text, &COLUMNS)?.iter().map(CoverageRow::read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "module,lines,by_tests,with_verify,most_left_in\n";

    #[test]
    fn a_share_is_rounded_down_and_a_module_without_lines_has_none() {
        let text = format!("{HEADER}a,3000,0,2999,a/b.rs 1\nb,0,0,0,\nc,7,7,7,\n");
        let rows = read_coverage("c.csv", &text).unwrap();
        let shares: Vec<Option<u64>> = rows.iter().map(|row| row.per_mille(row.with_verify)).collect();
        assert_eq!(shares, [Some(999), None, Some(1000)]);
    }

    #[test]
    fn more_lines_run_than_there_are_is_refused_by_name() {
        for (row, named) in [
            ("a,4,3,2,", "2: by_tests = 3"),
            ("a,3,3,4,", "2: with_verify = 4"),
            ("a,-4,3,3,a.rs 2", "2: lines = -4"),
            ("a,4,3,3", "2: 4 cells"),
        ] {
            let faults = read_coverage("c.csv", &format!("{HEADER}{row}\n")).unwrap_err();
            assert!(faults[0].to_string().contains(named), "{}", faults[0]);
        }
    }
}
