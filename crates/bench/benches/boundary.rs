//! Boundary points at 50 digits: the rational curve against the discriminant and against bisection; then crossings by digits.
//!
//! Times depend on the machine and on its load: read the ratios. Alternatives are run in turn, medians are printed.

use std::hint::black_box;
use std::time::Instant;

use slipmode_bench::cpu_clock::best_of;
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational, parse_decimal};
use slipmode_core::stability::Arc;
use slipmode_core::stability::boundary::hard_sections::{DIGITS as DIGITS_COMPARED, HardSections};
use slipmode_core::stability::boundary::{BoundaryCurve, Section, by_bisection, by_discriminant};

const REPETITIONS: usize = 7;
const DIGITS: u32 = 50;

fn number(text: &str) -> Rational {
    parse_decimal(text).unwrap()
}

/// The paper's slider.
fn slider() -> Slider<Rational> {
    Slider::from([number("0.004"), number("0.006"), number("1e-5"), number("1e7"), number("1000")])
}

/// Sections at given σ that cross the boundary once: the upper arc above eq 15, the lower one below eq 16.
fn stresses() -> Vec<Rational> {
    ["6e5", "9.1e5", "1.7e6", "7.3e6", "6.1e7", "5e3", "2.9e3", "1.1e3", "340", "21"].map(number).to_vec()
}

/// Median over the repetitions of the microseconds per item, for each of the alternatives run in turn.
fn medians<const N: usize>(items: usize, rounds: usize, mut run: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut times = [const { Vec::new() }; N];
    for _ in 0..REPETITIONS {
        for (alternative, collected) in run.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (0..rounds).for_each(|_| alternative());
            collected.push(start.elapsed().as_secs_f64() * 1e6 / (rounds * items) as f64);
        }
    }
    times.map(|mut collected| {
        collected.sort_by(f64::total_cmp);
        collected[collected.len() / 2]
    })
}

fn points_of_the_curve(slider: &Slider<Rational>) {
    let curve = BoundaryCurve::new(slider, DIGITS);
    let places: Vec<Ball> = curve.sample_parameters(100, 1e-6);
    let both = |evaluate: &dyn Fn(Arc, &Ball)| {
        places.iter().for_each(|place| [Arc::Upper, Arc::Lower].iter().for_each(|&arc| evaluate(arc, place)));
    };
    let [position, row] = medians(
        2 * places.len(),
        5,
        [&mut || both(&|arc, place| drop(black_box(curve.position(arc, place)))), &mut || {
            both(&|arc, place| drop(black_box(curve.point(arc, place, None))))
        }],
    );
    println!(
        "boundary, {DIGITS} digits, curve: sigma and V0          {position:9.2} us  {:10.0} points/s",
        1e6 / position
    );
    println!(
        "boundary, {DIGITS} digits, curve: full row with errors  {row:9.2} us  {:10.0} points/s",
        1e6 / row
    );
}

fn points_at_given_normal_stress(slider: &Slider<Rational>) {
    let curve = BoundaryCurve::new(slider, DIGITS);
    let sections: Vec<Section> = stresses().into_iter().map(Section::AtNormalStress).collect();
    let ends = (number("1e-8"), number("1e3"));
    let [velocity, row, discriminant, bisection] = medians(
        sections.len(),
        5,
        [
            &mut || sections.iter().for_each(|section| drop(black_box(curve.crossings(section)))),
            &mut || sections.iter().for_each(|section| drop(black_box(curve.on_section(section)))),
            &mut || sections.iter().for_each(|s| drop(black_box(by_discriminant(slider, s, DIGITS)))),
            &mut || {
                sections.iter().for_each(|section| {
                    drop(black_box(by_bisection(slider, section, (&ends.0, &ends.1), DIGITS)));
                });
            },
        ],
    );
    println!("boundary at given sigma, curve                  {velocity:9.2} us");
    println!("boundary at given sigma, curve, full row        {row:9.2} us  {:7.1} x", row / velocity);
    println!(
        "boundary at given sigma, discriminant           {discriminant:9.2} us  {:7.1} x",
        discriminant / velocity
    );
    println!(
        "boundary at given sigma, bisection              {bisection:9.2} us  {:7.1} x",
        bisection / velocity
    );
}

/// CPU time of a crossing at given σ and at given V0, and of building the curve, over the sections that are hard.
fn crossings_by_digits() {
    let all = HardSections::all();
    for digits in DIGITS_COMPARED {
        let curves: Vec<BoundaryCurve> =
            all.iter().map(|one| BoundaryCurve::new(&one.slider, digits)).collect();
        let (building, _) = best_of(REPETITIONS, || {
            all.iter()
                .map(|one| black_box(BoundaryCurve::new(&one.slider, digits)).arcs().len())
                .sum::<usize>()
        });
        let crossings = |of: fn(&HardSections) -> &Vec<Section>| {
            let (seconds, found) = best_of(REPETITIONS, || {
                let pairs = all.iter().zip(&curves);
                let sections =
                    pairs.flat_map(|(one, curve)| of(one).iter().map(move |section| (curve, section)));
                sections.map(|(curve, section)| curve.crossings(section).len()).sum::<usize>()
            });
            seconds * 1e6 / found as f64
        };
        println!(
            "boundary, {digits:3} digits: crossing at given sigma {:6.2} us, at given V0 {:6.2} us, curve built in {:6.2} us (CPU)",
            crossings(|one| &one.at_normal_stress),
            crossings(|one| &one.at_velocity),
            building * 1e6 / all.len() as f64
        );
    }
}

fn main() {
    let slider = slider();
    points_of_the_curve(&slider);
    points_at_given_normal_stress(&slider);
    crossings_by_digits();
}
