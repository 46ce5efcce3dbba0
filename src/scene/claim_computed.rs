//! A part of a claim that proofs, other claims or a procedure of this program decide: the keys beside its words.

use std::collections::BTreeMap;
use std::sync::Arc;

use slipmode_core::theory::Equations;
use slipmode_core::theory::stated_proofs::StatedProofs;

use crate::scene::claim_formula::{Computed, Premise};
use crate::scene::claim_library::library_proofs;
use crate::scene::section::{Entry, Section};
use crate::scene::{Problem, of_word};

/// The procedures of this program that a claim may name.
#[derive(Debug, Clone, Default)]
pub struct Procedures {
    /// Those that decide.
    pub checks: Vec<&'static str>,
    /// Those that compute evidence beside what decides.
    pub shows: Vec<&'static str>,
}

/// The keys of such a part; the first three decide.
const KEYS: [&str; 8] =
    ["check", "proofs", "premises", "of", "equations", "counter_example", "extent", "shows"];

/// The entries of such a part, by their keys.
pub(super) struct ComputedEntries<'t>(BTreeMap<&'static str, Entry<'t>>);

/// What a part is read with: the equations and the procedures.
#[derive(Clone, Copy)]
pub(super) struct Known<'k> {
    pub equations: Option<&'k Equations>,
    pub procedures: &'k Procedures,
}

impl<'t> ComputedEntries<'t> {
    pub fn of(section: &mut Section<'t>) -> Self {
        Self(KEYS.into_iter().filter_map(|key| Some((key, section.optional(key)?))).collect())
    }

    /// The first key that is there.
    pub fn first(&self) -> Option<&Entry<'t>> {
        KEYS.into_iter().find_map(|key| self.0.get(key))
    }

    /// Whether something decides.
    pub fn is_stated(&self) -> bool {
        KEYS[..3].iter().any(|key| self.0.contains_key(key))
    }

    pub fn text(&self, key: &str) -> Option<Option<String>> {
        self.0.get(key).map_or(Some(None), |entry| entry.text().map(Some))
    }

    /// Whether nothing is there but how far something goes.
    pub fn is_extent(&self) -> bool {
        self.0.keys().eq(["extent"].iter())
    }

    fn texts(&self, key: &str) -> Option<Vec<String>> {
        self.0.get(key).map_or(Some(Vec::new()), |entry| entry.list(Entry::text))
    }

    pub fn read(&self, known: &Known<'_>) -> Option<Computed> {
        let name = |entry: &Entry<'_>, known: &[&'static str]| {
            let name = entry.text()?;
            entry.sound(of_word(&name, known, |known| known))?;
            Some(name)
        };
        let check =
            self.0.get("check").map_or(Some(None), |entry| name(entry, &known.procedures.checks).map(Some));
        let shows = self
            .0
            .get("shows")
            .map_or(Some(Vec::new()), |entry| entry.list(|member| name(member, &known.procedures.shows)));
        let own = known.equations.map(Equations::proofs);
        let proofs = self.texts("proofs");
        let all = |proofs: &StatedProofs, ids: &[String]| ids.iter().all(|id| proofs.has(id));
        let stated = proofs.as_ref().and_then(|ids| match own {
            Some(own) if all(own, ids) => Some(own.clone()),
            // The faults of the equations or of the proofs are told already.
            None => Some(Arc::default()),
            _ if all(library_proofs(), ids) => Some(library_proofs().clone()),
            _ => {
                let missing = ids.iter().find(|id| !own.is_some_and(|own| own.has(id)))?;
                self.0.get("proofs")?.refuse(Problem::Needs(format!(
                    "proofs of the report's folder `proofs`: there is no `{missing}`"
                )))
            }
        });
        let premises = self.texts("premises").map(|ids| {
            // What they say is put in when all claims of the file are read.
            ids.into_iter().map(|id| Premise { id, stated: Arc::default() }).collect()
        });
        let [of, equations] = ["of", "equations"].map(|key| self.texts(key));
        let [counter_example, extent] = ["counter_example", "extent"].map(|key| self.text(key));
        Some(Computed {
            check: check?,
            of: of?,
            equations: equations?,
            proofs: proofs?,
            counter_example: counter_example?,
            premises: premises?,
            extent: extent?,
            shows: shows?,
            stated: stated?,
        })
    }
}

impl Computed {
    /// Whether its proofs are those of the first paper's report: that their steps imply what they say was reviewed with the program.
    #[must_use]
    pub fn has_reviewed_proofs(&self) -> bool {
        Arc::ptr_eq(&self.stated, library_proofs())
    }

    /// What decides it, in a few words.
    pub(super) fn text(&self) -> String {
        let proofs = self.proofs.iter().map(|id| format!("the proof `{id}`"));
        let premises = self.premises.iter().map(|premise| format!("claim {}", premise.id));
        let check = self.check.iter().map(|name| format!("the procedure `{name}`"));
        check.chain(proofs).chain(premises).collect::<Vec<_>>().join(", ")
    }
}
