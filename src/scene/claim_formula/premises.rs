//! What a formula assumes: positive variables and conditions, with the equations among the conditions solved.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Condition, Domain, Expression, Literal, Relation, Sign, Symbol};
use slipmode_core::number::Rational;
use slipmode_core::theory::Equations;

use super::{Comparison, Scope};
use crate::scene::claim_names::Names;

/// What is assumed of the variables of a formula, in the variables that are left.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Premises {
    /// The variables that are positive.
    pub positive: BTreeSet<Symbol>,
    /// The other assumptions; no equation is among them.
    pub conditions: Vec<Literal>,
    /// The variables that were solved for, in this order.
    pub solved: Vec<Solved>,
    /// The values of variables that have one.
    pub values: BTreeMap<Symbol, Expression>,
}

/// An equation, expression = slope·(variable − value) = 0 with a slope that is never zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solved {
    /// What is zero.
    pub expression: Expression,
    /// The variable that it was solved for.
    pub variable: Symbol,
    /// Its value.
    pub value: Expression,
    /// The slope.
    pub slope: Expression,
}

impl Premises {
    pub(super) fn new(scope: &Scope, moving: Option<&str>, equations: &Equations) -> Result<Self, String> {
        let names = Names::of(equations);
        let number = |value: &Rational| Expression::Number(value.clone());
        let mut premises = Self {
            positive: equations.positive().iter().map(|name| Symbol::new(name)).collect(),
            values: scope.at.iter().map(|(name, value)| (Symbol::new(name), number(value))).collect(),
            ..Self::default()
        };
        for (name, value) in &scope.at {
            if premises.positive.remove(&Symbol::new(name)) && *value <= 0 {
                return Err(format!("{name} = {value} is not positive as the equations assume"));
            }
        }
        for (name, [low, high]) in &scope.within {
            if premises.positive.contains(&Symbol::new(name)) && *low <= 0 {
                return Err(format!("{name} = {low} is not positive as the equations assume"));
            }
            let name = || Expression::variable(name);
            premises.conditions.extend([
                Comparison::AtLeast.literal(name(), number(low)),
                Comparison::AtMost.literal(name(), number(high)),
            ]);
        }
        let (equal, other): (Vec<_>, Vec<_>) =
            scope.given.iter().partition(|condition| condition.comparison == Comparison::Equal);
        for condition in other {
            let literal = condition.literal();
            premises.assume(Literal::new(names.resolved(&literal.expression), literal.sign))?;
        }
        for condition in equal {
            let expression = premises.put_in(&names.resolved(&condition.literal().expression));
            let alone = condition.sides.iter().filter_map(|side| match side {
                Expression::Variable(name) => Some(name.clone()),
                _ => None,
            });
            let candidates: Vec<Symbol> = alone.chain(expression.variables()).collect();
            let solved = candidates.iter().filter(|name| Some(name.as_str()) != moving);
            let solved =
                solved.into_iter().find_map(|name| premises.solve(&expression, name)).ok_or_else(|| {
                    format!(
                        "'{}' is not linear in one of its variables with a factor that is never zero",
                        condition.text
                    )
                })?;
            premises.put(solved)?;
        }
        Ok(premises)
    }

    /// expression = 0 solved for a variable in which it is linear.
    #[must_use]
    pub fn solve(&self, expression: &Expression, name: &Symbol) -> Option<Solved> {
        let domain = self.domain();
        let slope = domain.rational_function(&expression.derivative(name)).ok()?;
        let slope = Some(Expression::from(&slope)).filter(|slope| !slope.variables().contains(name))?;
        domain.rational_function(&slope.clone().power(-1)).ok()?;
        let rest = expression.with(name.as_str(), &Expression::integer(0));
        let value = Expression::from(&domain.rational_function(&-(rest / slope.clone())).ok()?);
        let is_free = !value.variables().contains(name);
        is_free.then(|| Solved { expression: expression.clone(), variable: name.clone(), value, slope })
    }

    /// Puts the value of a variable in its place everywhere.
    ///
    /// # Errors
    /// When an assumption is then false.
    pub fn put(&mut self, solved: Solved) -> Result<(), String> {
        let name = solved.variable.clone();
        let mut conditions = std::mem::take(&mut self.conditions);
        if self.positive.remove(&name) {
            conditions.push(Literal::new(Expression::Variable(name), Sign::Positive));
        }
        self.solved.push(solved);
        conditions.into_iter().try_for_each(|condition| self.assume(condition))
    }

    /// Adds an assumption; one that is true under the others adds nothing.
    fn assume(&mut self, literal: Literal) -> Result<(), String> {
        let expression = self.put_in(&literal.expression);
        let value = self.domain().rational_function(&expression);
        match value.ok().and_then(|value| value.as_constant()) {
            Some(value) if literal.sign.admits(value.cmp0()) => {}
            Some(_) => return Err(format!("the condition {literal} is not met")),
            None => self.conditions.push(Literal::new(expression, literal.sign)),
        }
        Ok(())
    }

    /// An expression with the values and the solutions in place.
    #[must_use]
    pub fn put_in(&self, expression: &Expression) -> Expression {
        let start = expression.substitute(&self.values);
        self.solved
            .iter()
            .fold(start, |expression, solved| expression.with(solved.variable.as_str(), &solved.value))
    }

    /// The assumptions as a domain.
    #[must_use]
    pub fn domain(&self) -> Domain {
        let names: Vec<&str> = self.positive.iter().map(Symbol::as_str).collect();
        let known: Vec<Condition> = self.conditions.iter().filter_map(condition).collect();
        let given = |domain: Domain, Condition { expression, relation }: Condition| {
            domain.given(expression, relation)
        };
        known.into_iter().fold(Domain::positive(&names.join(" ")), given)
    }
}

/// A literal as a condition of a domain; none for an equation.
fn condition(literal: &Literal) -> Option<Condition> {
    let relation: Relation = literal.sign.relation()?;
    Some(Condition { expression: literal.expression.clone(), relation })
}
