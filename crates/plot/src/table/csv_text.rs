//! CSV for programs: units in the header, quoting by the `csv` crate, no cell that a spreadsheet would run.

use super::{Cell, Kind, Table};

impl Table {
    /// The table as CSV with `\n` line ends and one header row of [`super::Column::name`]s.
    ///
    /// A text cell that starts with `=`, `+`, `-`, `@`, a tab or a carriage return gets a leading `'`, so that no
    /// spreadsheet takes it for a formula. Numbers are written as they are; a cell declared a number that is not spelled like one is guarded as text.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut writer = csv::WriterBuilder::new().flexible(true).from_writer(Vec::new());
        let header = self.columns.iter().map(|column| guarded(&column.name));
        let rows = self.rows.iter().map(|row| row.iter().map(field).collect::<Vec<_>>());
        for record in std::iter::once(header.collect::<Vec<_>>()).chain(rows) {
            // A flexible writer into memory has no way to fail.
            let _ = writer.write_record(&record);
        }
        let bytes = writer.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }
}

fn field(cell: &Cell) -> String {
    match cell.kind {
        Kind::Number if is_number(&cell.text) => cell.text.clone(),
        Kind::Number | Kind::Text => guarded(&cell.text),
    }
}

fn guarded(text: &str) -> String {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r']) { format!("'{text}") } else { text.into() }
}

/// Digits with an optional sign, point, fraction bar and exponent: nothing that a spreadsheet would evaluate further.
fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text);
    digits.starts_with(|c: char| c.is_ascii_digit())
        && digits.chars().enumerate().all(|(at, c)| {
            c.is_ascii_digit()
                || matches!(c, '.' | '/' | 'e')
                || (matches!(c, '+' | '-') && digits[..at].ends_with('e'))
        })
}

#[cfg(test)]
mod tests {
    use super::super::{Cell, Column, Table};

    fn table(cells: Vec<Cell>) -> Table {
        let columns = (0..cells.len()).map(|i| Column::text(&format!("c{i}"), "")).collect();
        let mut table = Table::new("t", "T", columns);
        table.push(cells);
        table
    }

    #[test]
    fn header_is_the_column_name_with_its_unit() {
        let mut t = Table::new("t", "T", vec![Column::number("normal_stress_pa", "Normal stress", "Pa")]);
        t.push(vec![Cell::number("-1.5e-4")]);
        assert_eq!(t.to_csv(), "normal_stress_pa\n-1.5e-4\n");
    }

    #[test]
    fn text_that_a_spreadsheet_would_run_gets_a_quote() {
        for hostile in ["=1+1", "+1", "-1", "@SUM(A1)", "\tx"] {
            let csv = table(vec![Cell::text(hostile), Cell::text("x")]).to_csv();
            assert!(csv.contains(&format!("'{hostile}")), "{csv}");
        }
    }

    #[test]
    fn a_number_cell_is_guarded_when_it_is_no_number() {
        for hostile in ["-2+3+cmd|' /C calc'!A0", "=1", "-", "@1"] {
            let csv = table(vec![Cell::number(hostile), Cell::text("x")]).to_csv();
            assert!(csv.contains(&format!("'{hostile}")), "{csv}");
        }
        assert!(table(vec![Cell::number("-8.25e+12"), Cell::empty()]).to_csv().ends_with("\n-8.25e+12,\n"));
    }

    #[test]
    fn commas_quotes_and_newlines_come_back_from_a_reader() {
        let cells = ["a,b", "say \"so\"", "two\nlines", "", "<img onerror=x>"];
        let csv = table(cells.iter().map(|&c| Cell::text(c)).collect()).to_csv();
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        let record = reader.records().next().unwrap().unwrap();
        assert_eq!(record.iter().collect::<Vec<_>>(), cells);
    }
}
