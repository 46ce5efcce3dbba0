//! `certificates`: files of certificates are written, proved again, and refused after any change; a run shows how many it proved.

use std::fs;

use serde_json::Value;
use slipmode::archive::{Caps, sha256_hex, unpack};

use crate::archive::small_report;
use crate::harness::{Ended, Workplace};

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n[simulations]\n\
    loading_velocity_m_per_s = { from = 1e-3, to = 1e-2, points = 2 }\n\
    normal_stress_pa = { from = 1e3, to = 1e5, points = 2 }\nlaws = [\"slip\"]\ntolerance = 1e-2\n";

/// A scene whose certificates have this digest, as a line of TOML.
fn scene(digest: &str) -> String {
    format!("{SCENE}[certificates]\nprove_again = 1\n[[certificates.file]]\nname = \"c\"\n{digest}")
}

/// Writes `certified.toml` with its file of certificates, of three cycles and a decay.
pub fn write_certified(place: &Workplace) {
    place.write("new.toml", SCENE);
    let arguments = ["certificates", "new.toml", "--law", "slip", "-o", "c.csv"];
    let digest = place.run(arguments).expect_success();
    place.write("certified.toml", scene(&digest));
}

#[test]
fn certificates_are_written_and_proved_again() {
    let place = Workplace::new();
    write_certified(&place);
    let all = ["certificates", "certified.toml"];
    assert_eq!(place.run(all).expect_success(), "4 of 4 certificates proved again\n");
    let to_stream = ["certificates", "new.toml", "--law", "slip", "-o", "-", "--threads", "1"];
    assert_eq!(place.run(to_stream).expect_success(), place.read("c.csv"));
    let found: Value =
        serde_json::from_str(&place.run([&all[..], &["--json"]].concat()).expect_success()).unwrap();
    assert_eq!((&found["proved_again"], &found["certificates"]), (&4.into(), &4.into()));
    let to_both = ["certificates", "new.toml", "--law", "slip", "-o", "-", "--json"];
    place.run(to_both).expect_refusal(&["--output = -: needs a file"]);
    place.run(["run", "certified.toml", "-o", "out"]).expect_success();
    let table = place.read("out/tables/certificates.csv");
    // The first row, and as extremes two neighbouring cycles.
    assert!(table.lines().nth(1).unwrap().starts_with("s,slip,4,3,1,3,"), "{table}");
    place
        .run(["certificates", "new.toml"])
        .expect_refusal(&["new.toml: certificates: ", "a section that names"]);
}

#[test]
fn a_changed_byte_is_refused_and_a_changed_bound_with_its_digest_is_not_proved() {
    let place = Workplace::new();
    write_certified(&place);
    let (right, known) = (place.read("c.csv"), place.read("certified.toml"));
    let line = right.lines().nth(3).unwrap();
    let cells: Vec<&str> = line.split(',').collect();
    // Both bounds of the peak, a part of 10^-9 higher.
    let higher = |text: &str| (text.parse::<f64>().unwrap() * (1.0 + 1e-9)).to_string();
    let changed = cells[9..11].iter().fold(right.clone(), |text, cell| text.replace(cell, &higher(cell)));
    place.write("c.csv", &changed);
    let all = ["certificates", "certified.toml"];
    place.run(all).expect_refusal(&["c.csv: sha256: ", "the file of SHA-256"]);
    place.run(["run", "certified.toml", "-o", "out"]).expect_refusal(&["c.csv: sha256: "]);
    let digest = known.rsplit('"').nth(1).unwrap();
    let found = place.run(all).stderr.rsplit("not ").next().unwrap()[..64].to_string();
    place.write("certified.toml", known.replace(digest, &found));
    let ended = place.run(all);
    assert_eq!((ended.code, ended.stdout.as_str()), (1, "3 of 4 certificates proved again\n"));
    assert!(ended.stderr.contains("slip law: the stored peak velocity is another one"), "{}", ended.stderr);
}

/// What a row's certificate does not have stays empty, and a cycle attracts.
#[test]
fn a_cell_that_no_certificate_of_its_kind_has_is_refused() {
    let place = Workplace::new();
    write_certified(&place);
    let right = place.read("c.csv");
    let lines: Vec<&str> = right.lines().collect();
    let columns: Vec<&str> = lines[0].split(',').collect();
    for (kind, column, value) in [
        ("decay", "period_low_s", "abc"),
        ("decay", "period_high_s", "5"),
        ("decay", "contraction_factor", "0.5"),
        ("decay", "second_coordinate", "psi"),
        ("cycle", "captured_after_s", "1"),
        ("cycle", "contraction_factor", "1"),
        ("cycle", "contraction_factor", "-0.1"),
    ] {
        let row = lines.iter().position(|line| line.split(',').nth(8) == Some(kind)).unwrap();
        let mut cells: Vec<&str> = lines[row].split(',').collect();
        cells[columns.iter().position(|name| *name == column).unwrap()] = value;
        let (changed, mut rows) = (cells.join(","), lines[1..].to_vec());
        rows[row - 1] = &changed;
        with_rows(&place, lines[0], &rows)
            .expect_refusal(&[&format!("c.csv:{}: {column} = {value}: ", row + 1)]);
    }
}

/// Stores these rows with the digest of their file in the scene, and proves them again.
fn with_rows(place: &Workplace, header: &str, rows: &[&str]) -> Ended {
    let text: String = std::iter::once(&header).chain(rows).map(|line| format!("{line}\n")).collect();
    place.write("certified.toml", scene(&format!("sha256 = \"{}\"\n", sha256_hex(text.as_bytes()))));
    place.write("c.csv", text);
    place.run(["certificates", "certified.toml"])
}

/// A file that has not exactly the rows of the grid is refused in one message, also by a run that would prove some of them.
#[test]
fn a_file_without_rows_or_with_missing_repeated_foreign_or_exchanged_ones_is_refused() {
    let place = Workplace::new();
    write_certified(&place);
    let right = place.read("c.csv");
    let lines: Vec<&str> = right.lines().collect();
    let [header, first, second, third, fourth] = lines[..] else { panic!("{right}") };
    let here = "the grid of [simulations] has here σ = 1000 Pa, V_l = 0.01 m/s";
    let counts = |rows: usize| format!("(points of the grid of [simulations]: 4; rows of the file: {rows})");
    let [foreign, other_law] = [second.replacen(",0.01,", ",0.011,", 1), second.replace(",slip,", ",aging,")];
    assert!(foreign != second && other_law != second);
    let all_aging: Vec<String> = lines[1..].iter().map(|row| row.replace(",slip,", ",aging,")).collect();
    let other_slider = second.replacen("0.006,", "0.007,", 1);
    for (rows, line, what) in [
        (vec![], 1, format!("row 1: missing: σ = 1000 Pa, V_l = 0.001 m/s {}", counts(0))),
        (
            vec![first, second, third],
            4,
            format!("row 4: missing: σ = 100000 Pa, V_l = 0.01 m/s {}", counts(3)),
        ),
        (
            vec![second, third, fourth],
            2,
            format!("row 1: missing: σ = 1000 Pa, V_l = 0.001 m/s {}", counts(3)),
        ),
        (vec![first, third, fourth], 3, format!("row 2: missing: σ = 1000 Pa, V_l = 0.01 m/s {}", counts(3))),
        (
            vec![first, first, second, third, fourth],
            3,
            format!("row 2: repeated: σ = 1000 Pa, V_l = 0.001 m/s is row 1 already ({here})"),
        ),
        (
            vec![first, second, third, fourth, third],
            6,
            format!("row 5: repeated: σ = 100000 Pa, V_l = 0.001 m/s is row 3 already {}", counts(5)),
        ),
        (
            vec![first, fourth, third, second],
            3,
            format!("row 2: out of place: σ = 100000 Pa, V_l = 0.01 m/s belongs into row 4 ({here})"),
        ),
        (
            vec![first, &foreign, third, fourth],
            3,
            format!("row 2: σ = 1000 Pa, V_l = 0.011 m/s is no point of the grid ({here})"),
        ),
        (
            vec![first, &other_law, third, fourth],
            3,
            "row 2: out of place: aging law (all other rows have the slip law)".into(),
        ),
        (
            all_aging.iter().map(String::as_str).collect(),
            2,
            "law = aging: out of range (allowed: a law of [simulations]: slip)".into(),
        ),
        (
            vec![first, &other_slider, third, fourth],
            3,
            "evolution_effect = 0.007: another slider's (the scene has 0.006)".into(),
        ),
    ] {
        let ended = with_rows(&place, header, &rows);
        let wanted = format!("error: ./c.csv:{line}: {what}\n");
        assert_eq!((ended.code, ended.stdout.as_str(), ended.stderr.as_str()), (2, "", wanted.as_str()));
        let ended = place.run(["run", "certified.toml", "-o", "out"]);
        assert_eq!((ended.code, ended.stderr.as_str()), (2, wanted.as_str()));
    }
    assert_eq!(with_rows(&place, header, &lines[1..]).expect_success(), "4 of 4 certificates proved again\n");
}

#[test]
fn a_second_file_of_one_law_and_a_scene_without_a_grid_are_refused() {
    let place = Workplace::new();
    write_certified(&place);
    let known = place.read("certified.toml");
    let second = known.rsplit_once("[[certificates.file]]").unwrap().1.replace("\"c\"", "\"d\"");
    place.write("d.csv", place.read("c.csv"));
    place.write("certified.toml", format!("{known}[[certificates.file]]{second}"));
    place
        .run(["certificates", "certified.toml"])
        .expect_refusal(&["d.csv: law = slip: the same as the law of ./c.csv\n"]);
    let (before, rest) = known.split_once("[simulations]").unwrap();
    let without = format!("{before}[certificates]{}", rest.split_once("[certificates]").unwrap().1);
    place.write("certified.toml", without);
    place
        .run(["certificates", "certified.toml"])
        .expect_refusal(&["c.csv: needs a section [simulations] in the scene `s`: its grid has the rows\n"]);
}

#[test]
fn points_without_a_certificate_are_counted() {
    let place = Workplace::new();
    write_certified(&place);
    let right = place.read("c.csv");
    let lines: Vec<&str> = right.lines().collect();
    let inputs: Vec<&str> = lines[2].split(',').take(8).collect();
    let none = format!("{},none: because{}", inputs.join(","), ",".repeat(lines[0].split(',').count() - 9));
    let ended = with_rows(&place, lines[0], &[lines[1], &none, lines[3], lines[4]]);
    assert_eq!(ended.expect_success(), "3 of 3 certificates proved again; 1 of 4 points have none\n");
}

#[test]
fn an_archive_has_its_certificates_with_the_program_that_proves_them_again() {
    let place = small_report();
    write_certified(&place);
    place.write("small/scenes/a.toml", place.read("certified.toml").replace("name = \"s\"", "name = \"a\""));
    place.write("small/vectors/c.csv", place.read("c.csv"));
    place.write("small/prose/c.md", "Words.\n\n[[table:certificates]]\n");
    place.run(["archive", "small", "-o", "small.zip"]).expect_success();
    place.run(["replay", "small.zip"]).expect_success();
    let files = unpack(&fs::read(place.path("small.zip")).unwrap(), &Caps::default()).unwrap().0;
    assert_eq!(files["input/vectors/c.csv"], place.read("c.csv").into_bytes());
    assert_eq!(files["certified_cycle.py"], include_bytes!("../../proofs/certified_cycle.py"));
    let readme = String::from_utf8(files["README.md"].clone()).unwrap();
    assert!(readme.contains("\n    python certified_cycle.py --rows 3 input/vectors/c.csv\n"), "{readme}");
}
