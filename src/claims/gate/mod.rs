//! The last gate: before a verdict on a formula leaves the program, it is tested against the claim as it is written.
//!
//! The gate shares no code with the prover. It walks the expressions as the user wrote them, finds names on the way, and evaluates in
//! exact rationals and in balls with outward rounding. A counter-example has to make the formula false with certainty. A claim that
//! holds is tried at a thousand points that meet its conditions, their edges included. What contradicts a verdict is an error of the
//! program, never a verdict.
//!
//! Statements on motions and on rows of tables are not evaluated.

mod behaviour;
mod book;
mod claim;
mod evaluate;
mod number;
mod points;
mod polynomial;
mod roots;
mod truth;
mod value;

use std::cmp::Ordering;

use slipmode_core::number::Rational;
use slipmode_theory::Equations;

use crate::claims::finding::NamedPoint;
use crate::claims::{Finding, Verdict};
use crate::scene::ClaimFormula;
use behaviour::Tail;
use claim::{At, Base, Claim, Says};
use evaluate::AtPoint;
use points::{Sequence, power_of_two};
use truth::Said;

/// At how many points a claim that holds is tried.
const POINTS: usize = 1000;

/// How many points are looked at for that, and at how many of those next to an edge.
const LOOKED_AT: u32 = 3000;
const EDGE_STARTS: usize = 12;

/// At one of so many points that stay open the precision is raised.
const OPEN: u32 = 8;

/// Along how many sequences a limit is followed, and from how many points a counter-example to it.
const SEQUENCES: usize = 16;

/// What the gate found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Nothing contradicts the verdict. So many points were tried, and so many of them stayed open.
    Passed { points: usize, open: usize },
    /// There is nothing that the gate evaluates.
    NotEvaluated(String),
    /// A counter-example, or a point that shows that there is one, does not show it with certainty.
    Unconfirmed(String),
    /// The verdict is wrong.
    Contradicted(String),
}

/// The finding, if the gate does not contradict it. Else the formula is not checked, and the finding says that the program is at fault.
pub(super) fn passed(formula: &ClaimFormula, finding: Finding, equations: &Equations) -> Finding {
    let verdict = finding.verdict.as_str();
    match tested(formula, &finding, equations) {
        Outcome::Passed { .. } | Outcome::NotEvaluated(_) => finding,
        Outcome::Unconfirmed(why) => Finding::not_checked(format!(
            "Not decided: the proof says that '{}' {verdict}, and an independent evaluation does not confirm it. {why}",
            formula.text
        )),
        Outcome::Contradicted(why) => Finding::contradicted(format!(
            "the proof says that '{}' {verdict}, and an independent evaluation contradicts it. {why}",
            formula.text
        )),
    }
}

/// Tests a verdict on a formula.
pub(super) fn tested(formula: &ClaimFormula, finding: &Finding, equations: &Equations) -> Outcome {
    let holds = match finding.verdict {
        Verdict::Holds => true,
        Verdict::Fails => false,
        Verdict::HoldsWithin | Verdict::NotChecked => {
            return Outcome::NotEvaluated("there is no verdict".into());
        }
    };
    let claim = match Claim::of(formula, equations) {
        None => return Outcome::NotEvaluated("a statement on motions or rows".into()),
        Some(Err(why)) => return Outcome::NotEvaluated(why),
        Some(Ok(claim)) => claim,
    };
    if finding.points.iter().any(|point| claim.misses(point)) {
        return Outcome::Unconfirmed("A function has too many terms at the point.".into());
    }
    let points: Vec<Base> = finding.points.iter().map(|point| claim.base(point)).collect();
    match (&claim.says, holds) {
        (Says::True(said), true) if claim.there_is.is_empty() => {
            claim.tallied(&|place: &mut AtPoint| said.truth(place), |starts| claim.edges(said, starts))
        }
        (Says::True(said), false) if claim.there_is.is_empty() => claim.counter_example(said, &points),
        (Says::True(said), true) => claim.somewhere(said, &points),
        (Says::True(said), false) => claim.nowhere(said, &points),
        (Says::Limit(side, goal, variable, toward), _) => {
            let tail = |base: &Base| claim.tail(side, goal, *variable, *toward, base);
            claim.limit(holds, &points, tail)
        }
        (Says::Monotone(side, comparison, variable), _) => {
            let refutes = |pair: [&Base; 2]| claim.refutes_monotone(side, *comparison, *variable, pair);
            match holds {
                true => claim.no_pair(*variable, "It does not", refutes),
                false => claim.not_monotone(&points, *variable, refutes),
            }
        }
        (Says::Depends(side, depends, variable), _) => {
            let order = |[one, other]: [&Base; 2]| claim.compared(side, one, other);
            match *depends == holds {
                true => claim.differs(&points, *variable, order),
                false => {
                    claim.no_pair(*variable, "It differs", |pair| order(pair).is_some_and(Ordering::is_ne))
                }
            }
        }
    }
}

/// What was found so far on a formula that holds.
#[derive(Default)]
struct Tally {
    tried: usize,
    open: usize,
    /// The first points that were tried.
    starts: Vec<Base>,
}

impl Tally {
    /// Adds what a point says, and says what contradicts there.
    fn add(&mut self, claim: &Claim, base: Base, found: At) -> Option<Outcome> {
        self.tried += usize::from(found != At::Outside);
        self.open += usize::from(found == At::Open);
        let words = match found {
            At::Says(false) => "it is false.",
            At::NoValue => "a side has no value.",
            _ => {
                let is_start = found == At::Says(true) && self.starts.len() < EDGE_STARTS;
                self.starts.extend(is_start.then_some(base));
                return None;
            }
        };
        Some(Outcome::Contradicted(format!("At {} {words}", claim.text(&base))))
    }
}

impl Claim {
    /// Whether a point gives a function more terms than are evaluated.
    fn misses(&self, point: &NamedPoint) -> bool {
        point.keys().any(|name| name.ends_with(')') && self.book.place(name).is_none())
    }

    /// The values of a point for the variables that are chosen; a variable that the point leaves out has the value 1, a term of a
    /// function the factor 0.
    fn base(&self, point: &NamedPoint) -> Base {
        let value = |variable: &usize| {
            let known = point.get(self.book.name(*variable)).cloned();
            let other = i32::from(self.book.order(*variable).is_none());
            (*variable, known.unwrap_or_else(|| Rational::from(other)))
        };
        self.chosen.iter().map(value).collect()
    }

    /// Points that meet the conditions, each with what it says of something.
    fn answers<'c>(
        &'c self,
        ask: &'c impl Fn(&mut AtPoint) -> number::Tried<bool>,
    ) -> impl Iterator<Item = (Base, At)> + 'c {
        let mut sequence = Sequence::new();
        (0..LOOKED_AT).filter_map(move |turn| {
            let answer = |base: Base| {
                let found = if turn % OPEN == 0 { self.at(&base, ask) } else { self.quickly_at(&base, ask) };
                (found != At::Outside).then_some((base, found))
            };
            let point = self.point(turn, &mut sequence);
            answer(point.clone()).or_else(|| answer(self.repaired(point, turn)?))
        })
    }

    /// Points that meet the conditions.
    fn inside(&self) -> impl Iterator<Item = Base> + '_ {
        self.answers(&|_: &mut AtPoint| Ok(true)).map(|(base, _)| base)
    }

    /// Points next to where a comparison, a predicate or a condition changes.
    fn edges(&self, said: &Said, starts: &[Base]) -> Vec<Base> {
        let mut found = Vec::new();
        let places = |turn: usize| starts.iter().zip(self.chosen.iter().cycle().skip(turn));
        let sides = said.atoms().into_iter().filter_map(|atom| match atom {
            Said::Compare(compared) => Some(compared),
            _ => None,
        });
        let sides = sides.chain(&self.conditions);
        for (turn, compared) in sides.enumerate() {
            for (base, variable) in places(turn) {
                found.extend(self.near_zero(base, compared, *variable).into_iter().flatten());
            }
        }
        for (turn, atom) in said.atoms().into_iter().enumerate() {
            for (base, variable) in places(turn) {
                found.extend(self.next_to_edge(base, *variable, &|place: &mut AtPoint| atom.truth(place)));
            }
        }
        let is_possible = |base: &Base| {
            base.iter().all(|(variable, value)| !self.book.is_positive(*variable) || *value > 0)
        };
        found.retain(is_possible);
        found
    }

    /// What is true at all values that the conditions allow, and at the edges next to the first ones.
    fn tallied(
        &self,
        ask: &impl Fn(&mut AtPoint) -> number::Tried<bool>,
        edges: impl FnOnce(&[Base]) -> Vec<Base>,
    ) -> Outcome {
        let mut tally = Tally::default();
        let found = self.answers(ask).take(POINTS).find_map(|(base, at)| tally.add(self, base, at));
        let found = found.or_else(|| {
            edges(&tally.starts).into_iter().find_map(|base| {
                let at = self.at(&base, ask);
                tally.add(self, base, at)
            })
        });
        found.unwrap_or(Outcome::Passed { points: tally.tried, open: tally.open })
    }

    /// A point at which a formula is false.
    fn counter_example(&self, said: &Said, points: &[Base]) -> Outcome {
        let Some(base) = points.first() else {
            return Outcome::Unconfirmed("The counter-example names no point.".into());
        };
        let place = self.text(base);
        match self.at(base, &|place: &mut AtPoint| said.truth(place)) {
            At::Says(false) => Outcome::Passed { points: 1, open: 0 },
            At::Says(true) => Outcome::Contradicted(format!("At {place} it is true.")),
            At::NoValue => Outcome::Contradicted(format!("At {place} a side has no value.")),
            At::Open => Outcome::Unconfirmed(format!("At {place} enclosures leave it open.")),
            At::Outside if self.decided(base, |place| self.allows(place)) == Ok(false) => {
                Outcome::Contradicted(format!("At {place} a condition is not met."))
            }
            At::Outside => Outcome::Unconfirmed(format!("At {place} enclosures leave a condition open.")),
        }
    }

    /// Whether the values of the variables of `there_is` that the witness has at a point do.
    fn witness_does(&self, said: &Said, place: &mut AtPoint) -> number::Tried<bool> {
        let values = self.witness.iter().map(|(variable, value)| Ok((*variable, place.value(value)?)));
        for (variable, value) in values.collect::<number::Tried<Vec<_>>>()? {
            place.set(variable, value);
        }
        self.does(said, place)
    }

    /// Whether the values of the variables of `there_is` at a point do.
    fn does(&self, said: &Said, place: &mut AtPoint) -> number::Tried<bool> {
        number::all([self.allows_inner(place), said.truth(place)].into_iter())
    }

    /// For all values of the other variables there is one that does: without other variables the point that was found, else the
    /// witness.
    fn somewhere(&self, said: &Said, points: &[Base]) -> Outcome {
        if let Some(base) = points.first() {
            return match self.at(base, &|place: &mut AtPoint| self.does(said, place)) {
                At::Says(true) => Outcome::Passed { points: 1, open: 0 },
                At::Says(false) | At::NoValue => {
                    Outcome::Contradicted(format!("At {} it is false.", self.text(base)))
                }
                At::Open | At::Outside => {
                    Outcome::Unconfirmed(format!("At {} enclosures leave it open.", self.text(base)))
                }
            };
        }
        if self.witness.is_empty() {
            return Outcome::Unconfirmed("The proof names no point.".into());
        }
        self.tallied(&|place: &mut AtPoint| self.witness_does(said, place), |_| Vec::new())
    }

    /// At the values of the other variables that the point names there is no value that does.
    fn nowhere(&self, said: &Said, points: &[Base]) -> Outcome {
        let Some(named) = points.first() else {
            return Outcome::Unconfirmed("The proof names no values of the other variables.".into());
        };
        let mut tried = 0;
        for (turn, other) in self.inside().take(POINTS).enumerate() {
            let mut base = named.clone();
            for variable in &self.there_is {
                base.extend(other.get(variable).map(|value| (*variable, value.clone())));
            }
            // The witness first, then values by chance.
            let does = if turn == 0 { Self::witness_does } else { Self::does };
            match self.at(&base, &|place: &mut AtPoint| does(self, said, place)) {
                At::Says(true) => {
                    return Outcome::Contradicted(format!("At {} it is true.", self.text(&base)));
                }
                At::Outside if self.decided(&base, |place| self.allows(place)) == Ok(false) => {
                    return Outcome::Contradicted(format!("At {} a condition is not met.", self.text(&base)));
                }
                _ => tried += 1,
            }
        }
        Outcome::Passed { points: tried, open: 0 }
    }

    /// Pairs of points that meet the conditions and differ in the variable that moves.
    fn pairs(&self, variable: usize, count: usize) -> impl Iterator<Item = [Base; 2]> + '_ {
        let mut sequence = Sequence::new();
        let bases: Vec<Base> = self.inside().take(count).collect();
        let values: Vec<Base> = bases.iter().take(64).cloned().collect();
        bases.into_iter().filter_map(move |base| {
            let here = base.get(&variable)?.clone();
            let other = match sequence.below(3) {
                0 => here * (power_of_two(-(sequence.below(20) as i32)) + 1_u32),
                _ => values.get(sequence.below(values.len() as u32) as usize)?.get(&variable)?.clone(),
            };
            let moved = Self::moved(&base, variable, other);
            (moved != base && self.is_inside(&moved)).then_some([base, moved])
        })
    }

    /// No two points show what would contradict.
    fn no_pair(&self, variable: usize, words: &str, contradicts: impl Fn([&Base; 2]) -> bool) -> Outcome {
        if !self.is_solved_plainly {
            return Outcome::NotEvaluated("which variable moves along is open".into());
        }
        let mut tried = 0;
        for [one, other] in self.pairs(variable, POINTS) {
            if contradicts([&one, &other]) {
                let place = self.text(&one);
                let (name, value) = (self.book.name(variable), &other[&variable]);
                return Outcome::Contradicted(format!("{words} at {place} and {name} = {value}."));
            }
            tried += 1;
        }
        Outcome::Passed { points: tried, open: 0 }
    }

    /// Two points, or a point next to which the side moves the wrong way.
    fn not_monotone(
        &self,
        points: &[Base],
        variable: usize,
        refutes: impl Fn([&Base; 2]) -> bool,
    ) -> Outcome {
        if !self.is_solved_plainly {
            return Outcome::NotEvaluated("which variable moves along is open".into());
        }
        let Some(base) = points.first() else {
            return Outcome::Unconfirmed("The counter-example names no point.".into());
        };
        let Some(here) = base.get(&variable) else {
            return Outcome::NotEvaluated("the variable that moves has one value".into());
        };
        let near = (0..16).flat_map(|turn| {
            let step = power_of_two(-2 * turn) * (Rational::from(here.abs_ref()) + power_of_two(-4)) / 2_u32;
            [Rational::from(here + &step), Rational::from(here - &step)]
        });
        let near = near.map(|value| Self::moved(base, variable, value));
        match points[1..].iter().cloned().chain(near).any(|other| refutes([base, &other])) {
            true => Outcome::Passed { points: 1, open: 0 },
            false => Outcome::Unconfirmed(format!("Next to {} no pair of points shows it.", self.text(base))),
        }
    }

    /// Two points at which the side differs.
    fn differs(
        &self,
        points: &[Base],
        variable: usize,
        order: impl Fn([&Base; 2]) -> Option<Ordering>,
    ) -> Outcome {
        let [one, other, ..] = points else {
            return Outcome::Unconfirmed("The proof names no two points.".into());
        };
        let differ_in = one.iter().filter(|(name, value)| other.get(name) != Some(value));
        let Some(moved) = other.get(&variable) else {
            return Outcome::NotEvaluated("the variable that moves has one value".into());
        };
        let places = format!("{} and {} = {moved}", self.text(one), self.book.name(variable));
        let is_pair = differ_in.map(|(name, _)| *name).eq([variable]);
        if !is_pair || !self.is_inside(one) || !self.is_inside(other) {
            return Outcome::Contradicted(format!("The points {places} do not meet the conditions."));
        }
        match order([one, other]) {
            Some(Ordering::Equal) => Outcome::Contradicted(format!("It is the same at {places}.")),
            Some(_) => Outcome::Passed { points: 1, open: 0 },
            None => Outcome::Unconfirmed(format!("At {places} enclosures leave it open.")),
        }
    }

    /// A limit that holds, or one that does not from a point on. A tail that is not clear contradicts nothing.
    fn limit(&self, holds: bool, points: &[Base], tail: impl Fn(&Base) -> Tail) -> Outcome {
        let bases = if holds { self.inside().take(SEQUENCES).collect() } else { points.to_vec() };
        let (mut clear, mut open) = (0, 0);
        for base in &bases {
            match (tail(base), holds) {
                (Tail::There, true) | (Tail::Elsewhere(_), false) => clear += 1,
                (Tail::Unclear, _) => open += 1,
                (Tail::Elsewhere(words), true) => {
                    return Outcome::Contradicted(format!("Along {} the side {words}.", self.text(base)));
                }
                (Tail::There, false) => {
                    return Outcome::Contradicted(format!(
                        "Along {} it tends to the value.",
                        self.text(base)
                    ));
                }
            }
        }
        Outcome::Passed { points: clear + open, open }
    }
}

#[cfg(test)]
mod tests;
