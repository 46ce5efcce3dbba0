//! `slipmode compare`: runs of other programs compared with the theory and with our simulation.

mod figures;
mod inputs;
mod page;
mod rows;
mod tables;
mod view;

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use slipmode::report::ProvenanceView;
use slipmode::scene::{AllowedRange, first_lines};
use slipmode_core::number::nearest_f64;

use crate::cli::dialect::DialectOptions;
use crate::cli::environment::Environment;
use crate::cli::failure::Failure;
use crate::cli::input::open_csv;
use crate::cli::options::Arguments;
use crate::cli::output::{Output, OutputFolder, is_stream};
use crate::cli::path_text::word_of;
use crate::cli::points::{Started, print_warnings};
use crate::cli::progress::Progress;
use crate::cli::simulate::over_box::BoxOptions;
use crate::cli::terminal::{self, count_of};
use crate::cli::words::law_of_word;
use rows::{CompareRows, ComparedRow, counts};

/// Options of `compare`.
#[derive(Debug, Args)]
pub struct Options {
    /// The runs, one per row; `-` reads standard input
    ///
    /// The header is that of `classify --points`, with at least one of the columns peak_velocity_m_per_s, period_s,
    /// stress_drop_pa, frequency_hz, mode (periodic, decaying, or a slip mode) and trajectory (a CSV file in the folder of the
    /// runs file or below it, with time_s, velocity_m_per_s and optionally shear_stress_pa, that of the spring). Columns law, start
    /// and tolerance are optional; other columns are kept; empty cells are ignored. Limits of a trajectory: 8 to 10 000 000
    /// samples. Parameters may have error bars, as in `classify --points`: a value that differs at the middle values is compared with
    /// the range over the error bars, which is sampled, and the verdict is then `agrees-within-error-bars`.
    #[arg(long, value_name = "FILE.csv")]
    runs: PathBuf,
    /// The evolution law, `slip` or `aging`, of a file without a column `law` [default: slip]
    #[arg(long, value_name = "LAW", allow_hyphen_values = true)]
    law: Option<String>,
    /// Relative error of the runs' values, 1e-13 to 0.5; a column `tolerance` states it row by row
    ///
    /// A value agrees if it differs from ours by at most this plus the errors of both sides. A value with a larger error is not
    /// compared. The relative error of our simulation is a hundredth of this, or 1e-8 if that is smaller.
    #[arg(long, value_name = "T", default_value = "1e-2", allow_hyphen_values = true)]
    tolerance: String,
    /// Compares the valid rows although others are invalid; the command lists their faults and exits with 1
    ///
    /// The rows written with --output get a column `error`.
    #[arg(long)]
    keep_going: bool,
    #[command(flatten)]
    dialect: DialectOptions,
    #[command(flatten)]
    within_error_bars: BoxOptions,
    /// One JSON object instead of text
    #[arg(long)]
    json: bool,
    /// Also write the rows as CSV, with the results of theory and simulation and the verdicts; `-` is standard output, instead of text
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<PathBuf>,
    /// Also write a report folder: index.html, report.md, tables and figures
    #[arg(long, value_name = "DIR")]
    report: Option<PathBuf>,
}

/// Runs the command.
///
/// # Errors
/// When the arguments, the rows or their trajectories are at fault, an output cannot be written, or a row does not agree.
pub fn run(options: &Options, progress: Progress) -> Result<(), Failure> {
    let environment = Environment::start();
    let command = options.command()?;
    let create = |place: &Path| OutputFolder::create(place, &["index.html", "report.md"]);
    let folder = options.report.as_deref().map(create).transpose()?;
    let rows = open_csv(&options.runs, options.dialect.dialect())?;
    let started = Started::new(rows, command, options.keep_going, progress)?;
    let output = options.output.as_deref().map(Output::create).transpose()?;
    let (done, output) = match output {
        Some(mut output) => (started.work(&mut output)?, Some(output)),
        None => (started.work(&mut io::sink())?, None),
    };
    if let Some(folder) = folder {
        let (command, inputs) = (options.words(), inputs::inputs(&options.runs, &done.kept)?);
        let provenance = ProvenanceView { command, inputs, ..ProvenanceView::default() };
        folder.commit(&page::files(provenance, &done, &environment)?)?;
    }
    let takes_stdout = options.output.as_deref().is_some_and(is_stream);
    output.map_or(Ok(()), Output::commit)?;
    if options.json || !takes_stdout {
        view::answer(&done.kept, done.counts.faulty).print(options.json)?;
    }
    let faults = done.faults.iter().map(ToString::to_string);
    first_lines(faults, |more| format!("and at least {more} more like these"))
        .iter()
        .for_each(|fault| terminal::message(fault));
    print_warnings(&done.counts);
    verdict(&done.kept, done.counts.faulty)
}

impl Options {
    /// The command that makes the report, without the folders of this machine.
    fn words(&self) -> String {
        let file = self.runs.file_name().map_or(&*self.runs, Path::new);
        let (DialectOptions { delimiter, decimal }, BoxOptions { box_runs }) =
            (&self.dialect, &self.within_error_bars);
        let given =
            [("law", &self.law), ("delimiter", delimiter), ("decimal", decimal), ("box-runs", box_runs)];
        let given = given.iter().filter_map(|(option, value)| Some((*option, value.as_ref()?.as_ref())));
        let all = [("runs", file), ("tolerance", self.tolerance.as_ref())].into_iter().chain(given);
        let all: String = all.map(|(option, value)| format!("--{option} {} ", word_of(value))).collect();
        format!("slipmode compare {all}{}--report DIR", if self.keep_going { "--keep-going " } else { "" })
    }

    fn command(&self) -> Result<CompareRows, Failure> {
        let mut arguments = Arguments::default();
        let law = self.law.as_ref().and_then(|word| arguments.number("--law", word, law_of_word));
        let range = AllowedRange::RUN_TOLERANCE;
        let tolerance = arguments.number("--tolerance", &self.tolerance, |text| range.parse(text));
        arguments.refuse_stream("--output", self.output.as_deref().filter(|_| self.json), "the object");
        let box_runs = self.within_error_bars.read(&mut arguments);
        let tolerance = arguments.finish(tolerance)?;
        // Standard input has no folder: trajectories are looked for in the current one.
        let folder = self.runs.parent().filter(|folder| !folder.as_os_str().is_empty());
        Ok(CompareRows {
            folder: folder.unwrap_or(Path::new(".")).to_path_buf(),
            law,
            tolerance: nearest_f64(&tolerance),
            dialect: self.dialect.dialect(),
            keeps_recordings: self.report.is_some(),
            box_runs,
        })
    }
}

/// Success when every row agrees and none was passed over.
fn verdict(rows: &[ComparedRow], faulty: u64) -> Result<(), Failure> {
    let [_, differs, open] = counts(rows);
    let rest = format!("{}, {differs} differ and {open} could not be compared", count_of(rows.len(), "row"));
    match differs + open {
        _ if faulty > 0 => Err(Failure::Check(format!(
            "{} passed over as invalid; of the other {rest}",
            count_of(faulty, "row")
        ))),
        _ if rows.is_empty() => Err(Failure::Check("no rows, so nothing was compared".into())),
        0 => Ok(()),
        _ => Err(Failure::Check(format!("of {rest}"))),
    }
}
