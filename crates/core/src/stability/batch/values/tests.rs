//! Values of grids and of points against 60-digit roots.

use super::*;
use crate::number::nearest_f64;
use crate::roots::certified_roots;
use crate::stability::batch::dispatch::Kernel;
use crate::stability::curve;
use proptest::prelude::*;
use rug::Float;

/// Holds a value against 60-digit roots; the largest error of the two parts, in units of the last place.
fn error_in_units(point: &Parameters<Rational>, found: &LargestPartsPerS) -> f64 {
    let roots = certified_roots(&point.groups().characteristic_cubic(), 60).roots;
    let rate = point.rate_per_s();
    let in_si = |part: &Float| Float::with_val(200, part * &rate);
    let rightmost = roots.iter().max_by(|x, y| x.re.total_cmp(&y.re)).unwrap();
    let highest = roots.iter().max_by(|x, y| x.im.total_cmp(&y.im)).unwrap();
    let (re, im) = (in_si(&rightmost.re), in_si(&highest.im));
    let modulus = re.clone().hypot(&in_si(&rightmost.im));
    let units = |found: Wide, exact: Float, size: &Float| {
        let unit = libm::ldexp(1.0, size.get_exp().unwrap_or(0) - 53);
        (Float::with_val(200, found.to_float()) - exact).abs().to_f64() / unit
    };
    let of_imaginary = if im.is_zero() {
        if found.imaginary == Wide::ZERO { 0.0 } else { f64::INFINITY }
    } else {
        units(found.imaginary, im.clone(), &im)
    };
    of_imaginary.max(units(found.real, re, &modulus))
}

fn slider(exponents: [f64; 5]) -> Slider<Rational> {
    let [a, ratio, d, k, m] = exponents.map(|exponent| exact(libm::exp10(exponent)));
    Slider {
        evolution_effect: a.clone() * ratio,
        direct_effect: a,
        critical_slip_distance_m: d,
        stiffness_pa_per_m: k,
        mass_per_area_kg_per_m2: m,
    }
}

fn kernel_row(terms: &ValueTerms, velocity: f64, stresses: &[f64], plain: bool) -> [Vec<f64>; 2] {
    let [mut real, mut imaginary] = [(); 2].map(|()| vec![0.0; stresses.len()]);
    let row = terms.row(velocity);
    let parts = PartColumns { real: &mut real, imaginary: &mut imaginary };
    let work = ValueLoop { row: &row, stresses, parts };
    if plain {
        work.run()
    } else {
        run_on_widest_unit(work)
    }
    [real, imaginary]
}

fn at(fixed: &Slider<Rational>, velocity: f64, stress: f64) -> Parameters<Rational> {
    fixed.at(exact(stress), exact(velocity))
}

proptest! {
    #[test]
    fn what_the_kernel_proves_is_within_two_units_in_the_last_place(
        exponents in [-4f64..-1.5, -1.3f64..1.3, -7f64..-2.0, 4f64..12.0, -2f64..7.0],
        velocity in -9f64..1.0, stresses in prop::array::uniform8(2f64..9.0),
    ) {
        let (fixed, velocity) = (slider(exponents), libm::exp10(velocity));
        let stresses = stresses.map(libm::exp10);
        let [real, imaginary] = kernel_row(&ValueTerms::new(&fixed), velocity, &stresses, false);
        for (index, &stress) in stresses.iter().enumerate() {
            if let Some(found) = certified(real[index], imaginary[index]) {
                let point = at(&fixed, velocity, stress);
                prop_assert!(error_in_units(&point, &found) <= 2.0, "{:?} {:?}", point, found);
            }
        }
    }

    /// σ of the boundary and of the transition for a = D_c = 1, V0 = 1, at distances from zero to 1e-6.
    #[test]
    fn next_to_the_boundary_and_the_transition_values_keep_their_digits(
        steps in 7i32..384, ratio in 71i32..512, depth in 6i32..54, on in prop::bool::ANY,
    ) {
        let ratio = Rational::from((ratio, 64));
        let r = -1.0 - (64.0 * nearest_f64(&ratio).sqrt()).ceil() / 64.0 - f64::from(steps) / 64.0;
        let r = exact(r);
        let one = Rational::from(1);
        let at_groups = |eta: Rational, kappa: Rational| Slider {
            direct_effect: one.clone(),
            evolution_effect: ratio.clone(),
            critical_slip_distance_m: one.clone(),
            stiffness_pa_per_m: kappa,
            mass_per_area_kg_per_m2: eta,
        };
        let eta = curve::inertial_parameter(&r, &ratio);
        let beside = at_groups(eta.clone(), curve::stiffness_group(&r, &ratio));
        let critical = (ratio.clone() - 1u32) * (eta.clone() + 1u32);
        for fixed in [beside, at_groups(eta, critical)] {
            let stress = if on { 1.0 } else { 1.0 + libm::ldexp(1.0, -depth) };
            let values = grid_values(&fixed, &[1.0], &[stress]).unwrap();
            let point = at(&fixed, 1.0, stress);
            prop_assert!(error_in_units(&point, &values[0]) <= 2.0, "{:?} {:?}", point, values);
        }
    }

    #[test]
    fn points_of_columns_keep_their_digits_from_the_hard_to_the_wild(
        exponents in prop::collection::vec(prop::array::uniform7(-12f64..12.0), 1..20), same in prop::bool::ANY,
    ) {
        let column = |k: usize| exponents.iter().map(|e| libm::exp10(e[k])).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = (0..7).map(column).collect();
        let points = Parameters::from([0, if same { 0 } else { 1 }, 2, 3, 4, 5, 6].map(|k| &columns[k][..]));
        let values = point_values(&points).unwrap();
        prop_assert_eq!(values.len(), exponents.len());
        for (index, found) in values.iter().enumerate() {
            let point = points.map(|column| exact(column[index]));
            prop_assert!(error_in_units(&point, found) <= 2.0, "{:?} {:?}", point, found);
        }
    }

    #[test]
    fn vector_units_and_the_baseline_give_the_same_bits(
        exponents in [-4f64..-1.5, -1.3f64..1.3, -7f64..-2.0, 4f64..12.0, -2f64..7.0], velocity in -9f64..1.0,
    ) {
        let (terms, velocity) = (ValueTerms::new(&slider(exponents)), libm::exp10(velocity));
        let stresses: Vec<f64> = (0..67).map(|i| libm::exp10(2.0 + 0.1 * f64::from(i))).collect();
        let bits = |plain| {
            kernel_row(&terms, velocity, &stresses, plain).map(|part| part.into_iter().map(f64::to_bits).collect::<Vec<_>>())
        };
        prop_assert_eq!(bits(true), bits(false));
    }
}

#[test]
fn the_kernel_proves_nearly_all_of_the_papers_map() {
    let terms = ValueTerms::new(&crate::stability::fixtures::paper());
    let stresses: Vec<f64> = (0..200).map(|i| libm::exp10(2.0 + 0.035 * f64::from(i))).collect();
    let open = (0..80).map(|i| {
        let [_, imaginary] = kernel_row(&terms, libm::exp10(-7.0 + 0.1 * f64::from(i)), &stresses, false);
        imaginary.iter().filter(|part| part.is_nan()).count()
    });
    assert!(open.sum::<usize>() < 80 * 200 / 100);
}

#[test]
fn values_of_a_grid_are_within_two_units_in_the_last_place() {
    let fixed = crate::stability::fixtures::paper();
    let axis =
        |from: f64, to: f64| (0..40).map(|i| libm::exp10(from + (to - from) * f64::from(i) / 39.0)).collect();
    let (velocities, stresses): (Vec<f64>, Vec<f64>) = (axis(-9.0, 2.0), axis(1.0, 9.0));
    let values = grid_values(&fixed, &velocities, &stresses).unwrap();
    for (index, found) in values.iter().enumerate() {
        let (velocity, stress) = (velocities[index / 40], stresses[index % 40]);
        let point = at(&fixed, velocity, stress);
        assert!(error_in_units(&point, found) <= 2.0, "{velocity:e} {stress:e} {found:?}");
        let by_rationals = exactly(&point);
        assert!(error_in_units(&point, &by_rationals) <= 2.0, "{velocity:e} {stress:e} {by_rationals:?}");
    }
}

#[test]
fn columns_of_unequal_length_and_values_out_of_range_have_no_values() {
    let with_effect = |effect: &[f64], stress: &[f64]| {
        let one = &[1.0][..];
        point_values(&Parameters::from([one, effect, one, one, one, stress, one]))
    };
    let values = |stress: &[f64]| with_effect(&[1.0], stress);
    assert!(values(&[2.0]).is_some() && values(&[1.0, 2.0]).is_none());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(values(&[bad]).is_none() && with_effect(&[bad], &[2.0]).is_none());
    }
}
