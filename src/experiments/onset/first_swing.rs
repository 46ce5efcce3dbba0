//! What a reader sees of a run from V_l/10 to steady sliding: its peak, its undershoot, and how far V rises again.

use slipmode_core::dynamics::events::{Mark, candidates, state_at};
use slipmode_core::dynamics::{Control, Failure, Integrator, Model, Radau, Start};

/// What is seen of one run, in units of V_l; 0 for what does not happen.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Swing {
    /// How far V exceeds V_l at its first peak above it.
    pub overshoot: f64,
    /// How far V falls below V_l after that peak.
    pub undershoot: f64,
    /// The largest rise of V from a minimum after that peak to the next peak, or to V_l when none follows.
    pub second_rise: f64,
}

/// Size of the state at which all that could be seen is over.
const OVER: f64 = 1e-5;

/// Extremes after which all that could be seen has been seen: a vibration that lasts shows its largest swing first.
const EXTREMES: usize = 12;

impl Swing {
    /// The largest difference of the three.
    pub(crate) fn largest_difference(&self, other: &Self) -> f64 {
        let differences = [
            self.overshoot - other.overshoot,
            self.undershoot - other.undershoot,
            self.second_rise - other.second_rise,
        ];
        differences.into_iter().fold(0.0, |largest, difference| largest.max(difference.abs()))
    }

    /// Follows the run until nothing more can be seen.
    pub(crate) fn of(model: &Model<f64>, local_tolerance: f64) -> Result<Self, Failure> {
        let control = Control { local_tolerance, most_steps: 1_000_000 };
        let start = Start::default().at_a_tenth(model);
        let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
        let mut seen = Self::default();
        let (mut first_peak, mut trough, mut extremes) = (None, None, 0);
        let mut above = false;
        while extremes < EXTREMES && run.state().iter().any(|component| component.abs() > OVER) {
            run.advance(None)?;
            for candidate in candidates(&run).into_iter().flatten() {
                let excess = || libm::expm1(state_at(&run, candidate)[0]);
                match candidate.mark {
                    Mark::Rise => above = true,
                    Mark::Fall => {}
                    Mark::Peak if above && first_peak.is_none() => {
                        seen.overshoot = excess();
                        first_peak = Some(seen.overshoot);
                    }
                    Mark::Peak => {
                        extremes += 1;
                        if let Some(low) = trough.take() {
                            seen.second_rise = seen.second_rise.max(excess() - low);
                        }
                    }
                    Mark::Trough => {
                        extremes += 1;
                        if first_peak.is_some() {
                            let low = excess();
                            seen.undershoot = seen.undershoot.max(-low);
                            trough = Some(low);
                        }
                    }
                }
            }
        }
        let back_to_rest = trough.map_or(0.0, |low: f64| -low);
        seen.second_rise = seen.second_rise.max(back_to_rest);
        Ok(seen)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::{EvolutionLaw, Groups};

    fn swing(inertial_parameter: f64) -> Swing {
        // σ = 10^3.25 Pa with the paper's values; eq 20 is at η = 1/(4κ).
        let groups = Groups { inertial_parameter, stiffness_group: 14.0585, effect_ratio: 1.5 };
        Swing::of(&Model::new(groups, EvolutionLaw::Slip), 1e-9).unwrap()
    }

    #[test]
    fn real_roots_overshoot_once_and_do_not_rise_again() {
        let seen = swing(0.25 / 14.0585 * 0.25);
        assert!(seen.overshoot > 0.2, "{seen:?}");
        assert_eq!([seen.undershoot, seen.second_rise], [0.0, 0.0]);
    }

    #[test]
    fn a_ripple_on_the_way_down_rises_again_without_falling_below_the_loading_velocity() {
        let seen = swing(0.25 / 14.0585 * 2.8117 * 2.8117);
        assert!(seen.undershoot < 0.01 && seen.second_rise > 0.05, "{seen:?}");
        let ringing = swing(0.25 / 14.0585 * 25.0);
        assert!(ringing.undershoot > 0.2 && ringing.second_rise > ringing.undershoot, "{ringing:?}");
    }
}
