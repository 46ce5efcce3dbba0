//! A table of peak velocities over the velocity of the load point, perhaps with their errors and normal stresses.

use crate::csv::name::{Unit, Wanted};
use crate::csv::rows::RowReader;
use crate::csv::samples::{SampleCells, Samples, number};
use crate::fitting::{PeakFailure, PeakRow};
use crate::scene::{CsvProblem, Fault, Faults, Problem, Quantity};

/// Index of the peak velocity among the columns.
const PEAK: usize = 1;
/// What a column of other errors would need.
const NEEDS_FOR_ERRORS: &str = "no errors: remove it; the errors of peak_velocity_m_per_s alone are read";
/// The least V_peak/V_l: V_peak is at least 4 V_18 where the law holds, and V_l at most a tenth of V_18.
const LEAST_PEAK: f64 = 10.0;
/// The most rows: a fit takes a time in proportion to them.
const MOST_ROWS: usize = 500;

/// A table as it was read.
pub struct PeakTable {
    /// Its rows.
    pub rows: Vec<PeakRow>,
    /// The normal stress of the first row, Pa.
    pub normal_stress_pa: Option<f64>,
    /// Whether it has errors of the peaks.
    pub has_errors: bool,
    /// The columns that are not read.
    pub unread: Vec<String>,
}

/// Reads a table; `normal_stress_pa` is that of a table without a column of it.
///
/// # Errors
/// Every fault of the file, up to twenty.
pub fn read_peak_table(reader: RowReader, normal_stress_pa: Option<f64>) -> Result<PeakTable, Faults> {
    let file = reader.name().to_string();
    let samples = Samples {
        columns: [
            Wanted::quantity(Quantity::LoadingVelocity, false),
            Wanted { key: "peak_velocity_m_per_s", symbols: &["v_peak"], is_optional: false },
            Wanted::quantity(Quantity::NormalStress, true),
        ],
        physical: &[0, PEAK, 2],
        needs_for_errors: None,
        most: MOST_ROWS,
    };
    let mut table = PeakTable { rows: Vec::new(), normal_stress_pa, has_errors: false, unread: Vec::new() };
    let mut of_rows = Faults::new();
    let mut faults = samples.read(reader, |cells, values| {
        match table.row(cells, values) {
            Ok(row) => table.rows.push(row),
            Err((position, problem)) => of_rows.push(cells.fault(position, problem)),
        }
        false
    })?;
    faults.extend(of_rows);
    if faults.is_empty() && table.rows.is_empty() {
        let problem = CsvProblem::Record(PeakFailure::TooFewRows(0).to_string());
        faults.push(Fault::of(&file, "", problem));
    }
    if faults.is_empty() { Ok(table) } else { Err(faults) }
}

impl PeakTable {
    /// A row, or where it is at fault.
    fn row(
        &mut self,
        cells: SampleCells<'_, 3>,
        values: [Option<f64>; 3],
    ) -> Result<PeakRow, (Option<usize>, Problem)> {
        let header = cells.header;
        let record = |reason: &str| CsvProblem::Record(reason.into()).into();
        if self.rows.is_empty() {
            self.unread = header.unread().map(str::to_string).collect();
            self.has_errors = header.error_place(PEAK).is_some();
            if let Some((position, _)) = header.error_place(0).or(header.error_place(2)) {
                return Err((Some(*position), Problem::Needs(NEEDS_FOR_ERRORS.into())));
            }
            if let (Some(position), Some(_)) = (header.positions[2], self.normal_stress_pa) {
                let reason = "--normal-stress-pa is given, too (wanted: one of the two)";
                return Err((Some(position), record(reason)));
            }
            self.normal_stress_pa = self.normal_stress_pa.or(values[2]);
        }
        for (value, position) in values.into_iter().zip(header.positions) {
            if value.is_some_and(|value| value <= 0.0) {
                return Err((position, Problem::NotPositive { allowed: "a positive number".into() }));
            }
        }
        let [Some(load_m_per_s), Some(peak_m_per_s), stress] = values else {
            return Err((None, record("a cell is missing")));
        };
        if peak_m_per_s < LEAST_PEAK * load_m_per_s {
            let reason = format!(
                "the peak velocity is {:.3} times the load velocity (wanted: at least {LEAST_PEAK}, deep stick-slip)",
                peak_m_per_s / load_m_per_s
            );
            return Err((header.positions[PEAK], CsvProblem::Record(reason).into()));
        }
        let stress = stress.zip(self.normal_stress_pa).map_or(1.0, |(stress, first)| stress / first);
        let error = header.error_place(PEAK).map(|(position, unit)| {
            let cell = cells.row.cell(*position);
            let relative = match unit {
                Unit::Share(whole) => number(cell, true, None).map(|error| error / f64::from(*whole)),
                Unit::Size(size) => number(cell, true, Some(size)).map(|error| error / peak_m_per_s),
                _ => number(cell, true, header.unit(PEAK)).map(|error| error / peak_m_per_s),
            };
            let at_fault = |problem: Problem| (Some(*position), problem);
            match relative.map_err(at_fault)? {
                error if error > 0.0 && error < 1.0 => Ok(error),
                _ => Err(at_fault(record("an error is above 0 and below its value"))),
            }
        });
        let relative_error = error.transpose()?.unwrap_or(1.0);
        Ok(PeakRow { load_m_per_s, peak_m_per_s, relative_error, stress })
    }
}
