//! Points files that are at fault: named by row and column, nothing written; or, with `--keep-going`, an `error` column.

use crate::harness::{HEADER, ROW, Workplace, quoted};

/// Runs a points file that must be refused, and checks that nothing was written.
fn refuse(content: impl AsRef<[u8]>, parts: &[&str]) {
    let place = Workplace::new();
    place.write("in.csv", content);
    place.run(["classify", "--points", "in.csv", "-o", "out.csv"]).expect_refusal(parts);
    assert_eq!(place.names(), ["in.csv"]);
    place.run(["classify", "--points", "in.csv"]).expect_refusal(parts);
}

#[test]
fn a_header_is_a_contract() {
    let header = |from: &str, to: &str| format!("{}\n{ROW}\n", HEADER.replace(from, to));
    refuse(header("normal_stress_pa,", ""), &["in.csv:1: header, column normal_stress_pa: missing column"]);
    refuse(header("normal_stress_pa", "normal_stres_pa"), &["did you mean it by `normal_stres_pa`?"]);
    refuse(
        header("normal_stress_pa", "normal_stress_um"),
        &[
            "column normal_stress_um: um is a length; stress is Pa (allowed: normal_stress_pa, sigma_n, sigma;",
        ],
    );
    refuse(header("direct_effect", "direct_effect,direct_effect"), &["column direct_effect: doubled column"]);
    refuse(format!("{HEADER},rung\n{ROW},x\n"), &["column rung: a column of the output"]);
    refuse("", &["in.csv: empty file (wanted: a header line with the columns direct_effect, "]);
    refuse(
        header("normal_stress_pa,", "").replace("stiffness_pa_per_m", "kk"),
        &["column normal_stress_pa: missing", "column stiffness_pa_per_m: missing"],
    );
    for (separator, name) in [(";", "semicolons"), ("\t", "tabs")] {
        let rows = format!("{HEADER}\n{ROW}\n").replace(',', separator);
        refuse(rows, &[&format!("in.csv:1: header: columns are separated by {name} (classify, ")]);
    }
    refuse(b"\xff\xfed\0i\0r\0", &["in.csv:1: header: UTF-16 text (wanted: UTF-8"]);
    refuse(b"a,\xff\n", &["in.csv:1: header: not UTF-8 text (byte 1)"]);
}

#[test]
fn faulty_cells_are_named_by_row_column_value_and_range() {
    let rows = |bad: &str| format!("{HEADER}\n{ROW}\n0.004,0.006,1e-5,{bad},1000,1e5,1e-3\n{ROW}\n");
    let cases = [
        ("abc", "not a decimal number"),
        ("", "not a decimal number"),
        ("nan", "not a decimal number"),
        ("_1e7", "not a decimal number"),
        ("0", "must be > 0"),
        ("-1e7", "must be > 0"),
        ("1e400", "out of range"),
        ("1e1000000000", "exponent beyond"),
    ];
    for (value, problem) in cases {
        let place = format!("in.csv:3: row 2, column stiffness_pa_per_m = {}: {problem}", quoted(value));
        // The range is stated where the size is at fault.
        let is_of_size = ["must be > 0", "out of range"].contains(&problem);
        refuse(rows(value), &[&place, if is_of_size { "(allowed: 1e-300 to 1e300)" } else { "" }]);
    }
    refuse(rows("1\u{202e}7"), &["row 2, column stiffness_pa_per_m", "U+202E is not allowed"]);
    refuse(rows("1\u{0}7"), &["U+0000 is not allowed"]);
    refuse(rows(&"1".repeat(70_000)), &["a cell of 70000 bytes (allowed: at most 65536)"]);
}

#[test]
fn ragged_rows_and_runaway_quotes_are_refused() {
    refuse(format!("{HEADER}\n{ROW}\n1,2,3\n"), &["in.csv:3: row 2: 3 cells, where the header has 7"]);
    refuse(format!("{HEADER}\n{ROW},9\n"), &["in.csv:2: row 1: 8 cells, where the header has 7"]);
    refuse(format!("{HEADER}\n{ROW}\n\"1,2\n{ROW}\n"), &["row 2: the file ends inside a quoted cell"]);
    refuse(format!("{HEADER}\n\"{}", "x".repeat(3_000_000)), &["row 1: a row of more than 1048576 bytes"]);
    refuse(",".repeat(2_000_000), &["header: more than 1000 cells in a row"]);
}

#[test]
fn several_faults_are_told_at_once_and_the_first_are_enough() {
    let rows = format!("{HEADER}\n{}", "x,y,1e-5,1e7,1000,1e5,1e-3\n".repeat(1000));
    let place = Workplace::new();
    let ended = place.run_with_input(["classify", "--points", "-"], &rows);
    assert!(ended.stderr.chars().count() < 1_500, "{}", ended.stderr);
    ended.expect_refusal(&[
        "row 1, column direct_effect = x",
        "row 4, column evolution_effect = y",
        "\nerror: and at least ",
    ]);
}

#[test]
fn keep_going_gives_every_row_and_says_which_are_faulty() {
    let rows = format!("id,{HEADER}\na,{ROW}\n=b,x,0,1e-5,1e7,1000,1e5,1e-3\nc,1\nd,{ROW},9\ne,{ROW}\n");
    let place = Workplace::new();
    let ended = place.run_with_input(["classify", "--points", "-", "--keep-going"], &rows);
    assert_eq!(ended.code, 0);
    let told = "warning: columns that are not read: id\n3 of 5 rows have an error; see the column `error`\n";
    assert_eq!(ended.stderr, told);
    let mut reader = csv::ReaderBuilder::new().flexible(false).from_reader(ended.stdout.as_bytes());
    assert_eq!(reader.headers().unwrap().iter().next_back(), Some("error"));
    let errors: Vec<(String, String)> =
        reader.records().map(Result::unwrap).map(|row| (row[0].to_string(), row[20].to_string())).collect();
    let shown: Vec<_> = errors.iter().map(|(id, error)| (id.as_str(), error.is_empty())).collect();
    assert_eq!(shown, [("a", true), ("'=b", false), ("c", false), ("d", false), ("e", true)]);
    assert!(errors[1].1.contains("column direct_effect = x: not a decimal"), "{}", errors[1].1);
    assert!(errors[1].1.contains("column evolution_effect = 0: must be > 0"), "{}", errors[1].1);
    assert!(errors[2].1.contains("2 cells, where the header has 8"), "{}", errors[2].1);
}
