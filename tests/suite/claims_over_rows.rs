//! Claims over the rows of a table of simulations: true, false, about no row, open within the estimated errors, and at fault.

use crate::claim_formulas::report;
use crate::harness::Workplace;

const SCENE: &str = r#"
name = "a"
title = "A"
[parameters]
direct_effect = 0.004
evolution_effect = 0.006
critical_slip_distance_m = 10e-6
stiffness_pa_per_m = 10e6
mass_per_area_kg_per_m2 = 1000
[simulations]
loading_velocity_m_per_s = { from = 1e-5, to = 1e-2, points = 4 }
normal_stress_pa = { from = 1e2, to = 1e6, points = 3 }
laws = ["slip"]
tolerance = 1e-6
"#;

fn claim(id: usize, rows: &str, statement: &str, verdict: &str) -> String {
    format!(
        "[[claim]]\nid = \"R{id}\"\nplace = \"p\"\nwords = \"Claim {id}.\"\nexpected = \"{verdict}\"\nleaves_out = \"nothing\"\n\
         rows = \"{rows}\"\nformula = \"{statement}\"\n\n"
    )
}

fn with_runs(claims: &str) -> Workplace {
    let place = report(claims);
    place.write("r/scenes/a.toml", SCENE);
    place
}

/// A statement over the table of simulations, its verdict, its strength, and a part of what is said about it.
const ROWS: &[(&str, &str, &str, &str)] = &[
    (
        "for every row: behaviour = 'periodic' iff stiffness_over_critical < 1",
        "holds",
        "converged",
        "true in 12 of 12 rows",
    ),
    (
        "for every row where stiffness_over_critical > 1: period_s = ''",
        "fails",
        "converged",
        "the first: scene = a, slider = a < b, law = slip",
    ),
    // The law names the row, so that it is certain.
    ("for every row where stress_drop_pa > 1: law = 'slip'", "holds", "certified", "rows"),
    ("for every row where stress_drop_pa < 10^9: stress_drop_pa > 0", "holds", "converged", "rows"),
    (
        "for every row where law = 'aging': period_s > 0",
        "not-checked",
        "",
        "No row of the table `simulations`",
    ),
    ("count where behaviour = 'periodic' >= 1", "holds", "converged", "of 12 rows"),
    ("count where law = 'aging' = 0", "holds", "certified", "0 of 12 rows"),
    ("count = 11", "fails", "certified", "there are 12"),
    // The error of a peak is far above a part in 10^15.
    (
        "peak_velocity_m_per_s agrees with peak_velocity_m_per_s*(1 + 1/10^15) within 1e-16",
        "not-checked",
        "",
        "an estimated error leaves it open",
    ),
    (
        "peak_velocity_m_per_s agrees with 2*peak_velocity_m_per_s within 0.4",
        "fails",
        "converged",
        "in 12 of 12 rows",
    ),
    (
        "loading_velocity_m_per_s agrees with loading_velocity_m_per_s*1.01 within 0.02",
        "holds",
        "certified",
        "12 of 12",
    ),
    ("for every row: 1/(period_s - period_s) > 0", "not-checked", "", "a missing value"),
    (
        "correlation of loading_velocity_m_per_s with normal_stress_pa < 0.5",
        "holds",
        "certified",
        "true in 1 of 1",
    ),
    (
        "correlation of peak_velocity_m_per_s with normal_stress_pa at each loading_velocity_m_per_s > 0.99999",
        "fails",
        "converged",
        "in 4 of 4 groups of rows; the first: ",
    ),
    ("correlation of normal_stress_pa with 1 > 0", "not-checked", "", "different values"),
    ("least normal_stress_pa at normal_stress_pa = 1e2 within 1", "holds", "certified", "at 100"),
    (
        "largest normal_stress_pa at normal_stress_pa = 1e4 within 1 at each loading_velocity_m_per_s",
        "fails",
        "certified",
        "at 1e6",
    ),
    ("normal_stress_pa rises with normal_stress_pa at each law", "not-checked", "", "have one place"),
    (
        "normal_stress_pa^2 rises with normal_stress_pa at each loading_velocity_m_per_s",
        "holds",
        "certified",
        "8 of 8 neighbours",
    ),
    (
        "stiffness_over_critical rises with normal_stress_pa at each loading_velocity_m_per_s",
        "fails",
        "certified",
        "in 8 of 8 neighbours; the first: scene = a, slider = a < b, law = slip",
    ),
    (
        "between neighbours along loading_velocity_m_per_s and normal_stress_pa at each law: peak_velocity_m_per_s rises and normal_stress_pa rises",
        "holds",
        "converged",
        "true in 6 of 6 neighbours",
    ),
    (
        "between neighbours along loading_velocity_m_per_s at each law: peak_velocity_m_per_s rises",
        "not-checked",
        "",
        "Rows 1 and 5 have one place: name more columns after `at each`.",
    ),
    ("stiffness_over_critical is near 1", "fails", "certified", "off by"),
    (
        "peak_velocity_m_per_s agrees with peak_velocity_m_per_s*(1 + 1/10^15) within errors",
        "holds",
        "converged",
        "12 of 12",
    ),
    ("harmonic_distortion is near 0 where behaviour = 'decaying'", "not-checked", "", "is missing or"),
];

#[test]
fn statements_over_rows_get_the_verdict_and_the_strength_that_they_deserve() {
    let claims = ROWS
        .iter()
        .zip(1..)
        .map(|((statement, verdict, ..), id)| claim(id, "simulations", statement, verdict));
    let place = with_runs(&claims.collect::<String>());
    place.run(["report", "r", "-o", "out"]).expect_success();
    let ledger: serde_json::Value = serde_json::from_str(&place.read("out/ledger.json")).unwrap();
    for ((statement, verdict, strength, part), found) in ROWS.iter().zip(ledger["claims"].as_array().unwrap())
    {
        assert_eq!(found["verdict"], *verdict, "{statement}: {found:#}");
        assert!(*verdict == "not-checked" || found["strength"] == *strength, "{statement}: {found:#}");
        let told = format!("{} {} {}", found["evidence"], found["counter_example"], found["remarks"]);
        assert!(told.contains(part), "{statement}: {found:#}");
    }
    let text = place.read("out/ledger.md");
    assert!(text.contains("over the rows of the table `simulations`, `count = 11`"), "{text}");
}

#[test]
fn a_statement_over_rows_computes_only_its_own_table() {
    let claims =
        claim(1, "simulations", "count = 12", "holds") + &claim(2, "frequency", "count > 0", "not-checked");
    let place = with_runs(&claims);
    let said = place.run(["verify", "r", "--claim", "R1"]).expect_success();
    assert!(said.contains("simulations: count = 12: 12 of 12 rows"), "{said}");
    let said = place.run(["verify", "r", "--claim", "R2"]).expect_success();
    assert!(said.contains("No scene of the report computes the table."), "{said}");
}

/// What a true statement says of too few rows, groups or neighbours stays open; a counter-example decides, whatever their number.
#[test]
fn a_statement_that_is_true_of_fewer_rows_than_the_claim_wants_is_not_checked() {
    let every = "for every row: peak_velocity_m_per_s > 0";
    let pairs = "stiffness_over_critical^2 falls with normal_stress_pa at each loading_velocity_m_per_s";
    let cases = [
        (every, 12, "holds", "over the rows of the table `simulations` for at least 12, `"),
        (every, 13, "not-checked", "True, but of 12 only (the claim wants at least 13)."),
        (pairs, 9, "not-checked", "True, but of 8 only (the claim wants at least 9)."),
        ("count where law = 'aging' = 0", 1, "not-checked", "True, but of 0 only"),
        ("for every row: peak_velocity_m_per_s < 0", 13, "fails", "in 12 of 12 rows"),
    ];
    let claims = cases.iter().zip(1..).map(|((statement, least, verdict, _), id)| {
        claim(id, "simulations", statement, verdict) + &format!("at_least = {least}\n\n")
    });
    let place = with_runs(&claims.collect::<String>());
    place.run(["report", "r", "-o", "out"]).expect_success();
    let text = place.read("out/ledger.md");
    for (statement, least, _, part) in cases {
        assert!(text.contains(part), "{statement} {least}: {text}");
    }
}

#[test]
fn statements_over_rows_at_fault_are_refused_all_at_once() {
    let rows = [
        (
            "simulation",
            "count = 12",
            "there is no table `simulation` of computed values; did you mean `simulations`?",
        ),
        ("simulations", "for every row: peak_velocity > 0", "'peak_velocity' is no column of the table"),
        ("simulations", "for every row: perod_s > 0", "did you mean `period_s`?"),
        ("simulations", "for every row: law > 1", "`law` is a column of words"),
        (
            "simulations",
            "for every row: period_s = 'long'",
            "a word in quotes is compared with a column of words",
        ),
        ("simulations", "for every row period_s > 0", "needs a ':'"),
        ("simulations", "count where period_s > 0", "column 1: a formula has"),
        ("simulations", "period_s rises with law", "`law` is a column of words"),
        ("simulations", "period_s rises with normal_stress_pa at each lwa", "did you mean `law`?"),
        ("simulations", "period_s", "a statement over rows is `for every row: …`"),
        ("simulations", "for every row: law = 'slip", "a quote ' is not closed"),
        (
            "simulations",
            "between neighbours along normal_stress_pa: period_s grows",
            "expected `… rises` or `… falls`",
        ),
        ("simulations", "period_s is near 0", "`period_s` has the unit s, and 10 % of 0 is 0"),
        ("simulations", "between neighbours along lwa: period_s rises", "did you mean `law`?"),
        ("simulations", "between neighbours along law period_s rises", "`between neighbours` needs a ':'"),
    ];
    // The program prints faults of 1 500 characters at most.
    for rows in rows.chunks(3) {
        let claims: String = rows
            .iter()
            .zip(1..)
            .map(|((table, statement, _), id)| claim(id, table, statement, "holds"))
            .collect();
        let parts: Vec<&str> = rows.iter().map(|(.., part)| *part).collect();
        with_runs(&claims).run(["report", "r"]).expect_refusal(&parts);
    }
    let with_number = |number: &str| {
        claim(1, "simulations", "count = 12", "holds") + &format!("numbers = {{ n = \"{number}\" }}\n")
    };
    for (number, part) in [
        (
            "least perod_s, 2 digits",
            "the number `n`: 'perod_s' is no column of the table; did you mean `period_s`?",
        ),
        ("least period_s", "the number `n`: the form is `least x where …, 2 digits, below`"),
        ("largest law, 2 digits", "`law` is a column of words"),
    ] {
        with_runs(&with_number(number)).run(["report", "r"]).expect_refusal(&[part]);
    }
    let counted = claim(1, "simulations", "count = 12", "holds");
    let of_no_table = counted.replace("rows = \"simulations\"\n", "");
    for (claim, part) in [
        (counted.clone() + "given = [\"a < b\"]\n", "needs no `rows` beside it"),
        (
            counted.clone() + "at_least = 0\n",
            "at_least = 0: out of range (allowed: a whole number, 1 or more)",
        ),
        (counted + "at_least = \"all\"\n", "at_least = \"all\": "),
        (of_no_table + "at_least = 3\n", "at_least = 3: needs `rows` beside it: the table that it is about"),
    ] {
        with_runs(&claim).run(["report", "r"]).expect_refusal(&[part]);
    }
}
