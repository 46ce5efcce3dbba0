//! Statements on the motions of a system: the hypotheses of a general lemma are certified, its conclusion is argued.

use slipmode_algebra::{Domain, Expression, Literal, Sign, Symbol};
use slipmode_theory::lyapunov_sign::{LyapunovSign, ThreeStates};
use slipmode_theory::planar::MotionLemma;

use super::points::Points;
use super::{Problem, no_point};
use crate::claims::Finding;
use crate::scene::{ClaimMotion, MotionSaid};

/// A statement as the equations say.
enum Said {
    Planar(MotionLemma),
    Lyapunov(ThreeStates, LyapunovSign, Expression),
}

impl Problem<'_> {
    /// A hypothesis that is refused decides nothing: the claim may be true for another reason.
    pub(super) fn motion(&self, motion: &ClaimMotion) -> Finding {
        let Some(system) = self.names.system(&motion.name) else {
            return Finding::not_checked(format!("There is no system {}.", motion.name));
        };
        if let Some(name) = self.bound(&system.state) {
            return Finding::not_checked(format!(
                "A condition contains the state variable {name}, and a motion need not keep to it."
            ));
        }
        let resolved = |expression: &Expression| self.put_in(expression);
        let moving = system.map(resolved);
        let said = match &motion.said {
            MotionSaid::Planar(lemma) => (moving.state.len() == 2).then(|| Said::Planar(lemma.map(resolved))),
            MotionSaid::Lyapunov(lyapunov_sign, frequency) => ThreeStates::of(moving.clone()).map(|system| {
                let lyapunov_sign = match lyapunov_sign {
                    LyapunovSign::Positive => LyapunovSign::Positive,
                    LyapunovSign::Of(sign) => LyapunovSign::Of(resolved(sign)),
                };
                Said::Lyapunov(system, lyapunov_sign, resolved(frequency))
            }),
        };
        let Some(said) = said else {
            return Finding::not_checked(format!("The lemma is not for {} equations.", system.state.len()));
        };
        let region = match &said {
            Said::Planar(lemma) => lemma.region(&moving),
            Said::Lyapunov(..) => None,
        };
        let mut assumed = self.premises.clone();
        assumed.conditions.extend(region.map(|region| Literal::new(region, Sign::Positive)));
        let own = motion.expressions().into_iter().map(|(_, side)| side);
        let sides: Vec<Expression> = own.chain(&system.rates).map(resolved).collect();
        let points = self.points(&sides);
        let example = points.meeting(&assumed.conditions, Points::MOST).next();
        let start = self.start(&self.prover(&points));
        let (Some(example), Ok(start)) = (example, start) else {
            return no_point();
        };
        let with =
            |domain: Domain, (name, value): (Symbol, _)| domain.example(name, Expression::Number(value));
        let domain = example.into_iter().fold(self.premises.domain(), with);
        let domains = domain.forms(&[]);
        let proof = match said {
            Said::Planar(lemma) => lemma.prove(start, &moving, &domains),
            Said::Lyapunov(system, lyapunov_sign, frequency) => {
                system.lyapunov_sign(start, &lyapunov_sign, &frequency, &domains)
            }
        };
        match proof {
            Ok(proof) => Finding::from_proof(Ok(proof)),
            Err(refusal) => Finding::not_checked(format!("The lemma does not apply. {refusal}")),
        }
    }

    /// A state variable of which a condition speaks.
    fn bound<'n>(&self, state: &'n [Symbol]) -> Option<&'n Symbol> {
        let given = self.premises.conditions.iter().flat_map(|literal| literal.expression.variables());
        let solved = self.premises.solved.iter().flat_map(|solved| solved.expression.variables());
        let bound: Vec<Symbol> = given.chain(solved).chain(self.premises.values.keys().cloned()).collect();
        state.iter().find(|name| bound.contains(name))
    }
}
