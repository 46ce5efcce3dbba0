//! The text files of the repository; of Rust files the code too, with comments and literals blanked out, so that a rule sees code only.

use std::fmt::Display;
use std::ops::Range;

use crate::prelude::*;

/// A text file, its code when it is Rust, and which of its lines are tests.
#[derive(Debug)]
pub struct Source {
    /// Relative to the root, with `/`.
    pub path: String,
    /// The whole content.
    pub text: String,
    /// The same text with the insides of comments, strings and characters replaced by spaces; lines are kept. Empty unless it is Rust.
    pub code: String,
    /// For each line, whether it belongs to tests.
    is_test: Vec<bool>,
}

/// Reads every file that is text; binary files (fonts, archives) have no rules here. Files that another declares as tests are marked so.
pub fn read(paths: &[String]) -> Result<Vec<Source>> {
    let mut sources = Vec::new();
    for path in paths {
        let place = root().join(path);
        let text = String::from_utf8(fs::read(&place).map_err(at(&place))?);
        sources.extend(text.ok().map(|text| Source::new(path, text)));
    }
    let tests: BTreeSet<String> = sources.iter().flat_map(Source::test_modules).collect();
    for source in sources.iter_mut().filter(|source| tests.contains(&source.path)) {
        source.is_test.fill(true);
    }
    Ok(sources)
}

impl Source {
    /// Blanks comments and literals and finds the tests.
    pub fn new(path: &str, text: impl Into<String>) -> Self {
        let text = text.into();
        let code = if path.ends_with(".rs") { blank(&text) } else { String::new() };
        let is_test = test_lines(path, &code);
        Self { path: path.to_owned(), text, code, is_test }
    }

    /// Whether this is a file of Rust.
    pub fn is_rust(&self) -> bool {
        self.path.ends_with(".rs")
    }

    /// A complaint about one line of this file, counted from 1; 0 is the file as a whole.
    pub fn complaint(&self, line: usize, message: impl Display) -> String {
        let place = if line == 0 { String::new() } else { format!(":{line}") };
        format!("{}{place}: {message}", self.path)
    }

    /// The paths that this file's `#[cfg(test)] mod name;` declarations may mean.
    fn test_modules(&self) -> Vec<String> {
        let path = self.path.as_str();
        let (folder, name) = path.rsplit_once('/').unwrap_or(("", path));
        let folder = match name {
            "mod.rs" | "lib.rs" | "main.rs" => folder.to_string(),
            name => format!("{folder}/{}", name.trim_end_matches(".rs")),
        };
        let items = test_items(&self.code).map(|item| &self.code[item]);
        let declared = items.filter_map(|item| Some(item.rsplit_once("mod ")?.1.trim_end()));
        declared.flat_map(|name| [format!("{folder}/{name}.rs"), format!("{folder}/{name}/mod.rs")]).collect()
    }

    /// Number (from 1), code and original text of each line.
    pub fn lines(&self) -> impl Iterator<Item = (usize, &str, &str)> {
        self.code.lines().zip(self.text.lines()).enumerate().map(|(n, (code, text))| (n + 1, code, text))
    }

    /// The comments and strings of a Rust file, which are blank in its code.
    pub fn words(&self) -> String {
        let kept = |(code, text): (char, char)| if code.is_whitespace() { text } else { ' ' };
        self.code.chars().zip(self.text.chars()).map(kept).collect()
    }

    /// Whether a line (from 1) belongs to tests.
    pub fn is_test_line(&self, number: usize) -> bool {
        self.is_test.get(number - 1).copied().unwrap_or(false)
    }
}

/// Byte positions of a word, where neither neighbour continues an identifier of the word. A `*` at an end permits any neighbour there; a
/// `0` at the end stands for a number.
pub fn word_positions<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = usize> + 'a {
    let (fixed, has_number) = (word.trim_matches(['*', '0']), word.contains('0'));
    text.match_indices(fixed).map(|(position, _)| position).filter(move |position| {
        let (before, after) = (&text[..*position], &text[position + fixed.len()..]);
        let rest = after.trim_start_matches(|c: char| has_number && c.is_ascii_digit());
        let (begins_inside, ends_inside) = (before.ends_with(is_part), rest.starts_with(is_part));
        let is_whole =
            !(begins_inside && word.starts_with(is_part) || ends_inside && word.ends_with(is_part));
        is_whole && has_number == (rest.len() < after.len())
    })
}

fn is_part(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn test_lines(path: &str, code: &str) -> Vec<bool> {
    let whole_file = ["tests/", "benches/", "/tests.rs", "/tests/"].iter().any(|part| path.contains(part));
    let mut flags = vec![whole_file; code.lines().count()];
    for item in test_items(code) {
        let (first, last) = (line_at(code, item.start), line_at(code, item.end));
        flags.iter_mut().take(last).skip(first - 1).for_each(|flag| *flag = true);
    }
    flags
}

/// The line (from 1) that holds a byte position of a text.
pub fn line_at(text: &str, position: usize) -> usize {
    text[..position].matches('\n').count() + 1
}

/// The items that are for tests, without their last character.
fn test_items(code: &str) -> impl Iterator<Item = Range<usize>> {
    let starts = code.match_indices("#[cfg(test)]").map(|(start, _)| start);
    starts.map(|start| start..item_end(code, start))
}

/// Where the item that begins at `start` ends: at its closing brace, or at a semicolon before any brace.
fn item_end(code: &str, start: usize) -> usize {
    let mut depth = 0;
    let is_end = |c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth <= 0 && c == '}' || depth == 0 && c == ';'
    };
    code[start..].find(is_end).map_or(code.len(), |offset| start + offset)
}

/// Replaces comments and the insides of literals by spaces, keeping line breaks.
fn blank(text: &str) -> String {
    let (mut code, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(first) = rest.chars().next() {
        let length = literal_length(rest, code.ends_with(is_part));
        if length == 0 {
            code.push(first);
            rest = &rest[first.len_utf8()..];
        } else {
            code.extend(rest[..length].chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
            rest = &rest[length..];
        }
    }
    code
}

/// The length in bytes of the comment or literal that `rest` begins with; 0 without any. A word's last letters begin none.
fn literal_length(rest: &str, is_inside_word: bool) -> usize {
    match rest.as_bytes() {
        [b'/', b'/', ..] => rest.find('\n').unwrap_or(rest.len()),
        [b'/', b'*', ..] => comment_length(rest, ["/*", "*/"]),
        [b'"', ..] => quoted_length(rest, '"'),
        [b'\'', b'\\', ..] => quoted_length(rest, '\''),
        // A lifetime has no second quotation mark.
        [b'\'', ..] if rest.chars().nth(2) == Some('\'') => quoted_length(rest, '\''),
        [b'b' | b'c' | b'r', ..] if !is_inside_word => raw_length(rest).unwrap_or(0),
        _ => 0,
    }
}

/// The length in bytes of the raw string that `rest` begins with, such as `r#"…"#`.
fn raw_length(rest: &str) -> Option<usize> {
    let raw = ["br", "cr", "r"].iter().find_map(|prefix| rest.strip_prefix(prefix))?;
    let inside = raw.trim_start_matches('#').strip_prefix('"')?;
    let close = format!("\"{}", "#".repeat(raw.len() - inside.len() - 1));
    Some(inside.find(&close).map_or(rest.len(), |end| rest.len() - inside.len() + end + close.len()))
}

/// The length in bytes of the comment that `rest` begins with, which may hold others.
pub fn comment_length(rest: &str, [open, close]: [&str; 2]) -> usize {
    let (mut depth, mut inside) = (0, rest);
    while let Some(at) = [open, close].iter().filter_map(|mark| inside.find(mark)).min() {
        depth += if inside[at..].starts_with(open) { 1 } else { -1 };
        inside = &inside[at + open.len()..];
        if depth == 0 {
            return rest.len() - inside.len();
        }
    }
    rest.len()
}

fn quoted_length(rest: &str, quote: char) -> usize {
    let is_escaped = |before: &str| (before.len() - before.trim_end_matches('\\').len()) % 2 == 1;
    let mut quotes = rest.match_indices(quote).map(|(at, _)| at).skip(1);
    quotes.find(|at| !is_escaped(&rest[..*at])).map_or(rest.len(), |at| at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_literals_are_blanked_and_lines_kept() {
        let text = "a // b\n/* c /* d */\n e */ f(\"g\\\"h\", 'i', '\\'', r#\"j\"k\"#) &'l m";
        let code = blank(text);
        let kept: String = code.chars().filter(|c| c.is_alphanumeric()).collect();
        assert_eq!(kept, "aflm");
        assert_eq!(code.lines().count(), 3);
    }

    #[test]
    fn test_modules_end_at_their_brace() {
        let text = "fn a() {}\n#[cfg(test)]\nmod tests {\n  fn b() {}\n}\nfn c() {}\n#[cfg(test)]\nmod more;\nfn d() {}\n";
        let source = Source::new("src/x.rs", text);
        let outside: Vec<usize> = (1..=9).filter(|number| !source.is_test_line(*number)).collect();
        assert_eq!(outside, [1, 6, 9]);
    }

    #[test]
    fn a_file_may_be_declared_as_tests_by_its_parent() {
        let text = "#[cfg(test)]\npub(crate) mod sample;\nmod other;\n#[cfg(test)]\nmod tests { mod x; }\n";
        let found = Source::new("src/plot/mod.rs", text).test_modules();
        assert_eq!(found[..2], ["src/plot/sample.rs", "src/plot/sample/mod.rs"]);
        assert!(!found.iter().any(|path| path.contains("other")));
    }

    #[test]
    fn words_are_whole_identifiers() {
        assert_eq!(word_positions("f64 xf64 f64x f64", "f64").collect::<Vec<_>>(), [0, 14]);
        assert_eq!(word_positions("eq 8 eq 15, eq x, eq 8b, seq 8", "eq 0").collect::<Vec<_>>(), [0, 5]);
        assert_eq!(word_positions("eq 8 eq 15, eq x, eq 8b, seq 8", "eq 0*").collect::<Vec<_>>(), [0, 5, 18]);
        assert_eq!(word_positions("seq eqs", "*eq*").collect::<Vec<_>>(), [1, 4]);
    }
}
