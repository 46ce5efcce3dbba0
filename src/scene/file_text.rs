//! From the bytes of a file to a text that is safe to read and to show.

use crate::scene::{Fault, Problem, is_forbidden};

/// The largest scene, report or claims file, in bytes (1 MiB).
pub const MAX_FILE_BYTES: u64 = 1 << 20;

/// The text of a file: at most [`MAX_FILE_BYTES`] of UTF-8; a byte order mark at the start is dropped.
///
/// # Errors
/// When the file is too large, not UTF-8, or holds a character that is invisible or changes the reading
/// direction (NUL and other controls, zero-width characters, bidirectional overrides).
pub fn file_text<'b>(file: &str, bytes: &'b [u8]) -> Result<&'b str, Fault> {
    let fault = |line, problem: Problem| Fault::of(file, "", problem).at(line);
    let size = bytes.len() as u64;
    if size > MAX_FILE_BYTES {
        return Err(fault(None, Problem::TooLarge { bytes: size, limit: MAX_FILE_BYTES }));
    }
    if is_utf16(bytes) {
        return Err(fault(Some(1), Problem::Utf16));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let at = error.valid_up_to();
        fault(Some(line_at(bytes, at)), Problem::NotUtf8(at + 1))
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match text.char_indices().find(|(_, character)| is_forbidden(*character)) {
        Some((at, character)) => {
            let line = line_at(text.as_bytes(), at);
            Err(fault(Some(line), Problem::ForbiddenCharacter(u32::from(character))))
        }
        None => Ok(text),
    }
}

/// Whether bytes are the beginning of a text in UTF-16: its byte order mark, or a letter in two bytes.
pub(crate) fn is_utf16(bytes: &[u8]) -> bool {
    match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
        [letter, 0, second, 0, ..] | [0, letter, 0, second, ..] => *letter > 0 && *second > 0,
        _ => false,
    }
}

/// The line, counted from 1, of a byte offset.
pub(crate) fn line_at(bytes: &[u8], offset: usize) -> usize {
    bytes[..offset.min(bytes.len())].iter().filter(|byte| **byte == b'\n').count() + 1
}

/// What is wrong with a text that holds a character that no input may hold.
pub(crate) fn forbidden_character(text: &str) -> Option<Problem> {
    let forbidden = text.chars().find(|character| is_forbidden(*character))?;
    Some(Problem::ForbiddenCharacter(u32::from(forbidden)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_order_mark_and_carriage_returns_are_accepted() {
        assert_eq!(file_text("f", b"\xef\xbb\xbfa = 1\r\n").unwrap(), "a = 1\r\n");
    }

    #[test]
    fn what_hides_or_reorders_text_is_refused_with_its_line() {
        for hidden in ['\0', '\u{202e}', '\u{200b}', '\u{feff}', '\u{7f}', '\u{1b}'] {
            let text = format!("a = 1\nb = \"{hidden}\"\n");
            let fault = file_text("f", text.as_bytes()).unwrap_err();
            assert_eq!(fault.line, Some(2));
            assert_eq!(fault.problem, Problem::ForbiddenCharacter(u32::from(hidden)));
        }
    }

    #[test]
    fn other_encodings_and_large_files_are_refused() {
        for utf16 in [&b"\xff\xfea\0"[..], b"\xfe\xff\0a", b"a\0b\0", b"\0a\0b"] {
            assert_eq!(file_text("f", utf16).unwrap_err().problem, Problem::Utf16);
        }
        assert_eq!(file_text("f", b"a\xff").unwrap_err().problem, Problem::NotUtf8(2));
        let large = vec![b' '; MAX_FILE_BYTES as usize + 1];
        assert!(matches!(file_text("f", &large).unwrap_err().problem, Problem::TooLarge { .. }));
        assert!(file_text("f", &large[1..]).is_ok());
    }
}
