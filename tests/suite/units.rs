//! Numbers with units, wherever a number goes in: converted exactly, repeated in SI, and refused by name where they do not fit.

use serde_json::Value;

use crate::harness::{HEADER, Workplace};

/// A lab's slider at 5 MPa and 10 um/s, with the units of a lab book and in SI.
const LAB: [&str; 14] = [
    "-a",
    "0.009",
    "-b",
    "0.0126",
    "-d",
    "8um",
    "-k",
    "2MPa/mm",
    "-m",
    "12kg/50cm2",
    "-s",
    "5 MPa",
    "-v",
    "10µm/s",
];
const IN_SI: [&str; 14] =
    ["-a", "0.009", "-b", "0.0126", "-d", "8e-6", "-k", "2e9", "-m", "2400", "-s", "5e6", "-v", "1e-5"];

/// The lines that a command writes of the values of [`LAB`] that have a unit.
const ECHOED: [&str; 5] = [
    "in SI: --critical-slip-distance-m = 8um: 8e-6 m",
    "in SI: --stiffness-pa-per-m = 2MPa/mm: 2e9 Pa/m",
    "in SI: --mass-per-area-kg-per-m2 = 12kg/50cm2: 2400 kg/m^2",
    "in SI: --normal-stress-pa = 5 MPa: 5e6 Pa",
    "in SI: --loading-velocity-m-per-s = 10µm/s: 1e-5 m/s",
];

fn with(command: &[&'static str], rest: &[&'static str]) -> Vec<&'static str> {
    [command, rest].concat()
}

#[test]
fn every_command_that_takes_the_slider_takes_units_and_repeats_the_values_in_si() {
    let place = Workplace::new();
    let (lab, in_si) = (&LAB[..], &IN_SI[..]);
    for (command, values) in [
        (&["classify", "--json"][..], 14),
        (&["roots", "--json"], 14),
        (&["simulate", "--law", "slip", "--json"], 14),
        (&["boundary", "--points", "3"], 10),
        (&["tolerance", "--json"], 10),
        (&["solve", "--for", "loading-velocity", "--transition"], 12),
    ] {
        let ended = place.run(with(command, &lab[..values]));
        let plain = place.run(with(command, &in_si[..values])).expect_success();
        assert_eq!((ended.code, &ended.stdout), (0, &plain), "{command:?}");
        let echoed: Vec<&str> = ended.stderr.lines().collect();
        assert_eq!(echoed, ECHOED[..(values - 4) / 2], "{command:?}");
    }
}

#[test]
fn options_beside_the_slider_take_units_too() {
    let place = Workplace::new();
    let material = &IN_SI[..10];
    for (with_units, plain) in [
        (
            &["solve", "--for", "normal-stress", "-v", "1e-5", "--frequency", "0.1Hz"][..],
            &["solve", "--for", "normal-stress", "-v", "1e-5", "--frequency", "0.1"][..],
        ),
        (
            &["solve", "--for", "loading-velocity", "-s", "5MPa", "--growth-rate", "-0.06/min"],
            &["solve", "--for", "loading-velocity", "-s", "5e6", "--growth-rate", "-0.001"],
        ),
        (&["boundary", "--at-velocity", "1mm/s"], &["boundary", "--at-velocity", "1e-3"]),
        (&["boundary", "--at-normal-stress", "0.1MPa"], &["boundary", "--at-normal-stress", "1e5"]),
        (
            &["classify", "--grid-loading-velocity", "1um/s:10mm/s:5", "--grid-normal-stress", "1kPa:1e7:5"],
            &["classify", "--grid-loading-velocity", "1e-6:1e-2:5", "--grid-normal-stress", "1e3:1e7:5"],
        ),
    ] {
        let [ended, plain] = [with_units, plain].map(|command| place.run(with(command, material)));
        assert_eq!((ended.code, &ended.stdout), (0, &plain.stdout), "{with_units:?}: {}", ended.stderr);
    }
}

#[test]
fn a_value_that_is_no_decimal_in_si_is_taken_exactly() {
    let place = Workplace::new();
    // 31 557.6 um a year are exactly 1 nm/s; 35 mm a year are no decimal in m/s.
    let at = |velocity| [&["classify", "--json"], &IN_SI[..12], &["-v", velocity]].concat();
    let [year, second] = ["31557.6um/yr", "1nm/s"].map(|velocity| place.run(at(velocity)).stdout);
    assert_eq!(year, second);
    let plate = place.run(at("35mm/yr"));
    assert!(
        plate.stderr.contains("--loading-velocity-m-per-s = 35mm/yr: 7/6311520000 m/s"),
        "{}",
        plate.stderr
    );
    // The nearest number of 64 bits to 7/6311520000.
    assert!(plate.stdout.contains("\"loading_velocity_m_per_s\": 1.1090830734910133e-9"), "{}", plate.stdout);
}

#[test]
fn the_object_repeats_the_inputs_in_si_as_numbers() {
    let place = Workplace::new();
    for command in [&["classify", "--json"][..], &["solve", "--for", "mass", "--transition", "--json"]] {
        let values = if command[0] == "solve" { [&LAB[..8], &LAB[10..]].concat() } else { LAB.to_vec() };
        let ended = place.run([command, &values].concat());
        let json: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert_eq!(json["schema"], 1);
        let mut wanted = serde_json::json!({
            "direct_effect": 0.009, "evolution_effect": 0.0126, "critical_slip_distance_m": 8e-6,
            "stiffness_pa_per_m": 2e9, "mass_per_area_kg_per_m2": 2400.0, "normal_stress_pa": 5e6,
            "loading_velocity_m_per_s": 1e-5,
        });
        if command[0] == "solve" {
            wanted.as_object_mut().unwrap().remove("mass_per_area_kg_per_m2");
        }
        assert_eq!(json["inputs"], wanted);
    }
}

#[test]
fn units_of_another_dimension_are_refused_by_name_all_at_once() {
    let place = Workplace::new();
    let wrong = [
        "-a", "9mm", "-b", "0.0126Pa", "-d", "8MPa", "-k", "35kN/mm", "-m", "12kg", "-s", "5mPa", "-v",
        "10um",
    ];
    let parts = [
        "--direct-effect = 9mm: mm is a length; this number has no unit",
        "--evolution-effect = 0.0126Pa: Pa is a stress; this number has no unit",
        "--critical-slip-distance-m = 8MPa: MPa is a stress; length is m",
        "--stiffness-pa-per-m = 35kN/mm: kN/mm is a stiffness; stiffness per area is Pa/m: divide by the area",
        "--mass-per-area-kg-per-m2 = 12kg: kg is a mass; mass per area is kg/m^2: divide by the area",
        "--normal-stress-pa = 5mPa: \"mPa\" is no unit here; did you mean `MPa`?",
        "--loading-velocity-m-per-s = 10um: um is a length; velocity is m/s",
    ];
    place.run(with(&["classify"], &wrong)).expect_refusal(&parts);
    let solve = ["solve", "--for", "stiffness", "--frequency", "10s"];
    place
        .run([&solve[..], &IN_SI[..6], &IN_SI[8..]].concat())
        .expect_refusal(&["--frequency = 10s: s is a time; frequency is 1/s"]);
}

#[test]
fn error_bars_take_units() {
    let place = Workplace::new();
    let point = |stress| [&["classify", "--json"], &IN_SI[..10], &["-s", stress, "-v", "1e-5"]].concat();
    for (with_unit, echoed) in [
        ("5±0.1MPa", "in SI: --normal-stress-pa = 5±0.1MPa: 4.9e6 to 5.1e6 Pa\n"),
        ("[4900kPa, 5.1MPa]", "in SI: --normal-stress-pa = [4900kPa, 5.1MPa]: 4.9e6 to 5.1e6 Pa\n"),
    ] {
        let ended = place.run(point(with_unit));
        assert_eq!((ended.code, ended.stderr.as_str()), (0, echoed));
        assert_eq!(ended.stdout, place.run(point("5e6±1e5")).expect_success());
    }
    place
        .run(point("5±0.1mm"))
        .expect_refusal(&["--normal-stress-pa = \"5±0.1mm\": mm is a length; stress is Pa"]);
    place.write(
        "lab.csv",
        "a,b,d_c_um,k,m,sigma_mpa,v,sigma_mpa_error\n0.009,0.0126±0.0007,8,2e9,2400,5,1e-5,0.1\n",
    );
    place.write("si.csv", format!("{HEADER}\n0.009,0.0126±0.0007,8e-6,2e9,2400,5e6±1e5,1e-5\n"));
    let appended = ["lab.csv", "si.csv"].map(|file| {
        let rows = place.run(["classify", "--points", file]).stdout;
        rows.lines().nth(1).unwrap().rsplit_once("1e-5,").unwrap().1.trim_start_matches("0.1,").to_string()
    });
    assert_eq!(appended[0], appended[1]);
}

#[test]
fn a_unit_that_was_given_is_not_doubted() {
    let place = Workplace::new();
    let slow = [&["classify"], &IN_SI[..4], &["-d", "1cm"], &IN_SI[6..]].concat();
    let ended = place.run(slow);
    assert_eq!((ended.code, ended.stderr.lines().count()), (0, 1), "{}", ended.stderr);
    let ended = place.run([&["classify"], &IN_SI[..4], &["-d", "0.01"], &IN_SI[6..]].concat());
    assert!(ended.stderr.contains("looks like mm or um"), "{}", ended.stderr);
}

#[test]
fn columns_may_be_in_any_unit_and_under_their_symbols() {
    let place = Workplace::new();
    place.write("si.csv", format!("{HEADER},law\n0.009,0.0126,8e-6,2e9,2400,5e6,1e-5,slip\n"));
    for header in [
        "direct_effect,evolution_effect,critical_slip_distance_um,stiffness_mpa_per_mm,mass_per_area_kg_per_cm2,\
         normal_stress_mpa,loading_velocity_um_per_s,law",
        "a,b,d_c_um,k_mpa_per_mm,m_kg_per_cm2,sigma_mpa,v_0_um_per_s,law",
        " A , B,Dc [um], K [MPa/mm],M (kg/cm2),Sigma_MPa,V0 [um/s], LAW",
    ] {
        place.write("lab.csv", format!("{header}\n0.009,0.0126,8,2,0.24,5,10,slip\n"));
        for command in [&["classify"][..], &["simulate"], &["solve", "--for", "mass", "--transition"]] {
            let [lab, plain] =
                ["lab.csv", "si.csv"].map(|file| place.run([command, &["--points", file]].concat()));
            assert_eq!(lab.code, 0, "{}", lab.stderr);
            let appended =
                |text: &str| text.lines().nth(1).unwrap().split_once("slip,").unwrap().1.to_string();
            assert_eq!(appended(&lab.stdout), appended(&plain.stdout), "{header}");
            assert!(lab.stdout.starts_with(header.split(',').next().unwrap()), "input columns are kept");
            assert!(lab.stderr.contains(": stiffness_pa_per_m times 1e9"), "{}", lab.stderr);
        }
    }
    let faulty = "a,b,dc_um,k_mpa,m_kg,sigma_mpa,normal_stress_kpa,v\n1,1,1,1,1,1,1,1\n";
    place.write("lab.csv", faulty);
    place.run(["classify", "--points", "lab.csv"]).expect_refusal(&[
        "lab.csv:1: header, column k_mpa: MPa is a stress; stiffness per area is Pa/m (allowed: stiffness_pa_per_m, k;",
        "lab.csv:1: header, column m_kg: kg is a mass; mass per area is kg/m^2: divide by the area",
        "lab.csv:1: header, column normal_stress_kpa: `sigma_mpa` gives normal_stress_pa too; keep one of them",
    ]);
}

#[test]
fn a_cell_is_checked_in_si() {
    let place = Workplace::new();
    let header = "a,b,d_c_um,k,m,sigma,v";
    place.write("lab.csv", format!("{header}\n0.009,0.0126,1e-299,2e9,2400,5e6,1e-5\n"));
    let parts = ["row 1, column d_c_um = 1e-299: out of range (allowed: 1e-300 to 1e300)"];
    place.run(["classify", "--points", "lab.csv"]).expect_refusal(&parts);
}

#[test]
fn scenes_take_numbers_with_units() {
    let place = Workplace::new();
    let scene = |d: &str, k: &str, m: &str, from: &str, to: &str, stress: &str| {
        format!(
            "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.009\nevolution_effect = 0.0126\n\
             critical_slip_distance_m = {d}\nstiffness_pa_per_m = {k}\nmass_per_area_kg_per_m2 = {m}\n[map]\n\
             loading_velocity_m_per_s = {{ from = {from}, to = {to}, points = 5 }}\n\
             normal_stress_pa = {{ from = {stress}, to = 1e8, points = 5 }}\n"
        )
    };
    place.write("si.toml", scene("8e-6", "2e9", "2400", "1e-6", "1e-2", "1e3"));
    let with_units = scene("\"8um\"", "\"2MPa/mm\"", "\"12kg/50cm2\"", "\"1um/s\"", "\"1 cm/s\"", "\"1kPa\"");
    place.write("lab.toml", with_units);
    place.run(["run", "si.toml", "-o", "si"]).expect_success();
    place.run(["run", "lab.toml", "-o", "lab"]).expect_success();
    let figure = "figures/criticality.svg";
    assert_eq!(place.read(&format!("lab/{figure}")), place.read(&format!("si/{figure}")));
    place.write("bad.toml", scene("\"8MPa\"", "\"2MPa\"", "2400", "\"1um\"", "1e-2", "1e3"));
    place.run(["run", "bad.toml", "-o", "bad"]).expect_refusal(&[
        "bad.toml:6: parameters.critical_slip_distance_m = \"8MPa\": MPa is a stress; length is m",
        "bad.toml:7: parameters.stiffness_pa_per_m = \"2MPa\": MPa is a stress; stiffness per area is Pa/m",
        "bad.toml:10: map.loading_velocity_m_per_s.from = \"1um\": um is a length; velocity is m/s",
    ]);
}
