//! Certified roots at 50, 1 000 and 10 000 digits, against Newton's iteration at full precision with deflation, not certified.
//!
//! Times depend on the machine and on its load: read the ratios. Alternatives are run in turn, medians are printed.

use std::hint::black_box;
use std::time::Instant;

use rug::Float;
use slipmode::number::{Rational, bits_for_digits, parse_decimal};
use slipmode::roots::{Pair, binary64, certified_roots};

const REPETITIONS: usize = 5;

/// The cubics of a few dozen points of the (η, κ, β) space, all decades of each.
fn cubics() -> Vec<[Rational; 4]> {
    (0..60)
        .map(|i| {
            let group =
                |digit: i32, power: i32| parse_decimal(&format!("{digit}.{}e{power}", 37 + i)).unwrap();
            let eta = group(1 + i % 7, i % 13 - 8);
            let kappa = group(1 + i % 5, i % 11 - 5);
            let beta = group(1 + i % 3, i % 4 - 2);
            [kappa.clone(), kappa + 1u32 - beta, eta.clone() + 1u32, eta]
        })
        .collect()
}

/// The alternative: every step at full precision, from a 64-bit start; then deflation and the quadratic formula.
fn newton_at_full_precision(cubic: &[Rational; 4], digits: u32) -> [Float; 3] {
    let precision = bits_for_digits(digits) + 64;
    let [c0, c1, c2, c3] = cubic.each_ref().map(|c| Float::with_val(precision, c));
    let start = binary64::roots(cubic.each_ref().map(Rational::to_f64)).real.value;
    let mut root = Float::with_val(precision, start);
    let mut steps = 0;
    loop {
        let first = Float::with_val(precision, &c3 * &root) + &c2;
        let second = Float::with_val(precision, &first * &root) + &c1;
        let value = Float::with_val(precision, &second * &root) + &c0;
        let slope = (Float::with_val(precision, &c3 * &root) + &first) * &root + &second;
        let step = value / slope;
        let done = step.is_zero()
            || i64::from(step.get_exp().unwrap_or(0))
                < i64::from(root.get_exp().unwrap_or(0)) - i64::from(precision) + 8;
        root -= step;
        steps += 1;
        if done || steps > 64 {
            break;
        }
    }
    let linear = Float::with_val(precision, &c3 * &root) + &c2;
    let constant = -c0 / &root;
    let discriminant = linear.clone().square() - constant * &c3 * 4u32;
    let twice = c3 * 2u32;
    [root, -linear / &twice, discriminant.abs().sqrt() / twice]
}

fn microseconds_per_cubic(
    cubics: &[[Rational; 4]],
    rounds: usize,
    mut solve: impl FnMut(&[Rational; 4]),
) -> f64 {
    let start = Instant::now();
    for _ in 0..rounds {
        cubics.iter().for_each(&mut solve);
    }
    start.elapsed().as_secs_f64() * 1e6 / (rounds * cubics.len()) as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    let cubics = cubics();
    for (digits, rounds) in [(50, 200), (100, 100), (1_000, 20), (10_000, 1)] {
        let (mut certified, mut plain) = (Vec::new(), Vec::new());
        for _ in 0..REPETITIONS {
            certified.push(microseconds_per_cubic(&cubics, rounds, |cubic| {
                black_box(certified_roots(cubic, digits));
            }));
            plain.push(microseconds_per_cubic(&cubics, rounds, |cubic| {
                black_box(newton_at_full_precision(cubic, digits));
            }));
        }
        let (certified, plain) = (median(certified), median(plain));
        println!(
            "{digits} digits: certified {certified:.1} us a cubic, full-precision Newton (not certified) {plain:.1} us: {:.2} x",
            plain / certified
        );
    }
    let rounded: Vec<[f64; 4]> = cubics.iter().map(|cubic| cubic.each_ref().map(Rational::to_f64)).collect();
    let start = Instant::now();
    let mut open = 0;
    for _ in 0..20_000 {
        for &cubic in &rounded {
            open += usize::from(black_box(binary64::roots(cubic)).pair == Pair::NotSeparated);
        }
    }
    let each = start.elapsed().as_secs_f64() * 1e9 / (20_000.0 * rounded.len() as f64);
    println!(
        "64-bit with forward error bounds: {each:.0} ns a cubic; left open: {} of {}",
        open / 20_000,
        rounded.len()
    );
}
