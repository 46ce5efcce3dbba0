//! Every proof holds for the paper's equations and survives a round trip.

use rug::Rational;

use super::equations::tests::paper;
use super::*;
use crate::notation::{any, formula};
use slipmode_algebra::{Expression, Proof, RationalFunction, Symbol, UnivariatePolynomial};
use slipmode_core::friction::Parameters;

/// The proofs that the paper's report states.
fn proofs() -> Vec<Proof> {
    let (paper, library) = (paper(), stated_proofs::tests::library());
    let stated = library.ids().map(|id| library.prove(id, &paper));
    stated.map(|proof| proof.unwrap_or_else(|refutation| panic!("{refutation}"))).collect()
}

#[test]
fn the_papers_equations_are_proved_and_the_proofs_recheck_after_a_round_trip() {
    for proof in proofs() {
        let text = serde_json::to_string(&proof).expect("serialisable");
        let read: Proof = serde_json::from_str(&text).expect("readable");
        assert_eq!(read.to_string(), proof.to_string(), "{}", proof.id);
        assert_eq!(read.recheck(), Ok(()), "{}", proof.id);
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

/// The areas of the proofs `areas-for-weakening` and so on by another way: at fixed η the positive roots of the discriminant in κ, counted by Sturm sequences,
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

#[test]
fn regularised_law_differs_by_less_than_86_orders_of_magnitude() {
    let bound = |effect: (i32, i32)| {
        let difference = regularised::bound(&Rational::from((3, 5)), &Rational::from(effect));
        difference.expect("the regularised law").log10_bound
    };
    assert_eq!([bound((4, 1_000)), bound((6, 1_000))], [-129, -86]);
}

#[test]
fn every_step_of_every_proof_has_a_certificate() {
    use slipmode_core::friction::EvolutionLaw;
    let paper = paper();
    let mut proofs = proofs();
    proofs.extend(asymptote_series::derive(&paper, 2).unwrap().into_iter().map(|series| series.proof));
    for law in EvolutionLaw::ALL {
        proofs.push(hopf::coefficient(&paper, law).unwrap().proof);
    }
    let friction = regularised::bound(&Rational::from((3, 5)), &Rational::from((4, 1_000)));
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

/// The parameters as symbols.
fn symbolic_parameters() -> Parameters<RationalFunction> {
    Parameters::from(["a", "b", "D_c", "K", "M", "sigma", "V_0"].map(RationalFunction::variable))
}

/// Σ coefficients[k]·variable^k.
fn polynomial(coefficients: &[RationalFunction], variable: &'static str) -> Expression {
    let term = |(power, coefficient): (usize, &RationalFunction)| {
        Expression::from(coefficient) * Expression::variable(variable).power(power as i32)
    };
    coefficients.iter().enumerate().map(term).fold(Expression::integer(0), |sum, part| sum + part)
}

#[test]
fn the_cubic_that_the_program_computes_with_is_eq_8_in_groups_and_per_second() {
    let (parameters, eq8) = (symbolic_parameters(), paper().residual(Role::Characteristic));
    let scaled = eq8.with("s", &formula("p*V_0/D_c")) * formula("D_c^2/(a*V_0)");
    let groups = polynomial(&parameters.groups().characteristic_cubic(), "p");
    let per_second = polynomial(&parameters.characteristic_cubic_per_s(), "s");
    Proof::new("cubic", "")
        .identity("in groups", &["8"], &scaled, &groups, &any())
        .and_then(|proof| proof.identity("in s", &["8"], &(eq8 * formula("sigma")), &per_second, &any()))
        .expect("the same polynomials");
}
