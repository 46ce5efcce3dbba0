//! Three equations with a pair of roots on the imaginary axis: the sign of the first Lyapunov coefficient.

use crate::System;
use crate::hopf::expansion::{Conditions, in_basis, solve, taylor_part};
use crate::hopf::projection::{Critical, Vector, coefficient};
use crate::notation::{first_success, formula, rational, simplified};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

/// What is said of the first Lyapunov coefficient.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LyapunovSign {
    /// It is positive.
    Positive,
    /// It has the sign of this.
    Of(Expression),
}

/// Three equations of first order with a steady state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ThreeStates(System);

/// The names of the certificates, each with a number behind it: coordinates, components of vectors, unknowns.
const OWN: [&str; 9] = ["distance", "e", "f", "g", "h11", "h20", "imaginary", "p", "real"];

/// The distances of the state variables from the steady state.
const DISTANCES: [&str; 3] = ["distance_1", "distance_2", "distance_3"];

impl ThreeStates {
    /// A system of three equations with a steady state.
    #[must_use]
    pub fn of(system: System) -> Option<Self> {
        let counts = [system.state.len(), system.rates.len(), system.steady.len()];
        (counts == [3; 3]).then_some(Self(system))
    }

    /// Adds to a proof what is said of the steady state although no root has a positive real part: a pair ±i·`frequency` is on the axis,
    /// the third root is negative, and the first Lyapunov coefficient is positive, or has the sign of an expression. `domains` are forms
    /// of one domain.
    ///
    /// # Errors
    /// The hypothesis that is refused.
    pub fn lyapunov_sign(
        &self,
        start: Proof,
        said: &LyapunovSign,
        frequency: &Expression,
        domains: &[Domain],
    ) -> Result<Proof, Refutation> {
        let Some(domain) = domains.first() else {
            return Err(start.refute("the lemma has a domain", &[], "there is none"));
        };
        if let Some(name) = self.own_name(frequency, domain) {
            let remainder = format!("{name} stands for two things: choose another name");
            return Err(start.refute("the lemma has coordinates of its own", &[], remainder));
        }
        let proof = self.rests(start, domain)?;
        let proof = positive(proof, "the frequency of the pair", frequency, domains)?;
        let origin = self.0.state.iter().zip(&self.0.steady).zip(DISTANCES);
        let moved =
            origin.map(|((name, steady), own)| (name.clone(), steady.clone() + formula(own))).collect();
        let rates = [0, 1, 2].map(|n| self.0.rates[n].substitute(&moved));
        let linear = rates.each_ref().map(|rate| taylor_part(rate, &DISTANCES, 1));
        let trace = linear.iter().zip(DISTANCES).map(|(form, name)| form.derivative(&Symbol::from(name)));
        let trace = trace.fold(Expression::integer(0), |sum, part| sum + part);
        let proof =
            positive(proof, "minus the sum of the roots, which is minus the third one,", &-trace, domains)?;
        let transposed = [0, 1, 2].map(|column| {
            let slope = |row: usize| linear[row].derivative(&Symbol::from(DISTANCES[column]));
            (0..3).fold(Expression::integer(0), |sum, row| sum + slope(row) * formula(DISTANCES[row]))
        });
        let eigenvector = |forms: &Vector| eigenvector(&proof, forms, frequency, domain);
        let eigenvectors = [eigenvector(&linear)?, eigenvector(&transposed)?];
        let critical = Critical {
            state: DISTANCES,
            rates,
            names: "the distances from the steady state",
            frequency: frequency.clone(),
            domain: domain.clone(),
            eigenvectors,
            adjoint_says: "p, an eigenvector of the adjoint matrix over its product with q, so that ⟨p, q⟩ = 1",
        };
        let (proof, first) = coefficient(proof, &[], &critical)?;
        let real = simplified(&proof, &[], &first.with("i", &formula("0")), domain)?;
        let imaginary = simplified(&proof, &[], &first.derivative(&Symbol::from("i")), domain)?;
        let parts = real.clone() + formula("i") * imaginary;
        let proof = proof.identity("the real and the imaginary part of c_1", &[], &first, &parts, domain)?;
        let (proof, follows) = match said {
            LyapunovSign::Positive => (positive(proof, "Re c_1", &real, domains)?, OUTWARDS),
            LyapunovSign::Of(sign) => (has_sign_of(proof, &real, sign, domains)?, EITHER_WAY),
        };
        Ok(proof.reason(format!(
            "The third root is negative, so that near the steady state every motion approaches the two-dimensional centre manifold \
             (centre manifold theorem). On it d|w|/dt = Re c_1 |w|³ + O(|w|⁴){follows}"
        )))
    }

    /// A name of the system that the certificates of the lemma use for something of their own.
    fn own_name(&self, frequency: &Expression, domain: &Domain) -> Option<Symbol> {
        let said =
            self.0.rates.iter().chain(&self.0.steady).chain([frequency]).flat_map(Expression::variables);
        let said: Vec<Symbol> = said.chain(domain.symbols()).collect();
        let is_own = |name: &&Symbol| {
            let Some((letters, number)) = name.as_str().rsplit_once('_') else { return false };
            OWN.contains(&letters) && ["1", "2", "3"].contains(&number)
        };
        said.iter().find(is_own).cloned()
    }

    fn rests(&self, proof: Proof, domain: &Domain) -> Result<Proof, Refutation> {
        let at_rest = self.0.map(|rate| self.0.at_rest(rate));
        let says = "the rates at the steady state, by e_1, e_2, e_3";
        proof.identity(says, &[], &in_basis(&at_rest.rates), &Expression::integer(0), domain)
    }
}

const OUTWARDS: &str = ", with Re c_1 > 0: motions spiral outwards. The steady state is unstable and no periodic motion is near it. Where a \
     parameter moves the pair into the stable half-plane with a speed that is not zero, an unstable periodic motion surrounds the steady \
     state (Andronov and Hopf).";

const EITHER_WAY: &str = ". Where Re c_1 > 0 motions spiral outwards: the steady state is unstable, and where a parameter moves the pair into \
     the stable half-plane with a speed that is not zero, an unstable periodic motion surrounds the steady state. Where Re c_1 < 0 they \
     spiral inwards: the steady state attracts what starts near it, and on the unstable side a small stable periodic motion surrounds it \
     (Andronov and Hopf).";

/// The steps that `real` is a positive multiple of `sign`.
fn has_sign_of(
    proof: Proof,
    real: &Expression,
    sign: &Expression,
    domains: &[Domain],
) -> Result<Proof, Refutation> {
    let says = "Re c_1 is a factor times the expression";
    let Some(domain) = domains.first() else { return Err(proof.refute(says, &[], "there is no domain")) };
    let factor = rational(&proof, &[], real, domain)?.checked_div(&rational(&proof, &[], sign, domain)?);
    let Some(factor) = factor else { return Err(proof.refute(says, &[], "the expression is zero")) };
    let factor = Expression::from(&factor);
    let proof = proof.identity(says, &[], real, &(factor.clone() * sign.clone()), domain)?;
    positive(proof, "the factor", &factor, domains)
}

/// The step that an expression is positive, in the first form of the domain in which it is found.
fn positive(
    proof: Proof,
    says: &str,
    expression: &Expression,
    domains: &[Domain],
) -> Result<Proof, Refutation> {
    let says = format!("{says} is positive");
    first_success(domains, |domain| proof.clone().positive(&says, &[], expression, domain))
        .map_err(|refused| refused.unwrap_or_else(|| proof.refute(&says, &[], "there is no domain")))
}

/// A vector v with forms(v) = i·frequency·v and one component 1.
fn eigenvector(
    proof: &Proof,
    forms: &Vector,
    frequency: &Expression,
    domain: &Domain,
) -> Result<Vector, Refutation> {
    let unknowns = ["real_1", "imaginary_1", "real_2", "imaginary_2"];
    let with_one_at = |one: usize| {
        let mut vector = [0, 1, 2].map(|_| formula("1"));
        let pairs = unknowns.chunks(2).map(|pair| formula(&format!("{} + i*{}", pair[0], pair[1])));
        (0..3).filter(|place| *place != one).zip(pairs).for_each(|(place, pair)| vector[place] = pair);
        let values =
            DISTANCES.iter().zip(&vector).map(|(name, part)| (Symbol::from(*name), part.clone())).collect();
        let rest =
            |n: usize| forms[n].substitute(&values) - formula("i") * frequency.clone() * vector[n].clone();
        let vanishing = [0, 1, 2].map(rest);
        let conditions = Conditions { vanishing: &vanishing, identically_in: &["i"], unknowns: &unknowns };
        let found = solve(proof, &[], &conditions, domain.clone())?;
        Ok(vector.map(|part| found.substituted(&part)))
    };
    first_success(0..3, with_one_at)
        .map_err(|refused| refused.unwrap_or_else(|| proof.refute("an eigenvector", &[], "none was tried")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_algebra::Relation;

    /// The slider with mass in the units A = L = V = 1, on K = K_c with B = 1 + w² and M = eta.
    fn slider(law: &str) -> ThreeStates {
        let rates = [
            "w^2*(1 + eta)*(1 - v)".to_owned(),
            "(f - ln(v) - (1 + w^2)*ln(theta))/eta".to_owned(),
            law.to_owned(),
        ];
        three(["f", "v", "theta"], rates.each_ref().map(String::as_str), ["0", "1", "1"])
    }

    fn three(state: [&'static str; 3], rates: [&str; 3], steady: [&str; 3]) -> ThreeStates {
        let [rates, steady] = [rates, steady].map(|texts| texts.map(formula).into());
        ThreeStates(System { name: String::new(), state: state.map(Symbol::from).into(), rates, steady })
    }

    const AGING: &str = "1 - v*theta";

    fn domain(condition: &str, example: &str) -> [Domain; 1] {
        let domain = Domain::positive("eta w v theta").given(formula(condition), Relation::Positive);
        [domain.example("eta", formula(example))]
    }

    #[test]
    fn a_small_mass_makes_the_aging_law_weakly_unstable_and_a_large_one_or_the_slip_law_does_not() {
        // The known coefficient (claim N4 of the report on Im and Avouac) is positive exactly where this is.
        let small = "1 - 6*eta - eta^2*(7 + 4*w^2)";
        let prove_that = |said, system: &ThreeStates, frequency: &str, domain: &[Domain]| {
            system.lyapunov_sign(Proof::new("weak", "Weak."), &said, &formula(frequency), domain)
        };
        let prove = |system: &ThreeStates, frequency: &str, domain: &[Domain]| {
            prove_that(LyapunovSign::Positive, system, frequency, domain)
        };
        let proof = prove(&slider(AGING), "w", &domain(small, "1/100")).unwrap();
        assert_eq!(proof.recheck(), Ok(()));
        let large = domain("eta^2*(7 + 4*w^2) + 6*eta - 1", "1");
        let refused = prove(&slider(AGING), "w", &large).unwrap_err();
        assert!(refused.statement.contains("Re c_1"), "{refused}");
        let everywhere = [Domain::positive("eta w v theta")];
        let sign = |text: &str| LyapunovSign::Of(formula(text));
        let either = prove_that(sign(small), &slider(AGING), "w", &everywhere).unwrap();
        assert_eq!(either.recheck(), Ok(()));
        let refused = prove_that(sign(&format!("-({small})")), &slider(AGING), "w", &everywhere).unwrap_err();
        assert!(refused.statement.contains("the factor"), "{refused}");
        assert!(prove_that(sign("1 - 6*eta"), &slider(AGING), "w", &everywhere).is_err());
        assert!(prove_that(sign("0"), &slider(AGING), "w", &everywhere).is_err());
        let slip = prove(&slider("-v*theta*ln(v*theta)"), "w", &domain(small, "1/100")).unwrap_err();
        assert!(slip.statement.contains("Re c_1"), "{slip}");
        // Another frequency has no eigenvector; another stiffness has no pair on the axis.
        assert!(prove(&slider(AGING), "2*w", &domain(small, "1/100")).is_err());
        let softer = slider(AGING).0.map(|side| side.with("eta", &formula("2*eta")));
        let mut mixed = slider(AGING);
        mixed.0.rates[0] = softer.rates[0].clone();
        assert!(prove(&mixed, "w", &domain(small, "1/100")).is_err());
    }

    #[test]
    fn a_frequency_may_be_a_root() {
        let oscillator = three(["y", "z", "h"], ["z", "(-k*y - q*z^3)/m", "-A*h"], ["0"; 3]);
        let prove = |frequency: &str, sign: &str| {
            let said = LyapunovSign::Of(formula(sign));
            let domains = [Domain::positive("k m A")];
            oscillator.lyapunov_sign(Proof::new("weak", "Weak."), &said, &formula(frequency), &domains)
        };
        for frequency in ["sqrt(k/m)", "sqrt(k)/sqrt(m)"] {
            assert_eq!(prove(frequency, "-q").unwrap().recheck(), Ok(()), "{frequency}");
            assert!(prove(frequency, "q").is_err(), "{frequency}");
        }
        assert!(prove("2*sqrt(k/m)", "-q").is_err());
    }
}
