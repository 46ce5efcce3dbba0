//! Pictures, rows of grids and sampled trajectories of single commands, and the values that a lab looks for.

use serde_json::Value;

use crate::harness::{Ended, SLIDER, Workplace};

const POINT: [&str; 4] = ["-s", "1e5", "-v", "1e-3"];
const GRID: [&str; 4] = ["--grid-loading-velocity", "1e-6:1e-1:21", "--grid-normal-stress", "1e2:1e8:25"];

fn run(place: &Workplace, command: &[&str], more: &[&str]) -> Ended {
    place.run(command.iter().chain(&SLIDER).chain(more).copied())
}

/// Checks that a file is a picture with these words, and that nothing in it is no number.
fn check_picture(place: &Workplace, name: &str, words: &[&str]) {
    let svg = place.read(name);
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{name}");
    assert!(!svg.contains("NaN") && !svg.contains("inf\"") && svg.matches("<path").count() > 2, "{name}");
    for word in words {
        assert!(svg.contains(word), "{word} is not in {name}");
    }
}

#[test]
fn the_boundary_is_drawn_and_given_as_numbers() {
    let place = Workplace::new();
    let rows = run(&place, &["boundary", "--points", "9", "--svg", "b.svg"], &[]).expect_success();
    run(&place, &["boundary", "--svg", "all.svg"], &[]).expect_success();
    assert!(place.read("b.svg") == place.read("all.svg"), "the drawn line does not depend on --points");
    std::fs::remove_file(place.path("all.svg")).unwrap();
    check_picture(&place, "b.svg", &["cusp", "eqs 15, 16, 18 and 20", "Exact boundary of oscillation"]);
    let json = run(&place, &["boundary", "--points", "9", "--json"], &[]).expect_success();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&json["schema"], &json["inputs"]["stiffness_pa_per_m"]), (&1.into(), &1e7.into()));
    let points = json["points"].as_array().unwrap();
    assert_eq!(points.len(), rows.lines().count() - 1);
    for (line, point) in rows.lines().skip(1).zip(points) {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!((point["arc"].as_str(), point["asymptote"].as_str()), (Some(cells[0]), Some(cells[4])));
        for (key, cell) in [("normal_stress_pa", cells[2]), ("loading_velocity_m_per_s", cells[3])] {
            let (number, wanted) = (point[key].as_f64().unwrap(), cell.parse::<f64>().unwrap());
            assert!((number / wanted - 1.0).abs() < 1e-15, "{key}: {number} {wanted}");
        }
    }
    run(&place, &["boundary", "--svg", "c.svg", "--at-velocity", "1e-3"], &[])
        .expect_refusal(&["--svg: needs neither"]);
    run(&place, &["boundary", "--svg", "-"], &[]).expect_refusal(&["--svg = -: needs a file"]);
    assert_eq!(place.names(), ["b.svg"]);
}

#[test]
fn a_grid_gives_its_rows_and_its_map() {
    let place = Workplace::new();
    let counts = run(&place, &["classify", "-o", "map.csv", "--svg", "map.svg"], &GRID).expect_success();
    assert_eq!(counts, run(&place, &["classify"], &GRID).expect_success());
    check_picture(
        &place,
        "map.svg",
        &["stick-slip", "harmonic vibration", "overdamped stable sliding", "cusp"],
    );
    let rows = place.read("map.csv");
    let (head, rest) = rows.split_once('\n').unwrap();
    assert_eq!(rest.lines().count(), 21 * 25);
    // Each row is that of the same point in a file of points, up to the rounding of its coordinates to decimals.
    let points: String = rest
        .lines()
        .map(|line| {
            let (velocity, stress) = (line.split(',').next().unwrap(), line.split(',').nth(1).unwrap());
            format!("0.004,0.006,1e-5,1e7,1000,{stress},{velocity}\n")
        })
        .collect();
    place.write("in.csv", format!("a,b,dc,k,m,sigma,v0\n{points}"));
    let classified = place.run(["classify", "--points", "in.csv"]).stdout;
    let names = head.strip_prefix("loading_velocity_m_per_s,normal_stress_pa,").unwrap();
    assert!(classified.lines().next().unwrap().starts_with(&format!("a,b,dc,k,m,sigma,v0,{names},")));
    let kept = |line: &str, from: usize| line.split(',').skip(from).take(4).collect::<Vec<_>>().join(",");
    for (one, other) in rest.lines().zip(classified.lines().skip(1)) {
        assert_eq!(kept(one, 2), kept(other, 7));
    }
    let streamed = run(&place, &["classify", "-o", "-", "--threads", "3"], &GRID);
    assert_eq!((streamed.stdout, streamed.stderr), (rows, counts));
    run(&place, &["classify", "-o", "-", "--json"], &GRID).expect_refusal(&["--output = -: needs a file"]);
    run(&place, &["classify", "--svg", "x.svg"], &POINT)
        .expect_refusal(&["--svg: needs --grid-loading-velocity"]);
}

#[test]
fn a_trajectory_has_samples_slip_and_a_picture() {
    let place = Workplace::new();
    let slow = ["-s", "1e6", "-v", "1e-5", "--law", "slip"];
    let command = ["simulate", "--json", "--trajectory", "run.csv", "--samples", "2001", "--svg", "run.svg"];
    let found: Value = serde_json::from_str(&run(&place, &command, &slow).expect_success()).unwrap();
    assert_eq!((&found["law"], &found["tolerance"]), (&"slip".into(), &1e-8.into()));
    check_picture(&place, "run.svg", &["Velocity", "Slip", "Simulated run"]);
    let text = place.read("run.csv");
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 2001);
    let (end, period) = (rows[2000][0], found["period_s"].as_f64().unwrap());
    assert!((end / (10.0 * period) - 1.0).abs() < 1e-12);
    for (index, row) in rows.iter().enumerate() {
        assert!((row[0] - end * index as f64 / 2000.0).abs() < 1e-9 * end, "{index}");
    }
    assert_eq!(rows[0][4], 0.0);
    assert!(rows.windows(2).all(|pair| pair[1][4] >= pair[0][4]), "the slider never moves back");
    // On the cycle the slip of a period is what loading moves in it; 200 samples make a period.
    let (slip, moved) = (rows[2000][4] - rows[1800][4], 1e-5 * period);
    assert!((slip / moved - 1.0).abs() < 1e-6, "{slip} {moved}");
    let streamed = run(&place, &["simulate", "--trajectory", "-", "--samples", "2001"], &slow);
    assert_eq!((streamed.code, streamed.stdout), (0, text));
    assert!(streamed.stderr.starts_with("mode                       periodic"), "{}", streamed.stderr);
    run(&place, &["simulate", "--samples", "5"], &slow)
        .expect_refusal(&["--samples = 5: needs --trajectory: "]);
    run(&place, &["simulate", "--trajectory", "-", "--json"], &slow)
        .expect_refusal(&["--trajectory = -: needs a file"]);
}

#[test]
fn the_frequency_stands_in_text_object_and_rows() {
    let place = Workplace::new();
    let json: Value =
        serde_json::from_str(&run(&place, &["classify", "--json"], &POINT).expect_success()).unwrap();
    let number = |key: &str| json[key].as_f64().unwrap();
    // The numbers nearest to the exact ones, to more digits 6.72043115929401970790 and 0.42225714317988059697.
    let frequency = 6.720431159294019;
    assert_eq!(number("frequency_hz"), frequency);
    // K/M is 1e4, so that ω_n is 100 1/s; K_c is 2.5e7.
    assert_eq!((number("natural_angular_frequency_per_s"), number("stiffness_over_critical")), (100.0, 0.4));
    assert_eq!(number("frequency_over_natural"), 0.4222571431798806);
    let text = run(&place, &["classify"], &POINT).expect_success();
    assert!(text.contains("\nfrequency                  6.72043 Hz  (max Im(s)/2 pi)\n"), "{text}");
    place.write(
        "in.csv",
        "a,b,dc,k,m,sigma,v0\n0.004,0.006,1e-5,1e7,1000,1e5,1e-3\n0.006,0.004,1e-5,1e7,1000,1e3,1e-5\n",
    );
    let rows = place.run(["classify", "--points", "in.csv"]).stdout;
    let cells = |row: usize| -> Vec<String> {
        rows.lines().nth(row).unwrap().split(',').skip(14).map(str::to_string).collect()
    };
    assert_eq!(
        cells(0),
        [
            "frequency_hz",
            "critical_stiffness_pa_per_m",
            "stiffness_over_critical",
            "frequency_over_natural",
            "undecided_share"
        ]
    );
    let ratio = number("frequency_over_natural");
    let wanted =
        [frequency.to_string(), "2.5e7".to_string(), "0.4".to_string(), ratio.to_string(), "0".to_string()];
    assert_eq!(cells(1), wanted);
    // For a > b there is no transition, and K_c is negative; this slider does not oscillate.
    let cells = cells(2);
    assert_eq!((cells[0].as_str(), cells[2].as_str(), cells[3].as_str()), ("0", "", "0"));
    assert!(cells[1].parse::<f64>().unwrap() < 0.0);
}
