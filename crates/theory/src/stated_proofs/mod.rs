//! Proofs that a file states: steps with certificates, over expressions that are derived from the equations.
//!
//! In a proof a name stands for itself, but for `left_8`, `right_8` and `residual_8`, which mean the sides of an equation and their
//! difference, and for the names after `let`. How an expression was found is no part of a proof: the steps say what is true of it.

mod domain;
mod lemmas;
mod names;
mod prove;
mod steps;
mod text;

pub(crate) use lemmas::{add_block, lemma, named, stated_domain};
pub use text::{
    DifferenceText, DomainText, GrowthText, LimitText, ProofText, ProofsText, RootText, StepText, ValueText,
};

use std::collections::{BTreeMap, BTreeSet};

use names::{Form, check_names, read_names};

use super::EquationFault;
use super::names::circle;
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
#[derive(Debug, Clone, Default, PartialEq, Eq)]
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
            let kinds = [("block", file.block, &mut all.blocks), ("proof", file.proof, &mut all.proofs)];
            for (kind, texts, known) in kinds {
                for text in texts {
                    faults.under(&format!("{kind} {}", text.id), |faults| {
                        let read = StatedProof::read(&text, faults);
                        faults.once(known.insert(text.id.clone(), read).is_some());
                    });
                }
            }
        }
        for (key, proof) in all.blocks.iter().chain(&all.proofs) {
            faults.under(&format!("proof {key}"), |faults| all.check(proof, faults));
        }
        all.check_circles(&mut faults);
        if faults.found.is_empty() { Ok(all) } else { Err(faults.found) }
    }

    /// The block or the proof that a step of this name stands for.
    fn named(&self, name: &str) -> Option<&StatedProof> {
        self.blocks.get(name).or_else(|| self.proofs.get(name))
    }

    /// Proofs, blocks and domains that rest on themselves, and names that mean themselves.
    fn check_circles(&self, faults: &mut Faults) {
        let blocks = self.blocks.iter().map(|(name, block)| (format!("block {name}"), block));
        let all: Vec<(String, &StatedProof)> =
            blocks.chain(self.proofs.iter().map(|(name, proof)| (format!("proof {name}"), proof))).collect();
        let of_step = |name: &str| {
            let kind = if self.blocks.contains_key(name) { "block" } else { "proof" };
            format!("{kind} {name}")
        };
        let behind =
            |proof: &StatedProof| proof.steps.iter().filter_map(StepForm::refers_to).map(of_step).collect();
        let domains = self.domains.iter().map(|(name, domain)| {
            (format!("domain {name}"), BTreeSet::from([format!("domain {}", domain.of)]))
        });
        let uses: BTreeMap<String, BTreeSet<String>> =
            all.iter().map(|(key, proof)| (key.clone(), behind(proof))).chain(domains).collect();
        for key in uses.keys() {
            if let Some(way) = circle(key, &uses) {
                faults.under(key, |faults| faults.add(format!("it rests on itself: {}", way.join(" -> "))));
            }
        }
        let told = faults.found.len();
        faults.under("let", |faults| check_names(&self.names, faults));
        if faults.found.len() > told {
            return;
        }
        for (key, proof) in &all {
            let mut names = self.names.clone();
            names.extend(proof.names.clone());
            faults.under(key, |faults| check_names(&names, faults));
        }
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
            if self.named(name).is_none() && name != lemmas::FOR_REPORTS {
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

    /// What a proof states, in words.
    #[must_use]
    pub fn says(&self, id: &str) -> &str {
        self.proofs.get(id).map_or("", |proof| &proof.says)
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
