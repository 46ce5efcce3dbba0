//! Markdown pipe tables in the style that linters accept: spaced pipes, an alignment row that says what is a number.

use super::{Kind, Table, escape_cell};

impl Table {
    /// The table as a Markdown pipe table, numbers flush right; without its title and note.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        self.first_rows_to_markdown(self.rows.len())
    }

    /// The first `count` rows of the table as a pipe table.
    #[must_use]
    pub fn first_rows_to_markdown(&self, count: usize) -> String {
        let headings = line(self.columns.iter().map(|column| escape_cell(&column.heading())));
        let rules = line(self.columns.iter().map(|column| rule(column.kind).into()));
        let rows = self.rows.iter().take(count);
        let rows = rows.map(|row| line(row.iter().map(|cell| escape_cell(&cell.text))));
        [headings, rules].into_iter().chain(rows).collect()
    }
}

fn line(cells: impl Iterator<Item = String>) -> String {
    let cell = |cell: String| if cell.is_empty() { " |".to_owned() } else { format!(" {cell} |") };
    format!("|{}\n", cells.map(cell).collect::<String>())
}

fn rule(kind: Kind) -> &'static str {
    match kind {
        Kind::Text => "---",
        Kind::Number => "---:",
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Cell, Column, Table};

    #[test]
    fn numbers_are_flush_right_and_units_stand_in_the_heading() {
        let columns =
            vec![Column::text("arc", "Arc"), Column::number("normal_stress_pa", "Normal stress", "Pa")];
        let mut table = Table::new("t", "T", columns);
        table.push(vec![Cell::text("upper"), Cell::number("-1.5e4")]);
        table.push(vec![Cell::text("lower"), Cell::empty()]);
        assert_eq!(
            table.to_markdown(),
            "| Arc | Normal stress (Pa) |\n| --- | ---: |\n| upper | -1.5e4 |\n| lower | |\n"
        );
    }

    #[test]
    fn a_pipe_or_a_newline_in_a_cell_keeps_the_row_whole() {
        let mut table = Table::new("t", "T", vec![Column::text("a", "a|b"), Column::text("b", "B")]);
        table.push(vec![Cell::text("x|y\nz"), Cell::text("<script>")]);
        let text = table.to_markdown();
        assert_eq!(text.lines().count(), 3);
        assert!(text.ends_with("| x\\|y z | \\<script\\> |\n"), "{text}");
    }
}
