//! Whether a formula is true at a point: Kleene's logic over comparisons and statements on roots.

use std::cmp::Ordering;

use slipmode_algebra::{Comparison, Expression};
use slipmode_theory::root_location::RootStatement;

use super::book::{Book, Compared, Term};
use super::evaluate::{AtPoint, NEAR, is_zero};
use super::number::{Number, Tried, Trouble, all};
use super::roots;
use super::value::{Kind, Value};
use crate::scene::{Crossing, Formula};

/// A formula with its names found.
#[derive(Debug, Clone)]
pub(super) enum Said {
    Compare(Compared),
    Roots(RootStatement, Term, usize),
    Crossing(Box<Crosses>),
    Not(Box<Said>),
    All(Vec<Said>),
    Any(Vec<Said>),
    Iff(Box<[Said; 2]>),
}

/// A pair of roots that crosses the axis.
#[derive(Debug, Clone)]
pub(super) struct Crosses {
    polynomial: Term,
    variable: usize,
    parameter: usize,
    critical: Term,
    frequency: Term,
}

impl Said {
    pub fn of(formula: &Formula, book: &mut Book) -> Self {
        let all =
            |parts: &[Formula], book: &mut Book| parts.iter().map(|part| Self::of(part, book)).collect();
        match formula {
            Formula::Compare(left, comparison, right) => {
                Self::Compare(Compared::of(left, *comparison, right, book))
            }
            Formula::Roots(statement, polynomial, variable) => Self::Roots(
                *statement,
                book.term(polynomial, Some(variable.as_str())),
                book.variable(variable.as_str()),
            ),
            Formula::Crossing(crossing) => {
                let Crossing { polynomial, variable, parameter, critical, frequency } = &**crossing;
                Self::Crossing(Box::new(Crosses {
                    polynomial: book.term(polynomial, Some(variable.as_str())),
                    variable: book.variable(variable.as_str()),
                    parameter: book.variable(parameter.as_str()),
                    critical: book.term(critical, None),
                    frequency: book.term(frequency, None),
                }))
            }
            Formula::Not(inner) => Self::Not(Box::new(Self::of(inner, book))),
            Formula::All(parts) => Self::All(all(parts, book)),
            Formula::Any(parts) => Self::Any(all(parts, book)),
            Formula::Implies(both) => {
                Self::Any(vec![Self::Not(Box::new(Self::of(&both[0], book))), Self::of(&both[1], book)])
            }
            Formula::Iff(both) => Self::Iff(Box::new([Self::of(&both[0], book), Self::of(&both[1], book)])),
        }
    }

    /// Its comparisons and predicates.
    pub fn atoms(&self) -> Vec<&Self> {
        match self {
            Self::Compare(_) | Self::Roots(..) | Self::Crossing(_) => vec![self],
            Self::Not(inner) => inner.atoms(),
            Self::All(parts) | Self::Any(parts) => parts.iter().flat_map(Self::atoms).collect(),
            Self::Iff(both) => both.iter().flat_map(Self::atoms).collect(),
        }
    }

    /// The terms in it.
    pub fn terms(&self) -> Vec<&Term> {
        self.atoms().into_iter().flat_map(Self::own_terms).collect()
    }

    fn own_terms(&self) -> Vec<&Term> {
        match self {
            Self::Compare(Compared { left, right, .. }) => vec![left, right],
            Self::Roots(_, polynomial, _) => vec![polynomial],
            Self::Crossing(crosses) => vec![&crosses.polynomial, &crosses.critical, &crosses.frequency],
            _ => Vec::new(),
        }
    }

    pub fn truth(&self, place: &mut AtPoint) -> Tried<bool> {
        match self {
            Self::Compare(compared) => compared.truth(place),
            Self::Roots(statement, polynomial, variable) => {
                let coefficients = numbers(place.coefficients(polynomial, *variable)?)?;
                roots::is_true(*statement, &coefficients).ok_or(Trouble::Open)
            }
            Self::Crossing(crosses) => crosses.truth(place),
            Self::Not(inner) => inner.truth(place).map(|truth| !truth),
            Self::All(parts) => all(parts.iter().map(|part| part.truth(place))),
            Self::Any(parts) => {
                let opposite = all(parts.iter().map(|part| part.truth(place).map(|truth| !truth)));
                opposite.map(|truth| !truth)
            }
            Self::Iff(both) => {
                let (left, right) = (both[0].truth(place), both[1].truth(place));
                Ok(left? == right?)
            }
        }
    }
}

fn numbers(values: Vec<Value>) -> Tried<Vec<Number>> {
    values.into_iter().map(Value::number).collect()
}

impl Compared {
    pub fn of(left: &Expression, comparison: Comparison, right: &Expression, book: &mut Book) -> Self {
        let (left, right) = (book.term(left, None), book.term(right, None));
        Self { left, comparison, right }
    }

    pub fn truth(&self, place: &mut AtPoint) -> Tried<bool> {
        // Intervals show no equality, and the sides of an equation are equal at most points.
        if place.bits == NEAR && self.comparison == Comparison::Equal {
            return Err(Trouble::Open);
        }
        let left = place.value(&self.left)?;
        let difference = left.minus(&place.value(&self.right)?)?;
        match (self.comparison, difference) {
            (comparison, Value::Number(number)) => {
                number.sign().map(|order| comparison.holds(order)).ok_or(Trouble::Open)
            }
            (Comparison::Equal, complex) => is_zero(&complex),
            (Comparison::Unequal, complex) => is_zero(&complex).map(|zero| !zero),
            _ => Err(Trouble::Open),
        }
    }

    /// Left minus right.
    pub fn difference(&self) -> Term {
        Term::Sum(vec![self.left.clone(), Term::Negation(Box::new(self.right.clone()))])
    }
}

impl Crosses {
    /// The critical value meets what is assumed of the parameter, and there P has the roots ±iω, ω is not 0, no other root is on the axis, and by implicit differentiation the slope
    /// of the pair's real part, −Re(∂P/∂K · conj ∂P/∂s)/|∂P/∂s|², is not 0.
    fn truth(&self, place: &mut AtPoint) -> Tried<bool> {
        // Intervals do not show that the pair is on the axis.
        if place.bits == NEAR {
            return Err(Trouble::Open);
        }
        let critical = place.value(&self.critical)?;
        if place.book.is_positive(self.parameter) {
            match critical.clone().number()?.sign() {
                None => return Err(Trouble::Open),
                Some(Ordering::Greater) => {}
                Some(_) => return Ok(false),
            }
        }
        let there = vec![(self.parameter, critical.clone())];
        if !place.with(there, |place| all(place.conditions.iter().map(|one| one.truth(place))))? {
            return Ok(false);
        }
        let frequency = place.value(&self.frequency)?;
        let square = frequency.times(&frequency)?;
        let small = place.quantity(Kind::Small);
        let moved = vec![(self.parameter, Value::with_quantity(critical, small))];
        let list = place.with(moved, |place| place.coefficients(&self.polynomial, self.variable))?;
        let at: Vec<Value> = list.iter().map(|one| one.coefficient(small, 0)).collect();
        let by: Vec<Value> = list.iter().map(|one| one.coefficient(small, 1)).collect();
        let along = at.iter().zip(0..).skip(1).map(|(one, power)| one.times(&Value::whole(power)));
        let along: Vec<Value> = along.collect::<Tried<_>>()?;
        let [real, imaginary] = on_axis(&at, &square)?;
        let [slope_real, slope_imaginary] = on_axis(&by, &square)?;
        let [root_real, root_imaginary] = on_axis(&along, &square)?;
        let slope =
            slope_real.times(&root_real)?.plus(&square.times(&slope_imaginary.times(&root_imaginary)?)?)?;
        let others = numbers(without_pair(&at, &square)?)?;
        let apart = roots::is_one_on_axis(&others).map(|one| !one).ok_or(Trouble::Open);
        let not_zero = |value: &Value| is_zero(value).map(|zero| !zero);
        let parts = [not_zero(&frequency), is_zero(&real), is_zero(&imaginary), not_zero(&slope), apart];
        all(parts.into_iter())
    }
}

/// A and B with Σ c_k (iω)^k = A + iω·B, for the square of ω.
fn on_axis(coefficients: &[Value], square: &Value) -> Tried<[Value; 2]> {
    let part = |start: usize| {
        coefficients
            .iter()
            .skip(start)
            .step_by(2)
            .rev()
            .try_fold(Value::whole(0), |sum, coefficient| coefficient.minus(&sum.times(square)?))
    };
    Ok([part(0)?, part(1)?])
}

/// The quotient by s² + ω².
fn without_pair(coefficients: &[Value], square: &Value) -> Tried<Vec<Value>> {
    let mut quotient: Vec<Value> = Vec::new();
    for coefficient in coefficients.iter().skip(2).rev() {
        let next = match &quotient[..] {
            [.., before, _] => coefficient.minus(&before.times(square)?)?,
            _ => coefficient.clone(),
        };
        quotient.push(next);
    }
    quotient.reverse();
    Ok(quotient)
}
