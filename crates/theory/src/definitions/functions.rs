//! The functions that a file declares: smooth, with a value everywhere, and nothing else is known of them.

use std::collections::{BTreeMap, BTreeSet};

use super::{Forms, Reader};
use crate::derivation::{NOT_A_NAME, Operation, read_name};
use crate::names::Defined;
use crate::root_location::RootStatement;
use crate::{EquationFault, FunctionText};
use slipmode_algebra::Symbol;

/// The names of the functions, those at fault left out.
pub(crate) fn functions(texts: &[FunctionText]) -> BTreeSet<Symbol> {
    texts.iter().filter_map(|text| read_name(&text.name)).filter(|name| !is_reserved(name)).collect()
}

/// Whether a name before a bracket means something else in a definition or a formula, or ends like a predicate.
fn is_reserved(name: &Symbol) -> bool {
    let word = name.as_str();
    let mut predicates = RootStatement::ALL.map(RootStatement::as_str).into_iter().chain(["pair_crosses"]);
    ["i", "pm"].contains(&word)
        || Operation::from_word(word).is_some()
        || predicates.any(|predicate| word.ends_with(predicate))
}

impl Reader<'_> {
    /// Each function has a name of its own, and `of` names a variable.
    pub(super) fn check_functions(
        &mut self,
        assumed: &BTreeSet<Symbol>,
        defined: &BTreeMap<Symbol, Defined>,
        forms: &Forms<'_>,
    ) {
        let rest = self.rest;
        let mut faults: Vec<EquationFault> = Vec::new();
        let mut seen = BTreeSet::new();
        for text in &rest.functions {
            let key = format!("function {}", text.name);
            let mut fault = |message: String| faults.push(EquationFault { key: key.clone(), message });
            match read_name(&text.name).filter(|name| !is_reserved(name)) {
                None => fault(NOT_A_NAME.to_owned()),
                Some(name) => {
                    let taken = match defined.get(&name) {
                        Some(one) => Some(format!("equation {}", one.number)),
                        None if forms.contains_key(&name) => Some("a definition".to_owned()),
                        None => assumed
                            .contains(&name)
                            .then(|| "an assumption, a state or a derivation".to_owned()),
                    };
                    if let Some(taken) = taken {
                        fault(format!("the name has a meaning by {taken}"));
                    }
                    if !seen.insert(name) {
                        fault("occurs twice".to_owned());
                    }
                }
            }
            match &text.of {
                Some(of) if !self.names.variables.iter().any(|known| known.as_str() == of) => {
                    fault(format!("`of`: {}", self.unknown(of, &self.names.variables)));
                }
                None if !rest.units.is_empty() => {
                    fault(
                        "the file states units: `of` names a variable with the unit of the argument"
                            .to_owned(),
                    );
                }
                _ => {}
            }
        }
        self.faults.extend(faults);
    }
}
