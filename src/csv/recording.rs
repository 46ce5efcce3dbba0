//! A trajectory's file: time, velocity and perhaps stress, streamed, with every fault named by line and column.

mod backward;

use crate::comparison::recording::{LEAST_SAMPLES, Recording};
use crate::scene::{AllowedRange, CsvProblem, Fault, Faults, Problem, not_a_number};
use slipmode_core::number::{Dd, Rational, nearest_f64, parse_decimal, parse_decimal_to_dd};

use crate::csv::header::{Beyond, Header};
use crate::csv::row_work::Cells;
use crate::csv::rows::RowReader;
use crate::csv::wanted::Wanted;
use crate::csv::work::cell_problem;
use backward::Backward;

/// The columns; the last one may be missing.
const COLUMNS: [Wanted; 3] = [
    Wanted { key: "time_s", symbols: &[], is_optional: false },
    Wanted { key: "velocity_m_per_s", symbols: &[], is_optional: false },
    Wanted { key: "shear_stress_pa", symbols: &[], is_optional: true },
];
/// What a column of errors would need.
const NEEDS_FOR_ERRORS: &str =
    "no errors: remove it; the column tolerance of the runs states the error of a run";
/// Most samples of a trajectory: 240 MB of numbers.
const MOST_SAMPLES: usize = 10_000_000;
/// Rows read at a time.
const BLOCK_ROWS: usize = 4096;
/// The most faults that are reported of one file.
const MOST_FAULTS: usize = 20;
/// What a cell may be, for messages; a velocity that is not positive is reported with all the others.
const SIGNED: &str = "-1e300 to 1e300";

/// A recording, the lines on which its samples stand, and the rows without a logarithm of the velocity.
#[derive(Default)]
struct Read {
    recording: Recording,
    lines: Vec<usize>,
    backward: Backward,
}

/// Reads a trajectory; gaps are compared with the loading velocity, of which the logarithm is given.
///
/// # Errors
/// Every fault of the file, up to twenty.
pub fn read_recording(mut reader: RowReader, log_level: f64) -> Result<Recording, Faults> {
    let file = reader.name().to_string();
    let first = reader.block(1).map_err(|fault| vec![fault])?;
    let beyond = Beyond { appended: &[], needs_for_errors: Some(NEEDS_FOR_ERRORS), reads: &|_| false };
    let header = Header::of_columns(&file, first.rows().next(), COLUMNS, &beyond, |_| Vec::new())?;
    let mut read = Read::default();
    let mut faults = Faults::new();
    loop {
        let block = reader.block(BLOCK_ROWS).map_err(|fault| vec![fault])?;
        if block.is_empty() || faults.len() >= MOST_FAULTS {
            break;
        }
        for row in block.rows() {
            if let Err(found) = read.sample(Cells { file: &file, header: &header, row }) {
                faults.extend(found);
            }
        }
        if read.lines.len() > MOST_SAMPLES {
            faults.push(fault(&file, None, "", CsvProblem::TooManyRows(MOST_SAMPLES).into()));
            break;
        }
    }
    faults.truncate(MOST_FAULTS);
    faults.extend(read.backward.fault(&file, read.lines.len(), log_level));
    if faults.is_empty() {
        faults.extend(read.fault_of_the_whole(&file, log_level));
    }
    if faults.is_empty() { Ok(read.recording) } else { Err(faults) }
}

fn fault(file: &str, line: Option<usize>, key: &str, problem: Problem) -> Fault {
    Fault { file: file.into(), line, key: key.into(), value: None, problem }
}

impl Read {
    fn sample(&mut self, cells: Cells<'_, [Option<usize>; 3]>) -> Result<(), Faults> {
        cells.check_count()?;
        let (row, positions) = (cells.row, cells.header.positions);
        let mut faults = Faults::new();
        let mut values = [None; 3];
        for (index, position) in positions.into_iter().enumerate() {
            let Some(position) = position else { continue };
            match number(row.cell(position), index == 1, cells.header.unit(index)) {
                Ok(value) => values[index] = Some(value),
                Err(problem) => faults.push(cells.fault(Some(position), problem)),
            }
        }
        if let (Some(time), Some(last)) = (values[0], self.recording.times_s.last())
            && time <= *last
        {
            let allowed = format!("more than {last:e}, the time of the row before");
            faults.push(cells.fault(positions[0], CsvProblem::NotIncreasing { allowed }.into()));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        if let [Some(time), Some(velocity), stress] = values {
            if velocity <= 0.0 {
                self.backward.note(velocity, row.number, row.line);
                return Ok(());
            }
            self.recording.times_s.push(time);
            self.recording.log_velocities.push(libm::log(velocity));
            self.recording.stresses_pa.extend(stress);
            self.lines.push(row.line);
        }
        Ok(())
    }

    fn fault_of_the_whole(&self, file: &str, log_level: f64) -> Option<Fault> {
        let found = self.lines.len();
        if found < LEAST_SAMPLES {
            let problem = CsvProblem::TooFewSamples { found, wanted: LEAST_SAMPLES };
            return Some(fault(file, None, "", problem.into()));
        }
        let gap = self.recording.gap(log_level)?;
        let (step, usual) = (format!("{:.4e}", gap.step_s), format!("{:.4e}", gap.usual_s));
        let what = if gap.is_return { "oscillation" } else { "step" };
        let line = self.lines.get(gap.sample).copied();
        Some(fault(file, line, "column time_s", CsvProblem::Gap { step, usual, what }.into()))
    }
}

/// A cell as the nearest 64-bit number in SI; its decimal is read exactly first.
fn number(cell: &[u8], is_velocity: bool, unit: Option<&Rational>) -> Result<f64, Problem> {
    if let Some(problem) = cell_problem(cell) {
        return Err(problem);
    }
    let text = std::str::from_utf8(cell).unwrap_or_default();
    if unit.is_none()
        && let Some(value) = parse_decimal_to_dd(text)
        && value.rounds_surely(Dd::UNIT * value.hi())
    {
        return Ok(value.hi());
    }
    let value = parse_decimal(text).map_err(|reason| not_a_number(text, reason, None))?;
    let value = unit.map_or_else(|| value.clone(), |size| Rational::from(&value * size));
    if is_velocity && value > 0 {
        return AllowedRange::PHYSICAL.check(value).map(|value| nearest_f64(&value));
    }
    let limit = parse_decimal("1e300").unwrap_or_default();
    let size = Rational::from(value.abs_ref());
    if size <= limit { Ok(nearest_f64(&value)) } else { Err(Problem::OutOfRange { allowed: SIGNED.into() }) }
}
