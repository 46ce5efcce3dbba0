//! Tables: rows with units in their column names, as CSV for programs and Markdown for people.
//!
//! A cell carries text that is already formatted: the digits that are certain were chosen where the value was
//! computed, so that no writer can add or lose one.
//!
//! ```
//! use slipmode_plot::table::{Column, Table, escape_markdown};
//!
//! let empty = Table::new("empty", "No rows", vec![Column::number("period_s", "Period", "s")]);
//! assert_eq!(empty.to_csv(), "period_s\n");
//! assert!(escape_markdown("a*b").contains('\\'));
//! ```

mod csv_text;
mod escape;
mod markdown;
mod rows;

pub use escape::{escape_cell, escape_html, escape_markdown, printable};
pub use rows::TableRows;

use serde::Serialize;

/// A table as data: what is published as `tables/<id>.csv`, as Markdown and on the page.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Table {
    /// Name of the file and of the deep link, `[A-Za-z0-9._-]{1,100}`.
    pub id: String,
    /// One line that says what the rows are.
    pub title: String,
    /// Markdown below the table: how the numbers came about, what is left out. May be empty.
    pub note: String,
    /// Columns from left to right.
    pub columns: Vec<Column>,
    /// Rows from top to bottom; every row has as many cells as there are columns.
    pub rows: Vec<Vec<Cell>>,
    /// How many of the first columns name a row: what they hold is given, not computed.
    #[serde(skip)]
    pub names: usize,
}

/// A column: its name for programs and its header for people.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Column {
    /// CSV header with the unit in the name, such as `normal_stress_pa`.
    pub name: String,
    /// Header for people, such as `Normal stress σ`.
    pub header: String,
    /// Unit as people write it, such as `Pa`; empty for text and for pure numbers.
    pub unit: String,
    /// Whether the column is set flush right as numbers.
    pub kind: Kind,
}

/// What a column or a cell holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Words.
    Text,
    /// A number, printed with the digits that are certain.
    Number,
}

/// One cell: formatted text and what it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Cell {
    /// The text as it is shown; empty when there is nothing to say.
    pub text: String,
    /// Number or words; decides alignment and CSV quoting.
    pub kind: Kind,
    /// The significant digits that a number was rounded to, where it was.
    #[serde(skip)]
    pub digits: Option<u32>,
    /// Whether every digit shown is certain.
    #[serde(skip)]
    pub is_certain: bool,
}

impl Table {
    /// An empty table with its columns.
    #[must_use]
    pub fn new(id: &str, title: &str, columns: Vec<Column>) -> Self {
        Self { id: id.into(), title: title.into(), note: String::new(), columns, rows: Vec::new(), names: 0 }
    }

    /// The same table with a Markdown note below it.
    #[must_use]
    pub fn with_note(mut self, note: &str) -> Self {
        self.note = note.into();
        self
    }

    /// Appends a row.
    ///
    /// # Panics
    /// When the row has not one cell per column: an error of the program, never of its input.
    pub fn push(&mut self, row: Vec<Cell>) {
        assert_eq!(row.len(), self.columns.len(), "table {}: one cell per column", self.id);
        self.rows.push(row);
    }
}

impl Column {
    /// A column of numbers with a unit (empty when the numbers are pure).
    #[must_use]
    pub fn number(name: &str, header: &str, unit: &str) -> Self {
        Self { name: name.into(), header: header.into(), unit: unit.into(), kind: Kind::Number }
    }

    /// A column of words.
    #[must_use]
    pub fn text(name: &str, header: &str) -> Self {
        Self { name: name.into(), header: header.into(), unit: String::new(), kind: Kind::Text }
    }

    /// Header with unit for people: `Normal stress σ (Pa)`.
    pub(crate) fn heading(&self) -> String {
        if self.unit.is_empty() { self.header.clone() } else { format!("{} ({})", self.header, self.unit) }
    }
}

impl Cell {
    /// A number that was formatted where it was computed.
    #[must_use]
    pub fn number(text: impl Into<String>) -> Self {
        Self { text: text.into(), kind: Kind::Number, digits: None, is_certain: false }
    }

    /// A number that was rounded to some significant digits.
    #[must_use]
    pub fn rounded(text: impl Into<String>, digits: usize) -> Self {
        Self { digits: u32::try_from(digits).ok(), ..Self::number(text) }
    }

    /// The same with digits that are all certain.
    #[must_use]
    pub fn certain(self) -> Self {
        Self { is_certain: true, ..self }
    }

    /// Words.
    #[must_use]
    pub fn text(text: impl Into<String>) -> Self {
        Self { text: text.into(), kind: Kind::Text, digits: None, is_certain: false }
    }

    /// Nothing to say here.
    #[must_use]
    pub fn empty() -> Self {
        Self::text("")
    }
}
