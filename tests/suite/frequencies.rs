//! The frequencies that `classify` prints, compared with a computation of 1 500 bits that shares nothing with the program: each
//! printed number must be the 64-bit number nearest to the exact one.

use rug::float::Constant;
use rug::ops::Pow;
use rug::{Float, Rational};

use crate::hard_cases::decimal;
use crate::harness::{HEADER, Workplace};

const BITS: u32 = 1_500;

fn float(value: impl std::borrow::Borrow<Rational>) -> Float {
    Float::with_val(BITS, value.borrow())
}

/// The seven inputs as decimals: a, b, D_c, K, M, σ, V0.
type Inputs = [String; 7];

/// ω/2π and ω/ω_n from the cubic η p³ + (1 + η) p² + (κ + 1 − β) p + κ: a bisection for its negative real root, the other two
/// roots from their sum and product. Zero where the discriminant is not negative.
fn frequencies(inputs: &Inputs) -> [Float; 2] {
    let [a, b, d, k, m, s, v] = inputs.each_ref().map(|text| decimal(text));
    let strength = a.clone() * &s;
    let eta = m.clone() * &v * &v / (strength.clone() * &d);
    let kappa = k.clone() * &d / &strength;
    let linear = kappa.clone() + 1u32 - b / &a;
    let quadratic = eta.clone() + 1u32;
    let [c0, c1, c2, c3] = [&kappa, &linear, &quadratic, &eta];
    let product = |factors: &[&Rational]| factors.iter().fold(Rational::from(1), |all, one| all * *one);
    let discriminant = product(&[c3, c2, c1, c0]) * 18u32 - product(&[c2, c2, c2, c0]) * 4u32
        + product(&[c2, c2, c1, c1])
        - product(&[c3, c1, c1, c1]) * 4u32
        - product(&[c3, c3, c0, c0]) * 27u32;
    if discriminant >= 0 {
        return [Float::new(BITS), Float::new(BITS)];
    }
    let [c0, c1, c2, c3] = [c0, c1, c2, c3].map(float);
    let at = |x: &Float| ((c3.clone() * x + &c2) * x + &c1) * x + &c0;
    // The product of the pair is positive and that of all roots negative, so the real root is negative.
    let (mut low, mut high) = (Float::with_val(BITS, -1), Float::with_val(BITS, -1));
    while at(&low) > 0 {
        low *= 2u32;
    }
    while at(&high) < 0 {
        high /= 2u32;
    }
    for _ in 0..700 {
        let middle = Float::with_val(BITS, &low + &high) / 2u32;
        if at(&middle) < 0 { low = middle } else { high = middle }
    }
    let half_sum = -(Float::with_val(BITS, &c2 / &c3) + &low) / 2u32;
    let product = -(c0 / &c3) / &low;
    let omega = (product - half_sum.square()).sqrt() * float(v / d);
    let tau = Float::with_val(BITS, Constant::Pi) * 2u32;
    [omega.clone() / tau, omega / float(k / m).sqrt()]
}

/// The 64-bit number nearest to a value. A midpoint, which is known to 1 000 bits only, becomes one again with 400: no other row
/// is so near to one.
fn nearest(value: &Float) -> f64 {
    Float::with_val(400, value).to_f64()
}

/// Numbers without a pattern.
struct Random(u64);

impl Random {
    fn next(&mut self, below: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % below
    }

    /// A decimal of up to 20 digits between 10^low and 10^high.
    fn decimal(&mut self, [low, high]: [i64; 2]) -> String {
        let digits: String = (0..1 + self.next(19)).map(|_| char::from(b'0' + self.next(10) as u8)).collect();
        format!("{}.{digits}e{}", 1 + self.next(9), low + self.next((high - low) as u64) as i64)
    }
}

/// The midpoint between the 64-bit number nearest to a value and the next one.
fn midpoint(value: &Float) -> Rational {
    let below = value.to_f64();
    let above = f64::from_bits(below.to_bits() + 1);
    (Rational::from_f64(below).unwrap() + Rational::from_f64(above).unwrap()) / 2u32
}

/// A decimal of 140 digits.
fn rounded(value: &Rational) -> String {
    Float::with_val(600, value).to_string_radix(10, Some(140))
}

/// A slider with unit a, D_c and σ, so that η, κ and β are free; its frequencies rise in proportion to V0.
fn with_groups(eta: &Rational, kappa: &Rational, beta: &Rational, v: &Rational) -> Inputs {
    let mass = eta / Rational::from(v * v);
    let [beta, kappa, mass, v] = [beta, kappa, &mass, v].map(rounded);
    let one = || String::from("1");
    [one(), beta, one(), kappa, mass, one(), v]
}

/// Sliders like those of a laboratory or a fault, and others of any size.
fn ordinary(random: &mut Random) -> Inputs {
    const LIKELY: [[i64; 2]; 7] = [[-3, -1], [-3, -1], [-7, -3], [5, 11], [0, 5], [3, 8], [-9, 0]];
    const ANY: [[i64; 2]; 7] = [[-9, 3], [-9, 3], [-20, 5], [-5, 20], [-5, 15], [-5, 15], [-20, 5]];
    let ranges = if random.next(3) == 0 { ANY } else { LIKELY };
    ranges.map(|range| random.decimal(range))
}

/// ω/2π is a midpoint of two 64-bit numbers, but for a part of 10^-depth.
fn beside_a_midpoint_of_hertz(random: &mut Random, depth: u64) -> Inputs {
    let [eta, kappa, beta] = [[-3, 3], [-2, 3], [-1, 2]].map(|range| decimal(&random.decimal(range)));
    let one = Rational::from(1);
    let [hertz, _] = frequencies(&with_groups(&eta, &kappa, &beta, &one));
    if hertz.is_zero() {
        return with_groups(&eta, &kappa, &beta, &one);
    }
    let exact = float(midpoint(&hertz)) / hertz;
    let shift = decimal(&format!("{}1e-{depth}", if random.next(2) == 0 { "-" } else { "" })) + one;
    // Rounded to more bits than the depth has.
    let v = Float::with_val(8 * depth as u32 / 2 + 60, exact * float(shift));
    with_groups(&eta, &kappa, &beta, &v.to_rational().unwrap())
}

/// On K = K_c, (ω/ω_n)² = η/(1 + η). With M = r², σ = 1 − r² and unit a, D_c and V0, ω/ω_n = r, which is a midpoint of two 64-bit
/// numbers. K then moves by a part of 10^-depth, or not at all.
fn beside_a_midpoint_of_the_ratio(random: &mut Random, depth: Option<u64>) -> Inputs {
    let half = 1_u64 << 53;
    let ratio = Rational::from((half + 2 * random.next(1 << 31) + 1, 2 * half));
    let squared = Rational::from(&ratio * &ratio);
    let stress = Rational::from(1) - &squared;
    // A fraction over 2^108 is one over 10^108.
    let digits = |value: Rational| {
        let power = value.denom().significant_bits() - 1;
        format!("{}e-{power}", value.numer().clone() * rug::Integer::from(5).pow(power))
    };
    let excess = random.decimal([-2, 1]);
    let beta = decimal(&excess) + 1u32;
    let sign = ["", "-"][random.next(2) as usize];
    let shift = depth.map_or_else(|| "0".into(), |depth| format!("{sign}1e-{depth}"));
    let stiffness = decimal(&excess) * (decimal(&shift) + 1u32);
    let one = || String::from("1");
    [one(), rounded(&beta), one(), rounded(&stiffness), digits(squared), digits(stress), one()]
}

/// Beside the triple root at η = 1/8, κ = 27/8, β = 1.
fn beside_the_cusp(random: &mut Random, depth: u64) -> Inputs {
    let shift = |value: &str, random: &mut Random| {
        decimal(value)
            * (decimal(&format!("{}e-{depth}", random.next(2_000) as i64 - 1_000)) / 1_000u32 + 1u32)
    };
    let [eta, kappa, beta] = ["0.125", "3.375", "1"].map(|value| shift(value, random));
    with_groups(&eta, &kappa, &beta, &decimal("1"))
}

fn all_rows() -> Vec<Inputs> {
    let mut random = Random(29);
    let mut rows: Vec<Inputs> = (0..1_200).map(|_| ordinary(&mut random)).collect();
    for depth in 15..65 {
        rows.extend((0..6).map(|_| beside_a_midpoint_of_hertz(&mut random, depth)));
        rows.extend((0..4).map(|_| beside_a_midpoint_of_the_ratio(&mut random, Some(depth))));
        rows.extend((0..4).map(|_| beside_the_cusp(&mut random, depth / 2)));
    }
    rows.extend((0..100).map(|_| beside_a_midpoint_of_the_ratio(&mut random, None)));
    rows
}

#[test]
fn every_frequency_is_the_nearest_64_bit_number() {
    let place = Workplace::new();
    let rows = all_rows();
    let lines: Vec<String> = rows.iter().map(|row| row.join(",")).collect();
    place.write("in.csv", format!("{HEADER}\n{}\n", lines.join("\n")));
    let printed = place.run(["classify", "--points", "in.csv"]).expect_warnings();
    let names: Vec<&str> = printed.lines().next().unwrap().split(',').collect();
    let [hertz, ratio] = ["frequency_hz", "frequency_over_natural"]
        .map(|wanted| names.iter().position(|name| *name == wanted));
    let mut oscillating = 0;
    for (row, line) in rows.iter().zip(printed.lines().skip(1)) {
        let cells: Vec<&str> = line.split(',').collect();
        let wanted = frequencies(row);
        oscillating += usize::from(!wanted[0].is_zero());
        for (column, wanted) in [hertz, ratio].into_iter().zip(&wanted) {
            let found: f64 = cells[column.unwrap()].parse().unwrap();
            assert_eq!(found.to_bits(), nearest(wanted).to_bits(), "{row:?}: {found} {wanted}");
        }
    }
    assert_eq!(printed.lines().count(), rows.len() + 1);
    assert!(oscillating > rows.len() / 2, "{oscillating} of {}", rows.len());
}

#[test]
fn one_point_has_the_numbers_of_its_row() {
    let place = Workplace::new();
    let options = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"];
    for row in all_rows().iter().step_by(53) {
        let pairs = options.iter().zip(row).flat_map(|(option, value)| [*option, value.as_str()]);
        let arguments = std::iter::once("classify").chain(pairs).chain(["--json"]);
        let text = place.run(arguments).expect_warnings();
        for (name, wanted) in ["frequency_hz", "frequency_over_natural"].into_iter().zip(frequencies(row)) {
            let start = format!("\"{name}\": ");
            let found = text.lines().find_map(|line| line.trim().strip_prefix(&start)).unwrap();
            let found: f64 = found.trim_end_matches(',').parse().unwrap();
            assert_eq!(found.to_bits(), nearest(&wanted).to_bits(), "{name} of {row:?}");
        }
    }
}
