//! Which tables there are, and what each needs.

use crate::experiments::{Context, Need};
use crate::scene::cited;
use slipmode_plot::table::{Column, Table};

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
    #[must_use]
    pub fn table(&self, context: &Context) -> Option<Table> {
        let table = (self.make)(context).filter(|table| !table.rows.is_empty())?;
        let columns = table.columns.into_iter().map(|one| Column { header: cited(&one.header), ..one });
        let (title, note) = (cited(&table.title), cited(&table.note));
        Some(Table { title, note, columns: columns.collect(), ..table })
    }
}
