//! The sweep of 20 × 20 sliders (V_l 1e-6…1e-1 m/s, σ 1e3…1e7 Pa), both laws: runs a second at an error of one per cent.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use slipmode_core::dynamics::{LongTerm, Model, Options, simulate_model};
use slipmode_core::friction::EvolutionLaw;

use super::cycles::{line_start, paper, read_lines};
use super::row::{Row, scientific};
use slipmode_bench::cpu_clock::best_of;

const SIDE: usize = 20;

/// The error that counts as right: relative, of the peak velocity.
const ERROR: f64 = 1e-2;

/// Writes `sweep.txt`: name, law, groups, 1 for a cycle and 0 for a return to rest, and ln(V_peak/V_l), found at 1e-6.
pub fn prepare(folder: &Path) {
    let path = folder.join("sweep.txt");
    if path.exists() {
        return;
    }
    let fine = Options::at(1e-6);
    let at = |low: f64, high: f64, i: usize| low + (high - low) * i as f64 / (SIDE - 1) as f64;
    let mut text = String::new();
    for law in EvolutionLaw::ALL {
        for cell in 0..SIDE * SIDE {
            let (v, s) = (at(-6.0, -1.0, cell / SIDE), at(3.0, 7.0, cell % SIDE));
            let model = Model::new(paper(v, s, 0.004, 0.006), law);
            let outcome = simulate_model(&model, &fine).unwrap();
            let cycle = i32::from(matches!(outcome.long_term(), LongTerm::Cycle(_)));
            let head = line_start(&cell.to_string(), &model);
            writeln!(text, "{head} {cycle} {:e}", outcome.log_peak()).unwrap();
        }
    }
    fs::write(path, text).unwrap();
}

/// All runs in turn on one core.
pub fn play(folder: &Path) {
    let lines = read_lines(&folder.join("sweep.txt"));
    let options = Options::at(ERROR);
    let (seconds, found) =
        best_of(2, || lines.iter().map(|line| simulate_model(&line.model, &options)).collect::<Vec<_>>());
    let (mut wrong, mut worst, mut steps) = (0, 0.0f64, 0);
    for (line, found) in lines.iter().zip(&found) {
        let Ok(outcome) = found else {
            wrong += 1;
            continue;
        };
        let cycle = f64::from(i32::from(matches!(outcome.long_term(), LongTerm::Cycle(_))));
        let error = libm::expm1(outcome.log_peak() - line.rest[1]).abs();
        wrong += usize::from(cycle != line.rest[0] || error > ERROR);
        worst = worst.max(error);
        steps += outcome.steps();
    }
    Row {
        work: "sweep".into(),
        method: "slipmode-simulate",
        options: "simulate_model;one~thread",
        tolerance: Some(ERROR),
        items: lines.len(),
        seconds,
        error: Some(scientific(worst)),
        wrong,
        counts: Some((steps, 0)),
    }
    .print();
}
