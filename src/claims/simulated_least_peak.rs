//! Where the peak velocity turns from falling to rising, against eq 18 and against the change of mode.

use crate::claims::certified::{Pair, Pairs, both_certainly, rises};
use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::{Deviations, Measure};
use crate::claims::simulated::{grids, outcome};
use crate::claims::simulated_trends::{natural_period_s, peaks};
use crate::claims::{Evidence, Finding};
use crate::experiments::simulations::{FLATNESS_LEVELS, LeastPeak, SIDE_WIDTH};
use crate::experiments::{Context, Outcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::{Side, round_digits, rounded};
use slipmode_core::stability::SlipMode;

/// Normal stresses that the claim must be evaluated at, for each law.
const FEWEST_STRESSES: usize = 10;

/// Least and greatest of some numbers.
pub(super) fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

pub(super) fn range((low, high): (f64, f64), digits: usize) -> String {
    format!("{} to {}", round_digits(low, digits), round_digits(high, digits))
}

/// Width of the flat part at a level, where both its sides were found.
fn width(least: &LeastPeak, level: usize) -> Option<f64> {
    let [lower, upper] = least.flat[level];
    Some(upper? - lower?)
}

pub(super) fn velocity_of_least_peak(context: &Context) -> Result<Finding, Finding> {
    let least = &outcome(context, Outcome::potentially_unstable)?.least_peaks;
    let by = |law: EvolutionLaw| least.iter().filter(move |found| found.law == law);
    if EvolutionLaw::ALL.iter().any(|&law| by(law).count() < FEWEST_STRESSES) {
        return Err(Finding::not_checked(
            "The peak velocity was minimised at fewer than ten normal stresses.",
        ));
    }
    let offsets = extent(least.iter().map(|found| found.offset_dex));
    let error = least.iter().map(|found| found.offset_error_dex).fold(0.0, f64::max);
    let excess = least.iter().map(|found| found.peak_at_eq18_over_least).fold(1.0, f64::max);
    let each = |found: &LeastPeak| {
        format!(
            "{} {} Pa {}",
            found.law.as_str(),
            round_digits(found.normal_stress_pa, 4),
            round_digits(found.offset_dex, 4)
        )
    };
    let finding = Finding::from_evidence(Evidence::Simulation {
        quantity: "log10 of the minimising velocity divided by that of eq 18: law, σ, offset".into(),
        value: least.iter().map(each).collect::<Vec<_>>().join("; "),
        error: format!("{} dex at most", round_digits(error, 2)),
        runs: least.len(),
    });
    let deviations = least.iter().map(|found| (found.offset_dex, found.offset_error_dex));
    let deviations = Deviations::new(Measure::Place, deviations);
    let widths = |level: usize| extent(least.iter().filter_map(|found| width(found, level)));
    let percent = |value: f64| round_digits(100.0 * value, 3);
    // The flat part explains the claim where eq 18 lies in it.
    let inside = |level: usize| {
        least.iter().filter(|found| found.peak_at_eq18_over_least <= 1.0 + FLATNESS_LEVELS[level]).count()
    };
    Ok(finding
        .with_evidence(Evidence::Simulation {
            quantity: format!(
                "Width of the range of V_l whose peak is within {} % and {} % of the minimum, in dex",
                percent(FLATNESS_LEVELS[0]),
                percent(FLATNESS_LEVELS[1])
            ),
            value: format!("{}; {}", range(widths(0), 3), range(widths(1), 3)),
            error: format!("{SIDE_WIDTH} dex at each end"),
            runs: least.len(),
        })
        .near(context.kind, &deviations)
        .number("low", rounded(offsets.0, 2, Side::Below))
        .number("high", rounded(offsets.1, 2, Side::Above))
        .number("excess", format!("{} %", rounded(100.0 * (excess - 1.0), 3, Side::Above)))
        .remark(format!(
            "The peak at eq 18 is at most {} % above the minimum, and within {} % of it in {} of {} cases.",
            rounded(100.0 * (excess - 1.0), 3, Side::Above),
            percent(FLATNESS_LEVELS[1]),
            inside(1),
            least.len()
        ))
        .remark("Fig 5 divides by the peak at one velocity. This does not move the minimum.")
        .remark("The minimum is flat, so a grid of quarter decades locates it only to within one grid step."))
}

pub(super) fn peak_along_velocity(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let natural_s = natural_period_s(context)?;
    let by_mode = |mode: SlipMode, falls: bool| {
        let both = move |(first, second): &Pair| first.is(mode) && second.is(mode);
        Pairs::new(
            &grids,
            move |grid| grid.along_velocity().filter(both),
            move |pair| {
                let rises = rises(pair).among(both_certainly(pair, mode, natural_s));
                if falls { rises.not() } else { rises }
            },
        )
    };
    let [falling, rising] = [by_mode(SlipMode::StickSlip, true), by_mode(SlipMode::HarmonicVibration, false)];
    if falling.count() == 0 || rising.count() == 0 {
        return Err(Finding::not_checked(
            "No two neighbours of the grid are both stick-slip, or both harmonic.",
        ));
    }
    let in_stick_slip = falling.finding(
        "Neighbouring stick-slip points at the same σ whose peak velocity falls with V_l",
        |pairs| {
            let pair = pairs.failing().map_or_else(String::new, peaks);
            format!("it falls between {} neighbours only; {pair}", pairs.share())
        },
    );
    let rest = falling.count() - falling.passed();
    let in_stick_slip = in_stick_slip.number("share", format!("{rest} of {}", falling.count()));
    let in_stick_slip = match falling.failing() {
        None => in_stick_slip.on(format!("all {} neighbours of the grid", falling.count())),
        Some(_) => in_stick_slip,
    };
    let in_vibration = rising
        .finding(
            "Neighbouring points of harmonic vibration at the same σ whose peak velocity rises with V_l",
            |pairs| format!("it rises between {} neighbours only", pairs.share()),
        )
        .on(format!("{} neighbours of the grid", rising.count()));
    let written = Draft::new("the modes by the period of the cycle")
        .part("in stick-slip the peak velocity falls with V_l", in_stick_slip)
        .part("in harmonic vibration the peak velocity rises with V_l", in_vibration);
    let least = &outcome(context, Outcome::potentially_unstable)?.least_peaks;
    let after = |change: fn(&LeastPeak) -> Option<f64>| {
        extent(least.iter().filter_map(|found| Some(change(found)? - found.offset_dex)))
    };
    let (cycle, theory) =
        (after(|found| found.cycle_mode_change_dex), after(|found| found.theory_mode_change_dex));
    Ok(of_readings([written])
        .with_supporting(Evidence::Simulation {
            quantity: "log10 of the ratio of two velocities, where the mode changes and where the peak is lowest: for the mode of the cycle; for the mode of small deviations by the exact theory".into(),
            value: format!("{} dex; {} dex", range(cycle, 3), range(theory, 3)),
            error: format!("{SIDE_WIDTH} dex"),
            runs: least.len(),
        })
        .remark(format!(
            "The peak is lowest while the cycle is still stick-slip: its frequency passes the threshold {} dex above the velocity of the lowest peak.",
            range(cycle, 3)
        )))
}
