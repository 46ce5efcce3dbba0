//! Reading a file of equations: all faults at once.

use std::collections::BTreeMap;

use super::{Equation, EquationFault, EquationsError, definedness};
use crate::polynomial::Expression;

/// Every equation that must be there, with the name that stands alone on its left side, if one does.
pub(super) const REQUIRED: [(&str, Option<&str>); 28] = [
    ("1", Some("mu")),
    ("2", Some("theta'")),
    ("3", Some("theta'")),
    ("4", None),
    ("5", None),
    ("6", None),
    ("7", None),
    ("8", None),
    ("9", Some("K_c")),
    ("10", Some("K_c_qs")),
    ("11", Some("K_c_dyn")),
    ("12", Some("sigma_c")),
    ("13", Some("V_c")),
    ("14", None),
    ("15", Some("sigma")),
    ("16", Some("sigma")),
    ("17", None),
    ("18", None),
    ("19", None),
    ("20", None),
    ("21", None),
    ("22", None),
    ("23", Some("s")),
    ("steady-state", Some("theta_ss")),
    ("steady-friction", Some("mu_ss")),
    ("natural-frequency", Some("omega_n")),
    ("inertial-parameter", Some("eta")),
    ("regularised", Some("mu")),
];

/// The variables that may occur, without primes.
const VARIABLES: &str = "a b D_c K M sigma V V_0 theta mu_0 mu t s i pm delta Delta_delta Delta_theta \
                         K_c K_c_qs K_c_dyn sigma_c V_c theta_ss mu_ss omega_n eta";

fn is_variable(name: &str) -> bool {
    VARIABLES.split(' ').any(|known| known == name)
}

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

/// Equations by number.
pub(super) type Equations = BTreeMap<String, Equation>;

/// The equations and the positive variables of a file.
pub(super) fn read(file: EquationsText) -> Result<(Equations, Vec<String>), EquationsError> {
    let mut faults = assumption_faults(&file.assumptions);
    let mut equations = BTreeMap::new();
    for entry in file.equation {
        let key = format!("equation {}", entry.number);
        match read_entry(entry, &file.assumptions.positive) {
            Ok(equation) if equations.contains_key(&equation.number) => {
                faults.push(EquationFault { key, message: "occurs twice".to_owned() });
            }
            Ok(equation) => {
                equations.insert(equation.number.clone(), equation);
            }
            Err(message) => faults.push(EquationFault { key, message }),
        }
    }
    faults.extend(missing(&equations, &faults));
    if faults.is_empty() {
        Ok((equations, file.assumptions.positive))
    } else {
        Err(EquationsError { faults })
    }
}

/// The assumptions that every derivation makes must be among those of the file.
fn assumption_faults(assumptions: &AssumptionsText) -> Vec<EquationFault> {
    let fault = |message| EquationFault { key: "assumptions.positive".to_owned(), message };
    let unknown = |name: &&String| !is_variable(name);
    let unknown = assumptions
        .positive
        .iter()
        .filter(unknown)
        .map(|name| format!("'{name}' is not a variable of the paper"));
    let needed = ["a", "b", "D_c", "K", "M", "sigma", "V", "V_0", "theta", "mu_0"];
    let absent = needed.iter().filter(|name| !assumptions.positive.iter().any(|known| known == *name));
    unknown.chain(absent.map(|name| format!("'{name}' must be positive"))).map(fault).collect()
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
    let Some((_, name)) = REQUIRED.iter().find(|(number, _)| *number == entry.number) else {
        return Err("is not an equation of the paper (1 to 23, or one of its named ones)".to_owned());
    };
    let (left, right) = read_sides(&entry.equation, positive)?;
    if let Some(name) = name.filter(|name| left != Expression::variable(name)) {
        return Err(format!("the left side must be {name}, not {left}"));
    }
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
    let expression =
        definedness::read(text, positive).map_err(|error| format!("{side} side '{text}', {error}"))?;
    match expression.variables().iter().find(|name| !is_variable(name.base())) {
        Some(name) => Err(format!("{side} side: '{name}' is not a variable of the paper")),
        None => Ok(expression),
    }
}

fn missing(equations: &BTreeMap<String, Equation>, faults: &[EquationFault]) -> Vec<EquationFault> {
    let keys = REQUIRED
        .iter()
        .filter(|(number, _)| !equations.contains_key(*number))
        .map(|(number, _)| format!("equation {number}"));
    keys.filter(|key| !faults.iter().any(|fault| fault.key == *key))
        .map(|key| EquationFault { key, message: "is missing".to_owned() })
        .collect()
}
