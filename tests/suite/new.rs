//! `slipmode new` and `slipmode tolerance`: a folder that is a whole report, for every sign of a − b.

use std::fs;

use crate::harness::Workplace;

const REST: [&str; 6] = ["-d", "5e-6", "-k", "1e9", "-m", "300"];

fn new<'a>(name: &'a str, a: &'a str, b: &'a str) -> Vec<&'a str> {
    let mut arguments = vec!["new", name, "-a", a, "-b", b];
    arguments.extend(REST);
    arguments
}

#[test]
fn every_sign_of_a_minus_b_gives_a_report_with_the_verdicts_that_were_recorded() {
    let place = Workplace::new();
    for (name, a, b, has_transition) in [
        ("weak", "0.008", "0.012", true),
        ("equal", "0.01", "0.010", false),
        ("strong", "0.012", "0.008", false),
    ] {
        let said = place.run(new(name, a, b)).expect_success();
        assert!(said.ends_with(&format!("next: slipmode report {name}\n")), "{said}");
        let verified = place.run(["verify", name]).expect_success();
        assert!(verified.contains("0 not checked") && verified.contains("no published copy"), "{verified}");
        assert!(place.read(&format!("target/report/{name}/index.html")).contains("<html"));
        let scene = place.read(&format!("{name}/scenes/{name}.toml"));
        assert_eq!(scene.contains("\n[frequency]\n"), has_transition, "{scene}");
        assert_eq!(scene.contains("# [frequency] is left out: it needs the critical"), !has_transition);
        let claims = place.read(&format!("{name}/claims.toml"));
        for (id, listed) in [
            ("N1", has_transition),
            ("S4", has_transition),
            ("N9", name == "strong"),
            ("B5", true),
            ("F1", true),
        ] {
            assert_eq!(claims.contains(&format!("id = \"{id}\"\n")), listed, "{name} {id}");
        }
    }
    assert!(place.names().iter().all(|name| !name.starts_with('.')), "{:?}", place.names());
}

#[test]
fn numbers_stand_in_the_scene_as_they_were_typed() {
    let place = Workplace::new();
    let typed = [
        "new", "typed", "-a", "0.0040", "-b", ".006", "-d", "10E-6", "-k", "010e6", "-m", "1000", "-o",
        "deep/er",
    ];
    place.run(typed).expect_success();
    let scene = place.read("deep/er/scenes/typed.toml");
    for line in [
        "direct_effect = 0.0040  #",
        "evolution_effect = \".006\"  #",
        "critical_slip_distance_m = 10E-6  #",
        "stiffness_pa_per_m = \"010e6\"  #",
        "mass_per_area_kg_per_m2 = 1000  #",
    ] {
        assert!(scene.contains(line), "{line}: {scene}");
    }
    assert!(place.run(["report", "deep/er"]).expect_success().contains("target/report/typed/index.html"));
}

#[test]
fn an_operating_point_stands_in_the_first_sentence_and_on_the_maps() {
    let place = Workplace::new();
    let lab = ["new", "lab", "-a", "0.009", "-b", "0.0126", "-d", "8um", "-k", "2MPa/mm", "-m", "12kg/50cm2"];
    assert_eq!(place.run([&lab[..], &["-s", "5MPa", "-v", "10um/s"]].concat()).code, 0);
    let scene = place.read("lab/scenes/lab.toml");
    for line in [
        "critical_slip_distance_m = \"8um\"  #",
        "normal_stress_pa = \"5MPa\"  #",
        "loading_velocity_m_per_s = \"10um/s\"  #",
    ] {
        assert!(scene.contains(line), "{line}: {scene}");
    }
    assert!(place.read("lab/prose/introduction.md").contains("| 8e-6 | m |"));
    place.run(["report", "lab"]).expect_success();
    let page = place.read("target/report/lab/ledger.md");
    let said = "At 5 MPa and 10 µm/s, the slip mode is stick-slip: sliding is linearly unstable (K/K_c is 0.889), and small disturbances oscillate with 0.119 Hz.";
    assert!(
        page.contains(&format!("\n1. {said}\n2. At 10 µm/s, sliding is unstable above 4.44 MPa;")),
        "{page}"
    );
    let map = place.read("target/report/lab/figures/operating-map.svg");
    assert!(map.contains("operating point") && map.contains("transition"), "{map}");
    let explored = place.run(["explore", "lab/scenes/lab.toml", "-s", "1kPa", "-v", "1um/s"]);
    assert_eq!((explored.code, explored.stdout.as_str()), (0, "lab.html\n"), "{}", explored.stderr);
    let explored = place.read("lab.html");
    assert!(explored.contains("operating point") && explored.contains(" -s 1kPa -v 1um/s"), "the command");
    place
        .run([&lab[..2], &lab[2..], &["-s", "5MPa"]].concat())
        .expect_refusal(&["--loading-velocity-m-per-s: missing"]);
    place
        .run(["explore", "lab/scenes/lab.toml", "-v", "1MPa"])
        .expect_refusal(&["MPa is a stress", "--normal-stress-pa: missing"]);
}

#[test]
fn a_verdict_that_was_edited_is_drift() {
    let place = Workplace::new();
    place.run(["new", "example"]).expect_success();
    assert!(place.read("example/scenes/example.toml").contains("these are the paper's"));
    let claims = place.read("example/claims.toml");
    let edited = claims.replacen("expected = \"holds\"", "expected = \"fails\"", 1);
    fs::write(place.path("example/claims.toml"), edited).unwrap();
    let ended = place.run(["verify", "example"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.contains("recorded fails, now holds"), "{}", ended.stderr);
}

/// Without F1 and F3 among the claims, F2 and L1 used to hold of a law that does not rest at D_c/V.
#[test]
fn a_law_that_was_changed_is_drift_in_every_claim_about_its_steady_state() {
    let place = Workplace::new();
    place.run(["new", "example"]).expect_success();
    let equations = place.read("example/equations.toml");
    let changed = equations.replacen("theta' = 1 - V*theta/D_c", "theta' = 2 - V*theta/D_c", 1);
    assert_ne!(equations, changed);
    fs::write(place.path("example/equations.toml"), changed).unwrap();
    let ended = place.run(["verify", "example"]);
    assert_eq!(ended.code, 1);
    for id in ["F1", "F2", "F3", "L1", "L3"] {
        assert!(ended.stderr.contains(&format!("{id}: recorded holds, now fails")), "{id}: {}", ended.stderr);
    }
}

#[test]
fn a_place_that_is_taken_and_a_name_that_is_unsafe_are_refused() {
    let place = Workplace::new();
    place.write("taken/keep.txt", "mine");
    place.run(new("taken", "0.01", "0.02")).expect_refusal(&["taken: already exists; choose another folder"]);
    fs::create_dir(place.path("empty")).unwrap();
    place.run(new("empty", "0.01", "0.02")).expect_refusal(&["empty: already exists; choose another folder"]);
    for name in ["../up", "a b", "", "CON", "-x", "é", ".hidden"] {
        place.run(new(name, "0.01", "0.02")).expect_refusal(&["NAME = "]);
    }
    assert_eq!(place.names(), ["empty", "taken"]);
    assert_eq!(place.read("taken/keep.txt"), "mine");
}

#[test]
fn every_number_that_is_missing_or_faulty_is_told_at_once() {
    let place = Workplace::new();
    place.run(["new", "half", "-a", "0", "-b", "x"]).expect_refusal(&[
        "--direct-effect = 0",
        "--evolution-effect = x: not a decimal number",
        "--critical-slip-distance-m: missing",
        "--stiffness-pa-per-m: missing",
        "--mass-per-area-kg-per-m2: missing",
    ]);
    place
        .run(["new", "far", "-a", "0.01", "-b", "0.02", "-d", "1", "-k", "1e300", "-m", "1"])
        .expect_refusal(&["beyond 1e-250 to 1e250"]);
    for (stress, velocity, group) in
        [("1e30", "1e-12", "eta"), ("1e20", "1e-3", "kappa"), ("1e-9", "1e-6", "kappa")]
    {
        let far = [&new("far", "0.01", "0.02")[..], &["-s", stress, "-v", velocity]].concat();
        place.run(far).expect_refusal(&[&format!("error: {group} = "), "outside the range of reports"]);
    }
    assert!(place.names().is_empty());
}

#[test]
fn a_report_on_another_paper_is_decided_as_it_is_written() {
    let place = Workplace::new();
    let said = place.run(["new", "--paper", "other"]).expect_success();
    assert!(said.ends_with("other/report.toml\nnext: slipmode verify other\n"), "{said}");
    let verified = place.run(["verify", "other"]).expect_success();
    assert!(verified.contains("1 claim: 1 holds, ") && verified.contains("no published copy"), "{verified}");
    // The example is decided by its formula: another formula has another verdict.
    let claims = place.read("other/claims.toml");
    fs::write(place.path("other/claims.toml"), claims.replace("iff K > K_c", "iff K < K_c")).unwrap();
    let ended = place.run(["verify", "other"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.contains("C1: recorded holds, now fails"), "{}", ended.stderr);
    // An archive of a report without scenes is computed again from its inputs.
    fs::write(place.path("other/claims.toml"), claims).unwrap();
    place.run(["archive", "other", "-o", "other.zip"]).expect_success();
    place.run(["replay", "other.zip"]).expect_success();
    place.run(["new", "--paper", "other"]).expect_refusal(&["other: already exists; choose another folder"]);
    place.run(["new", "--paper", "a b"]).expect_refusal(&["NAME = "]);
    place.run(["new", "--paper", "slider", "-a", "0.01"]).expect_refusal(&["--paper", "--direct-effect"]);
    place.run(["new", "--paper", "slider", "-s", "1e6"]).expect_refusal(&["--paper", "--normal-stress-pa"]);
}

#[test]
fn units_of_a_lab_book_get_a_warning_and_the_folder_is_written() {
    let place = Workplace::new();
    let ended = place.run(["new", "um", "-a", "0.009", "-b", "0.0126", "-d", "8", "-k", "2e9", "-m", "2400"]);
    assert_eq!(ended.stderr, "warning: critical_slip_distance_m = 8: looks like um (wanted: m)\n");
    assert_eq!((ended.code, place.names()), (0, vec!["um".to_string()]));
}

#[test]
fn the_tolerance_table_has_a_line_for_each_formula_that_exists_and_each_error() {
    let place = Workplace::new();
    let lines = |a: &str, b: &str, errors: &[&str]| {
        let mut arguments = new("", a, b);
        arguments.splice(..2, ["tolerance"]);
        arguments.extend(errors.iter().flat_map(|error| ["-e", *error]));
        let text = place.run(arguments).expect_success();
        text.lines().skip(1).map(str::to_string).collect::<Vec<_>>()
    };
    assert_eq!(lines("0.008", "0.012", &[]).len(), 12);
    let equal = lines("0.01", "0.01", &["0.05", "0.5"]);
    assert_eq!(equal.len(), 4);
    assert!(equal.iter().all(|line| line.starts_with("eq16") || line.starts_with("eq20")), "{equal:?}");
    place.run(["tolerance", "-e", "1", "-e", "nan"]).expect_refusal(&[
        "--direct-effect: missing",
        "--relative-error = 1",
        "--relative-error = nan",
    ]);
}
