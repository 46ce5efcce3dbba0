//! Cells of the output: quoted where CSV needs it, and harmless in a spreadsheet.

use slipmode_core::number::parse_decimal;

/// Appends a cell of the input as it stands; text that a spreadsheet would run as a formula gets a `'` in front.
///
/// Numbers stay as written, their signs included.
pub fn push_cell(out: &mut Vec<u8>, cell: &[u8]) {
    let guarded = starts_a_formula(cell);
    let quoted = cell.iter().any(|byte| matches!(byte, b',' | b'"' | b'\n' | b'\r'));
    if quoted {
        out.push(b'"');
    }
    if guarded {
        out.push(b'\'');
    }
    for byte in cell {
        if *byte == b'"' {
            out.push(b'"');
        }
        out.push(*byte);
    }
    if quoted {
        out.push(b'"');
    }
}

fn starts_a_formula(cell: &[u8]) -> bool {
    let Some(b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r') = cell.first() else { return false };
    std::str::from_utf8(cell).map_or(true, |text| parse_decimal(text).is_err())
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
