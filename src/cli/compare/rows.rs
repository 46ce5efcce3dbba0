//! The rows of a runs file: read with their trajectories, compared, their verdicts appended.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use slipmode::comparison::recording::Recording;
use slipmode::comparison::{Agreement, Comparison, Finding, Observable, StatedMode, StatedRun, compare_run};
use slipmode::csv::{
    Cells, Column, Datum, Dialect, Remark, RowWork, is_named, misnamed, names, push_cells, read_recording,
};
use slipmode::scene::{AllowedRange, CsvProblem, Faults, Problem, Quantity, check_name, nearest, of_word};
use slipmode_core::dynamics::{Options, Simulation, Start};
use slipmode_core::friction::{EvolutionLaw, ParameterBox, Parameters};
use slipmode_core::number::{Rational, nearest_f64};

use crate::cli::input::{open_named_csv, place_inside};
use crate::cli::simulate::over_box::{is_point, points_within};
use crate::cli::simulate::range;
use crate::cli::simulate::run::simulate_point;
use crate::cli::words::{LAW_COLUMN, law_of_word, start_of_word};

/// The optional columns next to the values.
const TRAJECTORY_COLUMN: &str = "trajectory";
const START_COLUMN: &str = "start";
const TOLERANCE_COLUMN: &str = "tolerance";

/// Compares rows.
#[derive(Debug)]
pub struct CompareRows {
    /// The folder of the runs file, where trajectories are.
    pub folder: PathBuf,
    /// The law of all rows, when the command line gives it.
    pub law: Option<EvolutionLaw>,
    /// The relative error of the values of rows that state none.
    pub tolerance: f64,
    /// How the trajectories are written, as the runs are.
    pub dialect: Dialect,
    /// Whether trajectories are wanted back, for figures.
    pub keeps_recordings: bool,
    /// Runs at points spread within the error bars of a row.
    pub box_runs: u64,
}

/// A row that was read.
#[derive(Debug, Clone)]
pub struct ReadRow {
    /// The number of the row, the header being row 0.
    pub number: u64,
    /// What it states; without its trajectory, once compared, unless figures are wanted.
    pub run: StatedRun,
    /// All values within its error bars.
    pub region: ParameterBox,
    /// The start of our simulation.
    pub start: Start,
    /// The file of its trajectory, as the row names it.
    pub trajectory: Option<String>,
}

/// A row that was compared.
#[derive(Debug)]
pub struct ComparedRow {
    /// What was read.
    pub read: ReadRow,
    /// The comparison.
    pub comparison: Comparison,
    /// Groups outside the ranges over which simulations were tested.
    pub warnings: Vec<String>,
}

impl RowWork for CompareRows {
    type Input = ReadRow;
    type Kept = ComparedRow;

    const APPENDED: &'static [&'static str] = &names(&COLUMNS);
    /// A row takes milliseconds, and some a hundred times longer than others.
    const BLOCK_ROWS: usize = 1;
    const BLOCKS_PER_THREAD: usize = 16;

    fn header_faults(&self, names: &[String]) -> Vec<(String, Problem)> {
        let has = |key: &str| names.iter().any(|name| is_named(name, key));
        // A column that is known by its own name is no misspelling of another.
        let is_unknown = |name: &&str| !Quantity::ALL.iter().any(|quantity| quantity.as_str() == *name);
        let unknown: Vec<&str> = names.iter().map(String::as_str).filter(is_unknown).collect();
        let mut faults = Vec::new();
        if has(LAW_COLUMN) && self.law.is_some() {
            let problem = Problem::Needs("no --law together with it: the column chooses the law".into());
            faults.push((LAW_COLUMN.to_string(), problem));
        }
        for key in Observable::STATED.map(Observable::as_str) {
            let missing = || nearest(key, unknown.iter().copied()).filter(|_| !has(key));
            if let Some((name, problem)) = misnamed(key, names) {
                faults.push((name, problem.into()));
            } else if let Some(near) = missing() {
                let problem =
                    CsvProblem::MissingColumn { nearest: Some(near.to_string()), allowed: key.into() };
                faults.push((key.to_string(), problem.into()));
            }
        }
        let known: Vec<&str> = observable_columns().collect();
        if faults.is_empty() && !known.iter().any(|key| has(key)) {
            let allowed = format!("at least one of the columns {}", known.join(", "));
            faults.push((known[0].to_string(), Problem::Missing { allowed }));
        }
        faults
    }

    fn reads(&self, name: &str) -> bool {
        let more = [LAW_COLUMN, START_COLUMN, TOLERANCE_COLUMN];
        observable_columns().chain(more).any(|column| is_named(name, column))
    }

    fn read(&self, cells: Cells<'_>) -> Result<ReadRow, Faults> {
        let mut reader = RowCells { cells, faults: Faults::new() };
        let region = cells.region().map_err(|faults| reader.faults.extend(faults)).ok();
        let parameters = region.as_ref().map(ParameterBox::middle);
        let law = reader.optional(LAW_COLUMN, law_of_word).or(self.law).unwrap_or(EvolutionLaw::Slip);
        let start = reader.optional(START_COLUMN, start_of_word);
        let tolerance = reader.optional(TOLERANCE_COLUMN, |text| AllowedRange::RUN_TOLERANCE.parse(text));
        let mode = reader.optional(Observable::Mode.as_str(), mode_of_word);
        let values = Observable::STATED.map(|of| {
            reader
                .optional(of.as_str(), |text| AllowedRange::PHYSICAL.parse_measured(text, of.unit()))
                .map(|value| nearest_f64(&value))
        });
        let recording = self.recording(&mut reader, parameters.as_ref());
        let (Some((parameters, region)), true) = (parameters.zip(region), reader.faults.is_empty()) else {
            return Err(reader.faults);
        };
        let run = StatedRun {
            parameters,
            law,
            has_known_start: start.is_some(),
            tolerance: tolerance.map_or(self.tolerance, |tolerance| nearest_f64(&tolerance)),
            mode,
            values,
            recording: recording.map(Arc::new),
        };
        let trajectory = reader.optional(TRAJECTORY_COLUMN, |name| Ok(name.to_owned()));
        Ok(ReadRow { run, region, start: start.unwrap_or_default(), number: cells.row.number, trajectory })
    }

    fn append(&self, row: &ReadRow, out: &mut Vec<u8>) -> Remark<ComparedRow> {
        let simulate = |parameters: &Parameters<Rational>, law, tolerance| {
            simulate_point(parameters, law, Options { start: row.start, ..Options::at(tolerance) })
        };
        let others = points_within(&row.region, self.box_runs);
        let mut compared = ComparedRow {
            read: row.clone(),
            comparison: compare_run(&row.run, &others, &simulate),
            warnings: range::warnings(&row.run.parameters),
        };
        if !self.keeps_recordings {
            compared.read.run.recording = None;
        }
        push_cells(&COLUMNS, &compared, out);
        Remark {
            is_unanswered: compared.comparison.verdict == Agreement::NotCompared,
            warning: Remark::<()>::warning(&compared.warnings).warning,
            kept: compared,
        }
    }
}

impl CompareRows {
    /// The trajectory that a row names; none when it names none, or when it is at fault.
    fn recording(
        &self,
        reader: &mut RowCells<'_>,
        parameters: Option<&Parameters<Rational>>,
    ) -> Option<Recording> {
        let place = reader.optional(TRAJECTORY_COLUMN, |name| trajectory_place(&self.folder, name))?;
        // Without its velocity the row is refused anyway.
        let log_level = libm::log(nearest_f64(&parameters?.point.loading_velocity_m_per_s));
        let rows = open_named_csv(&place, self.dialect).map_err(|fault| vec![fault]);
        let read = rows.and_then(|rows| read_recording(rows, log_level));
        read.map_err(|faults| reader.faults.extend(faults)).ok()
    }
}

/// The place of a trajectory: parts of safe names below the folder of the runs file, and no link that leads out of it.
///
/// # Errors
/// When the name is not safe or the file is not there.
fn trajectory_place(folder: &Path, name: &str) -> Result<PathBuf, Problem> {
    name.split('/').try_for_each(check_name).map_err(Problem::BadName)?;
    place_inside(folder, name).map_err(|error| Problem::from(&error))
}

/// How many rows agree, within the error bars of their parameters at least, differ and could not be compared.
pub fn counts(rows: &[ComparedRow]) -> [usize; 3] {
    let of =
        |verdicts: &[Agreement]| rows.iter().filter(|row| verdicts.contains(&row.comparison.verdict)).count();
    let agrees = [Agreement::Agrees, Agreement::AgreesWithinErrorBars];
    [of(&agrees), of(&[Agreement::Differs]), of(&[Agreement::NotCompared])]
}

/// How many rows agree within their error bars only; none where no row has error bars.
pub fn within_error_bars(rows: &[ComparedRow]) -> Option<usize> {
    let agrees = |row: &&ComparedRow| row.comparison.verdict == Agreement::AgreesWithinErrorBars;
    rows.iter().any(|row| !is_point(&row.read.region)).then(|| rows.iter().filter(agrees).count())
}

/// Columns of which one at least has to be there.
fn observable_columns() -> impl Iterator<Item = &'static str> {
    let stated = Observable::STATED.into_iter().map(Observable::as_str);
    stated.chain([Observable::Mode.as_str(), TRAJECTORY_COLUMN])
}

fn mode_of_word(text: &str) -> Result<StatedMode, Problem> {
    of_word(text, &StatedMode::all(), |mode| mode.as_str())
}

/// The optional cells of a row, with the faults found so far.
struct RowCells<'r> {
    cells: Cells<'r>,
    faults: Faults,
}

impl RowCells<'_> {
    /// What a cell says; none when there is no such column, or the cell is empty, or at fault.
    fn optional<T>(&mut self, column: &str, parse: impl FnOnce(&str) -> Result<T, Problem>) -> Option<T> {
        let position = self.cells.header.position(column)?;
        let text = self.cells.text(position);
        if text.is_empty() {
            return None;
        }
        parse(text).map_err(|problem| self.faults.push(self.cells.fault(Some(position), problem))).ok()
    }
}

/// The appended columns.
pub const COLUMNS: [Column<ComparedRow>; 22] = [
    ("theory_class", |row| word(row.comparison.theory.class.as_str())),
    ("theory_slip_mode", |row| word(row.comparison.theory.slip_mode.as_str())),
    ("theory_stiffness_over_critical", |row| Datum::Number(row.comparison.theory.stiffness_ratio)),
    ("theory_frequency_hz", |row| Datum::Number(row.comparison.theory.frequency_hz)),
    ("simulated_mode", |row| simulated_word(row, |found| found.behaviour.as_str())),
    ("simulated_slip_mode", |row| simulated_word(row, |found| found.slip_mode.as_str())),
    ("simulated_peak_velocity_m_per_s", |row| simulated(row, |found| Some(found.peak_velocity_m_per_s))),
    ("simulated_period_s", |row| simulated(row, |found| found.period_s)),
    ("simulated_stress_drop_pa", |row| simulated(row, |found| Some(found.stress_drop_pa))),
    ("simulated_frequency_hz", |row| simulated(row, |found| found.frequency_hz)),
    ("simulated_peak_relative_error", |row| simulated(row, |found| Some(found.peak_relative_error))),
    ("simulated_period_relative_error", |row| simulated(row, |found| found.period_relative_error)),
    ("mode_verdict", |row| verdict_on(row, Observable::Mode)),
    ("peak_velocity_verdict", |row| verdict_on(row, Observable::PeakVelocity)),
    ("period_verdict", |row| verdict_on(row, Observable::Period)),
    ("stress_drop_verdict", |row| verdict_on(row, Observable::StressDrop)),
    ("frequency_verdict", |row| verdict_on(row, Observable::Frequency)),
    ("growth_rate_verdict", |row| verdict_on(row, Observable::GrowthRate)),
    ("largest_difference", |row| Datum::Number(largest_difference(&row.comparison))),
    ("verdict", |row| word(row.comparison.verdict.as_str())),
    ("reason", |row| Datum::Text(reason(&row.comparison))),
    ("warning", |row| Datum::Text(row.warnings.join("; "))),
];

fn word(word: &str) -> Datum {
    Datum::Text(word.into())
}

fn simulated(row: &ComparedRow, value: fn(&Simulation) -> Option<f64>) -> Datum {
    Datum::Number(row.comparison.simulation.as_ref().ok().and_then(value))
}

fn simulated_word(row: &ComparedRow, of: fn(&Simulation) -> &'static str) -> Datum {
    word(row.comparison.simulation.as_ref().map_or("", of))
}

/// The verdict on one quantity over all its references and origins; empty when the run does not give it.
fn verdict_on(row: &ComparedRow, of: Observable) -> Datum {
    let verdicts = row.comparison.findings.iter().filter(|finding| finding.observable == of);
    let verdict = verdicts.map(|finding| finding.verdict).max();
    word(verdict.map_or("", Agreement::as_str))
}

/// The difference of the largest size.
fn largest_difference(found: &Comparison) -> Option<f64> {
    let differences = found.findings.iter().filter_map(|finding| finding.difference);
    differences.max_by(|one, other| one.abs().total_cmp(&other.abs()))
}

/// Why the verdict is not `agrees`, in words; empty when it is.
pub fn reason(found: &Comparison) -> String {
    if let Some(diagnosis) = &found.diagnosis {
        return diagnosis.clone();
    }
    if found.verdict == Agreement::Agrees {
        return String::new();
    }
    let counts = |finding: &&Finding| finding.verdict == found.verdict;
    let mut reasons: Vec<String> = Vec::new();
    for finding in found.findings.iter().filter(counts) {
        let why = if finding.why.is_empty() { "differs" } else { &finding.why };
        let reason = format!("{}: {why}", finding.observable.words());
        if !reasons.contains(&reason) {
            reasons.push(reason);
        }
    }
    reasons.join("; ")
}
