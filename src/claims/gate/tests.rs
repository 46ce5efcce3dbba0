//! All formulas of the reports pass with the verdicts of the prover. Planted verdicts do not.

use std::{collections::BTreeSet, sync::Arc};

use super::*;
use crate::claims::alterations::alterations;
use crate::claims::formula::decide_equations;
use crate::claims::{Evidence, procedures};
use crate::scene::{ClaimEntry, FormulaCondition, Names, Scope, Statement, read_claims, read_equations};
use number::{Number, Trouble};
use slipmode_theory::root_location::RootStatement;
use value::{IMAGINARY, Kind, Mark, Value};

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
    let claims = read_claims("claims.toml", &read("claims.toml"), &procedures(), Some(&equations)).unwrap();
    let of_claim = |claim: ClaimEntry| {
        let parts = claim.stated.iter().flat_map(|stated| stated.parts()).map(|(_, formula)| formula);
        let outside = |formula: &ClaimFormula| Some(formula.limit.as_ref()?.outside.1.clone());
        let all = parts.flat_map(|formula| [Some(formula.clone()), outside(formula)]).flatten();
        let all = all.filter(|formula| formula.rows.is_none() && formula.computed().is_none());
        let stated = |formula: ClaimFormula| Stated {
            id: format!("{report} {}", claim.id),
            formula,
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
fn what_intervals_decide_exact_arithmetic_and_balls_decide_alike() {
    let mut counts = [0; 2];
    for Stated { id, formula, equations } in REPORTS.iter().flat_map(|report| of_report(report)) {
        let Some(Ok(claim)) = Claim::of(&formula, &equations) else { continue };
        let Says::True(said) = &claim.says else { continue };
        let mut sequence = Sequence::new();
        for base in (0..40).map(|turn| claim.point(turn, &mut sequence)) {
            for ask in [&|place: &mut AtPoint| said.truth(place), &|place: &mut AtPoint| claim.allows(place)]
                as [&dyn Fn(&mut AtPoint) -> number::Tried<bool>; 2]
            {
                let at = |bits: u32| claim.decided_at(&[bits], |bits| claim.place(&base, bits), ask);
                let near = at(evaluate::NEAR);
                if near.is_ok() {
                    assert_eq!(near, at(512), "{id}: {} at {}", formula.text, claim.text(&base));
                }
                counts[usize::from(near.is_err())] += 1;
            }
        }
    }
    let [decided, open] = counts;
    assert!(decided > open && open > 0, "{decided} decided, {open} open");
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
    let there_is = there_is.iter().map(|&name| name.parse().unwrap()).collect();
    outcome_over(text, given, Scope { there_is, ..Scope::default() }, verdict)
}

fn outcome_over(text: &str, given: &[&str], scope: Scope, verdict: &Finding) -> Outcome {
    let equations = read_equations("equations.toml", FILE.as_bytes()).unwrap();
    let names = Names::of(&equations);
    let given = given.iter().map(|text| FormulaCondition::read(text, &names).unwrap()).collect();
    let formula = ClaimFormula::read(text, Scope { given, ..scope }, &equations).unwrap();
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
        ("17*K != 31*M + 5", vec![]),
        ("x != 1237", vec!["x > 5"]),
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

/// Whether a formula is true at A = 1, B = 4, K = 2, M = 3, V = 9, x = -2, y = 0; none where that stays open.
fn is_true_there(text: &str) -> Option<bool> {
    let values = [("A", 1), ("B", 4), ("K", 2), ("M", 3), ("V", 9), ("x", -2), ("y", 0)];
    match outcome(text, &[], &[], &fails_at(&values)) {
        Outcome::Passed { .. } => Some(false),
        Outcome::Contradicted(words) if words.ends_with("it is true.") => Some(true),
        _ => None,
    }
}

#[test]
fn terms_have_their_values_at_a_point() {
    for (term, low) in [
        ("1 - sqrt(K)", -41422),
        ("sqrt(K) + sqrt(M)", 314_626),
        ("sqrt(K) - sqrt(M)", -31784),
        ("sqrt(K)/sqrt(M)", 81649),
        ("sqrt(K)*sqrt(M)", 244_948),
        ("-sqrt(K)*sqrt(M)", -244_949),
        ("exp(K) - exp(M)", -1_269_649),
        ("exp(K) + sqrt(K)", 880_326),
        ("exp(K)*exp(-M)", 36787),
        ("exp(K)/exp(M)", 36787),
        ("-exp(K)", -738_906),
        ("abs(exp(K) - exp(M))", 1_269_648),
        ("sqrt(exp(M))", 448_168),
        ("ln(K) - ln(M)", -40547),
        ("asinh(K)", 144_363),
        ("sin(K)", 90929),
        ("cos(K)", -41615),
        ("exp(x)^3", 247),
    ] {
        let between = format!("100000*({term}) > {low} and 100000*({term}) < {low} + 1");
        assert_eq!(is_true_there(&between), Some(true), "{term}");
    }
    for exact in [
        "sqrt(K)*sqrt(M) = sqrt(6)",
        "(-sqrt(K))*(-sqrt(M)) = sqrt(6)",
        "K/sqrt(K) = sqrt(K)",
        "sqrt(K) = sqrt(2)",
        "sqrt(V) = 3",
        "abs(x) = K",
        "abs(-sqrt(K)) = sqrt(K)",
        "y*exp(K) = 0",
        "y/exp(K) = 0",
        "exp(y) = A",
        "ln(A) = y",
        "asinh(y) + sin(y) = 0",
        "cos(y) = A",
        "x^3 = -8",
        "1/(K + x^2) = 1/6",
        "exp(K + 1/(2^64*2^64)) > exp(K)",
    ] {
        assert_eq!(is_true_there(exact), Some(true), "{exact}");
    }
}

#[test]
fn a_number_without_a_value_is_told_from_one_that_stays_open() {
    use slipmode_algebra::Function::{Exp, Ln, Sqrt};
    let call = |value: i32, function| Number::whole(value).call(function, 96);
    // e/e − 1, of which enclosures do not tell the sign.
    let one = call(1, Exp).unwrap().times(&call(-1, Exp).unwrap()).unwrap();
    let open = one.minus(&Number::whole(1)).unwrap();
    assert!(call(0, Sqrt).unwrap().is_exactly_zero() && open.sign().is_none());
    let root = call(2, Sqrt).unwrap();
    let product = root.times(&root.negated()).unwrap();
    assert!(matches!(&product, Number::Exact(value) if *value == -2), "{product:?}");
    for (found, trouble) in [
        (call(-1, Sqrt), Trouble::NoValue),
        (call(-1, Ln), Trouble::NoValue),
        (call(0, Ln), Trouble::NoValue),
        (Number::whole(1).over(&Number::whole(0)), Trouble::NoValue),
        (open.call(Sqrt, 96), Trouble::Open),
        (open.call(Ln, 96), Trouble::Open),
        (Number::whole(1).over(&open), Trouble::Open),
    ] {
        assert_eq!(found.unwrap_err(), trouble);
    }
}

#[test]
fn complex_numbers_and_derivatives_follow_their_rules() {
    use slipmode_algebra::Function::{Abs, Asinh, Cos, Exp, Ln, Sin, Sqrt};
    let is_zero = |value: Value| evaluate::is_zero(&value).ok();
    let [two, five] = [2, 5].map(Value::whole);
    let complex = |re: i32, im: i32| {
        let i = Value::with_quantity(Value::whole(0), IMAGINARY);
        Value::whole(re).plus(&i.times(&Value::whole(im)).unwrap()).unwrap()
    };
    for (found, wanted) in [
        (complex(2, 1).times(&complex(2, -1)), five.clone()),
        (complex(2, 1).power(2), complex(3, 4)),
        (complex(2, 1).power(3), complex(2, 11)),
        (five.over(&complex(2, 1)), complex(2, -1)),
        (complex(3, 4).over(&complex(2, 1)), complex(2, 1)),
        (complex(6, 4).over(&two), complex(3, 2)),
        (complex(2, 1).power(-1).and_then(|one| one.times(&five)), complex(2, -1)),
    ] {
        let found = found.unwrap();
        assert_eq!(is_zero(found.minus(&wanted).unwrap()), Some(true), "{found:?}");
        assert_eq!(is_zero(found.plus(&complex(0, 1)).unwrap().minus(&wanted).unwrap()), Some(false));
    }
    let mark = Mark { number: 1, kind: Kind::Small };
    let at = |above: i32, below: i32| {
        Value::with_quantity(Number::Exact(Rational::from((above, below))).into(), mark)
    };
    for (found, slope) in [
        (at(1, 2).call(Ln, 96), (2, 1)),
        (at(0, 1).call(Exp, 96), (1, 1)),
        (at(1, 4).call(Sqrt, 96), (1, 1)),
        (at(4, 1).call(Sqrt, 96), (1, 4)),
        (at(-3, 1).call(Abs, 96), (-1, 1)),
        (at(0, 1).call(Asinh, 96), (1, 1)),
        (at(3, 4).call(Asinh, 96), (4, 5)),
        (at(0, 1).call(Sin, 96), (1, 1)),
        (at(0, 1).call(Cos, 96), (0, 1)),
        (at(3, 1).power(3), (27, 1)),
        (at(3, 1).power(-1), (-1, 9)),
        (at(3, 1).over(&at(2, 1)), (-1, 4)),
        (at(3, 1).times(&at(2, 1)), (5, 1)),
        (at(3, 1).minus(&at(2, 1).times(&two).unwrap()), (-1, 1)),
        (at(3, 1).times(&complex(0, 1)).and_then(|one| one.over(&complex(0, 3))), (1, 3)),
    ] {
        let found = found.unwrap().coefficient(mark, 1);
        let wanted = Number::Exact(Rational::from(slope)).into();
        assert_eq!(is_zero(found.minus(&wanted).unwrap()), Some(true), "{found:?} is not {slope:?}");
    }
    // sin′(1) = cos(1) > 0, and cos′(1) = −sin(1) < 0.
    for (function, positive) in [(Sin, true), (Cos, false), (Exp, true)] {
        let slope = at(1, 1).call(function, 96).unwrap().coefficient(mark, 1).number().unwrap();
        assert_eq!(slope.sign(), Some(if positive { 1.cmp(&0) } else { 0.cmp(&1) }), "{function:?}");
    }
}

#[test]
fn one_false_part_decides_and_a_part_without_a_value_outweighs_an_open_one() {
    let (none, open) = (Err(Trouble::NoValue), Err(Trouble::Open));
    for (parts, found) in [
        (vec![], Ok(true)),
        (vec![Ok(true), Ok(true)], Ok(true)),
        (vec![open, none, Ok(false)], Ok(false)),
        (vec![open, none, Ok(true)], none),
        (vec![none, open], none),
        (vec![Ok(true), open, Ok(true)], open),
    ] {
        assert_eq!(number::all(parts.clone().into_iter()), found, "{parts:?}");
    }
}

/// The coefficients of a product of factors, by ascending power.
fn product(factors: &[Vec<Rational>]) -> Vec<Rational> {
    factors.iter().fold(vec![Rational::from(1)], |left, right| {
        let mut found = vec![Rational::new(); left.len() + right.len() - 1];
        for (at, one) in left.iter().enumerate() {
            for (by, two) in right.iter().enumerate() {
                found[at + by] += Rational::from(one * two);
            }
        }
        found
    })
}

#[test]
fn statements_on_roots_are_those_of_the_known_roots() {
    let near = || power_of_two(-70);
    let reals = [-2, -1, 0, 1, 3].map(Rational::from).into_iter();
    let reals: Vec<Rational> = reals.chain([near(), -near()]).collect();
    let pairs = [(-1, 1), (-1, 2), (0, 1), (0, 3), (2, 1), (1, 1), (-2, 5)];
    let pairs = pairs.map(|(re, im)| (Rational::from(re), im)).into_iter();
    let pairs: Vec<(Rational, i32)> = pairs.chain([(near(), 7), (-near(), 4)]).collect();
    let mut decided = 0;
    let mut sequence = Sequence::new();
    for turn in 0..200 {
        let mut pick = |list: usize| sequence.below(list as u32) as usize;
        let real: Vec<&Rational> = (0..turn % 4).map(|_| &reals[pick(reals.len())]).collect();
        let pair: Vec<&(Rational, i32)> = (0..turn / 4 % 3).map(|_| &pairs[pick(pairs.len())]).collect();
        let of_real = real.iter().map(|&root| vec![Rational::from(-root), Rational::from(1)]);
        let of_pair = pair.iter().map(|(re, im)| {
            let size = Rational::from(re.square_ref()) + im * im;
            vec![size, Rational::from(re * -2), Rational::from(1)]
        });
        let list = product(&of_real.chain(of_pair).collect::<Vec<_>>());
        let stable = real.iter().all(|root| **root < 0) && pair.iter().all(|(re, _)| *re < 0);
        let unstable = real.iter().any(|root| **root > 0) || pair.iter().any(|(re, _)| *re > 0);
        let on_axis = real.iter().any(|root| **root == 0) || pair.iter().any(|(re, _)| *re == 0);
        let exact: Vec<Number> = list.iter().cloned().map(Number::Exact).collect();
        let root = Number::Exact(Rational::from(2)).call(slipmode_algebra::Function::Sqrt, 96).unwrap();
        let enclosed: Vec<Number> = exact.iter().map(|one| one.times(&root).unwrap()).collect();
        for (statement, truth) in [
            (RootStatement::Stable, stable),
            (RootStatement::Unstable, unstable),
            (RootStatement::AllReal, pair.is_empty()),
        ] {
            assert_eq!(roots::is_true(statement, &exact), Some(truth), "{real:?} {pair:?} {statement:?}");
            let found = roots::is_true(statement, &enclosed);
            assert_ne!(found, Some(!truth), "{real:?} {pair:?} {statement:?}");
            decided += usize::from(found.is_some());
        }
        assert_eq!(roots::is_one_on_axis(&exact), Some(on_axis), "{real:?} {pair:?}");
        let found = roots::is_one_on_axis(&enclosed);
        assert_ne!(found, Some(!on_axis), "{real:?} {pair:?}");
        decided += usize::from(found.is_some());
    }
    // Every number is a root of the polynomial zero, and none of another constant.
    for (constant, is_stable) in [(0, false), (5, true)] {
        let list = [Number::whole(constant), Number::whole(0)];
        assert_eq!(roots::is_true(RootStatement::Stable, &list), Some(is_stable));
        assert_eq!(roots::is_true(RootStatement::Unstable, &list), Some(!is_stable));
    }
    // Enclosed coefficients leave repeated roots and those on the axis open.
    assert!(decided >= 570, "{decided}");
}

#[test]
fn limits_are_followed_to_their_ends() {
    for (text, is_true) in [
        ("K/(K + A) -> 1 as K -> infinity", true),
        ("K/(K + A) -> 0 as K -> 0", true),
        ("A*K -> infinity as K -> infinity", true),
        ("-A/K -> -infinity as K -> 0", true),
        ("K/(K + A) -> 2 as K -> infinity", false),
        ("K/(K + A) -> infinity as K -> infinity", false),
        ("A*K -> -infinity as K -> infinity", false),
        ("A*K -> 5 as K -> infinity", false),
        ("K -> infinity as K -> 0", false),
    ] {
        let holds = outcome(text, &[], &[], &planted_to_hold());
        let fails = outcome(text, &[], &[], &fails_at(&[("A", 1)]));
        let (right, wrong) = if is_true { (holds, fails) } else { (fails, holds) };
        assert!(matches!(right, Outcome::Passed { open: 0, points: 1.. }), "{text}: {right:?}");
        assert!(matches!(wrong, Outcome::Contradicted(_)), "{text}: {wrong:?}");
    }
    // It grows too slowly to be seen to.
    let slow = outcome("ln(K) -> infinity as K -> infinity", &[], &[], &planted_to_hold());
    assert!(matches!(slow, Outcome::Passed { open: 16, points: 16 }), "{slow:?}");
}

#[test]
fn a_slope_is_refuted_next_to_a_point_and_a_dependence_has_two_points_that_differ_in_one_value() {
    let falls = |x: i32| outcome("x^2 rises with x", &[], &[], &fails_at(&[("x", x)]));
    assert_eq!(falls(-3), Outcome::Passed { points: 1, open: 0 });
    assert!(matches!(falls(3), Outcome::Unconfirmed(_)));
    let depends = |one: [i32; 3], other: [i32; 3]| {
        let points = [one, other].map(|values| {
            let named = ["A", "K", "x"].iter().zip(values);
            named.map(|(name, value)| ((*name).to_owned(), Rational::from(value))).collect::<NamedPoint>()
        });
        outcome("K*x depends on K", &["K > A"], &[], &planted_to_hold().seen_at(points))
    };
    assert_eq!(depends([1, 2, 1], [1, 3, 1]), Outcome::Passed { points: 1, open: 0 });
    for (one, other) in [
        ([1, 2, 1], [2, 3, 1]),
        ([1, 2, 0], [1, 3, 0]),
        ([1, 1, 1], [1, 3, 1]),
        ([1, 3, 1], [1, 1, 1]),
        ([1, 2, 1], [1, 2, 1]),
    ] {
        let found = depends(one, other);
        assert!(matches!(found, Outcome::Contradicted(_)), "{one:?} {other:?}: {found:?}");
    }
}

#[test]
fn points_outside_the_conditions_confirm_nothing() {
    // An enclosure does not show that the condition is met.
    let open = outcome("K > A", &["exp(x)*exp(-x) >= 1"], &[], &fails_at(&[("K", 1), ("A", 1), ("x", 1)]));
    assert!(matches!(open, Outcome::Unconfirmed(_)), "{open:?}");
    let nowhere = |a: i32| fails_at(&[("A", a), ("B", 3), ("M", 7)]);
    let there_is = |a: i32| outcome("V^2 < A", &["V > B", "A > M"], &["V"], &nowhere(a));
    assert!(matches!(there_is(8), Outcome::Passed { .. }));
    assert!(matches!(there_is(6), Outcome::Contradicted(_)));
    let within = |text: &str, given: &[&str], verdict: &Finding| {
        let ends = [-1, 1].map(Rational::from);
        let scope = Scope { within: vec![("x".parse().unwrap(), ends)], ..Scope::default() };
        outcome_over(text, given, scope, verdict)
    };
    for (x, is_met) in [(-2, false), (-1, true), (1, true), (2, false)] {
        let found = within("x^2 > 4", &[], &fails_at(&[("x", x)]));
        assert_eq!(matches!(found, Outcome::Passed { .. }), is_met, "{x}: {found:?}");
    }
    // It falls from one range to the other, and rises within each of them.
    let ranges = within("x^3 - x/2 rises with x", &["x^2 >= 1/4"], &planted_to_hold());
    assert!(matches!(ranges, Outcome::Passed { points: 1.., .. }), "{ranges:?}");
    let unnamed = outcome("V^2 < A", &[], &["V"], &planted_to_hold());
    assert!(matches!(unnamed, Outcome::Unconfirmed(_)), "{unnamed:?}");
    let crosses = "pair_crosses(s^2 + (A - K)*s + B, s, K, A, sqrt(B))";
    for (given, is_met) in [(&["A > B"][..], true), (&["K > B", "A > B"], true), (&["K > B"], false)] {
        let found = outcome(crosses, given, &[], &planted_to_hold());
        assert_eq!(matches!(found, Outcome::Passed { points: 1.., .. }), is_met, "{given:?}: {found:?}");
    }
}
