//! Warnings about a slider's values: units that are not SI, and groups for which no simulation was tested.

use rug::Float;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::{round_digits, round_float};
use slipmode_core::number::{Rational, nearest_f64};

use crate::cli::unit_warnings::slider_warnings;

/// Groups between which simulations were tested: the paper's values over its figures' V0 = 10^-6 to 10^-1 m/s and
/// σ = 10^2.5 to 10^7.5 Pa, with a and b of its section 3 and exchanged, and b/a up to 5 (tests/suite/simulate.rs).
const TESTED: [(&str, [f64; 2]); 3] = [
    ("eta = M V0^2/(sigma a D_c)", [5e-10, 8e5]),
    ("kappa = K D_c/(a sigma)", [5e-4, 80.0]),
    ("beta = b/a", [0.66, 5.0]),
];

/// Units that are not SI, and groups for which no simulation was tested.
pub fn warnings(parameters: &Parameters<Rational>) -> Vec<String> {
    [slider_warnings(parameters.map(nearest_f64)), outside_tested(parameters).collect()].concat()
}

/// The groups of a slider that lie outside the ranges over which simulations were tested.
pub fn outside_tested(parameters: &Parameters<Rational>) -> impl Iterator<Item = String> {
    outside(parameters, [[1.0; 2]; 3], "tested range")
}

/// How far below and above the tested ranges the groups may lie.
pub type Factors = [[f64; 2]; 3];

/// The groups of a slider that lie outside the tested ranges, by more than a factor below and one above for each.
pub fn outside(of: &Parameters<Rational>, by: Factors, range: &str) -> impl Iterator<Item = String> {
    let groups = <[Rational; 3]>::from(of.groups());
    groups.into_iter().zip(TESTED).zip(by).filter_map(move |((value, (name, [from, to])), by)| {
        let ends = [from / by[0], to * by[1]];
        let is_inside = (ends[0]..=ends[1]).contains(&nearest_f64(&value));
        let shown = round_float(&Float::with_val(64, value), 3);
        let [from, to] = ends.map(|end| round_digits(end, 3));
        (!is_inside).then(|| format!("{name} is {shown}, outside the {range} {from} to {to}"))
    })
}
