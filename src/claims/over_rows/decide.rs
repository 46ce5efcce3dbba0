//! How a statement over rows is decided: in every row true, false, or open where an estimated error could turn it.

use std::collections::BTreeSet;

use slipmode_algebra::{Comparison, Expression, Function, Symbol};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Ball, Rational};
use slipmode_plot::table::Table;

use super::arithmetic::{BITS, compared, correlation, magnitude};
use super::statement::{Form, RowStatement};
use super::values::{Row, rows};
use crate::claims::{Evidence, Finding, Strength};
use crate::scene::Formula;

/// How many columns name a row: scene, law and place in most tables.
const FIRST_COLUMNS: usize = 4;

/// The finding on a statement over the rows of a table that has some.
pub(super) fn decide(text: &str, statement: &RowStatement, table: &Table) -> Finding {
    let rows = rows(table, &statement.words);
    let all = All { text, statement, table, rows, used: statement.names() };
    let chosen: Vec<(usize, Option<bool>)> = (0..all.rows.len())
        .map(|at| (at, all.truth(&statement.selected, at)))
        .filter(|(_, chosen)| *chosen != Some(false))
        .collect();
    if chosen.is_empty() && !matches!(statement.form, Form::Count(..)) {
        return Finding::not_checked(format!("No row of the table `{}` meets the condition.", table.id));
    }
    let unsure =
        || chosen.iter().filter(|(_, chosen)| chosen.is_none()).map(|(at, _)| (*at, None, String::new()));
    match &statement.form {
        Form::Every(claimed) => all.conclude(
            "rows",
            chosen.iter().map(|&(at, chosen)| {
                let truth = all.truth(claimed, at).filter(|truth| *truth || chosen.is_some());
                (at, truth, String::new())
            }),
        ),
        Form::Count(comparison, number) => {
            let certain = chosen.len() - unsure().count();
            let compares = |count: usize| comparison.holds(Rational::from(count).cmp(number));
            let truths: BTreeSet<bool> = (certain..=chosen.len()).map(compares).collect();
            let found = all.finding(format!("{certain} of {} rows", all.rows.len()), all.rows.len());
            match (truths.len(), truths.contains(&true)) {
                (1, true) => found,
                (1, false) => found.refuted(format!("there are {certain}")),
                _ => all.conclude("rows", unsure()),
            }
        }
        _ if unsure().next().is_some() => all.conclude("rows", unsure()),
        Form::Correlation(sides, comparison, number) => {
            all.in_groups(&chosen, |group| all.correlation(group, sides, *comparison, number))
        }
        Form::Extreme { least, of, at, place } => {
            all.in_groups(&chosen, |group| all.extreme(group, (*least, of), at, place))
        }
        Form::Trend { rises, sides } => all.in_groups(&chosen, |group| all.trend(group, *rises, sides)),
    }
}

/// The rows with what is said of them.
struct All<'a> {
    text: &'a str,
    statement: &'a RowStatement,
    table: &'a Table,
    rows: Vec<Row>,
    /// The columns that the statement names.
    used: BTreeSet<Symbol>,
}

/// Whether the statement is true, and the value; none for too few rows or without different values.
type InGroup = Option<(Option<bool>, String)>;

impl All<'_> {
    /// The finding of cases that each are true, false or open, with the row at which each begins.
    fn conclude(&self, of: &str, cases: impl Iterator<Item = (usize, Option<bool>, String)>) -> Finding {
        let cases: Vec<(usize, Option<bool>, String)> = cases.collect();
        let with = |wanted: Option<bool>| cases.iter().filter(move |(_, truth, _)| *truth == wanted);
        let first = |wanted: Option<bool>| {
            with(wanted).next().map_or_else(String::new, |(at, _, value)| match value.is_empty() {
                true => self.place(*at),
                false => format!("{value}: {}", self.place(*at)),
            })
        };
        let (count, wrong, open) = (cases.len(), with(Some(false)).count(), with(None).count());
        if wrong > 0 {
            let found = self.finding(format!("false in {wrong} of {count} {of}"), count);
            return found.refuted(format!("in {wrong} of {count} {of}; the first: {}", first(Some(false))));
        }
        if open > 0 {
            return Finding::not_checked(format!(
                "Not decided: in {open} of {count} {of} of `{}` a missing value or an estimated error leaves it open; the first: {}.",
                self.table.id,
                first(None)
            ));
        }
        let values: BTreeSet<&str> =
            cases.iter().map(|(_, _, value)| value.as_str()).filter(|value| !value.is_empty()).collect();
        let values = values.into_iter().map(|value| format!("; {value}")).collect::<String>();
        self.finding(format!("true in {count} of {count} {of}{values}"), count)
    }

    /// The rows in groups of the same cells in the statement's columns, and what is found in each.
    fn in_groups(&self, chosen: &[(usize, Option<bool>)], decide: impl Fn(&[usize]) -> InGroup) -> Finding {
        let by: Vec<usize> = (0..self.table.columns.len())
            .filter(|&at| self.statement.groups.contains(&self.table.columns[at].name))
            .collect();
        let key = |row: usize| {
            by.iter().map(|&column| self.table.rows[row][column].text.as_str()).collect::<Vec<_>>()
        };
        let mut rows: Vec<usize> = chosen.iter().map(|(at, _)| *at).collect();
        rows.sort_by_key(|&row| key(row));
        let groups = rows.chunk_by(|&one, &other| key(one) == key(other));
        let mut found = groups
            .filter_map(|group| decide(group).map(|(truth, value)| (group[0], truth, value)))
            .peekable();
        match found.peek() {
            None => Finding::not_checked("No group of rows has enough rows with different values."),
            Some(_) => self.conclude("groups of rows", found),
        }
    }

    fn correlation(
        &self,
        group: &[usize],
        sides: &[Expression; 2],
        comparison: Comparison,
        number: &Rational,
    ) -> InGroup {
        let Some([x, y]) = self.values(group, sides) else {
            return Some((None, "a value is missing".into()));
        };
        let found = correlation(&x, &y)?;
        let difference = found.clone() - Ball::from_rational(number, BITS);
        Some((compared(&difference, comparison, true), round_digits(found.to_f64(), 4)))
    }

    fn extreme(
        &self,
        group: &[usize],
        (least, of): (bool, &Expression),
        at: &Expression,
        [place, distance]: &[Rational; 2],
    ) -> InGroup {
        let of = if least { of.clone() } else { -of.clone() };
        let Some([values, places]) = self.values(group, &[of, at.clone()]) else {
            return Some((None, "a value is missing".into()));
        };
        // Each row that may have the least value, as far as errors tell.
        let below = values.iter().map(Ball::upper).min_by(|one, other| one.total_cmp(other))?;
        let places =
            places.iter().zip(&values).filter(|(_, value)| value.lower() <= below).map(|(place, _)| place);
        let [place, distance] = [place, distance].map(|number| Ball::from_rational(number, BITS));
        let near =
            |at: &Ball| compared(&(magnitude(&(at.clone() - &place)) - &distance), Comparison::AtMost, true);
        let found: Vec<(Option<bool>, String)> =
            places.map(|at| (near(at), round_digits(at.to_f64(), 4))).collect();
        let text = found.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>().join(" or ");
        let truth = found[0].0.filter(|first| found.iter().all(|(near, _)| *near == Some(*first)));
        Some((truth, format!("at {text}")))
    }

    fn trend(&self, group: &[usize], rises: bool, sides: &[Expression; 2]) -> InGroup {
        let Some([of, with]) = self.values(group, sides) else {
            return Some((None, "a value is missing".into()));
        };
        let mut values: Vec<(Ball, Ball)> = with.into_iter().zip(of).collect();
        values.sort_by(|one, other| one.0.to_f64().total_cmp(&other.0.to_f64()));
        let wanted = if rises { Comparison::Greater } else { Comparison::Less };
        let step = |pair: &[(Ball, Ball)]| {
            let ordered = compared(&(pair[1].0.clone() - &pair[0].0), Comparison::Greater, true);
            ordered
                .filter(|ordered| *ordered)
                .and_then(|_| compared(&(pair[1].1.clone() - &pair[0].1), wanted, true))
        };
        let steps: Vec<Option<bool>> = values.windows(2).map(step).collect();
        let passed = steps.iter().filter(|step| **step == Some(true)).count();
        let words = format!("{passed} of {} neighbours", steps.len());
        (!steps.is_empty()).then(|| (joined(steps.into_iter(), false), words))
    }

    /// The values of two expressions in rows; none where one is missing.
    fn values(&self, group: &[usize], sides: &[Expression; 2]) -> Option<[Vec<Ball>; 2]> {
        let of =
            |side: &Expression| group.iter().map(|&at| self.value(side, at)).collect::<Option<Vec<Ball>>>();
        Some([of(&sides[0])?, of(&sides[1])?])
    }

    /// The value of an expression in a row; none where a column has none there.
    fn value(&self, side: &Expression, at: usize) -> Option<Ball> {
        match side {
            Expression::Call(Function::Abs, inner) => self.value(inner, at).map(|inner| magnitude(&inner)),
            _ => side.enclosed(&self.rows[at].values, BITS),
        }
    }

    /// Whether a formula is true in a row; none where a value is missing or errors could turn it.
    fn truth(&self, formula: &Formula, at: usize) -> Option<bool> {
        let go = |part: &Formula| self.truth(part, at);
        match formula {
            Formula::Compare(left, comparison, right) => self.comparison([left, right], *comparison, at),
            Formula::Not(inner) => go(inner).map(|truth| !truth),
            Formula::All(parts) => joined(parts.iter().map(go), false),
            Formula::Any(parts) => joined(parts.iter().map(go), true),
            Formula::Implies(parts) => {
                joined([go(&parts[0]).map(|truth| !truth), go(&parts[1])].into_iter(), true)
            }
            Formula::Iff(parts) => Some(go(&parts[0])? == go(&parts[1])?),
            Formula::Roots(..) | Formula::Crossing(_) => None,
        }
    }

    fn comparison(&self, sides: [&Expression; 2], comparison: Comparison, at: usize) -> Option<bool> {
        let row = &self.rows[at];
        if let Some(column) = self.statement.compared_with_nothing(sides) {
            return Some(row.is_empty(column) == (comparison == Comparison::Equal));
        }
        let difference = self.value(sides[0], at)? - self.value(sides[1], at)?;
        let is_estimated =
            sides.iter().flat_map(|side| side.variables()).any(|name| row.estimated.contains(&name));
        compared(&difference, comparison, is_estimated)
    }

    /// A finding that holds, as sure as the least sure value that the statement names.
    fn finding(&self, value: String, count: usize) -> Finding {
        let strengths =
            self.rows.iter().flat_map(|row| self.used.iter().filter_map(|name| row.strengths.get(name)));
        let quantity = format!("{}: {}", self.table.id, self.text);
        Finding::from_evidence(match strengths.max() {
            Some(Strength::Certified) => Evidence::Enclosure { quantity, value },
            Some(Strength::Converged) => {
                Evidence::Simulation { quantity, value, error: self.largest_errors(), runs: count }
            }
            _ => Evidence::Sample { quantity, value, points: count },
        })
    }

    /// The largest entry of each column of errors.
    fn largest_errors(&self) -> String {
        let columns =
            self.table.columns.iter().enumerate().filter(|(_, column)| column.name.contains("_error"));
        let largest = columns.filter_map(|(at, column)| {
            let sizes = self.table.rows.iter().filter_map(|row| row[at].text.parse::<f64>().ok());
            Some(format!("{} at most {}", column.name, round_digits(sizes.reduce(f64::max)?, 2)))
        });
        largest.collect::<Vec<_>>().join(", ")
    }

    /// A row for people: its first columns, and those that the statement names.
    fn place(&self, at: usize) -> String {
        let shown = self.table.columns.iter().zip(&self.table.rows[at]).enumerate();
        let shown = shown.filter(|(place, (column, cell))| {
            !cell.text.is_empty()
                && (*place < FIRST_COLUMNS || self.used.iter().any(|name| name.as_str() == column.name))
        });
        shown
            .map(|(_, (column, cell))| format!("{} = {}", column.name, cell.text))
            .collect::<Vec<_>>()
            .join(", ")
    }
}

/// A conjunction, or with `wanted` a disjunction, of truths of which some are open.
fn joined(truths: impl Iterator<Item = Option<bool>>, wanted: bool) -> Option<bool> {
    let truths: BTreeSet<Option<bool>> = truths.collect();
    match truths.contains(&Some(wanted)) {
        true => Some(wanted),
        false => (!truths.contains(&None)).then_some(!wanted),
    }
}
