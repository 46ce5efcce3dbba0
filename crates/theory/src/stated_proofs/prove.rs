//! Stated proofs carried out on equations, and which of the equations they reach.

use std::collections::BTreeSet;

use super::names::Named;
use super::{DEEPEST, DomainForm, NONE, StatedProof, StatedProofs, StepForm, lemmas, names};
use crate::{Equation, Equations};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, within_budget};

/// The most steps of algebra that one step of a proof takes: as many as the decision of a formula.
const STEPS: u64 = 6_000_000;

/// What a part of a proof gives, if it takes no more steps than allowed.
fn limited<T>(id: &str, says: &str, work: impl FnOnce() -> Result<T, Refutation>) -> Result<T, Refutation> {
    let found = within_budget(STEPS, work);
    found.unwrap_or_else(|large| Err(Proof::new(id, "").refute(says, &[], large.to_string())))
}

impl StatedProofs {
    /// Carries out a proof on these equations.
    ///
    /// # Errors
    /// The first step that does not hold.
    pub fn prove(&self, id: &str, equations: &Equations) -> Result<Proof, Refutation> {
        self.proved(id, &equations.iter().collect::<Vec<_>>())
    }

    pub(super) fn proved(&self, id: &str, equations: &[&Equation]) -> Result<Proof, Refutation> {
        let Some(stated) = self.proofs.get(id) else {
            return Err(Proof::new(id, "").refute("a proof that is stated", &[], "there is no such proof"));
        };
        let proof = Proof::new(id, "");
        let named = Named::new(self, stated, equations);
        let filled = || named.filled(&stated.says).map_err(|reason| proof.refute(&stated.says, &[], reason));
        let says = limited(id, &stated.says, filled)?;
        self.add_steps(Proof::new(id, says), stated, equations, 0)
    }

    pub(super) fn add_steps(
        &self,
        proof: Proof,
        stated: &StatedProof,
        equations: &[&Equation],
        depth: usize,
    ) -> Result<Proof, Refutation> {
        let named = Named::new(self, stated, equations);
        stated.steps.iter().try_fold(proof, |proof, step| {
            let id = proof.id.clone();
            let Some(name) = step.refers_to() else {
                return limited(&id, &step.says, || step.add(proof, &named));
            };
            if depth == DEEPEST {
                return Err(proof.refute(&step.says, &[], "lemmas stand too deep in each other"));
            }
            match self.blocks.get(name) {
                Some(block) => self.add_steps(proof, block, equations, depth + 1),
                None if self.has(name) => Ok(proof.using(self.proved(name, equations)?)),
                None if name == lemmas::FOR_REPORTS => lemmas::add_block(proof, name),
                None => Err(proof.refute(&step.says, &[], "there is no such lemma")),
            }
        })
    }

    /// The domain of this name, with the meanings of the names in it.
    pub(super) fn domain(&self, name: &str, named: &Named<'_>) -> Result<Domain, String> {
        match self.domains.get(name) {
            _ if name.is_empty() || name == NONE => Ok(Domain::default()),
            Some(form) => form.add_to(self.domain(&form.of, named)?, named),
            None => Err(format!("there is no domain `{name}`")),
        }
    }

    /// The numbers of the equations that a proof reaches, in the order of the file.
    #[must_use]
    pub fn reached<'e>(&self, id: &str, equations: &'e Equations) -> Vec<&'e str> {
        let sides = self.sides(id);
        let is_reached = |equation: &&Equation| equation.sides().iter().any(|(name, _)| sides.contains(name));
        equations.iter().filter(is_reached).map(|equation| equation.number.as_str()).collect()
    }

    /// What a proof names and the file does not have: a sentence for each.
    #[must_use]
    pub fn missing(&self, id: &str, equations: &Equations) -> Vec<String> {
        let known: BTreeSet<String> =
            equations.iter().flat_map(Equation::sides).map(|(name, _)| name).collect();
        let missing = &self.sides(id) - &known;
        missing.into_iter().map(|side| format!("there is no equation for the name `{side}`")).collect()
    }

    /// The names of sides of equations that a proof rests on.
    fn sides(&self, id: &str) -> BTreeSet<String> {
        let mut sides = BTreeSet::new();
        self.proofs.get(id).into_iter().for_each(|proof| self.sides_of(proof, 0, &mut sides));
        sides
    }

    /// The sides of equations that a proof names, by its steps, their domains, and what both refer to.
    fn sides_of(&self, proof: &StatedProof, depth: usize, sides: &mut BTreeSet<String>) {
        let steps = proof.steps.iter();
        for inner in steps.clone().filter_map(StepForm::refers_to).filter(|_| depth < DEEPEST) {
            self.named(inner).into_iter().for_each(|inner| self.sides_of(inner, depth + 1, sides));
        }
        let of_steps = steps.clone().flat_map(StepForm::names);
        let over = steps.flat_map(|step| [step.over.as_str(), step.besides.of.as_str()]);
        let mut over: Vec<&str> = over.chain([proof.over.as_str()]).collect();
        let mut domains = BTreeSet::new();
        while let Some(name) = over.pop() {
            if domains.insert(name) {
                over.extend(self.domains.get(name).map(|domain| domain.of.as_str()));
            }
        }
        let values = domains.iter().filter_map(|name| self.domains.get(*name)).flat_map(DomainForm::values);
        let of_domains = values.flat_map(Expression::variables);
        let open = of_steps.chain(of_domains).map(|name| name.to_string()).collect();
        sides.extend(self.sides_behind(open, proof));
    }

    /// The sides of equations behind some names of a proof.
    pub(super) fn sides_behind(&self, names: Vec<String>, proof: &StatedProof) -> BTreeSet<String> {
        let (mut open, mut seen, mut sides) = (names, BTreeSet::new(), BTreeSet::new());
        while let Some(name) = open.pop() {
            if !seen.insert(name.clone()) {
                continue;
            }
            match proof.names.get(&name).or_else(|| self.names.get(&name)) {
                Some(form) => open.extend(form.names().iter().map(ToString::to_string)),
                None if names::is_side(&name) => _ = sides.insert(name),
                None => {}
            }
        }
        sides
    }
}
