//! The lines near an operating point, and the nearest value of each quantity at which the slip mode changes.

use super::error_bars::{Bar, bars, modes};
use super::reach::{DIGITS, reach};
use crate::experiments::SceneOutcome;
use crate::experiments::map::run::exactly;
use crate::scene::Quantity;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::{Side, rounded};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::inverse::{Target, Unknown, solve, solve_over_box};
use slipmode_core::stability::{InertialThreshold, ParameterBox, SlipMode, classify};

/// What was found at an operating point.
#[derive(Debug, Clone)]
pub struct OperatingPointOutcome {
    /// Whether all values within the error bars have one slip mode.
    pub is_certain: bool,
    /// The normal stresses at the transition and on the boundary, at this loading velocity: ranges where values have error bars, Pa.
    pub limits: Vec<(Target, [f64; 2])>,
    /// What each value has to become, in the order of [`Unknown::ALL`].
    pub changes: Vec<Change>,
    /// What each error bar does.
    pub bars: Vec<Bar>,
}

/// The nearest value of one quantity at which the slip mode changes; the middle values of the others stay.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// What is changed.
    pub quantity: Quantity,
    /// Its present value in SI.
    pub now: f64,
    /// The value in SI at which the slip mode changes, to a relative error of 1e-9, and the slip mode behind it; none within reach.
    pub to: Option<(f64, SlipMode)>,
    /// A value in SI, at which no values within the error bars have the present slip mode of the middle values; none found within reach.
    pub certain_from: Option<f64>,
}

/// Digits of a solution.
const SOLUTION_DIGITS: u32 = 20;
/// How far next to a line, relatively, the slip modes on its sides are decided.
const BESIDE: f64 = 1e-9;
/// Steps of a bisection to 1e-9 between values that differ by a factor below 1e20.
const HALVINGS: usize = 36;
/// The factor between values that are tried for all values within the error bars.
const STEP: f64 = 1.05;

impl OperatingPointOutcome {
    /// Decides all for the middle values, and for all values within the error bars where there are some.
    pub(super) fn of(earlier: &SceneOutcome) -> Option<Self> {
        let stated = earlier.scene.parameters.as_ref()?;
        let parameters = Parameters { slider: stated.slider.clone(), point: stated.point()? };
        let region = stated.error_bars.clone().or_else(|| ParameterBox::of(parameters.clone()))?;
        let threshold = earlier.scene.threshold();
        let found = Point { parameters: &parameters, region: &region, threshold: &threshold };
        let changes = Unknown::ALL.into_iter().map(|unknown| found.change(unknown)).collect::<Option<_>>()?;
        let limits = limits(&region);
        let possible = modes(&region, &threshold);
        let is_certain = possible.len() == 1;
        let bars = bars(&region, &limits, &threshold, is_certain);
        // Without any mode the threshold is one that is not decided over error bars.
        (!possible.is_empty()).then_some(Self { is_certain, limits, changes, bars })
    }
}

/// The normal stresses at which some values have the transition or the boundary.
fn limits(region: &ParameterBox) -> Vec<(Target, [f64; 2])> {
    let ranges = |target: Target| {
        let found = solve_over_box(region, Unknown::NormalStress, &target);
        found.into_iter().map(move |range| (target.clone(), range.enclosure))
    };
    [Target::GrowthRate(Rational::new()), Target::Boundary].into_iter().flat_map(ranges).collect()
}

struct Point<'a> {
    parameters: &'a Parameters<Rational>,
    region: &'a ParameterBox,
    threshold: &'a InertialThreshold,
}

impl Point<'_> {
    /// The slip mode of the middle values, one of which is this.
    fn mode(&self, quantity: Quantity, value: f64) -> SlipMode {
        let mut values: [Rational; 7] = self.parameters.clone().into();
        values[quantity as usize] = exactly(value);
        classify(&values.into(), self.threshold).slip_mode
    }

    /// `None` when the solutions are not separated.
    fn change(&self, unknown: Unknown) -> Option<Change> {
        let quantity = Quantity::from(unknown);
        let values: [Rational; 7] = self.parameters.clone().into();
        let now = nearest_f64(&values[quantity as usize]);
        let mut lines = Vec::new();
        for target in [Target::GrowthRate(Rational::new()), Target::Boundary] {
            let found = solve(self.parameters, unknown, &target, SOLUTION_DIGITS).ok()?;
            lines.extend(found.iter().map(|solution| solution.value.to_f64()));
        }
        let factor = |(value, _): &(f64, SlipMode)| libm::log(value / now).abs();
        let to = reach(quantity).into_iter().filter_map(|end| self.first_change(quantity, now, end, &lines));
        let to = to.min_by(|one, other| factor(one).total_cmp(&factor(other)));
        let certain_from = to.and_then(|(value, _)| self.certain_from(quantity, now, value));
        Some(Change { quantity, now, to, certain_from })
    }

    /// The first change of the slip mode between a value and an end of reach. Between two lines the roots keep their kind, and an
    /// oscillation crosses the threshold of its frequency once at most: a proof of `monotone.toml` shows it of each of the four quantities.
    fn first_change(&self, quantity: Quantity, now: f64, end: f64, lines: &[f64]) -> Option<(f64, SlipMode)> {
        let present = self.mode(quantity, now);
        let sign = (end - now).signum();
        let is_between = |line: &&f64| (**line - now) * sign > 0.0 && (end - **line) * sign > 0.0;
        let mut stops: Vec<f64> = lines.iter().filter(is_between).copied().collect();
        stops.sort_by(|one, other| (sign * one).total_cmp(&(sign * other)));
        let mut inside = now;
        for stop in stops.into_iter().chain((sign != 0.0).then_some(end)) {
            let [before, behind] = [-1.0, 1.0].map(|side| stop * (1.0 + side * sign * BESIDE));
            if self.mode(quantity, before) != present {
                let has_left = |value| self.mode(quantity, value) != present;
                let value = bisected(inside, before, has_left);
                return Some((value, self.mode(quantity, value)));
            }
            let beyond = self.mode(quantity, behind);
            if beyond != present {
                return (stop != end).then_some((stop, beyond));
            }
            inside = behind;
        }
        None
    }

    /// A value beyond a change, rounded away from it, at which no values within the error bars have the present slip mode.
    fn certain_from(&self, quantity: Quantity, now: f64, change: f64) -> Option<f64> {
        let present = self.mode(quantity, now);
        let has_left = |value: f64| {
            let region = self.region.clone().with_ends(quantity, [exactly(value), exactly(value)]);
            region.is_some_and(|region| !modes(&region, self.threshold).contains(&present))
        };
        let [low, high] = reach(quantity);
        let factor = if change > now { STEP } else { 1.0 / STEP };
        let tried = std::iter::successors(Some(change), |value| Some(value * factor));
        let found = tried.take_while(|value| (low..=high).contains(value)).find(|value| has_left(*value))?;
        let nearest = bisected((found / factor).clamp(low, high), found, has_left);
        let side = if change > now { Side::Above } else { Side::Below };
        let shown = rounded(nearest, DIGITS, side).parse().ok()?;
        [shown, found].into_iter().find(|value| has_left(*value))
    }
}

/// The value next to which a property begins, between one without it and one with it: one with it.
fn bisected(without: f64, with: f64, has: impl Fn(f64) -> bool) -> f64 {
    let halved = |[without, with]: [f64; 2], _| {
        let middle = without * (with / without).sqrt();
        if has(middle) { [without, middle] } else { [middle, with] }
    };
    (0..HALVINGS).fold([without, with], halved)[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::number::parse_decimal;

    fn changes(stress: [&str; 2], velocity: &str) -> Vec<Change> {
        let at = |stress: &str| paper().at(parse_decimal(stress).unwrap(), parse_decimal(velocity).unwrap());
        let region = ParameterBox::new(at(stress[0]), at(stress[1])).unwrap();
        let (parameters, threshold) = (region.middle(), InertialThreshold::default());
        let point = Point { parameters: &parameters, region: &region, threshold: &threshold };
        Unknown::ALL.into_iter().map(|unknown| point.change(unknown).unwrap()).collect()
    }

    #[test]
    fn the_nearest_changes_are_the_transition_and_the_threshold_of_the_frequency() {
        // At 100 kPa and 10 µm/s the slider sticks and slips; without inertia, K = K_c is at σ_c = 50 kPa and K = 2e7 Pa/m.
        let found = changes(["1e5", "1e5"], "1e-5");
        let to = |index: usize| found[index].to.unwrap();
        assert!((to(0).0 / 49_997.5 - 1.0).abs() < 1e-6, "{found:?}");
        assert_eq!(to(0).1, SlipMode::NonInertialUnderdampedOscillation);
        assert!((to(2).0 / 2e7 - 1.0).abs() < 1e-4);
        // The mode changes to harmonic vibration at the velocity and at the mass with ω = ω_n/√2, where classify says so.
        for index in [1, 3] {
            let (value, mode) = to(index);
            assert_eq!(mode, SlipMode::HarmonicVibration);
            let mode_at = |factor: f64| {
                let mut values: [Rational; 7] =
                    paper().at(Rational::from(100_000), parse_decimal("1e-5").unwrap()).into();
                values[found[index].quantity as usize] = exactly(value * factor);
                classify(&values.into(), &InertialThreshold::default()).slip_mode
            };
            assert_eq!([0.999_999, 1.000_001].map(mode_at), [SlipMode::StickSlip, mode]);
        }
    }

    #[test]
    fn a_change_for_all_values_lies_beyond_that_of_the_middle_values_and_none_out_of_reach_is_named() {
        let found = changes(["9e4", "1.1e5"], "1e-5");
        let [to, certain] = [found[2].to.unwrap().0, found[2].certain_from.unwrap()];
        assert!(to < certain && (certain / 2.2e7 - 1.0).abs() < 0.01, "{found:?}");
        // σ itself is set: its own error bar has no effect on its change.
        assert!((found[0].certain_from.unwrap() / 49_997.5 - 1.0).abs() < 0.01);
        let slow = changes(["1e3", "1e3"], "1e-11");
        assert!(slow.iter().all(|change| change.to.is_none_or(|(value, _)| {
            let [low, high] = reach(change.quantity);
            (low..=high).contains(&value)
        })));
    }
}
