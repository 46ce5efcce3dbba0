//! A claim with its disguises, and the smallest form in which it still gets a wrong verdict.

use super::claim::{Claim, Truth};
use super::disguise::Disguise;
use super::families;
use super::program::{Answer, answers};
use super::world::World;
use crate::random::Random;

/// The most disguises of one claim.
const MOST_DISGUISES: usize = 4;

/// A claim by the seed of what it says, and its disguises.
#[derive(Debug, Clone)]
pub struct Trial {
    seed: u64,
    disguises: Vec<Disguise>,
}

/// Whether the program contradicts the truth, or ends in another way than with a verdict or a refusal.
pub fn is_wrong(truth: Truth, answer: &Answer) -> bool {
    match answer {
        Answer::Holds => truth != Truth::True,
        Answer::Fails(_) => truth != Truth::False,
        Answer::NotChecked | Answer::Refused(_) => false,
        Answer::Broken(_) => true,
    }
}

impl Trial {
    pub fn drawn(random: &mut Random) -> Self {
        let seed = random.next();
        let count = random.below(MOST_DISGUISES + 1);
        Self { seed, disguises: (0..count).map(|_| Disguise::drawn(random)).collect() }
    }

    pub fn claim(&self) -> Claim {
        let plain = families::claim(&mut Random(self.seed));
        self.disguises.iter().fold(plain, |claim, disguise| disguise.applied(claim))
    }

    /// The claim without the disguises and the names that do not matter, in the words of a report.
    pub fn shrunk(&self, world: &World, answer: &Answer) -> String {
        let (mut smallest, mut world, mut answer) = (self.clone(), world.clone(), answer.clone());
        let still = |trial: &Self, world: &World| {
            let claim = trial.claim();
            let answer = answers(world, std::slice::from_ref(&claim)).remove(0);
            is_wrong(claim.truth, &answer).then_some(answer)
        };
        let mut at = 0;
        while at < smallest.disguises.len() {
            let mut fewer = smallest.clone();
            fewer.disguises.remove(at);
            match still(&fewer, &world) {
                Some(found) => (smallest, answer) = (fewer, found),
                None => at += 1,
            }
        }
        if let Some(found) = still(&smallest, &World::plain()) {
            (world, answer) = (World::plain(), found);
        }
        let claim = smallest.claim();
        format!(
            "truth: {:?}\nverdict: {answer:?}\ndisguises: {:?}\n{}{}{}",
            claim.truth,
            smallest.disguises.iter().map(|one| one.change).collect::<Vec<_>>(),
            world.toml(),
            claim.definitions_toml(0, &world),
            claim.toml(0, &world),
        )
    }
}
