//! The massless slider: hypotheses that hold, and altered ones that are refused.

use super::*;
use crate::notation::formula;
use slipmode_algebra::{Relation, Symbol};

/// What the sliders without mass conserve at the critical stiffness.
const HILL: &str = "ln(V) - V*theta/L - K*V_l*theta/A + (K*L/A + 1)*ln(theta)";

fn system(state: [&'static str; 2], rates: [&str; 2], steady: Option<[&str; 2]>) -> System {
    let steady = steady.map_or_else(Vec::new, |steady| steady.map(formula).into());
    System {
        name: String::new(),
        state: state.map(Symbol::from).into(),
        rates: rates.map(formula).into(),
        steady,
    }
}

fn loaded() -> System {
    let rates = ["V*(K*(V_l - V) - B*(1/theta - V/L))/A", "1 - V*theta/L"];
    system(["V", "theta"], rates, Some(["V_l", "L/V_l"]))
}

fn at_rest() -> System {
    system(["V", "theta"], ["V*(-K*V - B*(1/theta - V/L))/A", "1 - V*theta/L"], None)
}

/// The slip law with g = ln(V θ/L) in place of θ.
fn slip_law() -> System {
    let rates = ["V*(K*(V_l - V) + B*V*g/L)/A", "(K*(V_l - V) + B*V*g/L)/A - V*g/L"];
    system(["V", "g"], rates, Some(["V_l", "0"]))
}

/// All are positive but the listed parameter, which is expressed by the others and a gap.
fn domains(
    condition: &str,
    [name, value]: [&'static str; 2],
    example: &[(&'static str, &str)],
) -> Vec<Domain> {
    let start = Domain::positive("A B K L V V_l theta").given(formula(condition), Relation::Positive);
    let plain = example.iter().fold(start, |domain, (name, value)| domain.example(*name, formula(value)));
    let shifted = plain.clone().with(name, formula(value)).parameter("gap", formula(condition));
    vec![plain, shifted]
}

fn weakening(example: &[(&'static str, &str)]) -> Vec<Domain> {
    domains("B - A", ["B", "A + gap"], example)
}

/// K larger than critical.
fn stiff(example: &[(&'static str, &str)]) -> Vec<Domain> {
    domains("K*L - B + A", ["K", "(B - A + gap)/L"], example)
        .into_iter()
        .chain(domains("K*L - B + A", ["A", "gap + B - K*L"], example))
        .collect()
}

/// K smaller than critical.
fn soft(example: &[(&'static str, &str)]) -> Vec<Domain> {
    domains("B - A - K*L", ["B", "A + K*L + gap"], example)
}

fn prove(lemma: &MotionLemma, system: &System, domains: &[Domain]) -> Result<Proof, Refutation> {
    let proof = lemma.prove(Proof::new("motion", "How it moves."), system, domains)?;
    assert_eq!(proof.recheck(), Ok(()));
    assert!(!proof.is_certified(), "the conclusion is argued");
    Ok(proof)
}

fn critical(system: &System) -> System {
    system.map(|expression| expression.with("B", &formula("A + K*L")))
}

fn lemma(word: MotionWord, expressions: &[&str]) -> MotionLemma {
    MotionLemma::new(word, 0, expressions.iter().map(|text| formula(text)).collect())
}

fn attraction(quantity: &str, zero: &str) -> MotionLemma {
    lemma(MotionWord::Attraction, &[quantity, zero])
}

fn escape(quantity: &str, zero: &str, threshold: &str, growth: &str) -> MotionLemma {
    lemma(MotionWord::Escape, &[quantity, zero, threshold, growth])
}

fn runaway(region: &str, growth: &str) -> MotionLemma {
    lemma(MotionWord::Runaway, &[region, growth])
}

#[test]
fn at_the_critical_stiffness_every_motion_is_periodic() {
    let periodic = |quantity: &str| lemma(MotionWord::Periodic, &[quantity]);
    let domains = weakening(&[("B", "2")]);
    prove(&periodic(HILL), &critical(&loaded()), &domains).unwrap();
    // Minus the quantity is convex and serves as well.
    prove(&periodic(&format!("-({HILL})")), &critical(&loaded()), &domains).unwrap();
    // Another stiffness, and a wrong sign, coefficient or factor.
    let other = loaded().map(|expression| expression.with("B", &formula("A + 2*K*L")));
    let refused = prove(&periodic(HILL), &other, &domains).unwrap_err();
    assert!(
        refused.statement.contains("rate of the quantity") && refused.remainder.contains('K'),
        "{refused}"
    );
    for wrong in
        [HILL.replace("+ (K", "- (K"), HILL.replace("+ 1)", "+ 2)"), HILL.replace("ln(V)", "2*ln(V)")]
    {
        assert!(prove(&periodic(&wrong), &critical(&loaded()), &domains).is_err(), "{wrong}");
    }
    // A conserved quantity that is not concave: the square of the distance from its greatest value is not convex either.
    let refused = prove(&periodic("(ln(V) - V*theta)^2"), &critical(&loaded()), &domains).unwrap_err();
    assert!(!refused.remainder.is_empty());
    // No quantity at all: a constant is conserved, and is no hill.
    let refused = prove(&periodic("K"), &critical(&loaded()), &domains).unwrap_err();
    assert!(refused.statement.contains("second slope"), "{refused}");
}

#[test]
fn above_the_critical_stiffness_steady_sliding_attracts_and_below_it_repels() {
    let (stiff, soft) = (stiff(&[]), soft(&[("B", "3"), ("theta", "10")]));
    let zero = "1 - V*theta/L";
    prove(&attraction(HILL, zero), &loaded(), &stiff).unwrap();
    let threshold = "2*B/K/V_l";
    let growth = "K*V_l/(3*A)";
    prove(&escape(HILL, zero, threshold, growth), &loaded(), &soft).unwrap();
    // The other side of the critical stiffness.
    let refused = prove(&attraction(HILL, zero), &loaded(), &soft).unwrap_err();
    assert!(refused.statement.contains("towards"), "{refused}");
    let refused = prove(&escape(HILL, zero, threshold, growth), &loaded(), &stiff).unwrap_err();
    assert!(refused.statement.contains("away from"), "{refused}");
    // Another curve, another quantity, a threshold that is too low, a growth that is too fast or contains the state.
    for (quantity, zero) in [(HILL, "1 - 2*V*theta/L"), (HILL, "V"), ("ln(V) - V*theta/L", zero), ("V", zero)]
    {
        assert!(prove(&attraction(quantity, zero), &loaded(), &stiff).is_err(), "{quantity} {zero}");
    }
    for (threshold, growth) in
        [("B/(2*K*V_l)", growth), (threshold, "K*V_l"), (threshold, "V/L"), ("V", growth)]
    {
        assert!(
            prove(&escape(HILL, zero, threshold, growth), &loaded(), &soft).is_err(),
            "{threshold} {growth}"
        );
    }
    // Without a steady state there is nothing to approach.
    assert!(prove(&attraction(HILL, zero), &at_rest(), &stiff).is_err());
}

#[test]
fn with_the_load_point_at_rest_a_ratio_separates_runaway_from_deceleration() {
    let example = [("B", "3"), ("V", "4")];
    let beyond = "(B - A - K*L)*V*theta/L - (B - A)";
    let growth = "K/(B - A)";
    prove(&runaway(beyond, growth), &at_rest(), &soft(&example)).unwrap();
    let slower = lemma(MotionWord::Deceleration, &["B - (B - K*L)*V*theta/L"]);
    prove(&slower, &at_rest(), &soft(&[("B", "3")])).unwrap();
    let late = |quantity: &str| lemma(MotionWord::LateDeceleration, &[quantity]);
    prove(&late("V*theta/L"), &at_rest(), &stiff_and_weakening()).unwrap();
    // Too large a region, too fast a growth, the wrong side of the critical stiffness, another quantity.
    let larger = "(B - A - K*L)*V*theta/L - (B - A)/2";
    assert!(prove(&runaway(larger, growth), &at_rest(), &soft(&example)).is_err());
    assert!(prove(&runaway(beyond, "B/(A*L)"), &at_rest(), &soft(&example)).is_err());
    let refused = prove(&late("V*theta/L"), &at_rest(), &soft(&example)).unwrap_err();
    assert!(refused.statement.contains("rate of ln w is negative"), "{refused}");
    assert!(prove(&late("V*theta^2/L"), &at_rest(), &stiff_and_weakening()).is_err());
    // A rate with a logarithm of the other variable does not depend on the ratio alone.
    let mut healing = at_rest();
    healing.rates[1] = formula("1 - V*theta/L*(1 + ln(theta)^2)");
    let refused = prove(&late("V*theta/L"), &healing, &stiff_and_weakening()).unwrap_err();
    assert!(refused.remainder.contains("ln(theta)"), "{refused}");
    let faster = lemma(MotionWord::Deceleration, &["B - (B - K*L)*V*theta/(2*L)"]);
    assert!(prove(&faster, &at_rest(), &soft(&[("B", "3")])).is_err());
}

/// B > A and K L ≥ B − A, the second by a non-strict condition's two cases: here B − A = K L/(1 + gap) < K L.
fn stiff_and_weakening() -> Vec<Domain> {
    let plain = Domain::positive("A B K L V V_l theta")
        .given(formula("B - A"), Relation::Positive)
        .given(formula("K*L - B + A"), Relation::Positive)
        .example("B", formula("3/2"));
    let shifted = plain
        .clone()
        .with("B", formula("A + weakening"))
        .with("K", formula("(weakening + stiffness)/L"))
        .parameter("weakening", formula("B - A"))
        .parameter("stiffness", formula("K*L - B + A"));
    vec![plain, shifted]
}

#[test]
fn with_the_slip_law_large_disturbances_run_away_at_any_stiffness() {
    let domains = weakening(&[("B", "2"), ("g", "2")]);
    let beyond = "(B - A)*g/L - K";
    let growth = "K/B";
    prove(&runaway(beyond, growth), &slip_law(), &domains).unwrap();
    let smaller = "(B - A)*g/L - K/2";
    assert!(prove(&runaway(smaller, growth), &slip_law(), &domains).is_err());
    assert!(prove(&runaway(beyond, "B/L"), &slip_law(), &domains).is_err());
}

mod integrated;
