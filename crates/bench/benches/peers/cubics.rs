//! Certified roots of eq 8 at many digits, at random points and close to double and triple roots.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use rug::{Float, Integer, Rational};
use slipmode_core::number::parse_decimal;
use slipmode_core::roots::{CertifiedRoot, CertifiedRoots, certified_roots};

use super::hard;
use super::random::Random;
use super::row::Row;
use slipmode_bench::cpu_clock::best_of;

/// Digits, and how many cubics are solved at them.
const SIZES: [(u32, usize); 4] = [(50, 100), (100, 100), (1_000, 40), (10_000, 4)];

/// Digits of the references beyond those asked for.
const MORE_DIGITS: u32 = 20;

const REPETITIONS: usize = 5;

/// The same cubic with integer coefficients.
fn integers(cubic: &[Rational; 4]) -> [Integer; 4] {
    let scale = cubic.iter().fold(Integer::from(1), |scale, c| scale.lcm(c.denom()));
    cubic.each_ref().map(|c| Rational::from(c * &scale).into_numer_denom().0)
}

/// Random points with four significant digits, as a person would write them.
fn random_cubics(count: usize) -> Vec<[Integer; 4]> {
    let mut random = Random::new(11);
    let written = |value: &f64| parse_decimal(&format!("{value:.3e}")).unwrap();
    let mut cubic = || integers(&random.parameters().map(written).groups().characteristic_cubic());
    (0..count).map(|_| cubic()).collect()
}

/// Points at 1e-6 … 1e-16 from a double or triple root, none of them exactly on it.
fn hard_cubics(count: usize) -> Vec<[Integer; 4]> {
    let (doubles, triples) = (hard::points("disc", 2 * count), hard::points("cusp", 2 * count));
    let mixed = doubles.iter().zip(&triples).flat_map(|(double, triple)| [double, triple]);
    mixed
        .map(|point| point.map(|value| Rational::from_f64(*value).unwrap()).groups().characteristic_cubic())
        .filter(|cubic| certified_roots(cubic, 5).discriminant_sign != 0)
        .map(|cubic| integers(&cubic))
        .take(count)
        .collect()
}

/// Writes `roots-random.txt` and `roots-hard.txt`, and for each number of digits a file of references.
pub fn prepare(folder: &Path) {
    let most = SIZES.iter().map(|size| size.1).max().unwrap_or(0);
    for (family, cubics) in [("random", random_cubics(most)), ("hard", hard_cubics(most))] {
        let path = folder.join(format!("roots-{family}.txt"));
        if path.exists() {
            continue;
        }
        for (digits, count) in SIZES {
            let mut text = String::new();
            for cubic in &cubics[..count] {
                for root in certified_roots(&rationals(cubic), digits + MORE_DIGITS).roots {
                    let printed =
                        |part: &Float| part.to_string_radix(10, Some((digits + MORE_DIGITS) as usize));
                    writeln!(text, "{} {}", printed(&root.re), printed(&root.im)).unwrap();
                }
            }
            fs::write(folder.join(format!("roots-{family}-{digits}.txt")), text).unwrap();
        }
        let lines: String = cubics.iter().map(|[c0, c1, c2, c3]| format!("{c0} {c1} {c2} {c3}\n")).collect();
        fs::write(path, lines).unwrap();
    }
}

fn rationals(cubic: &[Integer; 4]) -> [Rational; 4] {
    cubic.each_ref().map(|c| Rational::from(c.clone()))
}

/// The worst radius over its root's modulus: a proved bound, where other players have a measured difference.
fn worst_radius(found: &[CertifiedRoots]) -> String {
    let ratio = |root: &CertifiedRoot| root.radius.clone() / root.re.clone().hypot(&root.im);
    let exponents = found.iter().flat_map(|roots| &roots.roots).map(ratio).filter(|ratio| !ratio.is_zero());
    let worst = exponents.fold(Float::with_val(53, 0), |worst, ratio| worst.max(&Float::with_val(53, ratio)));
    worst.to_string_radix(10, Some(3))
}

/// `50-random` and so on.
pub fn play(which: &str, folder: &Path) {
    let (digits, family) = which.split_once('-').unwrap();
    let digits: u32 = digits.parse().unwrap();
    let count = SIZES.iter().find(|size| size.0 == digits).unwrap().1;
    let text = fs::read_to_string(folder.join(format!("roots-{family}.txt"))).unwrap();
    let parse = |line: &str| -> [Rational; 4] {
        let numbers: Vec<Rational> = line.split(' ').map(|cell| cell.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    let cubics: Vec<[Rational; 4]> = text.lines().take(count).map(parse).collect();
    let rounds = if digits <= 100 { 20 } else { 1 };
    let (seconds, found) = best_of(REPETITIONS, || {
        (1..rounds).for_each(|_| cubics.iter().for_each(|c| drop(certified_roots(c, digits))));
        cubics.iter().map(|cubic| certified_roots(cubic, digits)).collect::<Vec<_>>()
    });
    Row {
        work: format!("roots-{which}"),
        method: "slipmode-certified",
        options: "certified_roots;cubics~ready",
        items: rounds * count,
        seconds,
        error: Some(worst_radius(&found)),
        ..Row::default()
    }
    .print();
}
