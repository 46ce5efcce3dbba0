//! The grammar of statements over the rows of a table.
//!
//! ```text
//! statement := 'for every row' ['where' condition] ':' condition
//!            | 'count' ['where' condition] comparison number
//!            | 'correlation of' side 'with' side [group] comparison number ['where' condition]
//!            | ('least' | 'largest') side 'at' side '=' number 'within' number [group] ['where' condition]
//!            | side 'agrees with' side 'within' number ['where' condition]
//!            | side ('rises' | 'falls') 'with' side [group] ['where' condition]
//! group     := 'at each' column (',' column)*
//! ```
//! A side is an expression in the names of the table's columns, and a condition a formula in them. A word in single quotes is compared
//! with a column of words; `''` is an empty cell.

use std::collections::BTreeSet;

use slipmode_algebra::{Comparison, Expression, Function, Source, Symbol};
use slipmode_core::number::{Rational, parse_decimal};

use crate::scene::{Formula, Names, nearest};
use slipmode_plot::table::{Column, Kind};

/// A statement and the rows that it is about.
#[derive(Debug, Clone)]
pub(super) struct RowStatement {
    pub form: Form,
    /// The rows that it is about: all, without a condition.
    pub selected: Formula,
    /// The columns whose cells divide the rows into groups.
    pub groups: Vec<String>,
    /// The words in quotes, by the number in their placeholder.
    pub words: Vec<String>,
}

/// What is said of the rows.
#[derive(Debug, Clone)]
pub(super) enum Form {
    /// The condition is true in every row.
    Every(Formula),
    /// The number of rows compares so with a number.
    Count(Comparison, Rational),
    /// Pearson's correlation of two values, in each group of rows, compares so with a number.
    Correlation([Expression; 2], Comparison, Rational),
    /// In each group, the row with the least (or largest) value has another value within a distance of a number.
    Extreme { least: bool, of: Expression, at: Expression, place: [Rational; 2] },
    /// In each group, between neighbours in the order of the second value, the first one rises (or falls).
    Trend { rises: bool, sides: [Expression; 2] },
}

impl RowStatement {
    /// The comparisons in its conditions.
    fn comparisons(&self) -> impl Iterator<Item = (&Expression, Comparison, &Expression)> {
        let claimed = match &self.form {
            Form::Every(claimed) => comparisons(claimed),
            _ => Vec::new(),
        };
        comparisons(&self.selected).into_iter().chain(claimed)
    }

    /// Its expressions outside conditions.
    fn sides(&self) -> Vec<&Expression> {
        match &self.form {
            Form::Every(_) | Form::Count(..) => Vec::new(),
            Form::Correlation(sides, ..) | Form::Trend { sides, .. } => sides.iter().collect(),
            Form::Extreme { of, at, .. } => vec![of, at],
        }
    }

    /// The columns that it names, with what stands for words.
    pub fn names(&self) -> BTreeSet<Symbol> {
        let compared = self.comparisons().flat_map(|(left, _, right)| [left, right]);
        compared.chain(self.sides()).flat_map(Expression::variables).collect()
    }

    /// The column that is compared with `''`.
    pub fn compared_with_nothing<'e>(&self, sides: [&'e Expression; 2]) -> Option<&'e Symbol> {
        let [Expression::Variable(column), Expression::Variable(word)] = sides else { return None };
        let number = word.as_str().strip_prefix(PLACEHOLDER)?.parse::<usize>().ok()?;
        self.words.get(number)?.is_empty().then_some(column)
    }

    /// Words are compared as a whole: they stand alone on a side of = or !=, and a number is compared with the empty word only.
    fn check_words(self, columns: &[Column]) -> Result<Self, String> {
        let is_word = |name: &Symbol| {
            let of_words = |column: &Column| column.name == name.as_str() && column.kind == Kind::Text;
            name.as_str().starts_with(PLACEHOLDER) || columns.iter().any(of_words)
        };
        let lone = |side: &Expression| matches!(side, Expression::Variable(name) if is_word(name));
        let numbers = self.comparisons().filter(|(left, comparison, right)| {
            let whole = lone(left) && lone(right) || self.compared_with_nothing([left, right]).is_some();
            !(whole && matches!(comparison, Comparison::Equal | Comparison::Unequal))
        });
        let numbers = numbers.flat_map(|(left, _, right)| [left, right]).chain(self.sides());
        let word = numbers.flat_map(Expression::variables).find(is_word);
        match word {
            Some(word) if word.as_str().starts_with(PLACEHOLDER) => {
                Err("a word in quotes is compared with a column of words, by = or !=".into())
            }
            Some(word) => Err(format!(
                "`{word}` is a column of words: compare it with a word in single quotes, by = or !="
            )),
            None => Ok(self),
        }
    }
}

fn comparisons(formula: &Formula) -> Vec<(&Expression, Comparison, &Expression)> {
    match formula {
        Formula::Compare(left, comparison, right) => vec![(left, *comparison, right)],
        Formula::Not(inner) => comparisons(inner),
        Formula::All(parts) | Formula::Any(parts) => parts.iter().flat_map(comparisons).collect(),
        Formula::Implies(parts) | Formula::Iff(parts) => parts.iter().flat_map(comparisons).collect(),
        Formula::Roots(..) | Formula::Crossing(_) => Vec::new(),
    }
}

/// How the names that stand for quoted words begin.
const PLACEHOLDER: &str = "quoted_word_";

/// What stands for the quoted word of this number in expressions.
pub(super) fn placeholder(number: usize) -> String {
    format!("{PLACEHOLDER}{number}")
}

const FORMS: &str = "a statement over rows is `for every row: …`, `count … = n`, `correlation of x with y … > r`, `least y at x = v within d`, \
                     `x agrees with y within d`, `x rises with y` or `x falls with y`";

/// Reads a statement in the names of columns.
///
/// # Errors
/// What is wrong with it, with the nearest known column for an unknown one.
pub(super) fn read(text: &str, columns: &[Column]) -> Result<RowStatement, String> {
    let (text, words) = without_quotes(text)?;
    let placeholders: Vec<String> = (0..words.len()).map(placeholder).collect();
    let known = columns.iter().map(|column| column.name.as_str());
    let names = Names::plain(known.clone().chain(placeholders.iter().map(String::as_str)));
    let mut reader = Reader { columns: known.collect(), names, groups: Vec::new() };
    let (form, selected) = reader.statement(text.trim())?;
    RowStatement { form, selected, groups: reader.groups, words }.check_words(columns)
}

/// The text with a placeholder for each word in single quotes, and the words.
fn without_quotes(text: &str) -> Result<(String, Vec<String>), String> {
    let mut words = Vec::new();
    let mut found = String::new();
    for (number, piece) in text.split('\'').enumerate() {
        if number % 2 == 0 {
            found += piece;
            continue;
        }
        found += &placeholder(words.len());
        words.push(piece.to_owned());
    }
    match text.matches('\'').count() % 2 {
        0 => Ok((found, words)),
        _ => Err("a quote ' is not closed".into()),
    }
}

struct Reader<'c> {
    columns: Vec<&'c str>,
    names: Names,
    groups: Vec<String>,
}

impl Reader<'_> {
    fn statement(&mut self, text: &str) -> Result<(Form, Formula), String> {
        if let Some(rest) = text.strip_prefix("for every row") {
            let (selected, claimed) = rest.split_once(':').ok_or("`for every row` needs a ':'")?;
            let selected = selected.trim();
            let selected = match selected.strip_prefix("where ") {
                Some(condition) => self.condition(condition)?,
                None if selected.is_empty() => all(),
                None => return Err(format!("'{selected}': expected `where` or ':'")),
            };
            return Ok((Form::Every(self.condition(claimed)?), selected));
        }
        if let Some(rest) = text.strip_prefix("count ") {
            let (condition, comparison, number) = compared(rest)?;
            let selected = match condition.trim() {
                "" => all(),
                condition => {
                    self.condition(condition.strip_prefix("where ").ok_or("`count` needs `where`")?)?
                }
            };
            return Ok((Form::Count(comparison, number), selected));
        }
        let (text, selected) = match text.split_once(" where ") {
            Some((text, condition)) => (text, self.condition(condition)?),
            None => (text, all()),
        };
        Ok((self.form(text)?, selected))
    }

    fn form(&mut self, text: &str) -> Result<Form, String> {
        if let Some((one, rest)) = text.split_once(" agrees with ") {
            let (other, distance) = rest.split_once(" within ").ok_or("`agrees with` needs `within`")?;
            let (one, other) = (self.side(one)?, self.side(other)?);
            let allowed = Expression::Number(number(distance)?) * other.clone().call(Function::Abs);
            let difference = (one - other).call(Function::Abs);
            return Ok(Form::Every(Formula::Compare(difference, Comparison::AtMost, allowed)));
        }
        if let Some(rest) = text.strip_prefix("correlation of ") {
            let (rest, comparison, number) = compared(rest)?;
            let rest = self.without_groups(rest)?;
            let (one, other) = rest.split_once(" with ").ok_or("`correlation of` needs `with`")?;
            return Ok(Form::Correlation([self.side(one)?, self.side(other)?], comparison, number));
        }
        for (word, least) in [("least ", true), ("largest ", false)] {
            let Some(rest) = text.strip_prefix(word) else { continue };
            let rest = self.without_groups(rest)?;
            let form = "the form is `least y at x = v within d`";
            let (rest, distance) = rest.split_once(" within ").ok_or(form)?;
            let (of, rest) = rest.split_once(" at ").ok_or(form)?;
            let (at, place) = rest.split_once('=').ok_or(form)?;
            let place = [number(place)?, number(distance)?];
            return Ok(Form::Extreme { least, of: self.side(of)?, at: self.side(at)?, place });
        }
        for (word, rises) in [(" rises with ", true), (" falls with ", false)] {
            let Some((of, rest)) = text.split_once(word) else { continue };
            let with = self.without_groups(rest)?;
            return Ok(Form::Trend { rises, sides: [self.side(of)?, self.side(with)?] });
        }
        Err(FORMS.into())
    }

    /// The text before `at each`; the columns after it are kept.
    fn without_groups<'t>(&mut self, text: &'t str) -> Result<&'t str, String> {
        let Some((text, list)) = text.split_once(" at each ") else { return Ok(text) };
        for name in list.split(',').map(str::trim) {
            if !self.columns.contains(&name) {
                return Err(self.unknown(name));
            }
            self.groups.push(name.to_owned());
        }
        Ok(text)
    }

    fn condition(&self, text: &str) -> Result<Formula, String> {
        self.known(text)?;
        Formula::read(text.trim(), &self.names)
    }

    fn side(&self, text: &str) -> Result<Expression, String> {
        self.known(text)?;
        let (expression, _) = Expression::read(text.trim()).map_err(|error| format!("'{text}': {error}"))?;
        Ok(expression)
    }

    /// Names what is no column before the grammar of formulas does: it knows no tables.
    fn known(&self, text: &str) -> Result<(), String> {
        let in_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let is_name = |word: &&str| word.starts_with(|c: char| c.is_ascii_alphabetic());
        let words = text.split(|c| !in_name(c)).filter(is_name);
        let grammar = ["and", "or", "not", "implies", "iff", "abs", "sqrt"];
        let mut unknown = words.filter(|word| {
            !grammar.contains(word) && !self.columns.contains(word) && !word.starts_with(PLACEHOLDER)
        });
        unknown.next().map_or(Ok(()), |word| Err(self.unknown(word)))
    }

    fn unknown(&self, name: &str) -> String {
        let near = nearest(name, self.columns.iter().copied());
        let near = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        format!("'{name}' is no column of the table{near} (columns: {})", self.columns.join(", "))
    }
}

/// True in every row.
fn all() -> Formula {
    Formula::All(Vec::new())
}

/// What stands before the last comparison of a text, the comparison, and the number after it.
fn compared(text: &str) -> Result<(&str, Comparison, Rational), String> {
    let last = Source::comparisons(text).pop();
    let (before, comparison, after) =
        last.ok_or_else(|| format!("'{text}' needs a comparison with a number"))?;
    Ok((before, comparison, number(after)?))
}

fn number(text: &str) -> Result<Rational, String> {
    parse_decimal(text.trim()).map_err(|error| format!("'{}' is no number: {error}", text.trim()))
}
