//! What a table or a check may look at.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::experiments::Outcome;
use crate::scene::{ClaimEntry, Kind};
use slipmode_algebra::Refutation;
use slipmode_core::friction::EvolutionLaw;
use slipmode_theory::Equations;
use slipmode_theory::hopf::{self, HopfCoefficient, coefficient};

/// What a table or a check may look at.
#[derive(Debug, Clone)]
pub struct Context<'c> {
    /// The paper's equations as the report states them: the thing under test.
    pub equations: &'c Equations,
    /// What was computed for the report's scenes.
    pub outcome: &'c Outcome,
    /// The claims of the report.
    pub claims: &'c [ClaimEntry],
    /// The kind of the sentence that is decided.
    pub kind: Kind,
    /// Whether each verdict on a formula has to pass the last gate. It does but where equations are altered on purpose: there a
    /// verdict is only compared with another one.
    pub is_gated: bool,
    known: Arc<Mutex<BTreeMap<String, Arc<dyn Any + Send + Sync>>>>,
    hopf: Arc<[OnceLock<Result<HopfCoefficient, Refutation>>; 2]>,
}

impl<'c> Context<'c> {
    /// Nothing is derived from the equations yet.
    pub(crate) fn new(equations: &'c Equations, outcome: &'c Outcome) -> Self {
        let (kind, known, hopf) = (Kind::default(), Arc::default(), Arc::default());
        Self { equations, outcome, claims: &[], kind, is_gated: true, known, hopf }
    }

    /// With the claims of the report, for the tables about them.
    pub(crate) fn with_claims(self, claims: &'c [ClaimEntry]) -> Self {
        Self { claims, ..self }
    }

    /// For a sentence of this kind.
    pub(crate) fn with_kind(&self, kind: Kind) -> Context<'_> {
        Context { kind, ..self.clone() }
    }

    /// Without the last gate.
    pub(crate) fn ungated(self) -> Self {
        Self { is_gated: false, ..self }
    }

    /// The same with some of its equations only.
    pub(crate) fn with_equations<'e>(&'e self, equations: &'e Equations) -> Context<'e> {
        // What was derived once stands for all who may derive it.
        let may_derive = equations.missing(&hopf::EQUATIONS).is_empty();
        let hopf = if may_derive { self.hopf.clone() } else { Arc::default() };
        Context { equations, hopf, ..self.clone() }
    }

    /// What the work gives, done once for a key. The key names everything that the result depends on.
    ///
    /// Nobody waits for another's work, since that could wait for this one: two threads that come at once both do it.
    pub fn once<T: Clone + Send + Sync + 'static>(&self, key: String, work: impl FnOnce() -> T) -> T {
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known().get(&key).and_then(|found| found.downcast_ref::<T>().cloned());
        found.unwrap_or_else(|| {
            let made = work();
            known().insert(key, Arc::new(made.clone()));
            made
        })
    }

    /// The first Lyapunov coefficient. A claim and a table show it; it takes seconds, so it is derived once.
    ///
    /// # Errors
    /// When the equations do not give the stated coefficient.
    pub fn hopf_coefficient(&self, law: EvolutionLaw) -> Result<&HopfCoefficient, Refutation> {
        let derived = &self.hopf[law as usize];
        derived.get_or_init(|| coefficient(&self.equations.in_symbols(), law)).as_ref().map_err(Clone::clone)
    }
}
