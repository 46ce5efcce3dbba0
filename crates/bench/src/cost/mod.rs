//! `cargo xtask cost`: how time and memory grow with points, rows, digits, tolerance, runs and threads.
//!
//! Every number is measured on the profile `dist` of the command line, one process at a time. A law is fitted to the CPU
//! times of each ladder but its top rung (wall times tell of the machine's other work too); what it says of the top is printed
//! beside what was measured there. The result is a CSV and a
//! Markdown file under `crates/bench/results/`, which enter a report only by `cargo xtask timings`.

mod fit;
mod ladders;
pub mod measure;

use std::fmt::Write as _;
use std::fs;

use crate::{measured_on, process, repository};
use fit::{Form, Law};
use ladders::Ladder;
use measure::Measured;

/// A ladder with what was measured on its rungs.
struct Climbed {
    ladder: Ladder,
    measured: Vec<Measured>,
}

/// Measures every ladder, writes both files and prints the Markdown.
///
/// # Errors
/// When the build or a measured command fails, or a file cannot be written.
pub fn run() -> Result<(), String> {
    let program = process::build_dist()?;
    let root = repository::root();
    let folder = root.join("target/cost");
    fs::create_dir_all(&folder).map_err(|error| cannot_write(&error))?;
    let mut climbed = Vec::new();
    for ladder in ladders::all(&folder).map_err(|error| cannot_write(&error))? {
        eprintln!("cost: {}", ladder.name);
        let mut measured = Vec::new();
        for rung in &ladder.rungs {
            measured.push(measure::run(&program, &rung.arguments, &folder)?);
        }
        climbed.push(Climbed { ladder, measured });
    }
    let report = markdown(&climbed);
    let results = measured_on::folder();
    fs::create_dir_all(&results).map_err(|error| cannot_write(&error))?;
    for (name, text) in [("cost.csv", csv(&climbed)), ("cost.md", format!("{}\n", report.trim_end()))] {
        fs::write(results.join(name), text).map_err(|error| cannot_write(&error))?;
    }
    measured_on::write("cost.csv", &measured_on::facts())?;
    print!("{report}");
    Ok(())
}

fn cannot_write(error: &std::io::Error) -> String {
    format!("target/cost or crates/bench/results: {error}")
}

fn csv(climbed: &[Climbed]) -> String {
    let mut text = String::from("ladder,variable,size,wall_s,cpu_s,peak_memory_kib,form,asked,command\n");
    for Climbed { ladder, measured } in climbed {
        let form = ladder.form.map_or_else(String::new, Form::words);
        let asked = ladder.asked.map_or_else(String::new, |size| format!("{size:e}"));
        for (rung, found) in ladder.rungs.iter().zip(measured) {
            let _ = writeln!(
                text,
                "{},{},{},{:.4},{:.4},{},{form},{asked},slipmode {}",
                // No cell has a comma or a quote.
                ladder.name.replace(',', ";"),
                ladder.variable,
                rung.size,
                found.wall_s,
                found.cpu_s,
                found.peak_kib,
                rung.arguments.join(" ")
            );
        }
    }
    text
}

fn markdown(climbed: &[Climbed]) -> String {
    let mut text = String::from("# Cost\n\n");
    let facts: Vec<String> =
        measured_on::facts().into_iter().map(|(key, value)| format!("{key} {value}")).collect();
    let _ = writeln!(text, "Command: `cargo xtask cost`. Release build; {}.\n", facts.join(", "));
    for one in climbed {
        text += &section(one);
    }
    text
}

fn section(Climbed { ladder, measured }: &Climbed) -> String {
    let mut text = format!("## {}\n\nCommand: `slipmode {}`\n\n", ladder.name, ladder.template);
    let _ = writeln!(text, "| {} | wall s | CPU s | peak memory MiB |\n|---|---|---|---|", ladder.variable);
    for (rung, found) in ladder.rungs.iter().zip(measured) {
        let mib = found.peak_kib as f64 / 1024.0;
        let _ = writeln!(text, "| {} | {:.3} | {:.3} | {mib:.1} |", rung.size, found.wall_s, found.cpu_s);
    }
    text.push('\n');
    let seconds: Vec<(f64, f64)> =
        ladder.rungs.iter().zip(measured).map(|(rung, found)| (rung.size, found.cpu_s)).collect();
    if let Some(form) = ladder.form {
        text += &fitted(ladder, form, &seconds);
    }
    text
}

/// The law of all rungs but the last, and what it says of the last; the law of all, and what it says of the size asked about.
fn fitted(ladder: &Ladder, form: Form, seconds: &[(f64, f64)]) -> String {
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
    if let Some(asked) = ladder.asked {
        let _ = writeln!(text, "{asked:e} {} would take {:.3e} s.", ladder.variable, all.at(asked));
    }
    text.push('\n');
    text
}
