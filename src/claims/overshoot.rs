//! How far runs that do not oscillate pass the loading velocity: what "critical damping" leaves open.

use crate::claims::simulated::Run;
use slipmode_core::number::format::round_digits;
use slipmode_core::stability::SlipMode;

/// The runs of the two areas without oscillation, and how far they pass V_l.
pub(super) struct Overshoots {
    /// Largest V/V_l − 1 in the upper area, less its estimated error; at most 0 when no run is faster than V_l.
    upper: f64,
    /// The same in the lower area.
    pub(super) lower: f64,
    /// Runs in the lower area, and those of them that pass V_l by more than their error.
    counts: [usize; 2],
}

impl Overshoots {
    /// Of the runs of an intrinsically stable slider.
    pub(super) fn of(runs: &[&Run]) -> Self {
        let (upper, lower) =
            (within(runs, SlipMode::OverdampedOscillation), within(runs, SlipMode::OverdampedStableSliding));
        let largest = |excesses: &[f64]| excesses.iter().copied().fold(-1.0, f64::max);
        let passing = lower.iter().filter(|excess| **excess > 0.0).count();
        Self { upper: largest(&upper), lower: largest(&lower), counts: [lower.len(), passing] }
    }

    /// Both areas, for the evidence.
    pub(super) fn text(&self) -> String {
        format!("{}, {}", round_digits(self.upper, 2), round_digits(self.lower, 2))
    }

    /// In which sense the boundaries are critical damping.
    pub(super) fn limit(&self) -> String {
        let [all, passing] = self.counts;
        format!(
            "oscillation in the long term; the {all} runs below the lower boundary do not oscillate, but {passing} of them exceed V_l once on their way from V_l/10, by up to {} of V_l",
            round_digits(self.lower, 2)
        )
    }
}

/// V_peak/V_l − 1 of the runs of one mode, each less its estimated error.
fn within(runs: &[&Run], mode: SlipMode) -> Vec<f64> {
    let excess = |run: &&&Run| {
        let ratio = run.simulation.peak_velocity_m_per_s / run.velocity_m_per_s;
        ratio * (1.0 - run.simulation.peak_relative_error) - 1.0
    };
    runs.iter().filter(|run| run.is(mode)).map(|run| excess(&run)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_counts_the_runs_that_pass_the_loading_velocity() {
        let overshoots = Overshoots { upper: -0.5, lower: 0.37, counts: [64, 60] };
        assert!(
            overshoots
                .limit()
                .contains("the 64 runs below the lower boundary do not oscillate, but 60 of them"),
            "{}",
            overshoots.limit()
        );
        assert!(overshoots.limit().ends_with("by up to 0.37 of V_l"), "{}", overshoots.limit());
        assert_eq!(overshoots.text(), "-0.5, 0.37");
    }
}
