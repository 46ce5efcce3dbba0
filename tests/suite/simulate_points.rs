//! `simulate --points`: rows kept, observables appended, the same bytes on any number of threads.

use crate::harness::{HEADER, ROW, Workplace};
use crate::simulate::NAMES;

/// The paper's slider over stresses and velocities, both laws, stable and unstable.
fn many_rows() -> String {
    let mut text = format!("law,{HEADER}\n");
    for exponent in 0..24 {
        let law = ["slip", "aging"][exponent % 2];
        let (stress, velocity) = (3 + exponent % 4, 2 + exponent % 5);
        text += &format!("{law},0.004,0.006,1e-5,1e7,1000,{}e{stress},3e-{velocity}\n", 1 + exponent % 7);
    }
    text
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let place = Workplace::new();
    place.write("in.csv", many_rows());
    for threads in ["1", "2"] {
        let out = format!("out-{threads}.csv");
        place
            .run(["simulate", "--points", "in.csv", "-o", &out, "--threads", threads, "--tolerance", "1e-6"])
            .expect_success();
    }
    let written = place.read("out-1.csv");
    assert_eq!(place.read("out-2.csv"), written);
    assert_eq!(written.lines().count(), 25);
    assert_eq!(written.lines().next().unwrap(), format!("law,{HEADER},{}", NAMES.join(",")));
    for (kept, line) in many_rows().lines().zip(written.lines()).skip(1) {
        assert!(line.starts_with(&format!("{kept},")) && line.ends_with(",ok"), "{line}");
    }
    assert!(written.contains(",periodic,stick-slip,") && written.contains(",decaying,"));
}

#[test]
fn a_row_says_what_simulate_says_of_the_point() {
    let place = Workplace::new();
    let rows = format!("{HEADER}\n0.004,0.006,1e-5,1e7,1000,1e3,1e-5\n");
    let out = place.run_with_input(["simulate", "--points", "-", "--law", "slip"], &rows).expect_success();
    let cells: Vec<_> = out.lines().nth(1).unwrap().split(',').skip(7).collect();
    let point =
        ["-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s", "1e3", "-v", "1e-5"];
    let single = place.run(["simulate", "--json", "--law", "slip"].iter().chain(&point).copied());
    let single = single.expect_success();
    assert_eq!(cells.len(), NAMES.len());
    for (name, cell) in NAMES.into_iter().zip(cells) {
        // The text of the value: what a JSON reader makes of its last bit is the reader's business.
        let line = single.lines().find_map(|line| line.trim().strip_prefix(&format!("\"{name}\": ")));
        let value = line.unwrap().trim_end_matches(',').trim_matches('"');
        match (value.parse::<f64>(), cell.parse::<f64>()) {
            (Ok(value), Ok(cell)) => assert_eq!(value.to_bits(), cell.to_bits(), "{name}"),
            _ => assert_eq!(if value == "null" { "" } else { value }, cell, "{name}"),
        }
    }
}

#[test]
fn a_row_that_fails_says_so_and_the_others_go_on() {
    let place = Workplace::new();
    let far = "0.004,0.006,1e-300,1e-300,1e300,1e5,1e300";
    let rows = format!("{HEADER}\n{ROW}\n{far}\n{ROW}\n");
    let ended = place.run_with_input(["simulate", "--points", "-", "--law", "aging"], &rows);
    assert_eq!(ended.code, 0);
    assert!(
        ended.stderr.starts_with("1 of 3 rows have no result; see the column `status`\nwarning: row 2: ")
    );
    let mut reader = csv::ReaderBuilder::new().flexible(false).from_reader(ended.stdout.as_bytes());
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows[0].iter().collect::<Vec<_>>(), rows[2].iter().collect::<Vec<_>>());
    assert_eq!((&rows[0][7], &rows[0][18], &rows[0][19]), ("periodic", "false", "ok"));
    assert!(rows[1].iter().skip(7).take(11).all(str::is_empty));
    assert_eq!(&rows[1][18], "true");
    assert_eq!(&rows[1][19], "the start or a group is not a finite, admissible number");
}

#[test]
fn files_at_fault_are_refused_with_row_and_column_and_nothing_is_written() {
    let place = Workplace::new();
    let refuse = |rows: &str, more: &[&str], parts: &[&str]| {
        place.write("in.csv", rows);
        let arguments = ["simulate", "--points", "in.csv", "-o", "out.csv"];
        place.run(arguments.iter().chain(more).copied()).expect_refusal(parts);
        assert_eq!(place.names(), ["in.csv"]);
    };
    let with_law = format!("{HEADER},law\n{ROW},slip\n{ROW},Slip\n{},x\n", ROW.replace("1e7", "0"));
    refuse(
        &with_law,
        &[],
        &[
            "in.csv:3: row 2, column law = Slip: unknown; did you mean `slip`? (allowed: slip, aging)",
            "in.csv:4: row 3, column stiffness_pa_per_m = 0: must be > 0",
            "in.csv:4: row 3, column law = x: unknown (allowed: slip, aging)",
        ],
    );
    let header = HEADER.replace("normal_stress_pa,", "");
    refuse(
        &format!("{header}\n"),
        &[],
        &[
            "header, column normal_stress_pa: missing column",
            "header, column law: missing (allowed: a column of slip, aging, or the option --law for all rows)",
        ],
    );
    refuse(
        &format!("{HEADER},law,mode\n"),
        &["--law", "slip"],
        &["column law: needs no --law together with it", "column mode: a column of the output"],
    );
    refuse(
        &format!("{HEADER}\n{ROW}\n"),
        &["--law", "slip", "-a", "1"],
        &["--direct-effect = 1: needs no --points"],
    );
    refuse("", &["--law", "slip"], &["in.csv: empty file"]);
}

#[test]
fn keep_going_gives_every_row_and_says_which_are_faulty() {
    let place = Workplace::new();
    let rows = format!("{HEADER},law\n{ROW},slip\n{ROW},none\n");
    let ended = place.run_with_input(["simulate", "--points", "-", "--keep-going"], &rows);
    assert_eq!(
        (ended.code, ended.stderr.trim_end()),
        (0, "1 of 2 rows have an error; see the column `error`")
    );
    let mut reader = csv::ReaderBuilder::new().flexible(false).from_reader(ended.stdout.as_bytes());
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!((&rows[0][20], &rows[0][21]), ("ok", ""));
    assert!(rows[1][21].contains("column law = none: unknown"), "{}", &rows[1][21]);
}
