//! The value of a term at a point: a walk along the tree as it is written, and along what its names mean.
//!
//! Derivatives are taken with dual numbers, determinants and coefficients with the values at the point, so that `characteristic`,
//! `linearised`, `rate`, `derivative`, `coefficient`, `solve`, `at` and `exchange` are found without the program's derivations.
//! `discriminant`, `hurwitz`, `eliminate`, `limit` and `series` need a degree or a limit that one point does not show: their values
//! are those of the expressions that the program derived.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use slipmode_algebra::Function;
use slipmode_core::number::Rational;
use slipmode_theory::Operation;

use super::book::{Book, Compared, Derived, EITHER_SIGN, Meaning, Term, UNIT};
use super::number::{Number, Tried, Trouble, all};
use super::value::{IMAGINARY, Kind, Mark, Value};

/// The values of defined names, and their coefficients as polynomials in a variable.
type Known = BTreeMap<(usize, Option<usize>), Tried<Vec<Value>>>;

/// The precision at which numbers are intervals of 64-bit numbers and nothing is exact.
pub(super) const NEAR: u32 = f64::MANTISSA_DIGITS;

/// A point, with what was worked out there.
pub(super) struct AtPoint<'b> {
    pub book: &'b Book,
    /// The conditions of the claim that are no equations: a critical value has to meet them.
    pub conditions: &'b [Compared],
    /// The precision of balls.
    pub bits: u32,
    values: Vec<Option<Value>>,
    /// What was found here, and after each change of variables that is in force, with the variables that changed.
    known: Vec<(Vec<usize>, Known)>,
    marks: u32,
}

impl<'b> AtPoint<'b> {
    pub fn new(book: &'b Book, conditions: &'b [Compared], bits: u32) -> Self {
        let mut values = vec![None; book.variable_count()];
        if let Some(unit) = book.place(UNIT) {
            values[unit] = Some(Value::with_quantity(Value::whole(0), IMAGINARY));
        }
        if let Some(sign) = book.place(EITHER_SIGN) {
            values[sign] = Some(Value::whole(1));
        }
        Self { book, conditions, bits, values, known: vec![Default::default()], marks: 0 }
    }

    /// A rational as a value here.
    pub fn rational(&self, value: &Rational) -> Value {
        Number::of_rational(value, self.bits == NEAR).into()
    }

    pub fn set(&mut self, variable: usize, value: Value) {
        self.values[variable] = Some(value);
        self.known.truncate(1);
        self.known[0].1.clear();
    }

    pub fn get(&self, variable: usize) -> Tried<Value> {
        self.values[variable].clone().ok_or(Trouble::Open)
    }

    pub fn has(&self, variable: usize) -> bool {
        self.values[variable].is_some()
    }

    /// A quantity that occurs nowhere yet.
    pub fn quantity(&mut self, kind: Kind) -> Mark {
        self.marks += 1;
        Mark { number: self.marks, kind }
    }

    /// Something found while variables have other values.
    pub fn with<T>(&mut self, changes: Vec<(usize, Value)>, find: impl FnOnce(&mut Self) -> T) -> T {
        self.known.push((changes.iter().map(|(variable, _)| *variable).collect(), Known::new()));
        let replace = |(variable, value): (usize, Value)| (variable, self.values[variable].replace(value));
        let before: Vec<(usize, Option<Value>)> = changes.into_iter().map(replace).collect();
        let found = find(self);
        self.known.pop();
        for (variable, value) in before.into_iter().rev() {
            self.values[variable] = value;
        }
        found
    }

    /// The coefficients of a term as a polynomial in a variable, by ascending power.
    pub fn coefficients(&mut self, term: &Term, variable: usize) -> Tried<Vec<Value>> {
        match term {
            Term::Defined(name) => {
                self.once(*name, Some(variable), |place| place.coefficients_of(term, variable))
            }
            _ => self.coefficients_of(term, variable),
        }
    }

    fn coefficients_of(&mut self, term: &Term, variable: usize) -> Tried<Vec<Value>> {
        let mark = self.quantity(Kind::Free);
        let free = Value::with_quantity(Value::whole(0), mark);
        let value = self.with(vec![(variable, free)], |place| place.value(term))?;
        Ok(value.coefficients(mark))
    }

    pub fn number(&mut self, term: &Term) -> Tried<Number> {
        self.value(term)?.number()
    }

    pub fn value(&mut self, term: &Term) -> Tried<Value> {
        if !self.book.takes_a_step() {
            return Err(Trouble::Open);
        }
        match term {
            Term::Number(value) => Ok(self.rational(value)),
            Term::Variable(variable) => self.get(*variable),
            Term::Defined(name) => self.meaning(*name),
            Term::Sum(parts) => self.joined(parts, 0, Value::plus),
            Term::Product(parts) => self.joined(parts, 1, Value::times),
            Term::Quotient(above, below) => {
                let above = self.value(above)?;
                above.over(&self.value(below)?)
            }
            Term::Negation(inner) => Ok(self.value(inner)?.negated()),
            Term::Power(inner, exponent) => self.value(inner)?.power(*exponent),
            Term::Call(function, inner) => {
                let bits = self.bits;
                self.value(inner)?.call(*function, bits)
            }
            Term::Polynomial(first, inner) => {
                let at = self.value(inner)?;
                self.polynomial(*first, &at)
            }
        }
    }

    /// The sum or the product of parts, from its value without any.
    fn joined(
        &mut self,
        parts: &[Term],
        none: i32,
        join: fn(&Value, &Value) -> Tried<Value>,
    ) -> Tried<Value> {
        let Some((first, others)) = parts.split_first() else { return Ok(Value::whole(none)) };
        let first = self.value(first)?;
        others.iter().try_fold(first, |found, part| join(&found, &self.value(part)?))
    }

    /// c_0 + x·(c_1 + x/2·(c_2 + x/3·(…))) with the values c_k at 0 of a function and of its derivatives.
    fn polynomial(&mut self, first: usize, x: &Value) -> Tried<Value> {
        let mut sum = Value::whole(0);
        for variable in self.book.coefficients_from(first).rev() {
            if !sum.is_exactly_zero() {
                let next = i32::try_from(variable - first + 1).map_err(|_| Trouble::Open)?;
                sum = sum.times(x)?.over(&Value::whole(next))?;
            }
            sum = sum.plus(&self.get(variable)?)?;
        }
        Ok(sum)
    }

    fn meaning(&mut self, name: usize) -> Tried<Value> {
        let book = self.book;
        let found = self.once(name, None, |place| {
            let found = match book.meaning(name) {
                Meaning::Term(term) => place.value(term),
                Meaning::Derived(derived) => place.derived(derived),
            };
            found.map(|value| vec![value])
        });
        found.map(|mut alone| alone.swap_remove(0))
    }

    /// What is found of a name, once for as long as nothing changes that it reaches; the variable of a polynomial has no value in it.
    fn once(
        &mut self,
        name: usize,
        of: Option<usize>,
        find: impl FnOnce(&mut Self) -> Tried<Vec<Value>>,
    ) -> Tried<Vec<Value>> {
        let reached = self.book.reach_of(name);
        let changes = |variable: &usize| Some(*variable) != of && reached.contains(variable);
        let changed = self.known.iter().rposition(|(changed, _)| changed.iter().any(changes));
        let place = changed.unwrap_or_default();
        if let Some(found) = self.known[place].1.get(&(name, of)) {
            return found.clone();
        }
        let found = find(self);
        self.known[place].1.insert((name, of), found.clone());
        found
    }

    fn derived(&mut self, derived: &Derived) -> Tried<Value> {
        let own = match (derived.operation, &derived.terms[..], &derived.variables[..]) {
            (Operation::Characteristic, _, [s]) => self.characteristic(derived, *s),
            (Operation::Linearised, _, [rate, by]) => {
                let place = |name: &usize| derived.states.iter().position(|state| state == name);
                match (place(rate), place(by)) {
                    (Some(rate), Some(by)) => Ok(self.slopes(derived, by)?.swap_remove(rate)),
                    _ => Err(Trouble::Open),
                }
            }
            (Operation::Rate, [f], _) => self.rate(derived, f),
            (Operation::Coefficient | Operation::Leading, [f], [x]) => {
                let list = self.coefficients(f, *x)?;
                Ok(list.get(derived.whole).cloned().unwrap_or_else(|| Value::whole(0)))
            }
            (Operation::Derivative, [f], [x]) => {
                let at = self.get(*x)?;
                self.slope(f, vec![(*x, at, Value::whole(1))])
            }
            (Operation::Solve, [f], [x]) => self.solution(f, *x),
            (Operation::At, [f], _) => {
                let values =
                    derived.values.iter().map(|(variable, value)| Ok((*variable, self.value(value)?)));
                let values = values.collect::<Tried<_>>()?;
                self.with(values, |place| place.value(f))
            }
            (Operation::Exchange, [f], [x, y]) => {
                let both = vec![(*x, self.get(*y)?), (*y, self.get(*x)?)];
                self.with(both, |place| place.value(f))
            }
            _ => Err(Trouble::Open),
        };
        match (own, &derived.found) {
            (Err(Trouble::Open), Some(found)) => self.value(found),
            (own, _) => own,
        }
    }

    /// The derivative of a term along a direction, at values of some variables.
    fn slope(&mut self, term: &Term, along: Vec<(usize, Value, Value)>) -> Tried<Value> {
        self.slopes_of(std::slice::from_ref(term), along).map(|mut alone| alone.swap_remove(0))
    }

    fn slopes_of(&mut self, terms: &[Term], along: Vec<(usize, Value, Value)>) -> Tried<Vec<Value>> {
        let mark = self.quantity(Kind::Small);
        let moved = along.into_iter().map(|(variable, start, by)| {
            let rests = by.is_exactly_zero();
            (variable, if rests { start } else { Value::Series(mark, vec![start, by]) })
        });
        let moved = moved.collect();
        let slope = |value: Tried<Value>| value.map(|value| value.coefficient(mark, 1));
        self.with(moved, |place| terms.iter().map(|term| slope(place.value(term))).collect())
    }

    fn steady(&mut self, derived: &Derived) -> Tried<Vec<Value>> {
        if derived.steady.is_empty() {
            return Err(Trouble::Open);
        }
        derived.steady.iter().map(|one| self.value(one)).collect()
    }

    /// The slopes of all rates in one state, at the steady state.
    fn slopes(&mut self, derived: &Derived, by: usize) -> Tried<Vec<Value>> {
        let steady = self.steady(derived)?;
        let direction = |at: usize| Value::whole(i32::from(at == by));
        let along = derived.states.iter().zip(steady).enumerate();
        let along = along.map(|(at, (state, value))| (*state, value, direction(at)));
        self.slopes_of(&derived.rates, along.collect())
    }

    /// det(s − J).
    fn characteristic(&mut self, derived: &Derived, s: usize) -> Tried<Value> {
        let (size, s) = (derived.states.len(), self.get(s)?);
        let columns = (0..size).map(|by| self.slopes(derived, by)).collect::<Tried<Vec<_>>>()?;
        let mut rows = Vec::new();
        for row in 0..size {
            let mut entries: Vec<Value> = columns.iter().map(|column| column[row].negated()).collect();
            entries[row] = entries[row].plus(&s)?;
            rows.push(entries);
        }
        determinant(&rows)
    }

    fn rate(&mut self, derived: &Derived, f: &Term) -> Tried<Value> {
        let along = derived.states.iter().zip(&derived.rates);
        let along = along.map(|(state, rate)| Ok((*state, self.get(*state)?, self.value(rate)?)));
        let along = along.collect::<Tried<_>>()?;
        self.slope(f, along)
    }

    /// The one zero of what is linear in a variable, or has its square alone and the variable is positive.
    fn solution(&mut self, f: &Term, x: usize) -> Tried<Value> {
        let bits = self.bits;
        match &self.coefficients(f, x)?[..] {
            [rest, slope] => rest.negated().over(slope),
            [rest, none, square] if none.is_exactly_zero() => {
                rest.negated().over(square)?.call(Function::Sqrt, bits)
            }
            _ => Err(Trouble::Open),
        }
    }
}

/// A determinant, along its first column.
fn determinant(rows: &[Vec<Value>]) -> Tried<Value> {
    if rows.is_empty() {
        return Ok(Value::whole(1));
    }
    let mut sum = Value::whole(0);
    for (at, row) in rows.iter().enumerate().filter(|(_, row)| !row[0].is_exactly_zero()) {
        let others = rows.iter().enumerate().filter(|(other, _)| *other != at);
        let minor = determinant(&others.map(|(_, row)| row[1..].to_vec()).collect::<Vec<_>>())?;
        let term = row[0].times(&minor)?;
        sum = if at % 2 == 0 { sum.plus(&term)? } else { sum.minus(&term)? };
    }
    Ok(sum)
}

/// Whether a value is zero. A value with an imaginary part is zero where both parts are.
pub(super) fn is_zero(value: &Value) -> Tried<bool> {
    match value {
        Value::Number(number) => number.sign().map(Ordering::is_eq).ok_or(Trouble::Open),
        Value::Series(_, terms) => all(terms.iter().map(is_zero)),
    }
}
