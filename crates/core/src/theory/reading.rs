//! Reading a file of equations: all faults at once.

use std::collections::{BTreeMap, BTreeSet};

use super::derivation::{NOT_A_NAME, is_name, read_condition};
use super::{Equation, EquationFault, Role, definedness};
use slipmode_algebra::{Condition, Domain, Expression, Symbol};

/// The most equations of a file: each costs a proof that it has a value.
const MOST: usize = 500;

/// The longest number or name of an equation: it is part of a page's links.
const LONGEST_NUMBER: usize = 40;

/// The equations of a paper as text, as a file states them.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct EquationsText {
    /// What is assumed of the variables.
    pub assumptions: AssumptionsText,
    /// The equations in any order.
    #[cfg_attr(feature = "serde", serde(default))]
    pub equation: Vec<EquationText>,
    /// Functions of which nothing is known but that they are smooth.
    #[cfg_attr(feature = "serde", serde(default))]
    pub function: Vec<FunctionText>,
    /// Systems of differential equations.
    #[cfg_attr(feature = "serde", serde(default))]
    pub system: Vec<SystemText>,
    /// The units of the variables.
    #[cfg_attr(feature = "serde", serde(default))]
    pub units: BTreeMap<String, String>,
    /// Names that stand for an expression or a derivation.
    #[cfg_attr(feature = "serde", serde(default))]
    pub definition: Vec<DefinitionText>,
    /// What the variables are, by the words of [`super::roles::QUANTITIES`]: procedures find them so.
    #[cfg_attr(feature = "serde", serde(default))]
    pub quantities: BTreeMap<String, String>,
}

impl EquationsText {
    /// The sections of the file.
    pub const SECTIONS: [&str; 7] =
        ["assumptions", "equation", "function", "system", "units", "definition", "quantities"];
}

/// What the equations assume of their variables.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct AssumptionsText {
    /// Names of the variables that are positive.
    pub positive: Vec<String>,
    /// Names of variables of either sign.
    #[cfg_attr(feature = "serde", serde(default))]
    pub free: Vec<String>,
    /// Conditions for everything in the file, such as `A < B`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub conditions: Vec<String>,
}

/// An autonomous system of differential equations of first order, as text.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct SystemText {
    /// Its name.
    pub name: String,
    /// The variables that move.
    pub state: Vec<String>,
    /// Their rates.
    pub rates: Vec<String>,
    /// Their values at which all rates are zero; empty where none are stated.
    #[cfg_attr(feature = "serde", serde(default))]
    pub steady: Vec<String>,
}

/// A function of one argument, as text: it has a value and derivatives of all orders everywhere, and nothing else is known of it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct FunctionText {
    /// The name.
    pub name: String,
    /// A variable with the unit of the argument.
    pub of: Option<String>,
    /// What it is.
    #[cfg_attr(feature = "serde", serde(default))]
    pub note: String,
}

/// A definition as text.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct DefinitionText {
    /// The name.
    pub name: String,
    /// An expression, or a derivation such as `characteristic(aging, s)`.
    pub is: String,
    /// What it is defined for, besides the assumptions of the file.
    #[cfg_attr(feature = "serde", serde(default))]
    pub given: Vec<String>,
    /// What it is.
    #[cfg_attr(feature = "serde", serde(default))]
    pub note: String,
}

/// One equation as text.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct EquationText {
    /// Its number in the paper, or its name.
    pub number: String,
    /// Both sides as they are meant, with one `=`.
    pub equation: String,
    /// Both sides as the page at hand shows them, where that differs.
    pub printed: Option<String>,
    /// Why it differs, or what it is.
    #[cfg_attr(feature = "serde", serde(default))]
    pub note: String,
    /// What it is stated for, besides the assumptions of the file.
    #[cfg_attr(feature = "serde", serde(default))]
    pub given: Vec<String>,
    /// What it is, as a word of [`Role`]: procedures find it so.
    pub role: Option<String>,
}

/// What a file assumes while its equations are read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Assumed<'a> {
    /// The positive variables and the conditions.
    pub domain: &'a Domain,
    /// The functions of which nothing is known.
    pub functions: &'a BTreeSet<Symbol>,
    /// The direct and the evolution effect, where the file says which variables they are: an equation may speak of one order of
    /// the two only.
    pub effects: Option<[&'a str; 2]>,
}

/// The equations of a file that can be read, in its order, and all faults.
pub(super) fn read(
    file: Vec<EquationText>,
    positive: &[String],
    assumed: &Assumed<'_>,
) -> (Vec<Equation>, Vec<EquationFault>) {
    let mut faults: Vec<EquationFault> = positive.iter().filter_map(|name| not_positive(name)).collect();
    if file.len() > MOST {
        let message = format!("{} equations (allowed: at most {MOST})", file.len());
        faults.push(EquationFault { key: "equation".to_owned(), message });
    }
    let mut equations: Vec<Equation> = Vec::new();
    for entry in file.into_iter().take(MOST) {
        let key = format!("equation {}", entry.number);
        match read_entry(entry, assumed) {
            Ok(equation) if equations.iter().any(|known| known.word() == equation.word()) => {
                faults.push(EquationFault { key, message: "occurs twice".to_owned() });
            }
            Ok(equation) => equations.push(equation),
            Err(message) => faults.push(EquationFault { key, message }),
        }
    }
    (equations, faults)
}

/// Why this cannot be the name of a positive variable.
fn not_positive(name: &str) -> Option<EquationFault> {
    let message = match name {
        "i" | "pm" => format!("'{name}' is no variable: i^2 = -1 and pm^2 = 1"),
        _ if is_name(name) => return None,
        _ => format!("'{name}' is not a name: {NOT_A_NAME}"),
    };
    Some(EquationFault { key: "assumptions.positive".to_owned(), message })
}

/// An equation with other sides.
pub(super) fn read_again(known: &Equation, text: &str, assumed: &Assumed<'_>) -> Result<Equation, String> {
    let (left, right) = read_sides(text, &known.given, assumed)?;
    Ok(Equation { left, right, ..known.clone() })
}

fn read_entry(entry: EquationText, assumed: &Assumed<'_>) -> Result<Equation, String> {
    let number = &entry.number;
    let is_plain = |character: char| character.is_ascii_alphanumeric() || "._-".contains(character);
    if number.is_empty() || number.len() > LONGEST_NUMBER || !number.chars().all(is_plain) {
        return Err(format!("a number has 1 to {LONGEST_NUMBER} characters of A-Z a-z 0-9 . _ -"));
    }
    let given = entry.given.iter().map(|text| read_condition(text, assumed.functions));
    let given = given.collect::<Result<Vec<_>, _>>()?;
    let (left, right) = read_sides(&entry.equation, &given, assumed)?;
    let printed = entry.printed.as_deref().map(|text| read_sides(text, &given, assumed)).transpose();
    let printed = printed.map_err(|error| format!("printed: {error}"))?;
    let role = entry.role.as_deref().map(Role::read).transpose()?;
    Ok(Equation { number: entry.number, left, right, printed, note: entry.note, given, role })
}

fn read_sides(
    text: &str,
    given: &[Condition],
    assumed: &Assumed<'_>,
) -> Result<(Expression, Expression), String> {
    let sides: Vec<&str> = text.split('=').collect();
    let [left, right] = sides[..] else {
        return Err(format!("needs one '=' but has {}: {text}", sides.len() - 1));
    };
    let side = |text: &str, side: &str| {
        let text = text.trim();
        let read = definedness::read(text, given, assumed);
        read.map_err(|error| format!("{side} side '{text}', {error}"))
    };
    Ok((side(left, "left")?, side(right, "right")?))
}
