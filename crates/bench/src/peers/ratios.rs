//! Ratios of CPU time, with the error beside each: at equal work, or at equal error where methods have tolerances.

use std::collections::BTreeSet;

use super::row::Row;
use crate::times::{ERRORS, KINDS};

/// One comparison.
#[derive(Debug)]
pub struct Ratio<'r> {
    /// The work, and the error that was to be met where methods have tolerances.
    pub work: String,
    /// The row compared; none when no tolerance met the error.
    pub row: Option<&'r Row>,
    /// The method, also when it has no row.
    pub method: &'r str,
    /// Its time over that of our fastest method.
    pub over_ours: Option<f64>,
}

/// All comparisons, work by work in the order of the rows.
pub fn ratios(rows: &[Row]) -> Vec<Ratio<'_>> {
    let mut seen = BTreeSet::new();
    let works = rows.iter().map(|row| row.work.as_str()).filter(|work| seen.insert(*work));
    works.flat_map(|work| of_work(work, rows.iter().filter(|row| row.work == work).collect())).collect()
}

fn of_work<'r>(work: &str, rows: Vec<&'r Row>) -> Vec<Ratio<'r>> {
    let has_tolerances = KINDS.iter().any(|kind| work.starts_with(kind));
    if !has_tolerances {
        return compare(
            work.to_string(),
            rows.into_iter().map(|row| (row.method.as_str(), Some(row))).collect(),
        );
    }
    let methods: BTreeSet<&str> = rows.iter().map(|row| row.method.as_str()).collect();
    let best = |method: &str, most: f64| {
        let is_right = |row: &Row| row.wrong == 0 && row.error_value().is_some_and(|error| error <= most);
        let meets = |row: &&&Row| row.method == method && is_right(row);
        rows.iter().filter(meets).copied().min_by(|a, b| a.seconds.total_cmp(&b.seconds))
    };
    ERRORS
        .iter()
        .flat_map(|&most| {
            let entries = methods.iter().map(|method| (*method, best(method, most))).collect();
            compare(format!("{work} at error {most:e}"), entries)
        })
        .collect()
}

fn compare<'r>(work: String, entries: Vec<(&'r str, Option<&'r Row>)>) -> Vec<Ratio<'r>> {
    let ours = entries.iter().filter_map(|(_, row)| *row).filter(|row| row.is_ours());
    let fastest = ours.map(Row::seconds_per_item).min_by(f64::total_cmp);
    let entry = |(method, row): (&'r str, Option<&'r Row>)| Ratio {
        work: work.clone(),
        row,
        method,
        over_ours: row.zip(fastest).map(|(row, fastest)| row.seconds_per_item() / fastest),
    };
    entries.into_iter().map(entry).collect()
}

/// The comparisons as lines for people.
pub fn lines(rows: &[Row]) -> Vec<String> {
    let line = |ratio: &Ratio| match ratio.row {
        None => format!("{:<42} {:<24} does not reach it", ratio.work, ratio.method),
        Some(row) => format!(
            "{:<42} {:<24} {:>11.4} us  {:>9} x  error {:>9}  wrong {} of {}  steps {}  evaluations {}",
            ratio.work,
            row.method,
            1e6 * row.seconds_per_item(),
            over(ratio.over_ours),
            row.error,
            row.wrong,
            row.items,
            row.steps,
            row.evaluations,
        ),
    };
    ratios(rows).iter().map(line).collect()
}

/// A ratio in three digits or so.
pub fn over(ratio: Option<f64>) -> String {
    let Some(ratio) = ratio else { return "-".into() };
    if ratio < 10.0 { format!("{ratio:.2}") } else { format!("{ratio:.0}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(work: &str, method: &str, tolerance: &str, seconds: f64, error: &str) -> Row {
        let line = format!(
            "row work={work} method={method} options=- tolerance={tolerance} items=1 seconds={seconds} error={error} wrong=0 steps=- evaluations=-"
        );
        Row::parse(&line, "", "").unwrap()
    }

    #[test]
    fn a_tolerance_counts_by_the_error_it_gave() {
        let rows = [
            row("cycles-a", "slipmode-x", "1e-3", 1.0, "1e-5"),
            row("cycles-a", "slipmode-x", "1e-9", 4.0, "1e-11"),
            row("cycles-a", "peer", "1e-9", 10.0, "5e-5"),
        ];
        let found = ratios(&rows);
        let peer = |most: &str| {
            found.iter().find(|r| r.method == "peer" && r.work.ends_with(most)).unwrap().over_ours
        };
        assert_eq!((peer(" 1e-4"), peer(" 1e-6")), (Some(10.0), None));
    }

    #[test]
    fn without_tolerances_every_row_is_over_our_fastest() {
        let rows = [
            row("roots", "slipmode-a", "-", 2.0, "-"),
            row("roots", "slipmode-b", "-", 1.0, "-"),
            row("roots", "peer", "-", 3.0, "-"),
        ];
        let found: Vec<_> = ratios(&rows).iter().map(|ratio| ratio.over_ours).collect();
        assert_eq!(found, [Some(2.0), Some(1.0), Some(3.0)]);
    }
}
