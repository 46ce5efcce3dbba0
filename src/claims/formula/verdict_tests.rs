//! Verdicts on small formulas and claims with known truth.

use slipmode_theory::Equations;
use slipmode_theory::root_location::RootStatement;

use super::*;
use crate::claims::Verdict;
use crate::experiments::Outcome;
use crate::scene::{FormulaCondition, Scope, read_claims, read_equations};

/// Equations of a slider with a spring K and a mass M, and variables of either sign.
pub(super) const SMALL: &str = "[assumptions]\npositive = [\"A\", \"B\", \"K\", \"M\", \"V\"]\nfree = [\"x\", \"y\", \"s\"]\n\
    [[function]]\nname = \"f\"\n\
    [[equation]]\nnumber = \"1\"\nequation = \"w = sqrt(K/M)\"\n";

/// Decides a formula; what is said of its variables stands behind `|`: a condition, `there is V`, `V by A`, `x in 0 to 1`, `M at 2`.
pub(super) fn decided(line: &str) -> Finding {
    let equations = read_equations("equations.toml", SMALL.as_bytes()).unwrap();
    let names = Names::of(&equations);
    let mut parts = line.split('|').map(str::trim);
    let (text, mut scope) = (parts.next().unwrap(), Scope::default());
    for part in parts {
        if let Some(name) = part.strip_prefix("there is ") {
            scope.there_is.push(name.parse().unwrap());
        } else if let Some((name, value)) = part.split_once(" by ") {
            scope.witness.push((name.parse().unwrap(), value.parse().unwrap()));
        } else if let Some((name, ends)) = part.split_once(" in ") {
            let (low, high) = ends.split_once(" to ").unwrap();
            scope.within.push((name.parse().unwrap(), [low, high].map(|end| end.parse().unwrap())));
        } else if let Some((name, value)) = part.split_once(" at ") {
            scope.at.push((name.parse().unwrap(), value.parse().unwrap()));
        } else {
            scope.given.push(FormulaCondition::read(part, &names).unwrap());
        }
    }
    let read = ClaimFormula::read(text, scope, &equations).unwrap_or_else(|error| panic!("{line}: {error}"));
    let found = decide_equations("formula", "", &read, &equations);
    let tested = gate::tested(&read, &found, &equations);
    let is_sound = match found.verdict {
        Verdict::NotChecked => matches!(tested, gate::Outcome::NotEvaluated(_)),
        _ => matches!(tested, gate::Outcome::Passed { points: 1.., .. }),
    };
    assert!(is_sound, "{line}: {:?}, {tested:?}", found.verdict);
    found
}

/// The verdicts, whatever is said: the last gate finds nothing against them.
fn assert_verdicts(verdict: Verdict, lines: &[&str]) {
    for line in lines {
        let found = decided(line);
        assert_eq!(found.verdict, verdict, "{line}: {:?} {:?}", found.counter_example, found.remarks);
    }
}

#[test]
fn what_is_true_everywhere_holds() {
    let lines = [
        "K + A > A",
        "K*M >= 0",
        "K != -A",
        "x^2 + 1 > 0",
        "x^2 - 2*x*y + y^2 >= 0",
        "w^2*M = K",
        "K > A or K <= A",
        "K > A implies K >= A",
        "not [K < A] iff K >= A",
        "K > M implies K > A | M > A",
        "K^2 > A^2 | K > A",
        "K > B | K = A + B",
        "K > B | 2*K = 3*B",
        "x = y | x - y = 0",
        "K*x^2 + M*x + A > 0 | 4*K*A > M^2",
        "exp(K) > 1 + K",
        "x^2 >= 4 iff x >= 2 | x >= 0",
        "x != y or x*y >= 0",
        "stable(s^2 + A*s + B, s)",
        "stable(s^2 + (A - B)*s + K, s) iff A > B",
        "all_real(s^2 + 2*x*s + x^2 - A, s)",
        "pair_crosses(s^2 + (A - K)*s + B, s, K, A, sqrt(B))",
        "pair_crosses(s^2 + (A - K)*s + B, s, K, A, sqrt(B)) | K > B | A > B",
        "sqrt(K) > 7/5 | K at 2",
    ];
    assert_verdicts(Verdict::Holds, &lines);
}

#[test]
fn what_is_false_somewhere_fails_at_a_point_where_it_is_false() {
    let lines = [
        "K > A",
        "K = A",
        "K != A",
        "K >= A",
        "(x - 2)^2 > 0",
        "x > 0",
        "K > A and K > 0",
        "K > A implies K > B",
        "K > A iff K >= A",
        "K^2 > M | K > A",
        "x >= 2 | x^2 >= 4",
        "K > 2*B | K = A + B",
        "stable(s^2 + (A - B)*s + K, s)",
        "unstable(s^2 + (A - B)*s + K, s) iff A <= B",
        "pair_crosses(s^2 + (A - K)*s + B, s, K, 2*A, sqrt(B))",
        "pair_crosses(s^2 + (A - K)*s + B, s, K, A, B)",
        "pair_crosses(s^2 + (A - K)^2*s + B, s, K, A, sqrt(B))",
        // The critical value has to be positive, as K is.
        "pair_crosses(s^2 + (A + K)*s + B, s, K, -A, sqrt(B))",
        "sqrt(K) > 3/2 | K at 2",
        // No point that is tried first is on the other side of the condition.
        "x > -20000 | x != -20000",
    ];
    assert_verdicts(Verdict::Fails, &lines);
}

#[test]
fn conditions_that_contradict_each_other_decide_nothing() {
    assert_verdicts(
        Verdict::NotChecked,
        &["K > 0 | K > A | K < A", "K > B | x^2 < 0", "w rises with K | K > A | A > K"],
    );
}

#[test]
fn what_there_is_holds_with_a_value_and_fails_where_no_value_does() {
    let holds = [
        "x > 2 | there is x",
        "exp(x) > 2 | there is x",
        "V^2 < A | there is V | V by A/(1 + A)",
        "V > A and V < B | there is V | V by (A + B)/2 | A < B",
        "x + A = 0 | there is x | x by -A",
        "V^2 = 4 | there is V",
    ];
    let fails = [
        "x^2 < -1 | there is x",
        "V + A < 0 | there is V",
        "V > A and V < B | there is V",
        "V > 2 and V < 1 | there is V",
    ];
    assert_verdicts(Verdict::Holds, &holds);
    assert_verdicts(Verdict::Fails, &fails);
}

#[test]
fn boxes_are_decided_by_enclosures() {
    // The largest value of x/exp(x) is 0.36788, at x = 1.
    let holds = [
        "exp(x) < 3 | x in 0 to 1",
        "x*exp(-x) < 3679/10000 | x in 1/2 to 3",
        "x*exp(-x) > 1/7 | x in 1/4 to 3",
        "sin(x) + y < 5/2 | x in -1 to 1 | y in 0 to 3/2",
        "exp(x) > 1 or y > 1/2 | x in 1/8 to 1 | y in 0 to 1",
        "exp(x) > 2 | x in 0 to 1 | x > 7/10",
    ];
    let fails = [
        "exp(x) > 2 | x in 0 to 1",
        "x*exp(-x) < 1/4 | x in 0 to 4",
        // False between two points that are tried only, where enclosures of any size contain the edge.
        "x*exp(-x) < 367/1000 | x in 0 to 3",
        "x*exp(-x) <= 367/1000 | x in 0 to 3",
        "-x*exp(-x) + y >= -1/4 | x in 1/2 to 3 | y in 0 to 1",
        "exp(x) = 2 | x in 0 to 1",
    ];
    assert_verdicts(Verdict::Holds, &holds);
    assert_verdicts(Verdict::Fails, &fails);
}

#[test]
fn slopes_limits_and_dependences_have_their_verdicts() {
    let holds = [
        "w rises with K",
        "w falls with M",
        "x^3 rises with x",
        "x^2 rises with x | x > 0",
        "-x^2 rises with x | x < 0",
        "K*x rises with x",
        "w does not depend on A",
        "w depends on K",
        "A*x depends on x",
        "K*x depends on K | K > A",
        "K/(K + A) -> 1 as K -> infinity",
        "K/(K + A) -> 0 as K -> 0",
        "A*K -> infinity as K -> infinity",
        "-A/K -> -infinity as K -> 0",
    ];
    let fails = [
        "w falls with K",
        "w rises with M",
        "w rises with A",
        "x^2 rises with x",
        "(A - B)*x rises with x",
        "w does not depend on K",
        "K*x does not depend on K | K > A",
        "w depends on A",
        "K/(K + A) -> 0 as K -> infinity",
        "A*K -> -infinity as K -> infinity",
        "A*K -> 0 as K -> infinity",
        "A*K/(K + B) -> -A as K -> infinity",
        "A*K/(K + B) -> B as K -> infinity",
        "K/(K + A) -> infinity as K -> infinity",
    ];
    assert_verdicts(Verdict::Holds, &holds);
    assert_verdicts(Verdict::Fails, &fails);
}

#[test]
fn what_the_rules_do_not_decide_is_not_said_to_fail() {
    let lines = [
        "sin(K) -> 0 as K -> infinity",
        "K*sin(1/K) -> 0 as K -> 0",
        "(A - B)/K -> infinity as K -> 0",
        // A slope says nothing of two ranges that are apart.
        "-1/x rises with x | x != 0",
        // The conditions allow one x, from which it does not move.
        "A - x rises with x | x >= 1 | x <= 1",
        "A rises with x | x >= 1 | x <= 1",
        "x + sin(x) rises with x",
        "V^2 < A | there is V",
        // The function may be constant.
        "f(x) depends on x",
    ];
    assert_verdicts(Verdict::NotChecked, &lines);
    assert_verdicts(Verdict::Holds, &["-1/x rises with x | x > 0", "x^2 rises with x | x >= 1"]);
}

/// The divisor is positive in another form of the condition only, K = M + g.
#[test]
fn a_proof_has_the_steps_that_make_its_sides_have_a_value() {
    let found = decided("1/(K + A - M) < 1/A | K > M");
    let steps = &found.evidence[0].proof().unwrap().steps;
    let step = steps.iter().find(|step| step.says.starts_with("a side has a value: ")).unwrap();
    let Some(Certificate::Sign { domain, .. }) = &step.certificate else { panic!("{step:?}") };
    // What is shown is not assumed: no condition speaks of A.
    let named = domain.conditions().iter().flat_map(|condition| condition.expression.variables());
    assert!(named.into_iter().all(|name| name.as_str() != "A"), "{step:?}");
}

#[test]
fn a_predicate_rests_on_its_lemma_and_on_the_coefficients_of_its_polynomial() {
    let stable = RootStatement::Stable.lemma(2).unwrap().statement;
    for (line, lemma) in [
        ("stable(s^2 + A*s + B, s)", Some(stable)),
        ("pair_crosses(s^2 + (A - K)*s + B, s, K, A, sqrt(B))", None),
    ] {
        let found = decided(line);
        let proof = found.evidence[0].proof().unwrap();
        let begun: Vec<&String> = proof.steps.iter().flat_map(|step| &step.begins).collect();
        assert!(!begun.is_empty() && lemma.is_none_or(|lemma| begun.contains(&&lemma)), "{proof}");
        assert!(proof.steps.iter().any(|step| step.says.starts_with("the coefficients of ")), "{proof}");
    }
}

/// The claim `C1` on the equations `SMALL`, from its formulas.
fn claim(formulas: &str, equations: &Equations) -> ClaimEntry {
    let start = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\n\
        leaves_out = \"nothing\"\n";
    let mut read = read_claims(
        "claims.toml",
        format!("{start}{formulas}").as_bytes(),
        &crate::claims::procedures(),
        Some(equations),
    );
    read.as_mut().unwrap_or_else(|faults| panic!("{formulas}: {faults:?}")).remove(0)
}

#[test]
fn a_claim_is_decided_by_its_parts_its_readings_and_its_limit_and_each_proof_has_an_id() {
    let equations = read_equations("equations.toml", SMALL.as_bytes()).unwrap();
    let limited = |inside: &str, outside: &str| {
        format!(
            "formula = \"{inside}\"\nlimit = \"l\"\noutside = {{ words = \"o\", formula = \"{outside}\" }}"
        )
    };
    let of_parts = |kind: &str, parts: &[&str]| -> String {
        parts.iter().map(|one| format!("[[{kind}]]\nwords = \"w\"\nformula = \"{one}\"\n")).collect()
    };
    let parts = |parts: &[&str]| of_parts("claim.part", parts);
    let reading = |parts: &[&str]| {
        format!("[[claim.reading]]\nwords = \"r\"\n{}", of_parts("claim.reading.part", parts))
    };
    let [rises, falls, wrong] = ["w rises with K", "w falls with M", "w falls with K"];
    for (formulas, verdict, ids) in [
        (limited(rises, falls), Verdict::HoldsWithin, &["formula-c1", "formula-c1-outside"][..]),
        (limited(rises, wrong), Verdict::NotChecked, &[]),
        (limited(wrong, falls), Verdict::Fails, &[]),
        (parts(&[rises, falls]), Verdict::Holds, &["formula-c1-1", "formula-c1-2"]),
        (parts(&[rises, wrong]), Verdict::Fails, &["formula-c1-1"]),
        (
            reading(&[rises]) + &reading(&[wrong, falls]),
            Verdict::Holds,
            &["formula-c1-1-1", "formula-c1-2-2"],
        ),
    ] {
        let claim = claim(&formulas, &equations);
        let outcome = Outcome { scenes: Vec::new() };
        let found = decide("C1", claim.stated.as_ref().unwrap(), &Context::new(&equations, &outcome));
        assert_eq!(found.verdict, verdict, "{formulas}: {found:?}");
        let proofs: Vec<&Proof> = found.evidence.iter().filter_map(Evidence::proof).collect();
        assert_eq!(proofs.iter().map(|proof| proof.id.as_str()).collect::<Vec<_>>(), ids, "{formulas}");
        let proof = |id: &str| proofs.iter().copied().find(|proof| proof.id == id);
        let theorems = whole_theorems(&claim, &equations, proof);
        assert_eq!(theorems.iter().map(|(id, _)| id.as_str()).collect::<Vec<_>>(), ids, "{formulas}");
    }
}

#[test]
fn the_criterion_of_a_claim_is_its_formulas_with_what_they_are_said_over() {
    let equations = read_equations("equations.toml", SMALL.as_bytes()).unwrap();
    let formulas = "[[claim.reading]]\nwords = \"r\"\n\
        [[claim.reading.part]]\nwords = \"w\"\nformula = \"exp(x) > A\"\ngiven = [\"A < 3\"]\n\
        box = { x = [2, 3] }\nat = { M = 1 }\n[[claim.reading.part]]\nwords = \"w\"\nformula = \"x > A\"\n\
        there_is = [\"x\"]\n[[claim.reading]]\nwords = \"s\"\n\
        [[claim.reading.part]]\nwords = \"w\"\nformula = \"K + A > A\"\n";
    assert_eq!(
        criterion(claim(formulas, &equations).stated.as_ref().unwrap()),
        "exp(x) > A for all A < 3, 2 <= x <= 3, M = 1; and there is x with x > A; or, read otherwise, K + A > A."
    );
}
