//! The velocities at which oscillation begins in simulations: where it exists, and where a reader first sees it.
//!
//! *Exists*: the frequency of small deviations from steady sliding, squared, extrapolated to zero. *Seen*: in the run
//! from V_l/10, after its first peak above V_l, V rises again by a given part of V_l, or falls below V_l by it. The first rise above V_l itself is no
//! sign of oscillation: with a < b the spring has to shorten on the way to V_l, and only V > V_l shortens it.

use crate::experiments::map::run::exactly;
use crate::experiments::onset::first_swing::Swing;
use slipmode_core::dynamics::{
    Control, Failure, Integrator, Model, Radau, Start, oscillation_of_small_deviations,
};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::search::{border_between, interpolated};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::Section;

/// A loading velocity in m/s, or on a line of constant velocity a normal stress in Pa, with its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Located {
    /// The value.
    pub value: f64,
    /// Estimated error of its log10.
    pub error_dex: f64,
}

/// Where oscillation begins in simulations with one law.
#[derive(Debug, Clone, PartialEq)]
pub struct SeenOnset {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// Where the frequency of small deviations reaches zero.
    pub exists: Option<Located>,
    /// Where V first rises again by the visible part of V_l after its first peak.
    pub second_rise: Option<Located>,
    /// Where V first falls below V_l by the visible part of it after its first peak.
    pub undershoot: Option<Located>,
    /// Largest V/V_l − 1 after the first rise above V_l in a run at the boundary, where nothing oscillates yet.
    pub peak_excess_at_boundary: Option<f64>,
}

/// A line of constant normal stress or loading velocity under one law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line<'p> {
    pub parameters: &'p Slider<Rational>,
    /// What is given; the other coordinate varies, and its logarithm is the place on the line.
    pub given: &'p Section,
    pub law: EvolutionLaw,
    pub tolerance: f64,
}

/// Half the range of ln V searched for the existence of oscillation, around the asymptote.
const REACH: f64 = 1.5;

/// Where the bisection on existence stops, in ln V: the points of the extrapolation begin above it.
const EDGE_WIDTH: f64 = 1e-3;

/// Distance in ln V of the points that are extrapolated.
const SPACING: f64 = 0.03;

/// Points that are extrapolated.
const POINTS: usize = 6;

/// Errors of the extrapolated place in units of the tolerance: frequencies are good to a tenth of it, and the weights of six even
/// points add up to 2^6 − 1.
const AMPLIFIED: f64 = 6.3;

/// Steps of ln V in the search for what is seen, and how many of them.
const SCAN_STEP: f64 = 0.1;
const SCAN_STEPS: usize = 70;

/// Width in ln V to which what is seen is located.
const VISIBLE_WIDTH: f64 = 1e-8;

impl Line<'_> {
    fn model(&self, place: f64) -> Model<f64> {
        let value = exactly(libm::exp(place));
        let point = match self.given {
            Section::AtNormalStress(stress) => self.parameters.at(stress.clone(), value),
            Section::AtVelocity(velocity) => self.parameters.at(value, velocity.clone()),
        };
        Model::new(point.groups().map(nearest_f64), self.law)
    }

    /// What is seen of the run at a place, and twice its change from a tenth of the tolerance.
    pub fn swing(&self, place: f64) -> Result<(Swing, f64), Failure> {
        let model = self.model(place);
        let (coarse, fine) = (Swing::of(&model, self.tolerance)?, Swing::of(&model, 0.1 * self.tolerance)?);
        Ok((fine, 2.0 * fine.largest_difference(&coarse)))
    }

    /// Searches along the line; the asymptote only says where to begin, the boundary where to look at a run.
    pub fn search(&self, asymptote: f64, boundary: f64, visible: f64) -> SeenOnset {
        let centre = libm::log(asymptote);
        let at_boundary = Swing::of(&self.model(libm::log(boundary)), self.tolerance);
        let from = centre - REACH;
        SeenOnset {
            law: self.law,
            exists: self.existence(centre),
            second_rise: self.visible(from, |swing| swing.second_rise >= visible),
            undershoot: self.visible(from, |swing| swing.undershoot >= visible),
            peak_excess_at_boundary: at_boundary.ok().map(|swing| swing.overshoot),
        }
    }

    /// (ω/ω_n)² of small deviations; none when nothing oscillates or a run failed.
    fn squared_frequency(&self, log_velocity: f64) -> Option<f64> {
        let model = self.model(log_velocity);
        let period = oscillation_of_small_deviations(&model, 0.01 * self.tolerance).ok()??.period;
        let omega = std::f64::consts::TAU / period;
        Some(omega * omega * model.groups().inertial_parameter / model.groups().stiffness_group)
    }

    /// Close above its beginning a pair dies before it turns, so its edge is found late; the frequency is not.
    fn existence(&self, centre: f64) -> Option<Located> {
        let oscillates = |log_velocity| Some(self.squared_frequency(log_velocity).is_some());
        let ends = (centre - REACH, centre + REACH);
        if oscillates(ends.0) != Some(false) || oscillates(ends.1) != Some(true) {
            return None;
        }
        let (_, edge) = border_between(oscillates, ends, EDGE_WIDTH)?;
        let points: Option<Vec<(f64, f64)>> = (1..=POINTS)
            .map(|index| {
                let place = SPACING.mul_add(index as f64, edge);
                // Without evolution of the state 1 − (ω/ω_n)² falls as 1/V² (eq 19): in this coordinate the line is nearly straight.
                Some((-0.5 * libm::log1p(-self.squared_frequency(place)?), place))
            })
            .collect();
        let points = points?;
        let (finer, coarser) = (interpolated(&points, 0.0), interpolated(&points[..POINTS - 1], 0.0));
        Some(located(finer, 2.0 * (finer - coarser).abs() + AMPLIFIED * self.tolerance))
    }

    /// The slowest velocity of the scan from which on something is seen, refined.
    fn visible(&self, from: f64, is_seen: impl Fn(&Swing) -> bool) -> Option<Located> {
        let seen = |tolerance: f64| {
            let is_seen = &is_seen;
            move |log_velocity| Some(is_seen(&Swing::of(&self.model(log_velocity), tolerance).ok()?))
        };
        let coarse = seen(self.tolerance);
        let place = |index: usize| SCAN_STEP.mul_add(index as f64, from);
        let first = (1..=SCAN_STEPS).find(|&index| coarse(place(index)) == Some(true))?;
        let ends = (place(first - 1), place(first));
        let (_, coarse) = border_between(coarse, ends, VISIBLE_WIDTH)?;
        let (_, fine) = border_between(seen(0.1 * self.tolerance), ends, VISIBLE_WIDTH)?;
        Some(located(fine, 2.0 * (coarse - fine).abs() + VISIBLE_WIDTH))
    }

    /// V/V_l at equal times (units of D_c/V_l) from the start on.
    pub fn history(&self, log_velocity: f64, until: f64, samples: usize) -> Result<Vec<(f64, f64)>, Failure> {
        let model = self.model(log_velocity);
        let control = Control { local_tolerance: self.tolerance, most_steps: 1_000_000 };
        let start = Start::default().at_a_tenth(&model);
        let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), start, control)?;
        let mut history = vec![(0.0, libm::exp(start[0]))];
        for index in 1..samples {
            let time = until * index as f64 / (samples - 1) as f64;
            while time - run.time() > 1e-13 * until {
                let rest = time - run.time();
                run.advance(Some(&rest))?;
            }
            history.push((time, libm::exp(run.state()[0])));
        }
        Ok(history)
    }
}

fn located(log_velocity: f64, error: f64) -> Located {
    Located { value: libm::exp(log_velocity), error_dex: error / std::f64::consts::LN_10 }
}
