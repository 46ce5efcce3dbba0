//! Claims N on peak velocity, stress drop and period across the grid.

use crate::claims::certified::{Pair, Pairs, both_certainly, both_cycle, grows_and_slows, rises};
use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::{Deviations, Measure};
use crate::claims::simulated::{Runs, evidence, grids};
use crate::claims::simulated_least_peak::extent;
use crate::claims::{Evidence, Finding};
use crate::experiments::{Context, Outcome};
use slipmode_core::number::format::{Side, round_digits, rounded};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::SlipMode;

/// Between which peaks a pair lies, for people.
pub(super) fn peaks(pair: Pair) -> String {
    format!(
        "from {} to {} the peak velocity goes from {} to {} m/s",
        pair.0.place(),
        pair.1.place(),
        round_digits(pair.0.simulation.peak_velocity_m_per_s, 4),
        round_digits(pair.1.simulation.peak_velocity_m_per_s, 4)
    )
}

pub(super) fn peak_rises(context: &Context) -> Result<Finding, Finding> {
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
    Ok(of_readings([written, joint]))
}

/// Neighbouring limit cycles of a grid.
type Neighbours<'r, 'c> = Box<dyn Iterator<Item = Pair<'r, 'c>> + 'r>;

/// Whether the peak velocity rises between all neighbours of a kind.
fn risen(
    grids: &[Runs],
    which: &str,
    neighbours: for<'r, 'c> fn(&'r Runs<'c>) -> Neighbours<'r, 'c>,
) -> Finding {
    let pairs = Pairs::new(grids, neighbours, |pair| rises(pair).among(both_cycle(pair)));
    if pairs.count() == 0 {
        return Finding::not_checked(format!("No two neighbours {which} are both limit cycles."));
    }
    let quantity = format!("Neighbouring limit cycles {which} whose peak velocity rises");
    let finding = pairs.finding(&quantity, |pairs| {
        let pair = pairs.failing().map_or_else(String::new, peaks);
        format!("it rises between {} neighbours only; {pair}", pairs.share())
    });
    match pairs.failing() {
        None => finding.on(format!("all {} neighbours of the grid {which}", pairs.count())),
        Some(_) => finding,
    }
}

pub(super) fn drop_and_period_fall(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let natural_s = natural_period_s(context)?;
    let both = |(lower, upper): &Pair| lower.is(SlipMode::StickSlip) && upper.is(SlipMode::StickSlip);
    let certainly = |pair: &Pair| both_certainly(pair, SlipMode::StickSlip, natural_s);
    let pairs = Pairs::new(
        &grids,
        |grid| grid.along_stress().filter(both),
        |pair| grows_and_slows(pair).among(certainly(pair)),
    );
    Ok(pairs
        .finding(
            "Neighbouring stick-slip points at the same V_l with the smaller stress drop and the shorter period at the lower σ",
            |pairs| format!("only {} neighbours", pairs.share()),
        )
        .require(pairs.count() > 0, || "only 0 of 0 neighbours".into()))
}

/// 2π/√(K/M) of the slider of the simulations, s.
pub(super) fn natural_period_s(context: &Context) -> Result<f64, Finding> {
    let scene = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let slider = scene.ok_or_else(|| Finding::not_checked("The scene has no parameters."))?;
    Ok(std::f64::consts::TAU / slider.map(nearest_f64).natural_angular_frequency_per_s())
}

pub(super) fn period_of_vibration(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let natural_s = natural_period_s(context)?;
    let modes = [SlipMode::HarmonicVibration, SlipMode::InertialUnderdampedOscillation];
    let vibrations = || {
        let named =
            grids.iter().flat_map(|grid| &grid.runs).filter(|run| modes.contains(&run.simulation.slip_mode));
        named.filter_map(|run| Some((run, run.simulation.period_s? / natural_s)))
    };
    let ratios: Vec<f64> = vibrations().map(|(_, ratio)| ratio).collect();
    let (shortest, longest) = extent(ratios.iter().copied());
    if ratios.is_empty() {
        return Err(Finding::not_checked("No run vibrates near the natural frequency."));
    }
    let within = |percent: f64| ratios.iter().filter(|ratio| **ratio <= 1.0 + percent / 100.0).count();
    let excess = |ratio: f64| format!("{} %", round_digits(100.0 * (ratio - 1.0), 3));
    let frequencies = vibrations().map(|(run, ratio)| {
        let error = run.simulation.period_relative_error.unwrap_or(0.0);
        (1.0 / ratio - 1.0, error / ratio)
    });
    let finding = Finding::from_evidence(evidence(
        &grids,
        "Excess of the period over 2π/√(K/M): minimum, maximum",
        format!("{}, {}", excess(shortest), excess(longest)),
    ))
    .with_evidence(Evidence::Sample {
        quantity: "Vibrations within 0.1 %, 1 % and 10 % of the natural period".into(),
        value: format!("{}, {}, {}", within(0.1), within(1.0), within(10.0)),
        points: ratios.len(),
    })
    .require(shortest > 1.0, || format!("one period is {} of the natural period", round_digits(shortest, 8)))
    .near(context.kind, &Deviations::new(Measure::Value, frequencies))
    .number("lowest", rounded(1.0 / longest, 2, Side::Below));
    Ok(finding)
}
