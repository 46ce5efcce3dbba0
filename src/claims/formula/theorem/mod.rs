//! A claim's formula as one theorem of Coq: the statement is written from the parsed formula, the proof from the steps of the
//! proof in the ledger.

mod signs;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use slipmode_algebra::coq::{self, Theorem};
use slipmode_algebra::{Certificate, Comparison, End, Expression, Proof, Symbol, Toward};
use slipmode_theory::Equations;

use super::behaviour::other_value;
use super::points::Point;
use crate::claims::sha256_hex;
use crate::scene::{ClaimFormula, Formula, Names, Premises, Statement};

/// The statements that Coq has accepted; `cargo xtask prove` writes and checks the list.
pub(super) static ACCEPTED: LazyLock<Accepted<'static>> = LazyLock::new(|| accepted(crate::claims::ACCEPTED));

/// Whether a theorem states a whole formula, and the digest of what it states.
pub(super) type Accepted<'l> = BTreeSet<(bool, &'l str)>;

/// The theorems of a list with a name and a digest in each line.
pub(super) fn accepted(list: &str) -> Accepted<'_> {
    let words = list.lines().filter_map(|line| line.split_once(' '));
    words.map(|(name, digest)| (name.starts_with(PREFIX), digest)).collect()
}

/// What the name of a whole theorem begins with.
const PREFIX: &str = "formula_";

/// The kinds of certificates that say what a name by a limit process means: nothing else in the theorem says it.
const OF_NAMES: [&str; 4] = ["derivative", "characteristic", "limit", "series"];

/// SHA-256 of what the theorem of a step states: the text between its name and the full stop before its proof.
#[must_use]
pub fn statement_digest(theorem: &Theorem) -> String {
    let head = format!("Theorem {}", theorem.name);
    let stated = theorem.text.split_once(&head).and_then(|(_, rest)| rest.split_once(".\nProof."));
    stated.map_or_else(String::new, |(stated, _)| sha256_hex(stated))
}

/// A formula as a theorem, with the steps that its proof uses.
#[derive(Debug)]
pub struct WholeTheorem {
    /// The name: a digest of the statement.
    pub name: String,
    /// SHA-256 of the statement.
    pub digest: String,
    /// The statement.
    pub statement: String,
    /// Its proof.
    pub proof: String,
    /// An altered statement, which is false.
    pub altered: String,
    /// The steps that the proof uses.
    pub steps: Vec<Theorem>,
}

/// A formula with the statement of its theorem, which Coq has accepted.
#[derive(Debug)]
pub struct WholeStatement<'c> {
    /// The formula in words; may be empty.
    pub words: &'c str,
    /// The formula.
    pub formula: &'c ClaimFormula,
    /// The theorem's name.
    pub name: String,
    /// What the theorem states.
    pub statement: String,
}

/// The theorem that states the whole formula, or its negation, if Coq has accepted it.
pub(super) fn accepted_statement<'c>(
    words: &'c str,
    formula: &'c ClaimFormula,
    equations: &Equations,
) -> Option<WholeStatement<'c>> {
    let find = |is_refuted| accepted_in(&ACCEPTED, formula, equations, is_refuted);
    let (name, statement) = find(false).or_else(|| find(true))?;
    Some(WholeStatement { words, formula, name, statement })
}

/// The name and the statement, if this list has its digest, and those of all derivatives, limits and series behind the names of the formula.
pub(super) fn accepted_in(
    list: &Accepted<'_>,
    formula: &ClaimFormula,
    equations: &Equations,
    is_refuted: bool,
) -> Option<(String, String)> {
    let statement = Stated::new(formula, equations, is_refuted).ok()?.text(false);
    let (name, digest) = named(&statement);
    let names = Names::of(equations);
    let steps = names.proofs_of(&super::all_expressions(formula)).into_iter().flat_map(|proof| &proof.steps);
    let mut of_names = steps
        .filter_map(|step| step.certificate.as_ref())
        .filter(|certificate| OF_NAMES.contains(&certificate.kind()));
    let is_known = of_names.all(|certificate| {
        Theorem::of(certificate)
            .is_ok_and(|theorem| list.contains(&(false, statement_digest(&theorem).as_str())))
    });
    (is_known && list.contains(&(true, digest.as_str()))).then_some((name, statement))
}

/// The formula as a theorem, proved from the steps of this proof, or its negation where they are its values at a point.
///
/// # Errors
/// What stands in the way.
pub(super) fn whole_theorem(
    formula: &ClaimFormula,
    equations: &Equations,
    proof: &Proof,
) -> Result<WholeTheorem, String> {
    let point = signs::point_of(proof);
    let is_refuted = formula.scope.there_is.is_empty()
        && matches!(formula.statement, Statement::True(_))
        && point.is_some();
    let stated = Stated::new(formula, equations, is_refuted)?;
    let statement = stated.text(false);
    let (name, digest) = named(&statement);
    let mut steps = Steps { stated: &stated, proof, used: Vec::new() };
    let tactics = steps.tactics(formula, point)?;
    let altered = stated.text(true);
    Ok(WholeTheorem { name, digest, statement, proof: tactics, altered, steps: steps.used })
}

fn named(statement: &str) -> (String, String) {
    let digest = sha256_hex(statement);
    (format!("{PREFIX}{}", &digest[..16]), digest)
}

/// Why a formula is no theorem that has the same text on both sides.
fn same_sides() -> String {
    "both sides are the same by the equations that define them: a definition, and no theorem".to_owned()
}

/// A statement in the original variables.
struct Stated {
    premises: Premises,
    names: Names,
    variables: BTreeSet<Symbol>,
    hypotheses: Vec<(String, String)>,
    /// The equations among the conditions, by their labels, in the order in which they were solved.
    equations: Vec<String>,
    goal: String,
    altered: String,
    /// Whether it says that values exist, and not what holds for all.
    exists: bool,
    /// Whether it is the negation of the formula.
    is_refuted: bool,
    /// The variables of which there is a value, for all values of the others.
    there_is: Vec<Symbol>,
}

impl Stated {
    fn new(formula: &ClaimFormula, equations: &Equations, is_refuted: bool) -> Result<Self, String> {
        let scope = &formula.scope;
        if formula.rows.is_some() {
            return Err("a statement on the rows of a table".into());
        }
        if is_refuted && !(matches!(formula.statement, Statement::True(_)) && scope.there_is.is_empty()) {
            return Err("the negation of a statement that values exist, or on how an expression moves".into());
        }
        let premises = formula.premises(equations)?;
        let mut stated = Self {
            premises,
            names: Names::of(equations),
            variables: BTreeSet::new(),
            hypotheses: Vec::new(),
            equations: Vec::new(),
            goal: String::new(),
            altered: String::new(),
            exists: is_refuted || matches!(formula.statement, Statement::Depends(_, true, _)),
            is_refuted,
            there_is: scope.there_is.clone(),
        };
        for (name, [low, high]) in scope.within.iter().filter(|(name, _)| !scope.there_is.contains(name)) {
            let [low, high] = [low, high].map(|end| coq::text(&Expression::Number(end.clone())));
            let name = stated.shown(&Expression::variable(name))?;
            stated.hypotheses.push((format!("least'{name}"), format!("{low} <= {name}")));
            stated.hypotheses.push((format!("most'{name}"), format!("{name} <= {high}")));
        }
        for (condition, number) in scope.given.iter().zip(1..) {
            if stated.is_wanted(&condition.sides) {
                continue;
            }
            let label = format!("given'{number}");
            let [left, right] = &condition.sides;
            let text = stated.compared(left, condition.comparison, right)?;
            if condition.comparison == Comparison::Equal {
                stated.equations.push(label.clone());
            }
            stated.hypotheses.push((label, text));
        }
        stated.goal = stated.goal_of(formula, false)?;
        stated.altered = stated.goal_of(formula, true)?;
        let positive = stated.variables.iter().filter(|name| stated.is_positive(name)).map(signs::shown);
        let positive = positive.map(|name| (format!("{name}'pos"), format!("0 < {name}")));
        let positive: Vec<(String, String)> = positive.collect();
        stated.hypotheses.splice(0..0, positive);
        Ok(stated)
    }

    /// Whether sides speak of a variable of which there is a value.
    fn is_wanted(&self, sides: &[Expression; 2]) -> bool {
        sides.iter().any(|side| self.side(side).variables().iter().any(|name| self.there_is.contains(name)))
    }

    /// Whether the equations assume that a variable is positive.
    fn is_positive(&self, name: &Symbol) -> bool {
        let solved = self.premises.solved.iter().any(|solved| solved.variable == *name);
        self.premises.positive.contains(name) || (solved && self.names.is_positive(name))
    }

    fn text(&self, altered: bool) -> String {
        let names: Vec<String> = self.variables.iter().map(signs::shown).collect();
        if self.exists {
            let (names, goal) = (names.join(" "), if altered { &self.altered } else { &self.goal });
            let hypotheses: String = self.hypotheses.iter().map(|(_, text)| format!("{text} /\\ ")).collect();
            return format!(" :\n  exists {names} : R, {hypotheses}{goal}");
        }
        let variables = if names.is_empty() { String::new() } else { format!(" ({} : R)", names.join(" ")) };
        let hypotheses: String =
            self.hypotheses.iter().map(|(label, text)| format!(" ({label} : {text})")).collect();
        format!("{variables}{hypotheses} :\n  {}", if altered { &self.altered } else { &self.goal })
    }

    /// A side with the definitions and the values of the scope in place.
    fn side(&self, side: &Expression) -> Expression {
        self.names.resolved(side).substitute(&self.premises.values)
    }

    /// A side as Coq reads it; its variables are noted.
    fn shown(&mut self, side: &Expression) -> Result<String, String> {
        self.noted(&self.side(side))
    }

    /// An expression in variables as Coq reads it; they are noted.
    fn noted(&mut self, side: &Expression) -> Result<String, String> {
        let variables = side.variables();
        if let Some(name) = variables.iter().find(|name| matches!(name.as_str(), "i" | "pm")) {
            return Err(format!("the formula contains {name}"));
        }
        if let Some(function) = side.functions().first() {
            return Err(format!("the formula has the function {function}, of which nothing is known"));
        }
        self.variables.extend(variables);
        Ok(coq::text(side))
    }

    fn compared(
        &mut self,
        left: &Expression,
        comparison: Comparison,
        right: &Expression,
    ) -> Result<String, String> {
        let (left, right) = (self.shown(left)?, self.shown(right)?);
        Ok(match comparison {
            Comparison::Equal => format!("{left} = {right}"),
            Comparison::Unequal => format!("{left} <> {right}"),
            Comparison::Less => format!("{left} < {right}"),
            Comparison::AtMost => format!("{left} <= {right}"),
            Comparison::Greater => format!("{right} < {left}"),
            Comparison::AtLeast => format!("{right} <= {left}"),
        })
    }

    /// What a statement says; altered, it is false.
    fn goal_of(&mut self, formula: &ClaimFormula, altered: bool) -> Result<String, String> {
        match &formula.statement {
            Statement::True(said) if !self.there_is.is_empty() => {
                let goal = self.by_signs(&signs::wanted(said, &formula.scope, self), false)?;
                let names: Vec<String> = self.there_is.iter().map(signs::shown).collect();
                self.there_is.iter().for_each(|name| _ = self.variables.remove(name));
                let goal = format!("exists {} : R, {goal}", names.join(" "));
                Ok(if altered { format!("~ ({goal})") } else { goal })
            }
            Statement::True(said) => self.by_signs(said, altered != self.is_refuted),
            _ if !self.there_is.is_empty() => {
                Err("a statement that a value exists with which an expression moves".into())
            }
            Statement::Limit(_, End::Infinite(_), ..) => Err("a limit beyond all bounds".into()),
            Statement::Limit(side, End::Finite(value), variable, toward) => {
                let point = coq::text(&Expression::variable(variable));
                let known = self.variables.contains(variable);
                let (side, value) = (self.shown(side)?, self.shown(value)?);
                if known {
                    return Err(format!("a condition contains {variable}, which moves"));
                }
                self.variables.remove(variable);
                let filter = match toward {
                    Toward::Zero => "(at_right 0)",
                    Toward::Infinity => "(Rbar_locally p_infty)",
                };
                let value = if altered { format!("({value} + 1)") } else { value };
                Ok(format!("filterlim (fun {point} : R => {side}) {filter} (locally {value})"))
            }
            Statement::Monotone(side, comparison, variable) => {
                if self.variables.contains(variable) {
                    return Err(format!("a condition contains {variable}, which moves"));
                }
                // No formula has a parameter.
                let [low, high] = [0, 1].map(|number| Expression::Variable(Symbol::parameter(number)));
                let ends = [&low, &high].map(|end| coq::text(&self.side(side).with(variable, end)));
                self.shown(side)?;
                self.variables.remove(variable);
                let [low, high] = [low, high].map(|end| coq::text(&end));
                let positive =
                    if self.is_positive(variable) { format!("0 < {low} -> ") } else { String::new() };
                let rises = (*comparison == Comparison::Greater) != altered;
                let [first, second] = &ends;
                let order = if rises { format!("{first} < {second}") } else { format!("{second} < {first}") };
                Ok(format!("forall {low} {high} : R, {positive}{low} < {high} -> {order}"))
            }
            Statement::Depends(side, depends, variable) => {
                let other = self.side(side).with(variable, &Expression::Variable(other_value()));
                let side = self.shown(side)?;
                if !self.premises.positive.contains(variable) {
                    return Err(format!("{variable} is not positive, but its other value is"));
                }
                self.variables.insert(other_value());
                let shown = signs::shown(&other_value());
                let known = format!("{shown}'pos");
                if self.hypotheses.iter().all(|(label, _)| *label != known) {
                    self.hypotheses.push((known, format!("0 < {shown}")));
                }
                let other = coq::text(&other);
                if !*depends && side == other {
                    return Err(same_sides());
                }
                if *depends {
                    return Ok(format!("{side} {} {other}", if altered { "=" } else { "<>" }));
                }
                Ok(if altered { format!("{side} = {other} + 1") } else { format!("{side} = {other}") })
            }
            Statement::Motion(_) => Err("a statement on the motions of a system".into()),
            Statement::Computed(_) => Err("no formula".into()),
        }
    }
}

/// The proof in the making: the ledger's steps that it uses.
struct Steps<'p> {
    stated: &'p Stated,
    proof: &'p Proof,
    used: Vec<Theorem>,
}

impl Steps<'_> {
    fn put_in(&self, side: &Expression) -> Expression {
        self.stated.premises.put_in(&self.stated.names.resolved(side))
    }

    /// The tactics that prove a statement.
    fn tactics(&mut self, formula: &ClaimFormula, point: Option<Point>) -> Result<String, String> {
        let mut tactics = String::new();
        let stated = self.stated;
        if let (Statement::True(said), true) = (&formula.statement, stated.is_refuted) {
            return self.at_point(said, point.unwrap_or_default(), true);
        }
        for (solved, label) in stated.premises.solved.iter().zip(&stated.equations) {
            let variable = Expression::Variable(solved.variable.clone());
            let [name, value, slope] = [&variable, &solved.value, &solved.slope].map(coq::text);
            let [left, right] =
                [solved.expression.clone() / solved.slope.clone(), variable - solved.value.clone()];
            let step = self.equality(&left, &right)?;
            tactics += &format!(
                "assert (is' : {name} = {value}) by (apply (solved_for _ _ {slope} _ _ {label}); \
                 first [ring | field; divisors | symmetry; {step}]); clear {label}; subst {name}; "
            );
            if solved.value.is_zero() {
                tactics += "repeat rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rplus_0_l, ?Rplus_0_r, ?Rminus_0_r; ";
            }
        }
        let rest = match &formula.statement {
            Statement::True(said) if !stated.there_is.is_empty() => {
                self.at_witness(said, &formula.scope, point)?
            }
            Statement::True(said) => self.by_signs(said, &BTreeMap::new(), false)?,
            Statement::Limit(side, End::Finite(value), variable, _) => {
                let [side, value] = [side, value].map(|side| self.put_in(side));
                self.fact(&[], |one| {
                    matches!(one, Certificate::Limit { expression, variable: moving, value: end, .. }
                        if *expression == side && moving == variable && *end == value)
                })? + "stated h'"
            }
            Statement::Monotone(side, comparison, variable) => {
                let side = self.put_in(side);
                let slope = side.derivative(variable);
                let falls = *comparison == Comparison::Less;
                let rising = if falls { -slope.clone() } else { slope.clone() };
                let moving = coq::text(&Expression::variable(variable));
                let positive =
                    if self.stated.is_positive(variable) { "assert (0 < t') by lra; " } else { "" };
                let fact = self.fact(&[(variable.clone(), "t'".to_owned())], |one| {
                    matches!(one, Certificate::Sign { expression, sign: 1, .. } if *expression == rising)
                })?;
                // Coq writes a quotient in an exponent in its own way.
                let differentiate = if coq::text(&side).contains("(exp ") { "derivative" } else { "slope" };
                format!(
                    "intros; apply ({} (fun {moving} : R => {}) (fun {moving} : R => {})); \
                     [ intros t' range'; {positive}cbn beta; {differentiate} \
                     | intros t' range'; {positive}cbn beta; {fact}stated h' | assumption ]",
                    if falls { "falls" } else { "rises" },
                    coq::text(&side),
                    coq::text(&slope),
                )
            }
            Statement::Depends(side, true, variable) => {
                let other = self.put_in(side).with(variable, &Expression::Variable(other_value()));
                let differ = Formula::Compare(self.put_in(side), Comparison::Unequal, other);
                return self.at_point(&differ, point.ok_or("no step compares two values")?, false);
            }
            Statement::Depends(side, false, variable) => {
                let side = self.put_in(side);
                let other = side.with(variable, &Expression::Variable(other_value()));
                self.equality(&side, &other)?
            }
            // Nothing states them.
            Statement::Limit(_, End::Infinite(_), ..) | Statement::Motion(_) | Statement::Computed(_) => {
                return Err("no theorem".into());
            }
        };
        Ok(tactics + &rest)
    }

    fn equality(&mut self, left: &Expression, right: &Expression) -> Result<String, String> {
        let difference = left.clone() - right.clone();
        let zero = Expression::integer(0);
        let fact = self.fact(&[], |one| {
            matches!(one, Certificate::Identity { left: one, right: other, .. }
                if (one == left && other == right) || (*one == difference && *other == zero))
        })?;
        Ok(fact + "stated h'")
    }

    /// The step with this certificate as a fact on the variables, of which some have other names.
    fn fact(
        &mut self,
        renamed: &[(Symbol, String)],
        is_it: impl Fn(&Certificate) -> bool,
    ) -> Result<String, String> {
        let mut certificates = self.proof.steps.iter().rev().filter_map(|step| step.certificate.as_ref());
        let found = certificates.find(|one| is_it(one));
        let found = found.ok_or("no single step states the formula or a part of it")?;
        let applied = self.applied(found, renamed)?;
        Ok(format!("pose proof {applied} as h'; "))
    }

    /// The theorem of a step for the variables of the statement, of which some have other names.
    fn applied(&mut self, step: &Certificate, renamed: &[(Symbol, String)]) -> Result<String, String> {
        let theorem = Theorem::of(step).map_err(|obstacle| obstacle.to_string())?;
        let renamed: BTreeMap<String, &String> =
            renamed.iter().map(|(name, other)| (signs::shown(name), other)).collect();
        let known: BTreeSet<String> = self.stated.variables.iter().map(signs::shown).collect();
        // A variable that the statement does not have is free: any value does.
        let arguments: Vec<&str> = theorem
            .variables
            .iter()
            .map(|name| match renamed.get(name) {
                Some(other) => other.as_str(),
                None if known.contains(name) => name,
                None => "1",
            })
            .collect();
        let applied = format!("({} {})", theorem.name, arguments.join(" "));
        if self.used.iter().all(|known| known.name != theorem.name) {
            self.used.push(theorem);
        }
        Ok(applied)
    }
}
