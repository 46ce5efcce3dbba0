//! Which error bar decides the slip mode: the width of the line's band that each one causes, and what a better measurement of it would settle.

use crate::scene::Quantity;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::inverse::{Target, Unknown, solve_over_box};
use slipmode_core::stability::{InertialThreshold, ParameterBox, SlipMode, over_box};

/// What one error bar does.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// The value that has it.
    pub quantity: Quantity,
    /// Its ends in SI.
    pub ends: [f64; 2],
    /// The width of the band with this error bar alone, in decades of σ; infinite where it has no end.
    pub width_decades: f64,
    /// This width among the sum of all of them.
    pub share: f64,
    /// The slip modes that stay possible if this value is that of the middle, exactly.
    pub modes_if_exact: Vec<SlipMode>,
    /// The share of this error bar, about the same middle, with which all values have one slip mode; none where several are possible anyway, or one already is.
    pub settling_share: Option<f64>,
}

/// Halvings of an error bar.
const HALVINGS: u32 = 10;

/// Every error bar of a box, with its effect on the line next to the operating point.
pub(super) fn bars(
    region: &ParameterBox,
    limits: &[(Target, [f64; 2])],
    threshold: &InertialThreshold,
    is_already_certain: bool,
) -> Vec<Bar> {
    let stress = nearest_f64(&region.middle().point.normal_stress_pa);
    let distance = |[low, high]: [f64; 2]| libm::log(stress.clamp(low, high) / stress).abs();
    let line = limits.iter().min_by(|one, other| distance(one.1).total_cmp(&distance(other.1)));
    let bar = |quantity: Quantity| {
        let [low, high] = ends(region, quantity);
        let scaled = |share: &Rational| {
            let (middle, half) = ((low.clone() + &high) / 2u32, (high.clone() - &low) / 2u32 * share);
            region.clone().with_ends(quantity, [middle.clone() - &half, middle + half])
        };
        let modes_if_exact = modes(&scaled(&Rational::new())?, threshold);
        let settles =
            |share: &Rational| scaled(share).is_some_and(|region| modes(&region, threshold).len() == 1);
        let may_settle = !is_already_certain && modes_if_exact.len() == 1;
        let settling_share = may_settle.then(|| largest_share(settles)).filter(|share| *share > 0.0);
        let width_decades = line.map_or(0.0, |line| width(region, quantity, line));
        let ends = [low, high].map(|end| nearest_f64(&end));
        Some(Bar { quantity, ends, width_decades, share: 0.0, modes_if_exact, settling_share })
    };
    let has_bar = |quantity: &Quantity| ends(region, *quantity).is_sorted_by(|low, high| low < high);
    let mut bars: Vec<Bar> = Quantity::ALL.into_iter().filter(has_bar).filter_map(bar).collect();
    let sum: f64 = bars.iter().map(|bar| bar.width_decades).sum();
    if sum > 0.0 && sum.is_finite() {
        bars.iter_mut().for_each(|bar| bar.share = bar.width_decades / sum);
    }
    bars
}

fn ends(region: &ParameterBox, quantity: Quantity) -> [Rational; 2] {
    [region.lower(), region.upper()].map(|end| <[Rational; 7]>::from(end)[quantity as usize].clone())
}

/// The possible slip modes and those not decided.
pub(super) fn modes(region: &ParameterBox, threshold: &InertialThreshold) -> Vec<SlipMode> {
    over_box(region, threshold).map_or_else(Vec::new, |found| {
        let undecided = found.undecided.into_iter().map(|(mode, _)| mode);
        found.slip_modes.into_iter().map(|one| one.what).chain(undecided).collect()
    })
}

/// Decades of σ of the band of a line with one error bar alone; for σ, of its error bar.
fn width(region: &ParameterBox, quantity: Quantity, (target, band): &(Target, [f64; 2])) -> f64 {
    let decades = |[low, high]: [f64; 2]| libm::log10(high / low);
    let ends = ends(region, quantity);
    if quantity == Quantity::NormalStress {
        return decades(ends.each_ref().map(nearest_f64));
    }
    let alone = ParameterBox::of(region.middle()).and_then(|middle| middle.with_ends(quantity, ends));
    let bands = alone.map_or_else(Vec::new, |alone| solve_over_box(&alone, Unknown::NormalStress, target));
    let bands = bands.into_iter().map(|range| range.enclosure);
    // Those of other arcs are left out.
    bands.filter(|[low, high]| *low <= band[1] && *high >= band[0]).map(decades).fold(0.0, f64::max)
}

/// The largest share with a property, to a thousandth; smaller shares have it, too.
fn largest_share(has: impl Fn(&Rational) -> bool) -> f64 {
    let grown = |share: Rational, halving: u32| {
        let tried = share.clone() + Rational::from((1, 1u32 << halving));
        if has(&tried) { tried } else { share }
    };
    nearest_f64(&(1..=HALVINGS).fold(Rational::new(), grown))
}
