//! A domain as hypotheses: what a theorem assumes, how substitutions cover it, and that it can hold.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use rug::ops::{DivRounding, Pow};

use super::Block;
use super::Obstacle;
use super::tactic::Tactics;
use super::term::{complex, condition, name, outer_calls, real};
use crate::number::Rational;
use crate::{Condition, Domain, Expression, Function, Symbol};

/// Computes an enclosure for each hypothesis, with a tactic of `proofs/Signs.v`.
const ENCLOSURE: &str = "repeat match goal with |- _ /\\ _ => split end; met";

/// The domain of a theorem, and which of its variables are complex.
pub(super) struct Setting<'d> {
    pub domain: &'d Domain,
    /// Complex variables.
    pub complex: BTreeSet<Symbol>,
    pub is_complex: bool,
    /// The variables that the statement itself binds.
    pub bound: BTreeSet<Symbol>,
    /// What is assumed not to be zero, beyond the domain.
    pub nonzero: Option<Expression>,
}

/// Variables and hypotheses, in the order of a theorem's binders.
#[derive(Default)]
pub(super) struct Binders {
    pub variables: Vec<(Symbol, &'static str)>,
    pub hypotheses: Vec<(String, String)>,
}

impl Binders {
    /// The binders as Coq reads them.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for kind in ["R", "C"] {
            let of_kind = self.variables.iter().filter(|(_, of)| *of == kind);
            let names: Vec<String> = of_kind.map(|(symbol, _)| name(symbol)).collect();
            if !names.is_empty() {
                let _ = write!(text, " ({} : {kind})", names.join(" "));
            }
        }
        for (label, statement) in &self.hypotheses {
            let _ = write!(text, " ({label} : {statement})");
        }
        text
    }

    /// Does a hypothesis speak of this variable?
    pub fn mentions(&self, variable: &Symbol) -> bool {
        let variable = name(variable);
        let is_inner = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
        self.hypotheses.iter().any(|(_, text)| text.split(|c| !is_inner(c)).any(|word| word == variable))
    }

    /// The variables, in the order of the binders.
    pub fn names(&self) -> Vec<String> {
        let of_kind = |kind| self.variables.iter().filter(move |(_, of)| *of == kind);
        ["R", "C"].into_iter().flat_map(of_kind).map(|(symbol, _)| name(symbol)).collect()
    }

    /// The same names as arguments.
    fn arguments(&self) -> String {
        let labels = self.hypotheses.iter().map(|(label, _)| label.clone());
        self.names().into_iter().chain(labels).collect::<Vec<_>>().join(" ")
    }
}

impl Setting<'_> {
    /// Substitutions that stand for an assumption.
    fn covered(&self) -> Vec<&(Symbol, Expression)> {
        self.domain.substitutions().iter().filter(|(name, _)| self.domain.is_assumed(name)).collect()
    }

    /// Substitutions that define a variable without assumptions.
    fn defined(&self) -> Vec<&(Symbol, Expression)> {
        self.domain.substitutions().iter().filter(|(name, _)| !self.domain.is_assumed(name)).collect()
    }

    /// The variables that a statement on these expressions needs, in the original variables.
    fn relevant(&self, start: BTreeSet<Symbol>) -> BTreeSet<Symbol> {
        let mut names = start;
        names.extend(self.domain.conditions().iter().flat_map(|given| given.expression.variables()));
        loop {
            let before = names.len();
            let covered = self.covered();
            if covered.iter().any(|(name, _)| names.contains(name)) {
                names.extend(covered.iter().map(|(name, _)| name.clone()));
                names.extend(self.domain.parameters().iter().flat_map(|(_, value)| value.variables()));
                names.extend(covered.iter().flat_map(|(_, value)| {
                    let inner = value.variables().into_iter();
                    inner.filter(|inner| !self.is_parameter(inner))
                }));
            }
            let values =
                self.defined().into_iter().chain(self.domain.parameters()).chain(self.domain.squares());
            let used: Vec<Symbol> = values
                .filter(|(name, _)| names.contains(name))
                .flat_map(|(_, value)| value.variables())
                .collect();
            names.extend(used);
            if names.len() == before {
                return names;
            }
        }
    }

    /// The text of a term of the statement.
    pub fn term(&self, expression: &Expression) -> String {
        if self.is_complex { complex(expression, &self.complex) } else { real(expression) }
    }

    fn is_parameter(&self, name: &Symbol) -> bool {
        self.domain.parameters().iter().any(|(known, _)| known == name)
    }

    fn bind(
        &self,
        names: &BTreeSet<Symbol>,
        domain: &Domain,
        conditions: &[Condition],
        squares: Vec<(Symbol, Expression)>,
    ) -> Binders {
        let mut binders = Binders::default();
        let names: BTreeSet<&Symbol> =
            names.iter().filter(|name| !self.bound.contains(*name) && name.as_str() != "i").collect();
        for symbol in &names {
            let kind = if self.complex.contains(*symbol) { "C" } else { "R" };
            binders.variables.push(((*symbol).clone(), kind));
        }
        for symbol in names.iter().filter(|name| domain.is_positive(name)) {
            let variable = name(symbol);
            binders.hypotheses.push((format!("{variable}'pos"), format!("0 < {variable}")));
        }
        if names.iter().any(|name| name.as_str() == "pm") {
            binders.hypotheses.push(("pm'square".to_owned(), "pm ^ 2 = 1".to_owned()));
        }
        if let Some(nonzero) = &self.nonzero {
            binders.hypotheses.push(("single'root".to_owned(), format!("{} <> 0", real(nonzero))));
        }
        for (index, given) in conditions.iter().enumerate() {
            binders.hypotheses.push((format!("given'{}", index + 1), condition(given)));
        }
        for (known, square) in squares {
            let known = name(&known);
            binders.hypotheses.push((format!("{known}'square"), format!("{known} ^ 2 = {}", real(&square))));
        }
        binders
    }

    /// The binders of the statement after the substitutions.
    pub fn substituted(&self, expressions: &[&Expression]) -> Binders {
        let mut names: BTreeSet<Symbol> =
            expressions.iter().flat_map(|part| self.domain.as_written(part).variables()).collect();
        let conditions = self.domain.conditions().iter();
        let written = |given: &Condition| self.domain.as_written(&given.expression);
        let conditions: Vec<Condition> = conditions
            .map(|given| Condition { expression: written(given), relation: given.relation })
            .collect();
        names.extend(conditions.iter().flat_map(|given| given.expression.variables()));
        let mut squares = Vec::new();
        for (known, square) in self.domain.squares() {
            let square = self.domain.as_written(square);
            if names.contains(known) {
                names.extend(square.variables());
                squares.push((known.clone(), square));
            }
        }
        names.extend(self.nonzero.iter().flat_map(Expression::variables));
        self.bind(&names, self.domain, &conditions, squares)
    }

    /// The binders of the statement in the original variables.
    pub fn original(&self, expressions: &[&Expression]) -> Binders {
        let stated = expressions.iter().copied().chain(&self.nonzero);
        let names = self.relevant(stated.flat_map(Expression::variables).collect());
        let in_use = |(known, _): &&(Symbol, Expression)| names.contains(known);
        let squares = self.domain.squares().iter().filter(in_use).cloned().collect();
        let mut binders = self.bind(&names, &self.domain.original(), self.domain.conditions(), squares);
        for (known, value) in self.domain.parameters().iter().filter(in_use) {
            let known = name(known);
            binders.hypotheses.push((format!("{known}'value"), format!("{known} = {}", real(value))));
        }
        for (known, value) in self.defined().into_iter().filter(in_use) {
            let is_complex = self.complex.contains(known);
            let known = name(known);
            let equality = match is_complex {
                true => format!("({known} = {})%C", complex(value, &self.complex)),
                false => format!("{known} = {}", real(value)),
            };
            binders.hypotheses.push((format!("{known}'is"), equality));
        }
        binders
    }

    /// Is the statement after the substitutions the statement itself?
    pub fn is_plain(&self) -> bool {
        self.domain.substitutions().is_empty() && self.domain.parameters().is_empty()
    }

    /// Goes from the original variables to those after the substitutions, and applies the lemma on them.
    pub fn transfer(&self, original: &Binders, substituted: &Binders, lemma: &str) -> String {
        let mut tactics = String::new();
        let has = |variable: &Symbol| original.variables.iter().any(|(known, _)| known == variable);
        let covered = self.covered();
        let used = covered.iter().any(|(known, _)| has(known))
            || self.domain.parameters().iter().any(|(known, _)| has(known));
        if used {
            for (known, value) in self.domain.parameters().iter().filter(|(known, _)| !has(known)) {
                let known = name(known);
                let _ = write!(
                    tactics,
                    "assert (ex' : exists x', x' = {}) by (eexists; reflexivity); destruct ex' as [{known} {known}'value]; ",
                    real(value)
                );
            }
            let cover = self.cover_binders();
            let _ = write!(tactics, "pose proof ({} {}) as cover'; ", self.cover_name(), cover.arguments());
            for (known, _) in self.domain.parameters() {
                let _ = write!(tactics, "destruct cover' as [{}'pos cover']; ", name(known));
            }
            for (known, _) in &covered {
                let _ = write!(tactics, "destruct cover' as [{}'is cover']; ", name(known));
            }
            for (known, _) in self.domain.parameters() {
                let _ = write!(tactics, "clear {}'value; ", name(known));
            }
        }
        for (known, _) in self.domain.substitutions().iter().filter(|(known, _)| has(known)) {
            let _ = write!(tactics, "subst {}; ", name(known));
        }
        tactics + &format!("exact ({lemma} {})", substituted.arguments())
    }

    fn cover_binders(&self) -> Binders {
        let covered = self.covered().into_iter().chain(self.domain.parameters());
        let all: Vec<Expression> = covered.map(|(known, _)| Expression::Variable(known.clone())).collect();
        self.original(&all.iter().collect::<Vec<_>>())
    }

    fn cover_name(&self) -> String {
        format!("cover_{}", super::digest(&self.domain.to_string()))
    }

    /// The lemma that the substitutions reach every point of the assumptions, if there are any.
    pub fn cover(&self) -> Result<Option<Block>, Obstacle> {
        let covered = self.covered();
        if covered.is_empty() && self.domain.parameters().is_empty() {
            return Ok(None);
        }
        let original = self.domain.original();
        let tactics = Tactics(&original);
        let parameters = self.domain.parameters();
        let values = parameters.iter().map(|(known, value)| (known.clone(), value.clone())).collect();
        let (mut parts, mut proofs) = (Vec::new(), Vec::new());
        for (known, value) in parameters {
            parts.push(format!("0 < {}", name(known)));
            proofs.push(tactics.sign(value, 1)?);
        }
        for (known, value) in &covered {
            parts.push(format!("{} = {}", name(known), real(value)));
            proofs.push(tactics.equal(&Expression::Variable(known.clone()), &value.replaced(&values))?);
        }
        parts.push("True".to_owned());
        let substituted: String =
            parameters.iter().map(|(known, _)| format!("subst {}; ", name(known))).collect();
        let mut proof = format!("{substituted}{}", tactics.facts()?);
        for part in &proofs {
            let _ = write!(proof, "split; [ {part} | ]; ");
        }
        proof += "exact I";
        let label = self.cover_name();
        let text = format!(
            "Lemma {label}{} :\n  {}.\nProof. {proof}. Qed.\n",
            self.cover_binders().text(),
            parts.join(" /\\ ")
        );
        Ok(Some(Block { name: label, text }))
    }

    /// The lemma that the assumptions hold somewhere, if there are any.
    pub fn witness(&self, original: &Binders) -> Option<Block> {
        if original.hypotheses.is_empty() {
            return None;
        }
        let label = format!("possible_{}", super::digest(&original.text()));
        let value = |symbol: &Symbol| {
            let mut defined = self.domain.parameters().iter().chain(self.domain.substitutions());
            let is_defined = !self.domain.is_assumed(symbol) && defined.any(|(known, _)| known == symbol);
            (!is_defined).then(|| match &self.nonzero {
                _ if symbol.as_str() == "pm" => "1".to_owned(),
                // The value 0, which is the example of a name without assumptions, often makes a double root.
                Some(value) if value.contains(symbol) => "2".to_owned(),
                _ => real(&Expression::Number(self.domain.original().example_of(symbol))),
            })
        };
        let mut proof = String::new();
        for (variable, kind) in &original.variables {
            proof += &match value(variable) {
                Some(value) if *kind == "C" => format!("exists (RtoC {value}); "),
                Some(value) => format!("exists {value}; "),
                None => "eexists; ".to_owned(),
            };
        }
        let (rational, others, close) = self.calls_at_the_example();
        for root in rational {
            let _ = write!(proof, "try root_is {}; ", real(&Expression::Number(root)));
        }
        for ends in others {
            let [low, high] = ends.map(|end| real(&Expression::Number(end)));
            let _ = write!(
                proof,
                "try (match goal with |- context [sqrt ?x] => \
                 assert ({low} < sqrt x < {high}) by (split; \
                 [ rewrite <- (sqrt_square {low}) by lra; apply sqrt_lt_1; lra \
                 | rewrite <- (sqrt_square {high}) by lra; apply sqrt_lt_1; lra ]) end); "
            );
        }
        let names: Vec<String> =
            original.variables.iter().map(|(symbol, kind)| format!("({} : {kind})", name(symbol))).collect();
        let statements: Vec<&str> = original.hypotheses.iter().map(|(_, text)| text.as_str()).collect();
        let text = format!(
            "Lemma {label} :\n  exists {}, {}.\nProof. {proof}{close}. Qed.\n",
            names.join(" "),
            statements.join(" /\\ ")
        );
        Some(Block { name: label, text })
    }

    /// The rational values that square roots of the conditions have at the example, inner roots first, and bounds of the others. Then
    /// the tactic for the conditions there: with an exponential or a logarithm that is no rational number it computes enclosures.
    fn calls_at_the_example(&self) -> (Vec<Rational>, Vec<[Rational; 2]>, &'static str) {
        let domain = self.domain.original();
        let (mut values, mut others, mut close) = (Vec::new(), Vec::new(), "possible");
        let mut waiting: Vec<Expression> =
            domain.conditions().iter().map(|given| given.expression.clone()).collect();
        while let Some(next) = waiting.pop() {
            let mut calls = BTreeMap::new();
            outer_calls(&next, &mut calls);
            for call in calls.into_values() {
                let Expression::Call(function, inner) = &call else { continue };
                waiting.push((**inner).clone());
                let names = inner.variables().into_iter();
                let point = names.map(|name| (name.clone(), domain.example_of(&name))).collect();
                match (function, call.rational_value(&point)) {
                    (Function::Sqrt, Some(value)) => values.push(value),
                    (Function::Sqrt, None) => {
                        others.extend(inner.rational_value(&point).and_then(root_bounds))
                    }
                    (Function::Exp | Function::Ln, None) => close = ENCLOSURE,
                    _ => {}
                }
            }
        }
        values.reverse();
        (values, others, close)
    }
}

/// Rational numbers below and above the root of a positive number.
fn root_bounds(square: Rational) -> Option<[Rational; 2]> {
    let scale = rug::Integer::from(10).pow(12);
    let scaled = square * scale.clone() * &scale;
    let root = (scaled > 0).then(|| scaled.numer().clone().div_floor(scaled.denom()).sqrt())?;
    Some([root.clone(), root + 1_u32].map(|end| Rational::from((end, scale.clone()))))
}
