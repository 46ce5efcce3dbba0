//! Changes of a claim that keep its truth. Each can be left out, so that a wrong verdict shrinks to what causes it.

use super::claim::{Claim, Comparison, Definition, Formula, Statement, Truth, compare};
use super::rewriting::{all_names, positive, rewrite, total};
use super::term::{Name, Term, exp, n, p};
use super::world::{FREE, POSITIVE};
use crate::random::Random;

/// A change, with the seed of its choices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Disguise {
    pub change: Change,
    pub seed: u64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// A part of a side in another form.
    Rewrite,
    /// A formula joined with one that is known to be true or false, or negated twice.
    Join,
    /// A comparison turned, or with the same done to both sides.
    Turn,
    /// A condition in other words.
    Respell,
    /// A condition on variables that occur nowhere else.
    Condition,
    /// A part of a side as a name of `equations.toml`.
    Define,
    /// A part of a side as a variable, with an equation among the conditions.
    Equate,
}

const CHANGES: [(Change, usize); 7] = [
    (Change::Rewrite, 40),
    (Change::Join, 15),
    (Change::Turn, 15),
    (Change::Respell, 8),
    (Change::Condition, 8),
    (Change::Define, 8),
    (Change::Equate, 6),
];

impl Disguise {
    pub fn drawn(random: &mut Random) -> Self {
        let mut rest = random.below(100);
        let mut change = Change::Rewrite;
        for (one, weight) in CHANGES {
            if rest < weight {
                change = one;
                break;
            }
            rest -= weight;
        }
        Self { change, seed: random.next() }
    }

    /// The claim after the change; the same claim where the change does not apply.
    pub fn applied(self, claim: Claim) -> Claim {
        // What has no value, or is no claim at all, stays exactly as it is: another form may have a value.
        if claim.truth == Truth::Meaningless {
            return claim;
        }
        let random = &mut Random(self.seed);
        match self.change {
            Change::Rewrite => rewritten(claim, random),
            Change::Join => joined(claim, random),
            Change::Turn => turned(claim, random),
            Change::Respell => respelt(claim, random),
            Change::Condition => conditioned(claim, random),
            Change::Define => defined(claim, random),
            Change::Equate => equated(claim, random),
        }
    }
}

/// The names that a new part of a side may contain.
fn names_for_parts(claim: &Claim, random: &mut Random) -> Vec<Name> {
    let is_variable = |name: &Name| matches!(name, Name::Positive(_) | Name::Free(_));
    let own: Vec<Name> = claim.names().into_iter().filter(is_variable).collect();
    // A box and a value leave no room for another variable.
    let only_own = !claim.within.is_empty() || !claim.at.is_empty() || !claim.there_is.is_empty();
    if only_own || random.percent(70) { own } else { all_names() }
}

fn rewritten(mut claim: Claim, random: &mut Random) -> Claim {
    let mut names = names_for_parts(&claim, random);
    let (moving, is_limit) = (claim.moving(), matches!(claim.statement, Statement::Limit { .. }));
    let (there_is, conditions) = (claim.there_is.clone(), 2 * claim.given.len());
    let mut sides = claim.sides_mut();
    let count = sides.len();
    if count == 0 {
        return claim;
    }
    let at = random.below(count);
    // A condition on a variable of which there is a value is one that this value has to meet.
    if at + conditions >= count {
        names.retain(|name| !there_is.contains(name));
    }
    // The value of a limit does not contain the variable that moves, and a condition on it stays linear in it.
    if (is_limit && at == 1) || moving.is_some() {
        names.retain(|name| Some(*name) != moving);
    }
    rewrite(sides[at], &names, random);
    claim
}

fn joined(mut claim: Claim, random: &mut Random) -> Claim {
    let own: Vec<Name> = claim.names().into_iter().filter(|name| matches!(name, Name::Positive(_))).collect();
    let Statement::Formula(formula) = claim.statement else { return claim };
    let mut name = || if own.is_empty() { p(random.below(POSITIVE)) } else { Term::Name(*random.pick(&own)) };
    let [a, b] = [name(), name()];
    let is = |left: Term, sign, right| Formula::Compare(compare(left, sign, right));
    let (always, never) = match random.below(3) {
        0 => (is(&a + &b, ">", b.clone()), is(&a + &b, "<=", b)),
        1 => (is(a.clone(), ">", n(0)), is(a, "<", n(0))),
        _ => (is(&a * &a + n(1), "!=", n(0)), is(&a * &a + n(1), "=", n(0))),
    };
    let joined = match random.below(7) {
        0 => formula.negated().negated(),
        1 => Formula::And(vec![formula, always]),
        2 => Formula::Or(vec![never, formula]),
        3 => always.implies(formula),
        4 => formula.iff(always),
        5 => formula.negated().iff(never),
        _ => formula.negated().implies(never),
    };
    claim.statement = Statement::Formula(joined);
    claim
}

/// The comparison that is true exactly where the other one is false.
fn opposite(sign: &'static str) -> &'static str {
    match sign {
        "<" => ">=",
        ">" => "<=",
        "<=" => ">",
        ">=" => "<",
        "=" => "!=",
        _ => "=",
    }
}

/// The comparison of the same sides in the other order.
fn exchanged(sign: &'static str) -> &'static str {
    match sign {
        "<" => ">",
        ">" => "<",
        "<=" => ">=",
        ">=" => "<=",
        same => same,
    }
}

/// A comparison that is true exactly where this one is.
fn equivalent(one: &Comparison, names: &[Name], random: &mut Random) -> Comparison {
    let Comparison { left, sign, right } = one.clone();
    let unit = positive(random, 1, names);
    match random.below(6) {
        0 => compare(right, exchanged(sign), left),
        1 => compare(left - right, sign, n(0)),
        2 => compare(left * &unit, sign, right * unit),
        3 => {
            let more = total(random, 1, names);
            compare(left + &more, sign, right + more)
        }
        4 if left.is_positive() && right.is_positive() => match random.below(3) {
            0 => compare(left.power(2), sign, right.power(2)),
            1 => compare(n(1) / left, exchanged(sign), n(1) / right),
            _ => compare(left / right, sign, n(1)),
        },
        5 if random.percent(30) => compare(exp(left), sign, exp(right)),
        _ => compare(n(0), sign, right - left),
    }
}

fn turned(mut claim: Claim, random: &mut Random) -> Claim {
    let names = names_for_parts(&claim, random);
    if let Statement::Formula(formula) = &mut claim.statement {
        let mut all = formula.comparisons_mut();
        let count = all.len();
        if count > 0 {
            let one = &mut all[random.below(count)];
            if let Formula::Compare(comparison) = &**one {
                **one = match random.below(4) {
                    0 => {
                        let Comparison { left, sign, right } = comparison.clone();
                        Formula::Compare(compare(left, opposite(sign), right)).negated()
                    }
                    _ => Formula::Compare(equivalent(comparison, &names, random)),
                };
            }
        }
    }
    claim
}

fn respelt(mut claim: Claim, random: &mut Random) -> Claim {
    let count = claim.given.len();
    if count > 0 {
        let at = random.below(count);
        let Comparison { left, sign, right } = claim.given[at].clone();
        let factor = n(random.whole(2, 5));
        claim.given[at] = match random.below(4) {
            0 => compare(right, exchanged(sign), left),
            1 => compare(left - right, sign, n(0)),
            2 => compare(left * &factor, sign, right * factor),
            _ => compare(&left + &factor, sign, &right + factor),
        };
    }
    claim
}

fn conditioned(mut claim: Claim, random: &mut Random) -> Claim {
    let Some(name) = claim.unused(Name::Positive, POSITIVE) else { return claim };
    let free = claim.unused(Name::Free, FREE);
    let x = Term::Name(name);
    let (left, sign, right) = match (random.below(5), free.map(Term::Name)) {
        (0, Some(y)) => (x, ">", y),
        (1, Some(y)) => (y, "!=", x),
        (2, Some(y)) => (y, "=", x * n(2) + n(1)),
        (3, _) => (x.power(2), ">", n(3)),
        _ => (x, ">=", n(random.whole(1, 4))),
    };
    claim.given.push(compare(left, sign, right));
    claim
}

/// The places of parts of the sides that have a value everywhere and do not contain these names.
fn parts(side: &mut Term, without: &[Name]) -> Vec<usize> {
    let is_part = |node: &Term| {
        node.is_total()
            && node.size() > 1
            && !without.iter().any(|name| node.contains(*name))
            && !node.names().is_empty()
    };
    (0..side.size()).filter(|place| side.node_mut(*place).is_some_and(|node| is_part(node))).collect()
}

fn defined(mut claim: Claim, random: &mut Random) -> Claim {
    let next = Term::Name(Name::Defined(claim.definitions.len()));
    let mut sides = claim.sides_mut();
    let count = sides.len();
    if count == 0 {
        return claim;
    }
    let side = &mut sides[random.below(count)];
    let places = parts(side, &[Name::Root]);
    if places.is_empty() {
        return claim;
    }
    let Some(node) = side.node_mut(*random.pick(&places)) else { return claim };
    let term = std::mem::replace(node, next);
    let definition = if random.coin() { Definition::Equation(term) } else { Definition::Expression(term) };
    claim.define(definition);
    claim
}

fn equated(mut claim: Claim, random: &mut Random) -> Claim {
    let positive_name = claim.unused(Name::Positive, POSITIVE);
    let free_name = claim.unused(Name::Free, FREE);
    let mut without = claim.there_is.clone();
    without.extend(claim.moves.iter().copied());
    // A variable that an equation ties to the one that is changed moves with it if the claim says so.
    let tied = claim.moving().filter(|_| !matches!(claim.statement, Statement::Formula(_)));
    without.extend(claim.moving().filter(|_| tied.is_none()));
    without.push(Name::Root);
    without.extend((0..claim.definitions.len()).map(Name::Defined));
    let mut sides = claim.sides_mut();
    let count = sides.len();
    if count == 0 {
        return claim;
    }
    let side = &mut sides[random.below(count)];
    let places = parts(side, &without);
    if places.is_empty() {
        return claim;
    }
    let Some(node) = side.node_mut(*random.pick(&places)) else { return claim };
    let name = if node.is_positive() { positive_name } else { free_name };
    let Some(name) = name else { return claim };
    let term = std::mem::replace(node, Term::Name(name));
    let own = Term::Name(name);
    if tied.is_some_and(|tied| term.contains(tied)) {
        claim.moves.push(name);
    }
    claim.given.push(match random.below(4) {
        0 => compare(own, "=", term),
        1 => compare(term, "=", own),
        2 => compare(own - term, "=", n(0)),
        _ => compare(n(2) * own, "=", n(2) * term),
    });
    claim
}
