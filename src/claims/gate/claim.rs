//! A claim as the gate reads it: what is said, over which points, with all names found on the tree as it is written.

use std::cell::Cell;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Comparison, End, Toward};
use slipmode_core::number::Rational;
use slipmode_theory::Equations;

use super::book::{Book, Compared, EITHER_SIGN, Term, UNIT};
use super::evaluate::{AtPoint, NEAR};
use super::number::{Number, Tried, Trouble, all};
use super::truth::Said;
use super::value::Value;
use crate::scene::{ClaimFormula, Statement};

/// Values of the variables that are chosen; those of the others follow from the conditions.
pub(super) type Base = BTreeMap<usize, Rational>;

/// The precisions, one after the other while something stays open: most points need intervals of 64-bit numbers only.
const BITS: [u32; 3] = [NEAR, 96, 512];

/// What a point says of something.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    /// It does not meet the conditions, or it is not known to.
    Outside,
    /// It meets them, and the enclosures stay too wide.
    Open,
    /// It meets them, and a side has no value there.
    NoValue,
    Says(bool),
}

/// What is said.
pub(super) enum Says {
    True(Said),
    Limit(Term, Goal, usize, Toward),
    Monotone(Term, Comparison, usize),
    Depends(Term, bool, usize),
}

/// Where a side is said to go.
pub(super) enum Goal {
    Value(Term),
    /// Beyond all bounds.
    Infinity(Ordering),
}

/// An equation among the conditions, and the variable that it is solved for.
struct Solved {
    difference: Term,
    variable: usize,
    /// The other side, if one side is the variable and the other one does not reach it.
    value: Option<Term>,
}

/// A claim with what it assumes.
pub(super) struct Claim {
    pub book: Book,
    pub says: Says,
    /// Conditions that are no equations.
    pub conditions: Vec<Compared>,
    pub within: Vec<(usize, [Rational; 2])>,
    at: Vec<(usize, Rational)>,
    pub there_is: Vec<usize>,
    pub witness: Vec<(usize, Term)>,
    /// The variables whose values are chosen.
    pub chosen: Vec<usize>,
    solved: Vec<Solved>,
    /// Whether each equation has one side that is the variable it is solved for, so that no other choice is at hand.
    pub is_solved_plainly: bool,
    has_two_signs: bool,
}

impl Claim {
    /// The claim; none for statements on motions and rows, which the gate does not evaluate.
    ///
    /// # Errors
    /// When an equation among the conditions is not solved by the gate.
    pub fn of(formula: &ClaimFormula, equations: &Equations) -> Option<Result<Self, String>> {
        let mut book = Book::of(equations);
        let says = match &formula.statement {
            Statement::True(said) => Says::True(Said::of(said, &mut book)),
            Statement::Limit(left, value, variable, toward) => {
                let goal = match value {
                    End::Finite(value) => Goal::Value(book.term(value, None)),
                    End::Infinite(sign) => Goal::Infinity(sign.cmp(&0)),
                };
                Says::Limit(book.term(left, None), goal, book.variable(variable.as_str()), *toward)
            }
            Statement::Monotone(side, comparison, variable) => {
                Says::Monotone(book.term(side, None), *comparison, book.variable(variable.as_str()))
            }
            Statement::Depends(side, depends, variable) => {
                Says::Depends(book.term(side, None), *depends, book.variable(variable.as_str()))
            }
            Statement::Motion(_) | Statement::Computed(_) => return None,
        };
        if formula.rows.is_some() {
            return None;
        }
        let scope = &formula.scope;
        let given = scope.given.iter().map(|one| (&one.sides, one.comparison));
        let given = given.map(|([left, right], comparison)| Compared::of(left, comparison, right, &mut book));
        let (equal, conditions): (Vec<_>, Vec<_>) =
            given.partition(|one| one.comparison == Comparison::Equal);
        let within =
            scope.within.iter().map(|(name, ends)| (book.variable(name.as_str()), ends.clone())).collect();
        let at = scope.at.iter().map(|(name, value)| (book.variable(name.as_str()), value.clone())).collect();
        let there_is = scope.there_is.iter().map(|name| book.variable(name.as_str())).collect();
        let witness = scope
            .witness
            .iter()
            .map(|(name, value)| (book.variable(name.as_str()), book.term(value, None)))
            .collect();
        let mut claim = Self {
            book,
            says,
            conditions,
            within,
            at,
            there_is,
            witness,
            chosen: Vec::new(),
            solved: Vec::new(),
            is_solved_plainly: true,
            has_two_signs: false,
        };
        let moves: Vec<usize> = scope.moves.iter().map(|name| claim.book.variable(name.as_str())).collect();
        claim.choose(&equal);
        Some(claim.solve(equal, &moves).map(|()| claim))
    }

    /// The variables that the claim reaches, but for those with one value.
    fn choose(&mut self, equal: &[Compared]) {
        let mut reached = BTreeSet::new();
        let sides = equal.iter().chain(&self.conditions).flat_map(|one| [&one.left, &one.right]);
        let witness = self.witness.iter().map(|(_, value)| value);
        for term in sides.chain(witness).chain(self.terms()) {
            self.book.reached(term, &mut reached);
        }
        reached.extend(self.there_is.iter().chain(self.moving().iter()));
        self.has_two_signs = self.book.place(EITHER_SIGN).is_some_and(|sign| reached.contains(&sign));
        let fixed: BTreeSet<usize> = (self.at.iter().map(|(variable, _)| *variable))
            .chain([UNIT, EITHER_SIGN].iter().filter_map(|name| self.book.place(name)))
            .collect();
        self.chosen = reached.difference(&fixed).copied().collect();
    }

    fn terms(&self) -> Vec<&Term> {
        match &self.says {
            Says::True(said) => said.terms(),
            Says::Limit(left, Goal::Value(value), ..) => vec![left, value],
            Says::Limit(side, ..) | Says::Monotone(side, ..) | Says::Depends(side, ..) => vec![side],
        }
    }

    /// The variable that moves.
    pub fn moving(&self) -> Option<usize> {
        match &self.says {
            Says::True(_) => None,
            Says::Limit(_, _, variable, _)
            | Says::Monotone(_, _, variable)
            | Says::Depends(_, _, variable) => Some(*variable),
        }
    }

    /// Finds a variable for each equation: one that is said to move with another one, or that stands alone on a side, or else one in
    /// which it is linear.
    fn solve(&mut self, equal: Vec<Compared>, moves: &[usize]) -> Result<(), String> {
        for one in equal {
            let alone = [&one.left, &one.right].into_iter().filter_map(|side| match side {
                Term::Variable(variable) => Some(*variable),
                _ => None,
            });
            let alone: Vec<usize> = alone.filter(|variable| self.may_solve(*variable)).collect();
            let reached = self.reached(&one);
            let mut others: Vec<usize> =
                reached.into_iter().filter(|variable| self.may_solve(*variable)).collect();
            others.sort_by_key(|variable| self.book.name(*variable));
            let difference = one.difference();
            let named: Vec<usize> =
                others.iter().copied().filter(|variable| moves.contains(variable)).collect();
            let alone = if named.is_empty() { alone } else { named };
            let candidates = alone.iter().chain(&others);
            let found = candidates.copied().find(|variable| self.is_linear(&difference, *variable));
            let variable = found.ok_or("an equation among the conditions is not linear in a variable")?;
            self.is_solved_plainly &= alone.contains(&variable);
            self.chosen.retain(|one| *one != variable);
            let value = self.beside(&one, variable).cloned();
            self.solved.push(Solved { difference, variable, value });
        }
        Ok(())
    }

    /// The side of an equation that does not reach a variable, if the other one is this variable.
    fn beside<'e>(&self, equation: &'e Compared, variable: usize) -> Option<&'e Term> {
        let sides = [(&equation.left, &equation.right), (&equation.right, &equation.left)];
        let is_variable = |side: &Term| matches!(side, Term::Variable(one) if *one == variable);
        let (_, other) = sides.into_iter().find(|(side, _)| is_variable(side))?;
        let mut reached = BTreeSet::new();
        self.book.reached(other, &mut reached);
        (!reached.contains(&variable)).then_some(other)
    }

    fn may_solve(&self, variable: usize) -> bool {
        self.chosen.contains(&variable)
            && self.book.order(variable).is_none()
            && self.moving() != Some(variable)
            && !self.there_is.contains(&variable)
    }

    /// Whether the coefficients of a term in a variable are two, at a point without special values.
    fn is_linear(&self, term: &Term, variable: usize) -> bool {
        let mut place = AtPoint::new(&self.book, &self.conditions, BITS[1]);
        let all = self.chosen.iter().chain(self.solved.iter().map(|one| &one.variable));
        for (one, step) in all.zip(1_u32..) {
            place.set(*one, Number::Exact(Rational::from((3 * step + 4, step + 2))).into());
        }
        for (one, value) in &self.at {
            place.set(*one, Number::Exact(value.clone()).into());
        }
        place.coefficients(term, variable).is_ok_and(|list| list.len() == 2)
    }

    /// The point with these values; none where an equation among the conditions has no solution there.
    pub fn place(&self, base: &Base, bits: u32) -> Option<AtPoint<'_>> {
        self.place_with(base, bits, self.solved.iter().collect())
    }

    /// The same for what two sides reach: the other equations are not solved.
    pub fn place_for(&self, base: &Base, bits: u32, sides: &Compared) -> Option<AtPoint<'_>> {
        let mut reached = self.reached(sides);
        let (mut needed, mut others): (Vec<&Solved>, Vec<&Solved>) =
            (Vec::new(), self.solved.iter().collect());
        while let Some(next) = others.iter().position(|one| reached.contains(&one.variable)) {
            let next = others.swap_remove(next);
            self.book.reached(&next.difference, &mut reached);
            needed.push(next);
        }
        self.place_with(base, bits, needed)
    }

    fn place_with(&self, base: &Base, bits: u32, mut open: Vec<&Solved>) -> Option<AtPoint<'_>> {
        let mut place = AtPoint::new(&self.book, &self.conditions, bits);
        for (variable, value) in base.iter().chain(self.at.iter().map(|(variable, value)| (variable, value)))
        {
            place.set(*variable, place.rational(value));
        }
        open.retain(|one| !place.has(one.variable));
        while !open.is_empty() {
            let before = open.len();
            open.retain(|one| match solution(one, &mut place) {
                Some(value) => {
                    place.set(one.variable, value);
                    false
                }
                None => true,
            });
            if open.len() == before {
                return None;
            }
        }
        Some(place)
    }

    /// Whether the point meets every assumption but those of which a variable of `there_is` is a part.
    pub fn allows(&self, place: &mut AtPoint) -> Tried<bool> {
        let outer = |variable: &usize| !self.there_is.contains(variable);
        let variables: Vec<usize> = self.variables().filter(outer).collect();
        let conditions: Vec<&Compared> = self.conditions.iter().filter(|one| !self.is_inner(one)).collect();
        self.meets(place, &variables, &conditions)
    }

    /// Whether the values of the variables of `there_is` meet what is assumed of them.
    pub fn allows_inner(&self, place: &mut AtPoint) -> Tried<bool> {
        let conditions: Vec<&Compared> = self.conditions.iter().filter(|one| self.is_inner(one)).collect();
        self.meets(place, &self.there_is, &conditions)
    }

    /// The variables that the sides of a comparison contain.
    fn reached(&self, compared: &Compared) -> BTreeSet<usize> {
        let mut reached = BTreeSet::new();
        self.book.reached(&compared.left, &mut reached);
        self.book.reached(&compared.right, &mut reached);
        reached
    }

    fn is_inner(&self, condition: &Compared) -> bool {
        if self.there_is.is_empty() {
            return false;
        }
        let reached = self.reached(condition);
        self.there_is.iter().any(|variable| reached.contains(variable))
    }

    fn variables(&self) -> impl Iterator<Item = usize> {
        let solved = self.solved.iter().map(|one| one.variable);
        self.chosen.iter().copied().chain(solved).chain(self.at.iter().map(|(variable, _)| *variable))
    }

    fn meets(&self, place: &mut AtPoint, variables: &[usize], conditions: &[&Compared]) -> Tried<bool> {
        let mut parts = Vec::new();
        for variable in variables.iter().filter(|variable| self.book.is_positive(**variable)) {
            let sign = place.get(*variable).and_then(Value::number).map(|number| number.sign());
            parts.push(sign.and_then(|sign| sign.map(|sign| sign == Ordering::Greater).ok_or(Trouble::Open)));
        }
        for (variable, [low, high]) in self.within.iter().filter(|(variable, _)| variables.contains(variable))
        {
            let value = place.get(*variable)?;
            let order =
                |end: &Rational| value.minus(&place.rational(end))?.number()?.sign().ok_or(Trouble::Open);
            parts.push(order(low).map(Ordering::is_ge));
            parts.push(order(high).map(Ordering::is_le));
        }
        parts.extend(conditions.iter().map(|condition| condition.truth(place)));
        all(parts.into_iter())
    }

    /// Whether something is true at a point, at the first precision that decides it; for both signs of ±.
    pub fn decided(&self, base: &Base, ask: impl Fn(&mut AtPoint) -> Tried<bool>) -> Tried<bool> {
        self.decided_at(&BITS, |bits| self.place(base, bits), ask)
    }

    /// Whether two sides compare so at a point.
    pub fn compares(&self, base: &Base, sides: &Compared) -> Tried<bool> {
        self.decided_at(&BITS, |bits| self.place_for(base, bits, sides), |place| sides.truth(place))
    }

    /// The same at these precisions, with a way to the point.
    pub fn decided_at<'c>(
        &'c self,
        bits: &[u32],
        place: impl Fn(u32) -> Option<AtPoint<'c>>,
        ask: impl Fn(&mut AtPoint) -> Tried<bool>,
    ) -> Tried<bool> {
        let mut found = Err(Trouble::Open);
        for bits in bits {
            let Some(mut place) = place(*bits) else { continue };
            found = match self.book.place(EITHER_SIGN).filter(|_| self.has_two_signs) {
                None => ask(&mut place),
                Some(sign) => all([1, -1].into_iter().map(|value| {
                    place.set(sign, Value::whole(value));
                    ask(&mut place)
                })),
            };
            // Intervals leave more open: beside what they leave open, what has no value decides nothing.
            if found.is_ok() || found == Err(Trouble::NoValue) && *bits != NEAR {
                break;
            }
        }
        found
    }

    /// Whether something is true at a point that meets the conditions.
    pub fn at(&self, base: &Base, ask: &impl Fn(&mut AtPoint) -> Tried<bool>) -> At {
        self.at_within(&BITS, base, ask)
    }

    /// The same with the first precision alone: an equation between roots and logarithms stays open at any precision.
    pub fn quickly_at(&self, base: &Base, ask: &impl Fn(&mut AtPoint) -> Tried<bool>) -> At {
        self.at_within(&BITS[..2], base, ask)
    }

    fn at_within(&self, bits: &[u32], base: &Base, ask: &impl Fn(&mut AtPoint) -> Tried<bool>) -> At {
        let is_inside = Cell::new(false);
        let found = self.decided_at(
            bits,
            |bits| self.place(base, bits),
            |place| {
                if !is_inside.get() {
                    match self.allows(place) {
                        Ok(true) => is_inside.set(true),
                        Ok(false) => return Ok(false),
                        Err(trouble) => return Err(trouble),
                    }
                }
                ask(place)
            },
        );
        match (is_inside.get(), found) {
            (false, _) => At::Outside,
            (true, Ok(truth)) => At::Says(truth),
            (true, Err(Trouble::NoValue)) => At::NoValue,
            (true, Err(Trouble::Open)) => At::Open,
        }
    }

    /// The point in words: the variables that the claim reaches.
    pub fn text(&self, base: &Base) -> String {
        let Some(mut place) = self.place(base, BITS[1]) else { return String::new() };
        let is_zero = |variable: &usize| base.get(variable).is_some_and(|value| *value == 0);
        let is_named = |variable: &usize| self.book.order(*variable).is_none() || !is_zero(variable);
        let named = self.variables().filter(is_named).filter_map(|variable| {
            let number = place.number(&Term::Variable(variable)).ok()?;
            Some((self.book.name(variable), number.text()))
        });
        let mut named: Vec<(&str, String)> = named.collect();
        named.sort();
        named.into_iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
    }
}

fn solution(one: &Solved, place: &mut AtPoint) -> Option<Value> {
    if let Some(value) = &one.value {
        return place.value(value).ok();
    }
    match &place.coefficients(&one.difference, one.variable).ok()?[..] {
        [rest, slope] => rest.negated().over(slope).ok(),
        _ => None,
    }
}
