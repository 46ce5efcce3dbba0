//! Statements over rows of small tables: what decides them, what leaves them open, and what is no grid.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::{Cell, Table};

use crate::claims::{Finding, Strength, Verdict};
use crate::experiments::certificates::{Certificates, certify_grid};
use crate::experiments::shared::fixtures::paper;
use crate::experiments::{Context, Need, Outcome, References, Scene, run};
use crate::scene::{Kind, Limits, OverRows};
use slipmode_theory::Equations;

/// A row: law, x, y, error of y, value with its enclosure, word with what is proved, failure.
type Line = [&'static str; 10];

/// Two laws on a grid of x and y = 1, 2.
const GRID: [Line; 8] = [
    ["slip", "1", "1", "0.1", "10", "9.9", "10.1", "cycle", "cycle", ""],
    ["slip", "2", "1", "0.1", "20", "19.9", "20.1", "cycle", "cycle", ""],
    ["slip", "1", "2", "0.1", "30", "29.9", "30.1", "cycle", "cycle", ""],
    ["slip", "2", "2", "0.1", "40", "39.9", "40.1", "cycle", "cycle", ""],
    ["aging", "1", "1", "0.1", "10", "", "", "none", "", ""],
    ["aging", "2", "1", "0.1", "20", "", "", "cycle", "", ""],
    ["aging", "1", "2", "0.1", "30", "", "", "cycle", "", ""],
    ["aging", "2", "2", "0.1", "20", "", "", "cycle", "", ""],
];

fn table(lines: &[Line]) -> Table {
    let number =
        |at: usize| move |line: &Line| Some(line[at]).filter(|text| !text.is_empty()).map(Cell::number);
    Table::of("t", "T", lines)
        .text("law", "Law", |line: &Line| line[0])
        .number("x", "x", "", number(1))
        .number("y", "y", "", number(2))
        .named()
        .number("x_dex", "x", "dex", number(1))
        .number("value_error", "Its error", "", number(3))
        .number("value_m", "Value", "m", number(4))
        .number("value_m_low", "from", "m", |line| Cell::number(line[5]).certain())
        .number("value_m_high", "to", "m", |line| Cell::number(line[6]).certain())
        .text("word", "Word", |line| line[7])
        .text("word_proved", "proved", |line| line[8])
        .text("failure", "Failure", |line| line[9])
        .table()
}

fn found_on(lines: &[Line], text: &str, kind: Kind) -> Finding {
    decided(&table(lines), text, kind)
}

fn decided(table: &Table, text: &str, kind: Kind) -> Finding {
    let numbers = BTreeMap::from(
        [
            ("most", "largest value_m where law = 'slip', 1 digits, above"),
            ("cycles", "count where word = 'cycle'"),
        ]
        .map(|(name, text)| (name.to_owned(), text.to_owned())),
    );
    let statement = super::statement::read(text, &numbers, &table.columns).unwrap();
    super::decide::decide(text, &statement, table, kind)
}

fn found(lines: &[Line], text: &str) -> (Verdict, Strength) {
    let found = found_on(lines, text, Kind::Universal);
    assert!(!found.is_overstated(), "{found:?}");
    (found.verdict, found.strength.unwrap_or_default())
}

/// The grid with one cell changed.
fn altered(row: usize, column: usize, text: &'static str) -> [Line; 8] {
    let mut lines = GRID;
    lines[row][column] = text;
    lines
}

const RISES: &str =
    "between neighbours along x at each law, y where law = 'slip' and word = 'cycle': value_m rises";

#[test]
fn an_enclosure_decides_before_an_estimated_error_and_a_missing_one_lowers_the_strength() {
    assert_eq!(found(&GRID, RISES), (Verdict::Holds, Strength::Certified));
    assert_eq!(found(&altered(0, 5, ""), RISES), (Verdict::Holds, Strength::Converged));
    // What rises in any case rises whether or not it is known to be a cycle; what is left out has to be known.
    assert_eq!(found(&altered(0, 8, ""), RISES), (Verdict::Holds, Strength::Certified));
    let mut left_out = altered(0, 8, "");
    left_out[0][7] = "none";
    assert_eq!(found(&left_out, RISES), (Verdict::Holds, Strength::Converged));
    // One counter-example that is certified decides alone.
    let falls = RISES.replace("rises", "falls");
    assert_eq!(found(&altered(0, 5, ""), &falls), (Verdict::Fails, Strength::Certified));
    // Enclosures that overlap decide nothing.
    let mut wide = GRID;
    wide[0][5..7].copy_from_slice(&["0", "50"]);
    assert_eq!(found(&wide, RISES).0, Verdict::NotChecked);
}

#[test]
fn numbers_that_may_be_equal_are_open_and_those_that_name_a_row_are_as_shown() {
    let shown = |_: &Line| Cell::rounded("1.2346", 5);
    let value = |line: &Line| Cell::number(line[4]);
    let law = || Table::of("t", "T", &GRID[..1]).text("law", "Law", |line: &Line| line[0]);
    let [computed, named] =
        [law().named().number("x", "x", "", shown), law().number("x", "x", "", shown).named()]
            .map(|rows| rows.number("value_m", "v", "m", value).text("word", "Word", |line| line[7]).table());
    let verdict = |table: &Table, text: &str| decided(table, text, Kind::Universal).verdict;
    for text in ["count where x = 1.2346 = 1", "count where x = 1.23461 = 0", "for every row: x != 1.23461"] {
        assert_eq!(verdict(&named, text), Verdict::Holds, "{text}");
    }
    for text in ["count where x = 1.2346 = 1", "count where x = 1.23461 = 0", "for every row: x = 1.23461"] {
        assert_eq!(verdict(&computed, text), Verdict::NotChecked, "{text}");
    }
    assert_eq!(verdict(&computed, "for every row: x != 1.2347"), Verdict::Holds);
    assert_eq!(verdict(&computed, "for every row: value_m = 10"), Verdict::Holds);
}

#[test]
fn a_statement_about_no_certain_row_decides_nothing() {
    for condition in
        ["value_m > value_m", "value_m_low > 1000", "value_m > 10 and law = 'aging' and x = 1 and y = 1"]
    {
        let text = format!("for every row where {condition}: x > 0");
        assert_eq!(found(&GRID, &text).0, Verdict::NotChecked, "{text}");
    }
    let some = "for every row where value_m >= 10 and law = 'aging': y > 0";
    assert_eq!(found_on(&GRID, some, Kind::Universal).numbers["count"], "3");
}

#[test]
fn a_run_that_contradicts_its_certificate_or_has_no_result_leaves_every_statement_open() {
    for contradicting in [altered(0, 4, "11"), altered(0, 7, "none")] {
        let found = found_on(&contradicting, "count = 8", Kind::Universal);
        assert_eq!(found.verdict, Verdict::NotChecked);
        assert!(found.remarks[0].contains("differs from its certificate"), "{found:?}");
    }
    // Within its error it contradicts nothing.
    assert_eq!(found(&altered(0, 4, "10.15"), "count = 8").0, Verdict::Holds);
    let mut failed = altered(4, 7, "");
    failed[4][9] = "no result";
    for open in
        ["for every row: word = 'cycle'", "for every row: word != ''", "count where word = 'none' = 1"]
    {
        assert_eq!(found(&failed, open).0, Verdict::NotChecked, "{open}");
    }
    assert_eq!(found(&failed, "for every row where law = 'slip': word = 'cycle'").0, Verdict::Holds);
}

#[test]
fn an_empty_word_is_no_other_word_unless_the_row_has_failed() {
    for text in [
        "for every row: failure = '' and failure != 'x' and not failure = 'x'",
        "count where failure = 'x' = 0",
        "for every row: word_proved != 'none'",
        "count where word_proved = word = 4",
        "for every row: word_proved = '' iff law = 'aging'",
    ] {
        assert_eq!(found(&GRID, text).0, Verdict::Holds, "{text}");
    }
    assert_eq!(found(&GRID, "for every row: word_proved = 'cycle'").0, Verdict::Fails);
    let failed = altered(4, 9, "no result");
    assert_eq!(found(&failed, "for every row: word_proved != 'none'").0, Verdict::NotChecked);
    assert_eq!(found(&failed, "count where failure = 'x' = 0").0, Verdict::Holds);
}

#[test]
fn neighbours_are_next_to_each_other_on_the_grid_and_both_meet_the_condition() {
    let found = |text: &str| found_on(&GRID, text, Kind::Universal);
    let along_x = "between neighbours along x at each law, y where word = 'cycle': value_m";
    // Of four pairs three are of cycles, of which one falls.
    let one = found(&format!("{along_x} rises"));
    assert_eq!((one.verdict, &one.numbers["share"][..]), (Verdict::Fails, "1 of 3"));
    assert!(one.counter_example.unwrap().contains(" and x = 2, "));
    let joint =
        found("between neighbours along x and y at each law where law = 'slip': value_m rises and x rises");
    assert_eq!((joint.verdict, &joint.numbers["count"][..]), (Verdict::Holds, "1"));
    let none = found("between neighbours along x at each law, y where word = 'other': value_m rises");
    assert!(none.verdict == Verdict::NotChecked && none.remarks[0].contains("No neighbour of the table"));
    let doubled = found("between neighbours along x at each law: value_m rises");
    assert!(doubled.remarks[0].contains("have one place"), "{doubled:?}");
    // A row between two others that does not meet the condition parts them.
    let mut row = GRID;
    for (at, x) in (1u8..).zip(["1", "2", "3"]) {
        row[usize::from(at) - 1] =
            ["slip", x, "1", "0.1", "10", "", "", if at == 2 { "none" } else { "cycle" }, "", ""];
    }
    let parted = found_on(&row[..3], RISES, Kind::Universal);
    assert_eq!(parted.verdict, Verdict::NotChecked, "{parted:?}");
}

#[test]
fn nearness_is_that_of_the_kind_of_the_sentence_and_agreement_that_of_the_errors() {
    let near = |text: &str, kind| found_on(&GRID, text, kind);
    let close = "value_m is near 10*x*y where law = 'slip' and y = 1";
    assert_eq!(near(close, Kind::Approximate).verdict, Verdict::Holds);
    let far = near("value_m and value_m are near 8*x where law = 'slip' and y = 1", Kind::Approximate);
    assert_eq!(far.counter_example.as_deref(), Some("off by 25 %; 4 of 4 by more than 10 %"));
    // The error is as large as the distance from the tolerance.
    let open = near("value_m is near 10/1.1 where law = 'aging' and word = 'none'", Kind::Approximate);
    assert_eq!(open.verdict, Verdict::NotChecked, "{open:?}");
    assert_eq!(near("value_m is near 9*x where law = 'aging'", Kind::Universal).verdict, Verdict::Fails);
    let agrees = "value_m agrees with 10.05 within errors where law = 'aging' and y = 1 and x = 1";
    assert_eq!(found(&GRID, agrees), (Verdict::Holds, Strength::Converged));
    assert_eq!(found(&altered(4, 4, "10.2"), agrees).0, Verdict::Fails);
    assert_eq!(found(&altered(4, 4, ""), agrees).0, Verdict::NotChecked);
    assert_eq!(found(&altered(4, 3, ""), agrees).0, Verdict::NotChecked);
}

/// Every pair of these values, as columns and as numbers in the text, on both sides. The truth is known: 10 % of y, and 0.1 of a pure
/// number from the number 0.
#[test]
fn nearness_is_ten_percent_of_the_right_side_whether_it_is_a_column_or_a_number() {
    let values = ["-1", "0", "0.02", "0.3", "1", "1.05", "2"];
    for (x, y) in values.iter().flat_map(|x| values.map(|y| (*x, y))) {
        let [left, right] = [x, y].map(|text| text.parse::<f64>().unwrap());
        let within = (left - right).abs() <= 0.1 * right.abs();
        let of_numbers = within || (x == "0" || y == "0") && left.abs().max(right.abs()) < 0.1;
        let cases = [
            ("x is near y".to_owned(), within),
            (format!("x is near {y}"), if y == "0" { of_numbers } else { within }),
            (format!("{x} is near y"), if x == "0" { of_numbers } else { within }),
            (format!("{x} is near {y}"), of_numbers),
        ];
        for (text, is_near) in cases {
            let found = found_on(&[["slip", x, y, "0.1", "", "", "", "", "", ""]], &text, Kind::Approximate);
            let verdict = if is_near { Verdict::Holds } else { Verdict::Fails };
            assert_eq!(found.verdict, verdict, "x = {x}, y = {y}: {text}: {found:?}");
        }
    }
}

#[test]
fn decades_are_compared_on_either_side_and_zero_within_an_error_has_no_percentage() {
    for (text, verdict) in [
        ("x_dex is near 0.8 where x = 1", Verdict::Holds),
        ("0.8 is near x_dex where x = 1", Verdict::Holds),
        ("0 is near x_dex - 0.9 where x = 1", Verdict::Holds),
        ("x_dex is near 0.7 where x = 1", Verdict::Fails),
        ("0.7 is near x_dex where x = 1", Verdict::Fails),
    ] {
        assert_eq!(found_on(&GRID, text, Kind::Approximate).verdict, verdict, "{text}");
    }
    // The value is 0 ± 0.1.
    let zero = altered(4, 4, "0");
    for (side, approximate, universal) in [
        ("x - 1", Verdict::NotChecked, Verdict::Holds),
        ("x/20", Verdict::NotChecked, Verdict::Holds),
        ("x", Verdict::Fails, Verdict::Fails),
    ] {
        let text = format!("{side} is near value_m where word = 'none'");
        assert_eq!(found_on(&zero, &text, Kind::Approximate).verdict, approximate, "{text}");
        assert_eq!(found_on(&zero, &text, Kind::Universal).verdict, universal, "{text}");
    }
    for text in ["value_m is near 0", "0 is near value_m", "x and value_m are near 1 - 1"] {
        let refused = super::statement::read(text, &BTreeMap::new(), &table(&GRID).columns);
        assert!(refused.unwrap_err().starts_with("`value_m` has the unit m, and 10 % of 0 is 0"), "{text}");
    }
}

#[test]
fn a_group_without_a_certain_correlation_leaves_the_statement_open_unless_another_group_refutes_it() {
    let of = |lines: &[Line], text: &str| {
        let found = found_on(lines, &format!("correlation of x with {text}"), Kind::Universal);
        let told = found.counter_example.or(found.remarks.first().cloned()).unwrap_or_default();
        (found.verdict, told)
    };
    // The correlation is 0.4472 for the slip law and 0 for the aging law.
    assert_eq!(of(&GRID, "value_m at each law > -0.5").0, Verdict::Holds);
    let mut wide = GRID;
    wide[4..].iter_mut().for_each(|line| line[3] = "50");
    for (lines, text, reason) in [
        (GRID, "value_m at each law > -0.5 where law = 'slip' or y = 1", "fewer than 3 values: law = aging"),
        (GRID, "x^2 at each law, y > -0.5", "fewer than 3 values: law = aging, y = 1; fewer than 3 values: "),
        (GRID, "1 at each law > -0.5", "one side has no certainly different values: law = aging; one side"),
        (wide, "value_m at each law > -0.5", "one side has no certainly different values: law = aging."),
        (altered(4, 4, ""), "value_m at each law > -0.5", "a value is missing: law = aging."),
    ] {
        let (verdict, told) = of(&lines, text);
        assert_eq!(verdict, Verdict::NotChecked, "{text}");
        assert!(told.contains(&format!("it is open; the first: {reason}")), "{text}: {told}");
    }
    let refuted = of(&wide, "value_m at each law > 0.5");
    let told = "false in 1 of 2 groups of rows; the first: 0.4472: law = slip";
    assert_eq!(refuted, (Verdict::Fails, told.to_owned()));
}

#[test]
fn the_row_of_an_extreme_value_is_the_one_that_has_it() {
    let found = found_on(&GRID, "largest value_m at x = 1 within 0.1 at each law", Kind::Universal);
    let told = "false in 1 of 2 groups of rows; the first: at 2: law = slip, x = 2, y = 2, value_m = 40";
    assert_eq!(found.counter_example.as_deref(), Some(told));
    let found = found_on(&GRID, "least value_m at y = 2 within 0.1 at each law", Kind::Universal);
    assert!(found.counter_example.unwrap().ends_with("at 1: law = slip, x = 1, y = 1, value_m = 10"));
}

#[test]
fn numbers_are_rounded_to_their_side_and_left_out_where_they_are_open() {
    let numbers = found_on(&altered(3, 4, "40.05"), "count = 8", Kind::Universal).numbers;
    assert_eq!((&numbers["most"][..], &numbers["cycles"][..], &numbers["count"][..]), ("40", "7", "8"));
    assert_eq!(found_on(&altered(3, 4, ""), "count = 8", Kind::Universal).numbers["most"], "40");
    let open = found_on(&altered(5, 7, ""), "count = 8", Kind::Universal).numbers;
    assert_eq!(open["cycles"], "6");
    let mut failed = altered(5, 7, "");
    failed[5][9] = "no result";
    assert_eq!(found_on(&failed, "count = 8", Kind::Universal).numbers.get("cycles"), None);
}

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n[simulations]\n\
    loading_velocity_m_per_s = { from = 1e-4, to = 1e-3, points = 2 }\n\
    normal_stress_pa = { from = 1e5, to = 2e5, points = 2 }\nlaws = [\"slip\"]\ntolerance = 1e-8\n";

/// Four stick-slip cycles with their certificates; `alter` changes these before the statement sees them.
fn on_cycles(alter: impl FnOnce(&mut Certificates)) -> Finding {
    static UNALTERED: OnceLock<Outcome> = OnceLock::new();
    let certified = || {
        let scene = Scene::parse("s.toml", SCENE.as_bytes(), &Limits::default()).unwrap();
        let rows = certify_grid(&paper(), scene.simulations.as_ref().unwrap(), EvolutionLaw::Slip);
        let mut outcome = run(&[scene], &[Need::Simulations].into(), &References::default(), &|_, _, _| {});
        outcome.scenes[0].certificates = Some(Certificates::of(vec![rows], 1));
        outcome
    };
    let mut outcome = UNALTERED.get_or_init(certified).clone();
    alter(outcome.scenes[0].certificates.as_mut().unwrap());
    let text = "between neighbours along normal_stress_pa at each scene, law, loading_velocity_m_per_s where cycle = 'stick-slip': stress_drop_pa rises and period_s rises";
    let rows = OverRows {
        table: "simulations".into(),
        numbers: BTreeMap::new(),
        at_least: 0,
        extent: Some("{count} pairs".into()),
    };
    super::decide(&rows, text, &Context::new(&Equations::default(), &outcome))
}

#[test]
fn certificates_of_cycles_decide_and_what_is_wrong_with_one_leaves_the_statement_open() {
    let all = on_cycles(|_| {});
    assert_eq!(
        (all.verdict, all.strength, all.limit.as_deref()),
        (Verdict::Holds, Some(Strength::Certified), Some("2 pairs"))
    );
    let one_less = on_cycles(|all| all.rows[3].certificate = Err("because".into()));
    assert_eq!((one_less.verdict, one_less.strength), (Verdict::Holds, Some(Strength::Converged)));
    let moved = on_cycles(|all| {
        let proof = all.rows[0].certificate.as_mut().unwrap();
        proof.peak_velocity_m_per_s = proof.peak_velocity_m_per_s.map(|end| 1.001 * end);
    });
    assert_eq!(moved.verdict, Verdict::NotChecked);
    assert!(moved.remarks[0].contains("differs from its certificate"), "{moved:?}");
    let refused = on_cycles(|all| all.again[0].refusal = Some("because".into()));
    assert_eq!(refused.verdict, Verdict::NotChecked);
    assert!(refused.remarks[0].ends_with("is not proved again: because."), "{refused:?}");
}
