//! `classify --points`: rows kept, results appended, the same bytes on any number of threads.

use crate::harness::{HEADER, ROW, Workplace};

const APPENDED: &str = ",transition_sign,boundary_sign,spectral_class,slip_mode,max_real_per_s,max_imaginary_per_s,rung,\
     frequency_hz,critical_stiffness_pa_per_m,stiffness_over_critical,frequency_over_natural,undecided_share";

/// Many different rows, easy and hard ones mixed, without a random generator.
fn many_rows(count: u32) -> String {
    let row = |i: u32| match i % 7 {
        0 => "1,1,1,3.375,0.125,1,1".to_string(),
        1 => format!("0.004,0.006,1e-5,1e7,1000,{}.{:030},1e-4", 49_750, i),
        _ => format!(
            "0.00{}{},0.0{}7,1e-{},{}e7,1000,{}e5,0.{}",
            1 + i % 9,
            i,
            i % 9,
            4 + i % 3,
            1 + i % 5,
            1 + i,
            1 + i % 97
        ),
    };
    std::iter::once(HEADER.to_string()).chain((0..count).map(row)).map(|line| line + "\n").collect()
}

#[test]
fn input_columns_are_kept_in_their_order_and_results_appended() {
    let place = Workplace::new();
    // Shuffled columns, text beside numbers, a byte order mark, line feeds with carriage returns.
    place.write(
        "in.csv",
        "\u{feff}site,loading_velocity_m_per_s,direct_effect,evolution_effect,critical_slip_distance_m,\
         stiffness_pa_per_m,mass_per_area_kg_per_m2,normal_stress_pa,\"note, free\"\r\n\
         A,1e-3,0.0040,0.006,1e-5,1e7,1000,1e5,\"say \"\"hello\"\"\"\r\n\
         =cmd,1e-3,0.004,0.006,1e-5,1e7,1000,+1e5,-3.5\r\n",
    );
    let ended = place.run(["classify", "--points", "in.csv", "-o", "out.csv"]);
    assert_eq!(ended.stderr, "warning: columns that are not read: site, note, free\n");
    assert_eq!((ended.code, ended.stdout.as_str()), (0, ""));
    let written = place.read("out.csv");
    let lines: Vec<_> = written.lines().collect();
    assert!(lines[0].starts_with("site,loading_velocity_m_per_s,") && lines[0].ends_with(APPENDED));
    assert!(lines[0].contains(",\"note, free\","), "{}", lines[0]);
    assert!(lines[1].starts_with("A,1e-3,0.0040,0.006,1e-5,1e7,1000,1e5,\"say \"\"hello\"\"\",-1,-1,"));
    assert!(lines[2].starts_with("'=cmd,1e-3,0.004,0.006,1e-5,1e7,1000,+1e5,-3.5,-1,-1,"), "{}", lines[2]);
    assert_eq!(place.names(), ["in.csv", "out.csv"]);
}

#[test]
fn a_row_says_what_classify_says_of_the_point() {
    let place = Workplace::new();
    let rows = format!("{HEADER}\n{ROW}\n");
    let out = place.run_with_input(["classify", "--points", "-"], &rows).expect_success();
    assert_eq!(
        out.lines().nth(1).unwrap(),
        format!(
            "{ROW},-1,-1,unstable-complex,stick-slip,11.393570596829527,42.22571431798806,f64,\
             6.720431159294019,2.5e7,0.4,0.4222571431798806,0"
        )
    );
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let place = Workplace::new();
    place.write("in.csv", many_rows(20_000));
    for threads in ["1", "2", "5"] {
        let out = format!("out-{threads}.csv");
        place.run(["classify", "--points", "in.csv", "-o", &out, "--threads", threads]).expect_warnings();
        assert_eq!(place.read(&out), place.read("out-1.csv"), "{threads} threads");
    }
    let written = place.read("out-1.csv");
    assert_eq!(written.lines().count(), 20_001);
    assert!(written.contains(",1,0,stable-real,"), "the cusp");
    assert!(written.contains(",0,-1,neutral,") || written.contains(",-1,-1,"), "beside the transition");
    let through_pipes =
        place.run_with_input(["classify", "--points", "-"], &many_rows(20_000)).expect_warnings();
    assert_eq!(through_pipes, written);
}

#[test]
fn signs_on_and_beside_the_limits_are_exact_for_decimals_of_any_length() {
    let place = Workplace::new();
    let stress = |text: &str| format!("0.004,0.006,1e-5,1e7,1000,{text},1e-4\n");
    let nearly = format!("49749.{}", "9".repeat(5000));
    let rows = format!(
        "{HEADER}\n{}{}{}",
        stress("49750"),
        stress(&nearly),
        stress("49750.00000000000000000000001")
    );
    let out = place.run_with_input(["classify", "--points", "-"], &rows).expect_success();
    let signs: Vec<_> = out.lines().skip(1).map(|line| line.split(',').nth(7).unwrap()).collect();
    assert_eq!(signs, ["0", "1", "-1"]);
    let rungs: Vec<_> = out.lines().skip(1).map(|line| line.split(',').nth(13).unwrap()).collect();
    assert_eq!(rungs, ["exact", "exact", "double-double"]);
}

#[test]
fn blanks_around_a_number_do_not_matter() {
    let of = |separator: &str| {
        let row = ["0.004", "0.006", "1e-5", "1e7±1e6", "1000", "1e5", "1 mm/s"].join(separator);
        let text = format!("{}\n{row} \n", HEADER.split(',').collect::<Vec<_>>().join(separator));
        let out = Workplace::new().run_with_input(["classify", "--points", "-", "--quiet"], &text);
        let line = out.expect_success().lines().nth(1).unwrap().to_owned();
        line.split(',').skip(7).map(str::to_owned).collect::<Vec<_>>()
    };
    assert!(!of(",").is_empty());
    assert_eq!(of(","), of(", "));
}

#[test]
fn a_header_without_rows_gives_a_header() {
    let out = Workplace::new().run_with_input(["classify", "--points", "-"], HEADER).expect_success();
    assert_eq!(out, format!("{HEADER}{APPENDED}\n"));
}
