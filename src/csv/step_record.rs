//! A record of velocity steps: time, displacement or velocity of the load point, shear stress or friction, and perhaps normal stress.

use slipmode_core::number::nearest_f64;

use crate::csv::name::Wanted;
use crate::csv::rows::RowReader;
use crate::csv::samples::{SampleCells, Samples};
use crate::fitting::{Column, Load, Measured, RecordFault, Response, StepRecord};
use crate::scene::{CsvProblem, Fault, Faults};

const TIME: Wanted = Wanted { key: "time_s", symbols: &["t"], is_optional: false };
const DISPLACEMENT: Wanted = optional("load_point_displacement_m");
const VELOCITY: Wanted = optional("load_point_velocity_m_per_s");
const SHEAR_STRESS: Wanted = optional("shear_stress_pa");
const FRICTION: Wanted = optional("friction");
const NORMAL_STRESS: Wanted = optional("normal_stress_pa");
/// What a column of errors would need.
const NEEDS_FOR_ERRORS: &str = "no errors: remove it; the noise is estimated from the record";
/// Most samples of a record: means over neighbours keep what longer ones tell.
const MOST_SAMPLES: usize = 200_000;

const fn optional(key: &'static str) -> Wanted {
    Wanted { key, symbols: &[], is_optional: true }
}

/// The columns as they are read.
#[derive(Default)]
struct Read {
    times_s: Vec<f64>,
    displacements_m: Vec<f64>,
    velocities_m_per_s: Vec<f64>,
    stresses_pa: Vec<f64>,
    frictions: Vec<f64>,
    normal_stresses_pa: Vec<f64>,
    /// Sizes of the last written digits of displacements.
    last_digits_m: Vec<f64>,
    lines: Vec<usize>,
}

/// Reads a record, and names the columns that are not read; `normal_stress_pa` is that of a record without a column of it.
///
/// # Errors
/// Every fault of the file, up to twenty, or all that keeps the record from being fitted.
pub fn read_step_record(
    reader: RowReader,
    normal_stress_pa: Option<f64>,
) -> Result<(StepRecord, Vec<String>), Faults> {
    let file = reader.name().to_string();
    let mut read = Read::default();
    let samples = Samples {
        columns: [TIME, DISPLACEMENT, VELOCITY, SHEAR_STRESS, FRICTION, NORMAL_STRESS],
        physical: &[5],
        needs_for_errors: Some(NEEDS_FOR_ERRORS),
        most: MOST_SAMPLES,
    };
    let (mut columns, mut unread) = (None, Vec::new());
    let faults = samples.read(reader, |cells, values| {
        if columns.is_none() {
            columns = Some(cells.header.positions.map(|position| position.is_some()));
            unread = cells.header.unread().map(str::to_string).collect();
        }
        read.push(cells, values);
        true
    })?;
    if !faults.is_empty() {
        return Err(faults);
    }
    let whole = |key: &str, reason: String| Fault::of(&file, key, CsvProblem::Record(reason));
    let problems = column_problems(columns.unwrap_or_default(), normal_stress_pa.is_some());
    if read.lines.is_empty() {
        return Err(vec![whole("", "no rows below the header".into())]);
    }
    if !problems.is_empty() {
        return Err(problems.into_iter().map(|(key, reason)| whole(key, reason)).collect());
    }
    let lines = read.lines.clone();
    let record = read.record(normal_stress_pa);
    record.map(|record| (record, unread)).map_err(|found| {
        let line = |sample: Option<usize>| sample.and_then(|sample| lines.get(sample)).copied();
        let named = |RecordFault { sample, column, reason }| {
            let column =
                column.map(|column| format!("column {}", name_of(column, columns.unwrap_or_default())));
            let row = sample.map(|sample| format!("row {}", sample + 1));
            let key = row.into_iter().chain(column).collect::<Vec<_>>().join(", ");
            Fault::of(&file, &key, CsvProblem::Record(reason)).at(line(sample))
        };
        found.into_iter().map(named).collect()
    })
}

/// What is wrong with the choice of columns.
fn column_problems(
    [_, displacement, velocity, stress, friction, normal]: [bool; 6],
    has_normal_stress: bool,
) -> Vec<(&'static str, String)> {
    let one_of = |[one, other]: [(&'static str, bool); 2]| match (one.1, other.1) {
        (true, true) => Some((other.0, format!("{} is there, too (wanted: one of the two)", one.0))),
        (false, false) => Some((one.0, format!("missing column (wanted: {} or {})", one.0, other.0))),
        _ => None,
    };
    let mut problems = Vec::new();
    problems.extend(one_of([(DISPLACEMENT.key, displacement), (VELOCITY.key, velocity)]));
    problems.extend(one_of([(SHEAR_STRESS.key, stress), (FRICTION.key, friction)]));
    match (normal, has_normal_stress) {
        (true, true) => problems
            .push((NORMAL_STRESS.key, "--normal-stress-pa is given, too (wanted: one of the two)".into())),
        (false, false) => problems
            .push((NORMAL_STRESS.key, "missing column (wanted: this column, or --normal-stress-pa)".into())),
        _ => {}
    }
    problems
}

/// The name of the column that has what was measured.
fn name_of(column: Column, [_, displacement, _, stress, ..]: [bool; 6]) -> &'static str {
    match column {
        Column::Time => TIME.key,
        Column::Load if displacement => DISPLACEMENT.key,
        Column::Load => VELOCITY.key,
        Column::Response if stress => SHEAR_STRESS.key,
        Column::Response => FRICTION.key,
        Column::NormalStress => NORMAL_STRESS.key,
    }
}

impl Read {
    fn push(&mut self, cells: SampleCells<'_, 6>, values: [Option<f64>; 6]) {
        let [time, displacement, velocity, stress, friction, normal] = values;
        self.lines.push(cells.row.line);
        self.times_s.extend(time);
        self.displacements_m.extend(displacement);
        self.velocities_m_per_s.extend(velocity);
        self.stresses_pa.extend(stress);
        self.frictions.extend(friction);
        self.normal_stresses_pa.extend(normal);
        if let Some(position) = cells.header.positions[1] {
            let unit = cells.header.unit(1).map_or(1.0, nearest_f64);
            self.last_digits_m.push(unit * last_digit(cells.row.cell(position)));
        }
    }

    fn record(mut self, normal_stress_pa: Option<f64>) -> Result<StepRecord, Vec<RecordFault>> {
        if let Some(stress) = normal_stress_pa {
            self.normal_stresses_pa = vec![stress; self.times_s.len()];
        }
        if let Some(sample) = self.normal_stresses_pa.iter().position(|stress| *stress <= 0.0) {
            let reason = "the normal stress is not positive (wanted: compression is positive)".into();
            let (sample, column) = (Some(sample), Some(Column::NormalStress));
            return Err(vec![RecordFault { sample, column, reason }]);
        }
        let response = match self.stresses_pa.is_empty() {
            true => Response::Friction(self.frictions),
            false => Response::ShearStress(self.stresses_pa),
        };
        let load = match self.velocities_m_per_s.is_empty() {
            true => Load::Displacement(self.displacements_m, upper_quartile(self.last_digits_m)),
            false => Load::Velocity(self.velocities_m_per_s),
        };
        let Self { times_s, normal_stresses_pa, .. } = self;
        StepRecord::new(Measured { times_s, load, response, normal_stresses_pa })
    }
}

/// The size of the last digit of a decimal as it is written.
fn last_digit(cell: &[u8]) -> f64 {
    let text = std::str::from_utf8(cell).unwrap_or_default().trim();
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let digits = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let exponent: f64 = exponent.parse().unwrap_or(0.0);
    libm::pow(10.0, exponent - digits as f64)
}

/// Three in four values are not larger: some decimals end in zeros that are not written.
fn upper_quartile(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(3 * values.len() / 4).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_digit_is_as_written() {
        for (cell, wanted) in [("1.25e-3", 1e-5), ("12", 1.0), ("0.0010", 1e-4), ("-3.5E+2", 10.0)] {
            assert!((last_digit(cell.as_bytes()) / wanted - 1.0).abs() < 1e-12, "{cell}");
        }
    }
}
