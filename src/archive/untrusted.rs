//! Texts of unknown origin in messages: short, and without characters that move a terminal's cursor.

use crate::scene::visible;

/// The most characters of one text.
const MOST_CHARACTERS: usize = 80;

/// A text of unknown origin as messages show it.
#[must_use]
pub fn shown(text: &str) -> String {
    match text.char_indices().nth(MOST_CHARACTERS) {
        None => visible(text),
        Some((end, _)) => format!("{}… ({} characters)", visible(&text[..end]), text.chars().count()),
    }
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn control_characters_are_escaped_and_long_texts_are_cut() {
        assert_eq!(shown("a\u{1b}[2Jb\n\u{202e}"), "a\\u{1b}[2Jb\\u{a}\\u{202e}");
        assert_eq!(shown("σ = 1/3 Pa"), "σ = 1/3 Pa");
        assert!(shown(&"x".repeat(1000)).ends_with("x… (1000 characters)"));
    }
}
