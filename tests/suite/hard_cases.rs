//! Hard cases with answers from PARI/GP and FLINT (tests/vectors): every sign right, every number to its promise.

use slipmode_core::friction::{Groups, Parameters};
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
use slipmode_core::roots::certified_roots;
use slipmode_core::stability::{InertialThreshold, classify};

const GROUPS: &str = include_str!("../vectors/groups-hard.txt");
pub const PARAMETERS: &str = include_str!("../../reports/im-avouac/timings/classification-hard.txt");
const ROOTS: &str = include_str!("../vectors/roots-1000-digits.txt");

/// What `classify` promises: max Im relative to itself, max Re relative to its root's modulus.
pub const PROMISE: &str = "1e-14";

/// The lines of a vector file, cells split; the first is the header.
pub fn rows(vectors: &str) -> impl Iterator<Item = Vec<&str>> {
    vectors.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').collect())
}

/// A fraction or a decimal, exactly.
pub fn number(text: &str) -> Rational {
    if text.contains('/') { text.parse().unwrap() } else { decimal(text) }
}

pub fn decimal(text: &str) -> Rational {
    parse_decimal(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

pub fn assert_within(found: &Rational, expected: &str, measure: &str, tolerance: &str, what: &str) {
    let error = (found - decimal(expected)).abs();
    let allowed = decimal(measure).abs() * decimal(tolerance);
    assert!(error <= allowed, "{what}: found {}, expected {expected}", nearest_f64(found));
}

/// Inputs with these groups: every unit is 1.
fn unit_parameters(eta: &str, kappa: &str, beta: &str) -> Parameters<Rational> {
    Parameters::from([
        Rational::from(1),
        number(beta),
        Rational::from(1),
        number(kappa),
        number(eta),
        Rational::from(1),
        Rational::from(1),
    ])
}

/// Inputs from the seven cells of a row.
fn parameters(cells: &[&str]) -> Parameters<Rational> {
    Parameters::from([0, 1, 2, 3, 4, 5, 6].map(|column| decimal(cells[column])))
}

/// Compares with the seven cells of expectations that end a row.
fn assert_classified(parameters: &Parameters<Rational>, expected: &[&str], point: &str) {
    let [transition, boundary, class, mode, real, modulus, imaginary] = *expected else {
        panic!("not seven cells: {expected:?}");
    };
    let found = classify(parameters, &InertialThreshold::default());
    assert_eq!(found.transition_sign.to_string(), transition, "{point}");
    assert_eq!(found.boundary_sign.to_string(), boundary, "{point}");
    assert_eq!(found.spectral_class.as_str(), class, "{point}");
    assert_eq!(found.slip_mode.as_str(), mode, "{point}");
    let real_found = found.max_real_per_s.to_float().to_rational().unwrap();
    assert_within(&real_found, real, modulus, PROMISE, point);
    let imaginary_found = found.max_imaginary_per_s.to_float().to_rational().unwrap();
    assert_within(&imaginary_found, imaginary, imaginary, PROMISE, point);
}

#[test]
fn the_library_is_right_on_every_hard_point_of_the_groups() {
    let mut count = 0;
    for row in rows(GROUPS).skip(1) {
        assert_classified(&unit_parameters(row[0], row[1], row[2]), &row[3..], &row[..3].join(","));
        count += 1;
    }
    assert_eq!(count, 265, "every case is tried");
}

#[test]
fn the_library_is_right_on_every_hard_point_of_the_inputs() {
    let mut count = 0;
    for row in rows(PARAMETERS).skip(1) {
        assert_classified(&parameters(&row), &row[7..], &row[..7].join(","));
        count += 1;
    }
    assert_eq!(count, 321, "every case is tried");
}

#[test]
fn a_thousand_digits_of_every_root_agree_with_two_other_programs() {
    let mut expected = rows(ROOTS).skip(1).peekable();
    let mut points = 0;
    while let Some(first) = expected.peek().cloned() {
        let [eta, kappa, beta] = [0, 1, 2].map(|column| number(first[column]));
        let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
        let found = certified_roots(&groups.characteristic_cubic(), 1000);
        // Of a pair the vectors list the upper root only.
        for root in found.roots.iter().filter(|root| root.im >= 0) {
            let row = expected.next().unwrap();
            let [_, _, _, multiplicity, re, im] = row[..] else { panic!("not six cells: {row:?}") };
            assert_eq!(row[..3], first[..3], "as many roots as expected");
            assert_eq!(root.multiplicity.to_string(), multiplicity);
            let larger = if decimal(re).abs() > decimal(im).abs() { re } else { im };
            // The expected decimals end at the thousandth digit, the enclosure's radius is below it.
            assert_within(&root.re.to_rational().unwrap(), re, larger, "1e-999", &first[..3].join(","));
            assert_within(&root.im.to_rational().unwrap(), im, larger, "1e-999", &first[..3].join(","));
        }
        points += 1;
    }
    assert_eq!(points, 50, "every case is tried");
}
