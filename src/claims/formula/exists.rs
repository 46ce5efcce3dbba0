//! Formulas that are true for a value of some variables, for all values of the others.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Certificate, Expression, Literal, Proof, Sign, SignFormula, Symbol, unknowns};
use slipmode_core::number::Rational;

use super::Problem;
use super::lowering::Lowered;
use super::points::{self, Point, Points};
use super::prover::Prover;
use super::truth::found;
use crate::claims::Finding;
use crate::scene::Premises;

/// At how many values of the other variables a refutation is sought.
const PLACES: usize = 64;

/// At how many of them a certificate is sought.
const MOST_PROOFS: usize = 8;

/// How many values of the listed variables are tried at each.
const VALUES: usize = 64;

impl Problem<'_> {
    /// The finding on: for all values of the other variables there are values of the listed ones that meet what is assumed of them, with
    /// which the formula is true. A variable that only a condition names is one of the others.
    pub(super) fn there_is(&self, lowered: &Lowered) -> Finding {
        let listed: BTreeSet<Symbol> = self.formula.scope.there_is.iter().cloned().collect();
        let positive = listed.iter().filter(|name| self.premises.positive.contains(*name));
        let positive = positive.map(|name| Literal::new(Expression::Variable(name.clone()), Sign::Positive));
        let own: Vec<Literal> = positive.chain(self.premises.wanted.iter().cloned()).collect();
        let wanted = own.iter().cloned().map(SignFormula::Literal).chain([lowered.signs.clone()]);
        let wanted = SignFormula::All(wanted.collect());
        let outer = Premises { positive: &self.premises.positive - &listed, ..self.premises.clone() };
        let expressions: Vec<Expression> =
            wanted.literals().into_iter().map(|literal| literal.expression.clone()).collect();
        let points = self.points(&expressions);
        let prover = self.prover(&points);
        let mut others = unknowns(&expressions).into_iter().filter(|name| !listed.contains(name));
        let alone = others.next().is_none() && outer.conditions.is_empty();
        let mut tried = Vec::new();
        if !self.formula.scope.witness.is_empty() {
            match self.by_witness(lowered, &wanted, &outer, &prover) {
                Ok(proof) => return Finding::from_proof(Ok(proof)),
                Err(reason) => tried.push(format!("the witness is not proved: {reason}")),
            }
        }
        let found = if alone && let Some(point) = found(&points, &[], &wanted, Points::MOST) {
            Some(self.at_point(&wanted, lowered, &point))
        } else {
            self.nowhere(lowered, &wanted, &outer, &points, alone)
        };
        match found {
            Some(found) => tried.iter().fold(found, |found, tried| found.remark(capital(tried))),
            None => {
                tried.push(if alone {
                    format!("none of {} points does, and no certificate excludes all", Points::MOST)
                } else {
                    format!("no certificate excludes all at {PLACES} values of the other variables")
                });
                Finding::not_checked(format!("Not decided: {}.", tried.join("; ")))
            }
        }
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
            witness.map(|(name, value)| (name.clone(), self.put_in(value))).collect();
        let signs = wanted.map(&|expression| expression.substitute(&values));
        let domain = prover.domain(&self.premises, &[]).ok_or("no point meets the conditions")?;
        let start = self.with_lemmas(self.start(prover)?, lowered, &domain)?;
        let points =
            self.points_under(outer, signs.literals().into_iter().map(|literal| &literal.expression));
        let proved = self.with_signs(start, &signs, outer, &self.prover(&points));
        let false_at = || found(&points, &outer.conditions, &signs.negated(), Points::MOST);
        proved.map_err(|reason| match false_at() {
            Some(point) => format!("it does not do at {}", points::text(&point)),
            None => reason,
        })
    }

    /// The finding that the formula is true at a point.
    fn at_point(&self, wanted: &SignFormula, lowered: &Lowered, point: &Point) -> Finding {
        match self.values_at(point, wanted, lowered) {
            Some(Ok(proof)) => Finding::from_proof(Ok(proof)).seen_at([points::named(&self.full(point))]),
            Some(Err(reason)) => Finding::not_checked(format!("Not decided: {reason}.")),
            // A certificate states a rational value. Of another one the sign is known by an enclosure.
            None => self.true_at(lowered, point),
        }
    }

    /// The proof that signs are true at a point: the values of their expressions there. None where one is not rational.
    pub(super) fn values_at(
        &self,
        point: &Point,
        signs: &SignFormula,
        lowered: &Lowered,
    ) -> Option<Result<Proof, String>> {
        let met = signs.literals().into_iter().filter(|literal| literal.holds_at(point) == Some(true));
        let value = |literal: &Literal| literal.expression.rational_value(point);
        let mut met: Vec<(&Literal, Rational)> =
            met.map(|literal| Some((literal, value(literal)?))).collect::<Option<_>>()?;
        let mut known: Vec<&Expression> = Vec::new();
        met.retain(|(literal, _)| {
            let is_new = !known.contains(&&literal.expression);
            known.push(&literal.expression);
            is_new
        });
        let listed: Vec<(Symbol, Expression)> =
            point.iter().map(|(name, value)| (name.clone(), Expression::Number(value.clone()))).collect();
        let prover_points = self.points(&lowered.expressions());
        let prover = self.prover(&prover_points);
        let start = self.start(&prover).and_then(|start| {
            let domain = prover.domain(&self.premises, &[]).unwrap_or_default();
            self.with_lemmas(start, lowered, &domain)
        });
        let says = format!("true at {}", points::text(point));
        let step = |proof: Proof, (literal, value): (&Literal, Rational)| {
            let (expression, point) = (literal.expression.clone(), listed.clone());
            let certificate = Certificate::Value { expression, point, value: Expression::Number(value) };
            proof.certify(&says, &self.numbers(), certificate).map_err(|error| error.to_string())
        };
        Some(start.and_then(|start| met.into_iter().try_fold(start, step)))
    }

    /// A certificate that no values of the listed variables do, at some values of the other ones.
    fn nowhere(
        &self,
        lowered: &Lowered,
        wanted: &SignFormula,
        outer: &Premises,
        points: &Points,
        alone: bool,
    ) -> Option<Finding> {
        let places: Vec<Point> =
            if alone { vec![Point::new()] } else { points.meeting(&outer.conditions, PLACES).collect() };
        let listed = &self.formula.scope.there_is;
        let positive: BTreeSet<Symbol> =
            self.premises.positive.iter().filter(|name| listed.contains(name)).cloned().collect();
        let inner =
            Premises { positive, conditions: Vec::new(), wanted: Vec::new(), ..self.premises.clone() };
        let open = places.into_iter().filter_map(|place| {
            let place: Point = place.into_iter().filter(|(name, _)| !listed.contains(name)).collect();
            let there = wanted.map(&|expression| expression.at_point(&place));
            let points =
                self.points_under(&inner, there.literals().into_iter().map(|literal| &literal.expression));
            let does = alone || found(&points, &[], &there, VALUES).is_none();
            does.then_some((place, there, points))
        });
        open.take(MOST_PROOFS).find_map(|(place, there, points)| {
            let prover = self.prover(&points);
            let domain = prover.domain(&inner, &[])?;
            let start = self.with_lemmas(self.start(&prover).ok()?, lowered, &domain).ok()?;
            let proof = self.with_signs(start, &there.negated(), &inner, &prover).ok()?;
            let words = if alone {
                "there is none".to_owned()
            } else {
                format!("at {}: there is none", points::text(&place))
            };
            Some(Finding::from_disproof(Ok(proof), &words).seen_at([points::named(&self.full(&place))]))
        })
    }
}

/// A sentence that begins with a capital letter.
fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters
        .next()
        .map_or_else(String::new, |first| format!("{}{}.", first.to_uppercase(), characters.as_str()))
}
