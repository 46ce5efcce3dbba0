//! Boolean combinations of the signs of expressions.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;

use super::{Expression, Relation, Symbol};
use crate::number::Rational;

crate::named! {
    /// What is said of the sign of an expression.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Sign {
        /// Greater than zero.
        Positive = " > 0",
        /// Zero or greater.
        NonNegative = " >= 0",
        /// Zero.
        Zero = " = 0",
        /// Not zero.
        NonZero = " != 0",
    }
}

impl Sign {
    /// Whether a number that compares so with zero has the sign.
    #[must_use]
    pub fn admits(self, found: Ordering) -> bool {
        match self {
            Self::Positive => found.is_gt(),
            Self::NonNegative => found.is_ge(),
            Self::Zero => found.is_eq(),
            Self::NonZero => found.is_ne(),
        }
    }

    /// As a condition of a domain; none for an equation.
    #[must_use]
    pub fn relation(self) -> Option<Relation> {
        Relation::ALL.into_iter().find(|relation| Self::from(*relation) == self)
    }
}

impl From<Relation> for Sign {
    fn from(relation: Relation) -> Self {
        match relation {
            Relation::Positive => Self::Positive,
            Relation::NonNegative => Self::NonNegative,
            Relation::NonZero => Self::NonZero,
        }
    }
}

/// A statement on the sign of one expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Literal {
    /// What is compared with zero.
    pub expression: Expression,
    /// How.
    pub sign: Sign,
}

impl Literal {
    /// This expression has this sign.
    #[must_use]
    pub fn new(expression: Expression, sign: Sign) -> Self {
        Self { expression, sign }
    }

    /// Whether it is true at a point; none where its expression has no value, or one that is not certain.
    #[must_use]
    pub fn holds_at(&self, point: &BTreeMap<Symbol, Rational>) -> Option<bool> {
        Some(self.sign.admits(self.expression.order_at(point)?))
    }

    /// The opposite statement.
    #[must_use]
    pub fn negated(&self) -> Self {
        match self.sign {
            Sign::Positive => Self::new(-self.expression.clone(), Sign::NonNegative),
            Sign::NonNegative => Self::new(-self.expression.clone(), Sign::Positive),
            Sign::Zero => Self::new(self.expression.clone(), Sign::NonZero),
            Sign::NonZero => Self::new(self.expression.clone(), Sign::Zero),
        }
    }
}

impl fmt::Display for Literal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}{}", self.expression, self.sign.as_str())
    }
}

/// A combination of literals by "and" and "or". Negations stand in the literals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SignFormula {
    /// One statement.
    Literal(Literal),
    /// All of them; true without any.
    All(Vec<SignFormula>),
    /// At least one of them; false without any.
    Any(Vec<SignFormula>),
}

impl SignFormula {
    /// One statement.
    #[must_use]
    pub fn sign(expression: &Expression, sign: Sign) -> Self {
        Self::Literal(Literal::new(expression.clone(), sign))
    }

    /// The opposite formula.
    #[must_use]
    pub fn negated(&self) -> Self {
        let all = |parts: &[Self]| parts.iter().map(Self::negated).collect();
        match self {
            Self::Literal(literal) => Self::Literal(literal.negated()),
            Self::All(parts) => Self::Any(all(parts)),
            Self::Any(parts) => Self::All(all(parts)),
        }
    }

    /// The statements in it.
    #[must_use]
    pub fn literals(&self) -> Vec<&Literal> {
        match self {
            Self::Literal(literal) => vec![literal],
            Self::All(parts) | Self::Any(parts) => parts.iter().flat_map(Self::literals).collect(),
        }
    }

    /// The formula with every expression replaced.
    #[must_use]
    pub fn map(&self, replace: &impl Fn(&Expression) -> Expression) -> Self {
        let all = |parts: &[Self]| parts.iter().map(|part| part.map(replace)).collect();
        match self {
            Self::Literal(literal) => Self::Literal(Literal::new(replace(&literal.expression), literal.sign)),
            Self::All(parts) => Self::All(all(parts)),
            Self::Any(parts) => Self::Any(all(parts)),
        }
    }

    /// Its truth where each literal is true, false or open (none).
    #[must_use]
    pub fn truth(&self, of: &impl Fn(&Literal) -> Option<bool>) -> Option<bool> {
        let decided = |parts: &[Self], decisive: bool| {
            let mut open = false;
            for part in parts {
                match part.truth(of) {
                    Some(truth) if truth == decisive => return Some(decisive),
                    Some(_) => {}
                    None => open = true,
                }
            }
            if open { None } else { Some(!decisive) }
        };
        match self {
            Self::Literal(literal) => of(literal),
            Self::All(parts) => decided(parts, false),
            Self::Any(parts) => decided(parts, true),
        }
    }

    /// Clauses of which each has to be true by one of its literals. Literals of known truth are left out, and so is a clause with a
    /// literal and its negation. None for more than `most` clauses, or for a clause of more literals.
    #[must_use]
    pub fn clauses(
        &self,
        known: &impl Fn(&Literal) -> Option<bool>,
        most: usize,
    ) -> Option<Vec<Vec<Literal>>> {
        match self {
            Self::Literal(literal) => Some(match known(literal) {
                Some(true) => Vec::new(),
                Some(false) => vec![Vec::new()],
                None => vec![vec![literal.clone()]],
            }),
            Self::All(parts) => parts.iter().try_fold(Vec::new(), |mut all: Vec<Vec<Literal>>, part| {
                for clause in part.clauses(known, most)? {
                    if !all.iter().any(|other| is_subset(other, &clause)) {
                        all.retain(|other| !is_subset(&clause, other));
                        all.push(clause);
                    }
                }
                (all.len() <= most).then_some(all)
            }),
            Self::Any(parts) => parts.iter().try_fold(vec![Vec::new()], |joined, part| {
                let part = part.clauses(known, most)?;
                let mut all: Vec<Vec<Literal>> = Vec::new();
                for (one, other) in joined.iter().flat_map(|one| part.iter().map(move |other| (one, other))) {
                    let Some(clause) = union(one, other) else { continue };
                    if !all.iter().any(|known| is_subset(known, &clause)) {
                        all.push(clause);
                    }
                    if all.len() > most || all.iter().any(|clause| clause.len() > most) {
                        return None;
                    }
                }
                Some(all)
            }),
        }
    }
}

fn is_subset(small: &[Literal], large: &[Literal]) -> bool {
    small.iter().all(|literal| large.contains(literal))
}

/// The literals of both; none when one is the negation of another, so that the clause is true.
fn union(one: &[Literal], other: &[Literal]) -> Option<Vec<Literal>> {
    other.iter().try_fold(one.to_vec(), |mut all, literal| {
        if all.contains(&literal.negated()) {
            return None;
        }
        if !all.contains(literal) {
            all.push(literal.clone());
        }
        Some(all)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A formula over the signs of x and y from a number, by its digits.
    fn formula(seed: &mut u64, depth: u32) -> SignFormula {
        let mut next = |below: u64| {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 33) % below
        };
        let kind = if depth == 0 { 0 } else { next(4) };
        if kind < 1 {
            let name = ["x", "y", "x - y"][next(3) as usize];
            let sign = Sign::ALL[next(4) as usize];
            let literal = Literal::new(name.parse().unwrap(), sign);
            return SignFormula::Literal(if next(2) == 0 { literal } else { literal.negated() });
        }
        let count = 1 + next(3);
        let parts = (0..count).map(|_| formula(seed, depth - 1)).collect();
        if kind == 1 { SignFormula::Any(parts) } else { SignFormula::All(parts) }
    }

    fn truth_at(formula: &SignFormula, x: i32, y: i32) -> bool {
        let of = |literal: &Literal| {
            let value =
                literal.expression.with("x", &Expression::integer(x)).with("y", &Expression::integer(y));
            let value = crate::Domain::default().rational_function(&value).unwrap().as_constant();
            Some(literal.sign.admits(value.unwrap().cmp0()))
        };
        formula.truth(&of).unwrap()
    }

    #[test]
    fn clauses_and_negations_agree_with_the_formula_at_every_point() {
        let mut seed = 1;
        let mut compared = 0;
        for _ in 0..300 {
            let formula = formula(&mut seed, 3);
            let Some(clauses) = formula.clauses(&|_| None, 64) else { continue };
            let any = |clause: Vec<Literal>| {
                SignFormula::Any(clause.into_iter().map(SignFormula::Literal).collect())
            };
            let joined = SignFormula::All(clauses.into_iter().map(any).collect());
            for (x, y) in
                [(0, 0), (1, 0), (0, 1), (1, 1), (2, 1), (1, 2), (-1, 1), (-1, -1), (-2, -1), (1, -1)]
            {
                let truth = truth_at(&formula, x, y);
                assert_eq!(truth_at(&joined, x, y), truth, "{formula:?}");
                assert_eq!(truth_at(&formula.negated(), x, y), !truth, "{formula:?}");
                compared += 1;
            }
        }
        assert!(compared > 2000, "{compared}");
    }

    #[test]
    fn a_literal_is_true_false_or_open_at_a_point() {
        let holds = |text: &str, sign, value: i32| {
            let literal = Literal::new(text.parse().unwrap(), sign);
            literal.holds_at(&[("x".into(), Rational::from(value))].into())
        };
        assert_eq!(holds("x - 1", Sign::Positive, 2), Some(true));
        assert_eq!(holds("x - 1", Sign::Positive, 1), Some(false));
        assert_eq!(holds("1/x", Sign::NonZero, 0), None);
    }

    #[test]
    fn clauses_have_a_bound_and_none_is_implied_by_another() {
        let positive = |name: &str| SignFormula::Literal(Literal::new(name.parse().unwrap(), Sign::Positive));
        let [a, b, c, d] = ["a", "b", "c", "d"].map(positive);
        let count = |formula: &SignFormula, most| formula.clauses(&|_| None, most).map(|all| all.len());
        let pair = |one: &SignFormula, other: &SignFormula| vec![one.clone(), other.clone()];
        let joined = SignFormula::Any(vec![SignFormula::All(pair(&a, &b)), SignFormula::All(pair(&c, &d))]);
        assert_eq!((count(&joined, 4), count(&joined, 3)), (Some(4), None));
        assert_eq!(joined.literals().len(), 4);
        let long = SignFormula::Any(vec![a.clone(), b.clone(), c]);
        assert_eq!((count(&long, 3), count(&long, 2)), (Some(1), None));
        let implied = SignFormula::All(vec![a.clone(), SignFormula::Any(pair(&a, &b))]);
        assert_eq!(count(&implied, 4), Some(1));
        let turned = SignFormula::All(vec![SignFormula::Any(pair(&a, &b)), a]);
        assert_eq!(count(&turned, 4), Some(1));
    }
}
