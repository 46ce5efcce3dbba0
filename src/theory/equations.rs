//! The paper's equations as input data.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use crate::polynomial::{Domain, Expression};

/// Every equation that must be there, with the name that stands alone on its left side, if one does.
const REQUIRED: [(&str, Option<&str>); 28] = [
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
const VARIABLES: [&str; 27] = [
    "a",
    "b",
    "D_c",
    "K",
    "M",
    "sigma",
    "V",
    "V_0",
    "theta",
    "mu_0",
    "mu",
    "t",
    "s",
    "i",
    "pm",
    "delta",
    "Delta_delta",
    "Delta_theta",
    "K_c",
    "K_c_qs",
    "K_c_dyn",
    "sigma_c",
    "V_c",
    "theta_ss",
    "mu_ss",
    "omega_n",
    "eta",
];

/// One equation of the paper.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// Its number in the paper, or a name where the paper gives none.
    pub number: String,
    /// The left side.
    pub left: Expression,
    /// The right side.
    pub right: Expression,
    /// Both sides as the page at hand shows them, where that differs from what is meant.
    pub printed: Option<(Expression, Expression)>,
    /// Why it differs, or what it is.
    pub note: String,
}

impl Equation {
    /// left − right, which the equation says is zero.
    #[must_use]
    pub fn residual(&self) -> Expression {
        self.left.clone() - self.right.clone()
    }

    /// The equation in LaTeX.
    #[must_use]
    pub fn latex(&self) -> String {
        format!("{} = {}", self.left.latex(), self.right.latex())
    }
}

impl fmt::Display for Equation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} = {}", self.left, self.right)
    }
}

/// What is wrong with one equation of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EquationFault {
    /// The key at fault, such as `equation 16` (empty when the file as a whole is at fault).
    pub key: String,
    /// What is wrong with it.
    pub message: String,
}

/// All faults of a file of equations at once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EquationsError {
    /// At least one.
    pub faults: Vec<EquationFault>,
}

impl fmt::Display for EquationsError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, EquationFault { key, message }) in self.faults.iter().enumerate() {
            let separator = if index > 0 { "\n" } else { "" };
            let colon = if key.is_empty() { "" } else { ": " };
            write!(formatter, "{separator}{key}{colon}{}", message.trim_end())?;
        }
        Ok(())
    }
}

impl std::error::Error for EquationsError {}

/// The equations of the paper, complete: each required one is there once, in known variables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PaperEquations {
    equations: BTreeMap<String, Equation>,
    positive: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    assumptions: Assumptions,
    #[serde(default)]
    equation: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Assumptions {
    positive: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    number: String,
    equation: String,
    printed: Option<String>,
    #[serde(default)]
    note: String,
}

impl PaperEquations {
    /// Reads a file of equations (TOML text).
    ///
    /// # Errors
    /// All faults at once: TOML that does not parse, unknown keys, missing, repeated or unknown numbers, text outside
    /// the grammar, unknown variables, a left side that should be one name and is not.
    pub fn parse(text: &str) -> Result<Self, EquationsError> {
        let file: File = toml::from_str(text).map_err(|error| EquationsError {
            faults: vec![EquationFault { key: String::new(), message: error.to_string() }],
        })?;
        let mut faults = assumption_faults(&file.assumptions);
        let mut equations = BTreeMap::new();
        for entry in file.equation {
            let key = format!("equation {}", entry.number);
            match read_entry(entry) {
                Ok(equation) if equations.contains_key(&equation.number) => {
                    faults.push(EquationFault { key, message: "stands twice".to_owned() });
                }
                Ok(equation) => {
                    equations.insert(equation.number.clone(), equation);
                }
                Err(message) => faults.push(EquationFault { key, message }),
            }
        }
        faults.extend(missing(&equations, &faults));
        if faults.is_empty() {
            Ok(Self { equations, positive: file.assumptions.positive })
        } else {
            Err(EquationsError { faults })
        }
    }

    /// The equation of this number.
    ///
    /// # Panics
    /// For a number that is not required of every file of equations.
    #[must_use]
    pub fn equation(&self, number: &str) -> &Equation {
        &self.equations[number]
    }

    /// All equations: the numbered ones in order, then the named ones.
    pub fn iter(&self) -> impl Iterator<Item = &Equation> {
        REQUIRED.iter().map(|(number, _)| self.equation(number))
    }

    /// The right side of the equation of this number.
    pub(super) fn right(&self, number: &str) -> Expression {
        self.equation(number).right.clone()
    }

    /// left − right of the equation of this number.
    pub(super) fn residual(&self, number: &str) -> Expression {
        self.equation(number).residual()
    }

    /// What the file assumes of the variables.
    #[must_use]
    pub fn domain(&self) -> Domain {
        Domain::positive(&self.positive.join(" "))
    }

    /// The same equations with one of them replaced: what a sabotaged claim is tested with.
    ///
    /// # Errors
    /// As [`PaperEquations::parse`], and for a number that is not there.
    pub fn altered(&self, number: &str, text: &str) -> Result<Self, EquationsError> {
        let fault = |message| EquationsError {
            faults: vec![EquationFault { key: format!("equation {number}"), message }],
        };
        let known =
            self.equations.get(number).ok_or_else(|| fault("there is no such equation".to_owned()))?;
        let entry = Entry {
            number: number.to_owned(),
            equation: text.to_owned(),
            printed: None,
            note: String::new(),
        };
        let mut changed = read_entry(entry).map_err(fault)?;
        changed.printed.clone_from(&known.printed);
        let mut altered = self.clone();
        altered.equations.insert(number.to_owned(), changed);
        Ok(altered)
    }
}

/// The assumptions that every derivation makes must be among those of the file.
fn assumption_faults(assumptions: &Assumptions) -> Vec<EquationFault> {
    let fault = |message| EquationFault { key: "assumptions.positive".to_owned(), message };
    let known = |name: &&String| !VARIABLES.contains(&name.as_str());
    let unknown = assumptions
        .positive
        .iter()
        .filter(known)
        .map(|name| format!("'{name}' is not a variable of the paper"));
    let needed = ["a", "b", "D_c", "K", "M", "sigma", "V", "V_0", "theta", "mu_0"];
    let absent = needed.iter().filter(|name| !assumptions.positive.iter().any(|known| known == *name));
    unknown.chain(absent.map(|name| format!("'{name}' must be positive"))).map(fault).collect()
}

fn read_entry(entry: Entry) -> Result<Equation, String> {
    let Some((_, name)) = REQUIRED.iter().find(|(number, _)| *number == entry.number) else {
        return Err("is not an equation of the paper (1 to 23, or one of its named ones)".to_owned());
    };
    let (left, right) = read_sides(&entry.equation)?;
    if let Some(name) = name.filter(|name| left != Expression::variable(name)) {
        return Err(format!("the left side must be {name}, not {left}"));
    }
    let printed =
        entry.printed.as_deref().map(read_sides).transpose().map_err(|error| format!("printed: {error}"))?;
    Ok(Equation { number: entry.number, left, right, printed, note: entry.note })
}

fn read_sides(text: &str) -> Result<(Expression, Expression), String> {
    let sides: Vec<&str> = text.split('=').collect();
    let [left, right] = sides[..] else {
        return Err(format!("needs one '=' but has {}: {text}", sides.len() - 1));
    };
    Ok((read_side(left, "left")?, read_side(right, "right")?))
}

fn read_side(text: &str, side: &str) -> Result<Expression, String> {
    let expression: Expression =
        text.trim().parse().map_err(|error| format!("{side} side '{}', {error}", text.trim()))?;
    match expression.variables().iter().find(|name| !VARIABLES.contains(&name.base())) {
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

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    const FILE: &str = include_str!("../../reports/im-avouac/equations.toml");

    pub(in crate::theory) fn paper() -> PaperEquations {
        PaperEquations::parse(FILE).expect("the report's own equations")
    }

    #[test]
    fn all_equations_of_the_paper_are_read() {
        assert_eq!(paper().iter().count(), REQUIRED.len());
        assert!(paper().equation("7").printed.is_some());
    }

    #[test]
    fn all_faults_are_told_at_once() {
        let text = FILE
            .replace("number = \"3\"", "number = \"2\"")
            .replace("a/V_0*s^2 + (K/", "a/V_0*s^2 + (Q/")
            .replace("number = \"16\"", "number = \"61\"")
            .replace("sigma_c = K*D_c", "sigma = K*D_c")
            .replace("omega_n = sqrt(K/M)", "omega_n = sqrt(K/M");
        let error = PaperEquations::parse(&text).expect_err("five faults").to_string();
        for part in [
            "equation 2: stands twice",
            "equation 3: is missing",
            "equation 14: left side: 'Q' is not a variable of the paper",
            "equation 61: is not an equation of the paper",
            "equation 12: the left side must be sigma_c, not sigma",
            "equation natural-frequency: right side 'sqrt(K/M', column 9: expected ')'",
        ] {
            assert!(error.contains(part), "{part} is not in:\n{error}");
        }
    }

    #[test]
    fn unknown_keys_are_refused() {
        let error =
            PaperEquations::parse(&FILE.replace("note =", "nota =")).expect_err("unknown key").to_string();
        assert!(error.contains("nota"), "{error}");
    }
}
