//! All formulas of the reports pass with the verdicts of the prover. Planted verdicts do not.

use std::sync::Arc;

use super::*;
use crate::claims::alterations::alterations;
use crate::claims::formula::decide_equations;
use crate::claims::{Evidence, known_ids};
use crate::scene::{ClaimEntry, FormulaCondition, Names, Scope, Statement, read_claims, read_equations};

const REPORTS: [&str; 5] =
    ["im-avouac", "paper-on-paper", "ranjith-rice-1999", "rice-ruina-1983", "rock-friction"];

/// A formula of a report, with the claim's id.
struct Stated {
    id: String,
    formula: ClaimFormula,
    equations: Arc<Equations>,
}

/// The formulas of a report about equations.
fn of_report(report: &str) -> Vec<Stated> {
    let read = |name: &str| {
        std::fs::read(format!("{}/reports/{report}/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
    };
    let equations = Arc::new(read_equations("equations.toml", &read("equations.toml")).unwrap());
    let claims = read_claims("claims.toml", &read("claims.toml"), &known_ids(), Some(&equations)).unwrap();
    let of_claim = |claim: ClaimEntry| {
        let parts = claim.stated.iter().flat_map(|stated| stated.parts()).map(|(_, formula)| formula);
        let all = parts.flat_map(ClaimFormula::with_outside).filter(|formula| formula.rows.is_none());
        let stated = |formula: &ClaimFormula| Stated {
            id: format!("{report} {}", claim.id),
            formula: formula.clone(),
            equations: equations.clone(),
        };
        all.map(stated).collect::<Vec<_>>()
    };
    claims.into_iter().flat_map(of_claim).collect()
}

/// A finding that a formula holds, on no ground.
fn planted_to_hold() -> Finding {
    Finding::from_evidence(Evidence::Enclosure { quantity: "planted".into(), value: "1".into() })
}

/// A finding that a formula fails, at points that meet the conditions.
fn planted_to_fail(claim: &Claim) -> Finding {
    let named = |base: Base| -> NamedPoint {
        base.into_iter().map(|(variable, value)| (claim.book.name(variable).to_owned(), value)).collect()
    };
    let points: Vec<Base> = match claim.moving() {
        Some(variable) if !matches!(claim.says, Says::Limit(..)) => {
            claim.pairs(variable, 50).next().unwrap().into()
        }
        _ => claim.inside().take(1).collect(),
    };
    Finding::failing("planted").seen_at(points.into_iter().map(named))
}

#[test]
fn the_verdicts_of_the_reports_pass_and_their_opposites_do_not() {
    let (mut passed, mut on_motions, mut planted, mut noticed) = (0, 0, 0, 0);
    let mut seen: Vec<(ClaimFormula, Arc<Equations>)> = Vec::new();
    for Stated { id, formula, equations } in REPORTS.iter().flat_map(|report| of_report(report)) {
        // Two reports repeat formulas of the first one.
        if seen.iter().any(|(known, of)| *known == formula && *of == equations) {
            continue;
        }
        seen.push((formula.clone(), equations.clone()));
        let finding = decide_equations("formula", "", &formula, &equations);
        let own = tested(&formula, &finding, &equations);
        if matches!(formula.statement, Statement::Motion(_)) {
            assert!(matches!(own, Outcome::NotEvaluated(_)), "{id}: {own:?}");
            on_motions += 1;
            continue;
        }
        assert!(matches!(own, Outcome::Passed { points: 1.., .. }), "{id}: {}: {own:?}", formula.text);
        passed += 1;
        let claim = Claim::of(&formula, &equations).unwrap().unwrap();
        let opposite = match finding.verdict {
            Verdict::Holds => planted_to_fail(&claim),
            _ => planted_to_hold(),
        };
        planted += 1;
        match tested(&formula, &opposite, &equations) {
            Outcome::Contradicted(_) | Outcome::Unconfirmed(_) => noticed += 1,
            other => eprintln!("not noticed: {id}: {} {:?}: {other:?}", formula.text, opposite.verdict),
        }
    }
    eprintln!("{passed} passed, {on_motions} on motions; {noticed} of {planted} planted verdicts noticed");
    assert!(passed >= 100 && on_motions == 9, "{passed} passed, {on_motions} on motions");
    assert_eq!(noticed, planted);
}

#[test]
fn a_formula_that_an_altered_equation_makes_false_does_not_pass_as_one_that_holds() {
    let (mut planted, mut missed) = (0, Vec::new());
    for (turn, Stated { id, formula, equations }) in of_report("rice-ruina-1983").into_iter().enumerate() {
        let names = Names::of(&equations);
        let own: BTreeSet<String> = formula
            .expressions()
            .into_iter()
            .flat_map(|side| names.equations_of(side).into_iter().map(str::to_owned).collect::<Vec<_>>())
            .collect();
        for equation in equations.iter().filter(|equation| own.contains(&equation.number)) {
            for alteration in alterations(equation, &[]).into_iter().skip(turn % 3).step_by(3) {
                let Ok(altered) = equations.altered(&equation.number, &alteration.text) else { continue };
                let finding = decide_equations("formula", "", &formula, &altered);
                if finding.verdict != Verdict::Fails {
                    continue;
                }
                planted += 1;
                assert!(
                    matches!(tested(&formula, &finding, &altered), Outcome::Passed { .. }),
                    "{id}: {} with {}",
                    formula.text,
                    alteration.text
                );
                if !matches!(tested(&formula, &planted_to_hold(), &altered), Outcome::Contradicted(_)) {
                    missed.push(format!("{id}: {} with {}", formula.text, alteration.text));
                }
            }
        }
    }
    eprintln!("{} of {planted} noticed; missed: {missed:#?}", planted - missed.len());
    assert!(planted >= 20 && missed.is_empty(), "{planted} planted, missed: {missed:#?}");
}

const FILE: &str = "[assumptions]\npositive = [\"A\", \"B\", \"K\", \"M\", \"V\"]\nfree = [\"x\", \"y\", \"s\"]\n\
    [[equation]]\nnumber = \"1\"\nequation = \"w = sqrt(K/M)\"\n\
    [[definition]]\nname = \"H\"\nis = \"hurwitz(s^3 + A*s^2 + B*s + K, s, 2)\"\n\
    [[definition]]\nname = \"K_0\"\nis = \"solve(H, K)\"\n";

fn outcome(text: &str, given: &[&str], there_is: &[&str], verdict: &Finding) -> Outcome {
    let equations = read_equations("equations.toml", FILE.as_bytes()).unwrap();
    let names = Names::of(&equations);
    let given = given.iter().map(|text| FormulaCondition::read(text, &names).unwrap()).collect();
    let there_is = there_is.iter().map(|&name| name.parse().unwrap()).collect();
    let formula =
        ClaimFormula::read(text, Scope { given, there_is, ..Scope::default() }, &equations).unwrap();
    tested(&formula, verdict, &equations)
}

fn fails_at(values: &[(&str, i32)]) -> Finding {
    let point = values.iter().map(|(name, value)| ((*name).to_owned(), Rational::from(*value))).collect();
    Finding::failing("planted").seen_at([point])
}

#[test]
fn what_is_false_at_an_edge_alone_does_not_pass() {
    for (text, given) in [
        ("K > A", vec!["K >= A"]),
        ("stable(s^3 + A*s^2 + B*s + K, s)", vec!["K <= K_0"]),
        ("not all_real(s^2 - 2*w*s + V, s)", vec!["V >= w^2"]),
        ("(x - 7)^2 > 0", vec![]),
        ("(K - M)^2*(A - B)^2 > 0", vec![]),
        ("w depends on A", vec![]),
        ("w does not depend on K", vec![]),
        ("w rises with M", vec![]),
        ("1/(K + x^2) -> 1/M as x -> 0", vec![]),
    ] {
        let found = outcome(text, &given, &[], &planted_to_hold());
        assert!(matches!(found, Outcome::Contradicted(_) | Outcome::Unconfirmed(_)), "{text}: {found:?}");
    }
}

#[test]
fn a_counter_example_has_to_be_one() {
    let fails = |values: &[(&str, i32)]| outcome("K > A", &["K > M"], &[], &fails_at(values));
    assert_eq!(fails(&[("K", 2), ("A", 2), ("M", 1)]), Outcome::Passed { points: 1, open: 0 });
    for (values, words) in [
        ([("K", 3), ("A", 2), ("M", 1)], "At A = 2, K = 3, M = 1 it is true."),
        ([("K", 2), ("A", 2), ("M", 2)], "At A = 2, K = 2, M = 2 a condition is not met."),
        ([("K", 2), ("A", -2), ("M", 1)], "At A = -2, K = 2, M = 1 a condition is not met."),
    ] {
        assert_eq!(fails(&values), Outcome::Contradicted(words.into()));
    }
    let none = outcome("K > A", &[], &[], &Finding::failing("somewhere"));
    assert!(matches!(none, Outcome::Unconfirmed(_)), "{none:?}");
    let edge = "unstable(s^2 + (A - B)*s + K, s)";
    let axis = outcome(edge, &[], &[], &fails_at(&[("A", 1), ("B", 1), ("K", 2)]));
    assert_eq!(axis, Outcome::Passed { points: 1, open: 0 });
    // At A = 9 the value V = 4 does.
    let there_is = |value: i32| outcome("V^2 < A", &["V > B"], &["V"], &fails_at(&[("A", value), ("B", 3)]));
    assert_eq!(there_is(9), Outcome::Passed { points: 1000, open: 0 });
    assert!(matches!(there_is(16), Outcome::Contradicted(_)));
}

#[test]
fn a_contradiction_makes_the_claim_undecided_and_names_the_formula() {
    let equations = read_equations("equations.toml", FILE.as_bytes()).unwrap();
    let formula = ClaimFormula::read("K > A", Scope::default(), &equations).unwrap();
    let found = passed(&formula, planted_to_hold(), &equations);
    assert_eq!(found.verdict, Verdict::NotChecked);
    let [contradiction] = &found.contradictions[..] else { panic!("{found:?}") };
    assert!(contradiction.starts_with("the proof says that 'K > A' holds"), "{contradiction}");
    let honest = passed(&formula, fails_at(&[("K", 1), ("A", 1)]), &equations);
    assert_eq!((honest.verdict, honest.contradictions.len()), (Verdict::Fails, 0));
}

/// A file with a function of which nothing is known.
const WITH_FUNCTION: &str = r#"
[assumptions]
positive = ["K", "M", "V"]
free = ["x", "y"]
[[function]]
name = "f"
[[system]]
name = "slider"
state = ["x", "y"]
rates = ["V - y", "(K*x - f(y))/M"]
steady = ["f(V)/K", "V"]
[[definition]]
name = "P"
is = "characteristic(slider, s)"
[[definition]]
name = "D"
is = "derivative(f(2*x), x)"
"#;

#[test]
fn wrong_verdicts_on_every_smooth_function_do_not_pass() {
    let equations = read_equations("equations.toml", WITH_FUNCTION.as_bytes()).unwrap();
    let names = Names::of(&equations);
    let formula = |text: &str, given: &[&str]| {
        let given = given.iter().map(|one| FormulaCondition::read(one, &names).unwrap()).collect();
        ClaimFormula::read(text, Scope { given, ..Scope::default() }, &equations).unwrap()
    };
    for (text, given) in [
        ("stable(P, s) iff f'(V) > 0", &[][..]),
        ("D = 2*f'(2*x)", &[]),
        ("f(x) = f(y)", &["x = y"]),
        ("x*f'(y) rises with x", &["f'(y) > 0"]),
        ("f(x) -> f(0) as K -> 0", &["x = 0"]),
    ] {
        let said = formula(text, given);
        let own = tested(&said, &planted_to_hold(), &equations);
        assert!(matches!(own, Outcome::Passed { points: 1.., .. }), "{text}: {own:?}");
        let claim = Claim::of(&said, &equations).unwrap().unwrap();
        let opposite = tested(&said, &planted_to_fail(&claim), &equations);
        assert!(!matches!(opposite, Outcome::Passed { .. }), "{text}: {opposite:?}");
    }
    for (text, given) in [
        ("stable(P, s)", &[][..]),
        ("D = f'(2*x)", &[]),
        ("f(x) = f(y)", &[]),
        ("f(x) = f(-x)", &[]),
        ("f'(x) > 0", &["f'(y) > 0"]),
        ("f(x) rises with x", &["f'(y) > 0"]),
        ("f(x) does not depend on x", &[]),
        ("f(K) -> 0 as K -> infinity", &[]),
    ] {
        let own = tested(&formula(text, given), &planted_to_hold(), &equations);
        assert!(matches!(own, Outcome::Contradicted(_)), "{text}: {own:?}");
    }
}

#[test]
fn a_counter_example_gives_the_function_its_own_terms() {
    let equations = read_equations("equations.toml", WITH_FUNCTION.as_bytes()).unwrap();
    let formula = ClaimFormula::read("f(x) = f(y)", Scope::default(), &equations).unwrap();
    let at = |values: &[(&str, i32)]| {
        let point: NamedPoint =
            values.iter().map(|(name, value)| ((*name).to_owned(), Rational::from(*value))).collect();
        tested(&formula, &Finding::failing("planted").seen_at([point]), &equations)
    };
    assert!(matches!(at(&[("x", 0), ("y", 1), ("f(0)", 3), ("f'(0)", -1)]), Outcome::Passed { .. }));
    // A constant, and an even function at opposite values.
    assert!(matches!(at(&[("x", 0), ("y", 1), ("f(0)", 3)]), Outcome::Contradicted(_)));
    assert!(matches!(at(&[("x", 1), ("y", -1), ("f''(0)", 3)]), Outcome::Contradicted(_)));
    let high = format!("f{}(0)", "'".repeat(30));
    assert!(matches!(at(&[("x", 0), ("y", 1), (high.as_str(), 1)]), Outcome::Unconfirmed(_)));
}
