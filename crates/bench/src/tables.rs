//! `cargo xtask tables`: everything that a report shows of what this package counts and measures, as files of its own.
//!
//! Counts are computed; times are read from the files that the other commands wrote and are only tabulated. Both give the same
//! bytes on every machine.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use slipmode::scene::Faults;

use crate::contents::contents;
use crate::counts::{Sizes, speed_counts};
use crate::integrators::{read_hard_cycles, run_hard_cycles, work_precision};
use crate::methods::{compare_hard_cases, read_hard_cases, score_families};
use crate::scheme::{Asked, original_scheme};
use crate::times::{FILES, Timings};
use crate::{counts, error_bound, integrators, methods, scheme, times};

/// The folder of a report that has the files.
const FOLDER: &str = "timings";

/// The points on which methods are compared, with their references; in the folder of the files.
const HARD_CASES: &str = "classification-hard.txt";

/// The cycles on which integrators are compared, with their references; in the folder of the files.
const HARD_CYCLES: &str = "simulation-hard.txt";

/// Computes the files for a report's folder and writes them into its folder `timings`.
///
/// # Errors
/// When a file cannot be read or written, or is not what it should be.
pub fn run(report: &Path) -> Result<(), String> {
    for (name, text) in files(report)? {
        let place = report.join(FOLDER).join(&name);
        let parent = place.parent().unwrap_or(report);
        let failed = |error| format!("{}: {error}", place.display());
        fs::create_dir_all(parent).and_then(|()| fs::write(&place, text)).map_err(failed)?;
        println!("{}", place.display());
    }
    Ok(())
}

/// The text of each file by its path inside the folder `timings`.
///
/// # Errors
/// When a file cannot be read, or is not what it should be.
pub fn files(report: &Path) -> Result<BTreeMap<String, String>, String> {
    let read = |name: &str| {
        fs::read_to_string(report.join(name))
            .map_err(|error| format!("{}: {error}", report.join(name).display()))
    };
    let [peers, cost, coverage, machine] = FILES.map(|name| read(&format!("{FOLDER}/{name}")));
    let texts = [peers?, cost?, coverage?, machine?];
    let timings = Timings::read(texts.each_ref().map(String::as_str)).map_err(message)?;
    let cases = read_hard_cases(HARD_CASES, &read(&format!("{FOLDER}/{HARD_CASES}"))?).map_err(message)?;
    let cycles_file = format!("{FOLDER}/{HARD_CYCLES}");
    let cycles = read_hard_cycles(&cycles_file, &read(&cycles_file)?).map_err(message)?;
    let counted = speed_counts(&Sizes::REPORTED);
    let worked = work_precision();
    let schemed = original_scheme(&Asked::REPORTED);
    let tables = [
        vec![methods::case_table(&compare_hard_cases(&cases))],
        methods::tables(&score_families(&cases)),
        integrators::hard_tables(&run_hard_cycles(&cycles)),
        vec![integrators::work_table(&worked)],
        vec![error_bound::table(&error_bound::error_bound(error_bound::REPORTED))],
        scheme::tables(&schemed),
        counts::tables(&counted),
        times::tables(&timings),
    ]
    .concat();
    let charts = [
        vec![scheme::figure(&schemed)],
        integrators::figures(&worked),
        counts::figures(&counted),
        times::figures(&timings),
    ]
    .concat();
    let sources = [&FILES[..], &[HARD_CASES, HARD_CYCLES]].concat();
    let rows = tables.iter().map(|table| (format!("tables/{}.csv", table.id), table.to_csv()));
    let words = ("contents.toml".to_string(), contents(&sources, &tables, &charts));
    Ok(rows.chain([words]).collect())
}

fn message(faults: Faults) -> String {
    faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::repository;

    #[test]
    fn the_files_of_the_report_on_the_paper_are_what_this_code_computes() {
        let report = repository::root().join("reports/im-avouac");
        let files = files(&report).unwrap();
        for (name, text) in &files {
            let committed = fs::read_to_string(report.join(FOLDER).join(name)).unwrap();
            assert_eq!(&committed, text, "{name}: `cargo xtask tables` writes it again");
        }
        let tables = fs::read_dir(report.join(FOLDER).join("tables")).unwrap().count();
        assert_eq!(tables + 1, files.len(), "a table is left over");
    }
}
