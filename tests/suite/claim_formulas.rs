//! Claims stated as formulas in `claims.toml`: each kind of statement, true, false, out of reach, and at fault.

use std::collections::BTreeMap;

use rug::Rational;

use crate::harness::Workplace;

const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

/// A formula, over what it is said, the verdict, and for a false one a test of the point that the counter-example names.
type Row = (&'static str, &'static str, &'static str, Option<fn(&Point) -> bool>);

/// The values that a counter-example names, and 1 for every other quantity.
struct Point(BTreeMap<String, Rational>);

impl Point {
    /// `at a = 1, b = 4: …` up to the colon.
    fn read(counter_example: &str) -> Self {
        let (list, _) = counter_example.strip_prefix("at ").unwrap().split_once(": ").unwrap();
        let pairs = list.split(", ").map(|pair| pair.split_once(" = ").unwrap());
        Self(pairs.map(|(name, text)| (name.to_owned(), text.parse().unwrap())).collect())
    }

    fn of(&self, name: &str) -> Rational {
        self.0.get(name).cloned().unwrap_or_else(|| Rational::from(1))
    }

    fn values<const COUNT: usize>(&self, names: [&str; COUNT]) -> [Rational; COUNT] {
        names.map(|name| self.of(name))
    }

    /// Eq 10 and eq 11, typed here on their own.
    fn stiffnesses(&self) -> [Rational; 2] {
        let [a, b, d, m, s, v] = self.values(["a", "b", "D_c", "M", "sigma", "V_0"]);
        let gap = b - &a;
        [gap.clone() * s / &d, gap / a * m * v.clone() * v / (d.clone() * d)]
    }

    fn critical(&self) -> Rational {
        let [quasi_static, dynamic] = self.stiffnesses();
        quasi_static + dynamic
    }

    fn weakening(&self) -> bool {
        self.of("a") < self.of("b")
    }
}

const WEAKENING: &str = "given = ['a < b']";

const ROWS: &[Row] = &[
    ("K_c_qs + K_c_dyn = K_c", "", "holds", None),
    ("K_c = K_c_qs", "", "fails", Some(|point| point.stiffnesses()[1] != 0)),
    ("K_c > K_c_qs", WEAKENING, "holds", None),
    ("K_c > K_c_qs", "", "fails", Some(|point| point.stiffnesses()[1] <= 0)),
    // In cases by the signs of what has an absolute value; false ones differ from true ones in a sign or an edge.
    ("abs(a - b) >= a - b", "", "holds", None),
    ("abs(a - b) > a - b", "", "fails", Some(|point| point.of("a") >= point.of("b"))),
    ("abs(a - b) <= a + b", "", "holds", None),
    ("a >= b or abs(a - b) = b - a", "", "holds", None),
    ("a >= b or abs(a - b) = a - b", "", "fails", Some(Point::weakening)),
    ("abs((a - b)*(K - M)) = abs(a - b)*abs(K - M)", "", "holds", None),
    (
        "abs((a - b)*(K - M)) = (a - b)*abs(K - M)",
        "",
        "fails",
        Some(|point| point.weakening() && point.of("K") != point.of("M")),
    ),
    ("abs(a - b + K - M) <= abs(a - b) + abs(K - M)", "", "holds", None),
    (
        "abs(a - b + K - M) < abs(a - b) + abs(K - M)",
        "",
        "fails",
        Some(|point| (point.of("a") - point.of("b")) * (point.of("K") - point.of("M")) >= 0),
    ),
    ("a + b + abs(a - b) >= 2*a", "", "holds", None),
    // False on the edge a = b only.
    ("K_c != 0", "", "fails", Some(|point| point.of("a") == point.of("b"))),
    ("K_c -> K_c_qs as V_0 -> 0", "", "holds", None),
    ("K_c -> 2*K_c_qs as V_0 -> 0", "", "fails", Some(|point| point.stiffnesses()[0] != 0)),
    ("K_c -> K_c_qs as V_0 -> infinity", "", "not-checked", None),
    ("K_c rises with V_0", WEAKENING, "holds", None),
    ("K_c falls with V_0", WEAKENING, "fails", Some(Point::weakening)),
    ("omega_n rises with D_c", "", "fails", None),
    ("K_c depends on D_c", "", "holds", None),
    ("omega_n depends on D_c", "", "fails", None),
    ("omega_n does not depend on D_c", "", "holds", None),
    ("K_c does not depend on M", WEAKENING, "fails", Some(Point::weakening)),
    // Vacuous: nothing meets both conditions.
    ("K_c > 0", "given = ['a < b', 'b < a']", "not-checked", None),
    ("K^2 + M^2 > K*M", "", "holds", None),
    ("K^2 + M^2 > 2*K*M", "", "fails", Some(|point| point.of("K") == point.of("M"))),
    ("K^2 + M^2 >= 2*K*M", "", "holds", None),
    ("right_15*right_16 = sigma_c^2", WEAKENING, "holds", None),
    ("right_15 > right_16", WEAKENING, "holds", None),
    ("V_c -> 0 as D_c -> 0", "given = ['b > a']", "holds", None),
    ("right_steady_friction falls with V", WEAKENING, "holds", None),
    // A positive slope on both sides of a pole is no rise across it.
    ("-1/(a - b) rises with a", "given = ['a != b']", "not-checked", None),
    // Conditions that leave a line: a limit is compared on it, and a variable that cannot move alone refutes no rise.
    ("K_c -> K as V_0 -> 0", "given = ['K >= K_c_qs', 'K <= K_c_qs']", "not-checked", None),
    ("-a rises with a", "given = ['a >= b', 'a <= b']", "not-checked", None),
    ("-a rises with a", "given = ['a >= b']", "fails", Some(|point| point.of("a") > point.of("b"))),
    // Boolean combinations.
    ("K < M or K = M or K > M", "", "holds", None),
    ("K <= M iff not K > M", "", "holds", None),
    ("K >= M and M >= K implies K = M", "", "holds", None),
    (
        "K > M implies K > 2*M",
        "",
        "fails",
        Some(|point| {
            let [k, m] = point.values(["K", "M"]);
            k > m && k <= m * 2
        }),
    ),
    (
        "[K > M or M > 2*K] and not K = M",
        "",
        "fails",
        Some(|point| {
            let [k, m] = point.values(["K", "M"]);
            k <= m && m <= k * 2
        }),
    ),
    ("K_c >= 0 iff b >= a", "", "holds", None),
    ("K_c > 0 iff b >= a", "", "fails", Some(|point| point.of("a") == point.of("b"))),
    ("b > a implies K_c > K_c_qs", "", "holds", None),
    ("K_c = 0", "given = ['a = b']", "holds", None),
    ("sigma = D_c", "given = ['K_c_qs = b - a', 'a != b']", "holds", None),
    ("K >= M and K <= 2*M", "given = ['2*M > K', 'K > M']", "holds", None),
    // Statements on roots.
    ("stable(residual_8, s) iff K > K_c", "", "holds", None),
    ("stable(residual_8, s) iff K >= K_c", "", "fails", Some(|point| point.of("K") == point.critical())),
    ("unstable(residual_8, s) iff K < K_c", "", "holds", None),
    // Neither on the edge.
    (
        "unstable(residual_8, s) iff not stable(residual_8, s)",
        "",
        "fails",
        Some(|point| point.of("K") == point.critical()),
    ),
    ("a >= b implies stable(residual_8, s)", "", "holds", None),
    (
        "stable(residual_8, s)",
        "given = ['K = K_c', 'a < b']",
        "fails",
        Some(|point| point.of("K") == point.critical()),
    ),
    ("all_real(s^2 + K*s + M, s) iff K^2 >= 4*M", "", "holds", None),
    (
        "all_real(s^2 + K*s + M, s) iff K^2 > 4*M",
        "",
        "fails",
        Some(|point| {
            let [k, m] = point.values(["K", "M"]);
            k.clone() * k == m * 4
        }),
    ),
    ("pair_crosses(residual_8, s, K, K_c, sqrt((b - a)/a)*V_0/D_c)", WEAKENING, "holds", None),
    ("pair_crosses(residual_8, s, K, K_c, omega_n)", WEAKENING, "fails", Some(Point::weakening)),
    // It touches the axis without crossing it.
    ("pair_crosses(s^2 + (K - M)^2*s + 1, s, K, M, 1)", "", "fails", Some(|_| true)),
    // There is a value for all values of the others.
    (
        "K < K_c",
        "given = ['a < b']\nthere_is = ['V_0']\nwitness = { V_0 = 'sqrt(a*K/(M*(b - a)))*D_c' }",
        "holds",
        None,
    ),
    ("K < K_c", "there_is = ['V_0']", "fails", Some(|point| !point.weakening())),
    ("K > M", "there_is = ['K']\nwitness = { K = 'M + 1' }", "holds", None),
    ("K > M", "there_is = ['K']\nwitness = { K = 'M/2' }", "not-checked", None),
    ("K*M = 12 and K + M = 7 and K > M", "there_is = ['K', 'M']", "holds", None),
    ("K^2 + 1 < 2*K", "there_is = ['K']", "fails", None),
    // Between two values, and at some.
    ("K*(1 - K) >= 3/16", "box = { K = ['1/4', '0.75'] }", "holds", None),
    (
        "K*(1 - K) > 3/16",
        "box = { K = ['1/4', '3/4'] }",
        "fails",
        Some(|point| {
            let k = point.of("K");
            [Rational::from((1, 4)), Rational::from((3, 4))].contains(&k)
        }),
    ),
    ("K*M <= 6", "box = { K = [1, 2], M = [1, 3] }", "holds", None),
    (
        "K*M < 6",
        "box = { K = [1, 2], M = [1, 3] }",
        "fails",
        Some(|point| point.of("K") == 2 && point.of("M") == 3),
    ),
    ("K_c = sigma + 1", "at = { a = 1, b = 2, D_c = 1, M = 1, V_0 = 1 }", "holds", None),
    (
        "K_c > 3",
        "at = { a = 1, b = 2, D_c = 1, M = 1, V_0 = 1, sigma = 2 }",
        "fails",
        Some(|point| point.critical() <= 3),
    ),
    (
        "stable(residual_8, s) and K > 2*K_c",
        "at = { a = 1, b = 2, D_c = 1, M = 1, V_0 = 1, sigma = 1, K = 5 }",
        "holds",
        None,
    ),
    // With logarithms: enclosures instead of certificates.
    ("ln(K) > 1/2", "at = { K = 2 }", "holds", None),
    ("ln(K) > 1", "at = { K = 2 }", "fails", Some(|point| point.of("K") == 2)),
    ("ln(1 + K) < K and exp(K) > 1 + K", "box = { K = ['1/2', '2'] }", "holds", None),
    // False above the root of e, 1.6487….
    (
        "ln(K) < 1/2",
        "box = { K = ['1', '2'] }",
        "fails",
        Some(|point| {
            let k = point.of("K");
            k > Rational::from((16_487, 10_000)) && k <= 2
        }),
    ),
    // Where a physicist stops: squares, means, slopes that are zero at one point, limits of functions.
    ("(x - 7)^2 >= 0 and (x^2 - 2)^2 >= 0", "", "holds", None),
    ("a + b >= 2*sqrt(a*b)", "", "holds", None),
    ("a + b > 2*sqrt(a*b)", "", "fails", Some(|point| point.of("a") == point.of("b"))),
    ("(a + b)*(1/a + 1/b) >= 4", "", "holds", None),
    ("1/((x - a)^2 + b) > 0", "", "holds", None),
    ("x^3 rises with x", "", "holds", None),
    ("exp(K) > 1 + K and ln(1 + K) < K", "", "holds", None),
    ("ln(2) + ln(3) = ln(6) and exp(K + M) = exp(K)*exp(M)", "", "holds", None),
    ("sin(x)^2 + cos(x)^2 = 1", "", "holds", None),
    ("exp(-K) -> 0 as K -> infinity", "", "holds", None),
    ("exp(-K) -> 1 as K -> infinity", "", "fails", None),
    ("sqrt(K^2 + a) - K -> 0 as K -> infinity", "", "holds", None),
    ("K^2 + a -> infinity as K -> infinity", "", "holds", None),
    ("ln(K) -> -infinity as K -> 0", "", "holds", None),
    ("a/K -> -infinity as K -> 0", "", "fails", Some(|point| point.of("a") > 0)),
    // Degrees 4 to 6.
    ("stable(s^4 + a*s^3 + b*s^2 + K*s + M, s) iff a*b*K > K^2 + a^2*M", "", "holds", None),
    ("unstable(s^4 + x*s^2 + a, s) iff x < 2*sqrt(a)", "", "holds", None),
    ("stable((s + a)*(s^2 + K*s + M)^2, s)", "", "holds", None),
    (
        "stable(s^5 + a*s^4 + b*s^3 + K*s^2 + M*s + 1, s)",
        "",
        "fails",
        Some(|point| {
            let [a, b, k, m] = point.values(["a", "b", "K", "M"]);
            let second = Rational::from(&a * &b) - &k;
            let last: Rational = Rational::from(&m * &a) - 1;
            second <= 0 || second * (m * k - b) <= last.clone() * last
        }),
    ),
    ("unstable(s^6 + s^2 + a, s) and not unstable((s^2 + a)^2*(s^2 + b), s)", "", "holds", None),
    // True, and equal on the edge, where no number of bits decides.
    ("exp(K/2)^2 = exp(K)", "box = { K = ['1', '2'] }", "not-checked", None),
    ("exp(ln(K)) = K", "box = { K = ['1', '2'] }", "holds", None),
];

pub fn claim(id: usize, formula: &str, scope: &str, verdict: &str) -> String {
    format!(
        "[[claim]]\nid = \"C{id}\"\nplace = \"p\"\nwords = \"Claim {id}.\"\nexpected = \"{verdict}\"\nleaves_out = \"nothing\"\n\
         formula = {formula:?}\n{scope}\n\n"
    )
}

pub fn report(claims: &str) -> Workplace {
    Workplace::with_report(EQUATIONS, claims, "Words.\n")
}

#[test]
fn each_formula_gets_the_verdict_that_it_deserves_and_a_point_where_it_is_false() {
    let claims: String = ROWS
        .iter()
        .zip(1..)
        .map(|((formula, scope, verdict, _), id)| claim(id, formula, scope, verdict))
        .collect();
    let place = report(&claims);
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    let decided = ledger["claims"].as_array().unwrap();
    assert_eq!(decided.len(), ROWS.len());
    assert!(decided.iter().any(|found| found["strength"] == "kernel-checked"));
    // Logarithms in a box that no certificate decides.
    assert!(decided.iter().any(|found| found["strength"] == "certified"));
    for ((formula, scope, verdict, is_false), found) in ROWS.iter().zip(decided) {
        let words = format!("{formula} {scope}: {found:#}");
        assert_eq!(found["verdict"], *verdict, "{words}");
        match *verdict {
            "holds" => {
                // The formulas that claims of the project state too have theorems that Coq has accepted.
                let strengths = match found["evidence"][0]["kind"].as_str() {
                    Some("enclosure") => &["certified"][..],
                    _ => &["exact", "kernel-checked"][..],
                };
                assert!(strengths.iter().any(|strength| found["strength"] == *strength), "{words}");
            }
            "fails" => assert!(!found["counter_example"].as_str().unwrap().is_empty(), "{words}"),
            _ => assert!(!found["remarks"][0].as_str().unwrap().is_empty(), "{words}"),
        }
        if let Some(is_false) = is_false {
            assert!(is_false(&Point::read(found["counter_example"].as_str().unwrap())), "{words}");
        }
    }
}

#[test]
fn a_claim_with_parts_fails_with_its_false_part_and_names_the_true_one() {
    let place = report(
        "[[claim]]\nid = \"R2\"\nplace = \"p\"\nwords = \"Both.\"\nexpected = \"fails\"\nleaves_out = \"nothing\"\n\
         [[claim.part]]\nwords = \"inertia raises it\"\nformula = \"K_c > K_c_qs\"\ngiven = [\"a < b\"]\n\
         [[claim.part]]\nwords = \"mass lowers it\"\nformula = \"K_c falls with M\"\ngiven = [\"a < b\"]\n",
    );
    let said = place.run(["verify", "r", "--claim", "R2"]).expect_warnings();
    assert!(said.contains("true only: inertia raises it"), "{said}");
    assert!(said.contains("mass lowers it: at "), "{said}");
}

#[test]
fn formulas_at_fault_are_refused_all_at_once_with_file_and_key() {
    let rows = [
        ("K_c", "", "column 1: a formula has '=', '!=', '<', '>', '<=' or '>=' once"),
        ("K_c = = 1", "", "column 7: a formula has '='"),
        (
            "K_cc = 1",
            "",
            "column 1: 'K_cc' is no variable and no defined name of equations.toml; did you mean `K_c`?",
        ),
        ("K > 0 and K_cc = 1", "", "column 11: 'K_cc' is no variable"),
        ("K_c = K_c", "", "both sides are the same by construction"),
        ("K > M implies M < K", "", "true by construction"),
        ("K_c = 1 +", "", "column 10"),
        ("1/(a - b) > 0", "", "has no value under the conditions"),
        ("V_c > 0", "", "has no value under the conditions"),
        ("K_c -> 0 as V_0 -> 7", "", "a limit has the form"),
        ("K_c -> K_c_dyn as V_0 -> 0", "", "the value 'K_c_dyn' of the limit contains V_0"),
        ("K_c > 0", "given = ['a^2 + a = b^2 + b']", "is not linear in one of its variables"),
        ("K_c rises with K", "given = ['K = 3']", "'K = 3' has no variable but the one that moves"),
        ("K > 0 K_c", "", "column 7"),
        ("[K > M", "", "column 7: expected ']'"),
        ("K > M ]", "", "column 7: unexpected ']'"),
        ("and K > M", "", "column 1: expected a formula, found 'and'"),
        ("not", "", "column 4: expected a formula, found the end"),
        ("0 < K < M", "", "column 7: a formula has"),
        ("stable(residual_8) iff K > K_c", "", "column 1: stable(P, s) has 2 arguments, not 1"),
        ("stable(residual_8, s) = 1", "", "is true or false and has no value to compare"),
        ("K > stable(residual_8, s)", "", "is true or false and has no value to compare"),
        ("stable(residual_8, K)", "", "column 20: K is positive by assumption"),
        ("stable(1/s, s)", "", "'1/s' has no value under the conditions"),
        ("stable(s^7 + 1, s)", "", "'s^7 + 1' is no real polynomial of degree 1 to 6 in s"),
        ("all_real(s^4 + 1, s)", "", "'s^4 + 1' is no real polynomial of degree 1 to 3 in s"),
        ("stable(s + i*K, s)", "", "is no real polynomial"),
        ("K > M", "at = { K = '-1' }", "K = -1 is not positive as the equations assume"),
        ("K > M", "at = { Q = '1' }", "'Q' is no variable"),
        ("K > M", "box = { K = ['2', '1'] }", "two numbers, the smaller one first"),
        ("K > M", "witness = { K = 'M' }", "needs `K` in `there_is`"),
        ("K > M", "given = ['K < 1']\nat = { K = '2' }", "is not met"),
    ];
    // The program prints faults of 1 500 characters at most.
    for rows in rows.chunks(4) {
        let claims: String = rows
            .iter()
            .zip(1..)
            .map(|((formula, scope, _), id)| claim(id, formula, scope, "holds"))
            .collect();
        let faults: Vec<&str> = rows.iter().map(|(.., fault)| *fault).collect();
        report(&claims).run(["report", "r"]).expect_refusal(&faults);
    }
    let bare = "[[claim]]\nid = \"S1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\n";
    report(&format!("{bare}formula = \"K_c > 0\"\n"))
        .run(["report", "r"])
        .expect_refusal(&["leaves_out: missing"]);
    report(&format!("{bare}given = [\"a < b\"]\n")).run(["report", "r"]).expect_refusal(&["needs `formula`"]);
}

#[test]
fn formulas_that_say_less_than_they_seem_to_are_warned_about() {
    let warned: [(&str, &str, &str); 9] = [
        (
            "K_c_qs does not depend on M",
            "",
            "is so by the equations that define its names: they do not contain M",
        ),
        ("K_c > K_c_qs", WEAKENING, "'K_c > K_c_qs' says nothing about a = b, where it is false"),
        ("K_c > 0", "given = ['a < b', 'b < a']", "the conditions of 'K_c > 0' contradict each other"),
        ("K > M", "given = ['K = 2*M', 'M > K']", "contradict each other"),
        ("K + M <= 0 implies K_c > 1", "", "the hypothesis (K + M <= 0) is never true under the conditions"),
        ("K > 0 or M > K", "there_is = ['K']\nwitness = { K = '2' }", "one value does for all of them"),
        ("M > 0", "there_is = ['K']", "'M > 0' does not contain K"),
        ("K_c = right_9", "", "both sides of 'K_c = right_9' are the same by their definitions"),
        ("K > K_c implies stable(residual_8, s)", "", "says nothing about K = K_c, where it is false"),
    ];
    // The edge is part of the formula, or is said to be left out, or the formula is true on it, or it has no value there.
    let silent: [(&str, &str); 6] = [
        ("omega_n > 1", "there_is = ['K']\nwitness = { K = '4*M' }"),
        ("stable(residual_8, s) iff K > K_c", ""),
        ("K_c >= K_c_qs", "given = ['a <= b']"),
        ("K^2 + 2*K > 0", "given = ['M != V']"),
        ("V_c > 0", WEAKENING),
        ("K_c > K_c_qs", "given = ['a < b']"),
    ];
    let claims: String = warned
        .iter()
        .map(|(formula, scope, _)| (formula, scope))
        .chain(silent.iter().map(|(f, s)| (f, s)))
        .zip(1..)
        .map(|((formula, scope), id)| claim(id, formula, scope, "holds"))
        .collect();
    let last = warned.len() + silent.len();
    let (rest, end) = claims.split_at(claims.rfind("leaves_out").unwrap());
    let place = report(&(rest.to_owned() + &end.replacen("nothing", "That both are equal for b = a.", 1)));
    let ended = place.run(["report", "r", "-o", "out"]);
    let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    let remarks = |id: usize| ledger["claims"][id - 1]["remarks"].to_string();
    for ((formula, _, warning), id) in warned.iter().zip(1..) {
        assert!(
            ended.stderr.contains(&format!("warning: C{id}: ")) && ended.stderr.contains(warning),
            "{}",
            ended.stderr
        );
        assert!(
            remarks(id).contains("Warning: ") && remarks(id).contains(warning),
            "{formula}: {}",
            remarks(id)
        );
    }
    for id in warned.len() + 1..=last {
        assert!(!ended.stderr.contains(&format!("warning: C{id}: ")), "C{id} in {}", ended.stderr);
    }
    // A formula whose conditions contradict each other says nothing: it is not decided, and the contradiction is proved.
    assert_eq!(ledger["claims"][2]["verdict"], "not-checked");
    assert_eq!(ledger["claims"][2]["evidence"][0]["kind"], "proof");
}

#[test]
fn a_claim_whose_words_say_more_than_its_formulas_is_argued_at_most() {
    let both = ["", "argued = 'The words are about all motions.'\n"].map(|argued| {
        let text = claim(1, "stable(left_8, s) iff K > K_c", "", "holds");
        let place = report(&text.replace("leaves_out", &format!("{argued}leaves_out")));
        place.run(["report", "r", "-o", "out"]);
        let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
        let found = &ledger["claims"][0];
        (found["strength"].as_str().unwrap().to_owned(), found["remarks"].to_string())
    });
    let [(strength, _), (argued, remarks)] = both;
    assert_eq!((strength.as_str(), argued.as_str()), ("kernel-checked", "argued"));
    assert!(remarks.contains("Argued in words: The words are about all motions."), "{remarks}");
}
