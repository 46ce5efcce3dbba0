//! The boundary at given σ and at given V0 by digits: Newton steps and precision by count, and the CPU time of a crossing.
//!
//! The sections are those of [`HardSections`], at which the library's tests bound the same counts for each crossing.

use std::hint::black_box;

use slipmode_core::stability::boundary::hard_sections::{DIGITS, HardSections};
use slipmode_core::stability::boundary::{BoundaryCurve, Section, Work};

use super::Sweep;
use crate::cpu_clock::cpu_seconds;

/// Rounds in which all digits of a section take turns; the fastest counts.
const ROUNDS: usize = 5;

/// Repetitions of a section between two readings of the clock.
const REPETITIONS: usize = 8;

/// A section with the curve of each number of digits.
struct Case<'c> {
    section: &'c Section,
    curves: &'c [BoundaryCurve],
}

/// Both kinds of section.
pub(super) fn sweeps() -> Result<Vec<Sweep>, String> {
    let sections = HardSections::all();
    let curves: Vec<Vec<BoundaryCurve>> = sections
        .iter()
        .map(|one| DIGITS.map(|digits| BoundaryCurve::new(&one.slider, digits)).to_vec())
        .collect();
    let mut sweeps = Vec::new();
    for (kind, of) in [
        ("given normal stress", (|one| &one.at_normal_stress) as fn(&HardSections) -> &Vec<Section>),
        ("given velocity", |one| &one.at_velocity),
    ] {
        let cases: Vec<Case<'_>> = sections
            .iter()
            .zip(&curves)
            .flat_map(|(one, curves)| of(one).iter().map(|section| Case { section, curves }))
            .collect();
        sweeps.extend(counts(kind, &cases)?);
        sweeps.extend(times(kind, &cases));
    }
    Ok(sweeps)
}

fn sweep(
    kind: &str,
    what: &str,
    quantity: &'static str,
    values: impl IntoIterator<Item = f64>,
    allowed_ratio: std::ops::RangeInclusive<f64>,
) -> Sweep {
    Sweep {
        name: format!("boundary at {kind}: {what}"),
        variable: "digits",
        quantity,
        points: DIGITS.iter().map(u32::to_string).zip(values).collect(),
        allowed_ratio,
    }
}

/// Means over all crossings. A crossing that takes the general way is an error.
fn counts(kind: &str, cases: &[Case<'_>]) -> Result<[Sweep; 3], String> {
    let mut means = [[0.0; DIGITS.len()]; 3];
    for (index, digits) in DIGITS.iter().enumerate() {
        let mut crossings = 0.0;
        for case in cases {
            for work in case.curves[index].work(case.section) {
                let work: Work = work.ok_or_else(|| {
                    format!("boundary at {kind}: {:?} takes the general way at {digits} digits", case.section)
                })?;
                let last = f64::from(*work.newton_bits.last().unwrap_or(&0));
                let all = [work.newton_bits.len() as f64, last, f64::from(work.evaluation_bits)];
                means.iter_mut().zip(all).for_each(|(mean, value)| mean[index] += value);
                crossings += 1.0;
            }
        }
        means.iter_mut().for_each(|mean| mean[index] /= crossings);
    }
    let [steps, last, evaluation] = means;
    // Twice the digits take twice the bits and one step more.
    Ok([
        sweep(kind, "Newton steps", "mean number of Newton steps", steps, 1.0..=2.0),
        sweep(kind, "precision of the last step", "mean bits", last, 1.0..=2.0),
        sweep(kind, "precision of the evaluation", "mean bits", evaluation, 1.0..=2.0),
    ])
}

fn times(kind: &str, cases: &[Case<'_>]) -> [Sweep; 2] {
    let mut microseconds: [Vec<f64>; DIGITS.len()] = Default::default();
    for case in cases {
        let crossings = case.curves[0].crossings(case.section).len();
        if crossings == 0 {
            continue;
        }
        let mut best = [f64::INFINITY; DIGITS.len()];
        for _ in 0..ROUNDS {
            for (curve, best) in case.curves.iter().zip(&mut best) {
                let start = cpu_seconds();
                for _ in 0..REPETITIONS {
                    black_box(curve.crossings(case.section));
                }
                *best = best.min((cpu_seconds() - start) * 1e6 / (REPETITIONS * crossings) as f64);
            }
        }
        microseconds.iter_mut().zip(best).for_each(|(all, best)| all.push(best));
    }
    microseconds.iter_mut().for_each(|all| all.sort_by(f64::total_cmp));
    let at = |share: f64| microseconds.each_ref().map(|all| all[((all.len() - 1) as f64 * share) as usize]);
    [
        sweep(kind, "time of a crossing, median", "CPU us", at(0.5), 0.8..=1.5),
        sweep(kind, "time of a crossing, 99 %", "CPU us", at(0.99), 0.7..=1.5),
    ]
}
