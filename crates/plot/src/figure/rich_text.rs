//! The little markup of words in figures: `*italic*`, `**bold**`, `_sub`, `^super`, braces for more than one character.

use super::svg::{Svg, escape, number};

/// A run of characters in one style.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Run {
    text: String,
    style: Style,
}

/// How characters look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Style {
    italic: bool,
    bold: bool,
    level: Level,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Level {
    Base,
    Sub,
    Super,
}

/// Size of sub- and superscripts relative to the line.
const SCRIPT_SIZE: f64 = 0.72;

/// Width of a space relative to the font size.
const SPACE: f64 = 0.28;

/// Markup as SVG content for a line of the given font size.
pub(crate) fn to_svg(markup: &str, size: f64) -> String {
    let mut svg = String::new();
    let (mut shift, mut space_before) = (0.0, false);
    for run in runs(markup) {
        // A shift on a run of spaces alone would be lost with it.
        if run.text.trim_matches(' ').is_empty() {
            space_before = true;
            continue;
        }
        let wanted = match run.style.level {
            Level::Base => 0.0,
            Level::Sub => 0.22 * size,
            Level::Super => -0.36 * size,
        };
        let mut attributes = String::new();
        if wanted != shift {
            attributes += &format!(" dy=\"{}\"", number(wanted - shift));
            shift = wanted;
        }
        if run.style.level != Level::Base {
            attributes += &format!(" font-size=\"{}\"", number(SCRIPT_SIZE * size));
        }
        if run.style.italic {
            attributes += " font-style=\"italic\"";
        }
        if run.style.bold {
            attributes += " font-weight=\"600\"";
        }
        // Some viewers drop a space at the edge of a run; a shift is kept by all.
        let words = run.text.trim_matches(' ');
        let gap = !svg.is_empty() && (space_before || run.text.starts_with(' '));
        if gap {
            attributes += &format!(" dx=\"{}\"", number(SPACE * size));
        }
        space_before = run.text.ends_with(' ');
        let text = escape(words);
        svg += &if attributes.is_empty() { text } else { format!("<tspan{attributes}>{text}</tspan>") };
    }
    svg
}

impl Svg {
    /// Words in figure markup at a place, in the style of the group around them.
    pub fn words(&mut self, (x, y): (f64, f64), markup: &str, size: f64) {
        let at = [number(x), number(y)];
        self.text(&[("x", &at[0]), ("y", &at[1])], &to_svg(markup, size));
    }
}

/// Estimated width of the markup for a line of the given font size: room enough for the wider system fonts.
pub(crate) fn width(markup: &str, size: f64) -> f64 {
    let run_width = |run: Run| {
        let scale = if run.style.level == Level::Base { size } else { SCRIPT_SIZE * size };
        run.text.chars().map(character_width).sum::<f64>() * scale
    };
    runs(markup).into_iter().map(run_width).sum()
}

/// The markup as plain words.
#[cfg(test)]
fn plain(markup: &str) -> String {
    runs(markup).into_iter().map(|run| run.text).collect()
}

fn character_width(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' => 0.31,
        'f' | 't' | 'r' | '(' | ')' | ' ' | '/' | '-' | '·' => 0.39,
        'm' | 'w' | 'M' | 'W' | '%' | '≈' => 0.93,
        'A'..='Z' => 0.7,
        _ => 0.62,
    }
}

fn runs(markup: &str) -> Vec<Run> {
    let mut found: Vec<Run> = Vec::new();
    let (mut style, mut braced) = (Style { italic: false, bold: false, level: Level::Base }, false);
    let mut characters = markup.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '*' if characters.next_if_eq(&'*').is_some() => style.bold = !style.bold,
            '*' => style.italic = !style.italic,
            '_' if style.level == Level::Base => style.level = Level::Sub,
            '^' if style.level == Level::Base => style.level = Level::Super,
            '{' if style.level != Level::Base && !braced => braced = true,
            '}' if braced => (style.level, braced) = (Level::Base, false),
            _ => {
                let c = if c == '\\' { characters.next().unwrap_or(c) } else { c };
                match found.last_mut() {
                    Some(run) if run.style == style => run.text.push(c),
                    _ => found.push(Run { text: c.into(), style }),
                }
                if !braced {
                    style.level = Level::Base;
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_raised_and_the_line_goes_on_at_its_base() {
        assert_eq!(
            to_svg("10^{−3} m", 10.0),
            "10<tspan dy=\"-3.6\" font-size=\"7.2\">−3</tspan><tspan dy=\"3.6\" dx=\"2.8\">m</tspan>"
        );
    }

    #[test]
    fn spaces_between_runs_become_shifts() {
        assert_eq!(to_svg("*a* = *b*", 10.0).matches("dx=\"2.8\"").count(), 2);
        assert_eq!(to_svg("10 m", 10.0), "10 m");
    }

    #[test]
    fn a_space_after_an_index_does_not_keep_the_line_low() {
        let svg = to_svg("*V*_l *t*", 10.0);
        assert!(svg.ends_with("<tspan dy=\"-2.2\" font-style=\"italic\" dx=\"2.8\">t</tspan>"), "{svg}");
    }

    #[test]
    fn variables_are_italic_and_their_indices_are_lowered() {
        let svg = to_svg("*V*_0", 10.0);
        assert_eq!(
            svg,
            "<tspan font-style=\"italic\">V</tspan><tspan dy=\"2.2\" font-size=\"7.2\">0</tspan>"
        );
    }

    #[test]
    fn markup_loses_no_character_of_hostile_words() {
        assert_eq!(plain(r"a\_b\*c\\"), r"a_b*c\");
        assert_eq!(to_svg("<b>&\"", 10.0), "&lt;b&gt;&amp;&quot;");
        assert_eq!(plain("x_{ab"), "xab");
        assert_eq!(plain("}{"), "}{");
        assert_eq!(plain("**a** *b*"), "a b");
    }
}
