//! The grammar of statements over the rows of a table.
//!
//! ```text
//! statement := 'for every row' ['where' condition] ':' condition
//!            | 'count' ['where' condition] comparison number
//!            | 'correlation of' side 'with' side [group] comparison number ['where' condition]
//!            | ('least' | 'largest') side 'at' side '=' number 'within' number [group] ['where' condition]
//!            | side 'agrees with' side 'within' (number | 'errors') ['where' condition]
//!            | side ('is near' | ('and' side)* 'are near') side ['where' condition]
//!            | 'between neighbours along' column ('and' column)* [group] ['where' condition] ':' change ('and' change)*
//!            | side ('rises' | 'falls') 'with' column [group] ['where' condition]
//! group     := 'at each' column (',' column)*
//! change    := side ('rises' | 'falls')
//! number    := ('least' | 'largest') side ['where' condition] ',' whole 'digits' [',' ('above' | 'below')]
//!            | 'count' ['where' condition]
//! ```
//! A side is an expression in the names of the table's columns, and a condition a formula in them. A word in single quotes is compared
//! with a column of words; `''` is an empty cell.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Comparison, Expression, Function, Source, Symbol};
use slipmode_core::number::format::Side;
use slipmode_core::number::{Ball, Rational, parse_decimal};

use super::arithmetic::BITS;
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
    /// The numbers that its sentences name.
    pub numbers: Vec<(String, Number)>,
}

/// A number and how it is written.
#[derive(Debug, Clone)]
pub(super) struct Number {
    pub what: What,
    /// The rows that it is about.
    pub selected: Formula,
}

/// What is computed.
#[derive(Debug, Clone)]
pub(super) enum What {
    /// How many rows there are.
    Count,
    /// The least (or largest) value, with this many digits, rounded to this side or else to nearest.
    Extreme { least: bool, of: Expression, digits: usize, side: Option<Side> },
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
    /// Two values differ by no more than their estimated errors in every row.
    Agrees([Expression; 2]),
    /// Values are near another one, as near as the kind of the sentence allows.
    Near(Vec<Expression>, Expression),
    /// Between neighbours along these columns, in each group of rows, each value rises (or falls).
    Neighbours { along: Vec<String>, changes: Vec<(Expression, bool)> },
}

impl RowStatement {
    /// The comparisons in its conditions, and its expressions outside of them; on request also those of its numbers.
    fn parts(&self, with_numbers: bool) -> (Vec<Compared<'_>>, Vec<&Expression>) {
        let mut compared = comparisons(&self.selected);
        let mut sides: Vec<&Expression> = match &self.form {
            Form::Every(_) | Form::Count(..) => Vec::new(),
            Form::Correlation(sides, ..) | Form::Agrees(sides) => sides.iter().collect(),
            Form::Near(sides, to) => sides.iter().chain([to]).collect(),
            Form::Extreme { of, at, .. } => vec![of, at],
            Form::Neighbours { changes, .. } => changes.iter().map(|(side, _)| side).collect(),
        };
        if let Form::Every(claimed) = &self.form {
            compared.extend(comparisons(claimed));
        }
        for (_, number) in self.numbers.iter().filter(|_| with_numbers) {
            compared.extend(comparisons(&number.selected));
            if let What::Extreme { of, .. } = &number.what {
                sides.push(of);
            }
        }
        (compared, sides)
    }

    /// Whether a name stands for a quoted word.
    pub fn is_word(name: &Symbol) -> bool {
        name.as_str().starts_with(PLACEHOLDER)
    }

    /// The columns that it names, with what stands for words; on request also those that its numbers name.
    pub fn names(&self, with_numbers: bool) -> BTreeSet<Symbol> {
        let (compared, sides) = self.parts(with_numbers);
        let compared = compared.into_iter().flat_map(|(left, _, right)| [left, right]);
        compared.chain(sides).flat_map(Expression::variables).collect()
    }

    /// The columns that have to be a certain word.
    pub fn fixed(&self) -> Vec<&Symbol> {
        let Formula::All(parts) = &self.selected else { return Vec::new() };
        let fixed = parts.iter().filter_map(|part| match part {
            Formula::Compare(Expression::Variable(column), Comparison::Equal, Expression::Variable(word)) => {
                Self::is_word(word).then_some(column)
            }
            _ => None,
        });
        fixed.collect()
    }

    /// Whether places on a logarithmic axis are compared: all its columns outside conditions are in decades.
    pub fn is_place(&self) -> bool {
        let mut names = self.parts(false).1.into_iter().flat_map(Expression::variables).peekable();
        names.peek().is_some() && names.all(|name| name.as_str().ends_with("_dex"))
    }

    /// The column with a unit that is compared with 0: 10 % of 0 is 0.
    fn near_zero<'c>(&self, columns: &'c [Column]) -> Option<&'c Column> {
        let sides = self.parts(false).1;
        let is_near_zero = matches!(self.form, Form::Near(..)) && sides.iter().any(|side| is_zero(side));
        let mut names = sides.into_iter().flat_map(Expression::variables).filter(|_| is_near_zero);
        let with_unit =
            |name: Symbol| columns.iter().find(|one| one.name == name.as_str() && !one.unit.is_empty());
        names.find_map(with_unit).filter(|_| !self.is_place())
    }

    /// The column that is compared with `''`.
    pub fn compared_with_nothing<'e>(&self, sides: [&'e Expression; 2]) -> Option<&'e Symbol> {
        let [Expression::Variable(column), Expression::Variable(word)] = sides else { return None };
        let number = word.as_str().strip_prefix(PLACEHOLDER)?.parse::<usize>().ok()?;
        self.words.get(number)?.is_empty().then_some(column)
    }

    /// Words are compared as a whole: they stand alone on a side of = or !=, and a number is compared with the empty word only. A value
    /// with a unit is not near the number 0.
    fn check(self, columns: &[Column]) -> Result<Self, String> {
        if let Some(Column { name, unit, .. }) = self.near_zero(columns) {
            return Err(format!(
                "`{name}` has the unit {unit}, and 10 % of 0 is 0: write `… is near` another number, \
                 `for every row: abs(…) < …` or `… agrees with 0 within errors`"
            ));
        }
        let is_word = |name: &Symbol| {
            let of_words = |column: &Column| column.name == name.as_str() && column.kind == Kind::Text;
            Self::is_word(name) || columns.iter().any(of_words)
        };
        let lone = |side: &Expression| matches!(side, Expression::Variable(name) if is_word(name));
        let (compared, sides) = self.parts(true);
        let numbers = compared.into_iter().filter(|(left, comparison, right)| {
            let whole = lone(left) && lone(right) || self.compared_with_nothing([left, right]).is_some();
            !(whole && matches!(comparison, Comparison::Equal | Comparison::Unequal))
        });
        let numbers = numbers.flat_map(|(left, _, right)| [left, right]).chain(sides);
        let along = match &self.form {
            Form::Neighbours { along, .. } => &along[..],
            _ => &[],
        };
        let along = along.iter().filter_map(|name| name.parse::<Symbol>().ok());
        let word = numbers.flat_map(Expression::variables).chain(along).find(is_word);
        match word {
            Some(word) if Self::is_word(&word) => {
                Err("a word in quotes is compared with a column of words, by = or !=".into())
            }
            Some(word) => Err(format!(
                "`{word}` is a column of words: compare it with a word in single quotes, by = or !="
            )),
            None => Ok(self),
        }
    }
}

/// The two sides of a comparison with what stands between them.
type Compared<'a> = (&'a Expression, Comparison, &'a Expression);

fn comparisons(formula: &Formula) -> Vec<Compared<'_>> {
    let compared = formula.atoms().into_iter().filter_map(|atom| match atom {
        Formula::Compare(left, comparison, right) => Some((left, *comparison, right)),
        _ => None,
    });
    compared.collect()
}

/// How the names that stand for quoted words begin.
const PLACEHOLDER: &str = "quoted_word_";

/// What stands for the quoted word of this number in expressions.
pub(super) fn placeholder(number: usize) -> String {
    format!("{PLACEHOLDER}{number}")
}

/// Whether an expression without columns is zero.
pub(super) fn is_zero(side: &Expression) -> bool {
    let value = side.enclosed(&BTreeMap::<Symbol, Ball>::new(), BITS);
    value.is_some_and(|value| value.sign() == Some(Ordering::Equal))
}

const FORMS: &str = "a statement over rows is `for every row: …`, `count … = n`, `correlation of x with y … > r`, `least y at x = v within d`, \
                     `x agrees with y within d`, `x is near y`, `between neighbours along x: y rises`, `x rises with y` or `x falls with y`";

/// Reads a statement, and the numbers that its sentences name, in the names of columns.
///
/// # Errors
/// What is wrong with it, with the nearest known column for an unknown one.
pub(super) fn read(
    text: &str,
    numbers: &BTreeMap<String, String>,
    columns: &[Column],
) -> Result<RowStatement, String> {
    let mut words = Vec::new();
    let text = without_quotes(text, &mut words)?;
    let numbers = numbers.iter().map(|(name, text)| Ok((name, without_quotes(text, &mut words)?)));
    let numbers = numbers.collect::<Result<Vec<_>, String>>()?;
    let placeholders: Vec<String> = (0..words.len()).map(placeholder).collect();
    let known = columns.iter().map(|column| column.name.as_str());
    let names = Names::plain(known.clone().chain(placeholders.iter().map(String::as_str)));
    let mut reader = Reader { columns: known.collect(), names, groups: Vec::new() };
    let (form, selected) = reader.statement(text.trim())?;
    let number = |(name, text): (&String, String)| match reader.number(&text) {
        Ok(number) => Ok((name.clone(), number)),
        Err(message) => Err(format!("the number `{name}`: {message}")),
    };
    let numbers = numbers.into_iter().map(number).collect::<Result<_, _>>()?;
    RowStatement { form, selected, groups: reader.groups, words, numbers }.check(columns)
}

/// The text with a placeholder for each word in single quotes; the words are added to the others.
fn without_quotes(text: &str, words: &mut Vec<String>) -> Result<String, String> {
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
        0 => Ok(found),
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
            let selected = self.selected(selected, "`for every row`")?;
            return Ok((Form::Every(self.condition(claimed)?), selected));
        }
        if let Some(rest) = text.strip_prefix("count ") {
            let (condition, comparison, number) = compared(rest)?;
            return Ok((Form::Count(comparison, number), self.selected(condition, "`count`")?));
        }
        if let Some(rest) = text.strip_prefix("between neighbours along ") {
            let (rest, changes) = rest.split_once(':').ok_or("`between neighbours` needs a ':'")?;
            let (rest, selected) = self.without_condition(rest)?;
            let along = self.without_groups(rest)?.split(" and ");
            let along = along.map(|name| self.column(name.trim())).collect::<Result<_, _>>()?;
            let changes = changes.split(" and ").map(|text| self.change(text)).collect::<Result<_, _>>()?;
            return Ok((Form::Neighbours { along, changes }, selected));
        }
        let (text, selected) = self.without_condition(text)?;
        Ok((self.form(text)?, selected))
    }

    /// The rows that stand between words of a statement: those with a condition after `where`, or all.
    fn selected(&self, text: &str, words: &str) -> Result<Formula, String> {
        let text = text.trim();
        match text.strip_prefix("where ") {
            Some(condition) => self.condition(condition),
            None if text.is_empty() => Ok(all()),
            None => Err(format!("'{text}': expected `where` after {words}")),
        }
    }

    /// The text before `where`, and the condition after it.
    fn without_condition<'t>(&self, text: &'t str) -> Result<(&'t str, Formula), String> {
        match text.split_once(" where ") {
            Some((text, condition)) => Ok((text, self.condition(condition)?)),
            None => Ok((text, all())),
        }
    }

    /// An expression that rises or falls.
    fn change(&self, text: &str) -> Result<(Expression, bool), String> {
        let text = text.trim();
        let words = [(" rises", true), (" falls", false)].into_iter();
        let mut found = words.filter_map(|(word, rises)| Some((text.strip_suffix(word)?, rises)));
        let (side, rises) =
            found.next().ok_or_else(|| format!("'{text}': expected `… rises` or `… falls`"))?;
        Ok((self.side(side)?, rises))
    }

    /// A number for sentences.
    fn number(&self, text: &str) -> Result<Number, String> {
        if let Some(rest) = text.strip_prefix("count") {
            return Ok(Number { what: What::Count, selected: self.selected(rest, "`count`")? });
        }
        let form = "the form is `least x where …, 2 digits, below`, `largest …` or `count where …`";
        let mut parts = text.split(',').map(str::trim);
        let (side, selected) = self.without_condition(parts.next().unwrap_or_default())?;
        let digits = parts.next().and_then(|part| part.strip_suffix(" digits")?.parse().ok());
        let rounding = match parts.next() {
            None => None,
            Some("above") => Some(Side::Above),
            Some("below") => Some(Side::Below),
            Some(_) => return Err(form.into()),
        };
        let (least, side) = match (side.strip_prefix("least "), side.strip_prefix("largest ")) {
            (Some(side), _) => (true, side),
            (_, Some(side)) => (false, side),
            _ => return Err(form.into()),
        };
        let digits = digits.filter(|digits| (1..=15).contains(digits)).ok_or(form)?;
        let what = What::Extreme { least, of: self.side(side)?, digits, side: rounding };
        Ok(Number { what, selected })
    }

    fn column(&self, name: &str) -> Result<String, String> {
        if self.columns.contains(&name) { Ok(name.to_owned()) } else { Err(self.unknown(name)) }
    }

    fn form(&mut self, text: &str) -> Result<Form, String> {
        if let Some((one, rest)) = text.split_once(" agrees with ") {
            let (other, distance) = rest.split_once(" within ").ok_or("`agrees with` needs `within`")?;
            let (one, other) = (self.side(one)?, self.side(other)?);
            if distance.trim() == "errors" {
                return Ok(Form::Agrees([one, other]));
            }
            let allowed = Expression::Number(number(distance)?) * other.clone().call(Function::Abs);
            let difference = (one - other).call(Function::Abs);
            return Ok(Form::Every(Formula::Compare(difference, Comparison::AtMost, allowed)));
        }
        if let Some((sides, to)) = text.split_once(" is near ").or_else(|| text.split_once(" are near ")) {
            let sides = sides.split(" and ").map(|side| self.side(side)).collect::<Result<_, _>>()?;
            return Ok(Form::Near(sides, self.side(to)?));
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
            let rest = self.without_groups(rest)?;
            let along = vec![self.column(rest.trim())?];
            return Ok(Form::Neighbours { along, changes: vec![(self.side(of)?, rises)] });
        }
        Err(FORMS.into())
    }

    /// The text before `at each`; the columns after it are kept.
    fn without_groups<'t>(&mut self, text: &'t str) -> Result<&'t str, String> {
        let Some((text, list)) = text.split_once(" at each ") else { return Ok(text) };
        let names = list.split(',').map(|name| self.column(name.trim()));
        let names = names.collect::<Result<Vec<_>, _>>()?;
        self.groups.extend(names);
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
        let grammar = ["and", "or", "not", "implies", "iff", "abs", "sqrt", "ln", "exp"];
        let mut unknown = words.filter(|word| {
            !grammar.contains(word) && !self.columns.contains(word) && !word.starts_with(PLACEHOLDER)
        });
        unknown.next().map_or(Ok(()), |word| Err(self.unknown(word)))
    }

    fn unknown(&self, name: &str) -> String {
        let near = nearest(name, self.columns.iter().copied());
        match near {
            Some(near) => format!("'{name}' is no column of the table; did you mean `{near}`?"),
            None => format!("'{name}' is no column of the table (columns: {})", self.columns.join(", ")),
        }
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
