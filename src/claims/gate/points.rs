//! Points at which a claim is tried: numbers over many decades, small numbers, squares, equal values, and edges of comparisons.

use slipmode_core::number::Rational;

use super::book::Compared;
use super::claim::{At, Base, Claim};
use super::evaluate::{AtPoint, NEAR, is_zero};
use super::number::{Number, Tried};
use super::value::Value;

/// A sequence of numbers that is the same everywhere.
pub(super) struct Sequence(u64);

impl Sequence {
    pub fn new() -> Self {
        Self(0x51_1d_e4_0d)
    }

    pub fn below(&mut self, end: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(end)) as u32
    }
}

/// 2^exponent.
pub(super) fn power_of_two(exponent: i32) -> Rational {
    let size = Rational::from(1) << exponent.unsigned_abs();
    if exponent < 0 { size.recip() } else { size }
}

impl Claim {
    /// A point without regard to the conditions.
    pub fn point(&self, turn: u32, sequence: &mut Sequence) -> Base {
        let mut base = Base::new();
        for variable in &self.chosen {
            let within = self.within.iter().find(|(one, _)| one == variable);
            let value = match within {
                Some((_, [low, high])) => {
                    low + Rational::from(high - low) * Rational::from((sequence.below(17), 16))
                }
                None => match self.book.order(*variable) {
                    Some(order) => coefficient(order, turn, sequence),
                    None => self.unbounded(*variable, turn, sequence),
                },
            };
            base.insert(*variable, value);
        }
        if turn % 8 == 6 && self.chosen.len() > 1 {
            let mut any = || self.chosen[sequence.below(self.chosen.len() as u32) as usize];
            let (one, other) = (any(), any());
            if self.within.iter().all(|(variable, _)| *variable != one) && self.book.is_positive(other) {
                base.insert(one, base[&other].clone());
            }
        }
        base
    }

    fn unbounded(&self, variable: usize, turn: u32, sequence: &mut Sequence) -> Rational {
        let mut small = |end: u32| 1 + sequence.below(end);
        let size = match turn % 8 {
            0 => Rational::from(if turn == 0 { 1 } else { small(3) }),
            1 | 2 => Rational::from((small(63), 16)) * power_of_two(small(41) as i32 - 21),
            3 | 4 => Rational::from((small(31), 16)) * power_of_two(small(9) as i32 - 5),
            5 => {
                let root = Rational::from((small(12), small(8)));
                Rational::from(root.square_ref())
            }
            _ => Rational::from((small(9), small(3))),
        };
        match (self.book.is_positive(variable), small(9)) {
            (true, _) => size,
            (false, 1) => Rational::new(),
            (false, 2..=5) => -size,
            (false, _) => size,
        }
    }

    /// The point moved so that it meets the conditions, one condition and one variable at a time.
    pub fn repaired(&self, mut base: Base, turn: u32) -> Option<Base> {
        for _ in 0..=self.conditions.len() {
            let unmet = self.conditions.iter().find(|one| self.compares(&base, one) != Ok(true));
            let Some(unmet) = unmet else { return Some(base) };
            let count = self.chosen.len();
            let variables = (0..count).map(|at| self.chosen[(at + turn as usize) % count]);
            let mut moved = variables.filter_map(|variable| self.near_zero(&base, unmet, variable)).flatten();
            let next = moved.find(|moved| {
                self.chosen.iter().all(|one| !self.book.is_positive(*one) || moved[one] > 0)
                    && self.compares(moved, unmet) == Ok(true)
            })?;
            drop(moved);
            base = next;
        }
        None
    }

    /// The point with the value of one variable at which two sides are equal, and values next to it, where they are linear in it.
    pub fn near_zero(
        &self,
        base: &Base,
        compared: &Compared,
        variable: usize,
    ) -> Option<impl Iterator<Item = Base>> {
        let difference = compared.difference();
        let coefficients =
            |bits: u32| self.place_for(base, bits, compared)?.coefficients(&difference, variable).ok();
        let is_bent = |near: Vec<Value>| near.iter().skip(2).any(|one| is_zero(one) == Ok(false));
        if coefficients(NEAR).is_some_and(is_bent) {
            return None;
        }
        let Ok([rest, slope]) = <[Value; 2]>::try_from(coefficients(96)?) else { return None };
        let Ok(Number::Exact(zero)) = rest.negated().over(&slope).and_then(Value::number) else {
            return None;
        };
        let step = power_of_two(-30) * (Rational::from(zero.abs_ref()) + power_of_two(-10));
        let values = [
            zero.clone(),
            Rational::from(&zero + &step),
            Rational::from(&zero - &step),
            Rational::from(&zero * 2_u32),
            Rational::from(&zero / 2_u32),
            Rational::from(&zero + 1_u32),
            Rational::from(&zero - 1_u32),
        ];
        Some(values.into_iter().map(move |value| Self::moved(base, variable, value)))
    }

    /// Points to both sides of where the truth of something changes as one variable grows from a point.
    pub fn next_to_edge(
        &self,
        base: &Base,
        variable: usize,
        ask: &impl Fn(&mut AtPoint) -> Tried<bool>,
    ) -> Vec<Base> {
        let with = |value: &Rational| Self::moved(base, variable, value.clone());
        let truth = |value: &Rational| match self.at(&with(value), ask) {
            At::Says(truth) => Some(truth),
            _ => None,
        };
        let start = base[&variable].clone();
        let Some(here) = truth(&start).filter(|_| start != 0) else { return Vec::new() };
        let scales = [1, -1, 3, -3, 8, -8, 20, -20];
        let across = scales.into_iter().map(|scale| power_of_two(scale) * &start);
        let Some(mut far) = across.into_iter().find(|value| truth(value) == Some(!here)) else {
            return Vec::new();
        };
        let mut near = start;
        for _ in 0..24 {
            let middle = Rational::from(&near + &far) / 2_u32;
            match truth(&middle) {
                Some(truth) if truth == here => near = middle,
                Some(_) => far = middle,
                None => break,
            }
        }
        vec![with(&near), with(&far)]
    }
}

/// The value at 0 of a derivative of a function: a small number. At most points the function is a polynomial of degree 1, 2 or 3.
fn coefficient(order: usize, turn: u32, sequence: &mut Sequence) -> Rational {
    let degree = [1, 2, 3, usize::MAX][turn as usize / 8 % 4];
    let value = Rational::from((sequence.below(19) as i32 - 9, 1 + sequence.below(4)));
    if order > degree { Rational::new() } else { value }
}
