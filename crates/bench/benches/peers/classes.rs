//! Exact class of random points, of a (V0, σ) grid and of the hard families; growth rate and frequency of single points.

use std::path::Path;

use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::{Dd, Rational};
use slipmode_core::stability::batch::{GridCell, GridKernel, PrecisionCounts, SignPair, signs_of_points};
use slipmode_core::stability::{InertialThreshold, SlipMode, classify, classify_quickly};

use super::columns::Columns;
use super::hard;
use super::random::Random;
use super::row::{Row, scientific};
use slipmode_bench::cpu_clock::best_of;

const RANDOM_POINTS: usize = 1_000_000;
const HARD_POINTS: usize = 60_000;
const SIDE: usize = 4096;

/// Every how many rows and columns of the grid go to the peers.
const STRIDE: usize = 8;

const REPETITIONS: usize = 5;

/// The paper's slider.
fn paper() -> Slider<f64> {
    Slider::from([0.004, 0.006, 1e-5, 1e7, 1000.0])
}

fn axis(low: f64, high: f64) -> Vec<f64> {
    (0..SIDE).map(|i| libm::exp10(low + (high - low) * i as f64 / (SIDE - 1) as f64)).collect()
}

fn grid_axes() -> (Vec<f64>, Vec<f64>) {
    (axis(-7.0, 1.0), axis(2.0, 9.0))
}

/// Writes the points with their references, unless an earlier run did.
pub fn prepare(folder: &Path) {
    let mut random = Random::new(5);
    write(folder, "random", || (0..RANDOM_POINTS).map(|_| random.parameters()).collect());
    for family in ["disc", "hopf", "cusp"] {
        write(folder, family, || hard::points(family, HARD_POINTS));
    }
    write(folder, "grid", || {
        let (velocities, stresses) = grid_axes();
        let at = |v: &f64, s: &f64| paper().at(*s, *v);
        let rows = velocities.iter().step_by(STRIDE);
        rows.flat_map(|v| stresses.iter().step_by(STRIDE).map(|s| at(v, s)).collect::<Vec<_>>()).collect()
    });
}

fn write(folder: &Path, family: &str, points: impl FnOnce() -> Vec<Parameters<f64>>) {
    let path = folder.join(format!("{family}.f64"));
    if !path.exists() {
        Columns::of(&points()).write(&path);
    }
}

fn signs_differ(pair: SignPair, answers: [f64; 5]) -> bool {
    f64::from(pair.transition_sign()) != answers[0] || f64::from(pair.boundary_sign()) != answers[1]
}

/// One family of points: signs of all by the batch, values of single points.
pub fn play(family: &str, folder: &Path) {
    let columns = Columns::read(&folder.join(format!("{family}.f64")));
    if family == "grid" {
        play_grid(&columns);
        return;
    }
    let inputs = columns.inputs();
    let (seconds, (signs, _)) = best_of(REPETITIONS, || signs_of_points(&inputs).unwrap());
    let wrong =
        signs.iter().enumerate().filter(|(i, pair)| signs_differ(**pair, columns.answers(*i))).count();
    let row = Row { work: format!("classes-{family}"), items: columns.len(), ..Row::default() };
    Row { method: "slipmode-signs", seconds, wrong, ..row.clone() }.print();
    let some = columns.len().min(HARD_POINTS);
    let (seconds, found) = best_of(2, || (0..some).map(|i| values(&columns.point(i))).collect::<Vec<_>>());
    let (mut wrong, mut error) = (0, 0.0f64);
    for (i, [transition, boundary, real, imaginary]) in found.into_iter().enumerate() {
        let answers = columns.answers(i);
        wrong += usize::from(transition != answers[0] || boundary != answers[1]);
        error = error.max((real - answers[2]).abs() / answers[3]);
        if answers[4] > 0.0 {
            error = error.max((imaginary / answers[4] - 1.0).abs());
        }
    }
    let one = Row { method: "slipmode-values", items: some, seconds, wrong, ..row };
    Row { error: Some(scientific(error)), ..one }.print();
}

/// Both signs, max Re and max Im.
fn values(point: &Parameters<f64>) -> [f64; 4] {
    let threshold = InertialThreshold::default();
    let found = classify_quickly(&point.map(|value| Dd::from(*value)), &threshold)
        .unwrap_or_else(|| classify(&point.map(|value| Rational::from_f64(*value).unwrap()), &threshold));
    let part = |value: slipmode_core::number::Wide| value.to_f64().unwrap_or(f64::NAN);
    [
        f64::from(found.transition_sign),
        f64::from(found.boundary_sign),
        part(found.max_real_per_s),
        part(found.max_imaginary_per_s),
    ]
}

fn play_grid(some: &Columns) {
    let (velocities, stresses) = grid_axes();
    let fixed = paper().map(|value| Rational::from_f64(*value).unwrap());
    let kernel = GridKernel::new(&fixed, &InertialThreshold::default(), &stresses).unwrap();
    let mut cells = vec![GridCell::new(SignPair::new(0, 0), SlipMode::StickSlip); SIDE * SIDE];
    let (seconds, _) = best_of(REPETITIONS, || {
        let mut counts = PrecisionCounts::default();
        for (&velocity, row) in velocities.iter().zip(cells.chunks_mut(SIDE)) {
            counts += kernel.classify_row(velocity, row).unwrap();
        }
        counts
    });
    let side = SIDE / STRIDE;
    let wrong = (0..some.len())
        .filter(|i| {
            signs_differ(cells[(i / side) * STRIDE * SIDE + (i % side) * STRIDE].signs(), some.answers(*i))
        })
        .count();
    let work = "classes-grid".to_string();
    Row { work, method: "slipmode-signs", items: SIDE * SIDE, seconds, wrong, ..Row::default() }.print();
}
