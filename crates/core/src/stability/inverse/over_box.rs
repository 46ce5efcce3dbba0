//! Inverse questions over a box of parameters: enclosures of all values of the unknown at which some point of the box does what is stated.
//!
//! Outside of the enclosures no value is a solution. Interval arithmetic excludes parts of the axis, and near 0 and far out the
//! polynomials of the inverse question with intervals as coefficients do so. The transition and the boundary are decided exactly over each part.

use std::collections::VecDeque;

use rug::Rational;

use super::frequency::angular_frequency;
use super::tails::{Tails, tails};
use super::{Target, Unknown};
use crate::number::Interval;
use crate::stability::over_box::{
    ParameterBox, RootPart, Sought, boundary_sought, sought_in, threshold_sought, transition_sought,
};

/// Parts of the axis are halved until their ends have this ratio.
const COARSE: f64 = 1.0 + 1.0 / 16.0;
/// The ends of an enclosure are halved until they are known to this ratio, or not decided.
const FINE: f64 = 1.0 + 1e-12;
/// The most parts of the axis for which it is not decided whether they have solutions.
const MOST_UNDECIDED: usize = 64;
/// The axis is searched over so many powers of two about its unit where the polynomials bound no solution.
const OCTAVES: i32 = 60;

/// A range of the unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolutionRange {
    /// All its solutions lie between these two; 0 or infinity where they may have no bound.
    pub enclosure: [f64; 2],
    /// Two values that are certainly solutions at some point of the box, near the ends of the enclosure; none where that is not known.
    pub certain: Option<[f64; 2]>,
}

/// The solutions for all points of a box, ascending; empty where no point has one. The unknown's own values in the box have no effect.
///
/// ```
/// use slipmode_core::stability::ParameterBox;
/// use slipmode_core::stability::inverse::{Target, Unknown, solve_over_box};
/// use slipmode_core::{friction::Parameters, number::{Rational, parse_decimal}};
///
/// let point = |b: &str| {
///     Parameters::from(["0.004", b, "1e-5", "1e7", "1000", "1", "1e-5"].map(|text| parse_decimal(text).unwrap()))
/// };
/// let uncertain = ParameterBox::new(point("0.005"), point("0.006")).unwrap();
/// let found = solve_over_box(&uncertain, Unknown::NormalStress, &Target::GrowthRate(Rational::new()));
/// // σ = K D_c/(b − a) − M V0²/(a D_c): from 49 997.5 to 99 997.5 Pa.
/// assert_eq!(found.len(), 1);
/// assert!((found[0].enclosure[0] / 49_997.5 - 1.0).abs() < 1e-9 && found[0].enclosure[0] <= 49_997.5);
/// assert!((found[0].enclosure[1] / 99_997.5 - 1.0).abs() < 1e-9 && found[0].enclosure[1] >= 99_997.5);
/// ```
#[must_use]
pub fn solve_over_box(region: &ParameterBox, unknown: Unknown, target: &Target) -> Vec<SolutionRange> {
    let Tails { window, is_bounded } = tails(region, unknown, target, OCTAVES);
    let axis = Axis { region, unknown, target };
    let mut runs: Vec<[f64; 2]> = Vec::new();
    for [low, high] in axis.parts(window) {
        match runs.last_mut() {
            Some(run) if run[1] == low => run[1] = high,
            _ => runs.push([low, high]),
        }
    }
    runs.into_iter().map(|run| axis.refined(run, window, is_bounded)).collect()
}

/// Whether it is certain that no point of a box does what is stated. The transition and the boundary are decided exactly.
#[must_use]
pub fn is_nowhere(region: &ParameterBox, target: &Target) -> bool {
    sought_over(region, target) == Sought::Nowhere
}

/// Whether some point of a box is a solution.
fn sought_over(region: &ParameterBox, target: &Target) -> Sought {
    match target {
        Target::GrowthRate(rate) if rate.is_zero() => transition_sought(region),
        Target::GrowthRate(rate) => sought_in(region, RootPart::Real, Interval::enclosing(rate)),
        Target::Boundary => boundary_sought(region),
        Target::FrequencyRatio(threshold) => threshold_sought(region, threshold),
        target => sought_in(region, RootPart::Imaginary, angular_frequency(target)),
    }
}

/// The axis of the unknown.
struct Axis<'a> {
    region: &'a ParameterBox,
    unknown: Unknown,
    target: &'a Target,
}

/// A number between two, at about the same ratio to each.
fn between([low, high]: [f64; 2]) -> f64 {
    let middle = low * (high / low).sqrt();
    if low < middle && middle < high { middle } else { low + 0.5 * (high - low) }
}

impl Axis<'_> {
    /// Whether some value in a part of the axis is a solution.
    fn sought(&self, [low, high]: [f64; 2]) -> Sought {
        let region = Rational::from_f64(low)
            .zip(Rational::from_f64(high))
            .and_then(|(low, high)| self.region.clone().with_ends(self.unknown.into(), [low, high]));
        region.map_or(Sought::Unknown, |region| sought_over(&region, self.target))
    }

    /// The parts that may have solutions, ascending. The longest are halved first; after [`MOST_UNDECIDED`] parts the rest may have solutions.
    fn parts(&self, window: [f64; 2]) -> Vec<[f64; 2]> {
        let (mut parts, mut open, mut undecided) = (Vec::new(), VecDeque::from([window]), 0);
        while let Some(part) = open.pop_front() {
            let may_halve = undecided < MOST_UNDECIDED;
            let sought = if may_halve { self.sought(part) } else { Sought::Unknown };
            if sought == Sought::Nowhere {
                continue;
            }
            undecided += usize::from(sought == Sought::Unknown);
            let middle = between(part);
            if may_halve && part[1] / part[0] > COARSE && part[0] < middle && middle < part[1] {
                open.extend([[part[0], middle], [middle, part[1]]]);
            } else {
                parts.push(part);
            }
        }
        parts.sort_by(|one, other| one[0].total_cmp(&other[0]));
        parts
    }

    /// The end of the solutions, between a number beyond them and one that may be among them.
    fn end(&self, mut beyond: f64, mut within: f64) -> f64 {
        loop {
            let ends = [beyond.min(within), beyond.max(within)];
            let middle = between(ends);
            if ends[1] / ends[0] <= FINE || middle <= ends[0] || middle >= ends[1] {
                return beyond;
            }
            let outer = [beyond.min(middle), beyond.max(middle)];
            if self.sought(outer) == Sought::Nowhere { beyond = middle } else { within = middle }
        }
    }

    fn refined(&self, [low, high]: [f64; 2], window: [f64; 2], is_bounded: [bool; 2]) -> SolutionRange {
        let [from_zero, to_infinity] =
            [!is_bounded[0] && low == window[0], !is_bounded[1] && high == window[1]];
        let lowest = if from_zero { low } else { self.end(low, high.min(low * COARSE)) };
        let highest = if to_infinity { high } else { self.end(high, low.max(high / COARSE)) };
        let is_solution =
            |value: f64| (lowest..=highest).contains(&value) && self.sought([value; 2]) == Sought::Somewhere;
        let middle = between([lowest, highest]);
        let near = |sign: f64, end: f64| {
            let inside = [0.0, 2e-12, 1e-9, 1e-6, 1e-4, 1e-2].map(|share| end * (1.0 + sign * share));
            inside.into_iter().chain([middle]).find(|value| is_solution(*value))
        };
        let certain = near(1.0, lowest).zip(near(-1.0, highest)).map(|(low, high)| [low, high]);
        SolutionRange {
            enclosure: [
                if from_zero { 0.0 } else { lowest },
                if to_infinity { f64::INFINITY } else { highest },
            ],
            certain,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Parameters;
    use crate::number::parse_decimal;
    use crate::number::split_mix::SplitMix64;
    use crate::stability::InertialThreshold;
    use crate::stability::inverse::solve;

    /// A lab's slider at 5 MPa and 10 µm/s, each value ± this share of it.
    fn laboratory(share: f64) -> ParameterBox {
        let values = ["0.009", "0.0126", "8e-6", "2e9", "2400", "5e6", "1e-5"]
            .map(|text| parse_decimal(text).unwrap());
        let end = |sign: f64| {
            let factor = Rational::from_f64(1.0 + sign * share).unwrap();
            Parameters::from(values.each_ref().map(|value| value.clone() * &factor))
        };
        ParameterBox::new(end(-1.0), end(1.0)).unwrap()
    }

    fn targets() -> [Target; 7] {
        let number = |text| parse_decimal(text).unwrap();
        [
            Target::GrowthRate(Rational::new()),
            Target::GrowthRate(number("0.03")),
            Target::GrowthRate(-number("0.2")),
            Target::Boundary,
            Target::AngularFrequency(number("0.7")),
            Target::Frequency(number("0.1")),
            Target::FrequencyRatio(InertialThreshold::default()),
        ]
    }

    #[test]
    fn solutions_of_points_lie_in_the_enclosures_and_the_values_called_certain_are_attained() {
        let region = laboratory(0.01);
        let [lower, upper]: [[Rational; 7]; 2] = [region.lower().into(), region.upper().into()];
        let mut random = SplitMix64(3);
        for (unknown, target) in
            Unknown::ALL.into_iter().flat_map(|unknown| targets().map(|target| (unknown, target)))
        {
            let ranges = solve_over_box(&region, unknown, &target);
            assert!(ranges.windows(2).all(|pair| pair[0].enclosure[1] < pair[1].enclosure[0]));
            let mut met = vec![0; ranges.len()];
            for _ in 0..12 {
                let point: [Rational; 7] = std::array::from_fn(|i| {
                    let share = Rational::from(((9.0 * random.unit()) as u32, 8));
                    Rational::from(&upper[i] - &lower[i]) * share + &lower[i]
                });
                for solution in solve(&Parameters::from(point), unknown, &target, 20).unwrap() {
                    let value = solution.value.to_f64();
                    let index = ranges.iter().position(|range| {
                        range.enclosure[0] * (1.0 - 1e-15) <= value
                            && value <= range.enclosure[1] * (1.0 + 1e-15)
                    });
                    met[index.unwrap_or_else(|| panic!("{unknown:?} {target:?}: {value} in {ranges:?}"))] +=
                        1;
                }
            }
            assert!(met.iter().all(|count| *count > 0), "{unknown:?} {target:?}: {ranges:?} {met:?}");
            for range in &ranges {
                let certain = range.certain.unwrap_or_else(|| panic!("{unknown:?} {target:?}: {ranges:?}"));
                for (enclosed, certain) in range.enclosure.into_iter().zip(certain) {
                    let is_near =
                        enclosed == 0.0 || enclosed.is_infinite() || (certain / enclosed - 1.0).abs() < 2e-4;
                    assert!(is_near, "{unknown:?} {target:?}: {range:?}");
                }
            }
        }
    }

    #[test]
    fn what_no_point_reaches_has_no_range() {
        let region = laboratory(0.02);
        // Above the natural frequency, 145 Hz.
        let fast = Target::Frequency(Rational::from(160));
        assert_eq!(solve_over_box(&region, Unknown::NormalStress, &fast), []);
        assert_eq!(solve_over_box(&region, Unknown::LoadingVelocity, &fast), []);
        let growing = Target::GrowthRate(Rational::from(1000));
        assert_eq!(solve_over_box(&region, Unknown::Stiffness, &growing), []);
    }
}
