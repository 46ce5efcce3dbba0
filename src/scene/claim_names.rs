//! The names that formulas of claims may use: those of the equations, with the nearest one to a misspelt one.

use std::ops::Deref;
use std::sync::Arc;

use slipmode_algebra::{Condition, Domain, Expression, Symbol};
use slipmode_theory::{Equations, Names as Meanings};

use crate::scene::nearest;

/// The names that formulas may use: variables, names that an equation defines, definitions.
#[derive(Debug, Clone)]
pub struct Names(Arc<Meanings>);

impl Deref for Names {
    type Target = Meanings;

    fn deref(&self) -> &Meanings {
        &self.0
    }
}

impl Names {
    /// The variables of the equations, and what the other names mean.
    #[must_use]
    pub fn of(equations: &Equations) -> Self {
        Self(equations.names().clone())
    }

    /// These variables, without an assumption about them.
    #[must_use]
    pub fn plain<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        Self(Arc::new(Meanings::of_variables(names)))
    }

    pub(super) fn refusal(&self, unknown: &str) -> String {
        let near = nearest(unknown, self.all()).map(|near| format!("; did you mean `{near}`?"));
        let near = near.unwrap_or_default();
        format!("'{unknown}' is no variable and no defined name of equations.toml{near}")
    }

    /// The expression with the definitions in place of their names, but for one name, which stands for the roots of a polynomial.
    pub(crate) fn resolved_but(&self, expression: &Expression, name: &Symbol) -> Expression {
        let own = Symbol::fresh(&expression.variables());
        self.resolved(&expression.with(name, &Expression::variable(&own)))
            .with(own, &Expression::variable(name))
    }

    /// What must hold for an expression to have a value, in variables only; one name stands for the roots of a polynomial.
    pub(crate) fn demands_but(&self, expression: &Expression, own: Option<&Symbol>) -> Vec<Condition> {
        let Some(own) = own else { return self.demands_of(expression) };
        // Nothing is simplified: what has no value stays.
        let root = Symbol::fresh(&expression.variables());
        let renamed = expression.replaced(&[(own.clone(), Expression::variable(&root))].into());
        let back = |one: Condition| Condition {
            expression: one.expression.replaced(&[(root.clone(), Expression::variable(own))].into()),
            relation: one.relation,
        };
        self.demands_of(&renamed).into_iter().map(back).collect()
    }

    /// What a definition in an expression is given for and the domain does not prove after values are put in, in words.
    pub(super) fn missing_condition(
        &self,
        expression: &Expression,
        domain: &Domain,
        put_in: impl Fn(&Expression) -> Expression,
    ) -> Option<String> {
        let is_missing = |one: &&Condition| {
            let there = Condition { expression: put_in(&one.expression), relation: one.relation };
            domain.proves(&there) != Ok(true)
        };
        let missing = self.given_of(expression).into_iter().find(is_missing)?;
        Some(format!("'{expression}' is defined for {missing} only: add this to `given`"))
    }
}
