//! Which tables there are: `tables.toml` has their words, and an experiment fills each.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::experiments::figures::list_in;
use crate::experiments::shared::cells::Digits;
use crate::experiments::{Context, Need};
use crate::scene::cited;
use slipmode_plot::table::{Cell, Column, Table, TableRows};

/// How a table is made.
#[derive(Debug)]
pub struct TableMaker {
    /// The table's id.
    pub id: &'static str,
    /// What must have been computed.
    pub needs: &'static [Need],
    /// Fills it; `None` or no rows when the scenes do not hold what it lists.
    pub make: fn(&Context) -> Option<Table>,
}

impl TableMaker {
    /// The table, unless it has no rows.
    pub(crate) fn table(&self, context: &Context) -> Option<Table> {
        let table = (self.make)(context).filter(|table| !table.rows.is_empty())?;
        let columns = table.columns.into_iter().map(|one| Column { header: cited(&one.header), ..one });
        let (title, note) = (cited(&table.title), cited(&table.note));
        Some(Table { title, note, columns: columns.collect(), ..table })
    }
}

/// A table in the file: each column is `name | header`, or `name | header | unit`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Described {
    id: String,
    title: String,
    #[serde(default)]
    note: String,
    columns: Vec<String>,
}

static DESCRIBED: LazyLock<Vec<Described>> = LazyLock::new(|| list_in(include_str!("tables.toml")));

/// A described table that is being filled from the values of its rows.
#[derive(Debug)]
pub(crate) struct Rows<R> {
    rows: TableRows<R>,
    note: String,
    described: &'static [String],
}

/// The described table with this id, with one row per value; its columns follow.
pub(crate) fn table_of<R: Copy>(id: &str, values: impl IntoIterator<Item = R>) -> Rows<R> {
    let table = DESCRIBED.iter().find(|table| table.id == id);
    let (title, note) = table.map_or(("", ""), |table| (&table.title, &table.note));
    let described = table.map_or(&[][..], |table| &table.columns);
    Rows { rows: Table::of(id, title, values), note: note.into(), described }
}

impl<R: Copy> Rows<R> {
    /// Puts a value in the place of its name in braces in the note.
    pub(crate) fn fill(mut self, name: &str, value: &str) -> Self {
        self.note = self.note.replace(&format!("{{{name}}}"), value);
        self
    }

    /// The columns up to here name a row.
    pub(crate) fn named(self) -> Self {
        Self { rows: self.rows.named(), ..self }
    }

    /// Header and unit of a column; one that is not described has its name as header.
    fn words<'n>(&self, name: &'n str) -> (&'n str, &'n str) {
        let words = |column: &'static String| column.strip_prefix(name)?.strip_prefix(" | ");
        let words = self.described.iter().find_map(words).unwrap_or(name);
        words.split_once(" | ").unwrap_or((words, ""))
    }

    /// One more column of words.
    pub(crate) fn text<C: Into<Cell>>(self, name: &str, cell: impl Fn(R) -> C) -> Self {
        let (header, _) = self.words(name);
        Self { rows: self.rows.text(name, header, cell), ..self }
    }

    /// One more column of numbers.
    pub(crate) fn number<C: Into<Cell>>(self, name: &str, cell: impl Fn(R) -> C) -> Self {
        let (header, unit) = self.words(name);
        Self { rows: self.rows.number(name, header, unit, cell), ..self }
    }

    /// One more column of numbers with the same significant digits in every row.
    pub(crate) fn digits<D: Digits>(self, name: &str, digits: usize, value: impl Fn(R) -> D) -> Self {
        self.number(name, |row| value(row).cell(digits))
    }

    /// Several more columns that are described elsewhere, whose cells come together.
    pub(crate) fn columns<C: IntoIterator<Item = Cell>>(
        self,
        columns: impl IntoIterator<Item = Column>,
        cells: impl Fn(R) -> C,
    ) -> Self {
        Self { rows: self.rows.columns(columns, cells), ..self }
    }

    /// The table, with or without rows.
    pub(crate) fn table(self) -> Option<Table> {
        Some(self.rows.note(&self.note).table())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::{Outcome, table_makers};
    use crate::scene::read_equations;

    #[test]
    fn every_table_is_described_and_its_columns_stand_in_the_order_of_the_file() {
        let equations = include_bytes!("../../reports/im-avouac/equations.toml");
        let equations = read_equations("equations.toml", equations).unwrap();
        let outcome = Outcome::default();
        let context = Context::new(&equations, &outcome);
        let mut compared = 0;
        for table in DESCRIBED.iter() {
            let maker = table_makers().find(|maker| maker.id == table.id).unwrap();
            let Some(made) = (maker.make)(&context) else { continue };
            assert_eq!((made.id.as_str(), made.title.as_str()), (maker.id, table.title.as_str()));
            let described = table.columns.iter().map(|column| column.split(" | ").next().unwrap());
            for (column, name) in made.columns.iter().zip(described) {
                assert_eq!(column.name, name, "{}", table.id);
                assert_ne!(column.header, column.name, "{}", table.id);
                compared += 1;
            }
            // The columns of points of the boundary are those of the command `boundary`.
            let is_complete = made.columns.len() <= table.columns.len();
            assert!(is_complete || ["boundary", "marks"].contains(&maker.id), "{}", table.id);
        }
        assert!(compared > 300, "{compared}");
        // A table that is not described has no title.
        let made = table_makers().filter_map(|maker| (maker.make)(&context));
        let without: Vec<String> =
            made.filter(|table| table.title.is_empty()).map(|table| table.id).collect();
        assert_eq!(without, ["test-experiment"]);
    }
}
