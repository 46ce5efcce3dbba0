//! Where the largest real part lies over a part of a box, without its roots: smooth and sharp also where roots meet.
//!
//! With z = g + y, f has the coefficients C3 = c3 > 0, C2, C1 and C0 in y. All roots lie left of Re z = g exactly where C2, C0 and
//! H = C2 C1 − C3 C0 are positive (Hurwitz). The largest real part falls with a parameter where each of these three rises with it or has one
//! sign, for every g that it may have: then no parameters that are all left of g stop being so.

use super::pair::coefficient_slopes;
use super::root_discs::{Values, cubic};
use crate::number::Interval;

/// C2, C0 and H, with their derivatives by each parameter that changes.
struct Conditions {
    values: [Interval; 3],
    slopes: [[Interval; 7]; 3],
}

impl Conditions {
    fn of(parameters: &Values, g: Interval) -> Self {
        let powers = [Interval::point(1.0), g, g.square(), g.square() * g];
        let moved = |[c0, c1, c2, c3]: [Interval; 4]| {
            let constant = c0 + c1 * g + c2 * powers[2] + c3 * powers[3];
            [constant, c1 + c2 * g * 2.0 + c3 * powers[2] * 3.0, c2 + c3 * g * 3.0, c3]
        };
        let [c0, c1, c2, c3] = moved(cubic(parameters));
        let mut slopes = [[Interval::point(0.0); 7]; 3];
        let changing = coefficient_slopes(parameters).into_iter().enumerate();
        for (i, of_parameter) in changing.filter(|(i, _)| parameters[*i].low < parameters[*i].high) {
            let [d0, d1, d2, d3] = moved(of_parameter);
            let of_product = d2 * c1 + c2 * d1 - d3 * c0 - c3 * d0;
            [slopes[0][i], slopes[1][i], slopes[2][i]] = [d2, d0, of_product];
        }
        Self { values: [c2, c0, c2 * c1 - c3 * c0], slopes }
    }
}

/// What is known of the derivatives of the largest real part, where it lies in `g` over a part: for each parameter the numbers that are
/// not negative, those that are not positive, or all.
pub(super) fn slopes(parameters: &Values, g: Interval) -> [Interval; 7] {
    let Conditions { values, slopes } = Conditions::of(parameters, g);
    let changing: Vec<usize> =
        (0..3).filter(|which| values[*which].low <= 0.0 && values[*which].high >= 0.0).collect();
    std::array::from_fn(|i| Interval {
        low: if changing.iter().all(|which| slopes[*which][i].high <= 0.0) { 0.0 } else { f64::NEG_INFINITY },
        high: if changing.iter().all(|which| slopes[*which][i].low >= 0.0) { 0.0 } else { f64::INFINITY },
    })
}

/// Whether all roots lie left of Re z = g at all points of a part, for certain.
pub(super) fn are_left(parameters: &Values, g: f64) -> bool {
    (0..3).all(|which| extreme(parameters, g, which, false) > 0.0)
}

/// Whether some root does not lie left of Re z = g at any point of a part, for certain.
pub(super) fn are_not_left(parameters: &Values, g: f64) -> bool {
    (0..3).any(|which| extreme(parameters, g, which, true) <= 0.0)
}

/// A bound of a condition over a part, from above or from below: each parameter with which it rises or falls is at its end.
fn extreme(parameters: &Values, g: f64, which: usize, from_above: bool) -> f64 {
    let mut parameters = *parameters;
    loop {
        let found = Conditions::of(&parameters, Interval::point(g));
        let mut is_changed = false;
        for (parameter, slope) in parameters.iter_mut().zip(found.slopes[which]) {
            let is_monotone = slope.low >= 0.0 || slope.high <= 0.0;
            if parameter.low < parameter.high && is_monotone {
                let end = if (slope.low >= 0.0) == from_above { parameter.high } else { parameter.low };
                *parameter = Interval::point(end);
                is_changed = true;
            }
        }
        if !is_changed {
            return if from_above { found.values[which].high } else { found.values[which].low };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::root_discs::{Quantity, RootDiscs};
    use super::*;
    use crate::number::split_mix::SplitMix64;

    fn largest(point: &[f64; 7]) -> Interval {
        RootDiscs::of(&point.map(Interval::point)).unwrap().largest(Quantity::Real, &[None; 3])
    }

    /// A box with random ends near those of a laboratory's slider, in units of the box.
    fn any_box(random: &mut SplitMix64) -> Values {
        let width = libm::exp10(-3.0 * random.unit());
        std::array::from_fn(|i| {
            let low = [0.01, 0.014, 1.0, 0.005, 1e-4, 1.0, 1.0][i] * libm::exp10(2.0 * random.unit() - 1.0);
            Interval { low, high: low * (1.0 + width * random.unit()) }
        })
    }

    fn within(part: &Values, random: &mut SplitMix64) -> [f64; 7] {
        part.map(|ends| (ends.low + random.unit() * ends.width()).min(ends.high))
    }

    #[test]
    fn what_is_certain_of_a_line_is_true_at_every_point() {
        let mut random = SplitMix64(8);
        let mut certain = [0; 2];
        for _ in 0..400 {
            let part = any_box(&mut random);
            let g = largest(&within(&part, &mut random)).middle() + 0.3 * (random.unit() - 0.5);
            let said = [are_left(&part, g), are_not_left(&part, g)];
            certain.iter_mut().zip(said).for_each(|(count, said)| *count += u32::from(said));
            for _ in 0..20 {
                let point = within(&part, &mut random);
                let found = largest(&point);
                assert!(!said[0] || found.low < g, "{part:?} {g} {point:?}");
                assert!(!said[1] || found.high >= g, "{part:?} {g} {point:?}");
            }
        }
        assert!(certain.iter().all(|count| *count > 40), "{certain:?}");
    }

    #[test]
    fn the_largest_real_part_rises_and_falls_as_its_slopes_say() {
        let mut random = SplitMix64(9);
        let mut known = 0;
        for _ in 0..400 {
            let part = any_box(&mut random);
            let point = within(&part, &mut random);
            let level = largest(&point).hull(largest(&within(&part, &mut random)));
            for (i, slope) in slopes(&part, level).into_iter().enumerate() {
                let [low, high] = [part[i].low, part[i].high].map(|end| {
                    let mut moved = point;
                    moved[i] = end;
                    largest(&moved)
                });
                let in_level = |value: Interval| Interval {
                    low: value.low.max(level.low),
                    high: value.high.min(level.high),
                };
                // Beyond the level nothing is said: values count as its ends there.
                let [low, high] = [low, high].map(in_level);
                assert!(
                    slope.low < 0.0 || low.low <= high.high || low.low >= level.high,
                    "{i} {part:?} {level:?}"
                );
                assert!(
                    slope.high > 0.0 || high.low <= low.high || high.low >= level.high,
                    "{i} {part:?} {level:?}"
                );
                known += u32::from(slope.low == 0.0) + u32::from(slope.high == 0.0);
            }
        }
        assert!(known > 400, "{known}");
    }
}
