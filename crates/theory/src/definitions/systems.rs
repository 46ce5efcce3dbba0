//! Reading the systems of a file.

use std::collections::{BTreeMap, BTreeSet};

use super::Reader;
use super::assumptions::with_conditions;
use crate::derivation::{MOST_STATES, NOT_A_NAME, System, Work, is_name, read_name};
use crate::equations_text::SystemText;
use slipmode_algebra::{Condition, Domain, Expression, Proof, Symbol};

impl Reader<'_> {
    pub(super) fn read_systems(&mut self, known: &BTreeSet<Symbol>) -> BTreeMap<String, System> {
        let mut systems = BTreeMap::new();
        for text in &self.rest.systems {
            let key = format!("system {}", text.name);
            match self.read_system(text, known) {
                Ok(_) if systems.contains_key(&text.name) => self.fault(&key, "occurs twice"),
                Ok(system) => {
                    systems.insert(text.name.clone(), system);
                }
                Err(messages) => messages.into_iter().for_each(|message| self.fault(&key, message)),
            }
        }
        systems
    }

    fn read_system(&self, text: &SystemText, known: &BTreeSet<Symbol>) -> Result<System, Vec<String>> {
        let mut messages = Vec::new();
        let count = text.state.len();
        if !is_name(&text.name) {
            messages.push(NOT_A_NAME.to_owned());
        }
        if count == 0
            || count > MOST_STATES
            || text.rates.len() != count
            || ![0, count].contains(&text.steady.len())
        {
            let (rates, steady) = (text.rates.len(), text.steady.len());
            messages.push(format!("{count} states, {rates} rates and {steady} steady values (allowed: 1 to {MOST_STATES}, as many of each)"));
        }
        let distinct: BTreeSet<&String> = text.state.iter().collect();
        if distinct.len() != count || text.state.iter().any(|name| !is_name(name)) {
            messages.push("the states are different names".to_owned());
        }
        let mut side = |place: String, text: &String| -> Expression {
            match Expression::read_in(text, &self.names.functions) {
                Ok((expression, _)) => {
                    let names = expression.variables().into_iter().filter(|name| !known.contains(name));
                    let message =
                        |name: Symbol| format!("{place} '{text}': {}", self.unknown(name.as_str(), known));
                    messages.extend(names.map(message));
                    expression
                }
                Err(error) => {
                    messages.push(format!("{place} '{text}', {error}"));
                    Expression::integer(0)
                }
            }
        };
        let mut all = |what: &str, list: &[String]| -> Vec<Expression> {
            list.iter().zip(1..).map(|(text, at)| side(format!("{what} {at}"), text)).collect()
        };
        let (rates, steady) = (all("rate", &text.rates), all("steady value", &text.steady));
        let state: Vec<Symbol> = text.state.iter().filter_map(|name| read_name(name)).collect();
        if let Some(moving) = steady.iter().flat_map(Expression::variables).find(|name| state.contains(name))
        {
            messages.push(format!("a steady value contains the state {moving}"));
        }
        match messages.is_empty() {
            true => Ok(System { name: text.name.clone(), state, rates, steady }),
            false => Err(messages),
        }
    }

    /// Each system is checked to be at rest at its steady state.
    pub(super) fn keep_systems(&mut self, systems: BTreeMap<String, System>, domain: &Domain) {
        for (name, system) in systems {
            let parts = || system.rates.iter().chain(&system.steady);
            // A name that is at fault was reported where it is defined.
            if parts().flat_map(Expression::variables).any(|name| !self.names.has(&name)) {
                continue;
            }
            let given: Vec<Condition> = parts().flat_map(|one| self.names.given_of(one)).cloned().collect();
            let equations: Vec<String> = vec![format!("system {name}")];
            let resolved = system.map(|one| self.names.resolved(one));
            let checked = with_conditions(domain.clone(), &given).and_then(|domain| {
                let mut work = Work { domain, proof: Proof::new(&name, ""), equations: &equations };
                for rate in &resolved.rates {
                    work.has_value(rate).map_err(|error| format!("a rate has no value: {error}"))?;
                }
                resolved.rest(&mut work)
            });
            match checked {
                Ok(()) => {
                    self.names.systems.insert(name, resolved);
                }
                Err(message) => self.fault(&format!("system {name}"), message),
            }
        }
    }
}
