//! Proofs that a file states: steps with certificates, over expressions that are derived from the equations.
//!
//! In a proof a name stands for itself, but for `left_8`, `right_8` and `residual_8`, which mean the sides of an equation and their
//! difference, and for the names after `let`. How an expression was found is no part of a proof: the steps say what is true of it.

mod domain;
mod names;
mod steps;
mod text;

pub use text::{
    DifferenceText, DomainText, GrowthText, LimitText, ProofText, ProofsText, RootText, StepText, ValueText,
};

use std::collections::{BTreeMap, BTreeSet};

use names::{Form, Named, read_names};
use slipmode_algebra::{Domain, Expression, Proof, Refutation};

use super::{Equation, EquationFault, Equations};
use domain::DomainForm;
use steps::StepForm;

/// The proofs of a folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct StatedProofs {
    names: BTreeMap<String, Form>,
    domains: BTreeMap<String, DomainForm>,
    blocks: BTreeMap<String, StatedProof>,
    proofs: BTreeMap<String, StatedProof>,
}

/// One proof, or a block of steps.
#[derive(Debug, Clone, PartialEq, Eq)]
struct StatedProof {
    says: String,
    over: String,
    names: BTreeMap<String, Form>,
    steps: Vec<StepForm>,
}

/// How deep lemmas and blocks may stand in each other.
const DEEPEST: usize = 8;

impl StatedProofs {
    /// Reads the proofs of the files of a folder, which share their names.
    ///
    /// # Errors
    /// All faults at once.
    pub fn read(files: impl IntoIterator<Item = ProofsText>) -> Result<Self, Vec<EquationFault>> {
        let (mut all, mut faults) = (Self::default(), Faults::default());
        let files: Vec<ProofsText> = files.into_iter().collect();
        for file in &files {
            faults.under("let", |faults| read_names(&file.names, &mut all.names, faults));
            for text in &file.domain {
                faults.under(&format!("domain {}", text.name), |faults| {
                    let read = DomainForm::read(text, faults);
                    faults.once(all.domains.insert(text.name.clone(), read).is_some());
                });
            }
        }
        for file in files {
            for (text, is_block) in
                file.block.iter().map(|one| (one, true)).chain(file.proof.iter().map(|one| (one, false)))
            {
                let kind = if is_block { "block" } else { "proof" };
                faults.under(&format!("{kind} {}", text.id), |faults| {
                    let read = StatedProof::read(text, faults);
                    let known = if is_block { &mut all.blocks } else { &mut all.proofs };
                    faults.once(known.insert(text.id.clone(), read).is_some());
                });
            }
        }
        for (key, proof) in all.blocks.iter().chain(&all.proofs) {
            faults.under(&format!("proof {key}"), |faults| all.check(proof, faults));
        }
        if faults.found.is_empty() { Ok(all) } else { Err(faults.found) }
    }

    /// What refers to something that is not there.
    fn check(&self, proof: &StatedProof, faults: &mut Faults) {
        let own = proof.steps.iter().map(|step| step.over.as_str());
        let base = self.domains.values().map(|domain| domain.of.as_str());
        let wheres = proof.steps.iter().map(|step| step.besides.of.as_str());
        for name in own.chain(base).chain(wheres).chain([proof.over.as_str()]) {
            if !name.is_empty() && name != NONE && !self.domains.contains_key(name) {
                faults.add(format!("there is no domain `{name}`"));
            }
        }
        for name in proof.steps.iter().filter_map(StepForm::refers_to) {
            if !self.blocks.contains_key(name)
                && !self.proofs.contains_key(name)
                && steps::built_in(name).is_none()
            {
                faults.add(format!("there is no block and no proof `{name}`"));
            }
        }
    }

    /// Whether there is a proof of this name.
    #[must_use]
    pub fn has(&self, id: &str) -> bool {
        self.proofs.contains_key(id)
    }

    /// The names of the proofs, in alphabetical order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.proofs.keys().map(String::as_str)
    }

    /// Carries out a proof on these equations.
    ///
    /// # Errors
    /// The first step that does not hold.
    pub fn prove(&self, id: &str, equations: &Equations) -> Result<Proof, Refutation> {
        let Some(stated) = self.proofs.get(id) else {
            return Err(Proof::new(id, "").refute("a proof that is stated", &[], "there is no such proof"));
        };
        let proof = Proof::new(id, "");
        let named = Named::new(self, stated, equations);
        let says = named.filled(&stated.says).map_err(|reason| proof.refute(&stated.says, &[], reason))?;
        self.add_steps(Proof::new(id, says), stated, equations, 0)
    }

    fn add_steps(
        &self,
        proof: Proof,
        stated: &StatedProof,
        equations: &Equations,
        depth: usize,
    ) -> Result<Proof, Refutation> {
        let named = Named::new(self, stated, equations);
        stated.steps.iter().try_fold(proof, |proof, step| {
            let Some(name) = step.refers_to() else { return step.add(proof, &named) };
            if depth == DEEPEST {
                return Err(proof.refute(&step.says, &[], "lemmas stand too deep in each other"));
            }
            match (self.blocks.get(name), self.proofs.contains_key(name), steps::built_in(name)) {
                (Some(block), ..) => self.add_steps(proof, block, equations, depth + 1),
                (None, true, _) => Ok(proof.using(self.prove(name, equations)?)),
                (None, false, Some(lemma)) => lemma(proof),
                (None, false, None) => Err(proof.refute(&step.says, &[], "there is no such lemma")),
            }
        })
    }

    /// The domain of this name, with the meanings of the names in it.
    fn domain(&self, name: &str, named: &Named<'_>) -> Result<Domain, String> {
        match self.domains.get(name) {
            _ if name.is_empty() || name == NONE => Ok(Domain::default()),
            Some(form) => form.add_to(self.domain(&form.of, named)?, named),
            None => Err(format!("there is no domain `{name}`")),
        }
    }

    /// What a proof states, in words.
    #[must_use]
    pub fn says(&self, id: &str) -> &str {
        self.proofs.get(id).map_or("", |proof| &proof.says)
    }

    /// The numbers of the equations that a proof reaches, in the order of the file.
    #[must_use]
    pub fn reached<'e>(&self, id: &str, equations: &'e Equations) -> Vec<&'e str> {
        let mut sides = BTreeSet::new();
        self.proofs.get(id).into_iter().for_each(|proof| self.sides_of(proof, 0, &mut sides));
        let is_reached = |equation: &&Equation| {
            equation.sides().iter().any(|(side, _)| sides.contains(&format!("{side}_{}", equation.word())))
        };
        equations.iter().filter(is_reached).map(|equation| equation.number.as_str()).collect()
    }

    /// What a proof names and the file does not have: a sentence for each.
    #[must_use]
    pub fn missing(&self, id: &str, equations: &Equations) -> Vec<String> {
        let mut sides = BTreeSet::new();
        self.proofs.get(id).into_iter().for_each(|proof| self.sides_of(proof, 0, &mut sides));
        for equation in equations.iter() {
            for (side, _) in equation.sides() {
                sides.remove(&format!("{side}_{}", equation.word()));
            }
        }
        sides.into_iter().map(|side| format!("there is no equation for the name `{side}`")).collect()
    }

    /// The sides of equations that a proof names, by its steps, their domains, and what both refer to.
    fn sides_of(&self, proof: &StatedProof, depth: usize, sides: &mut BTreeSet<String>) {
        let steps = proof.steps.iter();
        for inner in steps.clone().filter_map(StepForm::refers_to).filter(|_| depth < DEEPEST) {
            let inner = self.blocks.get(inner).or_else(|| self.proofs.get(inner));
            inner.into_iter().for_each(|inner| self.sides_of(inner, depth + 1, sides));
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
    fn sides_behind(&self, names: Vec<String>, proof: &StatedProof) -> BTreeSet<String> {
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

/// The domain without assumptions.
const NONE: &str = "none";

impl StatedProof {
    fn read(text: &ProofText, faults: &mut Faults) -> Self {
        let mut names = BTreeMap::new();
        read_names(&text.names, &mut names, faults);
        if text.step.is_empty() {
            faults.add("it has no step".to_owned());
        }
        let steps = text.step.iter().enumerate().map(|(index, step)| {
            faults.under(&format!("step {}", index + 1), |faults| StepForm::read(step, faults))
        });
        let steps = steps.collect();
        Self { says: text.says.clone(), over: text.over.clone(), names, steps }
    }
}

/// All faults of the files, each with its key.
#[derive(Debug, Default)]
struct Faults {
    key: Vec<String>,
    found: Vec<EquationFault>,
}

impl Faults {
    fn under<T>(&mut self, key: &str, read: impl FnOnce(&mut Self) -> T) -> T {
        self.key.push(key.to_owned());
        let read = read(self);
        self.key.pop();
        read
    }

    fn add(&mut self, message: String) {
        self.found.push(EquationFault { key: self.key.join(", "), message });
    }

    fn once(&mut self, is_known: bool) {
        if is_known {
            self.add("occurs twice".to_owned());
        }
    }

    /// The value, where there is one; else its fault is kept.
    fn keep<T>(&mut self, read: Result<T, String>) -> Option<T> {
        read.map_err(|message| self.add(message)).ok()
    }
}

#[cfg(test)]
pub(super) mod tests;
