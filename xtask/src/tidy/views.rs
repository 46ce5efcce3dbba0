//! Templates hold strings: no numbers are computed in them.

use super::source::{Source, line_at};

/// Complains about arithmetic between the delimiters of a template.
pub fn check(file: &Source, found: &mut Vec<String>) {
    if !file.path.starts_with("templates/") {
        return;
    }
    for (open, close) in [("{{", "}}"), ("{%", "%}")] {
        for (start, _) in file.text.match_indices(open) {
            let rest = &file.text[start + open.len()..];
            let inside = rest.find(close).map_or(rest, |end| &rest[..end]);
            if has_arithmetic(inside) {
                let message = "arithmetic in a template: compute it below `report`";
                found.push(file.complaint(line_at(&file.text, start), message));
            }
        }
    }
}

/// Whether a template expression, whitespace-control dashes removed, uses `+ - * / %` outside strings.
fn has_arithmetic(inside: &str) -> bool {
    let expression = inside.strip_prefix('-').unwrap_or(inside);
    let mut rest = expression.strip_suffix('-').unwrap_or(expression);
    while let Some(at) = rest.find(['"', '\'', '`', '+', '-', '*', '/', '%']) {
        let quote = &rest[at..=at];
        if !"\"'`".contains(quote) {
            return true;
        }
        rest = rest[at + 1..].split_once(quote).map_or("", |(_, after)| after);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    #[test]
    fn a_template_prints_and_never_computes() {
        let good =
            "<a href=\"x-y\">\n{%- for row in rows -%}{{ row.name | join(sep=\"-\") }}{% endfor %} 1 + 1";
        assert_eq!(lines_of("templates/a.html", good, check), [0; 0]);
        for bad in ["\n{{ a * b }}", "\n{{ loop.index0 + 1 }}", "\n{% set x = a-b %}", "\n{%- if a / b -%}"] {
            assert_eq!(lines_of("templates/a.html", bad, check), [2], "{bad}");
        }
    }
}
