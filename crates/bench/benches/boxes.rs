//! The classification over boxes of parameters: 1 000 boxes of all kinds, each compared with 10 000 exact points of it.
//!
//! Boxes lie around random points, around the transition, the boundary (its double and triple roots) and the place where the
//! threshold of the frequency meets the transition. Their half-widths are 1e-12 to 0.5 of the values, and some values are certain.
//!
//! Times are CPU times and depend on the machine: the time of one exact classification of a point stands beside them.

use rug::ops::Pow;
use slipmode_bench::cpu_clock::best_of;
use slipmode_bench::split_mix::SplitMix64;
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Dd, Rational, nearest_f64};
use slipmode_core::stability::{
    Effort, InertialThreshold, OverBox, ParameterBox, Possible, SlipMode, classify, classify_quickly,
    over_box,
};

const BOXES: usize = 1_000;
const POINTS: usize = 10_000;
/// Points of the box have coordinates at multiples of this part of its width.
const GRID: usize = 64;

type Point = [Rational; 7];

fn rational(value: f64) -> Rational {
    // Six digits, as a lab would write them.
    let exponent = libm::floor(libm::log10(value)) - 5.0;
    let digits = Rational::from_f64(libm::round(value / libm::exp10(exponent))).unwrap();
    let scale = Rational::from(rug_power(exponent.abs() as u32));
    if exponent < 0.0 { digits / scale } else { digits * scale }
}

fn rug_power(exponent: u32) -> rug::Integer {
    rug::Integer::from(10).pow(exponent)
}

fn laboratory(random: &mut SplitMix64) -> [f64; 7] {
    let ranges = [(-3.0, -1.5), (-3.0, -1.5), (-6.0, -3.0), (5.0, 10.0), (0.0, 5.0), (4.0, 8.0), (-7.0, 1.0)];
    ranges.map(|(low, high)| libm::exp10(random.between(low, high)))
}

/// The point with the groups η, κ, β at the given a, D_c, σ, V0.
fn with_groups([eta, kappa, beta]: [f64; 3], point: [f64; 7]) -> [f64; 7] {
    let [a, _, d, _, _, s, v] = point;
    [a, beta * a, d, kappa * a * s / d, eta * s * a * d / (v * v), s, v]
}

/// The point whose cubic has the roots −1 − x_i.
fn with_roots([x, y, z]: [f64; 3], point: [f64; 7]) -> Option<[f64; 7]> {
    let sum = x + y + z + 2.0;
    let groups = [1.0 / sum, (1.0 + x) * (1.0 + y) * (1.0 + z) / sum, x * y * z / sum];
    groups.iter().all(|group| *group > 0.0).then(|| with_groups(groups, point))
}

fn centre(kind: usize, random: &mut SplitMix64) -> [f64; 7] {
    let point = laboratory(random);
    let positive = |random: &mut SplitMix64| libm::exp10(random.between(-2.0, 1.5));
    let (x, y, z) = (positive(random), positive(random), positive(random));
    match kind {
        0 => point,
        // On K = K_c, and there where η is that of the threshold.
        1 => with_groups([x, y * (1.0 + x), 1.0 + y], point),
        2 => with_groups([1.0, 2.0 * y, 1.0 + y], point),
        // A double root below −1, a triple one, a double root in each upper area.
        3 => with_roots([x, x, z], point).unwrap_or(point),
        4 => with_roots([x, x, x], point).unwrap_or(point),
        5 => with_roots([-1.0 - x, -1.0 - x, z + 2.0 * x], point).unwrap_or(point),
        6 => with_roots([-1.0 / (1.0 + x), -1.0 / (1.0 + x), z], point).unwrap_or(point),
        // A pair at the threshold (ω/ω_n)² = 1/2 with real part x, in units of ω_n.
        _ => {
            let (x, rate) = (random.between(-0.7, 0.7), libm::exp10(random.between(-2.0, 2.0)));
            let excess = 1.0 / (x * x + 0.5) - 1.0;
            let a = excess - 2.0 * x / rate;
            let b = excess * ((x / rate + 1.0) * (x / rate + 1.0) + 0.5 / (rate * rate));
            // a' = aσ/(K D_c) = rate² a and M V0²/(K D_c²) = rate².
            let groups = [1.0 / a, 1.0 / (rate * rate * a), b / a];
            if a > 0.0 { with_groups(groups, point) } else { point }
        }
    }
}

fn random_box(index: usize, random: &mut SplitMix64) -> (ParameterBox, [[Rational; GRID + 1]; 7]) {
    let point = centre(index % 8, random).map(rational);
    let width = [0.5, 0.1, 0.1, 0.03, 0.01, 1e-4, 1e-12][(7.0 * random.unit()) as usize];
    let ends = point.map(|value| {
        let share = if random.unit() < 0.25 { 0.0 } else { libm::round(100.0 * random.unit()) / 100.0 };
        let error = Rational::from_f64(width * share).unwrap() * &value;
        // Many boxes have their point at a corner or on a face.
        match (3.0 * random.unit()) as usize {
            0 => (Rational::from(&value - &error), value),
            1 => (value.clone(), Rational::from(&value + &error)),
            _ => (Rational::from(&value - &error), value + error),
        }
    });
    let lower = Parameters::from(ends.each_ref().map(|(low, _)| low.clone()));
    let upper = Parameters::from(ends.each_ref().map(|(_, high)| high.clone()));
    let grid = ends.map(|(low, high)| {
        let step = Rational::from(&high - &low) / GRID as u32;
        std::array::from_fn(|i| Rational::from(&step * i as u32) + &low)
    });
    (ParameterBox::new(lower, upper).unwrap(), grid)
}

fn mode_of(point: &Point, rounded: [Dd; 7], threshold: &InertialThreshold) -> (i8, SlipMode) {
    let found = classify_quickly(&Parameters::from(rounded), threshold)
        .unwrap_or_else(|| classify(&Parameters::from(point.clone()), threshold));
    (found.transition_sign, found.slip_mode)
}

/// Points of the box, or witnesses, that contradict what was found over it.
fn contradictions(
    found: &OverBox,
    region: &ParameterBox,
    grid: &[[Rational; GRID + 1]; 7],
    random: &mut SplitMix64,
    threshold: &InertialThreshold,
) -> usize {
    let rounded: Vec<Vec<Dd>> =
        grid.iter().map(|values| values.iter().map(Dd::from_rational).collect()).collect();
    let is_possible = |mode: SlipMode| {
        found.slip_modes.iter().any(|possible| possible.what == mode)
            || found.undecided.iter().any(|(open, _)| *open == mode)
    };
    let points = (0..POINTS).filter(|_| {
        let at: [usize; 7] = std::array::from_fn(|_| ((GRID + 1) as f64 * random.unit()) as usize);
        let point = std::array::from_fn(|i| grid[i][at[i]].clone());
        let (sign, mode) = mode_of(&point, std::array::from_fn(|i| rounded[i][at[i]]), threshold);
        let [least, greatest] = found.transition_signs;
        !is_possible(mode) || sign < least || sign > greatest
    });
    let is_wrong = |possible: &&Possible<SlipMode>| {
        possible.witness.as_ref().is_some_and(|point| {
            !region.contains(point) || classify(point, threshold).slip_mode != possible.what
        })
    };
    points.count() + found.slip_modes.iter().filter(is_wrong).count()
}

fn main() {
    let mut random = SplitMix64(17);
    let threshold = InertialThreshold::default();
    let boxes: Vec<_> = (0..BOXES).map(|index| random_box(index, &mut random)).collect();
    let mut found = Vec::new();
    for (region, _) in &boxes {
        let run = || over_box(region, &threshold).expect("the default threshold is allowed");
        let (seconds, over) = best_of(3, run);
        found.push((seconds * 1e6, over));
    }
    let classified =
        || boxes.iter().map(|(region, _)| classify(&region.lower(), &threshold)).collect::<Vec<_>>();
    let point_us = best_of(3, classified).0 * 1e6 / BOXES as f64;
    let percent = |count: usize| 100.0 * count as f64 / BOXES as f64;
    let count =
        |test: &dyn Fn(&OverBox) -> bool| percent(found.iter().filter(|(_, over)| test(over)).count());
    println!("{BOXES} boxes; one exact classification of a point takes {point_us:.2} us");
    println!("  one mode is certain: {:.1} %", count(&|over| over.certain_mode().is_some()));
    println!("  decided without subdivision: {:.1} %", count(&|over| over.effort.halvings == 0));
    println!("  with an undecided share: {:.1} %", count(&|over| !over.undecided.is_empty()));
    let largest = found.iter().map(|(_, over)| nearest_f64(&over.undecided_share())).fold(0.0, f64::max);
    println!("  largest undecided share: {largest:.2e} of the box");
    let without =
        found.iter().flat_map(|(_, over)| &over.slip_modes).filter(|mode| mode.witness.is_none()).count();
    println!("  modes without a rational witness: {without}");
    for (name, test) in [
        ("by corners", (|effort| effort == Effort::default()) as fn(Effort) -> bool),
        ("by corners and the path", |effort| effort.edges > 0 && effort.searches == 0),
        ("with the threshold, without subdivision", |effort| effort.searches > 0 && effort.halvings == 0),
        ("with subdivision", |effort| effort.halvings > 0),
    ] {
        let mut times: Vec<f64> =
            found.iter().filter(|(_, over)| test(over.effort)).map(|(time, _)| *time).collect();
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times.get((share * times.len() as f64) as usize).copied().unwrap_or(f64::NAN);
        let [half, most, all] = [at(0.5), at(0.9), at(0.999)];
        println!(
            "  {name}: {} boxes, median {half:.0} us, 90 % below {most:.0} us, slowest {all:.0} us",
            times.len()
        );
    }
    let wrong: usize = boxes
        .iter()
        .zip(&found)
        .map(|((region, grid), (_, over))| contradictions(over, region, grid, &mut random, &threshold))
        .sum();
    println!("  contradictions among {POINTS} exact points of each box, and witnesses: {wrong}");
}
