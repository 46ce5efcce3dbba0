//! What a command answers, each thing stated once: text for people, one JSON object for programs, cells of a CSV row.

use std::path::Path;

use serde::Serialize;
use serde_json::{Map, Value, json};
use slipmode::csv::Column;
use slipmode_core::number::format::{round_digits, round_float, shortest};
use slipmode_core::number::{Rational, Wide};

use crate::cli::failure::Failure;
use crate::cli::output::is_stream;
use crate::cli::terminal;

/// Significant digits of a value in the text for people.
pub const SHOWN_DIGITS: usize = 6;

/// Holds an answer, or a part of one: the object of its keys, and its lines of text.
#[derive(Debug, Clone, Default)]
pub struct Answer {
    object: Map<String, Value>,
    text: String,
}

/// Holds a value as programs read it, and as people read it.
#[derive(Debug)]
pub struct Item {
    value: Value,
    text: String,
}

impl Answer {
    /// Starts an answer to a question with these inputs.
    pub fn to(inputs: impl Serialize) -> Self {
        Self::default().with("schema", terminal::SCHEMA).with("inputs", inputs)
    }

    /// Starts a part with one line of text.
    pub fn line(text: &str) -> Self {
        Self::default().text(&format!("{text}\n"))
    }

    /// Adds a value that text does not show.
    pub fn with(mut self, key: &str, value: impl Serialize) -> Self {
        self.object.insert(key.to_string(), json!(value));
        self
    }

    /// Adds text that has no key.
    pub fn text(mut self, text: &str) -> Self {
        self.text += text;
        self
    }

    /// Adds a value: its key, its name for people, and itself.
    pub fn item(self, key: &str, name: &str, item: impl Into<Item>) -> Self {
        let Item { value, text } = item.into();
        self.with(key, value).named(name, &text)
    }

    /// Adds a line of text with a name and a value.
    pub fn named(self, name: &str, value: &str) -> Self {
        let line = format!("{name:<26} {value}");
        self.text(line.trim_end()).text("\n")
    }

    /// Adds a remark to the last line of text: a meaning, an equation, or how sure the value is.
    pub fn note(mut self, note: &str) -> Self {
        if !note.is_empty() {
            self.text.truncate(self.text.trim_end_matches('\n').len());
            self.text += &format!("  {note}\n");
        }
        self
    }

    /// Adds parts: an array of their objects, and their lines.
    pub fn list(mut self, key: &str, parts: impl IntoIterator<Item = Self>) -> Self {
        let add = |part: Self| {
            self.text += &part.text;
            part.object
        };
        let objects: Vec<_> = parts.into_iter().map(add).collect();
        self.with(key, objects)
    }

    /// Adds a part under a key of its own.
    pub fn part(self, key: &str, part: Self) -> Self {
        self.with(key, part.object).text(&part.text)
    }

    /// Adds the keys and lines of another part.
    pub fn and(mut self, part: Self) -> Self {
        self.object.extend(part.object);
        self.text(&part.text)
    }

    /// Adds the columns of a result as keys.
    pub fn columns<T>(self, columns: &[Column<T>], result: &T) -> Self {
        columns.iter().fold(self, |answer, (name, cell)| answer.with(name, cell(result)))
    }

    /// Gives the object for programs.
    pub fn json(&self) -> Value {
        Value::Object(self.object.clone())
    }

    /// Gives the value of a key; null where there is none.
    pub fn value(&self, key: &str) -> &Value {
        self.object.get(key).unwrap_or(&Value::Null)
    }

    /// Prints the object, or the text.
    ///
    /// # Errors
    /// When standard output cannot be written.
    pub fn print(&self, as_json: bool) -> Result<(), Failure> {
        if as_json { terminal::print_json(&self.json()) } else { terminal::print(&self.text) }
    }

    /// Prints the object, or the text: on standard error where standard output has something else.
    ///
    /// # Errors
    /// As [`Self::print`].
    pub fn print_beside(&self, as_json: bool, output: Option<&Path>) -> Result<(), Failure> {
        if as_json || !output.is_some_and(is_stream) {
            return self.print(as_json);
        }
        terminal::message(self.text.trim_end());
        Ok(())
    }
}

/// Writes a value as a CSV cell: a range as it is typed as an input, with `inf` where it has no bound.
pub fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(ends) => {
            let end = |end: &Value| end.as_f64().map_or_else(|| "inf".to_string(), shortest);
            format!("[{}]", ends.iter().map(end).collect::<Vec<_>>().join(", "))
        }
        other => other.to_string(),
    }
}

/// Writes rows of numbers as CSV below a line of column names.
pub fn csv_of_numbers<const N: usize>(names: &str, rows: impl Iterator<Item = [f64; N]>) -> String {
    let line = |row: [f64; N]| format!("{}\n", row.map(shortest).join(","));
    format!("{names}\n{}", rows.map(line).collect::<String>())
}

impl Item {
    /// Pairs a value with its text.
    pub fn new(value: Value, text: String) -> Self {
        Self { value, text }
    }

    /// Adds a unit to the text.
    pub fn in_unit(mut self, unit: &str) -> Self {
        self.text += &format!(" {unit}");
        self
    }

    /// Rounds a number in the text, where its unit follows it; the text is a dash where there is no number.
    pub fn rounded(value: Option<f64>, unit: &str) -> Self {
        let shown = |value| format!("{}{unit}", round_digits(value, SHOWN_DIGITS));
        Self { value: json!(value), text: value.map_or_else(|| "-".into(), shown) }
    }
}

impl From<&str> for Item {
    fn from(word: &str) -> Self {
        Self { value: word.into(), text: word.to_string() }
    }
}

impl From<u64> for Item {
    fn from(count: u64) -> Self {
        Self { value: count.into(), text: count.to_string() }
    }
}

/// A positive sign is shown with its plus.
impl From<i8> for Item {
    fn from(sign: i8) -> Self {
        Self { value: sign.into(), text: if sign > 0 { format!("+{sign}") } else { sign.to_string() } }
    }
}

/// A number is shown with all its digits.
impl From<Wide> for Item {
    fn from(value: Wide) -> Self {
        Self { value: wide(value), text: value.to_string() }
    }
}

/// The value is the nearest number of 64 bits, and the text has fewer digits.
impl From<&Rational> for Item {
    fn from(value: &Rational) -> Self {
        let nearest = Wide::from_float(&rug::Float::with_val(53, value));
        Self { value: wide(nearest), text: round_float(&rug::Float::with_val(64, value), SHOWN_DIGITS) }
    }
}

/// What is absent is shown as a dash.
impl<T: Into<Item>> From<Option<T>> for Item {
    fn from(value: Option<T>) -> Self {
        value.map_or_else(|| Self { value: Value::Null, text: "-".into() }, Into::into)
    }
}

/// Gives a JSON number; a text beyond the range of 64-bit numbers, which JSON readers would turn into infinity or zero.
pub fn wide(value: Wide) -> Value {
    value.to_f64().map_or_else(|| json!(value.to_string()), |value| json!(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_stated_once_and_printed_as_text_and_as_object() {
        let part = |mode: &str| Answer::default().item("mode", "slip mode", mode).with("share", 0.5);
        let answer = Answer::to(json!({ "a": 1 }))
            .item("boundary_sign", "sign of discriminant", 1_i8)
            .note("(all roots real)")
            .item("frequency_hz", "frequency", Item::rounded(None, " Hz"))
            .note("")
            .list("slip_modes", [part("creep")])
            .part("groups", Answer::default().item("effect_ratio", "beta, b/a", &Rational::from((3, 2))));
        assert_eq!(
            answer.text,
            "sign of discriminant       +1  (all roots real)\nfrequency                  -\n\
             slip mode                  creep\nbeta, b/a                  1.5\n"
        );
        let wanted = json!({
            "schema": terminal::SCHEMA, "inputs": { "a": 1 }, "boundary_sign": 1, "frequency_hz": null,
            "slip_modes": [{ "mode": "creep", "share": 0.5 }], "groups": { "effect_ratio": 1.5 },
        });
        assert_eq!(answer.json(), wanted);
    }

    #[test]
    fn a_cell_is_a_value_as_it_is_typed_as_an_input() {
        for (value, wanted) in [
            (Value::Null, ""),
            (json!("1/3"), "1/3"),
            (json!([0.0, 1e-7]), "[0, 1e-7]"),
            (json!([2.5, null]), "[2.5, inf]"),
        ] {
            assert_eq!(cell(&value), wanted);
        }
    }
}
