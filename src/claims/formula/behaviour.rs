//! How a side behaves as one variable moves: its limit, whether it rises or falls, whether it depends on the variable at all.

use std::cmp::Ordering;

use slipmode_algebra::{
    Certificate, Comparison, Domain, End, Expression, Literal, Proof, RationalFunction, Refutation, Sign,
    Symbol, Toward,
};

use super::points::{self, Point, Points};
use super::prover::{Prover, certify_all};
use super::{Problem, no_point};
use crate::claims::Finding;
use crate::claims::finding::NamedPoint;
use crate::scene::{Premises, Statement};

/// Of how many points each is compared with each other one.
const FIRST_POINTS: usize = 64;

impl Problem<'_> {
    pub(super) fn behaviour(&self, statement: &Statement) -> Finding {
        let sides: Vec<Expression> = statement.sides().into_iter().map(|side| self.put_in(side)).collect();
        let points = self.points(&sides);
        let prover = self.prover(&points);
        // A variable that goes to a limit has to be free, and what follows from the conditions does not bind it.
        let premises = match statement {
            Statement::Limit(..) => Premises { facts: Vec::new(), ..self.premises.clone() },
            _ => self.premises.clone(),
        };
        let (Some(domain), Ok(proof)) = (prover.domain(&premises, &[]), self.start(&prover)) else {
            return no_point();
        };
        let domain = match statement {
            Statement::Depends(..) => domain.with_positive(other_value()),
            _ => domain,
        };
        let attempt =
            Attempt { proof, numbers: self.numbers(), domains: domain.forms(&sides), points, problem: self };
        match (statement, &sides[..]) {
            (Statement::Monotone(_, _, variable), _) if !one_interval(&self.premises, variable) => {
                Finding::not_checked(format!(
                    "Not decided: a condition that is not linear in {variable} may allow separate ranges of it, between which a slope says nothing."
                ))
            }
            (Statement::Monotone(_, comparison, variable), [side, ..]) => {
                attempt.monotone(side, *comparison, variable)
            }
            (Statement::Limit(_, end, variable, toward), [side, ..]) => {
                let end = match (end, &sides[1..]) {
                    (End::Finite(_), [value]) => End::Finite(value.clone()),
                    _ => end.clone(),
                };
                attempt.limit(side, &end, variable, *toward)
            }
            (Statement::Depends(_, depends, variable), [side, ..]) => {
                attempt.depends(side, *depends, variable)
            }
            _ => Finding::not_checked("Not decided."),
        }
    }
}

/// Another value of the variable on which an expression may depend: no formula has a parameter.
pub(super) fn other_value() -> Symbol {
    Symbol::parameter(0)
}

/// Whether the conditions allow one interval of a variable: each that contains it is linear in it, and no inequality of the kind ≠.
fn one_interval(premises: &Premises, name: &Symbol) -> bool {
    let domain = premises.domain();
    premises.conditions.iter().filter(|condition| condition.expression.variables().contains(name)).all(
        |condition| {
            let slope = domain.rational_function(&condition.expression.derivative(name));
            let is_constant = |slope: RationalFunction| !slope.variables().contains(name);
            condition.sign != Sign::NonZero && slope.is_ok_and(is_constant)
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

    fn all_points(&self, count: usize) -> impl Iterator<Item = Point> {
        self.points.meeting(&self.problem.premises.conditions, count)
    }

    fn place(&self, point: &Point) -> String {
        points::place(&self.problem.full(point))
    }

    fn named(&self, point: &points::Point) -> NamedPoint {
        points::named(&self.problem.full(point))
    }

    fn undecided(&self, tried: &str) -> Finding {
        Finding::not_checked(format!(
            "Not decided: {tried} in {} forms of the conditions, and {} points do not refute it.",
            self.domains.len(),
            Points::MOST
        ))
    }

    /// A slope of one sign. Only the opposite sign refutes it: a function with a slope of zero at one point may be monotone.
    fn monotone(&self, side: &Expression, comparison: Comparison, variable: &Symbol) -> Finding {
        let slope = side.derivative(variable);
        let is_flat = |domain: &Domain| domain.rational_function(&slope).is_ok_and(|slope| slope.is_zero());
        let is_zero = self.domains.first().is_some_and(is_flat);
        let movable = || self.all_points(FIRST_POINTS).find(|point| self.can_move(point, variable));
        if is_zero && let Some(point) = movable() {
            return Finding::failing(format!("its slope in {variable} is 0 everywhere"))
                .seen_at([self.named(&point)]);
        }
        let rising = if comparison == Comparison::Less { -slope.clone() } else { slope.clone() };
        let prover = self.problem.prover(&self.points);
        let clause = [Literal::new(rising.clone(), Sign::Positive)];
        if let Some(steps) = prover.clause(&self.problem.premises, &clause) {
            let before = format!("its slope in {variable}: ");
            return Finding::from_proof(certify_all(self.proof.clone(), &before, &self.numbers, steps));
        }
        if let Some(found) = self.with_flat_points(&prover, &rising, variable) {
            return found;
        }
        let refuted = self.all_points(Points::MOST).find_map(|point| {
            let order = slope.order_at(&point)?;
            let opposite = if comparison == Comparison::Less { order.is_gt() } else { order.is_lt() };
            let value = points::value(&slope, &point)?;
            (opposite && self.can_move(&point, variable))
                .then(|| (format!("{}its slope in {variable} is {value}", self.place(&point)), point))
        });
        match refuted {
            Some((words, point)) => Finding::failing(words)
                .enclosed_unless(slope.rational_value(&point).is_some())
                .seen_at([self.named(&point)]),
            None => self.undecided("coefficients of one sign were not found"),
        }
    }

    /// A slope that is not negative, and zero at single points only: as a polynomial in the variable it has a coefficient that is not zero.
    fn with_flat_points(
        &self,
        prover: &Prover<'_>,
        rising: &Expression,
        variable: &Symbol,
    ) -> Option<Finding> {
        let premises = &self.problem.premises;
        let function = premises.domain().rational_function(rising).ok()?;
        if function.hides(variable).is_some() {
            return None;
        }
        let slope = [Literal::new(rising.clone(), Sign::NonNegative)];
        let mut steps = prover.clause(premises, &slope)?;
        let coefficients = function.numerator().coefficients(variable).into_iter().rev();
        let apart = coefficients
            .filter(|one| !one.is_zero())
            .find_map(|one| prover.clause(premises, &[Literal::new(Expression::from(&one), Sign::NonZero)]));
        steps.extend(apart?);
        let before = format!("its slope in {variable}, which is zero at single points at most: ");
        Some(Finding::from_proof(certify_all(self.proof.clone(), &before, &self.numbers, steps)))
    }

    fn limit(&self, expression: &Expression, end: &End, variable: &Symbol, toward: Toward) -> Finding {
        let prove = |proof: Proof, domain: &Domain| {
            let (expression, variable, domain) = (expression.clone(), variable.clone(), domain.clone());
            let certificate = match end.clone() {
                End::Finite(value) => Certificate::Limit { expression, variable, toward, value, domain },
                End::Infinite(sign) => Certificate::Divergence { expression, variable, toward, sign, domain },
            };
            proof.certify("the limit", &self.numbers, certificate)
        };
        self.proved(prove).unwrap_or_else(|| match self.other_limit(expression, end, variable, toward) {
            Some((words, point, is_rational)) => {
                Finding::failing(words).enclosed_unless(is_rational).seen_at([self.named(&point)])
            }
            None => {
                let first = self.domains.first();
                let why = first.and_then(|domain| domain.end(expression, variable, toward).err());
                Finding::not_checked(format!(
                    "Not decided: the limit was not found to be {end} in {} forms of the conditions, and {} points do not refute it{}.",
                    self.domains.len(),
                    Points::MOST,
                    why.map_or_else(String::new, |why| format!(": {why}"))
                ))
            }
        })
    }

    /// A point that meets the conditions and at which the limit is another one, and whether both are rational there.
    fn other_limit(
        &self,
        expression: &Expression,
        claimed: &End,
        variable: &Symbol,
        toward: Toward,
    ) -> Option<(String, Point, bool)> {
        let found = self.domains.first()?.end(expression, variable, toward).ok()?;
        self.all_points(Points::MOST).find_map(|point| {
            let (differ, is_rational) = match (&found, claimed) {
                (End::Finite(found), End::Finite(claimed)) => {
                    let difference = found.clone() - claimed.clone();
                    let order = difference.order_at(&point);
                    (order.is_some_and(Ordering::is_ne), difference.rational_value(&point).is_some())
                }
                (found, claimed) => (found != claimed, true),
            };
            let shown = |end: &End| match end {
                End::Finite(value) => points::value(value, &point).unwrap_or_else(|| value.to_string()),
                End::Infinite(_) => end.to_string(),
            };
            let words = [&found, claimed].map(shown);
            let others: Point = point.into_iter().filter(|(name, _)| name != variable).collect();
            let [limit, claimed] = words;
            let place = self.place(&others);
            differ.then(|| (format!("{place}the limit is {limit}, not {claimed}"), others, is_rational))
        })
    }

    /// Whether the conditions let a variable move away from a point that meets them, to both sides.
    fn can_move(&self, point: &Point, variable: &Symbol) -> bool {
        let of_variable =
            |one: &&Literal| one.sign == Sign::NonNegative && one.expression.variables().contains(variable);
        let mut of_variable = self.problem.premises.conditions.iter().filter(of_variable);
        of_variable.all(|one| one.expression.order_at(point).is_some_and(Ordering::is_gt))
    }

    /// A function of which nothing is known in the normal form of an expression.
    fn function_in(&self, expression: &Expression) -> Option<Symbol> {
        let normal = self.domains.first()?.rational_function(expression).ok();
        let functions =
            normal.map_or_else(|| expression.functions(), |one| Expression::from(&one).functions());
        functions.into_iter().next()
    }

    fn depends(&self, expression: &Expression, claimed: bool, variable: &Symbol) -> Finding {
        let changed = expression.with(variable, &Expression::Variable(other_value()));
        let same = self.proved(|proof, domain| {
            proof.identity(&format!("with another {variable}"), &self.numbers, expression, &changed, domain)
        });
        if let Some(same) = same {
            let never = format!("it is the same for every {variable}");
            return if claimed { same.refuted(never) } else { same };
        }
        let apart = expression.clone() - changed.clone();
        if let Some(function) = self.function_in(&apart).filter(|_| claimed) {
            return Finding::not_checked(format!(
                "Not decided: whether it depends on {variable} may differ from one function {function} to another."
            ));
        }
        // A point, and the same point with the variable's value of another one. Values of a proof are rational.
        let rational = |point: &Point| expression.rational_value(point).is_some();
        let pair =
            self.all_points(FIRST_POINTS).filter(|point| !claimed || rational(point)).find_map(|point| {
                let moved = self.all_points(FIRST_POINTS).find_map(|other| {
                    let moved = points::with(&point, variable, other.get(variable)?.clone());
                    let both = points::with(&point, &other_value(), moved[variable].clone());
                    let differ = apart.order_at(&both).is_some_and(Ordering::is_ne);
                    let conditions = &self.problem.premises.conditions;
                    let allowed = conditions.iter().all(|one| one.holds_at(&moved) == Some(true));
                    (differ && allowed && (!claimed || rational(&moved))).then_some(moved)
                })?;
                Some((point, moved))
            });
        let Some((point, at_moved)) = pair else {
            return self.undecided("no identity was found");
        };
        let moved = at_moved[variable].clone();
        let shown = |point: &Point| points::value(expression, point).unwrap_or_default();
        let words = format!(
            "{}{}, and {} with {variable} = {moved}",
            self.place(&point),
            shown(&point),
            shown(&at_moved)
        );
        let pair = [&point, &at_moved].map(|one| self.named(one));
        let values = expression.rational_value(&point).zip(expression.rational_value(&at_moved));
        if !claimed {
            return Finding::failing(words).enclosed_unless(values.is_some()).seen_at(pair);
        }
        let Some((value, changed_value)) = values else {
            return self.undecided("no rational values were found");
        };
        let mut listed: Vec<(Symbol, Expression)> =
            point.iter().map(|(name, value)| (name.clone(), Expression::Number(value.clone()))).collect();
        listed.push((other_value(), Expression::Number(moved)));
        let values = [value, changed_value].map(Expression::Number);
        let certificate =
            Certificate::Difference { left: expression.clone(), right: changed, point: listed, values };
        Finding::from_proof(self.proof.clone().certify(&words, &self.numbers, certificate)).seen_at(pair)
    }
}
