//! The rows and columns of a block's CSV, counted while it is read.

use crate::cli::sweep::block_file::{Content, Heading};

/// The longest line of column names that is kept, in bytes.
const LONGEST_COLUMNS: u64 = 1 << 21;

/// What is known of a CSV text after a part of it.
#[derive(Default)]
pub struct Shape {
    /// The line of column names.
    pub columns: Vec<u8>,
    bytes: u64,
    rows: u64,
    /// Bytes of the first row, with its end.
    first_row_bytes: u64,
    /// Cells of the first row.
    width: u64,
    separators: u64,
    is_quoted: bool,
    is_row_open: bool,
    ragged_row: Option<u64>,
    has_nul: bool,
}

impl Shape {
    /// Adds the next bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.bytes += 1;
            if self.rows == 0 && self.bytes <= LONGEST_COLUMNS {
                self.columns.push(*byte);
            }
            self.is_row_open = true;
            match byte {
                b'"' => self.is_quoted = !self.is_quoted,
                b',' if !self.is_quoted => self.separators += 1,
                b'\n' if !self.is_quoted => self.end_row(),
                0 => self.has_nul = true,
                _ => {}
            }
        }
    }

    fn end_row(&mut self) {
        let cells = std::mem::take(&mut self.separators) + 1;
        if self.rows == 0 {
            (self.width, self.first_row_bytes) = (cells, self.bytes);
        } else if cells != self.width && self.ragged_row.is_none() {
            self.ragged_row = Some(self.rows);
        }
        self.rows += 1;
        self.is_row_open = false;
    }

    /// How the text is not what its heading states, if it is not.
    pub fn fault(&self, heading: &Heading) -> Option<String> {
        if self.has_nul {
            return Some("contains the character U+0000".into());
        }
        if self.is_row_open || self.first_row_bytes != heading.columns {
            return Some("a line does not end where its heading says".into());
        }
        if let Some(row) = self.ragged_row {
            return Some(format!("row {row} has another number of cells than there are columns"));
        }
        let rows = self.rows.saturating_sub(1);
        (heading.origin.content == Content::Rows && rows != heading.points)
            .then(|| format!("contains {rows} rows, not {}", heading.points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::sweep::block_file::Origin;

    fn fault(csv: &str, columns: u64, points: u64) -> Option<String> {
        let origin = Origin { scene: "s".into(), version: "v".into(), blocks: 1, content: Content::Rows };
        let mut shape = Shape::default();
        // In parts, as a file is read.
        csv.as_bytes().chunks(3).for_each(|part| shape.add(part));
        shape.fault(&Heading::of(origin, 0, points, columns, csv.len() as u64))
    }

    #[test]
    fn rows_and_columns_are_those_of_the_heading() {
        assert_eq!(fault("a,b\n1,2\n\"x\n,\",4\n", 4, 2), None);
        for (csv, columns, points, problem) in [
            ("a,b\n1,2\n", 4, 2, "contains 1 rows, not 2"),
            ("a,b\n1,2\n3,4\n", 4, 1, "contains 2 rows, not 1"),
            ("a,b\n1,2,3\n", 4, 1, "row 1 has another number of cells"),
            ("a,b\n1,2", 4, 1, "does not end"),
            ("a,b\n1,2\n", 8, 1, "does not end"),
            ("a,b\n\"1,2\n", 4, 1, "does not end"),
            ("a,b\n1,\0\n", 4, 1, "U+0000"),
        ] {
            let found = fault(csv, columns, points).unwrap_or_default();
            assert!(found.contains(problem), "{csv:?}: {found:?}");
        }
    }
}
