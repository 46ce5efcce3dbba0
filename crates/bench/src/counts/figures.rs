//! Diagrams of work against error by counts.

use super::{RootCount, SpeedCounts, SweepCount};
use crate::chart::{Chart, LogAxis, marked};

/// The two diagrams.
#[must_use]
pub fn figures(counts: &SpeedCounts) -> Vec<Chart> {
    vec![roots(counts), sweep(counts)]
}

/// Below one digit nothing is right; the axis needs a place for it.
const LEAST_DIGITS: f64 = 1.0;

fn roots(counts: &SpeedCounts) -> Chart {
    let rows = &counts.roots;
    let place = |row: &RootCount| Some((f64::from(row.bits), row.digits_right?.max(LEAST_DIGITS)));
    let line = |set: &str| {
        let certified = rows.iter().filter(|row| row.set == set && row.method == "certified");
        marked(&format!("certified, {set}"), certified.filter_map(place).collect())
    };
    let alone = |method: &str| {
        marked(method, rows.iter().filter(|row| row.method == method).filter_map(place).collect())
    };
    let series = vec![
        line("random"),
        line("hard"),
        alone("double-double with bounds"),
        alone("64-bit with bounds"),
        alone("companion eigenvalues"),
        alone("Cardano"),
    ];
    Chart {
        id: "speed-roots",
        data: &["speed-roots"],
            label: "Figure P1",
            title: "Correct digits against bits of the arithmetic, three roots of a cubic".into(),
            caption: "Correct digits in the worst root of a set, against the bits of the arithmetic. Certified roots use as many additional bits as the cubic loses, a number that is known in advance; the other methods lose digits. The two marks of a method are the two sets of the table. A mark at one digit means that no digit is correct.".into(),
            description: "Correct digits in the worst root against bits of the arithmetic, on logarithmic axes. Certified roots lie on a straight line up to ten thousand digits; 64-bit methods lie below it.",
        x: LogAxis::new("Bits of the arithmetic", ""),
        y: LogAxis::new("Correct digits, worst root", ""),
        series,
        vertical: None,
    }
}

fn sweep(counts: &SpeedCounts) -> Chart {
    let rows = &counts.sweep;
    let per_run = |count: u64, runs: usize| count as f64 / runs.max(1) as f64;
    let line = |label, of: fn(&SweepCount) -> u64| {
        marked(label, rows.iter().map(|row| (per_run(of(row), row.runs), row.worst_error)).collect())
    };
    Chart {
        id: "speed-sweep",
        data: &["speed-sweep"],
            label: "Figure P3",
            title: "Largest error of a sweep against its work".into(),
            caption: "Largest relative error of peak velocity and period over a sweep of both laws, against steps and right-hand sides per run, one mark per tolerance.".into(),
            description: "Largest relative error of a sweep against steps and evaluations per run, on logarithmic axes. The line of evaluations falls steeply; the line of steps turns back where the method changes.",
        x: LogAxis::new("Count per run", ""),
        y: LogAxis::new("Largest relative error", ""),
        series: vec![line("right-hand sides", |row| row.evaluations), line("steps", |row| row.steps)],
        vertical: None,
    }
}
