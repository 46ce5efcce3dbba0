//! The names of a proof: sides of equations, and what stands after `let`.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Domain, Expression, Proof, Symbol};

use super::super::Equation;
use super::super::derivation::{Operation, Work, derive, exchanged, read_name};
use super::super::names::circle;
use super::{Faults, StatedProof, StatedProofs};

pub(super) use super::super::Derivation as Form;

/// Reads the names of a file or of a proof.
pub(super) fn read_names(
    texts: &BTreeMap<String, String>,
    known: &mut BTreeMap<String, Form>,
    faults: &mut Faults,
) {
    for (name, text) in texts {
        faults.under(name, |faults| {
            if read_name(name).is_none() || is_side(name) {
                faults.add("it is no name that a proof can bring in".to_owned());
            }
            let Some(form) = faults.keep(Form::read(text, &BTreeSet::new())) else { return };
            if form.system.is_some() {
                faults.add(OF_SYSTEM.to_owned());
            }
            faults.once(known.insert(name.clone(), form).is_some());
        });
    }
}

/// Complains about names that mean themselves.
pub(super) fn check_names(known: &BTreeMap<String, Form>, faults: &mut Faults) {
    let of = |name: &String| name.parse::<Symbol>().ok();
    let uses: BTreeMap<_, _> =
        known.iter().filter_map(|(name, form)| Some((of(name)?, form.names()))).collect();
    if let Some(way) = uses.keys().find_map(|name| circle(name, &uses)) {
        let way: Vec<&str> = way.iter().map(Symbol::as_str).collect();
        faults.add(format!("the names go round in a circle: {}", way.join(" -> ")));
    }
}

pub(super) const OF_SYSTEM: &str = "a derivation of a system stands in equations.toml, as a definition";

pub(super) fn is_side(name: &str) -> bool {
    ["left_", "right_", "residual_"].iter().any(|side| name.starts_with(side))
}

/// The names that one proof may use, with what they mean.
pub(super) struct Named<'p> {
    pub all: &'p StatedProofs,
    pub proof: &'p StatedProof,
    sides: BTreeMap<String, (Expression, &'p str)>,
    /// The numbers of the equations, in the order of their file.
    order: Vec<&'p str>,
}

/// An expression in variables only, and the numbers of the equations behind it.
pub(super) type Meant = (Expression, BTreeSet<String>);

impl<'p> Named<'p> {
    pub fn new(all: &'p StatedProofs, proof: &'p StatedProof, equations: &[&'p Equation]) -> Self {
        let mut sides = BTreeMap::new();
        for equation in equations {
            let number = equation.number.as_str();
            sides.extend(equation.sides().map(|(name, expression)| (name, (expression, number))));
        }
        let order = equations.iter().map(|equation| equation.number.as_str()).collect();
        Self { all, proof, sides, order }
    }

    /// An expression with the meanings in place of the names.
    ///
    /// # Errors
    /// A side of an equation that is not there; a derivation without a result.
    pub fn meant(&self, expression: &Expression) -> Result<Meant, String> {
        let mut numbers = BTreeSet::new();
        let mut values = BTreeMap::new();
        for name in expression.variables() {
            if let Some((value, behind)) = self.meaning(&name)? {
                numbers.extend(behind);
                values.insert(name, value);
            }
        }
        Ok((expression.substitute(&values), numbers))
    }

    fn meaning(&self, name: &Symbol) -> Result<Option<Meant>, String> {
        let text = name.as_str();
        if let Some((side, number)) = self.sides.get(text) {
            return Ok(Some((side.clone(), BTreeSet::from([(*number).to_owned()]))));
        }
        match self.proof.names.get(text).or_else(|| self.all.names.get(text)) {
            Some(form) => self.formed(form).map(Some).map_err(|reason| format!("{text}: {reason}")),
            None if is_side(text) => Err(format!("there is no equation for the name `{text}`")),
            None => Ok(None),
        }
    }

    /// What is derived, with the meanings in place of the names.
    ///
    /// # Errors
    /// As [`Self::meant`].
    pub fn formed(&self, form: &Form) -> Result<Meant, String> {
        let mut numbers = BTreeSet::new();
        let mut meant = |expression: &Expression| {
            let (value, behind) = self.meant(expression)?;
            numbers.extend(behind);
            Ok::<_, String>(value)
        };
        let mut form = form.clone();
        for expression in &mut form.expressions {
            *expression = meant(expression)?;
        }
        for (_, value) in &mut form.values {
            *value = meant(value)?;
        }
        let found = match (form.operation, &form.expressions[..], &form.variables[..]) {
            (None, [f], _) => f.clone(),
            (Some(Operation::At), [f], _) => f.substitute(&form.values.iter().cloned().collect()),
            (Some(Operation::Derivative), [f], [x]) => f.derivative(x),
            (Some(Operation::Exchange), [f], [x, y]) => exchanged(f, [x, y]),
            _ => {
                let over = self.all.domain(&self.proof.over, self)?;
                let in_domain = |domain: Domain| {
                    let proof = Proof::new("derivation", "");
                    derive(&form, None, &mut Work { domain, proof, equations: &[] })
                };
                // In the variables of the proof where their assumptions suffice, else in the parameters that stand for them.
                in_domain(over.original()).or_else(|_| in_domain(over))?
            }
        };
        Ok((found, numbers))
    }

    /// The numbers of the equations behind some names, in the order of the equations' file.
    pub fn numbers_behind(&self, names: &BTreeSet<Symbol>) -> Vec<&'p str> {
        let sides = self.all.sides_behind(names.iter().map(ToString::to_string).collect(), self.proof);
        let numbers: BTreeSet<&str> =
            sides.iter().filter_map(|side| self.sides.get(side)).map(|(_, number)| *number).collect();
        self.order.iter().copied().filter(|number| numbers.contains(number)).collect()
    }

    /// These numbers in the order of the equations' file.
    pub fn in_order(&self, numbers: &BTreeSet<String>) -> Vec<String> {
        let known = self.order.iter().filter(|number| numbers.contains(**number));
        known.map(|number| (*number).to_owned()).collect()
    }

    /// A statement with the expressions in the place of `{name}`.
    pub fn filled(&self, says: &str) -> Result<String, String> {
        let mut parts = says.split('{');
        let mut text = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (name, rest) = part.split_once('}').ok_or_else(|| format!("'{says}' has no '}}'"))?;
            let name: Expression = name.parse().map_err(|error| format!("'{name}': {error}"))?;
            text += &self.meant(&name)?.0.to_string();
            text += rest;
        }
        Ok(text)
    }
}
