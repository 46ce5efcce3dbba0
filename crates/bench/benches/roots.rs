//! Certified roots at 50, 1 000 and 10 000 digits, against Newton's iteration at full precision with deflation, not certified;
//! and at 50 to 100 000 digits in units of one multiplication, at random points and next to double and triple roots.
//!
//! Times depend on the machine and on its load: read the ratios. Alternatives are run in turn, medians are printed.

use std::hint::black_box;
use std::time::Instant;

use rug::{Assign, Float, Integer};
use slipmode_bench::cpu_clock::best_of;
use slipmode_core::number::{Rational, bits_for_digits, nearest_f64, parse_decimal};
use slipmode_core::roots::{Pair, bounded_roots, certified_roots};

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
    let start = bounded_roots(cubic.each_ref().map(nearest_f64)).real.value;
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

/// Cubics next to a double root and to a triple one: the boundary at b = a, r = −3 − i/8, with κ times 1 ± 1e-6 … 1e-16.
fn hard_cubics() -> Vec<[Rational; 4]> {
    let beside = |i: i32| {
        let r = Rational::from((-24 - i / 4, 8));
        let square = Rational::from(&r + 1u32).square();
        let eta = (Rational::from(1) - &square) / (Rational::from(&r * 2u32) * &square);
        let kappa = (Rational::from(&r * 2u32) + 1u32 - &square) * &r / (square * 2u32);
        let distance =
            parse_decimal(&format!("{}1e-{}", if i % 2 == 0 { "" } else { "-" }, 6 + i % 11)).unwrap();
        let kappa = kappa * (distance + 1u32);
        [kappa.clone(), kappa, eta.clone() + 1u32, eta]
    };
    (0..60).map(beside).collect()
}

/// Microseconds of CPU time for one multiplication of two integers of this many digits.
fn microseconds_per_product(digits: u32) -> f64 {
    let factor = |power: u32| Integer::from(Integer::u_pow_u(power, 4 * digits)) >> (3 * digits);
    let bits = bits_for_digits(digits);
    let [one, other] = [3, 7].map(|base| factor(base).keep_bits(bits));
    let mut product = Integer::new();
    let rounds = 2_000_000 / digits + 20;
    let multiply = || (0..rounds).for_each(|_| product.assign(black_box(&one) * black_box(&other)));
    best_of(REPETITIONS, multiply).0 * 1e6 / f64::from(rounds)
}

/// The cost of certified roots in units of one multiplication, random and hard in turn, by CPU time.
fn costs_in_products(random: &[[Rational; 4]], hard: &[[Rational; 4]]) {
    for digits in [50, 100, 1_000, 10_000, 100_000] {
        let some = if digits < 100_000 { random.len() } else { 6 };
        let rounds = (10_000 / digits as usize).max(1);
        let mut times = [f64::INFINITY; 3];
        for _ in 0..REPETITIONS {
            let solve = |cubics: &[[Rational; 4]]| {
                let all = || {
                    (0..rounds)
                        .flat_map(|_| &cubics[..some])
                        .for_each(|cubic| drop(certified_roots(cubic, digits)));
                };
                best_of(1, all).0 * 1e6 / (rounds * some) as f64
            };
            let round = [microseconds_per_product(digits), solve(random), solve(hard)];
            times.iter_mut().zip(round).for_each(|(best, time)| *best = best.min(time));
        }
        let [product, random, hard] = times;
        println!(
            "{digits} digits: one multiplication {product:.4} us; certified roots {:.1} of them, next to multiple roots {:.1} ({:.2} x)",
            random / product,
            hard / product,
            hard / random
        );
    }
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
    costs_in_products(&cubics, &hard_cubics());
    let rounded: Vec<[f64; 4]> = cubics.iter().map(|cubic| cubic.each_ref().map(nearest_f64)).collect();
    let start = Instant::now();
    let mut open = 0;
    for _ in 0..20_000 {
        for &cubic in &rounded {
            open += usize::from(black_box(bounded_roots(cubic)).pair == Pair::NotSeparated);
        }
    }
    let each = start.elapsed().as_secs_f64() * 1e9 / (20_000.0 * rounded.len() as f64);
    println!(
        "64-bit with forward error bounds: {each:.0} ns a cubic; left open: {} of {}",
        open / 20_000,
        rounded.len()
    );
}
