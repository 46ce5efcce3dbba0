//! The file `contents.toml` that tells a report what tables and line charts were measured.

use std::fmt::Write as _;

use slipmode_plot::figure::Series;
use slipmode_plot::table::{Column, Kind, Table};

use crate::chart::{Chart, LogAxis, ends};

/// The text of `contents.toml`: the files that the rows follow from, each table's words and columns, and each chart.
#[must_use]
pub fn contents(sources: &[&str], tables: &[Table], charts: &[Chart]) -> String {
    let mut text = format!(
        "# Written by `cargo xtask tables`: what slipmode-bench counted, and what follows from the times that it measured.\nsources = {}\n",
        list(sources)
    );
    for table in tables {
        write_table(&mut text, table);
    }
    for chart in charts {
        write_chart(&mut text, chart);
    }
    text
}

fn write_table(text: &mut String, table: &Table) {
    text.push_str("\n[[table]]\n");
    write_pair(text, "id", &table.id);
    write_pair(text, "title", &table.title);
    if !table.note.is_empty() {
        write_pair(text, "note", &table.note);
    }
    text.push_str("columns = [\n");
    for column in &table.columns {
        write_line(text, &format!("  {{ {} }},", column_keys(column)));
    }
    text.push_str("]\n");
}

fn column_keys(column: &Column) -> String {
    let mut keys = format!("name = {}, header = {}", quoted(&column.name), quoted(&column.header));
    if !column.unit.is_empty() {
        keys += &format!(", unit = {}", quoted(&column.unit));
    }
    if column.kind == Kind::Number {
        keys += ", number = true";
    }
    keys
}

fn write_chart(text: &mut String, chart: &Chart) {
    text.push_str("\n[[chart]]\n");
    let words = [
        ("id", chart.id),
        ("label", chart.label),
        ("title", &chart.title),
        ("caption", &chart.caption),
        ("description", chart.description),
    ];
    for (key, value) in words {
        write_pair(text, key, value);
    }
    write_line(text, &format!("data = {}", list(chart.data)));
    let points = || chart.series.iter().flat_map(|line| line.points.iter());
    write_line(text, &format!("x = {}", axis(chart.x, points().map(|point| point.0))));
    write_line(text, &format!("y = {}", axis(chart.y, points().map(|point| point.1))));
    text.push_str("series = [\n");
    for line in &chart.series {
        write_line(text, &format!("  {},", series(line)));
    }
    text.push_str("]\n");
    if let Some((at, label)) = chart.vertical {
        write_line(text, &format!("verticals = [{{ at = {at:e}, label = {} }}]", quoted(label)));
    }
}

fn axis(axis: LogAxis, values: impl Iterator<Item = f64>) -> String {
    let mut keys = format!("title = {}", quoted(axis.title));
    if !axis.unit.is_empty() {
        keys += &format!(", unit = {}", quoted(axis.unit));
    }
    if let Some([from, to]) = axis.ends.or_else(|| ends(values)) {
        keys += &format!(", from = {from:e}, to = {to:e}");
    }
    format!("{{ {keys} }}")
}

/// Numbers are printed with as many digits as bring back the same 64 bits.
fn series(series: &Series) -> String {
    let points: Vec<String> = series.points.iter().map(|(x, y)| format!("[{x:e}, {y:e}]")).collect();
    format!("{{ label = {}, points = [{}] }}", quoted(&series.label), points.join(", "))
}

fn list(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(|name| quoted(name)).collect();
    format!("[{}]", names.join(", "))
}

fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

fn write_pair(text: &mut String, key: &str, value: &str) {
    write_line(text, &format!("{key} = {}", quoted(value)));
}

fn write_line(text: &mut String, line: &str) {
    // A string has no way to fail.
    let _ = writeln!(text, "{line}");
}
