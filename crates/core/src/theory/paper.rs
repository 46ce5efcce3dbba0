//! What the derivations of the first paper ask of a file of equations.
//!
//! Any file may state any equations. A procedure of this program, and a proof of the report on Im and Avouac, need all
//! equations of that paper, in its variables.

use super::{Equation, EquationFault, Equations, EquationsError};
use slipmode_algebra::Expression;

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

/// The variables that its equations may contain, without primes.
const VARIABLES: &str = "a b D_c K M sigma V V_0 theta mu_0 mu t s i pm delta Delta_delta Delta_theta \
                         K_c K_c_qs K_c_dyn sigma_c V_c theta_ss mu_ss omega_n eta";

/// The quantities that every derivation takes as positive.
const POSITIVE: &str = "a b D_c K M sigma V V_0 theta mu_0";

fn is_variable(name: &str) -> bool {
    VARIABLES.split(' ').any(|known| known == name)
}

impl Equations {
    /// Whether the derivations of the paper can start from these equations.
    ///
    /// # Errors
    /// All faults at once: missing equations, a left side that should be one name and is not, other variables, quantities that are
    /// not assumed to be positive. Where something is missing, what has an unknown number or name is named too: it may be meant.
    pub fn demand_paper(&self) -> Result<(), EquationsError> {
        let fault = |key: String, message: String| EquationFault { key, message };
        let of_positive = |message| fault("assumptions.positive".to_owned(), message);
        let is_listed = |name: &&str| self.positive().iter().any(|known| known == name);
        let mut faults = Vec::new();
        if !POSITIVE.split(' ').all(|name| is_listed(&name)) {
            let unknown = self.positive().iter().filter(|name| !is_variable(name));
            faults
                .extend(unknown.map(|name| of_positive(format!("'{name}' is not a variable of the paper"))));
            let absent = POSITIVE.split(' ').filter(|name| !is_listed(name));
            faults.extend(absent.map(|name| of_positive(format!("'{name}' must be positive"))));
        }
        let found = |number: &str| self.iter().find(|equation| equation.number == number);
        let key = |number: &str| format!("equation {number}");
        let mut missing: Vec<EquationFault> = Vec::new();
        for (number, name) in REQUIRED {
            match found(number) {
                None => missing.push(fault(key(number), "is missing".to_owned())),
                Some(equation) => {
                    faults.extend(strange(equation, name).map(|message| fault(key(number), message)))
                }
            }
        }
        if !missing.is_empty() {
            let is_known =
                |equation: &&Equation| REQUIRED.iter().any(|(number, _)| *number == equation.number);
            let message = "is not an equation of the paper (1 to 23, or one of its named ones)";
            let unknown = self.iter().filter(|equation| !is_known(equation));
            faults.extend(unknown.map(|equation| fault(key(&equation.number), message.to_owned())));
            faults.extend(missing);
        }
        if faults.is_empty() { Ok(()) } else { Err(EquationsError { faults }) }
    }
}

/// What is wrong with an equation of the paper as the derivations read it.
fn strange(equation: &Equation, name: Option<&str>) -> Option<String> {
    let foreign = |(side, expression): (&str, &Expression)| {
        let variables = expression.variables();
        let name = variables.iter().find(|name| !is_variable(name.base()))?;
        Some(format!("{side} side: '{name}' is not a variable of the paper"))
    };
    let left = &equation.left;
    let foreign = [("left", left), ("right", &equation.right)].into_iter().find_map(foreign);
    let is_left = |name: &&str| matches!(left, Expression::Variable(symbol) if symbol.as_str() == *name);
    let other = name.filter(|name| !is_left(name));
    foreign.or_else(|| other.map(|name| format!("the left side must be {name}, not {left}")))
}
