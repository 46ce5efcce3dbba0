//! How a statement over rows is decided: in every row true, false, or open where an estimated error could turn it.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use slipmode_algebra::{Comparison, Expression, Symbol};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Ball, Rational};
use slipmode_plot::table::Table;

use super::arithmetic::{BITS, compared, correlation, magnitude};
use super::neighbours::neighbours;
use super::statement::{Form, RowStatement, is_zero};
use super::truth::{Rows, Truth};
use super::values::{self, error_column};
use crate::claims::rule::{Deviations, Measure};
use crate::claims::{Evidence, Finding, Strength};
use crate::scene::Kind;

/// How many columns name a row in a table that does not say it: scene, law and place in most tables.
const FIRST_COLUMNS: usize = 4;
/// How many open groups are named.
const MOST_NAMED: usize = 5;

/// The finding on a statement over the rows of a table that has some, in a sentence of this kind.
pub(super) fn decide(text: &str, statement: &RowStatement, table: &Table, kind: Kind) -> Finding {
    let rows = match values::rows(table, statement) {
        Ok(rows) => Rows { statement, rows },
        Err(contradiction) => return Finding::not_checked(contradiction),
    };
    let all = All { text, statement, table, rows, used: statement.names(false) };
    let numbers = statement.numbers.iter();
    let numbers = numbers.filter_map(|(name, number)| Some((name, number.text(&all.rows)?)));
    let found = all.found(kind).unwrap_or_else(|undecided| undecided);
    numbers.fold(found, |found, (name, value)| found.number(name.clone(), value))
}

/// The rows with what is said of them.
struct All<'a> {
    text: &'a str,
    statement: &'a RowStatement,
    table: &'a Table,
    rows: Rows<'a>,
    /// The columns that the statement names.
    used: BTreeSet<Symbol>,
}

/// One thing that is true, false or open: the rows that it is about, or the first of them, and what to say of it.
struct Case {
    at: Vec<usize>,
    truth: Truth,
    value: String,
}

/// A row of the group that stands for it, whether the statement is true, and the value; or why there is no value.
type InGroup = Result<(usize, Option<bool>, String), &'static str>;

impl All<'_> {
    fn found(&self, kind: Kind) -> Result<Finding, Finding> {
        Ok(match &self.statement.form {
            Form::Every(claimed) => self.in_rows(|at| self.rows.truth(claimed, at)),
            Form::Agrees(sides) => self.in_rows(|at| self.rows.agree(sides, at)),
            Form::Neighbours { along, changes } => self.between(along, changes)?,
            Form::Count(comparison, number) => self.count(*comparison, number),
            Form::Correlation(sides, comparison, number) => {
                let number = Ball::from_rational(number, BITS);
                self.in_groups(|group| {
                    let [x, y] = self.rows.values(group, sides)?;
                    let found = correlation(&x, &y)?;
                    let is = compared(&(found.clone() - &number), *comparison);
                    Ok((group[0], is, round_digits(found.to_f64(), 4)))
                })?
            }
            Form::Extreme { least, of, at, place } => {
                let sides = [if *least { of.clone() } else { -of.clone() }, at.clone()];
                self.in_groups(|group| self.extreme(group, &sides, place))?
            }
            Form::Near(sides, to) => self.near(kind, sides, to)?,
        })
    }

    /// Every row with whether it meets the condition.
    fn every(&self) -> Vec<(usize, Truth)> {
        let rows = 0..self.rows.rows.len();
        rows.map(|at| (at, self.rows.truth(&self.statement.selected, at))).collect()
    }

    /// The rows that meet the condition.
    ///
    /// # Errors
    /// The finding where it is open which rows do, and where none does.
    fn chosen(&self) -> Result<Vec<usize>, Finding> {
        let every = self.every();
        let chosen = every.iter().filter(|(_, truth)| truth.is == Some(true)).map(|(at, _)| *at);
        let chosen: Vec<usize> = chosen.collect();
        match every.iter().any(|(_, truth)| truth.is.is_none()) {
            true => Err(self.open(&every)),
            false if chosen.is_empty() => Err(self.nothing("row")),
            false => Ok(chosen),
        }
    }

    /// The finding where it is open which rows meet the condition.
    fn open(&self, every: &[(usize, Truth)]) -> Finding {
        let open = every.iter().filter(|(_, truth)| truth.is.is_none());
        let open = open.map(|&(at, truth)| Case { at: vec![at], truth, value: String::new() });
        self.conclude("rows", open.collect(), None)
    }

    /// The finding that something is true in every row that meets the condition.
    fn in_rows(&self, claimed: impl Fn(usize) -> Truth) -> Finding {
        let cases = self.every().into_iter().map(|(at, chosen)| (vec![at], chosen, claimed(at)));
        self.implied("rows", cases)
    }

    fn nothing(&self, of: &str) -> Finding {
        Finding::not_checked(format!(
            "No {of} of the table `{}` certainly meets the condition.",
            self.table.id
        ))
    }

    /// The finding that the second is true wherever the first one is, from the rows at which they begin.
    fn implied(&self, of: &str, cases: impl Iterator<Item = (Vec<usize>, Truth, Truth)>) -> Finding {
        let (mut met, mut left_out) = (Vec::new(), None);
        for (at, chosen, claimed) in cases {
            let truth = chosen.implies(claimed);
            if chosen.is == Some(true) || truth.is.is_none() {
                met.push(Case { at, truth, value: String::new() });
            } else {
                // Whatever may not meet the condition has to be out of the way as surely as the others are true.
                left_out = left_out.max(Some(chosen.is.map_or(truth, |_| chosen).strength));
            }
        }
        if met.is_empty() { self.nothing(of.trim_end_matches('s')) } else { self.conclude(of, met, left_out) }
    }

    /// The finding that between neighbours that both meet the condition the values change so.
    fn between(&self, along: &[String], changes: &[(Expression, bool)]) -> Result<Finding, Finding> {
        let pairs = neighbours(self.table, along, &self.statement.groups).map_err(Finding::not_checked)?;
        let all = |truths: &mut dyn Iterator<Item = Truth>| Truth::joined(truths, false);
        let cases = pairs.into_iter().map(|pair| {
            let chosen = &mut pair.into_iter().map(|at| self.rows.truth(&self.statement.selected, at));
            let changes = &mut changes.iter().map(|(side, rises)| self.rows.changes(side, *rises, pair));
            (pair.to_vec(), all(chosen), all(changes))
        });
        Ok(self.implied("neighbours", cases))
    }

    fn count(&self, comparison: Comparison, number: &Rational) -> Finding {
        let every = self.every();
        let with = |wanted: Option<bool>| every.iter().filter(move |(_, truth)| truth.is == wanted).count();
        let (certain, open) = (with(Some(true)), with(None));
        let compares = |count: usize| comparison.holds(Rational::from(count).cmp(number));
        let truths: BTreeSet<bool> = (certain..=certain + open).map(compares).collect();
        if truths.len() > 1 {
            return self.open(&every);
        }
        let strength = every.iter().map(|(_, truth)| truth.strength).max().unwrap_or(Strength::Sampled);
        let found = self.finding(strength, format!("{certain} of {} rows", every.len()), every.len());
        let found = found.number("count", certain.to_string());
        found.require(truths.contains(&true), || format!("there are {certain}"))
    }

    /// The finding that values are near another one in the chosen rows.
    fn near(&self, kind: Kind, sides: &[Expression], to: &Expression) -> Result<Finding, Finding> {
        let chosen = self.chosen()?;
        let is_place = self.statement.is_place();
        let deviation = |(side, at): (&Expression, usize)| {
            let is_absolute = is_place || is_zero(side) || is_zero(to);
            let (value, to) = (self.rows.value(side, at)?, self.rows.value(to, at)?);
            let difference = value - &to;
            let deviation = match (to.sign(), difference.sign()) {
                _ if is_absolute => difference,
                (Some(Ordering::Less | Ordering::Greater), _) => difference / to,
                // What may be zero has no percentage that differs from zero.
                (_, Some(Ordering::Equal)) => difference,
                (_, None) => return difference.is_bounded().then_some((0.0, f64::INFINITY)),
                (_, Some(_)) => {
                    let excess = magnitude(&difference) - magnitude(&to);
                    return (excess.sign() == Some(Ordering::Greater)).then_some((f64::INFINITY, 0.0));
                }
            };
            deviation.is_bounded().then(|| (deviation.to_f64(), deviation.radius().to_f64()))
        };
        let compared = chosen.iter().flat_map(|&at| sides.iter().map(move |side| (side, at)));
        let each = compared.map(deviation).collect::<Option<Vec<_>>>();
        let missing = || Finding::not_checked("A value that is compared is missing or has no bounds.");
        let each = each.ok_or_else(missing)?;
        let deviations = Deviations::new(if is_place { Measure::Place } else { Measure::Value }, each);
        let strength = self.weakest(&chosen);
        let found = self.finding(strength, format!("off by {}", deviations.range()), chosen.len());
        Ok(found.near(kind, &deviations).number("count", chosen.len().to_string()))
    }

    /// The finding of cases that each are true, false or open, where what was left out is as sure as this.
    fn conclude(&self, of: &str, cases: Vec<Case>, left_out: Option<Strength>) -> Finding {
        let with = |wanted: Option<bool>| cases.iter().filter(move |case| case.truth.is == wanted);
        let strengths = |wanted| with(wanted).map(|case| case.truth.strength);
        let named = |case: &Case| {
            let texts = [case.value.clone(), self.places(&case.at)];
            texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(": ")
        };
        let first = |wanted: Option<bool>, most: usize| {
            let mut cases: Vec<&Case> = with(wanted).collect();
            cases.sort_by_key(|case| case.truth.strength);
            cases.into_iter().take(most).map(named).collect::<Vec<_>>().join("; ")
        };
        let (count, wrong, open) = (cases.len(), with(Some(false)).count(), with(None).count());
        if let Some(strength) = strengths(Some(false)).min() {
            let found = self.finding(strength, format!("false in {wrong} of {count} {of}"), count);
            return found
                .number("share", format!("{wrong} of {count}"))
                .number("count", count.to_string())
                .refuted(format!("false in {wrong} of {count} {of}; the first: {}", first(Some(false), 1)));
        }
        if open > 0 {
            let (why, most) = match with(None).all(|case| case.value.is_empty()) {
                true => ("a missing value or an estimated error leaves it open", 1),
                false => ("it is open", MOST_NAMED),
            };
            return Finding::not_checked(format!(
                "Not decided: in {open} of {count} {of} of `{}` {why}; the first: {}.",
                self.table.id,
                first(None, most)
            ));
        }
        let values: BTreeSet<&str> =
            cases.iter().map(|case| case.value.as_str()).filter(|value| !value.is_empty()).collect();
        let values = values.into_iter().map(|value| format!("; {value}")).collect::<String>();
        let strength = strengths(Some(true)).chain(left_out).max().unwrap_or(Strength::Sampled);
        let found = self.finding(strength, format!("true in {count} of {count} {of}{values}"), count);
        found.number("count", count.to_string())
    }

    /// The rows in groups of the same cells in the statement's columns, and what is found in each.
    fn in_groups(&self, decide: impl Fn(&[usize]) -> InGroup) -> Result<Finding, Finding> {
        let mut rows = self.chosen()?;
        let by: Vec<usize> = (0..self.table.columns.len())
            .filter(|&at| self.statement.groups.contains(&self.table.columns[at].name))
            .collect();
        let key = |row: usize| {
            by.iter().map(|&column| self.table.rows[row][column].text.as_str()).collect::<Vec<_>>()
        };
        rows.sort_by_key(|&row| key(row));
        let case = |group: &[usize]| {
            let (at, is, value) = decide(group).unwrap_or_else(|reason| (group[0], None, reason.into()));
            Case { at: vec![at], truth: Truth { is, strength: self.weakest(group) }, value }
        };
        let found = rows.chunk_by(|&one, &other| key(one) == key(other)).map(case).collect();
        Ok(self.conclude("groups of rows", found, None))
    }

    /// The strength of the least sure value that the statement names in these rows.
    fn weakest(&self, group: &[usize]) -> Strength {
        let names = || self.used.iter().filter(|name| !RowStatement::is_word(name));
        let strengths =
            group.iter().flat_map(|&at| names().map(move |name| self.rows.rows[at].strength(name)));
        strengths.max().unwrap_or(Strength::Sampled)
    }

    /// The row with the least first value: whether its second one is as near as this to the place.
    fn extreme(&self, group: &[usize], sides: &[Expression; 2], place: &[Rational; 2]) -> InGroup {
        let [values, places] = self.rows.values(group, sides)?;
        let upper: Vec<_> = values.iter().map(Ball::upper).collect();
        let least = (1..group.len()).fold(0, |least, at| if upper[at] < upper[least] { at } else { least });
        // Each row that may have the least value, as far as errors tell.
        let may_be_least = |at: &usize| values[*at].lower() <= upper[least];
        let places = (0..group.len()).filter(may_be_least).map(|at| &places[at]);
        let [place, distance] = place.each_ref().map(|number| Ball::from_rational(number, BITS));
        let near = |at: &Ball| compared(&(magnitude(&(at.clone() - &place)) - &distance), Comparison::AtMost);
        let found: Vec<(Option<bool>, String)> =
            places.map(|at| (near(at), round_digits(at.to_f64(), 4))).collect();
        let text = found.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>().join(" or ");
        let truth = found[0].0.filter(|first| found.iter().all(|(near, _)| *near == Some(*first)));
        Ok((group[least], truth, format!("at {text}")))
    }

    /// A finding that holds, as sure as this.
    fn finding(&self, strength: Strength, value: String, count: usize) -> Finding {
        let quantity = format!("{}: {}", self.table.id, self.text);
        Finding::from_evidence(match strength {
            Strength::Sampled => Evidence::Sample { quantity, value, points: count },
            Strength::Converged => {
                Evidence::Simulation { quantity, value, error: self.largest_errors(), runs: count }
            }
            _ => Evidence::Enclosure { quantity, value },
        })
    }

    /// The largest entry of each column of errors of what the statement names; of all of them where it names words only.
    fn largest_errors(&self) -> String {
        let used = self.used.iter().filter_map(|name| error_column(name.as_str(), self.table));
        let used: BTreeSet<usize> = used.collect();
        let is_shown =
            |at: usize, name: &str| used.contains(&at) || used.is_empty() && name.contains("_error");
        let columns = self.table.columns.iter().enumerate();
        let columns = columns.filter(|(at, column)| is_shown(*at, &column.name));
        let largest = columns.filter_map(|(at, column)| {
            let sizes = self.table.rows.iter().filter_map(|row| row[at].text.parse::<f64>().ok());
            Some(format!("{} at most {}", column.name, round_digits(sizes.reduce(f64::max)?, 2)))
        });
        largest.collect::<Vec<_>>().join(", ")
    }

    /// Rows for people: the first one, and what is different in the others.
    fn places(&self, rows: &[usize]) -> String {
        let Some((&first, others)) = rows.split_first() else { return String::new() };
        let of_first = self.cells(first);
        let differs = |cell: &String| !of_first.contains(cell);
        let others = others.iter().map(|&at| self.cells(at).into_iter().filter(differs).collect::<Vec<_>>());
        std::iter::once(of_first.clone())
            .chain(others)
            .map(|cells| cells.join(", "))
            .collect::<Vec<_>>()
            .join(" and ")
    }

    /// A row for people: the columns that name it, and those that the statement names, but for words that the condition fixes.
    /// Where it stands for a group, also the columns that name the group, and only these for a correlation.
    fn cells(&self, at: usize) -> Vec<String> {
        let names = if self.table.names > 0 { self.table.names } else { FIRST_COLUMNS };
        let RowStatement { form, groups, .. } = self.statement;
        let fixed = self.statement.fixed();
        let is_correlation = matches!(form, Form::Correlation(..));
        let is_of_group = is_correlation || matches!(form, Form::Extreme { .. });
        let cells = self.table.columns.iter().zip(&self.table.rows[at]).enumerate();
        let shown = cells.filter(|(place, (column, cell))| {
            let is = |name: &&Symbol| name.as_str() == column.name;
            let is_named = || *place < names || self.used.iter().any(|name| is(&name));
            !cell.text.is_empty()
                && !fixed.iter().any(is)
                && (is_of_group && groups.contains(&column.name) || !is_correlation && is_named())
        });
        shown.map(|(_, (column, cell))| format!("{} = {}", column.name, cell.text)).collect()
    }
}
