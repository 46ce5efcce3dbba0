//! A paper's equations as input data.

use std::fmt;
use std::sync::{Arc, LazyLock};

use crate::definedness::Assumed;
use crate::definitions::{self, Rest};
use crate::names::Names;
use crate::notation::{formula, in_groups};
use crate::quantities::{self, Quantities};
use crate::reading;
use crate::stated_proofs::StatedProofs;
use crate::{DefinitionText, Equation, EquationFault, EquationsText, FunctionText, Role, SystemText};
use slipmode_algebra::{Domain, Expression, within_budget};

/// The most steps of algebra that the reading of one file takes.
const STEPS: u64 = 6_000_000;

/// All faults of a file of equations at once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EquationsError {
    /// At least one.
    pub faults: Vec<EquationFault>,
}

impl fmt::Display for EquationsError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let faults: Vec<String> = self.faults.iter().map(ToString::to_string).collect();
        formatter.write_str(&faults.join("\n"))
    }
}

impl std::error::Error for EquationsError {}

/// The equations of a paper, in the order of the file: any numbers, any variables.
///
/// The procedures of this module find an equation by its [`Role`], and take the variables in their own symbols
/// ([`Equations::in_symbols`]).
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Equations {
    equations: Vec<Equation>,
    rest: Rest,
    domain: Domain,
    names: Arc<Names>,
    proofs: Arc<StatedProofs>,
    quantities: Quantities,
}

/// What stands for an equation that is not there: it has no value, so that every step of a proof with it is refused.
static MISSING: LazyLock<Equation> = LazyLock::new(|| {
    let [left, right] = ["0/0"; 2].map(formula);
    let (number, note) = (String::new(), "the equation is missing".to_owned());
    Equation { number, left, right, printed: None, note, given: Vec::new(), role: None }
});

impl Equations {
    /// Reads the equations of a paper from their texts.
    ///
    /// # Errors
    /// All faults at once: repeated numbers, text outside the grammar, sides without a value.
    pub fn read(text: EquationsText) -> Result<Self, EquationsError> {
        let (equations, faults) = Self::read_partly(text);
        if faults.is_empty() { Ok(equations) } else { Err(EquationsError { faults }) }
    }

    /// The equations that can be read, and all faults.
    #[must_use]
    pub fn read_partly(text: EquationsText) -> (Self, Vec<EquationFault>) {
        let assumptions = text.assumptions.clone();
        within_budget(STEPS, || Self::read_all(text)).unwrap_or_else(|exhausted| {
            let rest = Rest { assumptions, ..Rest::default() };
            let domain = definitions::positive(&rest.assumptions);
            let nothing = Self { rest, domain, ..Self::default() };
            (nothing, vec![EquationFault { key: "equations".to_owned(), message: exhausted.to_string() }])
        })
    }

    fn read_all(text: EquationsText) -> (Self, Vec<EquationFault>) {
        let EquationsText { assumptions, equation, function, system, units, definition, quantities } = text;
        let mut faults = Vec::new();
        let functions = definitions::functions(&function);
        let domain = definitions::assumed(&assumptions, &functions).unwrap_or_else(|fault| {
            faults.push(fault);
            definitions::positive(&assumptions)
        });
        let (quantities, of_quantities) = Quantities::read(&quantities, &assumptions);
        let assumed = Assumed { domain: &domain, functions: &functions, effects: quantities.effects() };
        let (equations, of_equations) = reading::read(equation, &assumptions.positive, &assumed);
        // Without the quantities every variable would be told to be none of them.
        let of_roles = match of_quantities.is_empty() {
            true => quantities::faults(&equations.iter().collect::<Vec<_>>(), &quantities),
            false => of_quantities,
        };
        faults.extend(of_roles);
        let rest = Rest { assumptions, functions: function, systems: system, definitions: definition, units };
        let (names, of_names) = definitions::names(&rest, &equations, &domain);
        faults.extend(of_equations.into_iter().chain(of_names));
        let (names, proofs) = (Arc::new(names), Arc::default());
        (Self { equations, rest, domain, names, proofs, quantities }, faults)
    }

    /// What the names of the file mean.
    #[must_use]
    pub fn names(&self) -> &Arc<Names> {
        &self.names
    }

    /// The proofs about them that the report states.
    #[must_use]
    pub fn proofs(&self) -> &Arc<StatedProofs> {
        &self.proofs
    }

    /// With the proofs of the report.
    #[must_use]
    pub fn with_proofs(self, proofs: Arc<StatedProofs>) -> Self {
        Self { proofs, ..self }
    }

    /// The same file with other equations, and without systems and definitions.
    pub(super) fn with_equations(&self, equations: Vec<Equation>) -> Self {
        let (assumptions, functions) = (self.rest.assumptions.clone(), self.rest.functions.clone());
        let rest = Rest { assumptions, functions, ..Rest::default() };
        let (names, _) = definitions::names(&rest, &equations, &self.domain);
        Self { equations, rest, names: Arc::new(names), ..self.clone() }
    }

    /// The equations alone, with the variables in the symbols of the procedures.
    #[must_use]
    pub fn in_symbols(&self) -> Self {
        let equations = self.equations.iter().map(|equation| self.quantities.in_symbols(equation)).collect();
        let quantities = Quantities::of_symbols();
        Self { equations, proofs: self.proofs.clone(), quantities, ..Self::default() }
    }

    /// The unit of a variable as stated.
    pub(super) fn unit(&self, name: &str) -> Option<&str> {
        self.rest.units.get(name).map(String::as_str)
    }

    /// The conditions for everything in the file, as written.
    #[must_use]
    pub fn conditions(&self) -> &[String] {
        &self.rest.assumptions.conditions
    }

    /// The equation of this number. One that is not there has no value: no step of a proof with it succeeds.
    #[must_use]
    pub fn equation(&self, number: &str) -> &Equation {
        self.iter().find(|equation| equation.number == number).unwrap_or_else(|| &MISSING)
    }

    /// Whether there is an equation of this number.
    #[must_use]
    pub fn has(&self, number: &str) -> bool {
        self.iter().any(|equation| equation.number == number)
    }

    /// All equations, in the order of the file.
    pub fn iter(&self) -> impl Iterator<Item = &Equation> {
        self.equations.iter()
    }

    /// The variables that are assumed to be positive.
    #[must_use]
    pub fn positive(&self) -> &[String] {
        &self.rest.assumptions.positive
    }

    /// The variables of either sign.
    #[must_use]
    pub fn free(&self) -> &[String] {
        &self.rest.assumptions.free
    }

    /// The definitions as they are written.
    #[must_use]
    pub fn definitions(&self) -> &[DefinitionText] {
        &self.rest.definitions
    }

    /// The functions as they are declared.
    #[must_use]
    pub fn functions(&self) -> &[FunctionText] {
        &self.rest.functions
    }

    /// The systems as they are written.
    #[must_use]
    pub fn systems(&self) -> &[SystemText] {
        &self.rest.systems
    }

    /// The equation with this role. One that is not there has no value: no step of a proof with it succeeds.
    #[must_use]
    pub fn with_role(&self, role: Role) -> &Equation {
        self.iter().find(|equation| equation.role == Some(role)).unwrap_or_else(|| &MISSING)
    }

    /// What is missing for a procedure that needs equations with these roles: a sentence for each.
    #[must_use]
    pub fn missing(&self, roles: &[Role]) -> Vec<String> {
        let with_role = |role: &Role| self.iter().filter(|one| one.role == Some(*role)).collect::<Vec<_>>();
        let missing = roles.iter().flat_map(|role| match &with_role(role)[..] {
            [] => vec![format!("no equation has the role `{role}`")],
            some => quantities::faults(some, &self.quantities).iter().map(ToString::to_string).collect(),
        });
        missing.collect()
    }

    /// The right side of the equation with this role.
    pub(super) fn right(&self, role: Role) -> Expression {
        self.with_role(role).right.clone()
    }

    /// left − right of the equation with this role.
    pub(super) fn residual(&self, role: Role) -> Expression {
        self.with_role(role).residual()
    }

    /// Eq 8 in groups: F(p) = η p³ + (1 + η) p² + (κ + 1 − β) p + κ when eq 8 is right.
    pub(super) fn cubic(&self) -> Expression {
        in_groups(&self.residual(Role::Characteristic))
    }

    /// The numbers of the equations with these roles.
    pub(super) fn numbers<const COUNT: usize>(&self, roles: [Role; COUNT]) -> [&str; COUNT] {
        roles.map(|role| self.with_role(role).number.as_str())
    }

    /// The same equations with one of them replaced: what a sabotaged claim is tested with.
    ///
    /// # Errors
    /// As [`Equations::read`], and for a number that is not there.
    pub fn altered(&self, number: &str, text: &str) -> Result<Self, EquationsError> {
        let fault = |message| EquationsError {
            faults: vec![EquationFault { key: format!("equation {number}"), message }],
        };
        let mut altered = self.clone();
        let known = altered.equations.iter_mut().find(|equation| equation.number == number);
        let known = known.ok_or_else(|| fault("there is no such equation".to_owned()))?;
        let (functions, effects) = (&self.names.functions, self.quantities.effects());
        let assumed = Assumed { domain: &self.domain, functions, effects };
        *known = reading::read_again(known, text, &assumed).map_err(fault)?;
        let (names, faults) = definitions::names(&self.rest, &altered.equations, &self.domain);
        if !faults.is_empty() {
            return Err(EquationsError { faults });
        }
        altered.names = Arc::new(names);
        Ok(altered)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    const FILE: &str = include_str!("im-avouac.toml");

    fn read(text: &str) -> Result<Equations, EquationsError> {
        Equations::read(toml::from_str(text).expect("TOML with known keys"))
    }

    pub(crate) fn paper() -> Equations {
        read(FILE).expect("the report's own equations")
    }

    #[test]
    fn all_equations_of_the_paper_are_read() {
        assert_eq!(paper().iter().count(), 28);
        assert!(paper().equation("7").printed.is_some());
    }

    #[test]
    fn any_numbers_and_names_are_read_and_a_missing_equation_has_no_value() {
        let text = "[assumptions]\npositive = [\"A\", \"L\"]\n[[equation]]\nnumber = \"3.1\"\nequation = \"Q = A/L\"\n";
        let equations = read(text).expect("another paper's equation");
        assert_eq!(equations.equation("3.1").to_string(), "Q = A/L");
        let library = crate::stated_proofs::tests::library();
        let refused = library.prove("stability-transition", &equations).expect_err("eq 8 is missing");
        assert!(refused.remainder.ends_with("there is no equation for the name `residual_8`"), "{refused}");
        let missing = library.missing("stability-transition", &equations);
        assert!(
            missing.contains(&"there is no equation for the name `residual_8`".to_owned()),
            "{missing:?}"
        );
    }

    #[test]
    fn procedures_find_the_equations_by_their_roles_under_any_names() {
        let swapped = FILE.replace("direct_effect = \"a\"", "direct_effect = \"b\"");
        let swapped = swapped.replace("evolution_effect = \"b\"", "evolution_effect = \"a\"");
        let equations = read(&swapped).expect("the same equations with other meanings");
        let friction = equations.in_symbols().right(Role::Friction).to_string();
        assert_eq!(friction, "mu_0 + b*ln(V/V_0) + a*ln(V_0*theta/D_c)");
        assert_eq!(equations.missing(&Role::ALL), [""; 0]);
        assert_eq!(
            equations.only(&["1"]).missing(&[Role::Friction, Role::Motion]),
            ["no equation has the role `motion`"]
        );
        // `a` is no quantity here, but the name of one.
        let other = "[assumptions]\npositive = [\"A\", \"a\"]\n[quantities]\ndirect_effect = \"A\"\n[[equation]]\nnumber = \"1\"\nequation = \"f = A/a\"\n";
        assert_eq!(read(other).expect("another paper").in_symbols().equation("1").to_string(), "f = a/own_a");
    }

    #[test]
    fn all_faults_are_told_at_once() {
        let text = FILE
            .replace("number = \"3\"", "number = \"2\"")
            .replace("a/V_0*s^2 + (K/", "a/V_0*s^2 + (Q/")
            .replace(
                "number = \"20\"\nrole = \"inertial-lower\"",
                "number = \"61\"\nrole = \"inertial-lower\"",
            )
            .replace("role = \"quasi-static-lower\"", "role = \"inertial-lower\"")
            .replace("role = \"inertial-upper\"", "role = \"inertial-uper\"")
            .replace("sigma_c = K*D_c", "sigma = K*D_c")
            .replace("omega_n = sqrt(K/M)", "omega_n = sqrt(K/M");
        let (_, faults) = Equations::read_partly(toml::from_str(&text).expect("TOML"));
        let error = EquationsError { faults }.to_string();
        for part in [
            "equation 2: occurs twice",
            "equation 14: 'Q' is none of the `quantities`",
            "equation 12: the left side of the equation with the role `critical-normal-stress` must be sigma_c, not sigma",
            "equation 61: another equation has the role `inertial-lower`, too",
            "equation 18: 'inertial-uper' is no role; did you mean `inertial-upper`?",
            "equation natural-frequency: right side 'sqrt(K/M', column 9: expected ')'",
        ] {
            assert!(error.contains(part), "{part} is not in:\n{error}");
        }
        let text = FILE.replace("stiffness = \"K\"\nmass_per_area", "stiffness = \"k\"\nmas_per_area");
        let error = read(&text).expect_err("two faults").to_string();
        let found: Vec<&str> = error.lines().map(|line| line.split(" (").next().unwrap()).collect();
        assert_eq!(
            found,
            [
                "quantities.mas_per_area: no quantity of a procedure; did you mean `mass_per_area`?",
                "quantities.stiffness: 'k' must be positive: procedures take it so",
            ]
        );
    }
}
