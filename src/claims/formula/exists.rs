//! Formulas that are true for a value of some variables, for all values of the others.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Certificate, Expression, Literal, Proof, Sign, SignFormula, Symbol};

use super::Problem;
use super::lowering::Lowered;
use super::points::{self, Point, Points};
use super::prover::Prover;
use super::truth::found;
use crate::claims::Finding;
use crate::scene::Premises;

/// At how many values of the other variables a refutation is sought.
const PLACES: usize = 8;

impl Problem<'_> {
    /// The finding on: for all values of the other variables there are values of the listed ones, with which the formula is true.
    pub(super) fn there_is(&self, lowered: &Lowered) -> Finding {
        let listed: BTreeSet<Symbol> =
            self.formula.scope.there_is.iter().map(|name| Symbol::new(name)).collect();
        let is_own = |literal: &&Literal| !literal.expression.variables().is_disjoint(&listed);
        let (own, rest): (Vec<Literal>, Vec<Literal>) =
            self.premises.conditions.iter().cloned().partition(|literal| is_own(&literal));
        let positive = listed.iter().filter(|name| self.premises.positive.contains(*name));
        let positive = positive.map(|name| Literal::new(Expression::Variable(name.clone()), Sign::Positive));
        let wanted = positive.chain(own.clone()).map(SignFormula::Literal).chain([lowered.signs.clone()]);
        let wanted = SignFormula::All(wanted.collect());
        let outer = Premises {
            positive: &self.premises.positive - &listed,
            conditions: rest,
            ..self.premises.clone()
        };
        let expressions = lowered.expressions();
        let points = self.points(&expressions);
        let prover = Prover::new(&points);
        let others = expressions.iter().flat_map(Expression::variables).filter(|name| !listed.contains(name));
        let alone = others.count() == 0 && outer.conditions.is_empty();
        let mut tried = Vec::new();
        if !self.formula.scope.witness.is_empty() {
            match self.by_witness(lowered, &wanted, &outer, &prover) {
                Ok(proof) => return Finding::from_proof(Ok(proof)),
                Err(reason) => tried.push(format!("the witness is not proved: {reason}")),
            }
        }
        if alone && let Some(point) = found(&points, &self.premises.conditions, &lowered.signs, Points::MOST)
        {
            return self.at_point(lowered, &point);
        }
        let none = self.nowhere(lowered, &outer, &own, &points, alone);
        none.unwrap_or_else(|| {
            tried.push(if alone {
                format!("none of {} points does, and no certificate excludes all", Points::MOST)
            } else {
                format!("no certificate excludes all at {PLACES} values of the other variables")
            });
            Finding::not_checked(format!("Not decided: {}.", tried.join("; ")))
        })
    }

    /// The witness in the place of the listed variables, for all values of the others.
    fn by_witness(
        &self,
        lowered: &Lowered,
        wanted: &SignFormula,
        outer: &Premises,
        prover: &Prover<'_>,
    ) -> Result<Proof, String> {
        let witness = self.formula.scope.witness.iter();
        let values: BTreeMap<Symbol, Expression> =
            witness.map(|(name, value)| (Symbol::new(name), self.put_in(value))).collect();
        let signs = wanted.map(&|expression| expression.substitute(&values));
        let domain = prover.domain(&self.premises, &[]).ok_or("no point meets the conditions")?;
        let start = self.with_lemmas(self.start(prover)?, lowered, &domain)?;
        let points =
            self.points_under(outer, signs.literals().into_iter().map(|literal| &literal.expression));
        let found = self.with_signs(start, &signs, outer, &Prover::new(&points));
        found.map_err(|reason| match found_false(&points, outer, &signs) {
            Some(point) => format!("it does not do at {}", points::text(&point)),
            None => reason,
        })
    }

    /// The values of all expressions at a point.
    fn at_point(&self, lowered: &Lowered, point: &Point) -> Finding {
        let listed: Vec<(String, Expression)> =
            point.iter().map(|(name, value)| (name.to_string(), Expression::Number(value.clone()))).collect();
        let prover_points = self.points(&lowered.expressions());
        let prover = Prover::new(&prover_points);
        let start = self.start(&prover).and_then(|start| {
            let domain = prover.domain(&self.premises, &[]).unwrap_or_default();
            self.with_lemmas(start, lowered, &domain)
        });
        let start = match start {
            Ok(start) => start,
            Err(reason) => return Finding::not_checked(format!("Not decided: {reason}.")),
        };
        let literals = self.premises.conditions.iter().chain(lowered.signs.literals());
        let proof = literals.filter(|literal| points::meets(literal, point) == Some(true)).try_fold(
            start,
            |proof, literal| {
                let value = literal.expression.rational_value(point).unwrap_or_default();
                let certificate = Certificate::Value {
                    expression: literal.expression.clone(),
                    point: listed.clone(),
                    value: Expression::Number(value),
                };
                proof.certify(&format!("true at {}", points::text(point)), &self.numbers(), certificate)
            },
        );
        Finding::from_proof(proof)
    }

    /// A certificate that the formula is false for all values of the listed variables, at some values of the others.
    fn nowhere(
        &self,
        lowered: &Lowered,
        outer: &Premises,
        own: &[Literal],
        points: &Points,
        alone: bool,
    ) -> Option<Finding> {
        let places: Vec<Point> =
            if alone { vec![Point::new()] } else { points.meeting(&outer.conditions, PLACES).collect() };
        let listed = |name: &Symbol| self.formula.scope.there_is.iter().any(|one| one == name.as_str());
        places.into_iter().find_map(|place| {
            let place: Point = place.into_iter().filter(|(name, _)| !listed(name)).collect();
            let values = super::expressions(&place);
            let put_in = |expression: &Expression| expression.substitute(&values);
            let conditions = own.iter().map(|one| Literal::new(put_in(&one.expression), one.sign)).collect();
            let positive = self.premises.positive.iter().filter(|name| listed(name)).cloned().collect();
            let inner = Premises { positive, conditions, ..self.premises.clone() };
            let never = lowered.signs.negated().map(&put_in);
            let points =
                self.points_under(&inner, never.literals().into_iter().map(|literal| &literal.expression));
            let prover = Prover::new(&points);
            let domain = prover.domain(&inner, &[])?;
            let start = self.with_lemmas(self.start(&prover).ok()?, lowered, &domain).ok()?;
            let proof = self.with_signs(start, &never, &inner, &prover).ok()?;
            let words = if alone {
                "there is none".to_owned()
            } else {
                format!("at {}: there is none", points::text(&place))
            };
            Some(Finding::from_disproof(Ok(proof), &words))
        })
    }
}

/// A point that meets the premises and at which signs are false.
fn found_false(points: &Points, premises: &Premises, signs: &SignFormula) -> Option<Point> {
    found(points, &premises.conditions, &signs.negated(), Points::MOST)
}
