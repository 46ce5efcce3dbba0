//! Notations of numbers: error bars, units behind values, decimal commas, other separators; what is refused names the way out.

use crate::harness::{HEADER, Workplace};

/// A laboratory slider; what stands for `X` is tried.
fn classified(options: &str, value: &str) -> crate::harness::Ended {
    let words: Vec<&str> = options.split(' ').map(|word| if word == "X" { value } else { word }).collect();
    Workplace::new().run(["classify", "--json"].into_iter().chain(words))
}

const WITH_B: &str = "-a 0.009 -b X -d 8um -k 2MPa/mm -m 12kg/50cm2 -s 5MPa -v 10um/s";
const WITH_D: &str = "-a 0.009 -b 0.0126 -d X -k 2MPa/mm -m 12kg/50cm2 -s 5MPa -v 10um/s";
const WITH_K: &str = "-a 0.009 -b 0.0126 -d 8um -k X -m 12kg/50cm2 -s 5MPa -v 10um/s";

/// What an object says beside its inputs.
fn found(options: &str, value: &str) -> serde_json::Value {
    let ended = classified(options, value);
    assert_eq!(ended.code, 0, "{value}: {}", ended.stderr);
    let mut found: serde_json::Value = serde_json::from_str(&ended.stdout).unwrap();
    found["inputs"].take();
    found
}

#[test]
fn all_notations_of_an_error_bar_have_the_same_meaning() {
    let of_b = found(WITH_B, "0.0126±0.0007");
    for text in [
        "0.0126+/-0.0007",
        "0.0126+-0.0007",
        "0.0126(7)",
        "1.26(7)e-2",
        "0.0126 ± 0.0007",
        "[0.0119; 0.0133]",
    ] {
        assert_eq!(found(WITH_B, text), of_b, "{text}");
    }
    let of_b = found(WITH_B, "0.0126±0.00063");
    for text in ["0.0126±5%", "0.0126 +/- 5 %", "0.01260(63)"] {
        assert_eq!(found(WITH_B, text), of_b, "{text}");
    }
    let of_d = found(WITH_D, "8±0.2um");
    for text in
        ["8um±0.2um", "8 um ± 200 nm", "8.0(2)um", "8.0(2) um", "8um±2.5%", "8±2.5% um", "[7.8, 8.2] um"]
    {
        assert_eq!(found(WITH_D, text), of_d, "{text}");
    }
}

#[test]
fn fractions_are_read_wherever_a_ratio_or_a_rate_is() {
    let slider = ["-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000"];
    let said = |words: &[&str], value: &str| {
        let words = words.iter().map(|word| if *word == "X" { value } else { *word });
        Workplace::new().run(words.chain(slider)).expect_success()
    };
    for (words, pairs) in [
        (
            &["solve", "--for", "normal-stress", "-v", "1e-3", "--growth-rate", "X"][..],
            [("1/2", "0.5"), ("-1/4", "-0.25")],
        ),
        (
            &["solve", "--for", "normal-stress", "-v", "1e-3", "--frequency-ratio", "X"],
            [("1/2", "0.5"), ("3/5", "0.6")],
        ),
        (
            &["boundary", "--at-normal-stress", "3e4", "--frequency-ratio", "X"],
            [("1/2", "0.5"), ("3/5", "0.6")],
        ),
        (
            &["boundary", "--at-normal-stress", "1000", "--damping-ratio", "X"],
            [("1/2", "0.5"), ("3/4", "0.75")],
        ),
        (&["tolerance", "-e", "X"], [("1/10", "0.1"), ("1/4", "0.25")]),
        (&["boundary", "--at-velocity", "X"], [("1/1000", "1e-3"), ("3e-5/2", "1.5e-5")]),
        (
            &["simulate", "-s", "1e5", "-v", "1e-3", "--law", "slip", "--tolerance", "X"],
            [("1/100", "0.01"), ("0.5/100", "0.005")],
        ),
    ] {
        for (fraction, decimal) in pairs {
            assert_eq!(said(words, fraction), said(words, decimal), "{words:?} {fraction}");
        }
    }
    let refused = ["boundary", "--damping-ratio", "half"].into_iter().chain(slider);
    Workplace::new().run(refused).expect_refusal(&["--damping-ratio = half: not a decimal number"]);
}

#[test]
fn cells_and_scenes_take_the_same_notations() {
    let place = Workplace::new();
    let rows = |cell: &str| format!("{HEADER}\n0.009,{cell},8e-6,2e9,2400,5e6,1e-5\n");
    let last = |cell: &str| {
        let out = place.run_with_input(["classify", "--points", "-"], &rows(cell)).expect_success();
        out.lines().last().unwrap().split_once(",8e-6,").unwrap().1.to_string()
    };
    let bar = last("0.0126±0.00063");
    for cell in ["0.0126+/-0.00063", "0.0126±5%", "0.01260(63)", "63/5000 ± 5%", "[0.01197; 1323/1e5]"] {
        assert_eq!(last(cell), bar, "{cell}");
    }
    place.run_with_input(["classify", "--points", "-"], &rows("0.0126(6.3)")).expect_refusal(&[
        "row 1, column evolution_effect = \"0.0126(6.3)\": brackets have the error of the last digits, as in 0.0098(5) um",
    ]);
    let scene = |b: &str, d: &str| {
        format!(
            "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.009\nevolution_effect = {b}\n\
             critical_slip_distance_m = {d}\nstiffness_pa_per_m = 2e9\nmass_per_area_kg_per_m2 = 2400\n\
             [boundary]\npoints = 3\ndigits = 20\n"
        )
    };
    place.write("bar.toml", scene("\"0.0126±0.00063\"", "\"8um±0.2um\""));
    place.write("other.toml", scene("\"0.0126±5%\"", "\"8.0(2) um\""));
    place.write("fraction.toml", scene("\"63/5000±5%\"", "\"1/125000±2e-7\""));
    for name in ["bar", "other", "fraction"] {
        let ended = place.run(["run", &format!("{name}.toml"), "-o", name]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
    }
    assert_eq!(place.read("bar/tables/boundary.csv"), place.read("other/tables/boundary.csv"));
    assert_eq!(place.read("bar/tables/boundary.csv"), place.read("fraction/tables/boundary.csv"));
}

#[test]
fn an_error_of_0_is_none() {
    let slider = |a: &str| format!("-a {a} -b 0.006 -d 1e-5 -k 1e7 -m 1000 --json");
    for command in
        ["classify -s 1e5 -v 1e-3", "boundary --at-velocity 1e-3", "tolerance", "roots -s 1e5 -v 1e-3"]
    {
        let said = |a: &str| {
            let line = format!("{command} {}", slider(a));
            Workplace::new().run(line.split(' ')).expect_success()
        };
        assert_eq!(said("0.004±0"), said("0.004"), "{command}");
    }
}

#[test]
fn a_unit_may_stand_in_the_value() {
    assert_eq!(found(WITH_D, "8 um"), found(WITH_D, "8um"));
    let place = Workplace::new();
    let run = |d: &str, stress: &str| {
        let rows = format!("{HEADER}\n0.009,0.0126,{d},2e9,2400,{stress},1e-5\n");
        place.run_with_input(["classify", "--points", "-"], &rows)
    };
    let last = |text: String| text.lines().last().unwrap().rsplit_once(",1e-5,").unwrap().1.to_string();
    let plain = last(run("8e-6", "5e6").expect_success());
    for (d, stress) in [("8um", "5MPa"), ("8 um", "5 MPa"), ("8e-6", "50 bar")] {
        assert_eq!(last(run(d, stress).expect_success()), plain, "{d} {stress}");
    }
    run("8 MPa", "5MPa").expect_refusal(&[
        "row 1, column critical_slip_distance_m = \"8 MPa\": MPa is a stress; length is m",
    ]);
}

#[test]
fn what_is_refused_names_the_way_out() {
    let split = Workplace::new().run(WITH_B.split(' ').fold(vec!["classify"], |mut all, word| {
        all.extend(match word {
            "X" => vec!["0.0126"],
            "8um" => vec!["8", "um"],
            word => vec![word],
        });
        all
    }));
    split.expect_refusal(&["error: -d 8 um: a unit belongs to its value: write -d 8um, or -d \"8 um\""]);
    classified(WITH_K, "0.0005/um").expect_refusal(&[
        "/um is a number per length; stiffness per area is Pa/m: multiply by the normal stress (σ)",
    ]);
    classified(WITH_B, "0,0126")
        .expect_refusal(&["= \"0,0126\": not a decimal number: a comma stands in place of the point"]);
    for (options, text) in
        [(WITH_B, "abc"), (WITH_B, "1±2"), (WITH_D, "8MPa"), (WITH_D, "8um±1"), (WITH_B, "0.0126(x)")]
    {
        let ended = classified(options, text);
        assert!(ended.code == 2 && !ended.stderr.contains("1e-300"), "{text}: {}", ended.stderr);
    }
    let ended = Workplace::new().run(["classify", "-a", "0.009"]);
    assert!(ended.code == 2 && !ended.stderr.contains("1e-300"), "{}", ended.stderr);
    classified(WITH_B, "1e400").expect_refusal(&["out of range (allowed: 1e-300 to 1e300)"]);
}

const LAB: &str = "sample,a,b,Dc [um],K_MPa_per_mm,m_kg_per_cm2,sigma_MPa,V0_um_per_s\n\
    g1,0.009,0.0126,8.5,2,0.24,5,10\n\"g 1,2\",0.0070(2),0.0105±0.0001,6,2,0.24,5,1\n";

#[test]
fn semicolons_and_decimal_commas_are_read_with_the_options_that_a_message_names() {
    let place = Workplace::new();
    let plain = place.run_with_input(["classify", "--points", "-"], LAB);
    assert_eq!(plain.code, 0, "{}", plain.stderr);
    let lab = LAB.replace(',', ";").replace('.', ",").replace("g 1;2", "g 1,2");
    place.write("lab.csv", &lab);
    place.run(["classify", "--points", "lab.csv"]).expect_refusal(&[
        "lab.csv:1: header: columns are separated by semicolons (classify, simulate, solve, compare and fit: add --delimiter ';'; decimal commas: add --decimal ,)",
    ]);
    place.run(["classify", "--points", "lab.csv", "--delimiter", ";"]).expect_refusal(&[
        "row 1, column a = \"0,009\": not a decimal number: a comma stands in place of the point (in a CSV file, --decimal , reads it)",
    ]);
    let read = |options: &[&'static str]| {
        place.run(["classify", "--points", "lab.csv"].into_iter().chain(options.iter().copied()))
    };
    let ended = read(&["--delimiter", ";", "--decimal", ","]);
    assert_eq!((ended.code, &ended.stdout), (0, &plain.stdout), "{}", ended.stderr);
    place.write("lab.csv", LAB.replace(',', "\t").replace("g 1\t2", "g 1,2"));
    assert_eq!(read(&["--delimiter", "tab"]).stdout, plain.stdout);
    place.write("lab.csv", LAB);
    read(&["--delimiter", ";"]).expect_refusal(&["columns are separated by commas", "leave out --delimiter"]);
    read(&["--decimal", ","]).expect_refusal(&["row 1 = 0.009: a decimal point, where --decimal"]);
    let quoted = "a,b,dc,k,m,sigma,v\n\"0,004\",\"0,006\",\"1e-5\",1e7,1000,1e5,\"1,0e-3\"\n";
    place.write("lab.csv", quoted);
    assert_eq!(read(&["--decimal", ","]).code, 0);
    place.write("lab.csv", quoted.replace('"', ""));
    read(&["--decimal", ","]).expect_refusal(&["10 cells, where the header has 7 (do decimals have commas?"]);
    place.run(["roots", "--decimal", ","]).expect_refusal(&["--decimal"]);
    place.run(["classify", "--decimal", ","]).expect_refusal(&["--decimal = \",\": needs --points"]);
}

#[test]
fn runs_and_their_trajectories_are_written_alike() {
    let place = Workplace::new();
    place.write("runs.csv", "a;b;dc;k;m;sigma;v;period_s\n0,009;0,0126;8um;2MPa/mm;2400;5MPa;10um/s;19,25\n");
    let ended = place.run(["compare", "--runs", "runs.csv", "--delimiter", ";", "--decimal", ","]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stdout.contains("1 agree"), "{}", ended.stdout);
}

#[test]
fn utf_16_is_refused_by_its_name() {
    let place = Workplace::new();
    let little: Vec<u8> = LAB.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = LAB.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let marked = [b"\xff\xfe".to_vec(), little.clone()].concat();
    for bytes in [little, big, marked] {
        place.write("lab.csv", bytes);
        place
            .run(["classify", "--points", "lab.csv"])
            .expect_refusal(&["lab.csv:1: header: UTF-16 text (wanted: UTF-8"]);
    }
}
