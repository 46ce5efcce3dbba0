//! Tables of measured times: what was wanted and what was found, peers, laws of cost, the machine.
//!
//! Every row names the lines of the files of times that it follows from.

use super::coverage_table::coverage;
use super::{
    Aim, Bound, COST_FILE, CostSeries, PEERS_FILE, PeerRow, Reached, Timings, aims, cost_series,
    cycle_groups, micro, work_groups,
};
use crate::digit_columns::DigitColumns;
use crate::least_squares::Law;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Table};

/// The tables of times, of the machine and of coverage.
#[must_use]
pub fn tables(timings: &Timings) -> Vec<Table> {
    vec![
        wanted(timings),
        peers(timings, CLASSES, |work| !work.starts_with("roots-")),
        peers(timings, ROOTS, |work| work.starts_with("roots-")),
        cycles(timings),
        laws(timings),
        machine(timings),
        coverage(timings),
    ]
}

const CLASSES: [&str; 2] =
    ["peers-classes", "Signs, extremes, roots in 64 bits, boundary and sweep: ours and others"];
const ROOTS: [&str; 2] = ["peers-roots", "Roots of a cubic: ours and others"];

/// Digits of times and ratios.
const DIGITS: usize = 3;

fn lines<'l>(lines: impl IntoIterator<Item = &'l usize>) -> String {
    lines.into_iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

fn wanted(timings: &Timings) -> Table {
    let note = format!(
        "Rows are lines of `timings/{}`. The results are computed from the rows. Where a set of works is compared, the least favourable of them decides. A ratio below 1 means that the other program is faster.",
        PEERS_FILE
    );
    let aims = aims(&timings.peers);
    let rows = |aim: &Aim| match &aim.measured {
        Ok(found) if found.lines.is_empty() => format!("all of {}", aim.bench),
        Ok(found) => lines(&found.lines),
        Err(_) => String::new(),
    };
    let measured = |aim: &Aim| aim.measured.as_ref().ok().map(|found| found.value);
    let range = |aim: &Aim| range_text(aim.measured.as_ref().ok().and_then(|found| found.range));
    Table::of("aims", "Targets and measurements", &aims)
        .note(&note)
        .text("work", "Work", |aim| &aim.work)
        .text("quantity", "Quantity", |aim| aim.quantity)
        .text("outcome", "Result", outcome)
        .digits("measured", "Measured", "", DIGITS, measured)
        .text("range", "Smallest and largest", range)
        .text("must", "Required", |aim| bound(aim.must))
        .text("aim", "Target", |aim| bound(aim.aim))
        .text("rows", "Rows", rows)
        .text("command", "Command", |aim| format!("cargo xtask bench --peers {}", aim.bench))
        .table()
}

fn bound(bound: Option<Bound>) -> String {
    match bound {
        None => String::new(),
        Some(Bound::AtMost(0.0)) => "0".into(),
        Some(Bound::AtLeast(least)) => format!("≥ {}", round_digits(least, 2)),
        Some(Bound::AtMost(most)) => format!("≤ {}", round_digits(most, 2)),
    }
}

fn outcome(aim: &Aim) -> String {
    let value = match &aim.measured {
        Ok(found) => found.value,
        Err(missing) => return format!("not measured: {missing}"),
    };
    let met = |bound: Option<Bound>| bound.map(|bound| bound.is_met(value));
    match (met(aim.must), met(aim.aim)) {
        (Some(false), _) => "required value missed",
        (_, Some(true)) => "target met",
        (Some(true), Some(false)) => "required value met, target missed",
        (None, Some(false)) => "target missed",
        (Some(true), None) => "required value met",
        (None, None) => "",
    }
    .into()
}

fn peers(timings: &Timings, [id, title]: [&str; 2], wanted: fn(&str) -> bool) -> Table {
    let note = format!(
        "Printed by `cargo xtask bench --peers`. Rows are lines of `timings/{}`. A ratio below 1 means faster than ours. Wrong answers are not included in the errors.",
        PEERS_FILE
    );
    let groups = work_groups(&timings.peers);
    Table::of(id, title, groups.iter().filter(|group| wanted(&group.row.work)))
        .note(&note)
        .text("work", "Work", |group| &group.row.work)
        .text("method", "Method", |group| &group.row.method)
        .digits("tolerance", "Tolerance", "", DIGITS, |group| group.row.tolerance)
        .digits("cpu_us", "CPU time per item", "µs", DIGITS, |group| micro(group.row))
        .digits("over_ours", "Ratio to our fastest", "", DIGITS, |group| group.over_ours)
        .number("worst_error", "Largest error", "", |group| Cell::number(error_text(group.row)))
        .text("wrong", "Wrong or failed", |group| format!("{} of {}", group.row.wrong, group.row.items))
        .text("program", "Program", |group| &group.row.program)
        .text("options", "Options", |group| &group.row.options)
        .text("command", "Command", |group| &group.row.command)
        .number("row", "Row", "", |group| group.row.line)
        .table()
}

/// The error as printed where 64 bits do not hold it, in two digits elsewhere.
fn error_text(row: &PeerRow) -> String {
    match row.error_value() {
        Some(value) if value > 0.0 => round_digits(value, 2),
        _ => row.error.clone(),
    }
}

fn cycles(timings: &Timings) -> Table {
    let note = format!(
        "Printed by `cargo xtask bench --peers cycles`, `… smooth` and `… throughput`. All methods have the same tolerances, two a decade. For each case and method, the fastest tolerance whose measured error is at most the required error. Ratios are to our fastest method on the same case at the same error; their mean is geometric. A ratio below 1 means faster than ours. Rows are lines of `timings/{}`.",
        PEERS_FILE
    );
    let groups = cycle_groups(&timings.peers);
    Table::of(
        "peers-cycles",
        "Cycles, smooth regimes and sets of smooth runs at equal error: ours and others",
        &groups,
    )
    .note(&note)
    .text("kind", "Kind", |reached| reached.kind)
    .digits("error", "Required error", "", 1, |reached| reached.error)
    .text("method", "Method", |reached| reached.method)
    .text("cases", "Cases", |reached| format!("{} of {}", reached.rows.len(), reached.cases))
    .digits("mean_over_ours", "Ratio to our fastest, mean", "", DIGITS, Reached::mean_over_ours)
    .text("range_over_ours", "Smallest and largest", |reached| range_text(reached.range_over_ours()))
    .number("faster_cases", "Cases faster than ours", "", Reached::faster_cases)
    .text("program", "Program", |reached| reached.of_first(|row| &row.program))
    .text("options", "Options", |reached| reached.of_first(|row| &row.options))
    .text("command", "Command", |reached| reached.of_first(|row| &row.command))
    .text("rows", "Rows", |reached| lines(reached.rows.iter().map(|row| &row.line)))
    .table()
}

fn range_text(range: Option<(f64, f64)>) -> String {
    let words = |(least, most)| format!("{} to {}", round_digits(least, 2), round_digits(most, 2));
    range.map(words).unwrap_or_default()
}

fn laws(timings: &Timings) -> Table {
    let note = format!(
        "Printed by `cargo xtask cost`; rows are lines of `timings/{}`, which has every command. Times are for one thread unless the number of threads varies. Laws are least-squares fits to the rows.",
        COST_FILE
    );
    let at = |law: &Option<Law>, size: Option<f64>| Some(law.as_ref()?.at(size?));
    let residual =
        |series: &CostSeries<'_>| series.law.as_ref().map(|law| law.worst_residual(&series.points()));
    let all = cost_series(&timings.cost);
    let tops = all.iter().filter_map(|series| Some((*series.rows.last()?, series)));
    Table::of("cost-laws", "Growth of CPU time and memory", tops)
        .note(&note)
        .text("what", "Varied quantity", |(top, _)| &top.series)
        .text("law", "CPU time, s, by its size n", |(_, series)| {
            series.law.as_ref().map(law_text).unwrap_or_default()
        })
        .digits("residual", "Largest residual, factor", "", DIGITS, |(_, series)| residual(series))
        .digits("top_size", "Largest size measured", "", DIGITS, |(top, _)| top.size)
        .digits("top_cpu_s", "CPU time there", "s", DIGITS, |(top, _)| top.cpu_s)
        .digits("top_predicted_cpu_s", "Predicted by the law without it", "s", DIGITS, |(top, series)| {
            at(&series.law_below_top, Some(top.size))
        })
        .digits("peak_memory_mib", "Peak memory there", "MiB", DIGITS, |(top, _)| {
            top.peak_memory_kib / 1024.0
        })
        .digits("asked_size", "Predicted size", "", DIGITS, |(top, _)| top.requested)
        .digits("asked_cpu_s", "Predicted CPU time", "s", DIGITS, |(top, series)| {
            at(&series.law, top.requested)
        })
        .text("rows", "Rows", |(_, series)| lines(series.rows.iter().map(|row| &row.line)))
        .text("command", "Command of the largest", |(top, _)| &top.command)
        .table()
}

fn law_text(law: &Law) -> String {
    let term = |(factor, exponent): &(f64, f64)| {
        let factor = round_digits(*factor, 3);
        match *exponent {
            0.0 => factor,
            1.0 => format!("{factor} n"),
            _ => format!("{factor} n^{}", round_digits(*exponent, 3)),
        }
    };
    law.terms.iter().map(term).collect::<Vec<_>>().join(" + ")
}

fn machine(timings: &Timings) -> Table {
    Table::of("timings-machine", "Machine and date of the measurements", &timings.machine)
        .text("file", "File", |row| &row.file)
        .text("key", "Item", |row| &row.key)
        .text("value", "Value", |row| &row.value)
        .table()
}
