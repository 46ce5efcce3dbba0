//! What a map says at its points, carried in the drawing for a page that reads it out.

use std::collections::BTreeMap;

use super::frame::Frame;
use super::svg::{Svg, number};

/// Words at the points of a coarse grid over a map; the same words stand in the map's tables and legend.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Readout {
    /// The words themselves.
    Words(Words),
    /// Those of the figure with this id, which is a map over the same axes.
    SameAs(String),
}

/// The words of a readout.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Words {
    /// Horizontal coordinates with their unit, from left to right, even on the axis.
    pub columns: Vec<String>,
    /// Vertical coordinates with their unit, from the lowest, even on the axis.
    pub rows: Vec<String>,
    /// The sentence: `{x}` and `{y}` stand for the coordinates, `{0}`, `{1}`, … for the fields of a point.
    pub sentence: String,
    /// The fields: of each, one text a point, row by row. None may hold a `|` or `~`.
    pub fields: Vec<Vec<String>>,
}

impl Readout {
    /// Lays an invisible plane over the map that carries the words.
    pub(crate) fn draw(&self, svg: &mut Svg, frame: &Frame) {
        let corner = [number(frame.bounds.left), number(frame.bounds.top)];
        let size = [number(frame.size().0), number(frame.size().1)];
        let mut attributes = vec![
            ("class", "readout"),
            ("x", corner[0].as_str()),
            ("y", &corner[1]),
            ("width", &size[0]),
            ("height", &size[1]),
            ("fill", "#fff"),
            ("fill-opacity", "0"),
        ];
        let texts = match self {
            Self::SameAs(figure) => vec![("data-as", figure.clone())],
            Self::Words(words) => {
                let (named, cells): (Vec<_>, Vec<_>) = words.fields.iter().map(|field| packed(field)).unzip();
                vec![
                    ("data-columns", words.columns.join("|")),
                    ("data-rows", words.rows.join("|")),
                    ("data-sentence", words.sentence.clone()),
                    ("data-words", named.join("~")),
                    ("data-cells", cells.join("~")),
                ]
            }
        };
        attributes.extend(texts.iter().map(|(name, text)| (*name, text.as_str())));
        svg.leaf("rect", &attributes);
    }
}

/// How many points one code repeats at most.
const MOST_REPEATS: usize = 26;

/// How many words can be named by two digits of base 36.
const NAMED_WORDS: usize = 36 * 36;

/// A field as its different words, in the order in which they first occur, and codes: `!` is the next new word, two
/// digits of base 36 the number of a former one, `A` to `Z` repeat the word before 1 to 26 times.
#[must_use]
pub fn packed(field: &[String]) -> (String, String) {
    let (mut words, mut cells) = (Vec::new(), String::new());
    let mut known: BTreeMap<&str, usize> = BTreeMap::new();
    for run in field.chunk_by(|one, next| one == next) {
        let text = run[0].as_str();
        match known.get(text) {
            Some(&at) => cells.extend([at / 36, at % 36].map(base_36)),
            None => {
                cells.push('!');
                if words.len() < NAMED_WORDS {
                    known.insert(text, words.len());
                }
                words.push(text);
            }
        }
        cells.extend(
            run[1..].chunks(MOST_REPEATS).map(|repeats| base_36(9 + repeats.len()).to_ascii_uppercase()),
        );
    }
    (words.join("|"), cells)
}

fn base_36(digit: usize) -> char {
    u32::try_from(digit).ok().and_then(|digit| char::from_digit(digit, 36)).unwrap_or('0')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_is_packed_into_its_different_words_and_a_code_a_point() {
        let field: Vec<String> = ["a", "a", "b", "a", "c", "c", "b"].map(String::from).to_vec();
        assert_eq!(packed(&field), ("a|b|c".into(), "!A!00!A01".into()));
        assert_eq!(packed(&vec!["a".into(); 80]), ("a".into(), "!ZZZA".into()));
        assert_eq!(packed(&vec!["a".into(); 54]), ("a".into(), "!ZZA".into()));
        assert_eq!(packed(&[]), (String::new(), String::new()));
    }

    #[test]
    fn words_beyond_those_that_two_digits_name_are_written_again() {
        let mut field: Vec<String> = (0..1300).map(|n: u32| n.to_string()).collect();
        field.extend(["1295", "1299"].map(String::from));
        let (words, cells) = packed(&field);
        assert!(cells.ends_with("!zz!"), "{}", &cells[cells.len() - 8..]);
        assert_eq!(words.split('|').count(), cells.matches('!').count());
    }
}
