//! Escaping of plain text for Markdown, and the characters that no output may carry.

/// Plain text as Markdown inline text that shows exactly these characters, anywhere in a line.
///
/// Newlines become spaces; characters that are invisible or reorder text become U+FFFD.
#[must_use]
pub fn escape_markdown(text: &str) -> String {
    let body = escape_cell(text);
    let block_start = body.starts_with(['-', '+', '=', ':'])
        || body.trim_start_matches(|c: char| c.is_ascii_digit()).starts_with(['.', ')'])
            && body.starts_with(|c: char| c.is_ascii_digit());
    if !block_start {
        return body;
    }
    // A list, a rule or an underlined heading cannot start at an escaped sign.
    let at = body.find(|c: char| !c.is_ascii_digit()).unwrap_or(0);
    format!("{}\\{}", &body[..at], &body[at..])
}

/// Plain text as the content of a Markdown table cell: like [`escape_markdown`], but a leading sign or number stays bare.
#[must_use]
pub fn escape_cell(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    let mut characters = text.trim().chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '\n' | '\r' | '\t' => escaped.push(' '),
            '&' if !characters.peek().is_some_and(|next| next.is_alphanumeric() || *next == '#') => {
                escaped.push(c)
            }
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '~' | '$' | '#' | '&' => {
                escaped.push('\\');
                escaped.push(c);
            }
            c => escaped.push(printable(c)),
        }
    }
    escaped
}

/// Text for HTML and SVG: characters with a meaning there are escaped.
#[must_use]
pub fn escape_html(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\'' => escaped += "&#39;",
            c => escaped.push(printable(c)),
        }
    }
    escaped
}

/// The character itself, or U+FFFD for controls (newline and tab apart), zero-width and direction-changing characters.
#[must_use]
pub fn printable(c: char) -> char {
    let hidden = matches!(c,
        '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}'
        | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{fffe}' | '\u{ffff}' | '\u{e0000}'..='\u{e007f}');
    if hidden || (c.is_control() && !matches!(c, '\n' | '\t')) { '\u{fffd}' } else { c }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_shown_and_not_obeyed() {
        assert_eq!(escape_markdown("a|b*c_d`e"), r"a\|b\*c\_d\`e");
        assert_eq!(escape_markdown("<img src=x>"), r"\<img src=x\>");
        assert_eq!(escape_markdown("[x](javascript:y)"), r"\[x\](javascript:y)");
        assert_eq!(escape_markdown("two\nlines"), "two lines");
        assert_eq!(escape_markdown("a & b &lt; &#60;"), r"a & b \&lt; \&\#60;");
    }

    #[test]
    fn a_leading_sign_or_number_starts_no_list() {
        assert_eq!(escape_markdown("- item"), r"\- item");
        assert_eq!(escape_markdown("12. item"), r"12\. item");
        assert_eq!(escape_markdown("12.5"), r"12\.5");
        assert_eq!(escape_markdown("12 items"), "12 items");
        assert_eq!(escape_cell("-1.5e-4"), "-1.5e-4");
    }

    #[test]
    fn hidden_characters_become_visible() {
        assert_eq!(escape_cell("a\u{202e}b\u{200b}c\u{0}d"), "a\u{fffd}b\u{fffd}c\u{fffd}d");
    }
}
