//! A bound on the work of a computation, in steps that are counted: the same on every machine.
//!
//! A step is a product of two terms of polynomials (one for each machine word of the longest coefficient), a term of a sum, or a part
//! of an expression that is converted. Where no budget is set, nothing is counted.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::hash::Hash;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use thiserror::Error;

/// Results of a kind that a thread remembers, each with the steps that it took.
pub(super) type Memory<K, V> = RefCell<HashMap<K, (u64, V)>>;

/// How many results of a kind are remembered at most.
const MOST_REMEMBERED: usize = 2000;

thread_local! {
    /// The steps that are left; none without a budget.
    static LEFT: Cell<Option<u64>> = const { Cell::new(None) };
}

/// A computation took more steps than allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("too large: it takes more than {steps} steps")]
pub struct Exhausted {
    /// The steps that were allowed.
    pub steps: u64,
}

/// What unwinds the stack to the place that set the budget.
struct Stop;

/// The result of a computation, if it takes no more steps than allowed. An inner budget takes its steps from the outer one.
///
/// # Errors
/// When it takes more; whatever it had found is dropped.
pub fn within_budget<T>(steps: u64, compute: impl FnOnce() -> T) -> Result<T, Exhausted> {
    let outer = LEFT.get();
    let allowed = outer.map_or(steps, |left| left.min(steps));
    LEFT.set(Some(allowed));
    let found = catch_unwind(AssertUnwindSafe(compute));
    let used = allowed - LEFT.get().unwrap_or_default();
    LEFT.set(outer.map(|left| left - used));
    match found {
        Ok(found) => Ok(found),
        // The outer budget has run out, too: its owner is to know.
        Err(stop) if stop.is::<Stop>() && allowed < steps => resume_unwind(stop),
        Err(stop) if stop.is::<Stop>() => Err(Exhausted { steps }),
        Err(panic) => resume_unwind(panic),
    }
}

/// Takes steps from the budget.
pub(super) fn spend(steps: usize) {
    take(steps as u64);
}

fn take(steps: u64) {
    let Some(left) = LEFT.get() else { return };
    match left.checked_sub(steps) {
        Some(rest) => LEFT.set(Some(rest)),
        None => {
            LEFT.set(Some(0));
            // No fault of the program: nothing is printed, and the place that set the budget catches it.
            resume_unwind(Box::new(Stop));
        }
    }
}

/// What the work gives for a question, done once by each thread. The question names everything that the result depends on.
///
/// A result that is remembered takes as many steps from the budget as the work does, so that no decision depends on what a thread did
/// before.
pub(super) fn remembered<K: Hash + Eq, V: Clone>(
    memory: &RefCell<HashMap<K, (u64, V)>>,
    question: K,
    work: impl FnOnce() -> V,
) -> V {
    let known = memory.borrow().get(&question).cloned();
    if let Some((steps, found)) = known {
        take(steps);
        return found;
    }
    let before = LEFT.get();
    LEFT.set(before.or(Some(u64::MAX)));
    let start = LEFT.get();
    let found = work();
    let steps = start.unwrap_or_default() - LEFT.get().unwrap_or_default();
    if before.is_none() {
        LEFT.set(None);
    }
    let mut memory = memory.borrow_mut();
    if memory.len() >= MOST_REMEMBERED {
        memory.clear();
    }
    memory.insert(question, (steps, found.clone()));
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Domain, Expression};

    #[test]
    fn a_computation_that_takes_too_many_steps_is_stopped() {
        let expand = |power: u32| {
            let text = format!("(x + y + z)^{power}");
            Domain::default().rational_function(&text.parse::<Expression>().expect("in the grammar"))
        };
        assert!(within_budget(10_000, || expand(3)).is_ok_and(|found| found.is_ok()));
        assert_eq!(within_budget(100, || expand(30)).err(), Some(Exhausted { steps: 100 }));
        // The count starts anew, and none remains outside.
        assert!(within_budget(10_000, || expand(3)).is_ok());
        assert_eq!(LEFT.get(), None);
    }

    #[test]
    fn an_inner_budget_takes_from_the_outer_one() {
        let outer = within_budget(100, || {
            let first = within_budget(60, || spend(50));
            let second = within_budget(60, || spend(50));
            (first, second, within_budget(60, || spend(1)))
        });
        assert_eq!(outer.err(), Some(Exhausted { steps: 100 }));
        assert_eq!(within_budget(100, || within_budget(10, || spend(20))), Ok(Err(Exhausted { steps: 10 })));
    }
}
