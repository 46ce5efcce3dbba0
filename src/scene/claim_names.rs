//! The names that formulas of claims may use: the variables of the equations, and what the defined names mean.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_core::polynomial::{Expression, Symbol};
use slipmode_core::theory::Equations;

use crate::scene::nearest;

/// The names that formulas may use.
pub struct Names {
    pub(super) variables: BTreeSet<Symbol>,
    positive: BTreeSet<Symbol>,
    /// What a defined name means, and the number of its equation.
    definitions: BTreeMap<Symbol, (Expression, String)>,
}

impl Names {
    /// The variables of the equations, and what the defined names mean.
    #[must_use]
    pub fn of(equations: &Equations) -> Self {
        let mut definitions = BTreeMap::new();
        let mut doubled = BTreeSet::new();
        let mut variables: BTreeSet<Symbol> =
            equations.positive().iter().map(|name| Symbol::new(name)).collect();
        let assumed = variables.clone();
        for equation in equations.iter() {
            variables.extend(&equation.left.variables() | &equation.right.variables());
            let meaning = |side: Expression| (side, equation.number.clone());
            // A positive variable keeps its meaning where an equation solves for it, as eqs 15 and 16 do for σ.
            if let Expression::Variable(name) = &equation.left
                && !assumed.contains(name)
                && definitions.insert(name.clone(), meaning(equation.right.clone())).is_some()
            {
                doubled.insert(name.clone());
            }
            let place = |side: &str| Symbol::new(&format!("{side}_{}", equation.word()));
            definitions.insert(place("left"), meaning(equation.left.clone()));
            definitions.insert(place("right"), meaning(equation.right.clone()));
            definitions.insert(place("residual"), meaning(equation.residual()));
        }
        definitions.retain(|name, _| !doubled.contains(name));
        variables.retain(|name| !definitions.contains_key(name));
        Self { variables, positive: assumed, definitions }
    }

    /// These variables, without an assumption about them.
    #[must_use]
    pub fn plain<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        let variables = names.map(Symbol::new).collect();
        Self { variables, positive: BTreeSet::new(), definitions: BTreeMap::new() }
    }

    pub(super) fn has(&self, name: &Symbol) -> bool {
        self.variables.contains(name) || self.definitions.contains_key(name)
    }

    /// Whether a variable is positive by assumption.
    #[must_use]
    pub fn is_positive(&self, name: &str) -> bool {
        self.positive.contains(&Symbol::new(name))
    }

    pub(super) fn refusal(&self, unknown: &str) -> String {
        let names = self.variables.iter().chain(self.definitions.keys()).map(Symbol::as_str);
        let near = nearest(unknown, names).map(|near| format!("; did you mean `{near}`?"));
        let near = near.unwrap_or_default();
        format!("'{unknown}' is no variable and no defined name of equations.toml{near}")
    }

    /// The expression with the definitions in place of their names.
    #[must_use]
    pub fn resolved(&self, expression: &Expression) -> Expression {
        let meaning =
            |(name, (meaning, _)): (&Symbol, &(Expression, String))| (name.clone(), meaning.clone());
        expression.substitute(&self.definitions.iter().map(meaning).collect())
    }

    /// The expression with the definitions in place of their names, but for one name, which stands for the roots of a polynomial.
    #[must_use]
    pub fn resolved_but(&self, expression: &Expression, name: &str) -> Expression {
        let own = "root_of_polynomial";
        self.resolved(&expression.with(name, &Expression::variable(own)))
            .with(own, &Expression::variable(name))
    }

    /// The numbers of the equations that an expression names.
    pub fn equations_of(&self, expression: &Expression) -> impl Iterator<Item = &str> {
        let named = expression.variables();
        let of = self.definitions.iter().filter(move |(name, _)| named.contains(*name));
        of.map(|(_, (_, number))| number.as_str())
    }
}
