//! Lists of evolution laws.

use crate::scene::section::Entry;
use crate::scene::{Faults, Problem, nearest};
use slipmode_core::friction::EvolutionLaw;

/// A list of evolution laws, each at most once.
pub(crate) fn read_laws(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<EvolutionLaw>> {
    let mut seen = Vec::new();
    entry.list(faults, |member, faults| {
        let word = member.text(faults)?;
        let Some(law) = EvolutionLaw::from_word(&word) else {
            let words = EvolutionLaw::ALL.map(EvolutionLaw::as_str);
            let near = nearest(&word, words).map(str::to_string);
            faults.push(member.fault(Problem::UnknownWord { nearest: near, allowed: words.join(", ") }));
            return None;
        };
        if seen.contains(&law) {
            let of = format!("an earlier law `{word}`");
            faults.push(member.fault(Problem::Duplicate { of, folded: false }));
            return None;
        }
        seen.push(law);
        Some(law)
    })
}
