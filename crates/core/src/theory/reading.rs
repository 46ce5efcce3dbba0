//! Reading a file of equations: all faults at once.

use super::{Equation, EquationFault, definedness};
use crate::polynomial::Expression;

/// The most equations of a file: each costs a proof that it has a value.
const MOST: usize = 500;

/// The longest number or name of an equation: it is part of a page's links.
const LONGEST_NUMBER: usize = 40;

/// The equations of a paper as text, as a file states them.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct EquationsText {
    /// What is assumed of the variables.
    pub assumptions: AssumptionsText,
    /// The equations in any order.
    #[cfg_attr(feature = "serde", serde(default))]
    pub equation: Vec<EquationText>,
}

/// What the equations assume of their variables.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct AssumptionsText {
    /// Names of the variables that are positive.
    pub positive: Vec<String>,
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
}

/// The equations of a file that can be read, in its order, and all faults.
pub(super) fn read(file: Vec<EquationText>, positive: &[String]) -> (Vec<Equation>, Vec<EquationFault>) {
    let mut faults: Vec<EquationFault> = positive.iter().filter_map(|name| not_positive(name)).collect();
    if file.len() > MOST {
        let message = format!("{} equations (allowed: at most {MOST})", file.len());
        faults.push(EquationFault { key: "equation".to_owned(), message });
    }
    let mut equations: Vec<Equation> = Vec::new();
    for entry in file.into_iter().take(MOST) {
        let key = format!("equation {}", entry.number);
        match read_entry(entry, positive) {
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
    let is_name = matches!(name.parse(), Ok(Expression::Variable(read)) if read.derivative_order() == 0);
    let message = match name {
        "i" | "pm" => format!("'{name}' is no variable: i^2 = -1 and pm^2 = 1"),
        _ if is_name => return None,
        _ => format!("'{name}' is not a name (a letter, then letters, digits and _)"),
    };
    Some(EquationFault { key: "assumptions.positive".to_owned(), message })
}

/// One equation of this number from its text.
pub(super) fn read_equation(number: &str, text: &str, positive: &[String]) -> Result<Equation, String> {
    let entry = EquationText {
        number: number.to_owned(),
        equation: text.to_owned(),
        printed: None,
        note: String::new(),
    };
    read_entry(entry, positive)
}

fn read_entry(entry: EquationText, positive: &[String]) -> Result<Equation, String> {
    let number = &entry.number;
    let is_plain = |character: char| character.is_ascii_alphanumeric() || "._-".contains(character);
    if number.is_empty() || number.len() > LONGEST_NUMBER || !number.chars().all(is_plain) {
        return Err(format!("a number has 1 to {LONGEST_NUMBER} characters of A-Z a-z 0-9 . _ -"));
    }
    let (left, right) = read_sides(&entry.equation, positive)?;
    let printed = entry.printed.as_deref().map(|text| read_sides(text, positive)).transpose();
    let printed = printed.map_err(|error| format!("printed: {error}"))?;
    Ok(Equation { number: entry.number, left, right, printed, note: entry.note })
}

fn read_sides(text: &str, positive: &[String]) -> Result<(Expression, Expression), String> {
    let sides: Vec<&str> = text.split('=').collect();
    let [left, right] = sides[..] else {
        return Err(format!("needs one '=' but has {}: {text}", sides.len() - 1));
    };
    Ok((read_side(left, "left", positive)?, read_side(right, "right", positive)?))
}

fn read_side(text: &str, side: &str, positive: &[String]) -> Result<Expression, String> {
    let text = text.trim();
    definedness::read(text, positive).map_err(|error| format!("{side} side '{text}', {error}"))
}
