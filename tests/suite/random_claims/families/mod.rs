//! The kinds of claims, each with a truth that follows from how it is built.

mod boxes;
mod conditions;
mod dependence;
mod derivations;
mod existence;
mod functions;
mod growth;
mod identities;
mod limits;
mod meaningless;
mod pointed;
mod roots;
mod signs;

pub use meaningless::faulty_equations;

use super::claim::Claim;
use crate::random::Random;

/// A kind of claim, and how many of a hundred claims are of this kind.
type Family = (fn(&mut Random) -> Claim, usize);

const FAMILIES: [Family; 14] = [
    (functions::claim, 10),
    (identities::claim, 12),
    (signs::claim, 14),
    (roots::location, 14),
    (roots::crossing, 5),
    (growth::claim, 11),
    (dependence::claim, 8),
    (limits::claim, 9),
    (existence::claim, 9),
    (conditions::claim, 6),
    (boxes::claim, 4),
    (derivations::claim, 4),
    (pointed::claim, 15),
    (meaningless::claim, 5),
];

/// A claim of any kind, without disguise.
pub fn claim(random: &mut Random) -> Claim {
    let mut rest = random.below(FAMILIES.iter().map(|(_, weight)| weight).sum());
    for (family, weight) in FAMILIES {
        if rest < weight {
            return family(random);
        }
        rest -= weight;
    }
    FAMILIES[0].0(random)
}
