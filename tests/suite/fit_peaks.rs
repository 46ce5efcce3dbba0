//! `fit --peaks`: (b − a)σ/√(KM) from peak velocities of stick-slip, and tables that cannot be fitted.

use serde_json::Value;

use crate::harness::Workplace;

/// Twelve experiments of `tests/independent/fit/peaks.py`: noisy peaks of simulated cycles, with options and truth.
const TABLES: &str = include_str!("../data/peak_tables.csv");
const HEADER: &str = "loading_velocity_m_per_s,peak_velocity_m_per_s,peak_velocity_error_m_per_s";

struct Experiment {
    law: String,
    options: Vec<String>,
    truth: f64,
    table: String,
}

fn experiments() -> Vec<Experiment> {
    let rows: Vec<csv::StringRecord> =
        csv::Reader::from_reader(TABLES.as_bytes()).records().map(Result::unwrap).collect();
    let of = |rows: &[csv::StringRecord]| {
        let first = &rows[0];
        let columns = if first[6].is_empty() { 2 } else { 3 };
        let line = |cells: Vec<&str>| format!("{}\n", cells[..columns].join(","));
        let table = rows.iter().map(|row| line(vec![&row[4], &row[5], &row[6]])).collect::<String>();
        Experiment {
            law: first[1].to_string(),
            options: first[2].split('|').filter(|option| !option.is_empty()).map(str::to_string).collect(),
            truth: first[3].parse().unwrap(),
            table: line(HEADER.split(',').collect()) + &table,
        }
    };
    rows.chunk_by(|one, other| one[0] == other[0]).map(of).collect()
}

fn answer(place: &Workplace, more: &[&str]) -> Value {
    let arguments = ["fit", "--peaks", "peaks.csv", "--json"].iter().chain(more).copied();
    serde_json::from_str(&place.run(arguments).expect_warnings()).unwrap()
}

fn interval(answer: &Value) -> [f64; 4] {
    ["value", "error", "low", "high"].map(|key| answer[key].as_f64().unwrap_or(0.0))
}

/// A table whose errors are stated, without options.
fn table_with_errors() -> Experiment {
    experiments().into_iter().find(|one| one.options.is_empty() && one.table.contains("error")).unwrap()
}

#[test]
fn intervals_contain_the_truth_of_simulated_experiments() {
    let place = Workplace::new();
    let experiments = experiments();
    assert_eq!(experiments.len(), 12);
    for one in &experiments {
        place.write("peaks.csv", &one.table);
        let options: Vec<&str> = one.options.iter().map(String::as_str).collect();
        let found = answer(&place, &options);
        let [value, error, low, high] = interval(&found["twice_v18_m_per_s"]);
        assert!(low < one.truth && one.truth < high, "{} {} {found}", one.law, one.truth);
        assert!(low < value && value < high && error > 0.0, "{found}");
        // With D_c the height of the peaks counts: the interval is narrower than the truth.
        assert!(options.len() < 4 || high - low < 0.8 * one.truth, "{found}");
    }
}

/// Peaks of simulated cycles as `simulate --points` writes them, with 2 V_18 = (b − a) · 1e6/1e5 m/s.
fn write_simulated(place: &Workplace, law: &str, evolution_effect: &str) {
    let mut table = "law,direct_effect,evolution_effect,critical_slip_distance_m,stiffness_pa_per_m,mass_per_area_kg_per_m2,normal_stress_pa,loading_velocity_m_per_s\n".to_string();
    for load in ["1e-6", "3e-6", "1e-5", "3e-5", "1e-4"] {
        table += &format!("{law},0.01,{evolution_effect},3e-6,1e7,1e3,1e6,{load}\n");
    }
    place.write("points.csv", &table);
    place.run(["simulate", "--points", "points.csv", "-o", "peaks.csv"]).expect_success();
}

#[test]
fn without_noise_each_law_gives_b_minus_a_over_the_whole_range_of_effect_ratios() {
    let place = Workplace::new();
    for law in ["slip", "aging"] {
        for (effect, ratio) in [("0.012", "1.2"), ("0.015", "1.5"), ("0.05", "5")] {
            write_simulated(&place, law, effect);
            let found = answer(&place, &["--law", law, "-k", "1e7", "-m", "1e3", "--effect-ratio", ratio]);
            let difference = effect.parse::<f64>().unwrap() - 0.01;
            for (key, size) in [
                ("twice_v18_m_per_s", 10.0),
                ("effect_difference_stress_pa", 1e6),
                ("effect_difference", 1.0),
            ] {
                let [value, _, low, high] = interval(&found[key]).map(|value| value / (size * difference));
                assert!((value - 1.0).abs() < 0.02 && low < 1.002 && high > 0.998, "{law} {ratio} {found}");
            }
        }
    }
}

#[test]
fn without_noise_the_laws_are_told_apart_and_each_unknown_has_its_part_of_the_error() {
    let place = Workplace::new();
    for law in ["slip", "aging"] {
        write_simulated(&place, law, "0.015");
        let known = ["-k", "1e7", "-m", "1e3", "--effect-ratio", "1.5"];
        let found = answer(&place, &known);
        assert_eq!(found["law"], law);
        let parts = &found["error_parts_m_per_s"];
        let width = |part: &str| parts[part][1].as_f64().unwrap() - parts[part][0].as_f64().unwrap();
        assert!(width("model") > 1e-5 && width("bandwidth") == 0.0, "{parts}");
        // The slip law follows peaks of the aging law with a wrong scale; the aging law has no such peaks as those of the slip law.
        match law {
            "aging" => {
                assert!(width("law") > 0.002 && found["law_comparison"]["tells_apart"] == true, "{found}")
            }
            _ => assert!(
                found["remarks"].to_string().contains("The aging law requires K/K_c,qs above 0.1"),
                "{found}"
            ),
        }
        let high = |found: &Value| interval(&found["twice_v18_m_per_s"])[3];
        let wider = answer(&place, &known[..4]);
        assert!(high(&wider) > high(&found), "{wider}");
        // f_n = 15.9 Hz: a bandwidth of three times as much hides 5.1 %.
        let hidden: Vec<&str> = known.into_iter().chain(["--bandwidth-hz", "47.746483"]).collect();
        let hidden = answer(&place, &hidden);
        assert!((high(&hidden) / high(&found) * 0.9f64.sqrt() - 1.0).abs() < 1e-6, "{hidden}");
        let slip_distance: Vec<&str> =
            known.into_iter().chain(["-d", "[2.9e-6,3.1e-6]", "--law", law]).collect();
        let [value, _, low, high] = interval(&answer(&place, &slip_distance)["twice_v18_m_per_s"]);
        assert!((value / 0.05 - 1.0).abs() < 0.02 && low < 0.0501 && high > 0.0499);
    }
}

#[test]
fn a_first_order_filter_takes_no_more_of_a_simulated_peak_than_its_bandwidth_permits() {
    let place = Workplace::new();
    let slider =
        "simulate -a 0.01 -b 0.015 -d 1e-5 -k 1e7 -m 1000 -s 1e6 -v 1e-4 --law slip --trajectory run.csv";
    place.run(slider.split(' ')).expect_success();
    let text = place.read("run.csv");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|column| column == name).unwrap();
    let [time, velocity] = ["time_s", "velocity_m_per_s"].map(column);
    let samples: Vec<[f64; 2]> = reader
        .records()
        .map(Result::unwrap)
        .map(|row| [time, velocity].map(|column| row[column].parse().unwrap()))
        .collect();
    let natural_hz = (1e7f64 / 1e3).sqrt() / std::f64::consts::TAU;
    for factor in [1.0, 3.0, 10.0] {
        let delay = 1.0 / (std::f64::consts::TAU * factor * natural_hz);
        let (mut seen, mut highest, mut peak) = (0.0f64, 0.0f64, 0.0f64);
        for pair in samples.windows(2) {
            let step = pair[1][0] - pair[0][0];
            // Velocities are taken as linear between samples, which lowers the peak a little.
            let (decay, slope) = ((-step / delay).exp(), (pair[1][1] - pair[0][1]) / step.max(1e-300));
            seen = pair[1][1] - slope * delay + (seen - pair[0][1] + slope * delay) * decay;
            highest = highest.max(seen);
            peak = peak.max(pair[1][1]);
        }
        let permitted = 1.0 - 1.0 / (1.0 + 1.0 / (factor * factor)).sqrt();
        let taken = 1.0 - highest / peak;
        assert!(taken < 1.01 * permitted && taken > 0.7 * permitted, "{factor}: {taken} {permitted}");
    }
}

#[test]
fn errors_are_read_in_any_usual_spelling_and_scatter_beyond_them_is_reported() {
    let place = Workplace::new();
    let one = table_with_errors();
    place.write("peaks.csv", &one.table);
    let plain = answer(&place, &[]);
    let in_percent = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let [peak, error] = [1, 2].map(|cell| cells[cell].parse::<f64>().unwrap());
        format!("{},{},{}\n", cells[0], cells[1], 100.0 * error / peak)
    };
    let rows: String = one.table.lines().skip(1).map(in_percent).collect();
    place.write(
        "peaks.csv",
        format!("V_l_m_per_s,v_peak_m_per_s,v_peak_error_percent\n{rows}").replace("V_l", "V0"),
    );
    let [value, low, high] = [0, 2, 3].map(|n| interval(&answer(&place, &[])["twice_v18_m_per_s"])[n]);
    let [known, _, lower, upper] = interval(&plain["twice_v18_m_per_s"]);
    assert!(
        [(value, known), (low, lower), (high, upper)]
            .iter()
            .all(|(one, other)| (one - other).abs() <= 1e-9 * other)
    );
    // A hundredth of the errors.
    let small = |line: &str| {
        let (rest, error) = line.rsplit_once(',').unwrap();
        format!("{rest},{:e}\n", 0.01 * error.parse::<f64>().unwrap())
    };
    place.write(
        "peaks.csv",
        format!("{HEADER}\n{}", one.table.lines().skip(1).map(small).collect::<String>()),
    );
    let text = place.run(["fit", "--peaks", "peaks.csv"]).expect_success();
    assert!(text.contains("times as much as their errors: the intervals are that much wider."), "{text}");
}

#[test]
fn tables_for_which_the_method_does_not_hold_are_refused_and_leave_nothing() {
    let place = Workplace::new();
    let header = "loading_velocity_m_per_s,peak_velocity_m_per_s";
    let rows = |rows: &[[&str; 2]]| {
        let rows: String = rows.iter().map(|row| format!("{}\n", row.join(","))).collect();
        format!("{header}\n{rows}")
    };
    let good = [["1e-5", "1.3"], ["3e-5", "1.24"], ["1e-4", "1.18"], ["3e-4", "1.12"], ["1e-3", "1.06"]];
    let with = |row: usize, cells: [&'static str; 2]| {
        let mut rows = good;
        rows[row] = cells;
        rows
    };
    let flat = good.map(|[load, _]| [load, "1.2"]);
    for (table, words) in [
        (rows(&good[..4]), "peaks.csv: 4 rows (wanted: at least 5)"),
        (rows(&good.map(|[_, peak]| ["1e-5", peak])), "span a factor of 1.000 (wanted: at least 3)"),
        (rows(&with(4, ["1e-2", "1.0"])), "row 5, column loading_velocity_m_per_s: 1e-2 m/s is"),
        (
            rows(&with(4, ["0.5", "1.06"])),
            "peaks.csv:6: row 5, column peak_velocity_m_per_s = 1.06: the peak velocity is 2.120 times",
        ),
        (rows(&with(2, ["1e-4", "-1.18"])), "peaks.csv:4: row 3, column peak_velocity_m_per_s"),
        (rows(&with(2, ["0", "1.18"])), "peaks.csv:4: row 3, column loading_velocity_m_per_s"),
        (rows(&with(2, ["1e-4", "NaN"])), "peaks.csv:4: row 3, column peak_velocity_m_per_s"),
        (rows(&flat), "the peaks do not fall as the load velocity rises"),
        ("peak_velocity_m_per_s\n1\n".into(), "loading_velocity_m_per_s: missing column"),
        (format!("{header},v0_error\n1e-5,1.3,1e-7\n"), "column v0_error"),
        (
            format!("{header},peak_velocity_error_m_per_s\n1e-5,1.3,0\n"),
            "an error is above 0 and below its value",
        ),
    ] {
        place.write("peaks.csv", &table);
        place
            .run(["fit", "--peaks", "peaks.csv", "-o", "out.csv", "--svg", "out.svg"])
            .expect_refusal(&[words]);
    }
    place.write("peaks.csv", rows(&good));
    for (options, words) in [
        ("--effect-ratio 1.1", "--effect-ratio = 1.1"),
        ("--effect-ratio [2,1.5]", "reversed range"),
        ("-k 1e7", "--peaks: needs both of -k and -m, or neither"),
        ("-s 1e6", "--normal-stress-pa: "),
        ("-d 1e-5", "--stiffness-pa-per-m"),
        ("--bandwidth-hz 100", "--stiffness-pa-per-m"),
        ("--bandwidth-hz 0 -k 1e7 -m 1e3", "--bandwidth-hz = 0"),
        ("-d 1 -k 1e7 -m 1e3", "the peaks are not those of deep stick-slip"),
        ("--drift", "--drift"),
        ("-v 1e-3 -m 1e3", "--loading-velocity-m-per-s"),
        ("--into lab -m 1e3", "--into"),
        ("--law rate", "--law = rate"),
    ] {
        let arguments = ["fit", "--peaks", "peaks.csv"].into_iter().chain(options.split(' '));
        place.run(arguments).expect_refusal(&[words]);
    }
    place.run(["fit", "peaks.csv", "--effect-ratio", "2"]).expect_refusal(&["--peaks"]);
    assert_eq!(place.names(), ["peaks.csv"]);
}

#[test]
fn the_files_have_every_row_and_do_not_depend_on_threads() {
    let place = Workplace::new();
    let one = table_with_errors();
    place.write("peaks.csv", &one.table);
    place.run(["fit", "--peaks", "peaks.csv", "-o", "out.csv", "--svg", "out.svg"]).expect_success();
    let found = place.read("out.csv");
    assert_eq!(found.lines().count(), one.table.lines().count());
    assert!(found.starts_with(
        "loading_velocity_m_per_s,peak_velocity_m_per_s,fitted_peak_velocity_m_per_s,residual_m_per_s\n"
    ));
    let picture = place.read("out.svg");
    for label in ["measured", "slip law", "aging law", "lower end", "upper end"] {
        assert!(picture.contains(label), "{label}");
    }
    let of = |threads: &str| {
        place.run(["fit", "--peaks", "peaks.csv", "--json", "--threads", threads]).expect_success()
    };
    assert_eq!(of("1"), of("3"));
}
