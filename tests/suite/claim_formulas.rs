//! Claims stated as formulas in `claims.toml`: each kind of statement, true, false, out of reach, and at fault.

use std::collections::BTreeMap;

use crate::harness::Workplace;

const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

/// A formula, its conditions, the verdict, and for a false one a test of the point that the counter-example names.
type Row = (&'static str, &'static [&'static str], &'static str, Option<fn(&Point) -> bool>);

/// The values that a counter-example names, and 1 for every other quantity.
struct Point(BTreeMap<String, f64>);

impl Point {
    /// `at a = 1, b = 4: …` up to the colon.
    fn read(counter_example: &str) -> Self {
        let (list, _) = counter_example.strip_prefix("at ").unwrap().split_once(": ").unwrap();
        let value = |text: &str| {
            let (above, below) = text.split_once('/').unwrap_or((text, "1"));
            above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap()
        };
        let pairs = list.split(", ").map(|pair| pair.split_once(" = ").unwrap());
        Self(pairs.map(|(name, text)| (name.to_owned(), value(text))).collect())
    }

    fn of(&self, name: &str) -> f64 {
        self.0.get(name).copied().unwrap_or(1.0)
    }

    /// Eq 10 and eq 11, typed here on their own.
    fn stiffnesses(&self) -> [f64; 2] {
        let [a, b, d, m, s, v] = ["a", "b", "D_c", "M", "sigma", "V_0"].map(|name| self.of(name));
        [(b - a) * s / d, (b - a) / a * m * v * v / (d * d)]
    }
}

const ROWS: &[Row] = &[
    ("K_c_qs + K_c_dyn = K_c", &[], "holds", None),
    ("K_c = K_c_qs", &[], "fails", Some(|point| point.stiffnesses()[1] != 0.0)),
    ("K_c > K_c_qs", &["a < b"], "holds", None),
    ("K_c > K_c_qs", &[], "fails", Some(|point| point.stiffnesses()[1] <= 0.0)),
    // False on the edge a = b only.
    ("K_c != 0", &[], "fails", Some(|point| point.of("a") == point.of("b"))),
    ("K_c -> K_c_qs as V_0 -> 0", &[], "holds", None),
    ("K_c -> K_c_dyn as V_0 -> 0", &[], "fails", None),
    ("K_c -> K_c_qs as V_0 -> infinity", &[], "not-checked", None),
    ("K_c rises with V_0", &["a < b"], "holds", None),
    ("K_c falls with V_0", &["a < b"], "fails", Some(|point| point.of("a") < point.of("b"))),
    ("K_c depends on D_c", &[], "holds", None),
    ("omega_n depends on D_c", &[], "fails", None),
    ("omega_n does not depend on D_c", &[], "holds", None),
    ("K_c does not depend on M", &["a < b"], "fails", Some(|point| point.of("a") < point.of("b"))),
    // Vacuous: nothing meets both conditions.
    ("K_c > 0", &["a < b", "b < a"], "not-checked", None),
    // True, but not by coefficients of one sign.
    ("K^2 + M^2 > K*M", &[], "not-checked", None),
    ("right_15*right_16 = sigma_c^2", &["a < b"], "holds", None),
    ("right_15 > right_16", &["a < b"], "holds", None),
    ("V_c -> 0 as D_c -> 0", &["b > a"], "holds", None),
    ("right_steady_friction falls with V", &["a < b"], "holds", None),
    // A positive slope on both sides of a pole is no rise across it.
    ("-1/(a - b) rises with a", &["a != b"], "not-checked", None),
];

pub fn claim(id: usize, formula: &str, given: &[&str], verdict: &str) -> String {
    let given = if given.is_empty() { String::new() } else { format!("given = {given:?}\n") };
    format!(
        "[[claim]]\nid = \"C{id}\"\nplace = \"p\"\nwords = \"Claim {id}.\"\nexpected = \"{verdict}\"\nleaves_out = \"nothing\"\n\
         formula = {formula:?}\n{given}\n"
    )
}

pub fn report(claims: &str) -> Workplace {
    let place = Workplace::new();
    place.write(
        "r/report.toml",
        "name = \"r\"\ntitle = \"R\"\nscenes = [\"a\"]\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n",
    );
    place.write("r/claims.toml", claims);
    place.write("r/equations.toml", EQUATIONS);
    place.write("r/scenes/a.toml", "name = \"a\"\ntitle = \"A\"\n");
    place.write("r/prose/c.md", "Words.\n");
    place
}

#[test]
fn each_formula_gets_the_verdict_that_it_deserves_and_a_point_where_it_is_false() {
    let claims: String = ROWS
        .iter()
        .zip(1..)
        .map(|((formula, given, verdict, _), id)| claim(id, formula, given, verdict))
        .collect();
    let place = report(&claims);
    place.run(["report", "r", "-o", "out"]).expect_success();
    let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    let decided = ledger["claims"].as_array().unwrap();
    assert_eq!(decided.len(), ROWS.len());
    for ((formula, given, verdict, is_false), found) in ROWS.iter().zip(decided) {
        let words = format!("{formula} given {given:?}: {found:#}");
        assert_eq!(found["verdict"], *verdict, "{words}");
        match *verdict {
            "holds" => {
                assert!(found["strength"] == "exact" && found["evidence"][0]["kind"] == "proof", "{words}")
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
    let said = place.run(["verify", "r", "--claim", "R2"]).expect_success();
    assert!(said.contains("true only: inertia raises it"), "{said}");
    assert!(said.contains("mass lowers it: at "), "{said}");
}

#[test]
fn formulas_at_fault_are_refused_all_at_once_with_file_and_key() {
    let rows: [(&str, &[&str], &str); 9] = [
        ("K_c", &[], "a formula has '=', '!=', '<' or '>' once"),
        ("K_c = = 1", &[], "a formula has '='"),
        ("K_cc = 1", &[], "'K_cc' is no variable and no defined name of equations.toml; did you mean `K_c`?"),
        ("K_c = K_c", &[], "both sides are the same by construction"),
        ("K_c = 1 +", &[], "column"),
        ("1/(a - b) > 0", &[], "has no value under the conditions"),
        ("V_c > 0", &[], "has no value under the conditions"),
        ("K_c -> 0 as V_0 -> 7", &[], "a limit has the form"),
        ("K_c > 0", &["a = b"], "not '='"),
    ];
    let claims: String =
        rows.iter().zip(1..).map(|((formula, given, _), id)| claim(id, formula, given, "holds")).collect();
    let refused = report(&claims).run(["report", "r"]);
    let faults: Vec<&str> = rows.iter().map(|(.., fault)| *fault).collect();
    refused.expect_refusal(&faults);
    let bare = "[[claim]]\nid = \"S1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\n";
    report(&format!("{bare}formula = \"K_c > 0\"\n"))
        .run(["report", "r"])
        .expect_refusal(&["leaves_out: missing"]);
    report(&format!("{bare}given = [\"a < b\"]\n")).run(["report", "r"]).expect_refusal(&["needs `formula`"]);
}
