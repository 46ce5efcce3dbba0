//! `cargo xtask cost`: how time and memory grow with points, rows, digits, tolerance, runs and threads.
//!
//! Every number is measured on the profile `dist` of the command line, one process at a time. A law is fitted to the CPU
//! times of each series but its last (wall times include the machine's other work); what it predicts for the last is printed
//! next to what was measured there. Then come the sweeps, whose neighbours may not differ by more than a stated ratio.
//! The results are CSV and Markdown files under `crates/bench/results/`, which enter a report only by `cargo xtask timings`.

pub mod measure;
mod series;
mod sweeps;

use std::fmt::Write as _;
use std::fs;

use crate::least_squares::{Form, Law};
use crate::{measured_on, process, repository};
use measure::Measured;
use series::Series;

/// A series with what each of its commands costs.
struct MeasuredSeries {
    series: Series,
    measured: Vec<Measured>,
}

/// Measures every sweep, and with `series` every series before; writes the files and prints the Markdown.
///
/// # Errors
/// When the build or a measured command fails, a file cannot be written, or a sweep has a ratio outside its bounds.
pub fn run(with_series: bool) -> Result<(), String> {
    if with_series {
        run_series()?;
    }
    sweeps::run()
}

fn run_series() -> Result<(), String> {
    let program = process::build_dist()?;
    let root = repository::root();
    let folder = root.join("target/cost");
    fs::create_dir_all(&folder).map_err(|error| cannot_write(&error))?;
    let mut measured_series = Vec::new();
    for series in series::all(&folder).map_err(|error| cannot_write(&error))? {
        eprintln!("cost: {}", series.name);
        let mut measured = Vec::new();
        for command in &series.commands {
            measured.push(measure::run(&program, &command.arguments, &folder)?);
        }
        measured_series.push(MeasuredSeries { series, measured });
    }
    let report = markdown(&measured_series);
    write("cost", &csv(&measured_series), &report)?;
    print!("{report}");
    Ok(())
}

/// Writes `NAME.csv` and `NAME.md`, and on which machine they were measured.
fn write(name: &str, csv: &str, markdown: &str) -> Result<(), String> {
    let folder = measured_on::folder();
    fs::create_dir_all(&folder).map_err(|error| cannot_write(&error))?;
    let table = format!("{name}.csv");
    for (file, text) in [(&table, csv), (&format!("{name}.md"), &format!("{}\n", markdown.trim_end()))] {
        fs::write(folder.join(file), text).map_err(|error| cannot_write(&error))?;
    }
    measured_on::write(&table, &measured_on::facts())
}

fn cannot_write(error: &std::io::Error) -> String {
    format!("target/cost or crates/bench/results: {error}")
}

fn csv(measured_series: &[MeasuredSeries]) -> String {
    let mut text = String::from("series,variable,size,wall_s,cpu_s,peak_memory_kib,form,asked,command\n");
    for MeasuredSeries { series, measured } in measured_series {
        let form = series.form.map_or_else(String::new, Form::words);
        let asked = series.asked.map_or_else(String::new, |size| format!("{size:e}"));
        for (command, found) in series.commands.iter().zip(measured) {
            let _ = writeln!(
                text,
                "{},{},{},{:.4},{:.4},{},{form},{asked},slipmode {}",
                // No cell has a comma or a quote.
                series.name.replace(',', ";"),
                series.variable,
                command.size,
                found.wall_s,
                found.cpu_s,
                found.peak_kib,
                command.arguments.join(" ")
            );
        }
    }
    text
}

fn markdown(measured_series: &[MeasuredSeries]) -> String {
    let mut text = String::from("# Cost\n\n");
    let facts: Vec<String> =
        measured_on::facts().into_iter().map(|(key, value)| format!("{key} {value}")).collect();
    let _ = writeln!(text, "Command: `cargo xtask cost`. Release build; {}.\n", facts.join(", "));
    for one in measured_series {
        text += &section(one);
    }
    text
}

fn section(MeasuredSeries { series, measured }: &MeasuredSeries) -> String {
    let mut text = format!("## {}\n\nCommand: `slipmode {}`\n\n", series.name, series.template);
    let _ = writeln!(text, "| {} | wall s | CPU s | peak memory MiB |\n|---|---|---|---|", series.variable);
    for (command, found) in series.commands.iter().zip(measured) {
        let mib = found.peak_kib as f64 / 1024.0;
        let _ = writeln!(text, "| {} | {:.3} | {:.3} | {mib:.1} |", command.size, found.wall_s, found.cpu_s);
    }
    text.push('\n');
    let seconds: Vec<(f64, f64)> =
        series.commands.iter().zip(measured).map(|(command, found)| (command.size, found.cpu_s)).collect();
    if let Some(form) = series.form {
        text += &fitted(series, form, &seconds);
    }
    text
}

/// The law of all commands but the last, and its prediction for the last; the law of all, and its prediction for a size that was not measured.
fn fitted(series: &Series, form: Form, seconds: &[(f64, f64)]) -> String {
    let Some(((top, found), below)) = seconds.split_last() else { return String::new() };
    let (Some(law), Some(all)) = (Law::fit(form, below), Law::fit(form, seconds)) else {
        return String::new();
    };
    let mut text = format!(
        "Without the last row, CPU time ~ {} (largest residual: factor {:.2}); it says {:.3} s for the last row, where \
         {found:.3} s were measured.\n\nWith all rows, CPU time ~ {} (largest residual: factor {:.2}).\n",
        law.text(),
        law.worst_residual(below),
        law.at(*top),
        all.text(),
        all.worst_residual(seconds),
    );
    if let Some(asked) = series.asked {
        let _ = writeln!(text, "{asked:e} {} would take {:.3e} s.", series.variable, all.at(asked));
    }
    text.push('\n');
    text
}
