//! Exact classification of a 4096 × 4096 (V0, σ) grid on one core, against 64-bit Cardano, with its count of wrong answers.
//!
//! Times depend on the machine and on its load: read the ratios. Alternatives are run in turn, medians are printed.

use std::hint::black_box;
use std::time::Instant;

use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
use slipmode_core::stability::batch::{GridCell, GridKernel, PrecisionCounts, SignPair, signs_of_points};
use slipmode_core::stability::{InertialThreshold, SlipMode, classify};

const SIDE: usize = 4096;
const REPETITIONS: usize = 5;

fn paper(a: &str, b: &str) -> Slider<Rational> {
    let number = |text: &str| parse_decimal(text).unwrap();
    Slider::from([number(a), number(b), number("1e-5"), number("1e7"), number("1000")])
}

fn axis(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| libm::exp10(from + (to - from) * i as f64 / (count - 1) as f64)).collect()
}

fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}

fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = black_box(work());
    (start.elapsed().as_secs_f64(), result)
}

/// The alternative: 64-bit groups, the signs of Cardano's discriminant (q/2)² + (p/3)³ and of the margin as they come.
fn cardano_row(slider: &Slider<f64>, velocity: f64, stresses: &[f64], cells: &mut [SignPair]) {
    for (cell, &stress) in cells.iter_mut().zip(stresses) {
        let groups = slider.at(stress, velocity).groups();
        let [c0, c1, c2, c3] = groups.characteristic_cubic();
        let (a, b, c) = (c2 / c3, c1 / c3, c0 / c3);
        let third = b / 3.0 - a * a / 9.0;
        let half = a * a * a / 27.0 - a * b / 6.0 + c / 2.0;
        let real = half * half + third * third * third <= 0.0;
        let stable = groups.transition_margin() > 0.0;
        *cell = SignPair::new(if stable { 1 } else { -1 }, if real { 1 } else { -1 });
    }
}

fn grid_case(name: &str, slider: &Slider<Rational>) {
    let (velocities, stresses) = (axis(-7.0, 1.0, SIDE), axis(2.0, 9.0, SIDE));
    let kernel = GridKernel::new(slider, &InertialThreshold::default(), &stresses).unwrap();
    let blank = GridCell::new(SignPair::new(0, 0), SlipMode::StickSlip);
    let slider_64 = slider.map(nearest_f64);
    let (mut exact_cells, mut cardano_cells) =
        (vec![blank; SIDE * SIDE], vec![SignPair::new(0, 0); SIDE * SIDE]);
    let (mut exact_times, mut cardano_times) = (Vec::new(), Vec::new());
    let mut counts = PrecisionCounts::default();
    for _ in 0..REPETITIONS {
        counts = PrecisionCounts::default();
        let (seconds, ()) = timed(|| {
            for (&velocity, row) in velocities.iter().zip(exact_cells.chunks_mut(SIDE)) {
                counts += kernel.classify_row(velocity, row).unwrap();
            }
        });
        exact_times.push(seconds);
        let (seconds, ()) = timed(|| {
            for (&velocity, row) in velocities.iter().zip(cardano_cells.chunks_mut(SIDE)) {
                cardano_row(&slider_64, velocity, &stresses, row);
            }
        });
        cardano_times.push(seconds);
    }
    let wrong =
        exact_cells.iter().zip(&cardano_cells).filter(|(exact, other)| exact.signs() != **other).count();
    let (exact, cardano) = (median(exact_times), median(cardano_times));
    let rate = (SIDE * SIDE) as f64 / exact / 1e6;
    println!(
        "{name}: exact grid {rate:.0} million decisions/s on one core, {:.2} x 64-bit Cardano",
        cardano / exact
    );
    println!("  Cardano answers {wrong} of {} points wrongly, the exact grid none", SIDE * SIDE);
    println!("  rungs: f64 {}, double-double {}, exact {}", counts.f64, counts.double_double, counts.exact);
}

fn points_case() {
    let count = 1 << 20;
    let column = |from: f64, to: f64, stride: usize| -> Vec<f64> {
        // A full-period sequence of the exponents: deterministic, and different in every column.
        axis(from, to, count)
            .iter()
            .enumerate()
            .map(|(i, _)| i * stride % count)
            .map(|i| libm::exp10(from + (to - from) * i as f64 / count as f64))
            .collect()
    };
    let columns = [
        column(-4.0, -1.5, 7_919),
        column(-4.0, -1.5, 104_729),
        column(-7.0, -2.0, 15_485_863),
        column(4.0, 12.0, 32_452_843),
        column(-2.0, 7.0, 49_979_687),
        column(2.0, 9.0, 67_867_967),
        column(-9.0, 1.0, 86_028_121),
    ];
    let points = Parameters::from(columns.each_ref().map(Vec::as_slice));
    let mut counts = PrecisionCounts::default();
    let times = (0..REPETITIONS)
        .map(|_| {
            let (seconds, found) = timed(|| signs_of_points(&points).unwrap());
            counts = found.1;
            seconds
        })
        .collect();
    let threads = rayon::current_num_threads() as f64;
    let rate = count as f64 / median(times) / 1e6;
    println!(
        "seven columns: {:.0} million decisions/s per core ({threads} cores); rungs: f64 {}, double-double {}, exact {}",
        rate / threads,
        counts.f64,
        counts.double_double,
        counts.exact
    );
}

fn value_case(slider: &Slider<Rational>) {
    let (velocities, stresses) = (axis(-7.0, 1.0, 64), axis(2.0, 9.0, 256));
    let points = (velocities.len() * stresses.len()) as f64;
    let threshold = InertialThreshold::default();
    let (seconds, ()) = timed(|| {
        for &velocity in &velocities {
            for &stress in &stresses {
                let [stress, velocity] = [stress, velocity].map(|value| Rational::from_f64(value).unwrap());
                black_box(classify(&slider.at(stress, velocity), &threshold));
            }
        }
    });
    println!("values: classification (1e-14) {:.2} us a point", seconds / points * 1e6);
}

fn main() {
    grid_case("a < b", &paper("0.004", "0.006"));
    grid_case("a > b", &paper("0.006", "0.004"));
    points_case();
    value_case(&paper("0.004", "0.006"));
}
