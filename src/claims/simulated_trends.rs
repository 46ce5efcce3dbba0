//! Claims N on peak velocity, stress drop and period across the grid.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::{Run, Runs, evidence, for_each_law, grids};
use crate::claims::{Evidence, Finding};
use crate::experiments::{Context, Outcome};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::SlipMode;

pub(super) fn rises((first, second): &(&Run, &Run)) -> bool {
    second.simulation.peak_velocity_m_per_s > first.simulation.peak_velocity_m_per_s
}

/// How many of the pairs pass, and of how many.
pub(super) fn share<'r, 'c: 'r>(
    pairs: impl Iterator<Item = (&'r Run<'c>, &'r Run<'c>)>,
    passes: impl Fn(&(&Run, &Run)) -> bool,
) -> (usize, usize) {
    pairs.fold((0, 0), |(passed, all), pair| (passed + usize::from(passes(&pair)), all + 1))
}

pub(super) fn of((passed, all): (usize, usize)) -> String {
    format!("{passed} of {all}")
}

pub(super) fn total(grids: &[Runs], count: impl Fn(&Runs) -> (usize, usize)) -> (usize, usize) {
    grids.iter().map(count).fold((0, 0), |sum, (passed, all)| (sum.0 + passed, sum.1 + all))
}

pub(super) fn peaks(pair: (&Run, &Run)) -> String {
    format!(
        "from {} to {} the peak velocity goes from {} to {} m/s",
        pair.0.place(),
        pair.1.place(),
        round_digits(pair.0.simulation.peak_velocity_m_per_s, 4),
        round_digits(pair.1.simulation.peak_velocity_m_per_s, 4)
    )
}

pub(super) fn n3(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let with_stress = risen(&grids, "at the same V_l", |grid| Box::new(grid.along_stress()));
    let with_velocity = risen(&grids, "at the same σ", |grid| Box::new(grid.along_velocity()));
    let jointly = risen(&grids, "on diagonals of the grid", |grid| Box::new(grid.along_both()));
    let written = Draft::new("along each axis: σ at the same V_l, and V_l at the same σ")
        .part("the peak velocity is lowest next to K = K_c", with_stress.clone())
        .part("the peak velocity grows with normal stress", with_stress)
        .part("the peak velocity grows with loading velocity", with_velocity);
    let joint = Draft::new("along lines on which σ and V_l increase together")
        .part("the peak velocity grows with σ and V_l", jointly);
    Ok(of_readings([written, joint]).remark(
        "For stick-slip, claim N8 from the same section states the opposite of the part that fails here.",
    ))
}

/// Neighbouring limit cycles, the one with the smaller coordinates first.
type Pairs<'r, 'c> = Box<dyn Iterator<Item = (&'r Run<'c>, &'r Run<'c>)> + 'r>;

/// Whether the peak velocity rises between all neighbours of a kind.
fn risen(grids: &[Runs], which: &str, pairs: for<'r, 'c> fn(&'r Runs<'c>) -> Pairs<'r, 'c>) -> Finding {
    let count = |grid: &Runs| share(pairs(grid), rises);
    let (passed, all) = total(grids, count);
    if all == 0 {
        return Finding::not_checked(format!("No two neighbours {which} are both limit cycles."));
    }
    let quantity = format!("Neighbouring limit cycles {which} whose peak velocity rises");
    let finding =
        Finding::from_evidence(evidence(grids, &quantity, for_each_law(grids, |grid| of(count(grid)))));
    let falling = grids.iter().find_map(|grid| pairs(grid).find(|pair| !rises(pair)).map(peaks));
    match falling {
        None => finding.on(format!("all {all} neighbours of the grid {which}")),
        Some(pair) => {
            finding.refuted(format!("it rises between {} neighbours only; {pair}", of((passed, all))))
        }
    }
}

pub(super) fn n5(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let both = |(lower, upper): &(&Run, &Run)| lower.is(SlipMode::StickSlip) && upper.is(SlipMode::StickSlip);
    let larger_and_rarer = |(lower, upper): &(&Run, &Run)| {
        upper.simulation.stress_drop_pa > lower.simulation.stress_drop_pa
            && upper.simulation.period_s > lower.simulation.period_s
    };
    let count = |grid: &Runs| share(grid.along_stress().filter(both), larger_and_rarer);
    let (passed, all) = total(&grids, count);
    Ok(Finding::from_evidence(evidence(
            &grids,
            "Neighbouring stick-slip points at the same V_l with the smaller stress drop and the shorter period at the lower σ",
            for_each_law(&grids, |grid| of(count(grid))),
        ))
        .require(all > 0 && passed == all, || format!("only {passed} of {all} neighbours")))
}

pub(super) fn n10(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let natural_s = context
        .outcome
        .potentially_unstable()
        .and_then(|scene| scene.slider())
        .map(|slider| 1.0 / slider.map(nearest_f64).natural_angular_frequency_per_s())
        .map(|unit| std::f64::consts::TAU * unit)
        .ok_or_else(|| Finding::not_checked("The scene has no parameters."))?;
    let modes = [SlipMode::HarmonicVibration, SlipMode::InertialUnderdampedOscillation];
    let mut ratios: Vec<f64> = grids
        .iter()
        .flat_map(|grid| &grid.runs)
        .filter(|run| modes.contains(&run.simulation.slip_mode))
        .filter_map(|run| run.simulation.period_s.map(|period| period / natural_s))
        .collect();
    ratios.sort_by(f64::total_cmp);
    let (Some(shortest), Some(longest)) = (ratios.first(), ratios.last()) else {
        return Err(Finding::not_checked("No run vibrates near the natural frequency."));
    };
    let within = |percent: f64| ratios.iter().filter(|ratio| **ratio <= 1.0 + percent / 100.0).count();
    let excess = |ratio: f64| format!("{} %", round_digits(100.0 * (ratio - 1.0), 3));
    Ok(Finding::from_evidence(evidence(
            &grids,
            "Excess of the period over 2π/√(K/M): minimum, maximum",
            format!("{}, {}", excess(*shortest), excess(*longest)),
        ))
        .with_evidence(Evidence::Sample {
            quantity: "Vibrations within 0.1 %, 1 % and 10 % of the natural period".into(),
            value: format!("{}, {}, {}", within(0.1), within(1.0), within(10.0)),
            points: ratios.len(),
        })
        .require(*shortest > 1.0, || format!("one period is {} of the natural period", round_digits(*shortest, 8)))
        .within(format!(
            "within 1 % in {} of {} vibrations and within 10 % in {}; every period is longer than the natural period, by up to {}",
            within(1.0),
            ratios.len(),
            within(10.0),
            excess(*longest)
        ))
        .remark("The longest periods occur at the threshold ω/ω_n = √½ that ends the two modes; there the period is √2 times the natural period."))
}
