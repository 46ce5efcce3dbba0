//! What remains when a proof fails.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::{Domain, Expression, Function, Notation, RationalFunction, Sign, Symbol, unknowns};
use rug::Rational;

/// A rational point at which a statement is false, with what both sides are there.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CounterExample {
    /// Names and values.
    pub point: Vec<(Symbol, Expression)>,
    /// The value of the side that was derived.
    pub left: Expression,
    /// The value of the side that was claimed.
    pub right: Expression,
}

/// A step that could not be proved: it is false, or the rules do not decide it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Refutation {
    /// The identity of the proof that was attempted.
    pub id: String,
    /// The equations of the paper that enter the step which fails.
    pub equations: Vec<String>,
    /// The step that fails, in words.
    pub statement: String,
    /// The exact non-zero remainder, or why there is none.
    pub remainder: String,
    /// Whether the step is false; else the rules do not decide it.
    pub is_false: bool,
    /// A rational point at which both sides differ, when the step compares two sides.
    pub counter_example: Option<Box<CounterExample>>,
}

impl fmt::Display for Refutation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = if self.is_false { "refuted" } else { "not proved" };
        write!(formatter, "{}: {found}: {}", self.id, self.statement)?;
        if !self.equations.is_empty() {
            write!(formatter, " (equations {})", self.equations.join(", "))?;
        }
        write!(formatter, "; remainder: {}", self.remainder)?;
        if let Some(example) = &self.counter_example {
            let point = Notation::Plain.equal(&example.point);
            // Two constants differ everywhere: there is no point to name.
            let place = if point.is_empty() { point } else { format!("at {point}: ") };
            write!(formatter, "; {place}{} instead of {}", example.left, example.right)?;
        }
        Ok(())
    }
}

impl std::error::Error for Refutation {}

impl CounterExample {
    /// A point of the domain at which the difference of two sides is not zero, as exact numbers or enclosures show; `None` where no
    /// point of a fixed sequence shows it.
    #[must_use]
    pub(super) fn search(
        sides: &[RationalFunction; 2],
        difference: &RationalFunction,
        domain: &Domain,
    ) -> Option<Self> {
        let sides = sides.each_ref().map(Expression::from);
        // e + o i is zero where both parts are, which are real.
        let parts = difference.numerator().coefficients(&Symbol::read("i"));
        let parts: Vec<Expression> = parts.iter().map(Expression::from).collect();
        let differ = |there: &Place| parts.iter().any(|part| there.has(Sign::NonZero, part));
        let there = places(&sides, domain).find(|there| differ(there) && there.is_inside(domain))?;
        let [left, right] = sides.each_ref().map(|side| there.value(side));
        Some(Self { point: there.original(unknowns(&sides), domain), left, right })
    }
}

/// A point that may lie in a domain: numbers, and roots for the variables of which the square is known.
struct Place {
    point: BTreeMap<Symbol, Rational>,
    roots: BTreeMap<Symbol, Expression>,
}

/// Small primes, and points ever nearer to the example of the domain.
fn places<'d>(sides: &[Expression; 2], domain: &'d Domain) -> impl Iterator<Item = Place> + 'd {
    const VALUES: [u32; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let either_sign = [(Symbol::read("pm"), Expression::integer(1))];
    let roots = either_sign
        .iter()
        .chain(domain.squares())
        .map(|(name, square)| (name.clone(), domain.as_written(square).call(Function::Sqrt)));
    let roots: BTreeMap<_, _> = roots.collect();
    // The names of the sides come first: the others only say where the assumptions hold.
    let assumed = domain.expressions().into_iter().map(|one| domain.as_written(one)).collect::<Vec<_>>();
    let (first, others) = (unknowns(sides), &unknowns(&assumed) | &domain.symbols());
    let mut names: Vec<Symbol> = first.iter().chain(others.difference(&first)).cloned().collect();
    let substituted = |name: &Symbol| domain.substitutions().iter().any(|(known, _)| known == name);
    names.retain(|name| name.as_str() != "i" && !roots.contains_key(name) && !substituted(name));
    (0..24).flat_map(move |turn| {
        let value = |(index, name): (usize, &Symbol)| {
            let prime = Rational::from(VALUES[(index * (turn + 1) + turn) % VALUES.len()]);
            let value = match turn.checked_sub(VALUES.len()) {
                None => prime,
                Some(near) if (index + near) % 2 == 0 => domain.example_of(name) + (prime >> (4 * near)),
                Some(near) => domain.example_of(name) - (prime >> (4 * near)),
            };
            (name.clone(), value)
        };
        let point: BTreeMap<_, _> = names.iter().enumerate().map(value).collect();
        let opposite = roots.iter().map(|(name, root)| (name.clone(), -root.clone())).collect();
        [roots.clone(), opposite].map(|roots| Place { point: point.clone(), roots })
    })
}

impl Place {
    /// Whether the value of an expression certainly has this sign here.
    fn has(&self, sign: Sign, expression: &Expression) -> bool {
        expression.replaced(&self.roots).order_at(&self.point).is_some_and(|order| sign.admits(order))
    }

    /// Whether every assumption holds here, and the parameters have the values that the domain gives them.
    fn is_inside(&self, domain: &Domain) -> bool {
        let has = |sign: Sign, expression: Expression| self.has(sign, &domain.as_written(&expression));
        let mut names = domain.symbols().into_iter().filter(|name| domain.is_positive(name));
        names.all(|name| has(Sign::Positive, Expression::Variable(name)))
            && domain.conditions().iter().all(|one| has(one.relation.into(), one.expression.clone()))
            && domain.squares().iter().all(|(_, square)| has(Sign::NonNegative, square.clone()))
            && domain
                .parameters()
                .iter()
                .all(|(name, value)| has(Sign::Zero, value.clone() - Expression::Variable(name.clone())))
    }

    /// The value of an expression here: a number where it is rational.
    fn value(&self, expression: &Expression) -> Expression {
        let here = expression.replaced(&self.roots);
        here.rational_value(&self.point).map_or_else(|| here.at_point(&self.point), Expression::Number)
    }

    /// The point in the variables of the paper: values of the substituted variables are computed, the others kept.
    fn original(&self, names: BTreeSet<Symbol>, domain: &Domain) -> Vec<(Symbol, Expression)> {
        let computed = domain.substitutions();
        let is_kept =
            |name: &Symbol| name.as_str() != "i" && !computed.iter().any(|(_, value)| value.contains(name));
        let kept = names.into_iter().filter(is_kept).map(|name| (name.clone(), Expression::Variable(name)));
        kept.chain(computed.iter().cloned()).map(|(name, value)| (name, self.value(&value))).collect()
    }
}

#[cfg(test)]
mod tests;
