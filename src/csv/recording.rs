//! A trajectory's file: time, velocity and perhaps stress.

mod backward;

use crate::comparison::recording::{LEAST_SAMPLES, Recording};
use crate::scene::{CsvProblem, Fault, Faults};

use crate::csv::name::Wanted;
use crate::csv::rows::RowReader;
use crate::csv::samples::Samples;
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
/// What a stress of the wrong sign is.
const REVERSED: &str = "the stress falls below V0 and rises above it, so the sign convention seems reversed: multiply the column by -1";
/// Most samples of a trajectory: 240 MB of numbers.
const MOST_SAMPLES: usize = 10_000_000;

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
pub fn read_recording(reader: RowReader, log_level: f64) -> Result<Recording, Faults> {
    let file = reader.name().to_string();
    let mut read = Read::default();
    // A velocity that is not positive is reported with all the others.
    let samples = Samples {
        columns: COLUMNS,
        physical: &[1],
        needs_for_errors: Some(NEEDS_FOR_ERRORS),
        most: MOST_SAMPLES,
    };
    let mut faults = samples.read(reader, |cells, values| {
        if let [Some(time), Some(velocity), stress] = values {
            if velocity <= 0.0 {
                read.backward.note(velocity, cells.row.number, cells.row.line);
                return false;
            }
            read.recording.times_s.push(time);
            read.recording.log_velocities.push(libm::log(velocity));
            read.recording.stresses_pa.extend(stress);
            read.lines.push(cells.row.line);
        }
        true
    })?;
    faults.extend(read.backward.fault(&file, read.lines.len(), log_level));
    if faults.is_empty() {
        faults.extend(read.fault_of_the_whole(&file, log_level));
    }
    if faults.is_empty() { Ok(read.recording) } else { Err(faults) }
}

impl Read {
    fn fault_of_the_whole(&self, file: &str, log_level: f64) -> Option<Fault> {
        let found = self.lines.len();
        if found < LEAST_SAMPLES {
            let problem = CsvProblem::TooFewSamples { found, wanted: LEAST_SAMPLES };
            return Some(Fault::of(file, "", problem));
        }
        if self.recording.has_reversed_stress(log_level) {
            let problem = CsvProblem::Record(REVERSED.into());
            return Some(Fault::of(file, "column shear_stress_pa", problem));
        }
        let gap = self.recording.gap(log_level)?;
        let (step, usual) = (format!("{:.4e}", gap.step_s), format!("{:.4e}", gap.usual_s));
        let what = if gap.is_return { "oscillation" } else { "step" };
        let line = self.lines.get(gap.sample).copied();
        Some(Fault::of(file, "column time_s", CsvProblem::Gap { step, usual, what }).at(line))
    }
}
