//! What a formula assumes: positive variables and conditions, with the equations among the conditions solved.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Comparison, Condition, Domain, Expression, Literal, Relation, Sign, Symbol};
use slipmode_core::number::Rational;
use slipmode_theory::Equations;

use super::{FormulaCondition, Scope};
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
    /// What follows from the other assumptions in one of their forms, and makes sides have a value.
    pub facts: Vec<Condition>,
    /// The values of variables that have one.
    pub values: BTreeMap<Symbol, Expression>,
    /// What is assumed of the variables of which there is a value: it is a part of what that value does, and no assumption.
    pub wanted: Vec<Literal>,
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
    pub(super) fn new(scope: &Scope, moving: Option<&Symbol>, equations: &Equations) -> Result<Self, String> {
        let names = Names::of(equations);
        let mut premises = Self {
            positive: names.positive().clone(),
            values: scope.at.iter().cloned().map(|(name, value)| (name, Expression::Number(value))).collect(),
            ..Self::default()
        };
        for (name, value) in &scope.at {
            if premises.positive.remove(name) && *value <= 0 {
                return Err(format!("{name} = {value} is not positive as the equations assume"));
            }
        }
        for within in &scope.within {
            let (name, [low, _]) = within;
            if premises.positive.contains(name) && *low <= 0 {
                return Err(format!("{name} = {low} is not positive as the equations assume"));
            }
            let is_own = scope.there_is.contains(name);
            let assumed = if is_own { &mut premises.wanted } else { &mut premises.conditions };
            assumed.extend(within_ends(within));
        }
        let literal = |condition: &FormulaCondition| {
            let literal = condition.literal();
            Literal::new(names.resolved(&literal.expression), literal.sign)
        };
        let is_own = |condition: &&FormulaCondition| {
            scope.there_is.iter().any(|name| literal(condition).expression.variables().contains(name))
        };
        let (own, given): (Vec<_>, Vec<_>) = scope.given.iter().partition(is_own);
        premises.wanted.extend(own.into_iter().map(literal));
        let (equal, other): (Vec<_>, Vec<_>) =
            given.into_iter().partition(|condition| condition.comparison == Comparison::Equal);
        for condition in other {
            premises.assume(literal(condition))?;
        }
        for condition in equal {
            let expression = premises.put_in(&literal(condition).expression);
            let solved = premises.solved_for(condition, &expression, moving, &scope.moves)?;
            premises.put(solved)?;
        }
        let in_equations = |name: &Symbol| premises.solved.iter().any(|one| one.variable == *name);
        if let Some(name) = scope.moves.iter().find(|name| !in_equations(name)) {
            return Err(format!(
                "`moves` names {name}, for which no equation among the conditions is solved"
            ));
        }
        let wanted = std::mem::take(&mut premises.wanted);
        premises.wanted =
            wanted.iter().map(|one| Literal::new(premises.put_in(&one.expression), one.sign)).collect();
        Ok(premises)
    }

    /// An equation among the conditions, solved for the variable that moves with another one, or for any one where none moves.
    fn solved_for(
        &self,
        condition: &FormulaCondition,
        expression: &Expression,
        moving: Option<&Symbol>,
        moves: &[Symbol],
    ) -> Result<Solved, String> {
        let variables = expression.variables();
        let alone = condition.sides.iter().filter_map(|side| match side {
            Expression::Variable(name) => Some(name.clone()),
            _ => None,
        });
        let named: Vec<Symbol> = moves.iter().filter(|name| variables.contains(*name)).cloned().collect();
        let is_open = named.is_empty() && moving.is_some_and(|moving| variables.contains(moving));
        let candidates: Vec<Symbol> = match &named[..] {
            [] => alone.chain(variables.iter().cloned()).filter(|name| Some(name) != moving).collect(),
            _ => named,
        };
        let mut found = candidates.iter().filter_map(|name| self.solve(expression, name));
        let text = &condition.text;
        let first = found.next().ok_or_else(|| match &candidates[..] {
            [name] if moves.contains(name) => {
                format!("'{text}' is not linear in {name} with a factor that is never zero")
            }
            [] if moving.is_some() => format!("'{text}' has no variable but the one that moves"),
            _ => format!("'{text}' is not linear in one of its variables with a factor that is never zero"),
        })?;
        let other = found.find(|other| other.variable != first.variable);
        match (moving, other) {
            (Some(moving), Some(other)) if is_open => Err(format!(
                "with {moving} another variable of '{text}' moves: say which one, such as `moves = [\"{}\"]` or `moves = [\"{}\"]`",
                first.variable, other.variable
            )),
            _ => Ok(first),
        }
    }

    /// expression = 0 solved for a variable in which it is linear.
    #[must_use]
    pub fn solve(&self, expression: &Expression, name: &Symbol) -> Option<Solved> {
        let domain = self.domain();
        let slope = domain.rational_function(&expression.derivative(name)).ok()?;
        let slope = Some(Expression::from(&slope)).filter(|slope| !slope.variables().contains(name))?;
        domain.rational_function(&slope.clone().power(-1)).ok()?;
        let rest = expression.with(name, &Expression::integer(0));
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
            None => {
                let literal = Literal::new(expression, literal.sign);
                let follows = condition(&literal).is_some_and(|one| self.domain().proves(&one) == Ok(true));
                if !follows {
                    self.conditions.push(literal);
                }
            }
        }
        Ok(())
    }

    /// An expression with the values and the solutions in place.
    pub(crate) fn put_in(&self, expression: &Expression) -> Expression {
        let start = expression.substitute(&self.values);
        self.solved.iter().fold(start, |expression, solved| expression.with(&solved.variable, &solved.value))
    }

    /// Checks that a condition follows from the assumptions; one that follows in another form of them only is noted.
    ///
    /// # Errors
    /// Why it does not.
    pub fn demand(&mut self, condition: &Condition) -> Result<(), String> {
        let relation = condition.relation;
        let there = Condition { expression: self.put_in(&condition.expression), relation };
        if there.expression.is_positive_by_form(&|name| self.positive.contains(name)) {
            return Ok(());
        }
        let domain = self.with_wanted().domain();
        let found = domain.proves(&there);
        if found == Ok(true) {
            return Ok(());
        }
        // What the variables of which there is a value have to meet is no assumption: nothing follows from it elsewhere.
        if self.domain().proves_in_some_form(&there).is_some() {
            self.facts.push(there);
            return Ok(());
        }
        if domain.proves_in_some_form(&there).is_some() {
            return Ok(());
        }
        let role = match relation {
            Relation::NonZero => "a divisor and may be zero",
            Relation::NonNegative => "the argument of a square root and may be negative",
            Relation::Positive => "the argument of a logarithm and may be zero or negative",
        };
        Err(match found {
            Err(error) if !error.is_open() => error.to_string(),
            _ => format!("{} is {role}: the assumptions do not exclude it", there.expression),
        })
    }

    /// The assumptions with what the variables of which there is a value have to meet.
    pub(crate) fn with_wanted(&self) -> Self {
        let conditions = self.conditions.iter().chain(&self.wanted).cloned().collect();
        Self { conditions, ..self.clone() }
    }

    /// The assumptions as a domain.
    #[must_use]
    pub fn domain(&self) -> Domain {
        let known = self.conditions.iter().filter_map(condition);
        let facts = self.facts.iter().cloned();
        let given = |domain: Domain, Condition { expression, relation }: Condition| {
            domain.given(expression, relation)
        };
        known.chain(facts).fold(Domain::of_positive(self.positive.iter().cloned()), given)
    }
}

/// That a variable lies between its ends.
pub(crate) fn within_ends((name, [low, high]): &(Symbol, [Rational; 2])) -> [Literal; 2] {
    [(Comparison::AtLeast, low), (Comparison::AtMost, high)].map(|(comparison, end)| {
        comparison.literal(Expression::variable(name), Expression::Number(end.clone()))
    })
}

/// A literal as a condition of a domain; none for an equation.
fn condition(literal: &Literal) -> Option<Condition> {
    let relation: Relation = literal.sign.relation()?;
    Some(Condition { expression: literal.expression.clone(), relation })
}
