//! Warnings about formulas that may say less than they seem to.

use slipmode_algebra::{Comparison, Expression, Symbol, unknowns, within_budget};
use slipmode_theory::{Equation, Equations};

use super::lowering::{Lowered, words};
use super::{Problem, STEPS, decide_equations};
use crate::claims::{Finding, Verdict};
use crate::scene::{ClaimFormula, Formula, FormulaCondition, Names, StatedClaim, Statement};

/// How many edges of one formula are looked at.
const MOST_EDGES: usize = 4;

/// What a reader should know of the formulas of a claim besides their verdicts, which are those of a finding.
pub(in crate::claims) fn warnings(
    stated: &StatedClaim,
    found: &Finding,
    equations: &Equations,
) -> Vec<String> {
    let parts = found.readings.iter().flat_map(|reading| &reading.parts).map(|part| part.verdict);
    let alone = found.readings.is_empty().then_some(found.verdict);
    let mut warnings: Vec<String> = Vec::new();
    let about_equations =
        stated.parts().zip(parts.chain(alone)).filter(|((_, formula), _)| formula.rows.is_none());
    for ((_, formula), verdict) in about_equations {
        let own = within_budget(STEPS, || of_formula(formula, verdict, stated, equations));
        let own = own.unwrap_or_else(|exhausted| {
            vec![format!("not all warnings on '{}' were looked for: {exhausted}", formula.text)]
        });
        for warning in own {
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
    }
    warnings
}

fn of_formula(
    formula: &ClaimFormula,
    verdict: Verdict,
    stated: &StatedClaim,
    equations: &Equations,
) -> Vec<String> {
    let names = Names::of(equations);
    let Ok(problem) = Problem::new("warnings", "", formula, equations) else { return Vec::new() };
    if let Some(steps) = problem.contradiction() {
        let last = steps.last().map(|(says, _)| says.as_str()).unwrap_or_default();
        return vec![format!(
            "the conditions of '{}' contradict each other ({last}): it says nothing",
            formula.text
        )];
    }
    // What a derivation gives twice is not the same by construction.
    let is_written = |side: &Expression| names.proofs_of(side).is_empty();
    let is_same = |left: &Expression, right: &Expression| {
        names.resolved(left) == names.resolved(right) && is_written(left) && is_written(right)
    };
    let mut found = existence(formula, &names);
    found.extend(not_defined(formula, &names, equations));
    if let Statement::True(said) = &formula.statement {
        found.extend(said.atoms().into_iter().filter_map(|atom| match atom {
            Formula::Compare(left, _, right) if is_same(left, right) => {
                Some(format!("both sides of '{}' are the same by their definitions", words(atom)))
            }
            _ => None,
        }));
        found.extend(hypotheses(said).into_iter().filter_map(|hypothesis| problem.never(hypothesis)));
    }
    if let Statement::Depends(side, false, variable) = &formula.statement
        && is_written(side)
        && problem.put_in(side).variables().iter().all(|name| name != variable)
    {
        found.push(format!(
            "'{}' is so by the equations that define its names: they do not contain {variable}",
            formula.text
        ));
    }
    if verdict == Verdict::Holds {
        found.extend(forgotten_edges(formula, stated, equations));
    }
    found
}

/// Variables of the formula that stand alone on the left of one equation, which yet does not say what they are, because they are assumed
/// of or it has a ±. Where the formula names a side of an equation, its author knows what they are.
fn not_defined(formula: &ClaimFormula, names: &Names, equations: &Equations) -> Vec<String> {
    let written = super::all_expressions(formula);
    if !names.equations_of(&written).is_empty() {
        return Vec::new();
    }
    let left = |name: &Symbol| {
        let has = |equation: &&Equation| matches!(&equation.left, Expression::Variable(left) if left == name);
        let mut equations = equations.iter().filter(has);
        equations.next().filter(|_| equations.next().is_none())
    };
    let variables = written.variables();
    let open = variables
        .iter()
        .filter(|name| names.resolved(&Expression::variable(*name)) == Expression::variable(*name));
    open.filter_map(|name| {
        let number = &left(name)?.number;
        Some(format!("{name} is a variable in '{}': equation {number} does not define it", formula.text))
    })
    .collect()
}

/// Variables of which there is a value, but on which nothing depends.
fn existence(formula: &ClaimFormula, names: &Names) -> Vec<String> {
    let scope = &formula.scope;
    let used: Vec<_> =
        formula.statement.sides().into_iter().flat_map(|side| names.resolved(side).variables()).collect();
    let unused = scope.there_is.iter().filter(|name| !used.contains(name));
    let unused = unused
        .map(|name| format!("'{}' does not contain {name}, of which there is to be a value", formula.text));
    let others = used.iter().any(|name| !scope.there_is.contains(name));
    let fixed = scope.witness.iter().filter(|(_, value)| others && unknowns([value]).is_empty());
    let fixed = fixed.map(|(name, value)| {
        format!("the witness {name} = {value} does not depend on the other variables: one value does for all of them")
    });
    unused.chain(fixed).collect()
}

/// The left sides of `implies` that stand at the top.
fn hypotheses(formula: &Formula) -> Vec<&Formula> {
    match formula {
        Formula::Implies(both) => vec![&both[0]],
        Formula::All(parts) => parts.iter().flat_map(hypotheses).collect(),
        _ => Vec::new(),
    }
}

impl Problem<'_> {
    /// The warning that a hypothesis is false everywhere.
    fn never(&self, hypothesis: &Formula) -> Option<String> {
        let always_false = Formula::Not(Box::new(hypothesis.clone()));
        let text: Vec<String> = hypothesis.atoms().into_iter().map(words).collect();
        let is_true = self.is_proved(&always_false);
        is_true.then(|| {
            format!(
                "the hypothesis ({}) is never true under the conditions: the formula says nothing",
                text.join("; ")
            )
        })
    }

    /// Whether a certificate shows a formula for all points that meet the conditions.
    fn is_proved(&self, formula: &Formula) -> bool {
        let Ok(lowered) = Lowered::new(formula, &self.names, &self.premises) else { return false };
        let expressions = lowered.expressions();
        let points = self.points(&expressions);
        let prover = self.prover(&points);
        self.proved(formula, &lowered, &prover).is_ok()
    }
}

/// Two sides that compare strictly in a formula that holds, which is false or undecided where they are equal.
fn forgotten_edges(formula: &ClaimFormula, stated: &StatedClaim, equations: &Equations) -> Vec<String> {
    let is_strict =
        |comparison| matches!(comparison, Comparison::Less | Comparison::Greater | Comparison::Unequal);
    // What holds for every claim of the report is not this formula's to say.
    let is_own = |one: &FormulaCondition| !equations.conditions().iter().any(|text| text.trim() == one.text);
    let given = formula.scope.given.iter().enumerate();
    // A variable that goes to a limit does not stay on an edge.
    let moving = formula.statement.variable().filter(|_| matches!(formula.statement, Statement::Limit(..)));
    let names = Names::of(equations);
    let stays = |one: &FormulaCondition| {
        let mut variables = one.sides.iter().flat_map(|side| names.resolved(side).variables());
        variables.all(|name| Some(&name) != moving)
    };
    let given = given.filter(|(_, one)| is_strict(one.comparison) && is_own(one) && stays(one));
    let given = given.map(|(at, condition)| {
        let mut edge = formula.clone();
        edge.scope.given[at].comparison = Comparison::Equal;
        (condition.sides.clone(), edge)
    });
    let hypothesis = || {
        let Statement::True(Formula::Implies(both)) = &formula.statement else { return None };
        let [Formula::Compare(left, comparison, right), conclusion] = &**both else { return None };
        let sides = [left.clone(), right.clone()];
        let mut edge = ClaimFormula { statement: Statement::True(conclusion.clone()), ..formula.clone() };
        edge.scope.given.push(FormulaCondition {
            text: format!("{left} = {right}"),
            sides: sides.clone(),
            comparison: Comparison::Equal,
        });
        is_strict(*comparison).then_some((sides, edge))
    };
    let edges = given.chain(hypothesis()).take(MOST_EDGES);
    edges
        .filter_map(|([left, right], edge)| {
            let edge_words = format!("{left} = {right}");
            let plain = |text: &str| text.replace(' ', "");
            let named = [edge_words.clone(), format!("{right} = {left}")]
                .iter()
                .any(|words| plain(&stated.leaves_out).contains(&plain(words)));
            if named || stated.parts().any(|(_, other)| covers(other, [&left, &right])) {
                return None;
            }
            // Where a side has no value the formula cannot say anything.
            edge.premises(equations).ok()?;
            let there = match decide_equations("warnings", "", &edge, equations).verdict {
                Verdict::Fails => "where it is false",
                Verdict::NotChecked => "where it is not decided",
                Verdict::Holds | Verdict::HoldsWithin => return None,
            };
            Some(format!("'{}' says nothing about {edge_words}, {there}", formula.text))
        })
        .collect()
}

/// Whether a formula says something where two sides are equal.
fn covers(formula: &ClaimFormula, sides: [&Expression; 2]) -> bool {
    let same = |left, right| [left, right] == sides || [right, left] == sides;
    let is_weak = |comparison: Comparison| {
        matches!(comparison, Comparison::Equal | Comparison::AtLeast | Comparison::AtMost)
    };
    let given = formula.scope.given.iter();
    given.into_iter().any(|one| is_weak(one.comparison) && same(&one.sides[0], &one.sides[1]))
        || matches!(&formula.statement, Statement::True(said) if said.atoms().into_iter().any(|atom| {
            matches!(atom, Formula::Compare(left, comparison, right) if is_weak(*comparison) && same(left, right))
        }))
}
