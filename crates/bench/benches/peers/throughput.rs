//! Sets of runs where nothing is stiff: CPU time of a run in throughput, one method and tolerance for the whole set.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use slipmode_core::dynamics::{Model, Stepper, Taylor};
use slipmode_core::friction::EvolutionLaw;

use super::cycles::{Line, paper, read_lines};
use super::row::{Row, scientific, tolerances};
use super::smooth::{line_with_reference, samples};
use slipmode_bench::cpu_clock::best_of;

/// Velocities and stresses of a set, each: sixteen runs fill two times eight lanes.
const SIDE: usize = 4;
const REPETITIONS: usize = 5;

/// A name, the law, a and b. Vibration under the aging law is stiff and left out.
const SETS: [(&str, EvolutionLaw, f64, f64); 3] = [
    ("harmonic-slip", EvolutionLaw::Slip, 0.004, 0.006),
    ("underdamped-slip", EvolutionLaw::Slip, 0.006, 0.004),
    ("underdamped-aging", EvolutionLaw::Aging, 0.006, 0.004),
];

/// Writes `throughput.txt`: lines as those of `smooth.txt`, V_l from 0.03 to 0.08 m/s and σ from 4 to 10 kPa.
pub fn prepare(folder: &Path) {
    let at = |middle: f64, i: usize| middle - 0.2 + 0.4 * i as f64 / (SIDE - 1) as f64;
    let mut text = String::new();
    for (name, law, a, b) in SETS {
        for cell in 0..SIDE * SIDE {
            let model = Model::new(paper(at(-1.3, cell / SIDE), at(3.8, cell % SIDE), a, b), law);
            // The reference of every run is finished, or its set would not fill the lanes.
            writeln!(text, "{}", line_with_reference(name, &model).unwrap()).unwrap();
        }
    }
    fs::write(folder.join("throughput.txt"), text).unwrap();
}

fn measure<M: Stepper<f64> + Clone>(name: &'static str, set: &[Line], method: &M) {
    for tolerance in tolerances() {
        let run = |line: &Line| {
            let start = [line.rest[0], line.rest[1], line.rest[2]];
            samples(&line.model, method.clone(), start, &line.rest[3], tolerance)
        };
        let (seconds, found) = best_of(REPETITIONS, || set.iter().map(run).collect::<Vec<_>>());
        let (mut worst, mut failed, mut counts) = (0.0f64, 0, (0, 0));
        for (line, found) in set.iter().zip(&found) {
            let Some((samples, steps, evaluations)) = found else {
                failed += 1;
                continue;
            };
            let end = samples[samples.len() - 1];
            worst = (0..3).fold(worst, |worst, i| worst.max((end[i] - line.rest[4 + i]).abs()));
            counts = (counts.0 + steps, counts.1 + evaluations);
        }
        Row {
            work: format!("throughput-{}", set[0].name),
            method: name,
            options: "one~run~at~a~time",
            tolerance: Some(tolerance),
            items: set.len(),
            seconds,
            error: Some(scientific(worst)),
            wrong: failed,
            counts: Some(counts),
        }
        .print();
    }
}

/// Every set by Taylor series of two degrees.
pub fn play(folder: &Path) {
    let lines = read_lines(&folder.join("throughput.txt"));
    for set in lines.chunk_by(|one, next| one.name == next.name) {
        measure("slipmode-taylor16", set, &Taylor::<f64, 16>::new());
        measure("slipmode-taylor20", set, &Taylor::<f64, 20>::new());
    }
}
