//! The coefficient of both laws, its sign, and what becomes of it when an equation is altered.

mod simulated;

use super::*;
use crate::equations::tests::paper;
use slipmode_core::number::Rational;

#[test]
fn both_routes_give_the_closed_form_and_the_proof_rechecks_after_a_round_trip() {
    for law in EvolutionLaw::ALL {
        let hopf = coefficient(&paper(), law).unwrap_or_else(|refutation| panic!("{refutation}"));
        let text = serde_json::to_string(&hopf.proof).expect("serialisable");
        let read: Proof = serde_json::from_str(&text).expect("readable");
        assert_eq!(read.to_string(), hopf.proof.to_string());
        assert_eq!(read.recheck(), Ok(()));
    }
}

#[test]
fn altered_laws_are_refuted_by_name() {
    let alterations = [
        ("2", EvolutionLaw::Aging, "theta' = 1 + V*theta/D_c"),
        ("2", EvolutionLaw::Aging, "theta' = 1 - (V*theta/D_c)^2"),
        ("3", EvolutionLaw::Slip, "theta' = V*theta/D_c*ln(V*theta/D_c)"),
        ("3", EvolutionLaw::Slip, "theta' = -2*V*theta/D_c*ln(V*theta/D_c)"),
        ("1", EvolutionLaw::Slip, "mu = mu_0 - a*ln(V/V_0) + b*ln(V_0*theta/D_c)"),
        ("4", EvolutionLaw::Slip, "M*delta''/sigma = -K*(V_0*t - delta)/sigma - mu"),
    ];
    for (number, law, text) in alterations {
        let altered = paper().altered(number, text).expect("in the grammar");
        let refutation = coefficient(&altered, law).expect_err(text);
        assert!(refutation.equations.iter().any(|equation| equation == number), "{refutation}");
    }
}

/// A law with the same rest and the same linear part gets through the derivation; its coefficient is another one.
#[test]
fn a_law_altered_beyond_its_linear_part_changes_the_coefficient_only() {
    let text = "theta' = -(V*theta/D_c)^2*ln(V*theta/D_c)";
    let altered = paper().altered("3", text).expect("in the grammar");
    let refutation = coefficient(&altered, EvolutionLaw::Slip).expect_err("another law");
    assert_eq!(refutation.statement, "c_1 in closed form");
    assert!(refutation.counter_example.is_some());
}

#[test]
fn kind_changes_at_the_stated_inertial_parameter() {
    // β = 6 makes √(β + 3) rational: η_0 = 1/(3 + 2·3) = 1/9.
    let of = |law, eta: (i32, i32)| Criticality::of(law, &Rational::from(eta), &Rational::from(6));
    assert_eq!(of(EvolutionLaw::Aging, (1, 9)), Criticality::Degenerate);
    assert_eq!(of(EvolutionLaw::Aging, (112, 1_000)), Criticality::Supercritical);
    assert_eq!(of(EvolutionLaw::Aging, (111, 1_000)), Criticality::Subcritical);
    assert_eq!(of(EvolutionLaw::Slip, (1, 1_000_000)), Criticality::Supercritical);
}

/// The kind and the sign of the derived coefficient are the same where ω is rational.
#[test]
fn kind_is_the_sign_of_the_coefficient() {
    for law in EvolutionLaw::ALL {
        let real = closed_form::stated("real_part", law);
        for (eta, omega) in [("1/100", "1/3"), ("1/8", "1/2"), ("13/100", "2"), ("1/7", "1/9"), ("5", "3")] {
            let value = real.with("eta", &formula(eta)).with("omega", &formula(omega));
            let sign = slipmode_algebra::Domain::default().sign(&value).expect("a number");
            let number = |text: &str| text.parse::<Rational>().expect("a fraction");
            let beta = number(omega).square() + 1;
            let expected = match Criticality::of(law, &number(eta), &beta) {
                Criticality::Supercritical => Some(-1),
                Criticality::Subcritical => Some(1),
                Criticality::Degenerate => None,
            };
            assert_eq!(sign, expected, "{law:?} {eta} {omega}");
        }
    }
}
