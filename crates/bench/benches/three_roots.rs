//! Three roots in 64-bit numbers: points per second on one thread, precision levels, and errors compared with certified roots.
//!
//! The sets are random sliders, and points at relative distances of 1e-15 to 1e-6 from the boundary, from K = K_c and from the
//! triple root. Times are CPU times, the best of several rounds in which all sets take turns.

use num_complex::Complex;
use rayon::ThreadPoolBuilder;
use rug::Float;
use slipmode_bench::cpu_clock::best_of;
use slipmode_bench::split_mix::SplitMix64;
use slipmode_core::friction::Parameters;
use slipmode_core::number::Rational;
use slipmode_core::roots::{PrecisionLevel, certified_roots};
use slipmode_core::stability::ThreeRoots;
use slipmode_core::stability::batch::three_roots_of_points;

const POINTS: usize = 1 << 16;
/// Points of a set that are compared with certified roots.
const COMPARED: usize = 4_000;
const ROUNDS: usize = 7;
const SETS: [&str; 4] = ["random", "beside the boundary", "beside K = K_c", "beside the triple root"];

fn decades(random: &mut SplitMix64, low: f64, high: f64) -> f64 {
    libm::exp10(random.between(low, high))
}

/// 1 ± 1e-15 … 1e-6, uniform in the logarithm.
fn beside(random: &mut SplitMix64) -> f64 {
    let distance = decades(random, -15.0, -6.0);
    if random.unit() < 0.5 { 1.0 + distance } else { 1.0 - distance }
}

/// Unit a, D_c, V and σ make the groups the parameters: b = β, K = κ, M = η.
fn with_groups(eta: f64, kappa: f64, beta: f64) -> [f64; 7] {
    [1.0, beta, 1.0, kappa, eta, 1.0, 1.0]
}

fn point(set: usize, random: &mut SplitMix64) -> [f64; 7] {
    match set {
        0 => {
            let a = decades(random, -4.0, -1.5);
            let b = a * decades(random, -1.3, 1.3);
            let more = [[-7.0, -2.0], [4.0, 12.0], [-2.0, 7.0], [2.0, 9.0], [-9.0, 1.0]];
            let [d, k, m, s, v] = more.map(|[low, high]| decades(random, low, high));
            [a, b, d, k, m, s, v]
        }
        1 => {
            // η and κ of a double root r < −1 − √β.
            let beta = decades(random, -1.0, 1.0);
            let r = -1.0 - beta.sqrt() - decades(random, -1.0, 1.0);
            let square = (r + 1.0) * (r + 1.0);
            let eta = (beta - square) / (2.0 * r * square);
            let kappa = r * ((2.0 * r + 1.0) * beta - square) / (2.0 * square);
            with_groups(eta, kappa * beside(random), beta)
        }
        2 => {
            let (eta, beta) = (decades(random, -2.0, 2.0), 1.0 + decades(random, -2.0, 1.0));
            with_groups(eta, (beta - 1.0) * (1.0 + eta) * beside(random), beta)
        }
        _ => {
            // η(p − r)³.
            let r = -1.0 - decades(random, -1.0, 1.0);
            let eta = -1.0 / (3.0 * r + 1.0);
            let kappa = -eta * r * r * r;
            with_groups(eta, kappa, (kappa + 1.0 - 3.0 * eta * r * r) * beside(random))
        }
    }
}

/// The largest error of a root over its modulus, in units of 2^-53.
fn error(inputs: [f64; 7], found: &ThreeRoots) -> f64 {
    let exact = Parameters::from(inputs.map(|value| Rational::from_f64(value).unwrap()));
    let roots = certified_roots(&exact.characteristic_cubic_per_s(), 40).roots;
    let each = roots.iter().flat_map(|root| std::iter::repeat_n(root, root.multiplicity as usize));
    let of = |(one, root): (&Complex<f64>, &slipmode_core::roots::CertifiedRoot)| {
        let apart = |value: f64, part: &Float| Float::with_val(200, value) - part;
        // not f64: MPFR's.
        let distance = apart(one.re, &root.re).hypot(&apart(one.im, &root.im));
        // not f64: MPFR's.
        (distance / root.re.clone().hypot(&root.im)).to_f64() * libm::exp2(53.0)
    };
    found.roots.iter().zip(each).map(of).fold(0.0, f64::max)
}

fn main() {
    let sets: Vec<Vec<[f64; 7]>> = (0..SETS.len())
        .map(|set| {
            let mut random = SplitMix64(set as u64);
            (0..POINTS).map(|_| point(set, &mut random)).collect()
        })
        .collect();
    let columns: Vec<[Vec<f64>; 7]> = sets
        .iter()
        .map(|set| std::array::from_fn(|column| set.iter().map(|point| point[column]).collect()))
        .collect();
    let pool = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut best = [f64::INFINITY; SETS.len()];
    let mut found = vec![Vec::new(); SETS.len()];
    for _ in 0..ROUNDS {
        for (set, columns) in columns.iter().enumerate() {
            let inputs = Parameters::from(columns.each_ref().map(Vec::as_slice));
            let (seconds, roots) = best_of(1, || pool.install(|| three_roots_of_points(&inputs).unwrap()));
            best[set] = best[set].min(seconds);
            found[set] = roots;
        }
    }
    for (set, name) in SETS.iter().enumerate() {
        let exact = found[set].iter().filter(|roots| roots.precision_level == PrecisionLevel::Exact).count();
        let errors =
            sets[set].iter().zip(&found[set]).take(COMPARED).map(|(point, roots)| error(*point, roots));
        println!(
            "{name}: {:.2} million points/s, {:.2} % by certified enclosures, largest error {:.4} of 2^-53 of the modulus",
            POINTS as f64 / best[set] / 1e6,
            100.0 * exact as f64 / POINTS as f64,
            errors.fold(0.0, f64::max)
        );
    }
}
