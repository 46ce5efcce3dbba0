//! Tables of measured times: what was wanted and what was found, peers, laws of cost, the machine.
//!
//! Every row names the lines of the files of times that it follows from.

use super::coverage_table::coverage;
use super::{
    Aim, Bound, COST_FILE, CostRow, CostSeries, Law, PEERS_FILE, PeerGroup, PeerRow, Reached, Timings, aims,
    cost_series, cycle_groups, micro, work_groups,
};
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

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

const CLASSES: [&str; 2] = ["peers-classes", "Classes, hard cases, boundary and sweep: ours and others"];
const ROOTS: [&str; 2] = ["peers-roots", "Roots of a cubic: ours and others"];

fn number(value: f64) -> Cell {
    Cell::number(round_digits(value, 3))
}

fn optional(value: Option<f64>) -> Cell {
    value.map_or_else(Cell::empty, number)
}

fn lines(lines: impl IntoIterator<Item = usize>) -> Cell {
    Cell::text(lines.into_iter().map(|line| line.to_string()).collect::<Vec<_>>().join(" "))
}

fn wanted(timings: &Timings) -> Table {
    let columns = vec![
        Column::text("work", "Work"),
        Column::text("quantity", "Quantity"),
        Column::text("outcome", "Result"),
        Column::number("measured", "Measured", ""),
        Column::text("must", "Required"),
        Column::text("aim", "Target"),
        Column::text("rows", "Rows"),
        Column::text("command", "Command"),
    ];
    let note = format!(
        "Rows are lines of `timings/{}`. The bounds were set before the measurements. The results are computed from the rows.",
        PEERS_FILE
    );
    let mut table = Table::new("aims", "Targets and measurements", columns).with_note(&note);
    for aim in aims(&timings.peers) {
        let (value, found) = match &aim.measured {
            Ok((value, lines)) => (number(*value), lines.clone()),
            Err(_) => (Cell::empty(), Vec::new()),
        };
        table.push(vec![
            Cell::text(&aim.work),
            Cell::text(aim.quantity),
            Cell::text(outcome(&aim)),
            value,
            bound(aim.must),
            bound(aim.aim),
            if found.is_empty() && aim.measured.is_ok() {
                Cell::text(format!("all of {}", aim.bench))
            } else {
                lines(found)
            },
            Cell::text(format!("cargo xtask bench --peers {}", aim.bench)),
        ]);
    }
    table
}

fn bound(bound: Option<Bound>) -> Cell {
    Cell::text(match bound {
        None => String::new(),
        Some(Bound::AtMost(0.0)) => "0".into(),
        Some(Bound::AtLeast(least)) => format!("≥ {}", round_digits(least, 2)),
        Some(Bound::AtMost(most)) => format!("≤ {}", round_digits(most, 2)),
    })
}

fn outcome(aim: &Aim) -> String {
    let (value, _) = match &aim.measured {
        Ok(measured) => measured,
        Err(missing) => return format!("not measured: {missing}"),
    };
    let met = |bound: Option<Bound>| bound.map(|bound| bound.is_met(*value));
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
    let columns = vec![
        Column::text("work", "Work"),
        Column::text("method", "Method"),
        Column::number("tolerance", "Tolerance", ""),
        Column::number("cpu_us", "CPU time per item", "µs"),
        Column::number("over_ours", "Ratio to our fastest", ""),
        Column::number("worst_error", "Largest error", ""),
        Column::text("wrong", "Wrong or failed"),
        Column::number("row", "Row", ""),
    ];
    let note = format!(
        "Printed by `cargo xtask bench --peers`; the lines of `timings/{}` have the command of each row. Wrong answers are not included in the errors.",
        PEERS_FILE
    );
    let mut table = Table::new(id, title, columns).with_note(&note);
    for PeerGroup { row, over_ours } in work_groups(&timings.peers) {
        if !wanted(&row.work) {
            continue;
        }
        table.push(vec![
            Cell::text(&row.work),
            Cell::text(&row.method),
            optional(row.tolerance),
            number(micro(row)),
            optional(over_ours),
            Cell::number(error_text(row)),
            Cell::text(format!("{} of {}", row.wrong, row.items)),
            Cell::number(row.line.to_string()),
        ]);
    }
    table
}

/// The error as printed where 64 bits do not hold it, in two digits elsewhere.
fn error_text(row: &PeerRow) -> String {
    match row.error_value() {
        Some(value) if value > 0.0 => round_digits(value, 2),
        _ => row.error.clone(),
    }
}

fn cycles(timings: &Timings) -> Table {
    let columns = vec![
        Column::text("kind", "Kind"),
        Column::number("error", "Required error", ""),
        Column::text("method", "Method"),
        Column::text("cases", "Cases"),
        Column::number("mean_over_ours", "Ratio to our fastest, mean", ""),
        Column::text("range_over_ours", "Smallest and largest"),
        Column::text("rows", "Rows"),
    ];
    let note = format!(
        "Printed by `cargo xtask bench --peers cycles` and `… smooth`. For each case and method, the fastest tolerance whose measured error is at most the required error. Ratios are to our fastest method on the same case at the same error; their mean is geometric. Rows are lines of `timings/{}`.",
        PEERS_FILE
    );
    let mut table =
        Table::new("peers-cycles", "Cycles and smooth regimes at equal error: ours and others", columns)
            .with_note(&note);
    for reached in cycle_groups(&timings.peers) {
        table.push(cycle_row(&reached));
    }
    table
}

fn cycle_row(reached: &Reached<'_>) -> Vec<Cell> {
    let range = reached.range_over_ours();
    let range = range.map(|(least, most)| format!("{} to {}", round_digits(least, 2), round_digits(most, 2)));
    vec![
        Cell::text(reached.kind),
        Cell::number(round_digits(reached.error, 1)),
        Cell::text(reached.method),
        Cell::text(format!("{} of {}", reached.rows.len(), reached.cases)),
        optional(reached.mean_over_ours()),
        Cell::text(range.unwrap_or_default()),
        lines(reached.rows.iter().map(|row| row.line)),
    ]
}

fn laws(timings: &Timings) -> Table {
    let columns = vec![
        Column::text("what", "Varied quantity"),
        Column::text("law", "CPU time, s, by its size n"),
        Column::number("residual", "Largest residual, factor", ""),
        Column::number("top_size", "Largest size measured", ""),
        Column::number("top_cpu_s", "CPU time there", "s"),
        Column::number("top_predicted_cpu_s", "Predicted by the law without it", "s"),
        Column::number("peak_memory_mib", "Peak memory there", "MiB"),
        Column::number("asked_size", "Predicted size", ""),
        Column::number("asked_cpu_s", "Predicted CPU time", "s"),
        Column::text("rows", "Rows"),
        Column::text("command", "Command of the largest"),
    ];
    let note = format!(
        "Printed by `cargo xtask cost`; rows are lines of `timings/{}`, which has every command. Times are for one thread unless the number of threads varies. Laws are least-squares fits to the rows.",
        COST_FILE
    );
    let mut table = Table::new("cost-laws", "Growth of CPU time and memory", columns).with_note(&note);
    for series in cost_series(&timings.cost) {
        table.rows.extend(series.rows.last().map(|top| law_row(top, &series)));
    }
    table
}

fn law_row(top: &CostRow, series: &CostSeries<'_>) -> Vec<Cell> {
    let at = |law: &Option<Law>, size: f64| law.as_ref().map(|law| law.at(size));
    let residual = series.law.as_ref().map(|law| law.worst_residual(&series.points()));
    vec![
        Cell::text(&top.series),
        Cell::text(series.law.as_ref().map(law_text).unwrap_or_default()),
        optional(residual),
        number(top.size),
        number(top.cpu_s),
        optional(at(&series.law_below_top, top.size)),
        number(top.peak_memory_kib / 1024.0),
        optional(top.requested),
        optional(top.requested.and_then(|size| at(&series.law, size))),
        lines(series.rows.iter().map(|row| row.line)),
        Cell::text(&top.command),
    ]
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
    let columns =
        vec![Column::text("file", "File"), Column::text("key", "Item"), Column::text("value", "Value")];
    let mut table = Table::new("timings-machine", "Machine and date of the measurements", columns);
    for row in &timings.machine {
        table.push(vec![Cell::text(&row.file), Cell::text(&row.key), Cell::text(&row.value)]);
    }
    table
}
