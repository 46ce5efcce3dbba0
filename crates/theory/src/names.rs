//! What the names of a file of equations mean: variables, names that an equation defines, definitions.

use std::collections::{BTreeMap, BTreeSet};

use crate::Equation;
use crate::derivation::System;
use crate::units::Units;
use slipmode_algebra::{Condition, Expression, Proof, Symbol};

/// What a name means.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Meaning {
    /// In variables only.
    pub expression: Expression,
    /// The numbers of the equations behind it, and the systems.
    pub equations: Vec<String>,
    /// What it is defined for, besides the assumptions of the file.
    pub given: Vec<Condition>,
    /// What must hold for it to have a value, in variables only, as it and what it uses are written.
    pub demands: Vec<Condition>,
    /// The definitions behind it with a proof, each after those that it uses; itself last.
    proofs: Vec<Symbol>,
}

/// The names of a file of equations.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Names {
    /// Names without a meaning of their own.
    pub(super) variables: BTreeSet<Symbol>,
    pub(super) positive: BTreeSet<Symbol>,
    pub(super) meanings: BTreeMap<Symbol, Meaning>,
    pub(super) systems: BTreeMap<String, System>,
    /// Functions of which nothing is known but that they are smooth.
    pub(super) functions: BTreeSet<Symbol>,
    /// The number of the equation that defines a name.
    pub(super) defining: BTreeMap<Symbol, String>,
    /// Their units, where the file states units.
    pub(super) units: Option<Units>,
    /// The proof of a definition, in the order in which they were worked out.
    pub(super) proofs: BTreeMap<Symbol, Proof>,
}

impl Names {
    /// The names without a meaning of their own.
    #[must_use]
    pub fn variables(&self) -> &BTreeSet<Symbol> {
        &self.variables
    }

    /// The variables that are positive by assumption.
    #[must_use]
    pub fn positive(&self) -> &BTreeSet<Symbol> {
        &self.positive
    }

    /// These variables, without an assumption about them.
    #[must_use]
    pub fn of_variables<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        Self { variables: names.filter_map(|name| name.parse().ok()).collect(), ..Self::default() }
    }

    /// Checks that the two have the same unit, where the file states units.
    ///
    /// # Errors
    /// Both units, or what is wrong with one of the two.
    pub fn same_units(&self, left: &Expression, right: &Expression) -> Result<(), String> {
        self.units.as_ref().map_or(Ok(()), |units| units.same(left, right))
    }

    /// Whether a variable is positive by assumption.
    #[must_use]
    pub fn is_positive(&self, name: &Symbol) -> bool {
        self.positive.contains(name)
    }

    /// All names.
    pub fn all(&self) -> impl Iterator<Item = &str> {
        self.variables.iter().chain(self.meanings.keys()).map(Symbol::as_str)
    }

    /// The functions of which nothing is known but that they are smooth.
    #[must_use]
    pub fn functions(&self) -> &BTreeSet<Symbol> {
        &self.functions
    }

    /// Whether there is such a name.
    #[must_use]
    pub fn has(&self, name: &Symbol) -> bool {
        self.variables.contains(name) || self.meanings.contains_key(name)
    }

    /// What a name means that is not a variable.
    #[must_use]
    pub fn meaning(&self, name: &Symbol) -> Option<&Meaning> {
        self.meanings.get(name)
    }

    /// What the definition of this name was found to be, in variables only.
    #[must_use]
    pub fn derived(&self, name: &str) -> Option<&Expression> {
        self.meanings.iter().find(|(known, _)| known.as_str() == name).map(|(_, one)| &one.expression)
    }

    /// The number of the equation that defines a name: the name stands alone on its left, or means one of its sides.
    pub(crate) fn defining_equation(&self, name: &str) -> Option<&str> {
        self.defining.iter().find(|(known, _)| known.as_str() == name).map(|(_, number)| number.as_str())
    }

    /// The names of the systems.
    pub fn system_names(&self) -> impl Iterator<Item = &str> {
        self.systems.keys().map(String::as_str)
    }

    /// The system of this name.
    #[must_use]
    pub fn system(&self, name: &str) -> Option<&System> {
        self.systems.get(name)
    }

    /// The expression with the meanings in place of the names.
    #[must_use]
    pub fn resolved(&self, expression: &Expression) -> Expression {
        let meaning = |name: Symbol| Some((name.clone(), self.meanings.get(&name)?.expression.clone()));
        expression.substitute(&expression.variables().into_iter().filter_map(meaning).collect())
    }

    /// The meanings of the names in an expression.
    fn meanings_in(&self, expression: &Expression) -> Vec<&Meaning> {
        expression.variables().iter().filter_map(|name| self.meanings.get(name)).collect()
    }

    /// The numbers of the equations, and the systems, behind an expression, in order.
    #[must_use]
    pub fn equations_of(&self, expression: &Expression) -> Vec<&str> {
        let meanings = self.meanings_in(expression).into_iter();
        let all: BTreeSet<&str> = meanings.flat_map(|one| &one.equations).map(String::as_str).collect();
        all.into_iter().collect()
    }

    /// What the definitions behind an expression are given for, besides the assumptions of the file.
    #[must_use]
    pub fn given_of(&self, expression: &Expression) -> Vec<&Condition> {
        distinct(self.meanings_in(expression).into_iter().flat_map(|one| &one.given))
    }

    /// What must hold for an expression to have a value, in variables only: as it is written, and as the definitions behind it are.
    #[must_use]
    pub fn demands_of(&self, expression: &Expression) -> Vec<Condition> {
        let own = expression.demands().into_iter().map(|one| self.resolved_condition(&one));
        let behind = self.meanings_in(expression).into_iter().flat_map(|one| one.demands.iter().cloned());
        distinct(own.chain(behind))
    }

    /// A condition with the meanings in place of the names.
    pub(crate) fn resolved_condition(&self, one: &Condition) -> Condition {
        Condition { expression: self.resolved(&one.expression), relation: one.relation }
    }

    /// The proofs of the definitions behind an expression, each after those that it uses.
    #[must_use]
    pub fn proofs_of(&self, expression: &Expression) -> Vec<&Proof> {
        let order = distinct(self.meanings_in(expression).into_iter().flat_map(|one| &one.proofs));
        order.into_iter().filter_map(|name| self.proofs.get(name)).collect()
    }

    /// Adds a name with the meaning of an expression in earlier names.
    pub(super) fn define(
        &mut self,
        name: &Symbol,
        expression: Expression,
        behind: &[&Expression],
        own: impl IntoIterator<Item = String>,
        given: Vec<Condition>,
        proof: Option<Proof>,
    ) {
        let demands = distinct(behind.iter().flat_map(|expression| self.demands_of(expression)));
        let used: Vec<&Meaning> = behind.iter().flat_map(|expression| self.meanings_in(expression)).collect();
        let equations: BTreeSet<String> =
            used.iter().flat_map(|one| one.equations.iter().cloned()).chain(own).collect();
        let inherited = used.iter().flat_map(|one| one.given.iter().cloned());
        let given = distinct(given.into_iter().chain(inherited));
        let mut proofs = distinct(used.iter().flat_map(|one| one.proofs.iter().cloned()));
        if let Some(proof) = proof {
            proofs.push(name.clone());
            self.proofs.insert(name.clone(), proof);
        }
        let equations = equations.into_iter().collect();
        let meaning = Meaning { expression, equations, given, demands, proofs };
        self.meanings.insert(name.clone(), meaning);
    }
}

/// The items in their order, each once.
pub(super) fn distinct<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    items.fold(Vec::new(), |mut all, one| {
        if !all.contains(&one) {
            all.push(one);
        }
        all
    })
}

/// A name that an equation defines.
pub(super) struct Defined {
    /// What it means, in the names of the equation.
    pub expression: Expression,
    /// The number of the equation.
    pub number: String,
    /// What the equation is given for.
    pub given: Vec<Condition>,
    /// The name that the equation defines, which stays as it is on its sides.
    pub kept: Option<Symbol>,
}

impl Defined {
    /// The names that are to be resolved in it.
    pub fn uses(&self) -> BTreeSet<Symbol> {
        let given = self.given.iter().flat_map(|one| one.expression.variables());
        let mut names: BTreeSet<Symbol> = self.expression.variables().into_iter().chain(given).collect();
        self.kept.as_ref().map(|kept| names.remove(kept));
        names
    }
}

/// A name on the left of two equations, with their numbers.
pub(super) type Doubled = (Symbol, [String; 2]);

/// The names that equations define: each that stands alone on the left of exactly one equation, and `left_N`, `right_N` and
/// `residual_N` for each equation.
///
/// A name that is assumed of keeps its meaning where an equation solves for it, and the two values of a ± define none.
///
/// Besides them, the names on the left of two equations, each with the numbers of both.
pub(super) fn defined_by_equations(
    equations: &[Equation],
    assumed: &BTreeSet<Symbol>,
) -> (BTreeMap<Symbol, Defined>, Vec<Doubled>) {
    let mut defined: BTreeMap<Symbol, Defined> = BTreeMap::new();
    let mut doubled = Vec::new();
    let two_valued = Symbol::from("pm");
    for equation in equations {
        let meaning = |expression: Expression, kept: Option<&Symbol>| {
            let (number, given) = (equation.number.clone(), equation.given.clone());
            Defined { expression, number, given, kept: kept.cloned() }
        };
        let kept = match &equation.left {
            Expression::Variable(name) if !assumed.contains(name) => Some(name),
            _ => None,
        };
        if let Some(name) = kept.filter(|_| !equation.right.variables().contains(&two_valued))
            && let Some(earlier) = defined.insert(name.clone(), meaning(equation.right.clone(), None))
        {
            doubled.push((name.clone(), [earlier.number, equation.number.clone()]));
        }
        for (name, expression) in equation.sides() {
            let kept = kept.filter(|_| !name.starts_with("right"));
            if let Ok(name) = name.parse() {
                defined.insert(name, meaning(expression, kept));
            }
        }
    }
    // A name that is defined by means of itself is a variable.
    let uses: BTreeMap<_, _> = defined.iter().map(|(name, one)| (name.clone(), one.uses())).collect();
    defined.retain(|name, _| circle(name, &uses).is_none());
    // Two laws may give two rates, and a rate is a variable.
    defined.retain(|name, _| !doubled.iter().any(|(known, _)| known == name));
    doubled.retain(|(name, _)| name.derivative_order() == 0);
    (defined, doubled)
}

/// The way from a name back to itself through what the names use, if there is one.
pub fn circle<N: Ord + Clone>(start: &N, uses: &BTreeMap<N, BTreeSet<N>>) -> Option<Vec<N>> {
    let mut from: BTreeMap<&N, &N> = BTreeMap::new();
    let mut open = vec![start];
    while let Some(name) = open.pop() {
        for next in uses.get(name).into_iter().flatten() {
            if next == start {
                let back =
                    std::iter::successors(Some(name), |at| from.get(at).copied().filter(|_| *at != start));
                let mut way: Vec<N> = [start].into_iter().chain(back).cloned().collect();
                way.reverse();
                return Some(way);
            }
            if uses.contains_key(next) && !from.contains_key(next) {
                from.insert(next, name);
                open.push(next);
            }
        }
    }
    None
}

/// The names, each after those that it uses; those of a circle do not occur.
pub(super) fn in_order(uses: &BTreeMap<Symbol, BTreeSet<Symbol>>) -> Vec<Symbol> {
    let mut order: Vec<Symbol> = Vec::new();
    let mut placed: BTreeSet<&Symbol> = BTreeSet::new();
    loop {
        let ready = |(name, used): &(&Symbol, &BTreeSet<Symbol>)| {
            !placed.contains(name) && used.iter().all(|one| !uses.contains_key(one) || placed.contains(one))
        };
        let next: Vec<&Symbol> = uses.iter().filter(ready).map(|(name, _)| name).collect();
        if next.is_empty() {
            return order;
        }
        placed.extend(next.iter());
        order.extend(next.into_iter().cloned());
    }
}
