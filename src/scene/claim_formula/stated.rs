//! What a claim states: the ways to read it, their parts, and what decides a part that is no formula.

use std::sync::Arc;

/// What a claim says as formulas, and what else decides it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct StatedClaim {
    /// What has to be found for it to hold, where that is more than formulas.
    pub criterion: Option<String>,
    /// What of the words the formulas leave out.
    pub leaves_out: String,
    /// The step from the formulas to the words, where it is argued: the words are about more than the formulas.
    pub argued: Option<String>,
    /// What a reader should know besides.
    pub remarks: Vec<String>,
    /// The ways to read the claim; the first is the claim as it is written, and decides.
    pub readings: Vec<StatedReading>,
}

impl StatedClaim {
    pub(in crate::scene) fn premises_mut(&mut self) -> impl Iterator<Item = &mut Premise> {
        let parts = self.readings.iter_mut().flat_map(|reading| &mut reading.parts);
        parts.flat_map(|(_, formula)| formula.premises_mut())
    }

    /// All parts of all readings, in order.
    pub fn parts(&self) -> impl Iterator<Item = &(String, super::ClaimFormula)> {
        self.readings.iter().flat_map(|reading| &reading.parts)
    }
}

/// One way to read a claim: formulas, all of which have to be true.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StatedReading {
    /// What the claim says in this reading.
    pub words: String,
    /// The formulas with their words.
    pub parts: Vec<(String, super::ClaimFormula)>,
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
    pub stated: Arc<slipmode_theory::stated_proofs::StatedProofs>,
}

/// A claim that has to hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Premise {
    /// Its id.
    pub id: String,
    /// What it says.
    pub stated: Arc<StatedClaim>,
    /// What its sentence is decided for, where that is about more.
    pub decided_for: Option<String>,
}
