//! Parts of claims that proofs, other claims or a procedure of this program decide.

use super::{Check, Finding, Show, Verdict, checks, formula, shows};
use crate::experiments::{Context, Need};
use crate::scene::{Computed, Procedures};

/// What a procedure is asked, besides the equations and the outcome.
pub(super) struct Asked<'c> {
    /// What it is asked about.
    pub of: &'c [String],
    /// What proofs and premises beside it found; none where there are none.
    pub proved: Option<Finding>,
}

impl Asked<'_> {
    /// What proofs and premises found, for a procedure that needs some.
    pub fn proved(self) -> Finding {
        self.proved.unwrap_or_else(|| Finding::from_proofs([]))
    }

    /// The first thing that it is asked about; empty where nothing is.
    pub fn first(&self) -> &str {
        self.of.first().map_or("", String::as_str)
    }
}

/// What the program does not compute of a proof that a report states.
const OF_STATED_PROOFS: &str = "the certified steps of a stated proof imply what it says.";

/// The finding on a part.
pub(super) fn decide(computed: &Computed, context: &Context) -> Finding {
    if computed.needs_the_paper()
        && let Err(missing) = context.equations.demand_paper()
    {
        return Finding::not_checked(missing.to_string());
    }
    let proved = proved(computed, context);
    let found = match check_of(computed) {
        Some(check) => {
            let numbers: Vec<&str> = computed.equations.iter().map(String::as_str).collect();
            let equations = context.equations.only(&numbers);
            (check.decide)(&context.with_equations(&equations), Asked { of: &computed.of, proved })
        }
        None => proved.unwrap_or_else(|| Finding::from_proofs([])),
    };
    let evidence = shows_of(computed).flat_map(|show| (show.evidence)(context));
    let found = evidence.fold(found, Finding::with_supporting);
    match &computed.extent {
        Some(extent) if found.verdict == Verdict::Holds => found.on(extent),
        _ => found,
    }
}

/// What the proofs and the premises find together; none without any.
fn proved(computed: &Computed, context: &Context) -> Option<Finding> {
    let proofs = computed.proofs.iter().map(|id| {
        let key = format!("proof {id} {}", computed.needs_the_paper());
        context.once(key, || computed.stated.prove(id, context.equations))
    });
    let found = (!computed.proofs.is_empty()).then(|| Finding::from_proofs(proofs));
    let found = found.map(|found| match found.verdict {
        Verdict::Holds if !computed.has_reviewed_proofs() => found.argued(OF_STATED_PROOFS),
        _ => found,
    });
    let found = match (found, &computed.counter_example) {
        (Some(found), Some(shown)) if found.verdict == Verdict::Holds => Some(found.refuted(shown)),
        (Some(found), Some(_)) => {
            let reason = found.counter_example.unwrap_or_default();
            Some(Finding::not_checked(format!("The disproof fails: {reason}")))
        }
        (found, _) => found,
    };
    let mut premises = computed.premises.iter().map(|premise| {
        match formula::decide(&premise.id, &premise.stated, context) {
            undecided if undecided.verdict == Verdict::NotChecked => undecided,
            decided => Finding { readings: Vec::new(), remarks: Vec::new(), ..decided },
        }
    });
    match found {
        Some(found) => Some(premises.fold(found, Finding::with_premise)),
        None => premises.next().map(|first| premises.fold(first, Finding::with_premise)),
    }
}

fn check_of(computed: &Computed) -> Option<&'static Check> {
    let name = computed.check.as_ref()?;
    checks().find(|check| check.name == name)
}

fn shows_of(computed: &Computed) -> impl Iterator<Item = &'static Show> {
    computed.shows.iter().filter_map(|name| shows().find(|show| show.name == name))
}

/// What the procedures of a part need computed.
pub(super) fn needs(computed: &Computed) -> impl Iterator<Item = Need> {
    let of_check = check_of(computed).into_iter().flat_map(|check| check.needs);
    of_check.chain(shows_of(computed).flat_map(|show| show.needs)).copied()
}

/// Whether it is about runs: what these rest on was computed without the equations.
pub(super) fn is_of_runs(computed: &Computed) -> bool {
    check_of(computed).is_some_and(|check| check.is_of_runs)
}

/// The procedures that a claim may name.
#[must_use]
pub fn procedures() -> Procedures {
    Procedures {
        checks: checks().map(|check| check.name).collect(),
        shows: shows().map(|show| show.name).collect(),
    }
}

/// A procedure whose finding, or the reason why there is none, is its answer.
pub(super) fn either(found: Result<Finding, Finding>) -> Finding {
    found.unwrap_or_else(|undecided| undecided)
}
