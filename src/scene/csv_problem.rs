//! What can be wrong with a CSV file beyond its numbers.

use thiserror::Error;

/// A fault of a CSV header or row.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum CsvProblem {
    /// No header line, and the columns that must be there.
    #[error("empty file (wanted: a header line with the columns {0})")]
    NoHeader(String),
    /// A column that must be there and is not.
    #[error(
        "missing column{} (allowed: {allowed})",
        .nearest.as_ref().map(|near| format!("; did you mean it by `{near}`?")).unwrap_or_default()
    )]
    MissingColumn {
        /// The names that the column may have.
        allowed: String,
        /// The column of the file with the most similar name, when one is similar.
        nearest: Option<String>,
    },
    /// A column named like a quantity, in another unit; its name in SI.
    #[error("unknown unit (allowed: `{0}`, in SI)")]
    UnknownUnit(&'static str),
    /// A column named like a quantity, in no unit or one of another dimension.
    #[error("{reason} (allowed: {allowed})")]
    Unit {
        /// Why.
        reason: String,
        /// The names that the column may have.
        allowed: String,
    },
    /// A quantity in two columns.
    #[error("`{first}` gives {wanted} too; keep one of them")]
    SecondColumn {
        /// The column's name that stands first.
        first: String,
        /// The quantity, or its error.
        wanted: String,
    },
    /// A name that can be understood in two ways.
    #[error("may be {readings} (allowed: {allowed})")]
    Ambiguous {
        /// What it may be.
        readings: String,
        /// Names that are not ambiguous.
        allowed: String,
    },
    /// A name that says "error" and of which the rest is not understood; one that is.
    #[error("looks like an error and is not understood (allowed: a name such as {0}); rename or remove it")]
    UnknownError(String),
    /// A header of one cell that has another separator.
    #[error(
        "columns are separated by {found} (classify, simulate, solve, compare and fit: {option}; decimal commas: add --decimal ,)"
    )]
    OtherSeparator {
        /// The separators' name.
        found: &'static str,
        /// What reads them.
        option: &'static str,
    },
    /// A point in a number of a file whose decimals have commas.
    #[error("a decimal point, where --decimal says that decimals have commas")]
    DecimalPoint,
    /// A column for the second time; the position of the first column of that name, counted from 1.
    #[error("doubled column (column {0} has the same name)")]
    DoubledColumn(usize),
    /// A column that the output appends.
    #[error("a column of the output; remove or rename it")]
    OutputColumn,
    /// A row that is not the one that a scene's grid has there, in words.
    #[error("{0}")]
    OffGrid(String),
    /// A record that cannot be fitted, in words.
    #[error("{0}")]
    Record(String),
    /// A row with fewer or more cells than the header.
    #[error("{found} cells, where the header has {wanted}{}", if .found > .wanted { " (do decimals have commas? then put them between quotation marks, or separate columns by semicolons, and add --decimal ,)" } else { "" })]
    CellCount {
        /// The row's cells.
        found: usize,
        /// The header's cells.
        wanted: usize,
    },
    /// More columns than allowed.
    #[error("more than {0} cells in a row")]
    TooManyCells(usize),
    /// A cell longer than allowed.
    #[error("a cell of {bytes} bytes (allowed: at most {limit})")]
    CellTooLong {
        /// The cell's bytes.
        bytes: usize,
        /// The cap.
        limit: usize,
    },
    /// A row longer than allowed: as a rule a quotation mark that is never closed.
    #[error("a row of more than {0} bytes (is a quotation mark not closed?)")]
    RowTooLong(usize),
    /// More rows than can be held.
    #[error("more than {0} rows")]
    TooManyRows(usize),
    /// A time that is not later than the one before; what may stand there.
    #[error("time does not increase (allowed: {0})")]
    NotIncreasing(String),
    /// A trajectory too short to show anything.
    #[error("{found} samples (allowed: at least {wanted})")]
    TooFewSamples {
        /// The samples that there are.
        found: usize,
        /// The fewest that say anything.
        wanted: usize,
    },
    /// Velocities of a trajectory without a logarithm.
    #[error(
        "{count} of {of} velocities are zero or negative (rows: {rows}; least: {least} m/s), and the friction law needs ln V; {reading}"
    )]
    NotForward {
        /// How many.
        count: usize,
        /// How many velocities there are.
        of: usize,
        /// Their rows.
        rows: String,
        /// The least of them, m/s.
        least: String,
        /// What they probably are, and what to do.
        reading: &'static str,
    },
    /// A stretch of time without samples.
    #[error("a gap of {step} s before this row, where the usual {what} takes {usual} s")]
    Gap {
        /// The length of the gap, s.
        step: String,
        /// What it is compared with, s.
        usual: String,
        /// A `step` or an `oscillation`.
        what: &'static str,
    },
    /// The file ends inside a quoted cell.
    #[error("the file ends inside a quoted cell")]
    UnclosedQuote,
}
