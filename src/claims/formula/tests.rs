//! Random formulas, decided and compared with their truth at points; formulas and equations as theorems.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::coq::Theorem;
use slipmode_algebra::{Domain, Expression};
use slipmode_theory::Equations;

use super::verdict_tests::{SMALL, decided};
use super::*;
use crate::claims::{Strength, Verdict};
use crate::scene::{FormulaCondition, Scope, read_claims, read_equations};

const EQUATIONS: &[u8] = include_bytes!("../../../reports/im-avouac/equations.toml");

/// A comparison, and its truth for K, M and V in halves.
type Atom = (&'static str, fn([i64; 3]) -> bool);

const ATOMS: [Atom; 10] = [
    ("K > M", |[k, m, _]| k > m),
    ("K >= M", |[k, m, _]| k >= m),
    ("K = M", |[k, m, _]| k == m),
    ("K != V", |[k, _, v]| k != v),
    ("M <= V", |[_, m, v]| m <= v),
    ("K + M > V", |[k, m, v]| k + m > v),
    ("K*M >= V^2", |[k, m, v]| k * m >= v * v),
    ("2*K < M", |[k, m, _]| 2 * k < m),
    ("K - V < 1", |[k, _, v]| k - v < 2),
    ("stable(z^2 + (K - M)*z + V, z)", |[k, m, _]| k > m),
];

/// A formula in words with its truth.
type Random = (String, Box<dyn Fn([i64; 3]) -> bool>);

/// A random formula, from a sequence of numbers.
fn formula(next: &mut impl FnMut(usize) -> usize, depth: u32) -> Random {
    if depth == 0 || next(5) == 0 {
        let (text, truth) = ATOMS[next(ATOMS.len())];
        return (text.to_owned(), Box::new(truth));
    }
    let (one, truth) = formula(next, depth - 1);
    if next(5) == 0 {
        return (format!("not [{one}]"), Box::new(move |point| !truth(point)));
    }
    let (other, second) = formula(next, depth - 1);
    let (word, join): (_, fn(bool, bool) -> bool) = [
        ("and", (|a, b| a && b) as fn(bool, bool) -> bool),
        ("or", |a, b| a || b),
        ("implies", |a, b| !a || b),
        ("iff", |a, b| a == b),
    ][next(4)];
    (format!("[{one}] {word} [{other}]"), Box::new(move |point| join(truth(point), second(point))))
}

/// The value of a name in halves in `at K = 1/2, M = 3: …`, if it is a whole number of them.
fn halves(example: &str, name: &str) -> Option<i64> {
    let list = example.strip_prefix("at ").unwrap().split(": ").next().unwrap();
    let value = list.split(", ").find_map(|pair| pair.strip_prefix(&format!("{name} = ")));
    let value: slipmode_core::number::Rational = value.unwrap_or("1").parse().unwrap();
    let doubled: slipmode_core::number::Rational = value * 2;
    doubled.is_integer().then(|| doubled.numer().to_i64())?
}

#[test]
fn no_random_formula_holds_that_a_point_refutes_and_every_counter_example_is_one() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let mut state = 7_u64;
    let mut next = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 40).unwrap() % below
    };
    let values = [1, 2, 3, 4, 6];
    let points: Vec<[i64; 3]> =
        (0..125).map(|index| [values[index / 25], values[index / 5 % 5], values[index % 5]]).collect();
    let (mut held, mut failed, mut open) = (0, 0, 0);
    for turn in 0..200 {
        // Most are false; of several one is true more often.
        let several: Vec<Random> =
            (0..=turn % 2 * 4).map(|_| formula(&mut next, 3 - turn as u32 % 2)).collect();
        let text = several.iter().map(|(text, _)| format!("[{text}]")).collect::<Vec<_>>().join(" or ");
        let truth = |point| several.iter().any(|(_, truth)| truth(point));
        // Some are true by construction, and refused.
        let Ok(read) = ClaimFormula::read(&text, Scope::default(), &equations) else { continue };
        let found = decide_equations("formula", "", &read, &equations);
        match found.verdict {
            Verdict::Holds => {
                held += 1;
                let refuting = points.iter().find(|point| !truth(**point));
                assert_eq!(refuting, None, "{text} is said to hold");
            }
            Verdict::Fails => {
                failed += 1;
                let example = found.counter_example.unwrap();
                let point = ["K", "M", "V"].map(|name| halves(&example, name));
                if let [Some(k), Some(m), Some(v)] = point {
                    assert!(!truth([k, m, v]), "{text}: {example}");
                }
            }
            _ => open += 1,
        }
    }
    assert!(held >= 10 && failed >= 60 && open <= 20, "{held} held, {failed} failed, {open} open");
}

/// Its conditions of Hurwitz have long coefficients, of which squares were sought for 40 s.
#[test]
fn a_search_without_a_result_ends_within_its_steps() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let text = "[not stable((z^2 + K*z + M)*(z^2 + V*z + a)*(z + b), z)] implies K*K + 1 = 0";
    let read = ClaimFormula::read(text, Scope::default(), &equations).unwrap();
    let found = within_budget(STEPS / 4, || decide_equations("f", "", &read, &equations)).unwrap();
    assert_eq!(found.verdict, Verdict::NotChecked);
    assert!(found.remarks[0].contains("no proof was found"), "{:?}", found.remarks);
    assert!(found.remarks[0].chars().count() <= 300, "{:?}", found.remarks);
}

#[test]
fn what_is_not_decided_says_what_was_tried_and_what_may_help() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let remark = |text: &str| {
        let read = ClaimFormula::read(text, Scope::default(), &equations).unwrap();
        let found = decide_equations("f", "", &read, &equations);
        assert_eq!(found.verdict, Verdict::NotChecked, "{text}");
        assert!(found.remarks[0].chars().count() <= 300, "{:?}", found.remarks);
        found.remarks[0].clone()
    };
    // The mean of three positive numbers is at least their geometric mean, and the difference is no sum of squares.
    let plain = remark("K^4*M^2 + K^2*M^4 + V^3 >= 3*K^2*M^2*V");
    assert_eq!(
        plain,
        "Not decided: no proof was found, and no counter-example among 4096 points. Tried: signs of terms, sums of squares, \
         conditions solved for variables. What may help: a further condition in `given`."
    );
    let with_root = remark("K^4*M^2 + K^2*M^4 + sqrt(V)^3 >= 3*K^2*M^2*sqrt(V) and K + M > 0");
    assert!(
        with_root
            .ends_with("; one part for each clause; a parameter r for a root, with r^2 = ... in `given`."),
        "{with_root}"
    );
}

/// The theorem of the last step of the proof of a formula, without its proof.
fn stated(text: &str, equations: &Equations) -> String {
    let read = ClaimFormula::read(text, Scope::default(), equations).unwrap();
    let found = decide_equations("formula", "", &read, equations);
    let steps = &found.evidence[0].proof().unwrap().steps;
    let theorem = Theorem::of(steps.last().unwrap().certificate.as_ref().unwrap()).unwrap();
    theorem.text.rsplit_once("Theorem ").unwrap().1.split_once("Proof.").unwrap().0.to_owned()
}

#[test]
fn a_theorem_changes_with_the_claims_formula_and_with_the_equation_that_it_names() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let altered = equations.altered("9", "K_c = 7*(b - a)*sigma/D_c").unwrap();
    let text = stated("K_c*D_c/sigma + b = b + right_9*D_c/sigma", &equations);
    assert!(text.contains("(b - a) * sigma) / D_c") && text.contains("(M * (V_0 ^ 2))"), "{text}");
    let of_equation = stated("K_c*D_c/sigma + b = b + right_9*D_c/sigma", &altered);
    assert!(of_equation.contains("7 * (b - a) * sigma") && !of_equation.contains("V_0"), "{of_equation}");
    let of_formula = stated("5*K_c*D_c/sigma + b = b + 5*right_9*D_c/sigma", &equations);
    assert!(of_formula.contains("(5 * ") && !text.contains("(5 * "), "{of_formula}");
}

/// A row of `proofs/equations.csv`: what a definition in a hand-written file states.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Stated {
    file: String,
    name: String,
    report: String,
    equation: String,
    side: String,
    power: String,
}

/// A file of the repository.
fn file_of_repository(path: &str) -> String {
    std::fs::read_to_string(format!("{}/{path}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn stated_by_hand() -> Vec<Stated> {
    let row = |line: &str| {
        let [file, name, report, equation, side, power] =
            line.split(',').map(str::to_owned).collect::<Vec<_>>().try_into().unwrap();
        Stated { file, name, report, equation, side, power }
    };
    file_of_repository("proofs/equations.csv").lines().skip(1).map(row).collect()
}

/// The definitions of a hand-written file by name. It has D, V and v for Im & Avouac's D_c, V_0 and V.
fn definitions(file: &str) -> Vec<(String, String)> {
    let coq = file_of_repository(&format!("proofs/{file}.v"));
    let lines =
        coq.lines().filter_map(|line| line.strip_prefix("Let ")?.strip_suffix('.')?.split_once(" := "));
    let name = |head: &str| head.split_whitespace().next().unwrap().to_owned();
    lines.map(|(head, text)| (name(head), text.replace("Rabs", "abs"))).collect()
}

#[test]
fn the_hand_written_theorems_state_the_equations_of_the_reports() {
    let rows = stated_by_hand();
    let reports: BTreeMap<&str, Equations> = rows
        .iter()
        .map(|row| row.report.as_str())
        .collect::<BTreeSet<_>>()
        .into_iter()
        .map(|report| {
            let text = file_of_repository(&format!("reports/{report}/equations.toml"));
            (report, read_equations("equations.toml", text.as_bytes()).unwrap())
        })
        .collect();
    let stated = |row: &Stated| -> Expression {
        let found: Vec<_> =
            definitions(&row.file).into_iter().filter(|(name, _)| *name == row.name).collect();
        let [(_, text)] = &found[..] else { panic!("{row:?}: {found:?}") };
        let parsed: Expression = text.parse().unwrap_or_else(|_| panic!("{row:?}: {text}"));
        if row.report != "im-avouac" {
            return parsed;
        }
        let paper = [("D", "D_c"), ("V", "V_0"), ("v", "V")];
        paper.iter().fold(parsed, |text, (own, name)| text.with(*own, &Expression::variable(*name)))
    };
    // The terms of a polynomial in s are one expression.
    let mut sides: BTreeMap<[&str; 5], Vec<Expression>> = BTreeMap::new();
    for row in &rows {
        let (own, factor) = match row.power.as_str() {
            "-" => (row.name.as_str(), "1".to_owned()),
            "0" => ("", "1".to_owned()),
            power => ("", format!("s^{power}")),
        };
        let key = [&row.file, &row.report, &row.equation, &row.side, own];
        sides.entry(key).or_default().push(match factor.as_str() {
            "1" => stated(row),
            factor => stated(row) * factor.parse().unwrap(),
        });
    }
    for (key, mut terms) in sides {
        let [_, report, equation, side, _] = key;
        let domain = Domain::of_positive(reports[report].names().positive().iter().cloned());
        let is_same = |left: &Expression, right: &Expression| {
            left == right
                || domain.rational_function(&(left.clone() - right.clone())).is_ok_and(|zero| zero.is_zero())
        };
        let equation = reports[report].equation(equation);
        let written = if side == "left" { &equation.left } else { &equation.right };
        let stated = if terms.len() == 1 { terms.remove(0) } else { Expression::Sum(terms) };
        assert!(is_same(&stated, written), "{key:?}: {stated} is not {written}");
        assert!(!is_same(&(stated.clone() + stated), written), "{key:?}: anything passes");
    }
    // A name of the table that a file defines without a row would escape the comparison.
    let names: BTreeSet<&str> = rows.iter().map(|row| row.name.as_str()).collect();
    for file in rows.iter().map(|row| &row.file).collect::<BTreeSet<_>>() {
        for (name, _) in definitions(file).iter().filter(|(name, _)| names.contains(name.as_str())) {
            assert!(
                rows.iter().any(|row| row.file == *file && row.name == *name),
                "{file}: {name} has no row"
            );
        }
    }
}

/// A claim's formula as a whole theorem from the proof that decides it.
fn whole(text: &str, given: &[&str], equations: &Equations) -> Result<WholeTheorem, String> {
    let names = Names::of(equations);
    let given = given.iter().map(|text| FormulaCondition::read(text, &names).unwrap()).collect();
    let read = ClaimFormula::read(text, Scope { given, ..Scope::default() }, equations).unwrap();
    let found = decide_equations("formula", "", &read, equations);
    theorem::whole_theorem(&read, equations, found.evidence[0].proof().unwrap())
}

#[test]
fn a_whole_theorem_states_the_formula_with_its_conditions_and_rests_on_steps_of_its_proof() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let made = whole("right_3 = 0", &["theta = theta_ss"], &equations).unwrap();
    assert!(made.statement.contains("(given'1 : theta = (D_c / V))"), "{}", made.statement);
    assert!(made.statement.contains("(theta'pos : 0 < theta)"), "{}", made.statement);
    assert!(made.statement.ends_with(" = 0") && made.altered.ends_with(" = 0)"), "{}", made.altered);
    assert!(made.altered.contains(" :\n  ~ ("), "{}", made.altered);
    assert!(made.steps.iter().any(|step| made.proof.contains(&format!("({} ", step.name))), "{}", made.proof);
    let both = whole("right_2 = 0 and right_3 = 0", &["theta = theta_ss"], &equations).unwrap();
    assert!(both.statement.contains(" = 0 /\\ ") && both.name != made.name, "{}", both.statement);
    let fixed = whole("K_c -> K_c_qs as M -> 0", &[], &equations).unwrap();
    assert!(fixed.statement.contains("filterlim (fun M : R => ") && !fixed.statement.contains("M'pos"));
    let slope = whole("K_c falls with D_c", &["a < b"], &equations).unwrap();
    assert!(slope.statement.contains("forall p'0 p'1 : R, 0 < p'0 -> p'0 < p'1 -> "));
    assert!(slope.proof.contains("apply (falls "), "{}", slope.proof);
    // The value at the larger one of two values is the smaller one.
    let order =
        |statement: &str| statement.rsplit(" -> ").next().unwrap().split(" < ").next().unwrap().to_owned();
    assert!(order(&slope.statement).contains("p'1") && order(&slope.altered).contains("p'0"));
    let small = read_equations("equations.toml", SMALL.as_bytes()).unwrap();
    let solved = whole("x*K = A*K", &["x = A"], &small).unwrap();
    assert!(
        solved.statement.contains("A'pos") && !solved.statement.contains("x'pos"),
        "{}",
        solved.statement
    );
    let same = whole("K_c - K_c_dyn does not depend on V_0", &[], &equations).unwrap();
    assert!(same.altered.ends_with(" + 1"), "{}", same.altered);
    let depends = whole("K_c_qs depends on sigma", &[], &equations).unwrap();
    assert!(
        depends.statement.contains("exists p'0 D_c a b sigma : R, 0 < D_c /\\ "),
        "{}",
        depends.statement
    );
    assert!(depends.statement.contains(" <> ") && !depends.altered.contains(" <> "), "{}", depends.altered);
    for same in ["K_c_qs does not depend on M", "K_c = right_9", "K_c > 0 and K_c_qs <= right_10"] {
        let given = if same.contains('>') { vec!["a < b"] } else { Vec::new() };
        let obstacle = whole(same, &given, &equations).unwrap_err();
        assert!(obstacle.contains("a definition, and no theorem"), "{same}: {obstacle}");
    }
    let crossing = "pair_crosses(left_8, s, K, K_c, sqrt((b - a)/a)*V_0/D_c)";
    let obstacle = whole(crossing, &["a < b"], &equations).unwrap_err();
    assert!(obstacle.contains("crosses the axis"), "{obstacle}");
}

/// The parts of a whole statement: its variables and hypotheses, and what follows.
fn split(made: &WholeTheorem) -> (&str, &str) {
    made.statement.split_once(" :\n  ").unwrap()
}

#[test]
fn a_whole_theorem_on_roots_names_their_polynomial_and_keeps_how_the_formula_is_joined() {
    let small: Equations = read_equations("equations.toml", SMALL.as_bytes()).unwrap();
    let made = whole("stable(s^2 + 2*s + x, s) iff x > 0", &[], &small).unwrap();
    let says =
        "(forall s : R, ((s ^ 2) + (2 * s) + x) = horner [x; 2; 1] s) /\\ (all_left [x; 2; 1] <-> 0 < x)";
    assert_eq!(split(&made), (" (x : R)", says));
    assert_eq!(made.altered, made.statement.replace("(all_left", "~ (all_left"));
    assert!(made.proof.contains("by_signs") && made.proof.contains("by_cases"), "{}", made.proof);
    for (text, joined) in [
        ("not unstable(s + A, s)", "(~ (one_right [A; 1]))"),
        ("all_real(s^2 - A, s) or x > y", "(all_real [(- A); 0; 1] \\/ y < x)"),
        ("x > 1 implies [x > 0 and x != 0]", "1 < x -> (0 < x /\\ x <> 0)"),
    ] {
        let made = whole(text, &[], &small).unwrap();
        assert!(made.statement.ends_with(joined), "{text}: {}", made.statement);
    }
    let far = whole("not unstable(s^5 + A*s^4, s)", &[], &small).unwrap_err();
    assert!(far.contains("of degree 5"), "{far}");
    let bound = whole("not unstable(s + A, s)", &["s > 0"], &small).unwrap_err();
    assert!(bound.contains("a condition contains s"), "{bound}");
}

#[test]
fn the_theorem_of_a_formula_that_fails_is_its_negation_and_that_of_one_with_a_witness_says_that_there_is_one()
{
    let small: Equations = read_equations("equations.toml", SMALL.as_bytes()).unwrap();
    let names = Names::of(&small);
    let false_one = whole("stable(s^2 + x*s + A, s)", &["x > -2"], &small).unwrap();
    let (variables, says) = split(&false_one);
    assert_eq!(variables, "");
    assert!(says.starts_with("exists A x : R, 0 < A /\\ (-2) < x /\\ (forall s : R, "), "{says}");
    assert!(says.ends_with(" /\\ ~ (all_left [A; x; 1])"), "{says}");
    assert!(false_one.altered.ends_with(" /\\ (all_left [A; x; 1])"), "{}", false_one.altered);
    assert!(false_one.proof.starts_with("exists ") && false_one.steps.len() < 3, "{}", false_one.proof);

    let scope = Scope {
        there_is: vec!["x".into()],
        witness: vec![("x".into(), "2*A".parse().unwrap())],
        given: vec![FormulaCondition::read("x < 3*A", &names).unwrap()],
        ..Scope::default()
    };
    let read = ClaimFormula::read("x > A", scope, &small).unwrap();
    let found = decide_equations("formula", "", &read, &small);
    let made = theorem::whole_theorem(&read, &small, found.evidence[0].proof().unwrap()).unwrap();
    let says = "exists x : R, x < (3 * A) /\\ A < x";
    assert_eq!(split(&made), (" (A : R) (A'pos : 0 < A)", says));
    assert!(made.proof.starts_with("exists (2 * A); "), "{}", made.proof);
}

#[test]
fn the_formula_and_the_equations_that_the_ledger_evaluates_are_those_of_the_whole_theorem() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let altered = equations.altered("9", "K_c = 7*(b - a)*sigma/D_c").unwrap();
    let [text, other] = ["K_c*D_c + b = b + right_9*D_c", "5*K_c*D_c + b = b + 5*right_9*D_c"];
    let own = whole(text, &[], &equations).unwrap();
    let of_equation = whole(text, &[], &altered).unwrap();
    let of_formula = whole(other, &[], &equations).unwrap();
    assert!(of_equation.statement.contains("7 * (b - a)") && !own.statement.contains("7 * (b - a)"));
    assert!(of_formula.statement.contains("(5 * ") && !own.statement.contains("(5 * "));
    let digests = [&own, &of_equation, &of_formula].map(|made| made.digest.clone());
    assert!(digests[0] != digests[1] && digests[0] != digests[2] && digests[1] != digests[2]);
}

#[test]
fn a_verdict_is_kernel_checked_when_the_list_of_accepted_theorems_has_its_whole_statement() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let read = ClaimFormula::read("K_c = K_c_qs + K_c_dyn", Scope::default(), &equations).unwrap();
    let made = whole("K_c = K_c_qs + K_c_dyn", &[], &equations).unwrap();
    let found =
        || Finding { strength: Some(Strength::Exact), ..decide_equations("f", "", &read, &equations) };
    let listed = |line: &str| {
        let list = theorem::accepted(line);
        let accepted = theorem::accepted_in(&list, &read, &equations, false);
        found().with_theorem(|_| accepted.map(|(name, _)| name))
    };
    let accepted = listed(&format!("identity_1 00ff\n{} {}\n", made.name, made.digest));
    assert_eq!(accepted.strength, Some(Strength::KernelChecked));
    assert!(!accepted.is_overstated());
    assert_eq!(accepted.evidence[0].proof().unwrap().theorem.as_ref(), Some(&made.name));
    // Accepted steps alone, and another statement, make no verdict kernel-checked.
    for line in [format!("identity_1 {}\n", made.digest), format!("{} 00ff\n", made.name)] {
        assert_eq!(listed(&line).strength, Some(Strength::Exact), "{line}");
    }
    let failing = Finding::failing("no").with_theorem(|_| Some(made.name.clone()));
    assert_eq!(failing.strength, Some(Strength::Exact));
}

#[test]
fn the_accepted_formulas_of_the_first_report_are_kernel_checked_and_others_are_not() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let claims = include_bytes!("../../../reports/im-avouac/claims.toml");
    let claims = read_claims("claims.toml", claims, &crate::claims::procedures(), Some(&equations)).unwrap();
    let stated = || claims.iter().filter_map(|claim| claim.stated.as_ref());
    let accepted: Vec<WholeStatement<'_>> =
        stated().flat_map(|stated| whole_statements(stated, &equations)).collect();
    let [first, .., last] = &accepted[..] else { panic!("{accepted:?}") };
    for whole in [first, last] {
        let found = decide_equations("f", "", whole.formula, &equations);
        assert_eq!(found.strength, Some(Strength::KernelChecked), "{}", whole.formula.text);
        assert!(found.evidence.iter().any(|one| one.proof().unwrap().theorem.as_ref() == Some(&whole.name)));
    }
    assert_ne!(decided("K + A > A").strength, Some(Strength::KernelChecked));
}

#[test]
fn the_digest_of_a_theorem_is_that_of_its_statement() {
    let theorem = |proof: &str| Theorem {
        name: "same".into(),
        variables: vec!["x".into()],
        lemmas: Vec::new(),
        text: format!("Theorem same (x : R) :\n  x = x.\nProof. {proof} Qed.\n"),
        fault: String::new(),
    };
    for proof in ["ring.", "reflexivity."] {
        assert_eq!(statement_digest(&theorem(proof)), crate::claims::sha256_hex(" (x : R) :\n  x = x"));
    }
}
