//! How a side behaves as one variable moves: its limit, whether it rises or falls, whether it depends on the variable at all.

use slipmode_algebra::{
    Certificate, Domain, Expression, Literal, Proof, RationalFunction, Refutation, Sign, Symbol, Toward,
};

use super::Problem;
use super::points::{self, Points};
use super::prover::Prover;
use super::substitutions::domains;
use crate::claims::Finding;
use crate::scene::{Comparison, Statement};

/// Of how many points each is compared with each other one.
const FIRST_POINTS: usize = 64;

impl Problem<'_> {
    pub(super) fn behaviour(&self, statement: &Statement) -> Finding {
        let sides: Vec<Expression> = statement.sides().into_iter().map(|side| self.put_in(side)).collect();
        let points = self.points(&sides);
        let prover = Prover::new(&points);
        let (Some(domain), Ok(proof)) = (prover.domain(&self.premises, &[]), self.start(&prover)) else {
            return Finding::not_checked(format!(
                "None of {} points meets the conditions, so that they may be impossible.",
                Points::MOST
            ));
        };
        let attempt = Attempt {
            proof,
            numbers: self.numbers(),
            domains: domains(&domain, &sides),
            points,
            problem: self,
        };
        match (statement, &sides[..]) {
            (Statement::Monotone(_, _, variable), _) if !one_interval(&domain, variable) => {
                Finding::not_checked(format!(
                    "Not decided: a condition that is not linear in {variable} may allow separate ranges of it, between which a slope says nothing."
                ))
            }
            (Statement::Monotone(_, comparison, variable), [side, ..]) => {
                attempt.monotone(side, *comparison, variable)
            }
            (Statement::Limit(_, _, variable, toward), [side, value]) => {
                attempt.limit(side, value, variable, *toward)
            }
            (Statement::Depends(_, depends, variable), [side, ..]) => {
                attempt.depends(side, *depends, variable)
            }
            _ => Finding::not_checked("Not decided."),
        }
    }
}

/// Whether the conditions allow one interval of a variable: each that contains it is linear in it, and no inequality of the kind ≠.
fn one_interval(domain: &Domain, variable: &str) -> bool {
    let name = Symbol::new(variable);
    domain.conditions().iter().filter(|condition| condition.expression.variables().contains(&name)).all(
        |condition| {
            let slope = domain.rational_function(&condition.expression.derivative(&name));
            let is_constant = |slope: RationalFunction| !Expression::from(&slope).variables().contains(&name);
            condition.relation != slipmode_algebra::Relation::NonZero && slope.is_ok_and(is_constant)
        },
    )
}

/// What the decision of one statement works with.
struct Attempt<'a> {
    proof: Proof,
    numbers: Vec<&'a str>,
    /// The conditions, as they are and with substitutions that reach every point of them.
    domains: Vec<Domain>,
    points: Points,
    problem: &'a Problem<'a>,
}

impl Attempt<'_> {
    /// The first of the domains in which the proof succeeds.
    fn proved(&self, prove: impl Fn(Proof, &Domain) -> Result<Proof, Refutation>) -> Option<Finding> {
        let proof = self.domains.iter().find_map(|domain| prove(self.proof.clone(), domain).ok())?;
        Some(Finding::from_proof(Ok(proof)))
    }

    fn all_points(&self, count: usize) -> impl Iterator<Item = points::Point> {
        self.points.meeting(&self.problem.premises.conditions, count)
    }

    fn text(&self, point: &points::Point) -> String {
        points::text(&self.problem.full(point))
    }

    fn undecided(&self, tried: &str) -> Finding {
        Finding::not_checked(format!(
            "Not decided: {tried} in {} forms of the conditions, and {} points do not refute it.",
            self.domains.len(),
            Points::MOST
        ))
    }

    /// A slope of one sign. Only the opposite sign refutes it: a function with a slope of zero at one point may be monotone.
    fn monotone(&self, side: &Expression, comparison: Comparison, variable: &str) -> Finding {
        let slope = side.derivative(&Symbol::new(variable));
        let is_zero = self
            .domains
            .first()
            .is_some_and(|domain| domain.rational_function(&slope).is_ok_and(|slope| slope.is_zero()));
        if is_zero && self.all_points(FIRST_POINTS).any(|point| self.can_move(&point, variable)) {
            return Finding::failing(format!("its slope in {variable} is 0 everywhere"));
        }
        let rising = if comparison == Comparison::Less { -slope.clone() } else { slope.clone() };
        let prover = Prover::new(&self.points);
        let clause = [Literal::new(rising.clone(), Sign::Positive)];
        if let Some(steps) = prover.clause(&self.problem.premises, &clause) {
            let step = |proof: Proof, (says, certificate)| -> Result<Proof, Refutation> {
                let says = format!("its slope in {variable}: {says}");
                proof.certify(&says, &self.numbers, certificate)
            };
            return Finding::from_proof(steps.into_iter().try_fold(self.proof.clone(), step));
        }
        let refuted = self.all_points(Points::MOST).find_map(|point| {
            let value = slope.rational_value(&point)?;
            let opposite = if comparison == Comparison::Less { value > 0 } else { value < 0 };
            (opposite && self.can_move(&point, variable))
                .then(|| format!("at {}: its slope in {variable} is {value}", self.text(&point)))
        });
        refuted.map_or_else(|| self.undecided("coefficients of one sign were not found"), Finding::failing)
    }

    fn limit(&self, expression: &Expression, value: &Expression, variable: &str, toward: Toward) -> Finding {
        let prove = |domain: &Domain| {
            let proof = self.proof.clone();
            proof.limit("the limit", &self.numbers, expression, (variable, toward), value, domain)
        };
        for domain in &self.domains {
            if let Ok(proof) = prove(domain) {
                return Finding::from_proof(Ok(proof));
            }
        }
        match self.other_limit(expression, value, variable, toward) {
            Some(words) => Finding::failing(words),
            None => Finding::not_checked(format!(
                "Not decided: the limit was not found to be finite and {value} in {} forms of the conditions, and {} points do not refute it.",
                self.domains.len(),
                Points::MOST
            )),
        }
    }

    /// A point that meets the conditions and at which the limit is another one.
    fn other_limit(
        &self,
        expression: &Expression,
        value: &Expression,
        variable: &str,
        toward: Toward,
    ) -> Option<String> {
        let found = self.domains.first()?.limit(expression, &Symbol::new(variable), toward).ok()?;
        let found = Expression::from(&found);
        self.all_points(Points::MOST).find_map(|point| {
            let [limit, claimed] = [found.rational_value(&point)?, value.rational_value(&point)?];
            let others: points::Point =
                point.into_iter().filter(|(name, _)| name.as_str() != variable).collect();
            (limit != claimed)
                .then(|| format!("at {}: the limit is {limit}, not {claimed}", self.text(&others)))
        })
    }

    /// Whether the conditions let a variable move away from a point that meets them, to both sides.
    fn can_move(&self, point: &points::Point, variable: &str) -> bool {
        let name = Symbol::new(variable);
        let of_variable =
            |one: &&Literal| one.sign == Sign::NonNegative && one.expression.variables().contains(&name);
        self.problem
            .premises
            .conditions
            .iter()
            .filter(of_variable)
            .all(|one| one.expression.rational_value(point).is_some_and(|value| value > 0))
    }

    fn depends(&self, expression: &Expression, claimed: bool, variable: &str) -> Finding {
        let (name, other) = (Symbol::new(variable), Expression::variable("other_value"));
        let changed = expression.with(variable, &other);
        let same = self.proved(|proof, domain| {
            let domain = domain.clone().and_positive("other_value");
            proof.identity(&format!("with another {variable}"), &self.numbers, expression, &changed, &domain)
        });
        if let Some(same) = same {
            let never = format!("it is the same for every {variable}");
            return if claimed { same.refuted(never) } else { same };
        }
        // A point, and the same point with the variable's value of another one.
        let pair = self.all_points(FIRST_POINTS).find_map(|point| {
            let value = expression.rational_value(&point)?;
            let changed = self.all_points(FIRST_POINTS).find_map(|other| {
                let mut moved = point.clone();
                moved.insert(name.clone(), other.get(&name)?.clone());
                let changed = expression.rational_value(&moved).filter(|changed| *changed != value)?;
                let allowed = self
                    .problem
                    .premises
                    .conditions
                    .iter()
                    .all(|one| points::meets(one, &moved) == Some(true));
                allowed.then(|| (moved[&name].clone(), changed))
            })?;
            Some((point, value, changed))
        });
        let Some((point, value, (moved, changed_value))) = pair else {
            return self.undecided("no identity was found");
        };
        let words =
            format!("at {}: {value}, and {changed_value} with {variable} = {moved}", self.text(&point));
        if !claimed {
            return Finding::failing(words);
        }
        let mut listed: Vec<(String, Expression)> =
            point.iter().map(|(name, value)| (name.to_string(), Expression::Number(value.clone()))).collect();
        listed.push(("other_value".into(), Expression::Number(moved)));
        let values = [value, changed_value].map(Expression::Number);
        let certificate =
            Certificate::Difference { left: expression.clone(), right: changed, point: listed, values };
        Finding::from_proof(self.proof.clone().certify(&words, &self.numbers, certificate))
    }
}
