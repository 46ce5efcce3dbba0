//! The rows of the files of times, as they are read.

use super::sheet::{SheetRow, rows};
use crate::least_squares::Form;
use slipmode::scene::Faults;

/// One method on one piece of work, measured by `cargo xtask bench --peers`.
#[derive(Debug, Clone, PartialEq)]
pub struct PeerRow {
    /// Its line in the file, counted from 1.
    pub line: usize,
    /// The work, with what it was done on.
    pub work: String,
    /// How it was done; ours begin with `slipmode`.
    pub method: String,
    /// The tolerance requested, where the method has one.
    pub tolerance: Option<f64>,
    /// How many items were done.
    pub items: f64,
    /// CPU seconds for all items.
    pub seconds: f64,
    /// The worst error as printed, may be empty; below the range of 64 bits at many digits.
    pub error: String,
    /// Wrong answers and failures.
    pub wrong: u64,
    /// The program, with its version.
    pub program: String,
    /// The settings that matter.
    pub options: String,
    /// The command that prints the row.
    pub command: String,
}

/// One command of one size, measured by `cargo xtask cost`.
#[derive(Debug, Clone, PartialEq)]
pub struct CostRow {
    /// Its line in the file, counted from 1.
    pub line: usize,
    /// What grows.
    pub series: String,
    /// What its size counts.
    pub variable: String,
    /// The size.
    pub size: f64,
    /// CPU seconds.
    pub cpu_s: f64,
    /// Peak memory, KiB.
    pub peak_memory_kib: f64,
    /// The form of the law that is expected, if any.
    pub form: Option<Form>,
    /// A size whose cost is extrapolated and not measured.
    pub requested: Option<f64>,
    /// The command.
    pub command: String,
}

/// One fact about a measurement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MachineRow {
    /// Which file it is about.
    pub file: String,
    /// What is stated: `date`, `processor`, `cores`, `compiler`, or a program whose version follows.
    pub key: String,
    /// The value.
    pub value: String,
}

impl PeerRow {
    /// CPU seconds of one item.
    #[must_use]
    pub fn seconds_per_item(&self) -> f64 {
        self.seconds / self.items
    }

    /// The error as a number, where there is one; what is below the range of 64 bits is 0.
    #[must_use]
    pub fn error_value(&self) -> Option<f64> {
        self.error.parse().ok()
    }

    /// Whether slipmode did it.
    #[must_use]
    pub fn is_ours(&self) -> bool {
        self.method.starts_with("slipmode")
    }

    fn read(row: &SheetRow<'_>) -> Result<Self, Faults> {
        Ok(Self {
            line: row.line,
            work: row.text(0),
            method: row.text(1),
            tolerance: row.optional(2, SheetRow::positive)?,
            items: row.positive(3)?,
            seconds: row.positive(4)?,
            error: row.text(5),
            wrong: row.whole(6)?,
            program: row.text(7),
            options: row.text(8),
            command: row.text(9),
        })
    }
}

/// Reads what `cargo xtask bench --peers` wrote.
///
/// # Errors
/// Every fault of the header, or the first of a row.
pub fn read_peers(file: &str, text: &str) -> Result<Vec<PeerRow>, Faults> {
    const COLUMNS: [&str; 10] =
        ["work", "method", "tolerance", "items", "cpu_s", "error", "wrong", "program", "options", "command"];
    rows(file, text, &COLUMNS)?.iter().map(PeerRow::read).collect()
}

/// Reads what `cargo xtask cost` wrote.
///
/// # Errors
/// Those of [`read_peers`].
pub fn read_cost(file: &str, text: &str) -> Result<Vec<CostRow>, Faults> {
    const COLUMNS: [&str; 8] =
        ["series", "variable", "size", "cpu_s", "peak_memory_kib", "form", "asked", "command"];
    let read = |row: &SheetRow<'_>| {
        Ok(CostRow {
            line: row.line,
            series: row.text(0),
            variable: row.text(1),
            size: row.positive(2)?,
            cpu_s: row.at_least_zero(3)?,
            peak_memory_kib: row.at_least_zero(4)?,
            form: row.optional(5, |row, column| {
                Form::read(&row.text(column))
                    .ok_or_else(|| row.fault(column, "`power`, or `beside` and a power"))
            })?,
            requested: row.optional(6, SheetRow::positive)?,
            command: row.text(7),
        })
    };
    rows(file, text, &COLUMNS)?.iter().map(read).collect()
}

/// Reads on which machine, on which day and with which versions the other files were measured.
///
/// # Errors
/// Those of [`read_peers`].
pub fn read_machine(file: &str, text: &str) -> Result<Vec<MachineRow>, Faults> {
    let read = |row: &SheetRow<'_>| MachineRow { file: row.text(0), key: row.text(1), value: row.text(2) };
    Ok(rows(file, text, &["file", "key", "value"])?.iter().map(read).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str =
        "work,method,tolerance,items,cpu_s,error,wrong,steps,evaluations,program,options,command\n";

    #[test]
    fn a_row_keeps_its_line_and_an_error_below_the_range_of_64_bits_is_zero() {
        let rows = read_peers(
            "peers.csv",
            &format!("{HEADER}w,slipmode-x,,4,2e0,1e-400,0,,,p 1,a; b,cargo bench\n"),
        )
        .unwrap();
        assert_eq!((rows[0].line, rows[0].seconds_per_item(), rows[0].error_value()), (2, 0.5, Some(0.0)));
        assert_eq!((rows[0].program.as_str(), rows[0].options.as_str()), ("p 1", "a; b"));
        assert!(rows[0].is_ours() && rows[0].tolerance.is_none());
    }

    #[test]
    fn a_cell_that_is_no_number_is_named_with_its_line_and_column() {
        for (row, named) in [
            ("w,m,,0,1,,0,,,p,o,c", "2: items = 0"),
            ("w,m,,1,nan,,0,,,p,o,c", "2: cpu_s = nan"),
            ("w,m,x,1,1,,0,,,p,o,c", "2: tolerance = x"),
            ("w,m,,1,1,,-1,,,p,o,c", "2: wrong = -1"),
            ("w,m", "2: 2 cells"),
        ] {
            let faults = read_peers("peers.csv", &format!("{HEADER}{row}\n")).unwrap_err();
            assert!(faults[0].to_string().contains(named), "{}", faults[0]);
        }
        assert!(read_peers("peers.csv", "").is_err() && read_peers("peers.csv", "work,method\n").is_err());
    }

    #[test]
    fn a_series_states_its_form_and_the_requested_size() {
        let header = "series,variable,size,wall_s,cpu_s,peak_memory_kib,form,asked,command\n";
        let rows = read_cost("cost.csv", &format!("{header}grid,points,1e6,1,0.5,900,beside 0.5,1e9,slipmode x\nt,threads,2,1,1,9,,,slipmode y\n")).unwrap();
        assert_eq!((rows[0].form, rows[0].requested), (Some(Form::Beside(0.5)), Some(1e9)));
        assert_eq!((rows[1].form, rows[1].requested), (None, None));
        assert!(read_cost("cost.csv", &format!("{header}grid,points,1e6,1,0.5,900,cubic,,c\n")).is_err());
    }
}
