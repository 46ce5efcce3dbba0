//! What a user calls for points in 64 bits: the signs of many at once, and signs with max Re(s) and max Im(s), three roots.
//!
//! The points are random ones, the hard families, and for the signs a (V0, σ) grid. Other programs compute three roots for each of these.

use std::path::{Path, PathBuf};

use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::{Dd, Rational, Wide};
use slipmode_core::stability::batch::{
    GridCell, GridKernel, PrecisionCounts, SignPair, classify_points, signs_of_points, three_roots_of_points,
};
use slipmode_core::stability::{
    Classification, InertialThreshold, SlipMode, ThreeRoots, classify, classify_quickly, three_roots,
};

use super::columns::{Answers, Columns};
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
    let path = file(folder, family);
    if !path.exists() {
        Columns::of(&points()).write(&path);
    }
}

fn file(folder: &Path, family: &str) -> PathBuf {
    folder.join(format!("points-{family}.f64"))
}

fn signs_differ(transition_sign: i8, boundary_sign: i8, answers: &Answers) -> bool {
    [transition_sign, boundary_sign].map(f64::from) != [answers.transition_sign, answers.boundary_sign]
}

fn pair_differs(pair: SignPair, answers: &Answers) -> bool {
    signs_differ(pair.transition_sign(), pair.boundary_sign(), answers)
}

/// The signs of one family of points, or of the grid.
pub fn play_signs(family: &str, folder: &Path) {
    let columns = Columns::read(&file(folder, family));
    if family == "grid" {
        play_grid(&columns);
        return;
    }
    let inputs = columns.inputs();
    let (seconds, (signs, _)) = best_of(REPETITIONS, || signs_of_points(&inputs).unwrap());
    let wrong =
        signs.iter().enumerate().filter(|(i, pair)| pair_differs(**pair, &columns.answers(*i))).count();
    Row {
        work: format!("signs-{family}"),
        method: "slipmode-signs",
        options: "signs_of_points;one~call~for~all~points",
        items: columns.len(),
        seconds,
        wrong,
        ..Row::default()
    }
    .print();
}

/// Both signs, max Re(s) and max Im(s) of all points at once, and of one point after the other.
pub fn play_extremes(family: &str, folder: &Path) {
    let columns = Columns::read(&file(folder, family));
    let points: Vec<Parameters<f64>> =
        (0..columns.len().min(HARD_POINTS)).map(|i| columns.point(i)).collect();
    let threshold = InertialThreshold::default();
    let exactly = |point: &Parameters<f64>| {
        classify(&point.map(|value| Rational::from_f64(*value).unwrap()), &threshold)
    };
    let doubled = |point: &Parameters<f64>| point.map(|value| Dd::from(*value));
    let all = || {
        let found = classify_points(&points.iter().map(doubled).collect::<Vec<_>>(), &threshold);
        let or_exactly =
            |(found, point): (Option<Classification>, _)| found.unwrap_or_else(|| exactly(point));
        found.into_iter().zip(&points).map(or_exactly).collect()
    };
    let options = "classify_points~or~classify;one~call~for~all~points";
    print_extremes(family, "slipmode-extremes", options, &columns, best_of(REPETITIONS, all));
    let one = |point| classify_quickly(&doubled(point), &threshold).unwrap_or_else(|| exactly(point));
    let one_by_one = || points.iter().map(one).collect();
    let options = "classify_quickly~or~classify;one~call~for~each~point";
    print_extremes(family, "slipmode-extremes-single", options, &columns, best_of(REPETITIONS, one_by_one));
}

fn print_extremes(
    family: &str,
    method: &'static str,
    options: &'static str,
    columns: &Columns,
    (seconds, found): (f64, Vec<Classification>),
) {
    let (mut wrong, mut error) = (0, 0.0f64);
    for (i, found) in found.iter().enumerate() {
        let answers = columns.answers(i);
        let part = |value: &Wide| value.to_f64().unwrap_or(f64::INFINITY);
        wrong += usize::from(signs_differ(found.transition_sign, found.boundary_sign, &answers));
        error = error.max((part(&found.max_real_per_s) - answers.max_real).abs() / answers.modulus);
        if answers.max_imaginary > 0.0 {
            error = error.max((part(&found.max_imaginary_per_s) / answers.max_imaginary - 1.0).abs());
        }
    }
    Row {
        work: format!("extremes-{family}"),
        method,
        options,
        items: found.len(),
        seconds,
        error: Some(scientific(error)),
        wrong,
        ..Row::default()
    }
    .print();
}

/// Three roots of all points at once, and of one point after the other.
pub fn play_cubic(family: &str, folder: &Path) {
    let columns = Columns::read(&file(folder, family));
    let some = columns.len().min(HARD_POINTS);
    let inputs = columns.inputs().map(|column| &column[..some]);
    let all = || three_roots_of_points(&inputs).unwrap();
    let options = "three_roots_of_points;one~call~for~all~points";
    print_roots(family, "slipmode-three-roots", options, &columns, best_of(REPETITIONS, all));
    let one_by_one = || (0..some).map(|i| three_roots(&columns.point(i)).unwrap()).collect();
    let options = "three_roots;one~call~for~each~point";
    print_roots(family, "slipmode-three-roots-single", options, &columns, best_of(REPETITIONS, one_by_one));
}

fn print_roots(
    family: &str,
    method: &'static str,
    options: &'static str,
    columns: &Columns,
    (seconds, found): (f64, Vec<ThreeRoots>),
) {
    let is_pair = |found: &ThreeRoots| found.roots[2].im > 0.0;
    let kind_differs =
        |(i, found): &(usize, &ThreeRoots)| is_pair(found) != (columns.answers(*i).boundary_sign < 0.0);
    let errors = found.iter().enumerate().map(|(i, found)| columns.root_error(i, &found.roots));
    Row {
        work: format!("cubic-{family}"),
        method,
        options,
        items: found.len(),
        seconds,
        error: Some(scientific(errors.fold(0.0, f64::max))),
        wrong: found.iter().enumerate().filter(kind_differs).count(),
        ..Row::default()
    }
    .print();
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
            pair_differs(cells[(i / side) * STRIDE * SIDE + (i % side) * STRIDE].signs(), &some.answers(*i))
        })
        .count();
    Row {
        work: "signs-grid".into(),
        method: "slipmode-signs",
        options: "GridKernel;one~call~for~each~grid~row",
        items: SIDE * SIDE,
        seconds,
        wrong,
        ..Row::default()
    }
    .print();
}
