//! Parts of claims that proofs, other claims or a procedure of this program decide.

use super::check::{Asked, Check, Show};
use super::procedures::{CHECKS, SHOWS};
use super::{Finding, Verdict};
use crate::experiments::{Context, Need};
use crate::scene::{ClaimEntry, Computed, Fault, Faults, Problem};
use slipmode_theory::Equations;

/// What the program does not compute of a proof that a report states.
const OF_STATED_PROOFS: &str = "the certified steps of a stated proof imply what it says.";

/// The finding on a part, with those on its premises.
pub(super) fn decide(computed: &Computed, premises: Vec<Finding>, context: &Context) -> Finding {
    let missing = missing(computed, context.equations);
    if !missing.is_empty() {
        return Finding::not_checked(format!("Not decided: {}.", missing.join("; ")));
    }
    let proved = proved(computed, premises, context);
    let found = match check_of(computed) {
        Some(check) => {
            let equations = given(computed, context.equations).in_symbols();
            (check.decide)(&context.with_equations(&equations), Asked { of: &computed.of, proved })
        }
        None => proved.unwrap_or_else(|| Finding::from_proofs([])),
    };
    let evidence = shows_of(computed).filter_map(|show| (show.evidence)(context));
    let found = evidence.flatten().fold(found, Finding::with_supporting);
    match &computed.extent {
        Some(extent) if found.verdict == Verdict::Holds => found.on(extent),
        _ => found,
    }
}

/// The equations that the procedure of a part may use.
fn given(computed: &Computed, equations: &Equations) -> Equations {
    let numbers: Vec<&str> = computed.equations.iter().map(String::as_str).collect();
    equations.only(&numbers)
}

/// What a part needs of the equations and does not find: a sentence for each.
fn missing(computed: &Computed, equations: &Equations) -> Vec<String> {
    let of_check = check_of(computed).filter(|check| !check.roles.is_empty()).into_iter();
    let of_check = of_check.flat_map(|check| {
        let missing = given(computed, equations).missing(check.roles);
        missing.into_iter().map(|missing| format!("of the `equations` for `{}`, {missing}", check.name))
    });
    let of_proofs = computed.proofs.iter().flat_map(|id| computed.stated.missing(id, equations));
    of_check.chain(of_proofs).collect()
}

/// What procedures and proofs that a file of claims names miss in the equations: each once.
pub(crate) fn equation_faults(file: &str, claims: &[ClaimEntry], equations: &Equations) -> Faults {
    let parts = claims
        .iter()
        .flat_map(|claim| claim.formulas().filter_map(move |formula| Some((&claim.id, formula.computed()?))));
    let all = parts.flat_map(|(id, computed)| {
        missing(computed, equations).into_iter().map(move |missing| (id, missing))
    });
    let mut faults = Faults::new();
    for (id, message) in all {
        let problem = Problem::Equation(message);
        if faults.iter().all(|fault| fault.problem != problem) {
            faults.push(Fault::of(file, format!("claim {id}"), problem));
        }
    }
    faults
}

/// What the proofs and the premises find together; none without any.
fn proved(computed: &Computed, premises: Vec<Finding>, context: &Context) -> Option<Finding> {
    let proofs = computed.proofs.iter().map(|id| {
        let key = format!("proof {id} {}", computed.has_reviewed_proofs());
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
    let mut premises = premises.into_iter().map(|premise| match premise.verdict {
        Verdict::NotChecked => premise,
        _ => Finding { readings: Vec::new(), remarks: Vec::new(), ..premise },
    });
    let first = found.or_else(|| premises.next())?;
    Some(premises.fold(first, Finding::with_premise))
}

fn check_of(computed: &Computed) -> Option<&'static Check> {
    let name = computed.check.as_ref()?;
    CHECKS.iter().find(|check| check.name == name)
}

fn shows_of(computed: &Computed) -> impl Iterator<Item = &'static Show> {
    computed.shows.iter().filter_map(|name| SHOWS.iter().find(|show| show.name == name))
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
