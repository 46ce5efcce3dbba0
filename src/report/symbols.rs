//! Symbols in plain words: `K_c,qs` is set as K with its index below the line.

use super::templates::escape_html;

/// The words as HTML, everything in them escaped, with the index of every symbol as a subscript.
///
/// A symbol is one letter, an underscore and an index of ASCII letters and digits, which may hold single commas. Another Latin letter
/// before it, or a second underscore, makes it the name of something in a program, which stays as it is.
pub(crate) fn set_symbols(words: &str) -> String {
    let mut html = String::with_capacity(words.len());
    let (mut rest, mut before) = (words, None);
    while let Some(at) = rest.find('_') {
        let (head, tail) = (&rest[..at], &rest[at + 1..]);
        push_escaped(head, &mut html);
        let mut nearest = head.chars().rev().chain(before);
        let is_symbol =
            nearest.next().is_some_and(char::is_alphabetic) && !nearest.next().is_some_and(is_of_a_name);
        let index = index_of(tail);
        if is_symbol && !index.is_empty() && !tail[index.len()..].starts_with('_') {
            html.extend(["<sub>", index, "</sub>"]);
            before = index.chars().next_back();
            rest = &tail[index.len()..];
        } else {
            html.push('_');
            before = Some('_');
            rest = tail;
        }
    }
    push_escaped(rest, &mut html);
    html
}

fn is_of_a_name(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_'
}

/// The index that the text begins with: a comma belongs to it when more of the index follows at once.
fn index_of(text: &str) -> &str {
    let bytes = text.as_bytes();
    let is_part = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_alphanumeric);
    let is_inner_comma = |at: usize| at > 0 && bytes.get(at) == Some(&b',') && is_part(at + 1);
    let end = (0..bytes.len()).find(|&at| !is_part(at) && !is_inner_comma(at));
    &text[..end.unwrap_or(bytes.len())]
}

fn push_escaped(words: &str, html: &mut String) {
    let mut escaped = Vec::with_capacity(words.len());
    // Writing to memory does not fail, and what is escaped stays text.
    if escape_html(words, &mut escaped).is_ok() {
        html.push_str(&String::from_utf8_lossy(&escaped));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_go_below_the_line() {
        assert_eq!(set_symbols("K = K_c, or K_c,qs."), "K = K<sub>c</sub>, or K<sub>c,qs</sub>.");
        assert_eq!(set_symbols("M V_0²/(σ a D_c)"), "M V<sub>0</sub>²/(σ a D<sub>c</sub>)");
        assert_eq!(set_symbols("3σ_c/4, σD_c"), "3σ<sub>c</sub>/4, σD<sub>c</sub>");
        assert_eq!(set_symbols("ω_n < |p_measured|"), "ω<sub>n</sub> &lt; |p<sub>measured</sub>|");
    }

    #[test]
    fn names_of_a_program_stay() {
        for name in ["normal_stress_pa", "a_b_c", "mu_0", "_x", "x_", "x__y", "K_<b>"] {
            assert!(!set_symbols(name).contains("<sub>"), "{name}");
        }
        assert_eq!(set_symbols("K_<b>&"), "K_&lt;b&gt;&amp;");
    }
}
