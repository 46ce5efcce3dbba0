//! Assumptions that proofs share.

use std::collections::BTreeSet;

use slipmode_algebra::{Comparison, Condition, Domain, Expression, Source, Symbol};

use super::super::derivation::{read_condition, read_name};
use super::names::Named;
use super::{DomainText, Faults};

/// Assumptions, parsed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct DomainForm {
    pub of: String,
    positive: Vec<Symbol>,
    given: Vec<Condition>,
    with: Vec<Substitution>,
    example: Vec<Equal>,
}

/// `name = value`.
pub(super) type Equal = (Symbol, Expression);

/// A variable in others, and the parameter with its value.
type Substitution = (Equal, Option<Equal>);

impl DomainForm {
    pub fn read(text: &DomainText, faults: &mut Faults) -> Self {
        let mut all = Self { of: text.of.clone(), ..Self::default() };
        for name in &text.positive {
            all.positive.extend(faults.keep(read_name(name).ok_or_else(|| format!("'{name}' is no name"))));
        }
        for condition in &text.given {
            all.given.extend(faults.keep(read_condition(condition, &BTreeSet::new())));
        }
        for entry in &text.with {
            let (value, parameter) = match entry.split_once(" where ") {
                Some((value, parameter)) => (value, Some(parameter)),
                None => (entry.as_str(), None),
            };
            let parameter = parameter.map(read_equal).transpose();
            all.with.extend(faults.keep(read_equal(value).and_then(|value| Ok((value, parameter?)))));
        }
        all.example.extend(text.example.iter().filter_map(|entry| faults.keep(read_equal(entry))));
        all
    }

    /// The domain with these assumptions besides.
    ///
    /// # Errors
    /// A name in them without a meaning.
    pub fn add_to(&self, domain: Domain, named: &Named<'_>) -> Result<Domain, String> {
        let mut domain = self.positive.iter().fold(domain, |domain, name| domain.with_positive(name.clone()));
        for Condition { expression, relation } in &self.given {
            domain = domain.given(named.meant(expression)?.0, *relation);
        }
        for ((name, value), parameter) in &self.with {
            domain = domain.with(name.clone(), named.meant(value)?.0);
            if let Some((name, value)) = parameter {
                domain = domain.parameter(name.clone(), named.meant(value)?.0);
            }
        }
        for (name, value) in &self.example {
            domain = domain.example(name.clone(), named.meant(value)?.0);
        }
        Ok(domain)
    }

    /// The expressions that are put in the place of variables.
    pub fn values(&self) -> impl Iterator<Item = &Expression> {
        self.with.iter().map(|((_, value), _)| value)
    }
}

/// `name = value`.
///
/// # Errors
/// Another form.
pub(super) fn read_equal(text: &str) -> Result<Equal, String> {
    let source = Source::new(text);
    let [(name, Comparison::Equal, value)] = Source::comparisons(text)[..] else {
        return Err(format!("'{text}' is not of the form `x = value`"));
    };
    let name = read_name(name.trim()).ok_or_else(|| format!("'{}' is no name", name.trim()))?;
    let (value, _) = source.expression(value).map_err(|error| format!("'{text}', {error}"))?;
    Ok((name, value))
}
