//! One recomputed file compared with the archived one.

use csv::{ReaderBuilder, StringRecord};

use slipmode_core::number::{Rational, parse_decimal};

/// What an archive promises of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Promise {
    /// The same bytes: the program that compares has the version that archived.
    Bytes,
    /// The same numbers, each within one unit of its last printed digit, which is the error that tables state; other cells the same.
    Numbers,
}

/// How a recomputed file differs from the archived one; empty when the promise is kept.
#[must_use]
pub fn compare_file(path: &str, archived: &[u8], computed: &[u8], promise: Promise) -> Vec<String> {
    if archived == computed {
        return Vec::new();
    }
    match promise {
        Promise::Bytes => {
            let (old, new) = (archived.split(|byte| *byte == b'\n'), computed.split(|byte| *byte == b'\n'));
            let same = old.zip(new).take_while(|(old, new)| old == new).count();
            vec![format!("{path}:{}: differs from the result computed now", same + 1)]
        }
        Promise::Numbers => match (rows(archived), rows(computed)) {
            (Some(old), Some(new)) => table_differences(path, &old, &new),
            _ => vec![format!("{path}: is not a table")],
        },
    }
}

fn rows(bytes: &[u8]) -> Option<Vec<StringRecord>> {
    let mut reader = ReaderBuilder::new().has_headers(false).from_reader(bytes);
    reader.records().collect::<Result<_, _>>().ok()
}

fn table_differences(path: &str, old: &[StringRecord], new: &[StringRecord]) -> Vec<String> {
    if old.len() != new.len() {
        return vec![format!("{path}: {} rows archived, {} computed now", old.len(), new.len())];
    }
    let mut found = Vec::new();
    for (index, (old, new)) in old.iter().zip(new).enumerate() {
        let column = (old.len() != new.len())
            .then_some(0)
            .or_else(|| old.iter().zip(new).position(|(old, new)| !same_cell(old, new)));
        if let Some(column) = column {
            let cell = |record: &StringRecord| record.get(column).unwrap_or_default().to_string();
            found.push(format!("{path}:{}: {} archived, {} computed now", index + 1, cell(old), cell(new)));
        }
    }
    found
}

fn same_cell(old: &str, new: &str) -> bool {
    if old == new {
        return true;
    }
    match (parse_decimal(old), parse_decimal(new)) {
        (Ok(one), Ok(other)) => (one - other).abs() <= last_place(old).max(last_place(new)),
        _ => false,
    }
}

/// One unit in the last printed digit of a decimal.
fn last_place(text: &str) -> Rational {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len()) as i64;
    let power = exponent.parse::<i64>().unwrap_or(0).saturating_sub(decimals);
    // Beyond the reader's exponents nothing is forgiven.
    parse_decimal(&format!("1e{power}")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_compared_by_line() {
        let differences = compare_file("a.svg", b"1\n2\n3", b"1\n2\n4", Promise::Bytes);
        assert_eq!(differences, ["a.svg:3: differs from the result computed now"]);
        assert!(compare_file("a.svg", b"1", b"1", Promise::Bytes).is_empty());
    }

    #[test]
    fn numbers_may_differ_by_one_unit_of_the_last_digit() {
        let same = |old: &str, new: &str| {
            compare_file(
                "t.csv",
                format!("x\n{old}\n").as_bytes(),
                format!("x\n{new}\n").as_bytes(),
                Promise::Numbers,
            )
        };
        for (old, new) in
            [("1.50", "1.51"), ("-2e-3", "-3e-3"), ("1.5e10", "1.6e10"), ("1.50", "1.5"), ("9.99", "10.0")]
        {
            assert!(same(old, new).is_empty(), "{old} {new}");
        }
        for (old, new) in
            [("1.50", "1.52"), ("-2e-3", "2e-3"), ("eq15", "eq16"), ("1.5", "-"), ("1.51", "1.49")]
        {
            assert_eq!(same(old, new), [format!("t.csv:2: {old} archived, {new} computed now")]);
        }
    }

    #[test]
    fn rows_and_columns_are_counted() {
        let found = compare_file("t.csv", b"x\n1\n", b"x\n1\n2\n", Promise::Numbers);
        assert_eq!(found, ["t.csv: 2 rows archived, 3 computed now"]);
        assert_eq!(compare_file("t.csv", b"x,y\n1,2\n", b"x\n1\n", Promise::Numbers).len(), 2);
    }
}
