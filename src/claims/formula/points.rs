//! Rational points at which conditions are met: examples of a domain, and counter-examples.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_core::number::Rational;
use slipmode_core::polynomial::{Domain, Expression, Relation, Symbol};
use slipmode_core::theory::Equations;

use crate::scene::{ClaimFormula, Names};

/// A value for each variable.
pub(super) type Point = BTreeMap<Symbol, Rational>;

/// Values that variables take. Most are squares, so that square roots are rational.
const VALUES: [(u32, u32); 14] = [
    (1, 1),
    (4, 1),
    (9, 1),
    (16, 1),
    (25, 1),
    (1, 4),
    (1, 9),
    (1, 100),
    (100, 1),
    (2, 1),
    (1, 2),
    (10_000, 1),
    (1, 10_000),
    (3, 1),
];

/// The points of a fixed sequence that meet the conditions of a formula.
pub(super) struct Points {
    variables: Vec<(Symbol, bool)>,
    conditions: Vec<(Expression, Relation)>,
}

impl Points {
    /// How many points are looked at.
    pub const MOST: usize = 4096;

    pub fn new(formula: &ClaimFormula, names: &Names, equations: &Equations) -> Self {
        let conditions: Vec<(Expression, Relation)> = formula
            .given
            .iter()
            .map(|condition| (names.resolved(&condition.expression), condition.relation))
            .collect();
        let sides = formula.statement.sides().into_iter().map(|side| names.resolved(side));
        let variables: BTreeSet<Symbol> = sides
            .chain(conditions.iter().map(|(expression, _)| expression.clone()))
            .flat_map(|expression| expression.variables())
            .collect();
        let is_positive =
            |name: &Symbol| equations.positive().iter().any(|positive| positive == name.as_str());
        let variables = variables
            .into_iter()
            .map(|name| {
                let positive = is_positive(&name);
                (name, positive)
            })
            .collect();
        Self { variables, conditions }
    }

    /// The points in order.
    pub fn iter(&self) -> impl Iterator<Item = Point> {
        (0..Self::MOST).map(|index| self.point(index)).filter(|point| self.meets(point))
    }

    /// Whether a point meets the conditions.
    pub fn meets(&self, point: &Point) -> bool {
        self.conditions.iter().all(|(expression, relation)| {
            value(expression, point).is_some_and(|value| match relation {
                Relation::Positive => value > 0,
                Relation::NonNegative => value >= 0,
                Relation::NonZero => value != 0,
            })
        })
    }

    /// Point number `index`: the first has 1 everywhere, the others are spread by a linear congruential generator.
    fn point(&self, index: usize) -> Point {
        let mut state = index as u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 40).unwrap_or_default()
        };
        let values = self.variables.iter().map(|(name, positive)| {
            let place = if index == 0 { 0 } else { next() };
            let value = Rational::from(VALUES[place % VALUES.len()]);
            let sign = if *positive || index == 0 { 0 } else { next() % 3 };
            let value = match sign {
                0 => value,
                1 => -value,
                _ => Rational::new(),
            };
            (name.clone(), value)
        });
        values.collect()
    }
}

/// The exact value of an expression at a point; none where it is not rational or does not exist.
pub(super) fn value(expression: &Expression, point: &Point) -> Option<Rational> {
    let at_point = expression.substitute(&super::expressions(point));
    Domain::default().rational_function(&at_point).ok()?.as_constant()
}

/// A point in words.
pub(super) fn text(point: &Point) -> String {
    point.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
}
