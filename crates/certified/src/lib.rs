//! Certified runs: limit cycles and decays that are proved to exist for the given decimals, with enclosed observables.
//!
//! Every number is an interval that is rounded outward, from the decimals on. [`certify`] proves that the return map of a section maps a box
//! into itself by Krawczyk's test: one limit cycle passes through the box, and no other. It proves a decay by a
//! run that ends in an ellipsoid in which zᵀPz falls, or in a cone around the slowest mode. [`certify_over`] proves the same of every slider in a box of parameters.

// Tests compare with the system's elementary functions.
#![cfg_attr(test, allow(clippy::disallowed_methods))]
// A bound that is not a number must refuse: `!(a < b)` does, `a >= b` would not.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod attraction;
mod coexistence;
mod cone;
mod constants;
mod crossing;
mod cycle;
mod decay;
mod guess;
mod inertial;
mod interval;
mod jet;
mod lanes;
mod linear;
mod manifold;
mod motion;
mod observed;
mod set;
mod short_time;
mod slow;
mod step;
mod sticking;
#[cfg(test)]
mod tests;
mod transversal;

pub use coexistence::{Coexistence, certify_coexistence};

use constants::{Constants, Units};
use slipmode_core::dynamics::{LongTerm, Model, Options, Start, simulate_model};
use slipmode_core::friction::{EvolutionLaw, ParameterBox, Parameters};
use slipmode_core::number::{Rational, nearest_f64};

/// Why nothing was certified.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Reason {
    /// A value is not positive.
    #[error("a value is not positive")]
    NotPositive,
    /// The simulation that the proof starts from failed.
    #[error("the simulation failed: {0}")]
    Simulation(String),
    /// The cycle crosses V = V_l several times.
    #[error("the cycle crosses the loading velocity {0} times")]
    SeveralReturns(usize),
    /// The enclosure needs more steps than allowed.
    #[error("the enclosure needs more steps than allowed")]
    TooManySteps,
    /// No step was found that is held by its box.
    #[error("no step was found whose enclosure holds")]
    NoEnclosure,
    /// The slider sticks, but inertia is too strong for the slow manifold.
    #[error("inertia is too strong for the slow manifold")]
    LeftTheTube,
    /// The motion may cross the section in another place, or touch it.
    #[error("the motion may touch the section elsewhere")]
    Tangent,
    /// The return map does not map a box into itself.
    #[error("no box is mapped into itself")]
    NotContained,
    /// The cycle exists, but it may repel.
    #[error("a cycle exists, but its multipliers may exceed 1")]
    NotAttracting,
    /// A cycle was to repel.
    #[error("a cycle exists, but it may attract")]
    NotRepelling,
    /// Two cycles were to be different ones.
    #[error("two cycles exist, but they may be the same")]
    NotSeparate,
    /// Steady sliding attracts no ellipsoid.
    #[error("no ellipsoid around steady sliding is proved to attract")]
    NoAttraction,
}

/// What a certificate proves.
#[derive(Debug, Clone, PartialEq)]
pub enum Proved {
    /// One limit cycle passes through a box of the section V = `section_log_velocity`, and it attracts.
    Cycle {
        /// ln(V/V_l) of the section, which the cycle crosses upward.
        section_log_velocity: f64,
        /// The box of y = ln(V_l θ/D_c), lower and upper end.
        state_box: [f64; 2],
        /// The box of the second coordinate: F = ζ − x − βy, or ψ, the distance of x' from the slow manifold.
        second_box: [f64; 2],
        /// Whether the second coordinate is ψ.
        is_on_slow_manifold: bool,
        /// A bound of the sizes of the multipliers, below 1.
        contraction: f64,
        /// The period, s.
        period_s: [f64; 2],
    },
    /// The run from the start ends in steady sliding.
    Decay {
        /// The run is inside an ellipsoid or a cone of (x, y, F/η) that steady sliding attracts after this time, s.
        captured_after_s: f64,
    },
}

/// A proof with enclosures: lower and upper end.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// What is proved.
    pub proved: Proved,
    /// Largest velocity of the cycle, or of the run from its start on, m/s.
    pub peak_velocity_m_per_s: [f64; 2],
    /// Largest less least spring stress, Pa.
    pub stress_drop_pa: [f64; 2],
}

impl Proved {
    /// `cycle` or `decay`.
    #[must_use]
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Cycle { .. } => "cycle",
            Self::Decay { .. } => "decay",
        }
    }
}

/// The second coordinate of a section, as a word: `psi`, the distance from the slow manifold, or `force`.
#[must_use]
pub const fn second_coordinate(is_on_slow_manifold: bool) -> &'static str {
    if is_on_slow_manifold { "psi" } else { "force" }
}

impl Certificate {
    /// Lower and upper bound of the period of a cycle, s; none of a decay.
    #[must_use]
    pub const fn period_s(&self) -> Option<[f64; 2]> {
        match self.proved {
            Proved::Cycle { period_s, .. } => Some(period_s),
            Proved::Decay { .. } => None,
        }
    }
}

/// The most steps of one enclosed motion.
const MOST_STEPS: u64 = 200_000;

/// Certifies the long-term behaviour of a slider.
///
/// # Errors
/// A [`Reason`] when nothing is proved.
pub fn certify(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    start: Start,
) -> Result<Certificate, Reason> {
    certify_over(&ParameterBox::of(parameters.clone()).ok_or(Reason::NotPositive)?, law, start)
}

/// Certifies the long-term behaviour of every slider in a box of parameters.
///
/// For each of them one limit cycle, and no other, passes through the stated box of the section, and it attracts; or its run decays. The bounds
/// hold for all. η, κ and β are taken as independent of each other, which makes the box larger where they are not.
///
/// # Errors
/// A [`Reason`] when nothing is proved of all.
pub fn certify_over(region: &ParameterBox, law: EvolutionLaw, start: Start) -> Result<Certificate, Reason> {
    let (constants, units) = (Constants::over(region, law), Units::over(region));
    let model = Model::new(region.middle().groups().map(nearest_f64), law);
    let options = Options { start, ..Options::at(1e-8) };
    let found =
        simulate_model(&model, &options).map_err(|failure| Reason::Simulation(failure.to_string()))?;
    match found.long_term() {
        LongTerm::Cycle(cycle) => cycle::certify(&constants, &model, cycle, &units),
        LongTerm::Decay(_) => decay::certify(&constants, start, &units),
    }
}

/// Proves a certificate again: a cycle from the box that the certificate states, by one enclosed return; a decay by its run.
///
/// # Errors
/// A [`Reason`] when it is not proved.
pub fn prove_again(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    start: Start,
    stated: &Proved,
) -> Result<Certificate, Reason> {
    let region = ParameterBox::of(parameters.clone()).ok_or(Reason::NotPositive)?;
    let (constants, units) = (Constants::over(&region, law), Units::over(&region));
    match stated {
        Proved::Cycle { .. } => cycle::prove_again(&constants, stated, &units),
        Proved::Decay { .. } => decay::certify(&constants, start, &units),
    }
}
