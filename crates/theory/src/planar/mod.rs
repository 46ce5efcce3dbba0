//! How a system of two equations of first order moves, from every start: six general lemmas.
//!
//! A report names a lemma and gives its hypotheses as expressions. The hypotheses are identities and signs and carry certificates.
//! Each lemma's own conclusion is one argued step, written once here, with the name of the classical theorem it uses.
//!
//! A positive state variable is taken in its logarithm and a free one as it is, so that the plane of both is all of ℝ². The rates
//! are rational and have a value everywhere on it, so that a motion exists and is unique until it leaves every compact set.

mod hill;
mod ratio;
mod region;
mod steps;

use super::System;
use slipmode_algebra::{Domain, Expression, Proof, Refutation};
use steps::Steps;

slipmode_algebra::named! {
    /// The lemmas, by what they conclude.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum MotionWord {
        /// Every motion is periodic: `quantity` is conserved.
        Periodic = "periodic",
        /// Every motion approaches the steady state: `quantity` rises towards its greatest value, but where `zero` vanishes.
        Attraction = "attraction",
        /// Every motion off the steady state leaves every compact set, and the variable is unbounded: where the other one is larger than
        /// `threshold`, the rate of the variable's logarithm is larger than `growth`.
        Escape = "escape",
        /// From every start with `region` > 0 the variable becomes infinite in finite time: there the rate of its logarithm is larger than
        /// `growth` times it.
        Runaway = "runaway",
        /// From every start with `region` > 0 the variable falls for ever.
        Deceleration = "deceleration",
        /// From every start the variable falls from some time on for ever, and tends to zero. `quantity` is a multiple of the product of
        /// both state variables: in the time with dτ = dt over the other one it moves by itself.
        LateDeceleration = "late-deceleration",
    }
}

impl MotionWord {
    /// The words of the expressions that state the lemma. A quantity is strictly concave or convex where it is conserved or has a rate of
    /// one sign, which is a multiple of the square of `zero`; a region's expression rises in the region; `growth` is a positive constant.
    #[must_use]
    pub const fn expressions(self) -> &'static [&'static str] {
        match self {
            Self::Periodic | Self::LateDeceleration => &["quantity"],
            Self::Attraction => &["quantity", "zero"],
            Self::Escape => &["quantity", "zero", "threshold", "growth"],
            Self::Runaway => &["region", "growth"],
            Self::Deceleration => &["region"],
        }
    }

    /// Whether one of the state variables has a part of its own.
    #[must_use]
    pub const fn has_variable(self) -> bool {
        !matches!(self, Self::Periodic | Self::Attraction)
    }
}

/// What is claimed of the motions, with what the lemma needs to know.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MotionLemma {
    /// Which lemma.
    pub word: MotionWord,
    /// The state variable of which it speaks, 0 or 1.
    pub variable: usize,
    expressions: Vec<Expression>,
}

impl MotionLemma {
    /// The lemma with its expressions in the order of their words.
    #[must_use]
    pub const fn new(word: MotionWord, variable: usize, expressions: Vec<Expression>) -> Self {
        Self { word, variable, expressions }
    }

    /// The region in which a hypothesis is used, as an expression that is positive there.
    #[must_use]
    pub fn region(&self, system: &System) -> Option<Expression> {
        match (self.word, &self.expressions[..]) {
            (MotionWord::Runaway | MotionWord::Deceleration, [region, ..]) => Some(region.clone()),
            (MotionWord::Escape, [_, _, threshold, _]) => {
                Some(system.variable(1 - self.variable) - threshold.clone())
            }
            _ => None,
        }
    }

    /// The expressions that state it, each with its word.
    #[must_use]
    pub fn expressions(&self) -> Vec<(&'static str, &Expression)> {
        self.word.expressions().iter().copied().zip(&self.expressions).collect()
    }

    /// The lemma with each of its expressions changed.
    #[must_use]
    pub fn map(&self, change: impl Fn(&Expression) -> Expression) -> Self {
        Self::new(self.word, self.variable, self.expressions.iter().map(change).collect())
    }

    /// Adds the hypotheses and the conclusion to a proof. `domains` are forms of one domain, each of which reaches every point of it; a step is
    /// certified in the first form that allows it. The example of the domains lies in the lemma's region.
    ///
    /// # Errors
    /// The hypothesis that is refused, with what remains of it. The claim may be true for another reason.
    pub fn prove(&self, start: Proof, system: &System, domains: &[Domain]) -> Result<Proof, Refutation> {
        let mut steps = Steps::new(start, system, domains);
        if system.state.len() != 2 {
            return Err(
                steps.refuse("the system has two equations", format!("it has {}", system.state.len()))
            );
        }
        match (self.word, &self.expressions[..]) {
            (MotionWord::Periodic, [quantity]) => hill::periodic(&mut steps, quantity)?,
            (MotionWord::Attraction, [quantity, zero]) => hill::attraction(&mut steps, quantity, zero)?,
            (MotionWord::Escape, [quantity, zero, threshold, growth]) => {
                hill::repulsion(&mut steps, quantity, zero)?;
                region::unbounded(&mut steps, self.variable, threshold, growth)?;
            }
            (MotionWord::Runaway, [region, growth]) => {
                region::runaway(&mut steps, region, self.variable, growth)?;
            }
            (MotionWord::Deceleration, [region]) => region::deceleration(&mut steps, region, self.variable)?,
            (MotionWord::LateDeceleration, [quantity]) => {
                ratio::late_deceleration(&mut steps, quantity, self.variable)?;
            }
            (word, given) => {
                let says = format!("the lemma has {} expressions", word.expressions().len());
                return Err(steps.refuse(&says, format!("{} are given", given.len())));
            }
        }
        Ok(steps.proof)
    }
}

#[cfg(test)]
mod tests;
