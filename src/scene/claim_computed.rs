//! A part of a claim that proofs, other claims or a procedure of this program decide: the keys beside its words.

use std::sync::Arc;

use slipmode_theory::Equations;
use slipmode_theory::stated_proofs::StatedProofs;

use crate::scene::claim_formula::{Computed, Premise};
use crate::scene::claim_library::library_proofs;
use crate::scene::section::{Entries, Entry, Section};

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

/// The entries of such a part.
pub(super) struct ComputedEntries<'t>(Entries<'t>);

/// What a part is read with: the equations and the procedures.
#[derive(Clone, Copy)]
pub(super) struct Known<'k> {
    pub equations: Option<&'k Equations>,
    pub procedures: &'k Procedures,
}

impl<'t> ComputedEntries<'t> {
    pub fn of(section: &mut Section<'t>) -> Self {
        Self(section.entries(&KEYS))
    }

    /// The first key that is there.
    pub fn first(&self) -> Option<&Entry<'t>> {
        self.0.iter().next()
    }

    /// Whether something decides.
    pub fn is_stated(&self) -> bool {
        KEYS[..3].iter().any(|key| self.0.get(key).is_some())
    }

    /// How far something goes.
    pub fn extent(&self) -> Option<String> {
        self.0.text("extent")
    }

    /// Whether nothing is there but how far something goes.
    pub fn is_extent(&self) -> bool {
        self.0.get("extent").is_some() && self.0.iter().count() == 1
    }

    pub fn read(&self, known: &Known<'_>) -> Computed {
        let name = |entry: &Entry<'_>, known: &[&'static str]| Some(entry.word(known, |one| one)?.to_owned());
        let check = self.0.get("check").and_then(|entry| name(entry, &known.procedures.checks));
        let shows = self.0.get("shows");
        let shows = shows.and_then(|entry| entry.list(|member| name(member, &known.procedures.shows)));
        let proofs = self.0.texts("proofs");
        // What they say is put in when all claims of the file are read.
        let premise = |id| Premise { id, stated: Arc::default(), decided_for: None };
        Computed {
            check,
            of: self.0.texts("of"),
            equations: self.0.texts("equations"),
            stated: self.stated(&proofs, known.equations).unwrap_or_default(),
            proofs,
            counter_example: self.0.text("counter_example"),
            premises: self.0.texts("premises").into_iter().map(premise).collect(),
            extent: self.extent(),
            shows: shows.unwrap_or_default(),
        }
    }

    /// The proofs among which those of these ids are.
    fn stated(&self, ids: &[String], equations: Option<&Equations>) -> Option<Arc<StatedProofs>> {
        // The faults of the equations or of the proofs are told already.
        let own = equations?.proofs();
        let has_all = |proofs: &StatedProofs| ids.iter().all(|id| proofs.has(id));
        if let Some(all) = [own, library_proofs()].into_iter().find(|proofs| has_all(proofs)) {
            return Some(all.clone());
        }
        let missing = ids.iter().find(|id| !own.has(id))?;
        let needs = format!("proofs of the report's folder `proofs`: there is no `{missing}`");
        self.0.get("proofs")?.needs(needs)
    }
}

impl Computed {
    /// Whether its proofs are those of the first paper's report: that their steps imply what they say was reviewed with the program.
    pub(crate) fn has_reviewed_proofs(&self) -> bool {
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
