//! Points of the boundary at 50 digits, enclosed: at given normal stress, and anywhere on the rational curve.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::{Ball, Rational, parse_decimal};
use slipmode_core::stability::boundary::{BoundaryCurve, Section};

use super::row::{Row, scientific};
use slipmode_bench::cpu_clock::best_of;

const DIGITS: u32 = 50;
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

/// Writes `boundary.txt`: σ and the V0 that belongs to it, to 60 digits.
pub fn prepare(folder: &Path) {
    let curve = BoundaryCurve::new(&paper(), DIGITS + 12);
    let mut text = String::new();
    for stress in stresses() {
        for (crossing, _) in curve.crossings(&Section::AtNormalStress(parse_decimal(&stress).unwrap())) {
            let velocity = crossing.position.loading_velocity_m_per_s.centre().to_string_radix(10, Some(60));
            writeln!(text, "{stress} {velocity}").unwrap();
        }
    }
    fs::write(folder.join("boundary.txt"), text).unwrap();
}

/// Both ways to the boundary.
pub fn play(folder: &Path) {
    let text = fs::read_to_string(folder.join("boundary.txt")).unwrap();
    let curve = BoundaryCurve::new(&paper(), DIGITS);
    let sections: Vec<Section> = text
        .lines()
        .map(|line| line.split(' ').next().unwrap())
        .map(|stress| Section::AtNormalStress(parse_decimal(stress).unwrap()))
        .collect();
    let rounds = 20;
    let (seconds, widest) = best_of(REPETITIONS, || {
        let mut widest = 0.0f64;
        for section in (0..rounds).flat_map(|_| &sections) {
            for (crossing, _) in curve.crossings(section) {
                widest = widest.max(relative_radius(&crossing.position.loading_velocity_m_per_s));
            }
        }
        widest
    });
    let row = Row { work: "boundary-section".into(), ..Row::default() };
    let items = rounds * sections.len();
    Row { method: "slipmode-section", items, seconds, error: Some(scientific(widest)), ..row.clone() }
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
    Row { method: "slipmode-curve", items, seconds, error: Some(scientific(widest)), ..row }.print();
}

fn relative_radius(ball: &Ball) -> f64 {
    libm::exp2(ball.relative_radius_log2())
}
