//! How the CSV files that a command reads are written.

use clap::Args;
use slipmode::csv::Dialect;

use crate::cli::options::Arguments;

/// The separators of columns, as words.
const DELIMITERS: [(&str, u8); 4] = [(",", b','), (";", b';'), ("|", b'|'), ("tab", b'\t')];

/// What separates columns, and what stands in decimals.
#[derive(Debug, Args)]
pub struct DialectOptions {
    /// What separates the columns of the CSV files that are read [default: ,]
    #[arg(long, value_name = "C", value_parser = DELIMITERS.map(|(word, _)| word))]
    pub delimiter: Option<String>,
    /// What stands in the decimals of the CSV files that are read [default: .]
    ///
    /// With a comma, a cell that is a number gets a point in its place, and a number with a point is refused: it may separate
    /// thousands. What is written has commas between columns and points in decimals.
    #[arg(long, value_name = "C", value_parser = [".", ","])]
    pub decimal: Option<String>,
}

impl DialectOptions {
    /// How the files are written.
    pub fn dialect(&self) -> Dialect {
        let given = DELIMITERS.iter().find(|(word, _)| self.delimiter.as_deref() == Some(*word));
        Dialect {
            delimiter: given.map_or(b',', |(_, delimiter)| *delimiter),
            has_decimal_commas: self.decimal.as_deref() == Some(","),
        }
    }

    /// Notes the options where no file is read.
    pub fn refuse(&self, arguments: &mut Arguments, needs: &str) {
        arguments.refuse_value("--delimiter", self.delimiter.as_deref(), needs);
        arguments.refuse_value("--decimal", self.decimal.as_deref(), needs);
    }
}
