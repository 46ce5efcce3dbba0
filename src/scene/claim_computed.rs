//! A part of a claim that proofs, other claims or a procedure of this program decide: the keys beside its words.

use std::sync::Arc;

use slipmode_core::theory::Equations;
use slipmode_core::theory::stated_proofs::StatedProofs;

use crate::scene::claim_library::library_proofs;
use crate::scene::claim_list::StatedClaim;
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

/// What decides a part that is no formula.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Computed {
    /// The procedure.
    pub check: Option<String>,
    /// What the procedure is asked about, where it knows several things.
    pub of: Vec<String>,
    /// The equations that the procedure may use, by their numbers: it is given no others.
    pub equations: Vec<String>,
    /// The proofs that have to go through, by their names.
    pub proofs: Vec<String>,
    /// Where the proofs refute the part, what they show.
    pub counter_example: Option<String>,
    /// The claims that have to hold.
    pub premises: Vec<Premise>,
    /// How far it goes, in words.
    pub extent: Option<String>,
    /// The procedures that compute evidence beside it.
    pub shows: Vec<String>,
    /// The proofs as they are stated.
    pub stated: Arc<StatedProofs>,
}

/// A claim that has to hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Premise {
    /// Its id.
    pub id: String,
    /// What it says.
    pub stated: Arc<StatedClaim>,
}

/// The entries of such a part.
pub(super) struct ComputedEntries<'t> {
    check: Option<Entry<'t>>,
    proofs: Option<Entry<'t>>,
    premises: Option<Entry<'t>>,
    of: Option<Entry<'t>>,
    equations: Option<Entry<'t>>,
    counter_example: Option<Entry<'t>>,
    extent: Option<Entry<'t>>,
    shows: Option<Entry<'t>>,
}

/// What a part is read with: the equations and the procedures.
#[derive(Clone, Copy)]
pub(super) struct Known<'k> {
    pub equations: Option<&'k Equations>,
    pub procedures: &'k Procedures,
}

impl<'t> ComputedEntries<'t> {
    pub fn of(section: &mut Section<'t>) -> Self {
        let [check, proofs, premises, of, equations, counter_example, extent, shows] =
            ["check", "proofs", "premises", "of", "equations", "counter_example", "extent", "shows"]
                .map(|key| section.optional(key));
        Self { check, proofs, premises, of, equations, counter_example, extent, shows }
    }

    /// The first key that is there.
    pub fn first(&self) -> Option<&Entry<'t>> {
        let besides = [&self.of, &self.equations, &self.counter_example, &self.extent, &self.shows];
        [&self.check, &self.proofs, &self.premises].into_iter().chain(besides).flatten().next()
    }

    /// Whether something decides.
    pub fn is_stated(&self) -> bool {
        self.check.is_some() || self.proofs.is_some() || self.premises.is_some()
    }

    pub fn read(&self, known: &Known<'_>) -> Option<Computed> {
        fn texts(entry: &Option<Entry<'_>>) -> Option<Vec<String>> {
            entry.as_ref().map_or(Some(Vec::new()), |entry| entry.list(Entry::text))
        }
        fn text(entry: &Option<Entry<'_>>) -> Option<Option<String>> {
            entry.as_ref().map_or(Some(None), |entry| entry.text().map(Some))
        }
        let check = self.check.as_ref().map_or(Some(None), |entry| {
            let name = entry.text()?;
            entry.sound(of_word(&name, &known.procedures.checks, |known| known))?;
            Some(Some(name))
        });
        let shows = self.shows.as_ref().map_or(Some(Vec::new()), |entry| {
            entry.list(|member| {
                let name = member.text()?;
                member.sound(of_word(&name, &known.procedures.shows, |known| known))?;
                Some(name)
            })
        });
        let own = known.equations.map(Equations::proofs);
        let proofs = texts(&self.proofs);
        let all = |proofs: &StatedProofs, ids: &[String]| ids.iter().all(|id| proofs.has(id));
        let stated = proofs.as_ref().and_then(|ids| match own {
            Some(own) if all(own, ids) => Some(own.clone()),
            // The faults of the equations or of the proofs are told already.
            None => Some(Arc::default()),
            _ if all(library_proofs(), ids) => Some(library_proofs().clone()),
            _ => {
                let missing = ids.iter().find(|id| !own.is_some_and(|own| own.has(id)))?;
                self.proofs.as_ref()?.refuse(Problem::Needs(format!(
                    "proofs of the report's folder `proofs`: there is no `{missing}`"
                )))
            }
        });
        let premises = texts(&self.premises).map(|ids| {
            // What they say is put in when all claims of the file are read.
            ids.into_iter().map(|id| Premise { id, stated: Arc::default() }).collect()
        });
        let (of, equations) = (texts(&self.of), texts(&self.equations));
        let (counter_example, extent) = (text(&self.counter_example), text(&self.extent));
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
    /// Whether a procedure or a proof of the first paper's report decides it: both take that paper's equations.
    #[must_use]
    pub fn needs_the_paper(&self) -> bool {
        self.check.is_some() || !self.proofs.is_empty() && self.has_reviewed_proofs()
    }

    /// Whether its proofs are those of the first paper's report: that their steps imply what they say was reviewed with the program.
    #[must_use]
    pub fn has_reviewed_proofs(&self) -> bool {
        Arc::ptr_eq(&self.stated, library_proofs()) || self.stated == *library_proofs()
    }

    /// What decides it, in a few words.
    pub(super) fn text(&self) -> String {
        let proofs = self.proofs.iter().map(|id| format!("the proof `{id}`"));
        let premises = self.premises.iter().map(|premise| format!("claim {}", premise.id));
        let check = self.check.iter().map(|name| format!("the procedure `{name}`"));
        check.chain(proofs).chain(premises).collect::<Vec<_>>().join(", ")
    }
}
