//! Bands: the boundary and the transition over error bars, as rows, on maps, and on the pages of scenes with error bars.

use serde_json::Value;

use crate::harness::Workplace;

const LAB: [&str; 10] =
    ["-a", "0.009±0.0002", "-b", "0.0126±0.0004", "-d", "[7.8e-6, 8.2e-6]", "-k", "2e9", "-m", "2400"];

const SCENE: &str = "name = \"mine\"\ntitle = \"Mine\"\n\n[parameters]\ndirect_effect = \"0.009±0.0002\"\n\
    evolution_effect = \"0.0126+-0.0004\"\ncritical_slip_distance_m = \"[7.8, 8.2]um\"\nstiffness_pa_per_m = 2e9\n\
    mass_per_area_kg_per_m2 = 2400\nnormal_stress_pa = \"6MPa±0.1MPa\"\nloading_velocity_m_per_s = 1e-5\n";

const MAP: &str = "\n[boundary]\npoints = 20\ndigits = 10\n\n[map]\n\
    loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 9 }\nnormal_stress_pa = { from = 1e4, to = 1e9, points = 9 }\n";

#[test]
fn rows_of_the_boundary_are_the_ranges_that_solve_gives() {
    let place = Workplace::new();
    let command = ["boundary", "--json", "--at-velocity", "1e-5"].into_iter().chain(LAB);
    let found: Value = serde_json::from_str(&place.run(command).expect_success()).unwrap();
    assert_eq!(found["inputs"]["critical_slip_distance_m"], serde_json::json!([7.8e-6, 8.2e-6]));
    let rows = found["ranges"].as_array().unwrap();
    let of = |line: &str| rows.iter().filter(|row| row["line"] == line).collect::<Vec<_>>();
    assert_eq!((of("boundary").len(), of("transition").len(), rows.len()), (3, 1, 4));
    for line in ["boundary", "transition"] {
        let target = format!("--{line}");
        let question = ["solve", "--json", "--for", "normal-stress", &target, "-v", "1e-5"];
        let answer = place.run(question.into_iter().chain(LAB)).expect_success();
        let answer: Value = serde_json::from_str(&answer).unwrap();
        let expected = answer["solutions"].as_array().unwrap();
        for (row, expected) in of(line).iter().zip(expected) {
            assert_eq!(row["normal_stress_pa"], expected["range"], "{line}");
        }
    }
    let at_stress = ["boundary", "--at-normal-stress", "5e6"].into_iter().chain(LAB);
    let rows = place.run(at_stress).expect_success();
    let lines: Vec<Vec<&str>> = rows.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines[0][..3], ["line", "loading_velocity_low_m_per_s", "loading_velocity_high_m_per_s"]);
    for row in &lines[1..] {
        assert_eq!(row[3..5], ["5e6", "5e6"]);
        let [low, high] = [row[1], row[2]].map(|cell| cell.parse::<f64>().unwrap());
        assert!(low < high, "{row:?}");
    }
}

#[test]
fn the_picture_has_bands_and_every_row_holds_what_classify_cannot_decide() {
    let place = Workplace::new();
    let command = ["boundary", "--points", "6", "--svg", "bands.svg"].into_iter().chain(LAB);
    let rows = place.run(command).expect_success();
    let svg = place.read("bands.svg");
    for word in ["class=\"boundary-band\"", "class=\"transition-band\"", "transition within the error bars"] {
        assert!(svg.contains(word), "{word}");
    }
    let mut tested = 0;
    for row in rows.lines().skip(1).filter(|row| !row.ends_with(',')) {
        let cells: Vec<&str> = row.split(',').collect();
        let [low, high] = [cells[5], cells[6]].map(|cell| cell.parse::<f64>().unwrap());
        let middle = format!("{:e}", (low * high).sqrt());
        let command = ["classify", "--json", "-s", &middle, "-v", cells[1]];
        // The fastest velocities get a warning that they look like um/s.
        let ended = place.run(command.into_iter().chain(LAB));
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        let found: Value = serde_json::from_str(&ended.stdout).unwrap();
        let signs = &found[format!("{}_signs", cells[0])];
        assert_eq!([signs[0].as_i64(), signs[1].as_i64()], [Some(-1), Some(1)], "{row}");
        tested += 1;
    }
    assert!(tested > 10, "{rows}");
    let digits = ["boundary", "--digits", "30"].into_iter().chain(LAB);
    place.run(digits).expect_refusal(&["--digits", "without error bars"]);
}

#[test]
fn a_scene_with_error_bars_has_bands_on_its_map_and_its_explorer() {
    let place = Workplace::new();
    place.write("mine.toml", format!("{SCENE}{MAP}"));
    place.run(["run", "mine.toml", "-o", "out"]).expect_success();
    let map = place.read("out/figures/fig-1.svg");
    assert!(map.contains("boundary-band") && map.contains("transition-band"));
    place.run(["explore", "mine.toml"]).expect_success();
    let page = place.read("mine.html");
    assert!(page.contains("boundary-band") && page.contains("hold for all values within the scene"));
    assert!(
        page.contains("underdamped oscillation or stick-slip"),
        "some combination has two possible modes"
    );
    place.write("bad.toml", SCENE.replace("±0.0002", "±0.2"));
    place
        .run(["explore", "bad.toml"])
        .expect_refusal(&["parameters.direct_effect", "not smaller than the value"]);
    let exact = "name = \"e\"\ntitle = \"E\"\n\n[parameters]\ndirect_effect = 0.009\nevolution_effect = 0.0126\n\
        critical_slip_distance_m = 8e-6\nstiffness_pa_per_m = 2e9\nmass_per_area_kg_per_m2 = 2400\n";
    place.write("e.toml", format!("{exact}{MAP}"));
    place.run(["run", "e.toml", "-o", "exact"]).expect_success();
    assert!(!place.read("exact/figures/fig-1.svg").contains("-band"));
}
