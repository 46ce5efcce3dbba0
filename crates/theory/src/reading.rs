//! Reading a file of equations: all faults at once.

use crate::definedness::{self, Assumed};
use crate::derivation::{NOT_A_NAME, is_name, read_condition};
use crate::{Equation, EquationFault, EquationText, Role};
use slipmode_algebra::{Condition, Expression};

/// The most equations of a file: each costs a proof that it has a value.
const MOST: usize = 500;

/// The longest number or name of an equation: it is part of a page's links.
const LONGEST_NUMBER: usize = 40;

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
