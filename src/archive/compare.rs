//! A recomputed text compared with the archived one: the same bytes, or the same up to the last digits of numbers.

use slipmode_core::number::{Rational, parse_decimal};

use super::untrusted::shown;

/// The most differing lines of one file that are named one by one.
const MOST_LINES: usize = 10;

/// The fewest significant digits of a number that may differ in its last digit: then the difference is at most 1 %.
const FEWEST_DIGITS: usize = 3;

/// The first line in which two files differ; none when they have the same bytes.
pub(crate) fn byte_difference(path: &str, archived: &[u8], computed: &[u8]) -> Option<String> {
    let line = first_different_line(archived, computed)?;
    Some(format!("{path}:{line}: differs from the result computed now"))
}

/// The first line, counted from 1, in which two files differ; none when they have the same bytes.
pub fn first_different_line(old: &[u8], new: &[u8]) -> Option<usize> {
    let is_end = |byte: &u8| *byte == b'\n';
    let lines = old.split(is_end).zip(new.split(is_end));
    (old != new).then(|| lines.take_while(|(old, new)| old == new).count() + 1)
}

/// The lines in which two texts differ by more than the last digits of numbers; see [`same_text`].
pub(crate) fn text_differences(path: &str, archived: &[u8], computed: &[u8]) -> Vec<String> {
    if archived == computed {
        return Vec::new();
    }
    let (Ok(old), Ok(new)) = (std::str::from_utf8(archived), std::str::from_utf8(computed)) else {
        return vec![format!("{path}: is not UTF-8 text")];
    };
    let (old, new): (Vec<&str>, Vec<&str>) = (old.split('\n').collect(), new.split('\n').collect());
    let mut lines = (1..).zip(old.iter().zip(&new)).filter(|(_, (old, new))| !same_text(old, new));
    let line = |(number, (old, new)): (usize, (&&str, &&str))| {
        let (old, new) = first_difference(old, new);
        format!("{path}:{number}: {} archived, {} computed now", shown(old), shown(new))
    };
    let mut found: Vec<String> = lines.by_ref().take(MOST_LINES).map(line).collect();
    found.extend(lines.next().map(|_| format!("{path}: and more lines")));
    if old.len() != new.len() {
        found.push(format!("{path}: {} lines archived, {} computed now", old.len(), new.len()));
    }
    found
}

/// Whether two texts are the same but for the last digits of numbers.
///
/// A number may differ by one unit of the last digit of the *computed* one, if that one has a decimal point or an
/// exponent and at least three significant digits. Whole numbers, signs, words and everything else must be the same.
pub(crate) fn same_text(archived: &str, computed: &str) -> bool {
    archived == computed || same_pieces(archived, computed)
}

fn same_pieces(archived: &str, computed: &str) -> bool {
    let (old, new) = (pieces(archived), pieces(computed));
    old.len() == new.len() && old.iter().zip(&new).all(|(old, new)| old == new || same_number(old, new))
}

/// Numbers without sign, and the texts between them, in order.
fn pieces(text: &str) -> Vec<&str> {
    let bytes = text.as_bytes();
    let (mut pieces, mut start, mut at) = (Vec::new(), 0, 0);
    while at < bytes.len() {
        if !bytes[at].is_ascii_digit() {
            at += 1;
            continue;
        }
        let end = number_end(bytes, at);
        if !is_in_a_word(at.checked_sub(1).map(|before| bytes[before]))
            && !is_in_a_word(bytes.get(end).copied())
        {
            pieces.extend([&text[start..at], &text[at..end]]);
            start = end;
        }
        at = end;
    }
    pieces.push(&text[start..]);
    pieces
}

/// Whether a number beside this byte is part of a word, such as a digest. The commands of SVG paths are no words.
fn is_in_a_word(beside: Option<u8>) -> bool {
    let is_command = |byte: u8| b"MLHVCSQTAZhvlm".contains(&byte);
    beside.is_some_and(|byte| {
        byte == b'_' || byte == b'.' || (byte.is_ascii_alphanumeric() && !is_command(byte))
    })
}

/// Where the number that starts at `start` ends: digits, a point with digits, an exponent.
fn number_end(bytes: &[u8], start: usize) -> usize {
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = start + digits(start);
    if bytes.get(end) == Some(&b'.') && digits(end + 1) > 0 {
        end += 1 + digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let signed = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if signed < bytes.len() && digits(signed) > 0 {
            end = signed + digits(signed);
        }
    }
    end
}

fn same_number(archived: &str, computed: &str) -> bool {
    let Some(unit) = last_place(computed) else { return false };
    match (parse_decimal(archived), parse_decimal(computed)) {
        (Ok(one), Ok(other)) => (one - other).abs() <= unit,
        _ => false,
    }
}

/// One unit of the last digit of a number that may differ in it.
fn last_place(text: &str) -> Option<Rational> {
    if !text.contains(['.', 'e', 'E']) {
        return None;
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let significant = mantissa.replace('.', "").trim_start_matches('0').len();
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let power = exponent.parse::<i64>().ok()?.checked_sub(i64::try_from(decimals).ok()?)?;
    if significant < FEWEST_DIGITS { None } else { parse_decimal(&format!("1e{power}")).ok() }
}

/// The first cells or words of two lines that differ.
fn first_difference<'l>(old: &'l str, new: &'l str) -> (&'l str, &'l str) {
    let words = |line: &'l str| line.split([',', ' ', '"', '<', '>', '|']);
    words(old).zip(words(new)).find(|(old, new)| !same_text(old, new)).unwrap_or((old, new))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_compared_by_line() {
        let difference = byte_difference("a.svg", b"1\n2\n3", b"1\n2\n4").unwrap();
        assert_eq!(difference, "a.svg:3: differs from the result computed now");
        assert_eq!(byte_difference("a.svg", b"1", b"1"), None);
    }

    #[test]
    fn numbers_may_differ_by_one_unit_of_the_computed_ones_last_digit() {
        for (archived, computed) in [
            ("1.50", "1.51"),
            ("-2.17e-3", "-2.18e-3"),
            ("1.52e10", "1.53e10"),
            ("9.991", "9.99"),
            ("M1.25 3.00L7.85", "M1.26 3.00L7.84"),
            ("x = 0.00123, y = 5", "x = 0.00124, y = 5"),
        ] {
            assert!(same_text(archived, computed), "{archived} {computed}");
        }
        for (archived, computed) in [
            ("1.50", "1.52"),
            ("1e30", "1.50"),
            ("2e0", "1.50"),
            // A coarse archived number brings no tolerance of its own.
            ("2", "1.50"),
            ("-2.17e-3", "2.17e-3"),
            ("2e-3", "3e-3"),
            ("0.1", "0.2"),
            ("35 of 36", "36 of 36"),
            ("section 3.2", "section 3.1"),
            ("eq15", "eq16"),
            ("1.50", "-"),
            ("1.50 1.50", "1.50"),
            ("1.50e9999999999", "1.50e1"),
            ("a124e45b", "a123e45b"),
            ("1.235.0", "1.234.0"),
        ] {
            assert!(!same_text(archived, computed), "{archived} {computed}");
        }
    }

    #[test]
    fn differing_lines_are_named_and_capped() {
        let found = text_differences("t.csv", b"x\nupper,1.50\n", b"x\nlower,1.51\n");
        assert_eq!(found, ["t.csv:2: upper archived, lower computed now"]);
        assert_eq!(
            text_differences("t.csv", b"x\n1", b"x\n1\n2"),
            ["t.csv: 2 lines archived, 3 computed now"]
        );
        let many = |word: &str| format!("{word}\n").repeat(50).into_bytes();
        assert_eq!(text_differences("t.csv", &many("a"), &many("b")).len(), MOST_LINES + 1);
        assert_eq!(text_differences("t.csv", b"\xff", b"a"), ["t.csv: is not UTF-8 text"]);
    }
}
