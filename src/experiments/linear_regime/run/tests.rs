//! The linear regime holds for the roots of eq 8, and for no other rates.

use super::*;
use crate::experiments::shared::fixtures::with_effects;
use slipmode_core::number::parse_decimal;

fn decimal(text: &str) -> Rational {
    parse_decimal(text).unwrap()
}

fn place([velocity, stress]: [&str; 2]) -> PlanePoint {
    PlanePoint { loading_velocity_m_per_s: decimal(velocity), normal_stress_pa: decimal(stress) }
}

fn section(points: &[[&str; 2]], amplitudes: &[&str]) -> LinearRegimeSection {
    LinearRegimeSection {
        points: points.iter().map(|point| place(*point)).collect(),
        laws: EvolutionLaw::ALL.to_vec(),
        amplitudes: amplitudes.iter().map(|text| decimal(text)).collect(),
    }
}

fn runs(parameters: &Slider<Rational>, section: &LinearRegimeSection) -> Vec<ModeRuns> {
    let outcome = linear_regime(parameters, section, &InertialThreshold::default());
    outcome.runs.into_iter().map(Result::unwrap).collect()
}

#[test]
fn every_root_is_met_and_the_mismatch_falls_with_the_amplitude_as_predicted() {
    let points = [["1e-5", "1e3"], ["1e-3", "1e3"], ["1e-5", "1e6"], ["1e-2", "1e4"]];
    for parameters in [with_effects("0.004", "0.006"), with_effects("0.006", "0.004")] {
        let all = runs(&parameters, &section(&points, &["1e-9", "1e-6"]));
        // Three starts for each point and law: one for a real root, two for a pair.
        assert_eq!(all.len(), 3 * 2 * points.len());
        for run in &all {
            assert!(run.least_mismatch().unwrap() < 1e-6, "{run:?}");
            assert!((run.order().unwrap() - 1.0).abs() < 1e-3, "{run:?}");
            assert!(run.off_prediction().unwrap() < 1e-5, "{run:?}");
        }
    }
}

#[test]
fn a_rate_with_one_wrong_sign_is_not_met_at_any_amplitude() {
    let groups = with_effects("0.004", "0.006").at(decimal("2e4"), decimal("1e-3")).groups();
    let [constant, _, square, cube] = groups.characteristic_cubic();
    // κ + 1 + β instead of κ + 1 − β.
    let linear = groups.stiffness_group.clone() + 1u32 + &groups.effect_ratio;
    for root in certified_roots(&[constant, linear, square, cube], ROOT_DIGITS).roots {
        let mode = Mode::of(&root, &groups);
        let model = Model::new(groups.map(Dd::from_rational), EvolutionLaw::Slip);
        let start = mode.start(Direction::RealPart, 1e-9);
        let time = 1.0 / mode.modulus();
        let states = snapshots(&model, Radau::<Dd, 7>::new(), start, FINE, time).unwrap();
        let found = mismatch(
            &mode,
            1e-9,
            &projected_rate(&mode, &states, time),
            &rate_of_snapshots(&states, mode.is_real(), time),
        );
        assert!(found.size() > 1e-2 && found.snapshots > 1e-2, "{found:?}");
    }
}

#[test]
fn a_root_off_by_a_part_in_a_million_shows_as_a_floor() {
    let groups = with_effects("0.004", "0.006").at(decimal("2e4"), decimal("1e-3")).groups();
    let root = certified_roots(&groups.characteristic_cubic(), ROOT_DIGITS).roots.swap_remove(0);
    let mode = Mode::with_rate(Complex::with_val(BITS, (&root.re * 1.000_001f64, &root.im)), &groups);
    let model = Model::new(groups.map(Dd::from_rational), EvolutionLaw::Aging);
    let at = |amplitude: f64| {
        let time = 1.0 / mode.modulus();
        let start = mode.start(Direction::RealPart, amplitude);
        let states = snapshots(&model, Radau::<Dd, 7>::new(), start, FINE, time).unwrap();
        mismatch(&mode, amplitude, &projected_rate(&mode, &states, time), &mode.rate).size()
    };
    let (small, smaller) = (at(1e-9), at(1e-12));
    assert!(smaller > 1e-7 && (small / smaller - 1.0).abs() < 0.1, "{small:e} {smaller:e}");
}
