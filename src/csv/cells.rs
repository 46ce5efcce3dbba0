//! Cells of the output: quoted where CSV needs it, and harmless in a spreadsheet.

use slipmode_core::number::format::{shortest, shortest_pieces};
use slipmode_core::number::parse_decimal;

/// Appends a cell of the input as it stands; text that a spreadsheet would run as a formula gets a `'` in front.
///
/// Numbers stay as written, their signs included.
pub fn push_cell(out: &mut Vec<u8>, cell: &[u8]) {
    let guarded = starts_a_formula(cell);
    // All bytes are looked at, so that the loop runs in vector units.
    let quoted = cell.iter().fold(false, |found, byte| found | matches!(byte, b',' | b'"' | b'\n' | b'\r'));
    if quoted {
        out.push(b'"');
    }
    if guarded {
        out.push(b'\'');
    }
    if !quoted {
        out.extend_from_slice(cell);
        return;
    }
    for byte in cell {
        if *byte == b'"' {
            out.push(b'"');
        }
        out.push(*byte);
    }
    out.push(b'"');
}

fn starts_a_formula(cell: &[u8]) -> bool {
    let Some(b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r') = cell.first() else { return false };
    std::str::from_utf8(cell).map_or(true, |text| parse_decimal(text).is_err())
}

/// What stands in an appended cell, and under its name in JSON.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum Datum {
    /// A text.
    Text(String),
    /// A number of 64 bits, in its shortest decimal; an empty cell, or null, when there is none.
    Number(Option<f64>),
    /// The ends of a range, as it is typed as an input; an empty cell, or null, when there is none.
    Range(Option<[f64; 2]>),
    /// A whole number.
    Count(u64),
    /// `true` or `false`.
    Flag(bool),
}

/// An appended column: its name, and its cell of a result.
pub type Column<T> = (&'static str, fn(&T) -> Datum);

/// The names of columns.
#[must_use]
pub const fn names<T, const N: usize>(columns: &[Column<T>; N]) -> [&'static str; N] {
    let mut names = [""; N];
    let mut index = 0;
    while index < N {
        names[index] = columns[index].0;
        index += 1;
    }
    names
}

/// The names of columns followed by those of more columns, of which there are `N` together.
#[must_use]
pub const fn joined<const N: usize>(first: &[&'static str], more: &[&'static str]) -> [&'static str; N] {
    let mut names = [""; N];
    let mut index = 0;
    while index < N {
        names[index] = if index < first.len() { first[index] } else { more[index - first.len()] };
        index += 1;
    }
    names
}

/// Appends the cells of a result, each behind a comma.
pub fn push_cells<T>(columns: &[Column<T>], result: &T, out: &mut Vec<u8>) {
    for (_, cell) in columns {
        out.push(b',');
        match cell(result) {
            Datum::Text(text) => push_cell(out, text.as_bytes()),
            Datum::Number(None) => {}
            Datum::Number(Some(number)) => {
                shortest_pieces(number, |piece| out.extend_from_slice(piece.as_bytes()));
            }
            Datum::Range(ends) => push_cell(out, ends.map(range_text).unwrap_or_default().as_bytes()),
            Datum::Count(count) => out.extend(count.to_string().bytes()),
            Datum::Flag(flag) => out.extend(flag.to_string().bytes()),
        }
    }
}

/// A range as it is typed as an input.
fn range_text(ends: [f64; 2]) -> String {
    let [low, high] = ends.map(shortest);
    format!("[{low}, {high}]")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(cell: &str) -> String {
        let mut out = Vec::new();
        push_cell(&mut out, cell.as_bytes());
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn formulas_are_disarmed_and_numbers_are_not_touched() {
        for text in ["=1+1", "+cmd", "-x", "@sum", "\tx", "-inf"] {
            assert_eq!(written(text), format!("'{text}"));
        }
        for text in ["-1.50", "+1e-5", "-.5", "0.004", "a=b", ""] {
            assert_eq!(written(text), text);
        }
    }

    #[test]
    fn separators_and_quotation_marks_are_quoted() {
        assert_eq!(written("a,b"), "\"a,b\"");
        assert_eq!(written("5\" pipe"), "\"5\"\" pipe\"");
        assert_eq!(written("=\"x\""), "\"'=\"\"x\"\"\"");
    }
}
