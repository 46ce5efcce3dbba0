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
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};
use steps::Steps;

/// Two equations of first order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlanarSystem {
    /// The two state variables.
    pub state: [Symbol; 2],
    /// Their rates.
    pub rates: [Expression; 2],
    /// Where the rates vanish, if the system has a steady state.
    pub steady: Option<[Expression; 2]>,
}

/// What is claimed of the motions, with what the lemma needs to know.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MotionLemma {
    /// Every motion is periodic: `quantity` is conserved.
    Periodic {
        /// The conserved quantity, strictly concave or convex.
        quantity: Expression,
    },
    /// Every motion approaches the steady state: `quantity` rises towards its greatest value, but where `zero` vanishes.
    Attraction {
        /// The Lyapunov function, strictly concave or convex.
        quantity: Expression,
        /// Its rate is a multiple of the square of this.
        zero: Expression,
    },
    /// Every motion off the steady state leaves every compact set, and the state variable `grows` is unbounded.
    Escape {
        /// The Lyapunov function, strictly concave or convex.
        quantity: Expression,
        /// Its rate is a multiple of the square of this.
        zero: Expression,
        /// Which state variable is unbounded, 0 or 1.
        grows: usize,
        /// Where the other variable is larger than this, the rate of ln `grows` is larger than `growth`.
        threshold: Expression,
        /// A positive constant.
        growth: Expression,
    },
    /// From every start with `region` > 0 the state variable `grows` becomes infinite in finite time.
    Runaway {
        /// It is positive in the region and rises there.
        region: Expression,
        /// Which state variable, 0 or 1.
        grows: usize,
        /// In the region the rate of ln `grows` is larger than this times `grows`.
        growth: Expression,
    },
    /// From every start with `region` > 0 the state variable `falls` falls for ever.
    Deceleration {
        /// It is positive in the region and rises there.
        region: Expression,
        /// Which state variable, 0 or 1.
        falls: usize,
    },
    /// From every start the state variable `falls` falls from some time on for ever, and tends to zero.
    LateDeceleration {
        /// A multiple of the product of both state variables. In the time with dτ = dt over the other one it moves by itself.
        quantity: Expression,
        /// Which state variable, 0 or 1.
        falls: usize,
    },
}

impl PlanarSystem {
    /// A system of two equations.
    #[must_use]
    pub fn of(system: &System) -> Option<Self> {
        let both = [&system.rates, &system.steady].map(|list| <[Expression; 2]>::try_from(list.clone()).ok());
        let [rates, steady] = both;
        Some(Self { state: system.state.clone().try_into().ok()?, rates: rates?, steady })
    }

    /// The rate of an expression along the motion.
    #[must_use]
    pub fn rate(&self, expression: &Expression) -> Expression {
        self.gradient(expression)
            .into_iter()
            .zip(&self.rates)
            .fold(Expression::integer(0), |sum, (slope, rate)| sum + slope * rate.clone())
    }

    /// The system with each of its expressions changed.
    #[must_use]
    pub fn map(&self, change: impl Fn(&Expression) -> Expression) -> Self {
        let changed = |both: &[Expression; 2]| both.each_ref().map(&change);
        Self {
            state: self.state.clone(),
            rates: changed(&self.rates),
            steady: self.steady.as_ref().map(changed),
        }
    }

    fn gradient(&self, expression: &Expression) -> [Expression; 2] {
        [0, 1].map(|index| expression.derivative(&self.state[index]))
    }

    /// A state variable as an expression.
    fn variable(&self, index: usize) -> Expression {
        Expression::Variable(self.state[index].clone())
    }
}

impl MotionLemma {
    /// The region in which a hypothesis is used, as an expression that is positive there.
    #[must_use]
    pub fn region(&self, system: &PlanarSystem) -> Option<Expression> {
        match self {
            Self::Runaway { region, .. } | Self::Deceleration { region, .. } => Some(region.clone()),
            Self::Escape { grows, threshold, .. } => Some(system.variable(1 - grows) - threshold.clone()),
            Self::Periodic { .. } | Self::Attraction { .. } | Self::LateDeceleration { .. } => None,
        }
    }

    /// The expressions that state it, each with its word.
    #[must_use]
    pub fn expressions(&self) -> Vec<(&'static str, &Expression)> {
        match self {
            Self::Periodic { quantity } | Self::LateDeceleration { quantity, .. } => {
                vec![("quantity", quantity)]
            }
            Self::Attraction { quantity, zero } => vec![("quantity", quantity), ("zero", zero)],
            Self::Escape { quantity, zero, threshold, growth, .. } => {
                vec![("quantity", quantity), ("zero", zero), ("threshold", threshold), ("growth", growth)]
            }
            Self::Runaway { region, growth, .. } => vec![("region", region), ("growth", growth)],
            Self::Deceleration { region, .. } => vec![("region", region)],
        }
    }

    /// The lemma with each of its expressions changed.
    #[must_use]
    pub fn map(&self, change: impl Fn(&Expression) -> Expression) -> Self {
        match self {
            Self::Periodic { quantity } => Self::Periodic { quantity: change(quantity) },
            Self::Attraction { quantity, zero } => {
                Self::Attraction { quantity: change(quantity), zero: change(zero) }
            }
            Self::Escape { quantity, zero, grows, threshold, growth } => Self::Escape {
                quantity: change(quantity),
                zero: change(zero),
                grows: *grows,
                threshold: change(threshold),
                growth: change(growth),
            },
            Self::Runaway { region, grows, growth } => {
                Self::Runaway { region: change(region), grows: *grows, growth: change(growth) }
            }
            Self::Deceleration { region, falls } => {
                Self::Deceleration { region: change(region), falls: *falls }
            }
            Self::LateDeceleration { quantity, falls } => {
                Self::LateDeceleration { quantity: change(quantity), falls: *falls }
            }
        }
    }

    /// Adds the hypotheses and the conclusion to a proof. `domains` are forms of one domain, each of which reaches every point of it; a step is
    /// certified in the first form that allows it. The example of the domains lies in the lemma's region.
    ///
    /// # Errors
    /// The hypothesis that is refused, with what remains of it. The claim may be true for another reason.
    pub fn prove(
        &self,
        start: Proof,
        system: &PlanarSystem,
        domains: &[Domain],
    ) -> Result<Proof, Refutation> {
        let mut steps = Steps::new(start, system, domains);
        match self {
            Self::Periodic { quantity } => hill::periodic(&mut steps, quantity)?,
            Self::Attraction { quantity, zero } => hill::attraction(&mut steps, quantity, zero)?,
            Self::Escape { quantity, zero, grows, threshold, growth } => {
                hill::repulsion(&mut steps, quantity, zero)?;
                region::unbounded(&mut steps, *grows, threshold, growth)?;
            }
            Self::Runaway { region, grows, growth } => region::runaway(&mut steps, region, *grows, growth)?,
            Self::Deceleration { region, falls } => region::deceleration(&mut steps, region, *falls)?,
            Self::LateDeceleration { quantity, falls } => {
                ratio::late_deceleration(&mut steps, quantity, *falls)?
            }
        }
        Ok(steps.proof)
    }
}

#[cfg(test)]
mod tests;
