//! What the variables of a file are: procedures find them by these words, whatever their names.

use std::collections::{BTreeMap, BTreeSet};

use crate::notation::did_you_mean;
use crate::{AssumptionsText, Equation, EquationFault};

use slipmode_algebra::{Expression, Symbol};

/// What a variable is, with the symbol that stands for it in procedures.
pub const QUANTITIES: [(&str, &str); 23] = [
    ("direct_effect", "a"),
    ("evolution_effect", "b"),
    ("critical_slip_distance", "D_c"),
    ("stiffness", "K"),
    ("mass_per_area", "M"),
    ("normal_stress", "sigma"),
    ("velocity", "V"),
    ("loading_velocity", "V_0"),
    ("state", "theta"),
    ("reference_friction", "mu_0"),
    ("friction", "mu"),
    ("time", "t"),
    ("slip", "delta"),
    ("growth_rate", "s"),
    ("critical_stiffness", "K_c"),
    ("quasi_static_critical_stiffness", "K_c_qs"),
    ("inertial_critical_stiffness", "K_c_dyn"),
    ("critical_normal_stress", "sigma_c"),
    ("critical_velocity", "V_c"),
    ("steady_state", "theta_ss"),
    ("steady_friction", "mu_ss"),
    ("natural_angular_frequency", "omega_n"),
    ("inertial_parameter", "eta"),
];

/// How many of them, from the first, procedures take as positive.
const POSITIVE: usize = 10;

/// The variables of a file by what they are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Quantities {
    /// The symbol that stands in procedures for a variable of the file.
    symbols: BTreeMap<String, &'static str>,
}

impl Quantities {
    /// Reads which variable is what, and all faults.
    pub fn read(
        stated: &BTreeMap<String, String>,
        assumptions: &AssumptionsText,
    ) -> (Self, Vec<EquationFault>) {
        let mut faults = Vec::new();
        let mut symbols = BTreeMap::new();
        for (word, name) in stated {
            let mut fault =
                |message| faults.push(EquationFault { key: format!("quantities.{word}"), message });
            let Some(at) = QUANTITIES.iter().position(|(known, _)| known == word) else {
                let all = QUANTITIES.map(|(word, _)| word);
                let near = did_you_mean(word, all);
                fault(format!("no quantity of a procedure{near} (allowed: {})", all.join(", ")));
                continue;
            };
            if at < POSITIVE && !assumptions.positive.contains(name) {
                fault(format!("'{name}' must be positive: procedures take it so"));
            }
            if symbols.insert(name.clone(), QUANTITIES[at].1).is_some() {
                fault(format!("'{name}' is another quantity, too"));
            }
        }
        (Self { symbols }, faults)
    }

    /// Every variable has its symbol as its name.
    pub fn of_symbols() -> Self {
        Self { symbols: QUANTITIES.map(|(_, symbol)| (symbol.to_owned(), symbol)).into() }
    }

    /// The variable of the file that is this symbol.
    fn name(&self, symbol: &str) -> Option<&str> {
        self.symbols.iter().find(|(_, known)| **known == symbol).map(|(name, _)| name.as_str())
    }

    /// The variables that are the direct and the evolution effect.
    pub fn effects(&self) -> Option<[&str; 2]> {
        Some([self.name("a")?, self.name("b")?])
    }

    /// An equation with the variables in the symbols of the procedures. A variable that is none of them and has the name of one gets
    /// another name.
    pub fn in_symbols(&self, equation: &Equation) -> Equation {
        let renamed = |side: &Expression| {
            let values = side.variables().into_iter().filter_map(|name| {
                let symbol = self.symbol(&name)?;
                Some((name, Expression::Variable(symbol)))
            });
            side.substitute(&values.collect())
        };
        Equation { left: renamed(&equation.left), right: renamed(&equation.right), ..equation.clone() }
    }

    /// A variable of an equation that is no quantity.
    fn foreign(&self, equation: &Equation) -> Option<Symbol> {
        let mut variables = equation.left.variables().into_iter().chain(equation.right.variables());
        variables.find(|name| !self.symbols.contains_key(name.base()) && !["i", "pm"].contains(&name.base()))
    }

    fn symbol(&self, name: &Symbol) -> Option<Symbol> {
        let is_taken = || QUANTITIES.iter().any(|(_, symbol)| *symbol == name.base());
        let written = match self.symbols.get(name.base()) {
            Some(symbol) => format!("{symbol}{}", "'".repeat(name.derivative_order())),
            None if is_taken() => format!("own_{name}"),
            None => name.to_string(),
        };
        written.parse().ok()
    }
}

/// What is wrong with the roles of the equations: two equations with one role, another left side, variables without a meaning.
pub(super) fn faults(equations: &[&Equation], quantities: &Quantities) -> Vec<EquationFault> {
    let mut seen = BTreeSet::new();
    let mut faults = Vec::new();
    for equation in equations {
        let Some(role) = equation.role else { continue };
        let mut fault =
            |message| faults.push(EquationFault { key: format!("equation {}", equation.number), message });
        if !seen.insert(role) {
            fault(format!("another equation has the role `{}`, too", role.as_str()));
        }
        if let Some(foreign) = quantities.foreign(equation) {
            fault(format!(
                "'{foreign}' is none of the `quantities`: an equation with a role has no other variables"
            ));
        }
        let in_symbols = quantities.in_symbols(equation);
        if let Some(left) = role.left()
            && !matches!(&in_symbols.left, Expression::Variable(name) if name.as_str() == left)
        {
            let name = quantities.name(left.trim_end_matches('\''));
            let wanted = name.map_or_else(
                || format!("the variable that `quantities` calls {}", word_of(left)),
                |name| left.replace(left.trim_end_matches('\''), name),
            );
            fault(format!(
                "the left side of the equation with the role `{}` must be {wanted}, not {}",
                role.as_str(),
                equation.left
            ));
        }
    }
    faults
}

/// What a symbol is.
fn word_of(symbol: &str) -> &'static str {
    let base = symbol.trim_end_matches('\'');
    QUANTITIES.iter().find(|(_, known)| *known == base).map_or("", |(word, _)| word)
}
