//! Points of the boundary at 20, 50 and 200 digits, enclosed: at given normal stress, and anywhere on the rational curve.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use rug::Integer;
use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::{Ball, Rational, parse_decimal};
use slipmode_core::stability::boundary::{BoundaryCurve, Section};

use super::row::{Row, scientific};
use slipmode_bench::cpu_clock::best_of;

const DIGITS: [u32; 3] = [20, 50, 200];

/// Digits of the references beyond those requested.
const MORE_DIGITS: u32 = 12;

const REPETITIONS: usize = 5;

/// Leading digits and exponents of σ: above the upper arc's corner and below the lower one's, where one V0 belongs to each σ.
const LEADING: [&str; 4] = ["1.3", "2.9", "4.7", "7.1"];
const EXPONENTS: [i32; 6] = [0, 1, 2, 6, 7, 8];

fn paper() -> Slider<Rational> {
    let number = |text: &str| parse_decimal(text).unwrap();
    Slider::from([number("0.004"), number("0.006"), number("1e-5"), number("1e7"), number("1000")])
}

fn stresses() -> impl Iterator<Item = String> {
    EXPONENTS.into_iter().flat_map(|exponent| LEADING.map(|leading| format!("{leading}e{exponent}")))
}

/// The discriminant of eq 8 as an integer polynomial in η at these κ and β, from the constant term.
fn discriminant_in_inertia(stiffness_group: &Rational, effect_ratio: &Rational) -> [Integer; 4] {
    let kappa = || stiffness_group.clone();
    let c = || -> Rational { kappa() + 1 - effect_ratio };
    let coefficients: [Rational; 4] = [
        c().square() - kappa() * 4,
        c().square() * 2 + kappa() * c() * 18 - c().square() * c() * 4 - kappa() * 12,
        c().square() + kappa() * c() * 18 - kappa() * 12 - kappa().square() * 27,
        kappa() * -4,
    ];
    let scale = coefficients.iter().fold(Integer::from(1), |scale, one| scale.lcm(one.denom()));
    coefficients.map(|one| (one * &scale).into_numer_denom().0)
}

/// Writes for each number of digits a file with σ, the discriminant in η, V0²/η, and the V0 that belongs to σ.
pub fn prepare(folder: &Path) {
    for digits in DIGITS {
        let curve = BoundaryCurve::new(&paper(), digits + MORE_DIGITS);
        let mut text = String::new();
        for stress in stresses() {
            let exact = parse_decimal(&stress).unwrap();
            // At V0 = 1 m/s η is M / (a σ D_c), which is η/V0² anywhere.
            let groups = paper().at(exact.clone(), Rational::from(1)).groups();
            let [c0, c1, c2, c3] = discriminant_in_inertia(&groups.stiffness_group, &groups.effect_ratio);
            let scale = groups.inertial_parameter.recip();
            for crossing in curve.crossings(&Section::AtNormalStress(exact)) {
                let centre = crossing.position.loading_velocity_m_per_s.centre().clone();
                let velocity = centre.to_string_radix(10, Some((digits + MORE_DIGITS - 2) as usize));
                writeln!(text, "{stress} {c0} {c1} {c2} {c3} {scale} {velocity}").unwrap();
            }
        }
        fs::write(folder.join(format!("boundary-{digits}.txt")), text).unwrap();
    }
}

/// Both ways to the boundary.
pub fn play(digits: &str, folder: &Path) {
    let text = fs::read_to_string(folder.join(format!("boundary-{digits}.txt"))).unwrap();
    let curve = BoundaryCurve::new(&paper(), digits.parse().unwrap());
    let sections: Vec<Section> = text
        .lines()
        .map(|line| line.split(' ').next().unwrap())
        .map(|stress| Section::AtNormalStress(parse_decimal(stress).unwrap()))
        .collect();
    let rounds = 20;
    let (seconds, widest) = best_of(REPETITIONS, || {
        let mut widest = 0.0f64;
        for section in (0..rounds).flat_map(|_| &sections) {
            for crossing in curve.crossings(section) {
                widest = widest.max(relative_radius(&crossing.position.loading_velocity_m_per_s));
            }
        }
        widest
    });
    let row = Row { work: format!("boundary-{digits}"), ..Row::default() };
    let items = rounds * sections.len();
    let options = "BoundaryCurve::crossings;curve~ready";
    Row {
        method: "slipmode-section",
        options,
        items,
        seconds,
        error: Some(scientific(widest)),
        ..row.clone()
    }
    .print();
    let places = curve.sample_parameters(100, 1e-6);
    let (seconds, widest) = best_of(REPETITIONS, || {
        let mut widest = 0.0f64;
        for (place, arc) in places.iter().flat_map(|place| curve.arcs().iter().map(move |arc| (place, *arc)))
        {
            let OperatingPoint { normal_stress_pa, loading_velocity_m_per_s } = curve.position(arc, place);
            let radius = [normal_stress_pa, loading_velocity_m_per_s].map(|value| relative_radius(&value));
            widest = radius.into_iter().fold(widest, f64::max);
        }
        widest
    });
    let items = places.len() * curve.arcs().len();
    let options = "BoundaryCurve::position;anywhere~on~the~curve";
    Row { method: "slipmode-curve", options, items, seconds, error: Some(scientific(widest)), ..row }.print();
}

fn relative_radius(ball: &Ball) -> f64 {
    libm::exp2(ball.relative_radius_log2())
}
