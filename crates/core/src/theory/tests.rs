//! Every proof holds for the paper's equations and survives a round trip.

use rug::Rational;

use super::equations::tests::paper;
use super::*;
use slipmode_algebra::{Expression, Proof, Refutation, Symbol, UnivariatePolynomial};

type Prover = fn(&Equations) -> Result<Proof, Refutation>;

/// Every proof of this module, by the path of its function.
const PROVERS: [(&str, Prover); 28] = [
    ("steady_state::laws_differ_at_rest", steady_state::laws_differ_at_rest),
    ("regularised::linearisation", regularised::linearisation),
    ("characteristic::prove", characteristic::prove),
    ("characteristic::dimensionless", characteristic::dimensionless),
    ("transition::stability", transition::stability),
    ("transition::intrinsically_stable", transition::intrinsically_stable),
    ("inertial::small_slip_distance", inertial::small_slip_distance),
    ("inertial::large_slip_distance", inertial::large_slip_distance),
    ("frequency::bounded", frequency::bounded),
    ("frequency::low_frequency_zone", frequency::low_frequency_zone),
    ("non_inertial::at_critical_stress", non_inertial::at_critical_stress),
    ("non_inertial::mass", non_inertial::mass),
    ("non_inertial::stiffness", non_inertial::stiffness),
    ("non_inertial::at_stress_ratio", non_inertial::at_stress_ratio),
    ("exchange::no_other_choice", exchange::no_other_choice),
    ("exchange::frequency_contours", exchange::frequency_contours),
    ("boundary::prove", boundary::prove),
    ("boundary::cusp", boundary::cusp),
    ("boundary::transition_avoids", boundary::transition_avoids),
    ("worst_error::prove", worst_error::prove),
    ("strip_frequency::prove", strip_frequency::prove),
    ("criteria::inertial_parameter", criteria::inertial_parameter),
    ("monotone::unstable_real_area", monotone::unstable_real_area),
    ("monotone::upper_area", monotone::upper_area),
    ("monotone::unstable_side", monotone::unstable_side),
    ("monotone::lower_area_path", monotone::lower_area_path),
    ("monotone::lower_area_between", monotone::lower_area_between),
    ("monotone_frequency::threshold", monotone_frequency::threshold),
];

#[test]
fn the_papers_equations_are_proved_and_the_proofs_recheck_after_a_round_trip() {
    for (name, prover) in PROVERS {
        let proof = prover(&paper()).unwrap_or_else(|refutation| panic!("{name}: {refutation}"));
        let text = serde_json::to_string(&proof).expect("serialisable");
        let read: Proof = serde_json::from_str(&text).expect("readable");
        assert_eq!(read.to_string(), proof.to_string(), "{name}");
        assert_eq!(read.recheck(), Ok(()), "{name}");
    }
}

#[test]
fn leading_errors_of_the_asymptotes() {
    let second = |number: &str| -> Vec<String> {
        let all = asymptote_series::derive(&paper(), 2).expect("asymptotes of the boundary");
        let series = all.into_iter().find(|series| series.equation == number).expect("one of the four");
        assert_eq!(series.proof.recheck(), Ok(()));
        series.coefficients.iter().map(ToString::to_string).collect()
    };
    assert_eq!(second("15"), ["0", "1", "-w + 1"]);
    assert_eq!(second("16"), ["0", "1", "w + 1"]);
    assert_eq!(second("18")[1], "-2*beta/(beta - 1)^2");
    assert_eq!(second("20"), ["0", "beta/2", "(3*beta^2 + 2*beta)/8"]);
}

#[test]
fn areas_are_two_one_and_two_and_unstable_for_weakening_only() {
    let counted = areas::Effects::ALL.map(|effects| {
        let areas = areas::count(&paper(), effects).expect("eq 8 has the form");
        assert_eq!(areas.proof.recheck(), Ok(()));
        (areas.real_areas, areas.unstable_real_areas, areas.exists)
    });
    let (stable, all) = ([true, true, false, false], [true; 4]);
    assert_eq!(counted, [(2, 1, all), (1, 0, stable), (2, 0, stable)]);
}

/// The same count by another way: at fixed η the positive roots of the discriminant in κ, counted by Sturm sequences,
/// close one interval [0, m] (a ≠ b) and, below the cusp, a second one.
#[test]
fn sturm_sequences_count_the_same_areas_on_lines_of_fixed_inertial_parameter() {
    let discriminant = boundary::cubic_discriminant(&paper()).expect("eq 8");
    let ends = |beta: (i32, i32), eta: (i32, i32)| {
        let point = [("beta", beta), ("eta", eta)];
        let line = point.iter().fold(discriminant.clone(), |line, (name, value)| {
            line.substitute(
                &Symbol::from(*name),
                &slipmode_algebra::Polynomial::constant(Rational::from(*value)),
            )
        });
        let coefficients = line
            .coefficients(&Symbol::from("kappa"))
            .iter()
            .filter_map(slipmode_algebra::Polynomial::as_constant)
            .collect();
        UnivariatePolynomial::new(coefficients).isolate_positive_roots().len()
    };
    for (beta, upper) in [((3, 2), 1), ((1, 1), 0), ((2, 3), 1), ((1, 10), 1), ((100, 1), 1)] {
        // The cusp has η = 1/(3x + 2), β = x³/(3x + 2): η = 1/1000 is below it and 1/2 above it for all these β.
        assert_eq!(ends(beta, (1, 1_000)), upper + 2, "below the cusp, beta {beta:?}");
        assert_eq!(ends(beta, (1, 2)), upper, "above the cusp, beta {beta:?}");
    }
}

/// The same bound by another way: below η_c the discriminant has three positive roots in κ, above it one.
#[test]
fn the_sufficient_inertial_parameter_is_where_sturm_sequences_lose_two_roots() {
    let discriminant = boundary::cubic_discriminant(&paper()).expect("eq 8");
    for beta in [(3, 2), (11, 10), (5, 1), (1, 2)].map(Rational::from) {
        let bound = sufficient_inertia::sufficient_inertial_parameter(&beta, 100).expect("one root");
        let near = bound.centre().to_rational().expect("finite");
        let ends = |eta: Rational| {
            let number = |value: &Rational| slipmode_algebra::Polynomial::constant(value.clone());
            let line = discriminant.substitute(&Symbol::from("beta"), &number(&beta));
            let line = line.substitute(&Symbol::from("eta"), &number(&eta));
            let coefficients = line.coefficients(&Symbol::from("kappa"));
            let values = coefficients.iter().filter_map(slipmode_algebra::Polynomial::as_constant);
            UnivariatePolynomial::new(values.collect()).isolate_positive_roots().len()
        };
        let step = Rational::from((1, 1_000_000_000));
        assert_eq!((ends(near.clone() - &step), ends(near.clone() + &step)), (3, 1), "{beta}");
        assert_eq!(beta > 1, near < Rational::from((1, 8)));
        // 1/(2 + 6√β cos(arccos(1/√β)/3)) for β > 1.
        let root = crate::number::nearest_f64(&beta).sqrt();
        let closed = 1.0 / (2.0 + 6.0 * root * libm::cos(libm::acos(1.0 / root) / 3.0));
        assert!(beta < 1 || (closed - bound.to_f64()).abs() < 1e-14, "{beta}: {closed}");
    }
}

#[test]
fn exchange_changes_equation_20_only() {
    let exchanges = exchange::asymptotes(&paper()).expect("definite factors");
    let changed: Vec<&str> = exchanges.iter().filter(|e| !e.invariant).map(|e| e.equation).collect();
    assert_eq!(changed, ["20"]);
    assert_eq!(exchanges[3].factor, "b/a".parse::<Expression>().expect("in the grammar"));
    assert!(!exchanges[3].contains_b);
    assert!(exchanges.iter().all(|exchange| exchange.proof.recheck().is_ok()));
}

#[test]
fn regularised_law_differs_by_less_than_86_orders_of_magnitude() {
    let bound = |effect: (i32, i32)| {
        let difference = regularised::bound(&paper(), &Rational::from((3, 5)), &Rational::from(effect));
        difference.expect("the regularised law").log10_bound
    };
    assert_eq!([bound((4, 1_000)), bound((6, 1_000))], [-129, -86]);
}

#[test]
fn natural_period_of_the_papers_machine_is_not_the_printed_one() {
    let period =
        period::natural(&paper(), &Rational::from(10_000_000), &Rational::from(1_000)).expect("ω_n = 100 /s");
    assert_eq!(period.natural_angular_frequency_per_s.to_string(), "100");
    let [low, high] = &period.period_s;
    assert!(*low > Rational::from((628, 10_000)) && *high < Rational::from((629, 10_000)));
}

#[test]
fn every_step_of_every_proof_has_a_certificate() {
    use crate::friction::EvolutionLaw;
    let paper = paper();
    let mut proofs: Vec<Proof> = PROVERS.iter().map(|(_, prover)| prover(&paper).unwrap()).collect();
    proofs.extend(areas::Effects::ALL.map(|effects| areas::count(&paper, effects).unwrap().proof));
    proofs.extend(exchange::asymptotes(&paper).unwrap().into_iter().map(|exchange| exchange.proof));
    proofs.extend(asymptote_series::derive(&paper, 2).unwrap().into_iter().map(|series| series.proof));
    for law in EvolutionLaw::ALL {
        proofs.push(hopf::coefficient(&paper, law).unwrap().proof);
        proofs.push(hopf::quasi_static_centre(&paper, law).unwrap());
    }
    let (stiffness, mass) = (Rational::from(10_000_000), Rational::from(1_000));
    proofs.push(period::natural(&paper, &stiffness, &mass).unwrap().proof);
    let friction = regularised::bound(&paper, &Rational::from((3, 5)), &Rational::from((4, 1_000)));
    proofs.push(friction.unwrap().proof);
    for proof in proofs {
        let argued: Vec<&str> = proof
            .steps
            .iter()
            .filter(|step| step.certificate.is_none())
            .map(|step| step.says.as_str())
            .collect();
        assert!(argued.is_empty(), "{}: {argued:?}", proof.id);
    }
}
