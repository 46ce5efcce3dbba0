//! Names of columns: each is read, refused or named as not read. `tests/data/column_names.csv` has the spellings.

use crate::harness::{Ended, Workplace};

/// A laboratory's table.
const NAMES: &str = "a,b,Dc [um],K_MPa_per_mm,m_kg_per_cm2,sigma_MPa,V0_um_per_s";
const CELLS: [&str; 7] = ["0.009", "0.0126", "8", "2", "0.24", "5", "10"];
const KEYS: [&str; 7] = [
    "direct_effect",
    "evolution_effect",
    "critical_slip_distance_m",
    "stiffness_pa_per_m",
    "mass_per_area_kg_per_m2",
    "normal_stress_pa",
    "loading_velocity_m_per_s",
];

/// A row of the data: the name, what it gives, and a cell.
fn spellings() -> Vec<[String; 3]> {
    let data = include_bytes!("../data/column_names.csv");
    let records = csv::ReaderBuilder::new().from_reader(&data[..]).into_records();
    records
        .map(|record| {
            let row = record.unwrap();
            [0, 1, 2].map(|index| row[index].to_string())
        })
        .collect()
}

/// Classifies the table with one more column.
fn classified(name: &str, cell: &str) -> Ended {
    let place = Workplace::new();
    place.write("lab.csv", format!("{NAMES},\"{name}\"\n{},{cell}\n", CELLS.join(",")));
    place.run(["classify", "--points", "lab.csv"])
}

/// The cells that are appended, of the last row.
fn appended(rows: &str, row: &str) -> String {
    rows.lines().last().unwrap().strip_prefix(row).unwrap_or_else(|| panic!("{rows}")).to_string()
}

#[test]
fn every_spelling_of_an_error_is_read_or_refused() {
    let spellings = spellings();
    assert!(spellings.len() > 60);
    for [name, gives, cell] in spellings {
        let shown = name.trim();
        let ended = match gives.as_str() {
            "refused" => {
                let parts = ["lab.csv:1: header, column ", shown, &cell, "(allowed: "];
                classified(&name, "1").expect_refusal(&parts);
                continue;
            }
            _ => classified(&name, &cell),
        };
        assert_eq!(ended.code, 0, "{name}: {}", ended.stderr);
        if gives == "not read" {
            let warning = format!("warning: columns that are not read: {shown}\n");
            assert!(
                ended.stderr.ends_with(&warning) && !ended.stderr.contains("error of"),
                "{name}: {}",
                ended.stderr
            );
            continue;
        }
        let line = format!("in SI: column {shown}: error of {gives}");
        assert!(
            ended.stderr.contains(&line) && !ended.stderr.contains("warning"),
            "{name}: {}",
            ended.stderr
        );
        // Each error is a hundredth of its value.
        let with_bar = KEYS
            .iter()
            .zip(CELLS)
            .map(|(key, cell)| if *key == gives { format!("{cell}±1%") } else { cell.to_string() });
        let row = with_bar.collect::<Vec<_>>().join(",");
        let place = Workplace::new();
        let bars = place.run_with_input(["classify", "--points", "-"], &format!("{NAMES}\n{row}\n"));
        let found = appended(&ended.stdout, &format!("{},{cell}", CELLS.join(",")));
        assert_eq!(found, appended(&bars.stdout, &row), "{name}");
        assert!(found.contains('['), "{name}: the error has no effect");
    }
}

#[test]
fn values_are_found_under_greek_symbols_and_in_any_layout() {
    let plain = Workplace::new()
        .run_with_input(["classify", "--points", "-"], &format!("{NAMES}\n{}\n", CELLS.join(",")));
    for names in [
        "a,b,D_c / µm,K / (MPa/mm),M [kg cm-2],σ [MPa],V₀ (µm/s)",
        "A,B,mean Dc (um),k mpa/mm,m kg/cm2,σₙ/MPa,V0..um.s-1.",
        "Direct Effect,Evolution Effect,Critical slip distance [um],Stiffness (MPa/mm),Mass per area (kg/cm2),\
         Normal stress (MPa),Loading velocity (um/s)",
    ] {
        let table = format!("{names}\n{}\n", CELLS.join(","));
        let ended = Workplace::new().run_with_input(["classify", "--points", "-"], &table);
        assert_eq!(ended.code, 0, "{names}: {}", ended.stderr);
        let row = CELLS.join(",");
        assert_eq!(appended(&ended.stdout, &row), appended(&plain.stdout, &row), "{names}");
    }
}

#[test]
fn an_error_is_given_once_and_only_where_it_is_used() {
    let place = Workplace::new();
    let row = CELLS.join(",");
    place.write("twice.csv", format!("{NAMES},Dc_err_um,u(Dc) [um]\n{row},0.2,0.2\n"));
    place.run(["classify", "--points", "twice.csv"]).expect_refusal(&[
        "twice.csv:1: header, column u(Dc) [um]: `Dc_err_um` gives the error of critical_slip_distance_m too",
    ]);
    place.write("lab.csv", format!("{NAMES},Dc_err_um,period_s\n{row},0.2,19\n"));
    let compared = place.run(["compare", "--runs", "lab.csv"]);
    assert!(
        compared.stderr.contains("column Dc_err_um: error of critical_slip_distance_m"),
        "{}",
        compared.stderr
    );
    let scene =
        "name = \"s\"\ntitle = \"S\"\n[sweep]\nwork = \"boundary\"\n[sweep.list]\nfile = \"lab.csv\"\n";
    place.write("s.toml", scene);
    place.run(["sweep", "s.toml", "--out", "out"]).expect_refusal(&[
        "lab.csv:1: header, column Dc_err_um: needs no errors: a sweep computes exact points",
    ]);
    place.write("runs.csv", format!("{NAMES},period_s,period_s_error\n{row},19,0.1\n"));
    place.run(["compare", "--runs", "runs.csv"]).expect_refusal(&[
        "runs.csv:1: header, column period_s_error: looks like an error and is not understood",
    ]);
    // The error of a column that nothing reads is not read either.
    for [first, second] in [["mu", "mu_std"], ["depth_m", "depth_err_m"], ["T [C]", "σ_T"]] {
        place.write("mu.csv", format!("{NAMES},{first},{second}\n{row},0.6,0.01\n"));
        let ended = place.run(["classify", "--points", "mu.csv"]);
        let warning = format!("not read: {first}, {second}\n");
        assert!(ended.code == 0 && ended.stderr.ends_with(&warning), "{}", ended.stderr);
    }
    // The column of what is solved for is not used, and neither is its error.
    place.write("solve.csv", format!("{NAMES},sigma_err_MPa,Dc_err_um\n{row},0.1,0.2\n"));
    let ended = place.run(["solve", "--for", "normal-stress", "--transition", "--points", "solve.csv"]);
    assert!(ended.code == 0 && ended.stderr.ends_with("not read: sigma_err_MPa\n"), "{}", ended.stderr);
    assert!(ended.stderr.contains("column Dc_err_um: error of critical_slip_distance_m times 1e-6"));
}

#[test]
fn an_error_without_a_unit_is_in_that_of_its_value() {
    let place = Workplace::new();
    let row = CELLS.join(",");
    place.write("lab.csv", format!("{NAMES},Dc_error\n{row},0.2\n"));
    let ended = place.run(["classify", "--points", "lab.csv"]);
    assert!(
        ended.stderr.contains("column Dc_error: error of critical_slip_distance_m times 1e-6"),
        "{}",
        ended.stderr
    );
    assert!(ended.stdout.contains('['), "{}", ended.stdout);
    // A value with a unit of its own has no column whose unit the error could have.
    place.write(
        "cells.csv",
        format!("{},Dc_error\n{},0.2\n", NAMES.replace(" [um]", ""), row.replace(",8,", ",8um,")),
    );
    place.run(["classify", "--points", "cells.csv"]).expect_refusal(&[
        "cells.csv:2: row 1, column Dc_error = 0.2: the value has a unit and its error has none",
    ]);
}

#[test]
fn what_a_command_wrote_can_be_read_again() {
    let place = Workplace::new();
    place.write("lab.csv", format!("{NAMES}\n{}\n", CELLS.join(",")));
    place.run(["simulate", "--points", "lab.csv", "--law", "slip", "--keep-going", "-o", "simulated.csv"]);
    let ended = place.run(["compare", "--runs", "simulated.csv"]);
    assert!(
        ended.code == 0 && ended.stderr.contains("peak_relative_error, period_relative_error"),
        "{}",
        ended.stderr
    );
}
