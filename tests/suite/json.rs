//! `--json` of the commands on folders and files: a schema number, the inputs, and numbers as numbers.

use serde_json::{Value, json};

use crate::harness::{SLIDER, Workplace};

/// The object that a command prints; it has a schema number.
fn object(place: &Workplace, arguments: &[&str], code: i32) -> Value {
    let ended = place.run(arguments.iter().copied());
    assert_eq!(ended.code, code, "{}", ended.stderr);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(found["schema"], 1, "{arguments:?}");
    found
}

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";

const SWEEP: &str = "[sweep]\nwork = \"classify\"\nblock_points = 10\n[sweep.grid]\n\
    normal_stress_pa = { from = 1e3, to = 1e7, points = 5 }\n\
    loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 5 }\n";

#[test]
fn commands_on_folders_and_archives_have_json() {
    let place = Workplace::new();
    let report = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/rice-ruina-1983");
    let json = |arguments: &[&str]| object(&place, arguments, 0);
    let verified = json(&["verify", report, "--json", "-o", "out"]);
    assert_eq!(
        (&verified["has_published_copy"], &verified["differences"]),
        (&true.into(), &Vec::<Value>::new().into())
    );
    let claims = verified["claims"].as_array().unwrap();
    for (verdict, count) in verified["verdicts"].as_object().unwrap() {
        let found = claims.iter().filter(|claim| claim["verdict"] == verdict.as_str()).count();
        assert_eq!(found as u64, count.as_u64().unwrap(), "{verdict}");
    }
    assert!(claims.len() > 5 && claims.iter().all(|claim| claim["verdict"] == claim["recorded"]));
    assert_eq!(verified["inputs"]["report"], report);
    let archived = json(&["archive", report, "--json", "-o", "r.zip"]);
    assert_eq!(archived["sha256"].as_str().map(str::len), Some(64));
    let replayed = json(&["replay", "r.zip", "--json"]);
    assert_eq!(replayed["differences"], Value::Array(Vec::new()));
    for found in [&archived, &replayed, &json(&["report", report, "--json", "-o", "again"])] {
        assert_eq!(found["verdicts"], verified["verdicts"]);
        assert!(found["inputs"].is_object(), "{found}");
    }
}

#[test]
fn new_run_and_explore_name_what_they_wrote() {
    let place = Workplace::new();
    let paper = object(&place, &["new", "p", "--paper", "--json"], 0);
    assert_eq!(paper["inputs"], json!({ "name": "p", "paper": true }));
    assert_eq!((&paper["output"], &paper["next"]), (&json!("p"), &json!("slipmode verify p")));
    let quoted = object(&place, &["new", "q", "--paper", "--json", "--output=-it's"], 0);
    assert_eq!(quoted["next"], "slipmode verify './-it'\\''s'");
    for file in paper["files"].as_array().unwrap() {
        assert!(place.path("p").join(file.as_str().unwrap()).is_file(), "{file}");
    }
    let arguments = ["new", "lab", "-s", "1e5", "-v", "1 mm/s", "--json"];
    let slider = [&SLIDER[..5], &["10±2 um"], &SLIDER[6..]].concat();
    let own = object(&place, &[&arguments[..], &slider].concat(), 0);
    let inputs = json!({
        "name": "lab", "paper": false, "direct_effect": 0.004, "evolution_effect": 0.006,
        "critical_slip_distance_m": [8e-6, 1.2e-5], "stiffness_pa_per_m": 1e7, "mass_per_area_kg_per_m2": 1000.0,
        "normal_stress_pa": 1e5, "loading_velocity_m_per_s": 1e-3,
        "normal_stresses_pa": [32e3, 320e3], "loading_velocities_m_per_s": [1e-4, 1e-2],
    });
    assert_eq!((&own["inputs"], &own["next"]), (&inputs, &json!("slipmode report lab")));
    place.write("s.toml", format!("{SCENE}[boundary]\npoints = 3\ndigits = 20\n"));
    let run = object(&place, &["run", "s.toml", "-o", "out", "--json"], 0);
    assert_eq!((&run["inputs"]["scene"], &run["output"]), (&json!("s.toml"), &json!("out")));
    for file in run["files"].as_array().unwrap() {
        assert!(place.path("out").join(file.as_str().unwrap()).is_file(), "{file}");
    }
    let explored = object(&place, &["explore", "s.toml", "-s", "1kPa", "-v", "2e-3", "--json"], 0);
    let point = json!({ "normal_stress_pa": 1000.0, "loading_velocity_m_per_s": 0.002 });
    assert_eq!(explored["inputs"], json!({ "scene": "s.toml", "operating_point": point }));
    assert_eq!(explored["points"], json!({ "given": point }));
    assert_eq!(
        (&explored["slider"]["direct_effect"], &explored["output"]),
        (&json!(0.004), &json!("s.html"))
    );
    let refused = place.run(["explore", "s.toml", "--json", "-o", "-"]);
    refused.expect_refusal(&["--output = -: needs a file"]);
}

#[test]
fn errors_are_json_where_json_was_asked_for_and_there_is_no_answer() {
    let place = Workplace::new();
    let errors = |arguments: &[&str], code: i32| {
        let found = object(&place, arguments, code);
        assert_eq!(found.as_object().unwrap().len(), 2, "{found}");
        found["errors"].clone()
    };
    let roots = [&["roots", "--json", "-s", "-1e5", "-v", "1e-3 furlong/s"], &SLIDER[..]].concat();
    assert_eq!(
        errors(&roots, 2),
        json!([
            { "file": "command line", "line": null, "key": "--normal-stress-pa", "value": "-1e5",
              "message": "must be > 0 (allowed: 1e-300 to 1e300)" },
            { "file": "command line", "line": null, "key": "--loading-velocity-m-per-s", "value": "1e-3 furlong/s",
              "message": place.run(roots.iter().copied()).stderr.lines().last().unwrap().split_once("furlong/s\": ").unwrap().1 },
        ])
    );
    place.write("s.toml", SCENE.replace("mass_per_area", "mass_pr_area"));
    let scene = errors(&["run", "s.toml", "--json"], 2);
    let of_key =
        |fault: &&Value| fault["key"].as_str().is_some_and(|key| key.ends_with("mass_pr_area_kg_per_m2"));
    let misspelt = scene.as_array().unwrap().iter().find(of_key).unwrap();
    assert_eq!((&misspelt["file"], &misspelt["line"]), (&json!("s.toml"), &json!(8)));
    let usage = errors(&["roots", "--json", "--digts", "5"], 2);
    assert_eq!(
        usage[0],
        json!({ "message": "unexpected argument '--digts' found; tip: a similar argument exists: '--digits'" })
    );
    let missing = errors(&["verify", "nowhere", "--json"], 2);
    assert!(missing[0]["message"].as_str().unwrap().contains("no such folder"), "{missing}");
    // The messages for people stand where they always do; a check that failed has answered.
    let refused = place.run(roots.iter().copied());
    assert!(refused.stderr.starts_with("error: command line: --normal-stress-pa = -1e5: must be > 0"));
    let plain = place.run(roots.into_iter().filter(|word| *word != "--json"));
    assert_eq!((plain.stdout.as_str(), plain.stderr), ("", refused.stderr));
}

#[test]
fn sweep_and_merge_count_blocks_and_name_missing_shards() {
    let place = Workplace::new();
    place.write("s.toml", format!("{SCENE}{SWEEP}"));
    let sweep = |more: &[&str]| object(&place, &[&["sweep", "s.toml", "--json"], more].concat(), 0);
    let first = sweep(&["--out", "b", "--shard", "0/2"]);
    assert_eq!((&first["blocks"], &first["computed_blocks"]), (&json!(2), &json!(2)));
    assert_eq!(first["shard"], json!({ "index": 0, "count": 2 }));
    assert_eq!(sweep(&["--out", "b", "--shard", "0/2"])["computed_blocks"], 0);
    let merge = |more: &[&str], code| object(&place, &[&["merge", "b", "--json"], more].concat(), code);
    for (more, code) in [(&["--missing", "--shards", "2"], 0), (&["-o", "m.csv", "--shards"], 1)] {
        let more = if code == 0 { more.to_vec() } else { [more, &["2"][..]].concat() };
        let missing = merge(&more, code);
        assert_eq!((&missing["missing_shards"], &missing["output"]), (&json!([1]), &Value::Null));
    }
    sweep(&["--out", "b", "--shard", "1/2"]);
    let whole = merge(&["-o", "m.csv"], 0);
    assert_eq!((&whole["missing_shards"], &whole["output"]), (&json!([]), &json!("m.csv")));
    assert_eq!((&whole["blocks"], &whole["scene_sha256"]), (&json!(3), &first["scene_sha256"]));
    assert_eq!(place.read("m.csv").lines().count(), 26);
    place.run(["merge", "b", "--json"]).expect_refusal(&["--output = -: needs a file"]);
    let plan = sweep(&["--plan", "--minutes", "2"]);
    assert_eq!((&plan["points"], &plan["blocks"], &plan["shards"]), (&json!(25), &json!(3), &json!(1)));
    assert_eq!(plan["inputs"], json!({ "scene": "s.toml", "minutes": 2 }));
    assert!(plan["point_seconds"].as_f64().unwrap() > 0.0);
    let scripts = sweep(&["--slurm", "--out", "b", "--shards", "3"]);
    assert_eq!(
        (&scripts["shards"], &scripts["files"]),
        (&json!(3), &json!(["array.sh", "merge.sh", "submit.sh"]))
    );
}

#[test]
fn diff_lists_the_differences() {
    let place = Workplace::new();
    let ledger = |verdict: &str| {
        format!("{{\"claims\": [{{\"id\": \"S1\", \"verdict\": \"{verdict}\", \"strength\": \"exact\"}}]}}")
    };
    place.write("a.json", ledger("holds"));
    place.write("b.json", ledger("fails"));
    let same = object(&place, &["diff", "a.json", "a.json", "--json"], 0);
    assert_eq!(same["differences"], json!([]));
    let other = object(&place, &["diff", "a.json", "b.json", "--json"], 1);
    assert_eq!(other["inputs"], json!({ "first": "a.json", "second": "b.json" }));
    assert_eq!(other["differences"].as_array().map(Vec::len), Some(1));
}
