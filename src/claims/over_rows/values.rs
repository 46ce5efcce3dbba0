//! The rows of a table as numbers with their estimated errors, and what certificates prove of them.

use std::collections::BTreeMap;

use slipmode_algebra::Symbol;
use slipmode_core::number::{Ball, Rational, parse_decimal};
use slipmode_plot::table::{Cell, Column, Kind, Table};

use super::arithmetic::{BITS, around};
use super::statement::{RowStatement, placeholder};
use crate::claims::Strength;

/// A row: what is known of each column.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// The value of each column that has one, as wide as its error; words are numbered, the empty one too.
    pub values: BTreeMap<Symbol, Ball>,
    /// How sure each value is.
    pub strengths: BTreeMap<Symbol, Strength>,
    /// The numbers that name the row, as they are shown.
    pub names: BTreeMap<Symbol, Ball>,
    /// How sure it is that an empty cell has nothing to hold.
    pub of_words: Strength,
    /// Whether the row has no result: then no cell that is empty tells anything.
    pub has_failed: bool,
}

impl Row {
    /// A row of which only the quoted words are known.
    fn start(values: BTreeMap<Symbol, Ball>, table: &Table, cells: &[Cell], beside: &[Beside]) -> Self {
        let mut columns = table.columns.iter().zip(cells);
        let has_failed = columns.any(|(column, cell)| column.name == FAILURE && !cell.text.is_empty());
        let of_words = strength_of_words(cells, beside);
        Self { values, strengths: BTreeMap::new(), names: BTreeMap::new(), of_words, has_failed }
    }

    /// Whether a column has an empty cell here.
    pub fn is_empty(&self, column: &Symbol) -> bool {
        !self.strengths.contains_key(column)
    }

    /// How sure the value of a column is, or that it has none.
    pub fn strength(&self, column: &Symbol) -> Strength {
        self.strengths.get(column).copied().unwrap_or(self.of_words)
    }
}

/// The column with the reason why a row has no result.
const FAILURE: &str = "failure";

/// The column of the estimated error of another.
pub(super) fn error_column(name: &str, table: &Table) -> Option<usize> {
    Beside::of(name, table).error.map(|(at, _)| at)
}

/// What other columns say of one: its estimated error, and what is proved of it.
struct Beside {
    /// The column of the error, and whether the error is relative.
    error: Option<(usize, bool)>,
    /// The columns of the two ends of an enclosure.
    ends: Option<[usize; 2]>,
    /// The column of the word that is proved.
    proved: Option<usize>,
}

impl Beside {
    /// `peak_relative_error` is the error of every column whose name begins with `peak_`, and so is `…_error_dex` of the columns in
    /// dex and `…_error` of any. `period_s_low`, `period_s_high` and `cycle_proved` are about the columns `period_s` and `cycle`.
    fn of(name: &str, table: &Table) -> Self {
        let endings = [("_relative_error", "", true), ("_error_dex", "_dex", false), ("_error", "", false)];
        let find = |ending: &str| {
            table.columns.iter().position(|other| other.name.strip_suffix(ending) == Some(name))
        };
        let error = table.columns.iter().enumerate().find_map(|(at, error)| {
            endings.iter().find_map(|(suffix, ending, is_relative)| {
                let rest = name.strip_prefix(error.name.strip_suffix(suffix)?)?.strip_prefix('_')?;
                (!rest.contains("error") && name.ends_with(ending)).then_some((at, *is_relative))
            })
        });
        Self { error, ends: find("_low").zip(find("_high")).map(Into::into), proved: find("_proved") }
    }
}

/// The rows of a table with the columns that a statement names; the quoted words have the first numbers.
///
/// # Errors
/// Which row contradicts what is proved of it, in whatever column.
pub(super) fn rows(table: &Table, statement: &RowStatement) -> Result<Vec<Row>, String> {
    let beside: Vec<Beside> = table.columns.iter().map(|column| Beside::of(&column.name, table)).collect();
    let named = statement.names(true);
    let columns = table.columns.iter().enumerate();
    let columns = columns.filter_map(|(at, column)| Some((at, column, column.name.parse::<Symbol>().ok()?)));
    let is_proved = |beside: &Beside| beside.ends.is_some() || beside.proved.is_some();
    let is_read = |(at, _, name): &(usize, &Column, Symbol)| named.contains(name) || is_proved(&beside[*at]);
    let columns: Vec<_> = columns.filter(is_read).collect();
    let mut words = BTreeMap::new();
    let placeholders =
        statement.words.iter().enumerate().filter_map(|(number, word)| {
            Some((placeholder(number).parse().ok()?, numbered(word, &mut words)))
        });
    let start: BTreeMap<Symbol, Ball> = placeholders.collect();
    let row = |cells: &Vec<Cell>| {
        let mut row = Row::start(start.clone(), table, cells, &beside);
        for (at, column, name) in &columns {
            let cell = &cells[*at];
            let found = match column.kind {
                Kind::Text => word(cell, &beside[*at], cells, row.of_words)
                    .map(|found| found.map(|(word, strength)| (numbered(word, &mut words), strength))),
                Kind::Number => number(cell, &beside[*at], cells),
            };
            let found = found.ok_or_else(|| contradiction(table, cells))?;
            let Some((value, strength)) = found else {
                if column.kind == Kind::Text && !row.has_failed {
                    row.values.insert(name.clone(), numbered("", &mut words));
                }
                continue;
            };
            let is_name = *at < table.names;
            let strength = if is_name { Strength::Certified } else { strength };
            let shown = parse_decimal(&cell.text).ok().filter(|_| is_name);
            row.names.extend(shown.map(|shown| (name.clone(), Ball::from_rational(&shown, BITS))));
            row.values.insert(name.clone(), value);
            row.strengths.insert(name.clone(), strength);
        }
        Ok(row)
    };
    table.rows.iter().map(row).collect()
}

/// Which row contradicts what is proved of it.
fn contradiction(table: &Table, cells: &[Cell]) -> String {
    let names = table.columns.iter().zip(cells).take(table.names.max(1));
    let place: Vec<String> = names.map(|(column, cell)| format!("{} = {}", column.name, cell.text)).collect();
    let place = place.join(", ");
    format!("The run at {place} differs from its certificate by more than its estimated error.")
}

/// A word's number.
fn numbered(word: &str, words: &mut BTreeMap<String, usize>) -> Ball {
    let next = words.len();
    Ball::from_rational(&Rational::from(*words.entry(word.to_owned()).or_insert(next)), BITS)
}

/// The words of a row are as sure as its numbers: with an error estimate, or with certain digits only.
fn strength_of_words(cells: &[Cell], beside: &[Beside]) -> Strength {
    let mut numbers =
        cells.iter().filter(|cell| cell.kind == Kind::Number && !cell.text.is_empty()).peekable();
    if beside.iter().filter_map(|beside| beside.error).any(|(at, _)| !cells[at].text.is_empty()) {
        Strength::Converged
    } else if numbers.peek().is_some() && numbers.all(|cell| cell.is_certain) {
        Strength::Certified
    } else {
        Strength::Sampled
    }
}

/// What is known where a cell may hold nothing; the outer none where the cell contradicts what is proved.
type Known<T> = Option<Option<(T, Strength)>>;

/// The word of a cell, or the one that is proved.
fn word<'c>(cell: &'c Cell, beside: &Beside, cells: &'c [Cell], strength: Strength) -> Known<&'c str> {
    let found = Some(cell.text.as_str()).filter(|text| !text.is_empty());
    let proved = beside.proved.map(|at| cells[at].text.as_str()).filter(|text| !text.is_empty());
    match (found, proved) {
        (Some(found), Some(proved)) if found != proved => None,
        (_, Some(proved)) => Some(Some((proved, Strength::Certified))),
        (found, None) => Some(found.map(|found| (found, strength))),
    }
}

/// The number of a cell with its errors, or its enclosure.
fn number(cell: &Cell, beside: &Beside, cells: &[Cell]) -> Known<Ball> {
    let found = estimated(cell, beside.error.map(|(at, relative)| (&cells[at], relative)));
    let ends = beside.ends.map(|ends| ends.map(|at| parse_decimal(&cells[at].text).ok()));
    let Some([Some(low), Some(high)]) = ends else { return Some(found) };
    let [middle, half] = [Rational::from(&low + &high) / 2u32, Rational::from(&high - &low) / 2u32];
    let proved = around(&middle, &half);
    let contradicts =
        |(found, _): &(Ball, Strength)| (found.clone() - &proved).sign().is_some_and(|sign| sign.is_ne());
    match found.as_ref().is_some_and(contradicts) {
        true => None,
        false => Some(Some((proved, Strength::Certified))),
    }
}

/// A number with its estimated error and that of its rounding, and how sure it is; none where its error is not known.
fn estimated(cell: &Cell, error: Option<(&Cell, bool)>) -> Option<(Ball, Strength)> {
    let value = parse_decimal(&cell.text).ok()?;
    let size = Rational::from(value.abs_ref());
    let rounding = cell.digits.and_then(|digits| parse_decimal(&format!("5e-{digits}")).ok());
    let rounding = rounding.unwrap_or_default() * &size;
    let stated = match error.filter(|_| !cell.is_certain) {
        None => None,
        Some((error, is_relative)) => {
            let error = parse_decimal(&error.text).ok()?;
            Some(if is_relative { error * &size } else { error })
        }
    };
    let strength = match (cell.is_certain, &stated) {
        (true, _) => Strength::Certified,
        (false, Some(_)) => Strength::Converged,
        (false, None) => Strength::Sampled,
    };
    Some((around(&value, &(rounding + stated.unwrap_or_default())), strength))
}
