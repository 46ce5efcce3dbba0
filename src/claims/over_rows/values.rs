//! The rows of a table as numbers with their estimated errors.

use std::collections::BTreeMap;

use slipmode_algebra::Symbol;
use slipmode_core::number::{Ball, Rational, parse_decimal};
use slipmode_plot::table::{Cell, Column, Kind, Table};

use super::arithmetic::{BITS, around};
use super::statement::placeholder;
use crate::claims::Strength;

/// A row: what is known of each column.
#[derive(Debug, Default, Clone)]
pub(super) struct Row {
    /// The value of each column that has one, as wide as its error; words are numbered.
    pub values: BTreeMap<Symbol, Ball>,
    /// How sure each value is.
    pub strengths: BTreeMap<Symbol, Strength>,
    /// The columns with an estimated error.
    pub estimated: Vec<Symbol>,
}

impl Row {
    /// Whether a column has an empty cell here.
    pub fn is_empty(&self, column: &Symbol) -> bool {
        !self.strengths.contains_key(column)
    }
}

/// The column with the estimated error of another: `peak_relative_error` belongs to every column whose name begins with `peak_`, and so do
/// `…_error_dex` to the columns in dex and `…_error` to any.
fn error_of(column: &Column, table: &Table) -> Option<(usize, bool)> {
    let endings = [("_relative_error", "", true), ("_error_dex", "_dex", false), ("_error", "", false)];
    table.columns.iter().enumerate().find_map(|(at, error)| {
        endings.iter().find_map(|(suffix, ending, is_relative)| {
            let rest = column.name.strip_prefix(error.name.strip_suffix(suffix)?)?.strip_prefix('_')?;
            (!rest.contains("error") && column.name.ends_with(ending)).then_some((at, *is_relative))
        })
    })
}

/// The rows of a table; the quoted words have the first numbers.
pub(super) fn rows(table: &Table, quoted: &[String]) -> Vec<Row> {
    let errors: Vec<Option<(usize, bool)>> =
        table.columns.iter().map(|column| error_of(column, table)).collect();
    let mut words = BTreeMap::new();
    let placeholders = quoted
        .iter()
        .enumerate()
        .filter_map(|(number, word)| Some((placeholder(number).parse().ok()?, numbered(word, &mut words))));
    let start = Row { values: placeholders.collect(), ..Row::default() };
    let row = |cells: &Vec<Cell>| {
        let mut row = start.clone();
        let of_words = strength_of_words(cells, &errors);
        for ((column, cell), error) in table.columns.iter().zip(cells).zip(&errors) {
            let Ok(name) = column.name.parse::<Symbol>() else { continue };
            if cell.text.is_empty() {
                row.values.extend((column.kind == Kind::Text).then(|| (name, numbered("", &mut words))));
                continue;
            }
            let (value, strength) = match column.kind {
                Kind::Text => (numbered(&cell.text, &mut words), of_words),
                Kind::Number => {
                    let Some((value, strength)) =
                        number(cell, error.map(|(at, relative)| (&cells[at], relative)))
                    else {
                        continue;
                    };
                    if strength == Strength::Converged {
                        row.estimated.push(name.clone());
                    }
                    (value, strength)
                }
            };
            row.values.insert(name.clone(), value);
            row.strengths.insert(name, strength);
        }
        row
    };
    table.rows.iter().map(row).collect()
}

/// A word's number.
fn numbered(word: &str, words: &mut BTreeMap<String, usize>) -> Ball {
    let next = words.len();
    Ball::from_rational(&Rational::from(*words.entry(word.to_owned()).or_insert(next)), BITS)
}

/// The words of a row are as sure as its numbers: with an error estimate, or with certain digits only.
fn strength_of_words(cells: &[Cell], errors: &[Option<(usize, bool)>]) -> Strength {
    let mut numbers =
        cells.iter().filter(|cell| cell.kind == Kind::Number && !cell.text.is_empty()).peekable();
    if errors.iter().flatten().any(|(at, _)| !cells[*at].text.is_empty()) {
        Strength::Converged
    } else if numbers.peek().is_some() && numbers.all(|cell| cell.is_certain) {
        Strength::Certified
    } else {
        Strength::Sampled
    }
}

/// A number with its estimated error and that of its rounding, and how sure it is.
fn number(cell: &Cell, error: Option<(&Cell, bool)>) -> Option<(Ball, Strength)> {
    let value = parse_decimal(&cell.text).ok()?;
    let size = Rational::from(value.abs_ref());
    let rounding = cell.digits.and_then(|digits| parse_decimal(&format!("5e-{digits}")).ok());
    let rounding = rounding.unwrap_or_default() * &size;
    let stated = error.and_then(|(error, is_relative)| {
        let error = parse_decimal(&error.text).ok()?;
        Some(if is_relative { error * &size } else { error })
    });
    let strength = match (cell.is_certain, &stated) {
        (true, _) => Strength::Certified,
        (false, Some(_)) => Strength::Converged,
        (false, None) => Strength::Sampled,
    };
    Some((around(&value, &(rounding + stated.unwrap_or_default())), strength))
}
