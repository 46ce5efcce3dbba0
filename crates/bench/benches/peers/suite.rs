//! The suite of hard cases: what each way to the roots of eq 8 takes on all of its points, textbook methods among them.
//!
//! The textbook methods get the rounded cubic, ready made; ours get the exact groups. Open points of a precision level count as answered:
//! the next precision level takes them.

use std::hint::black_box;
use std::path::Path;

use slipmode_bench::methods::{HardCase, compare_hard_cases, read_hard_cases};
use slipmode_bench::methods::{Method, score_families};
use slipmode_bench::textbook::{Three, aberth, cardano, companion, newton, viete};
use slipmode_core::number::{Dd, Rational, nearest_f64};
use slipmode_core::roots::{bounded_roots, certified_roots};
use slipmode_core::stability::{InertialThreshold, classify};

use super::row::{Row, scientific};
use slipmode_bench::cpu_clock::best_of;

const CASES: &str = include_str!("../../../../reports/im-avouac/timings/classification-hard.txt");
const REPETITIONS: usize = 3;
/// How often the suite is gone through in one repetition.
const ROUNDS: usize = 20;
/// Digits of the certified roots.
const DIGITS: u32 = 35;

type Solve<'c> = Box<dyn Fn(&Inputs) + 'c>;

/// One point in every form that a method may want.
struct Inputs<'c> {
    case: &'c HardCase,
    exact: [Rational; 4],
    rounded: [f64; 4],
    doubled: [Dd; 4],
}

impl<'c> Inputs<'c> {
    fn of(case: &'c HardCase) -> Self {
        let exact = case.parameters.groups().characteristic_cubic();
        let rounded = case.parameters.map(nearest_f64).groups().characteristic_cubic();
        Self { case, rounded, doubled: exact.each_ref().map(Dd::from_rational), exact }
    }
}

fn textbook(solve: fn([f64; 4]) -> Three) -> Solve<'static> {
    Box::new(move |point| {
        black_box(solve(black_box(point.rounded)));
    })
}

fn methods() -> [(&'static str, Option<Method>, Solve<'static>); 9] {
    [
        ("textbook-cardano", Some(Method::Cardano), textbook(cardano)),
        ("textbook-viete", Some(Method::Viete), textbook(viete)),
        ("textbook-companion", Some(Method::Companion), textbook(companion)),
        ("textbook-newton", Some(Method::Newton), textbook(newton)),
        ("textbook-aberth", Some(Method::Aberth), textbook(aberth)),
        (
            "slipmode-64-bit",
            Some(Method::Ours64),
            Box::new(|point| {
                black_box(bounded_roots(black_box(point.rounded)));
            }),
        ),
        (
            "slipmode-double-double",
            Some(Method::DoubleDouble),
            Box::new(|point| {
                black_box(bounded_roots(black_box(point.doubled)));
            }),
        ),
        (
            "slipmode-certified-35",
            Some(Method::Certified),
            Box::new(|point| {
                black_box(certified_roots(black_box(&point.exact), DIGITS));
            }),
        ),
        (
            "slipmode-classify",
            None,
            Box::new(|point| {
                black_box(classify(&black_box(point.case).parameters, &InertialThreshold::default()));
            }),
        ),
    ]
}

/// Every method on the whole suite.
pub fn play(_folder: &Path) {
    let cases = read_hard_cases("classification-hard.txt", CASES).unwrap();
    let families = compare_hard_cases(&cases);
    let scored = score_families(&cases);
    let points: Vec<Inputs> = cases.iter().map(Inputs::of).collect();
    for (name, method, solve) in methods() {
        let (seconds, ()) = best_of(REPETITIONS, || {
            for point in (0..ROUNDS).flat_map(|_| &points) {
                solve(point);
            }
        });
        let scores = scored.iter().flat_map(|family| &family.methods);
        let (mut wrong, mut worst) = (0, 0.0_f64);
        for score in scores.filter(|score| Some(score.method) == method) {
            wrong += score.wrong + score.failed;
            worst = worst.max(score.worst_real_ulps).max(score.worst_imaginary_ulps);
        }
        if method.is_none() {
            wrong = families.iter().map(|family| family.wrong).sum();
            let errors = families.iter().map(|one| one.worst_real_error.max(one.worst_imaginary_error));
            worst = errors.fold(0.0, f64::max) / f64::EPSILON;
        }
        Row {
            work: "hard-cases".into(),
            method: name,
            options: "one~call~for~each~point",
            items: points.len(),
            seconds: seconds / ROUNDS as f64,
            error: Some(scientific(worst * f64::EPSILON)),
            wrong,
            ..Row::default()
        }
        .print();
    }
}
