//! Tables column by column: each column says which cell it takes from a row's value.

use super::{Cell, Column, Table};

/// A table whose columns are being filled from the values of its rows.
#[derive(Debug)]
pub struct TableRows<R> {
    values: Vec<R>,
    table: Table,
}

impl Table {
    /// A table with one row per value; its columns follow.
    ///
    /// ```
    /// use slipmode_plot::table::Table;
    ///
    /// let table = Table::of("squares", "Squares", [1u64, 2])
    ///     .text("parity", "Parity", |n| if n % 2 == 0 { "even" } else { "odd" })
    ///     .number("square", "n²", "", |n| n * n);
    /// assert_eq!(table.table().to_csv(), "parity,square\nodd,1\neven,4\n");
    /// ```
    #[must_use]
    pub fn of<R: Copy>(id: &str, title: &str, values: impl IntoIterator<Item = R>) -> TableRows<R> {
        let values: Vec<R> = values.into_iter().collect();
        let rows = vec![Vec::new(); values.len()];
        TableRows { values, table: Self { rows, ..Self::new(id, title, Vec::new()) } }
    }
}

impl<R: Copy> TableRows<R> {
    /// The same with a Markdown note below the table.
    #[must_use]
    pub fn note(mut self, note: &str) -> Self {
        self.table.note = note.into();
        self
    }

    /// The same table, whose columns up to here name a row.
    #[must_use]
    pub fn named(mut self) -> Self {
        self.table.names = self.table.columns.len();
        self
    }

    /// The same with one more column of words.
    #[must_use]
    pub fn text<C: Into<Cell>>(self, name: &str, header: &str, cell: impl Fn(R) -> C) -> Self {
        self.column(Column::text(name, header), &|value| cell(value).into())
    }

    /// The same with one more column of numbers with a unit (empty when the numbers are pure).
    #[must_use]
    pub fn number<C: Into<Cell>>(self, name: &str, header: &str, unit: &str, cell: impl Fn(R) -> C) -> Self {
        self.column(Column::number(name, header, unit), &|value| cell(value).into())
    }

    /// One more column. It is compiled once for each kind of row, and not once for each column.
    fn column(self, column: Column, cell: &dyn Fn(R) -> Cell) -> Self {
        self.columns([column], |value| [cell(value)])
    }

    /// The same with several more columns, whose cells come together.
    ///
    /// # Panics
    /// When there is not one cell per column: an error of the program, never of its input.
    #[must_use]
    pub fn columns<C: IntoIterator<Item = Cell>>(
        mut self,
        columns: impl IntoIterator<Item = Column>,
        cells: impl Fn(R) -> C,
    ) -> Self {
        self.table.columns.extend(columns);
        for (row, &value) in self.table.rows.iter_mut().zip(&self.values) {
            row.extend(cells(value));
            assert_eq!(row.len(), self.table.columns.len(), "table {}: one cell per column", self.table.id);
        }
        self
    }

    /// The table, with or without rows.
    #[must_use]
    pub fn table(self) -> Table {
        self.table
    }
}

macro_rules! cells {
    ($($value:ty => $kind:ident),+) => {$(
        impl From<$value> for Cell {
            fn from(value: $value) -> Self {
                Self::$kind(value.to_string())
            }
        }
    )+};
}

cells!(&str => text, &String => text, String => text, u64 => number, usize => number, u32 => number);

impl From<bool> for Cell {
    fn from(is: bool) -> Self {
        Self::text(if is { "yes" } else { "no" })
    }
}

/// Nothing is an empty cell.
impl<C: Into<Self>> From<Option<C>> for Cell {
    fn from(found: Option<C>) -> Self {
        found.map_or_else(Self::empty, Into::into)
    }
}
