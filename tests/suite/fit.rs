//! `fit`: records of velocity steps, with the values that an independent program finds in them, and records that cannot be fitted.

use serde_json::Value;

use crate::harness::Workplace;

const BASALT: &str = include_str!("../data/records/basalt-step.csv");
const BASALT_OPTIONS: [&str; 5] = ["-s", "1.9967e7", "--drift", "--law", "aging"];
const SYNTHETIC: &str = include_str!("../data/synthetic_records.csv");
const WRONG: &str = include_str!("../data/bad_records.csv");

/// The rows of a table with a header.
fn table(text: &str) -> Vec<csv::StringRecord> {
    csv::Reader::from_reader(text.as_bytes()).records().map(Result::unwrap).collect()
}

fn data(place: &Workplace, folder: &str, name: &str) {
    let path = format!("{}/tests/data/{folder}/{name}", env!("CARGO_MANIFEST_DIR"));
    place.write(name, std::fs::read_to_string(path).unwrap());
}

fn object(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn number(answer: &Value, parameter: &str, key: &str) -> f64 {
    answer[parameter][key].as_f64().unwrap_or_else(|| panic!("{parameter} {key}: {answer}"))
}

#[test]
fn every_wrong_record_gets_a_message_and_leaves_nothing() {
    let place = Workplace::new();
    let rows = table(WRONG);
    assert!(rows.len() > 30);
    for row in &rows {
        data(&place, "bad_records", &row[0]);
        let options = row[1].split_whitespace().chain(["-o", "out.csv", "--svg", "out.svg"]);
        let words: Vec<&str> = row[2].split('|').collect();
        place.run(["fit", &row[0]].into_iter().chain(options)).expect_refusal(&words);
        std::fs::remove_file(place.path(&row[0])).unwrap();
    }
    assert_eq!(place.names(), [""; 0]);
}

#[test]
fn values_are_those_of_an_independent_fit() {
    let place = Workplace::new();
    let rows = table(SYNTHETIC);
    assert!(rows.len() > 20);
    // A row for each parameter: record, options, parameter, truth, value and standard error of the independent fit.
    for rows in rows.chunk_by(|one, other| one[0] == other[0]) {
        data(&place, "synthetic_records", &rows[0][0]);
        let options = rows[0][1].split_whitespace().chain(["--json"]);
        let answer = object(&place.run(["fit", &rows[0][0]].into_iter().chain(options)).expect_success());
        for row in rows {
            let [truth, value, error] = [3, 4, 5].map(|index| row[index].parse::<f64>().unwrap());
            let [found, low, high] = ["value", "low", "high"].map(|key| number(&answer, &row[2], key));
            // Both searches end within 1e-6 of the optimum; that of the drift is counted in its errors.
            let apart = (found - value).abs();
            assert!(apart < 1e-6 * value.abs() || apart < 1e-4 * error, "{}: {row:?} {found}", &row[0]);
            assert!((number(&answer, &row[2], "error") / error - 1.0).abs() < 0.05, "{row:?}");
            // The truth lies within five standard errors; that 95 % of the intervals have it takes 500 records.
            assert!(
                low < found && found < high && (truth - found).abs() < 5.0 * error,
                "{row:?} {low} {high}"
            );
        }
    }
}

#[test]
fn a_public_record_has_correlated_residuals_and_wider_intervals() {
    let place = Workplace::new();
    place.write("basalt.csv", BASALT);
    let run =
        |more: &[&str]| place.run(["fit", "basalt.csv"].iter().chain(&BASALT_OPTIONS).chain(more).copied());
    let answer = object(&run(&["--json"]).expect_success());
    // By the independent program, tests/data/records/README.md.
    for (parameter, value, error) in [
        ("direct_effect", 0.00924, 0.00014),
        ("evolution_effect", 0.00915, 0.00014),
        ("critical_slip_distance_m", 6.0e-6, 0.14e-6),
        ("stiffness_pa_per_m", 147e9, 5e9),
    ] {
        assert!((number(&answer, parameter, "value") - value).abs() < 0.1 * error, "{answer}");
        assert!(number(&answer, parameter, "error") > 1.8 * error, "{parameter}");
    }
    assert!((answer["residual_autocorrelation"].as_f64().unwrap() - 0.69).abs() < 0.01);
    let text = run(&[]);
    assert!(text.stdout.contains("Neighbouring residuals are correlated, 0.69"), "{}", text.stdout);
    let one = run(&["--json", "--threads", "1"]);
    assert_eq!(one.stdout, run(&["--json", "--threads", "3"]).stdout);
    run(&["-o", "fitted.csv"]).expect_success();
    let fitted = place.read("fitted.csv");
    assert!(fitted.starts_with("time_s,load_point_displacement_m,friction,fitted_friction,residual\n"));
    assert_eq!(fitted.lines().count(), BASALT.lines().count());
}

#[test]
fn both_laws_are_compared_and_the_slip_mode_follows() {
    let place = Workplace::new();
    place.write("basalt.csv", BASALT);
    let arguments = ["fit", "basalt.csv", "-s", "1.9967e7", "--drift", "-m", "2400", "--json"];
    let answer = object(&place.run(arguments).expect_success());
    let comparison = &answer["law_comparison"];
    assert_eq!([&answer["law"], &comparison["other_law"]], ["slip", "aging"]);
    assert!(comparison["log_likelihood_ratio"].as_f64().unwrap() > 0.0);
    let shares = answer["slip_modes"].as_array().unwrap().iter().map(|mode| mode["share"].as_f64().unwrap());
    assert!((shares.sum::<f64>() - 1.0).abs() < 1e-12);
}

#[test]
fn the_report_of_a_fitted_slider_has_record_fit_and_profiles() {
    let place = Workplace::new();
    place.write("basalt.csv", BASALT);
    let arguments = ["fit", "basalt.csv", "-s", "1.9967e7", "--drift", "-m", "2400", "--into", "lab"];
    place.run(arguments).expect_success();
    place.run(["report", "lab"]).expect_success();
    let text = place.read("target/report/lab/ledger.md");
    for part in [
        "figures/fit-record.svg",
        "figures/fit-step.svg",
        "figures/fit-profiles.svg",
        "With the slip law the record gives a = ",
    ] {
        assert!(text.contains(part), "{part}");
    }
    let table = place.read("target/report/lab/tables/fit.csv");
    assert_eq!(table.lines().count(), 7, "{table}");
    // The folder is there: a second fit does not touch it.
    place.run(arguments).expect_refusal(&["lab: already exists"]);
}

#[test]
fn every_option_has_an_effect_on_the_answer_or_writes_its_file() {
    let place = Workplace::new();
    place.write("good.csv", include_str!("../data/bad_records/good.csv"));
    let run =
        |more: &[&str]| place.run(["fit", "good.csv", "-s", "5e6", "--json"].iter().chain(more).copied());
    let plain = run(&[]).expect_success();
    let mass = ["-m", "1e8"];
    let options: [&[&str]; 6] = [
        &["--law", "slip"],
        &["-s", "4e6"],
        &["-k", "1e9"],
        &mass,
        &["--drift"],
        &["-m", "1e8", "-v", "1e-3"],
    ];
    for option in options {
        // An option that is given twice is refused, so that the normal stress stands in place of the first one.
        let ended = match option {
            ["-s", stress] => place.run(["fit", "good.csv", "-s", *stress, "--json"]),
            _ => run(option),
        };
        assert_ne!(ended.expect_success(), plain, "{option:?}");
    }
    assert_ne!(run(&mass).expect_success(), run(&["-m", "1e8", "-v", "1e-3"]).expect_success());
    run(&["-o", "out.csv", "--svg", "out.svg"]).expect_success();
    assert!(place.read("out.svg").starts_with("<svg"));
    run(&["-o", "-"]).expect_refusal(&["--output = -: needs a file"]);
    for error_bar in ["20±1MPa", "[19,21]MPa", "20(1)MPa"] {
        run(&["-k", error_bar]).expect_refusal(&["takes no error bar"]);
    }
    run(&["--law", "rate"]).expect_refusal(&["slip, aging, both"]);
    let semicolons: String = place.read("good.csv").replace(',', ";");
    place.write("semicolons.csv", semicolons);
    let same =
        place.run(["fit", "semicolons.csv", "-s", "5e6", "--json", "--delimiter", ";"]).expect_success();
    assert_eq!(same, plain);
}
