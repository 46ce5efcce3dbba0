//! Diagrams of time against digits and against error.

use std::collections::BTreeMap;

use super::{PeerRow, Timings, micro};
use crate::chart::{Chart, LogAxis, marked};
use slipmode_plot::figure::Series;

/// The diagrams for which there are rows.
#[must_use]
pub fn figures(timings: &Timings) -> Vec<Chart> {
    std::iter::once(roots(&timings.peers)).chain(one_cycle(&timings.peers)).collect()
}

/// Rows by method, in the order of the names, ours first.
fn by_method<'r>(rows: impl Iterator<Item = &'r PeerRow>) -> Vec<(&'r str, Vec<&'r PeerRow>)> {
    let mut methods: BTreeMap<(bool, &str), Vec<&PeerRow>> = BTreeMap::new();
    for row in rows {
        methods.entry((!row.is_ours(), &row.method)).or_default().push(row);
    }
    methods.into_iter().map(|((_, method), rows)| (method, rows)).collect()
}

/// The program of a method: the first word of its name. FLINT is the same program from C and from Python.
fn program(method: &str) -> &str {
    method.trim_start_matches("python-").split('-').next().unwrap_or(method)
}

fn roots(rows: &[PeerRow]) -> Chart {
    let digits = |row: &PeerRow, set: &str| -> Option<f64> {
        row.work.strip_prefix("roots-")?.strip_suffix(set)?.strip_suffix('-')?.parse().ok()
    };
    let mut programs: BTreeMap<(bool, &str), Vec<&PeerRow>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.work.starts_with("roots-")) {
        programs.entry((!row.is_ours(), program(&row.method))).or_default().push(row);
    }
    let mut series = Vec::new();
    for ((is_peer, name), rows) in programs {
        let line = |set: &str| {
            let mut fastest: Vec<(f64, f64)> = Vec::new();
            for (digits, time) in rows.iter().filter_map(|row| Some((digits(row, set)?, micro(row)))) {
                match fastest.iter_mut().find(|point| point.0 == digits) {
                    Some(point) => point.1 = point.1.min(time),
                    None => fastest.push((digits, time)),
                }
            }
            fastest
        };
        series.push(marked(name, line("random")));
        if !is_peer {
            series.push(marked(&format!("{name}, hard cubics"), line("hard")));
        }
    }
    series.retain(|line| !line.points.is_empty());
    Chart {
        id: "times-roots",
        data: &["peers-roots"],
            label: "Figure P4",
            title: "Time of three roots against digits".into(),
            caption: "CPU time of the three roots of one cubic against the requested digits, for random cubics unless stated otherwise, by the fastest method of each program. The table has the errors. FLINT's roots and ours are enclosed, the others are not.".into(),
            description: "CPU time of three roots against requested digits, on logarithmic axes, one line for each program.",
        x: LogAxis::new("Digits", ""),
        y: LogAxis::new("CPU time", "µs"),
        series,
        vertical: None,
    }
}

/// Lines of one diagram: with more a look would repeat.
const MOST_LINES: usize = 6;

/// The error by whose time methods are ranked.
const RANKED_ERROR: f64 = 1e-6;

/// A name in which an underscore is no subscript.
fn escaped(name: &str) -> String {
    name.replace('_', "\\_")
}

/// Errors beyond this are no answer, and below this are rounding.
const SHOWN_ERRORS: std::ops::RangeInclusive<f64> = 1e-14..=1.0;

fn one_cycle(rows: &[PeerRow]) -> Option<Chart> {
    let case = rows
        .iter()
        .map(|row| row.work.as_str())
        .find(|work| work.starts_with("cycles-") && work.ends_with("slip"))?;
    let place = |row: &&PeerRow| {
        let error = row.error_value().filter(|error| row.wrong == 0 && SHOWN_ERRORS.contains(error))?;
        Some((error, micro(row)))
    };
    let mut lines: Vec<(f64, Series)> = by_method(rows.iter().filter(|row| row.work == case))
        .into_iter()
        .map(|(method, rows)| {
            let points: Vec<(f64, f64)> = rows.iter().filter_map(place).collect();
            let met = points.iter().filter(|(error, _)| *error <= RANKED_ERROR).map(|point| point.1);
            (met.fold(f64::INFINITY, f64::min), marked(&escaped(method), points))
        })
        .collect();
    lines.sort_by(|one, other| one.0.total_cmp(&other.0));
    lines.truncate(MOST_LINES);
    let series = lines.into_iter().map(|(_, series)| series).collect();
    Some(Chart {
        id: "times-cycle",
        data: &["peers-cycles"],
        label: "Figure P5",
        title: format!("Time of one cycle against its error, {case}"),
        caption: format!(
            "CPU time of one cycle of `{case}` (V_l = 10^v m/s, σ = 10^s Pa) against its measured error, the larger of the errors of ln V_peak and of the duration. The reference is Radau IIA of order 13 in double-double. One mark per tolerance, for the six fastest methods at an error of 1e-6. There is no mark at a tolerance where a program does not finish."
        ),
        description: "CPU time of one cycle against its measured error, on logarithmic axes, one line for each method.",
        x: LogAxis::new("Error", ""),
        y: LogAxis::new("CPU time", "µs"),
        series,
        vertical: None,
    })
}
