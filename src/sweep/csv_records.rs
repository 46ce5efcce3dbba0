//! Records and cells of CSV that was written by this program: as they stand, quotation marks included.

/// The records of a text, without the end of the line; a line break between quotation marks ends none.
pub(crate) fn records(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    split(text, b'\n').filter(|record| !record.is_empty())
}

/// The cells of a record.
pub(crate) fn cells(record: &[u8]) -> impl Iterator<Item = &[u8]> {
    split(record, b',')
}

/// Splits at a byte outside quotation marks; a doubled mark within a cell closes and opens again, which comes to the same.
fn split(text: &[u8], separator: u8) -> impl Iterator<Item = &[u8]> {
    let mut quoted = false;
    text.split(move |byte| {
        quoted ^= *byte == b'"';
        !quoted && *byte == separator
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_between_quotation_marks_separate_nothing() {
        let text = b"a,\"b,\n\"\"c\",\nd,e\n";
        let found: Vec<Vec<&[u8]>> = records(text).map(|record| cells(record).collect()).collect();
        assert_eq!(found, [vec![&b"a"[..], b"\"b,\n\"\"c\"", b""], vec![b"d", b"e"]]);
        assert_eq!(cells(b"").count(), 1);
    }
}
