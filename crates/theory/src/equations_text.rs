//! What a file of equations states, as it is written.

use std::collections::BTreeMap;

/// The equations of a paper as text, as a file states them.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EquationsText {
    /// What is assumed of the variables.
    pub assumptions: AssumptionsText,
    /// The equations in any order.
    #[serde(default)]
    pub equation: Vec<EquationText>,
    /// Functions of which nothing is known but that they are smooth.
    #[serde(default)]
    pub function: Vec<FunctionText>,
    /// Systems of differential equations.
    #[serde(default)]
    pub system: Vec<SystemText>,
    /// The units of the variables.
    #[serde(default)]
    pub units: BTreeMap<String, String>,
    /// Names that stand for an expression or a derivation.
    #[serde(default)]
    pub definition: Vec<DefinitionText>,
    /// What the variables are, by the words of [`super::QUANTITIES`]: procedures find them so.
    #[serde(default)]
    pub quantities: BTreeMap<String, String>,
}

impl EquationsText {
    /// The sections of the file.
    pub const SECTIONS: [&str; 7] =
        ["assumptions", "equation", "function", "system", "units", "definition", "quantities"];
}

/// What the equations assume of their variables.
#[derive(Debug, Clone, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AssumptionsText {
    /// Names of the variables that are positive.
    pub positive: Vec<String>,
    /// Names of variables of either sign.
    #[serde(default)]
    pub free: Vec<String>,
    /// Conditions for everything in the file, such as `A < B`.
    #[serde(default)]
    pub conditions: Vec<String>,
}

/// An autonomous system of differential equations of first order, as text.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SystemText {
    /// Its name.
    pub name: String,
    /// The variables that move.
    pub state: Vec<String>,
    /// Their rates.
    pub rates: Vec<String>,
    /// Their values at which all rates are zero; empty where none are stated.
    #[serde(default)]
    pub steady: Vec<String>,
}

/// A function of one argument, as text: it has a value and derivatives of all orders everywhere, and nothing else is known of it.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FunctionText {
    /// The name.
    pub name: String,
    /// A variable with the unit of the argument.
    pub of: Option<String>,
    /// What it is.
    #[serde(default)]
    pub note: String,
}

/// A definition as text.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DefinitionText {
    /// The name.
    pub name: String,
    /// An expression, or a derivation such as `characteristic(aging, s)`.
    pub is: String,
    /// What it is defined for, besides the assumptions of the file.
    #[serde(default)]
    pub given: Vec<String>,
    /// What it is.
    #[serde(default)]
    pub note: String,
}

/// One equation as text.
#[derive(Debug, Clone, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EquationText {
    /// Its number in the paper, or its name.
    pub number: String,
    /// Both sides as they are meant, with one `=`.
    pub equation: String,
    /// Both sides as the page at hand shows them, where that differs.
    pub printed: Option<String>,
    /// Why it differs, or what it is.
    #[serde(default)]
    pub note: String,
    /// What it is stated for, besides the assumptions of the file.
    #[serde(default)]
    pub given: Vec<String>,
    /// What it is, as a word of [`super::Role`]: procedures find it so.
    pub role: Option<String>,
}
