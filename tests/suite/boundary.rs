//! The boundary, its cusp and its worst corners against vectors computed from eq 8 by an unrelated program.

use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::BoundaryCurve;
use slipmode_core::stability::boundary::{Section, by_discriminant};
use slipmode_core::stability::deviation::corner_errors;

use crate::hard_cases::{decimal, rows};

const VECTORS: &str = include_str!("../vectors/boundary.txt");
const DIGITS: u32 = 60;

fn slider(cells: &[&str]) -> Slider<Rational> {
    Slider::from([1, 2, 3, 4, 5].map(|column| decimal(cells[column])))
}

/// The vectors print 60 digits, so that their rounding is below 1e-59 of each number.
fn assert_matches(found: &Ball, expected: &str, what: &str) {
    let expected = decimal(expected);
    let error = (found.clone() - Ball::from_rational(&expected, 300)) / Ball::from_rational(&expected, 300);
    let (low, high) = (error.lower().to_f64(), error.upper().to_f64());
    assert!(low.abs() < 1e-59 && high.abs() < 1e-59, "{what}: {low:e} {high:e}");
}

fn section(kind: &str, given: &str) -> Option<Section> {
    match kind {
        "velocity" => Some(Section::AtVelocity(decimal(given))),
        "normal_stress" => Some(Section::AtNormalStress(decimal(given))),
        _ => None,
    }
}

#[test]
fn sections_cross_the_boundary_where_an_unrelated_program_finds_them() {
    let mut crossings = 0;
    for cells in rows(VECTORS).skip(1) {
        let Some(section) = section(cells[0], cells[6]) else { continue };
        let slider = slider(&cells);
        let expected: Vec<&str> = cells[7].split(' ').filter(|text| !text.is_empty()).collect();
        let sought = |stress: Ball, velocity: Ball| match section {
            Section::AtVelocity(_) => stress,
            Section::AtNormalStress(_) => velocity,
        };
        let by_curve: Vec<Ball> = BoundaryCurve::new(&slider, DIGITS)
            .on_section(&section)
            .into_iter()
            .map(|point| sought(point.normal_stress_pa, point.loading_velocity_m_per_s))
            .collect();
        let by_discriminant = by_discriminant(&slider, &section, DIGITS).unwrap();
        let by_discriminant: Vec<Ball> = by_discriminant.into_iter().map(|solution| solution.value).collect();
        for mut found in [by_curve, by_discriminant] {
            found.sort_by(|x, y| x.centre().partial_cmp(y.centre()).unwrap());
            assert_eq!(found.len(), expected.len(), "{cells:?}");
            for (ball, text) in found.iter().zip(&expected) {
                assert_matches(ball, text, cells[6]);
            }
        }
        crossings += expected.len();
    }
    assert!(crossings > 100, "{crossings}");
}

#[test]
fn cusps_and_worst_corners_are_those_of_an_unrelated_program() {
    for cells in rows(VECTORS).skip(1) {
        let expected: Vec<&str> = cells[7].split(' ').collect();
        if cells[0] == "cusp" {
            let cusp = BoundaryCurve::new(&slider(&cells), DIGITS).cusp();
            let found = [cusp.normal_stress_pa, cusp.loading_velocity_m_per_s, cusp.double_root];
            found.iter().zip(&expected).for_each(|(ball, text)| assert_matches(ball, text, cells[2]));
        }
        if cells[0] == "worst" {
            let errors = corner_errors(&decimal(cells[2]), DIGITS);
            assert_matches(&errors.upper_worst_log10.unwrap(), expected[0], cells[2]);
            assert_matches(&errors.lower_worst_log10, expected[1], cells[2]);
        }
    }
}
