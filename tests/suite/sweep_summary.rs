//! Sweeps whose rows are summed up: the same bytes from any number of shards, and what the rows themselves say.

use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::harness::{Workplace, names_in};
use crate::sweep::{SCENE, block, merged, workplace};

const SUMMARY: &str = "[sweep.summary]\nby = [\"slip_mode\"]\n\
    [[sweep.summary.bins]]\ncolumn = \"normal_stress_pa\"\nfrom = 1e3\nto = 1e7\ncount = 4\n\
    [[sweep.summary.numbers]]\ncolumn = \"max_imaginary_per_s\"\nstatistics = [\"count\", \"least\", \"greatest\", \"sum\"]\n";

fn summed() -> Workplace {
    let place = workplace();
    place.write("sum.toml", format!("{SCENE}{SUMMARY}"));
    place
}

fn sweep(place: &Workplace, scene: &str, shard: &str, out: &str) {
    place.run(["sweep", scene, "--shard", shard, "--out", out, "--threads", "2"]).expect_success();
}

#[test]
fn a_summary_has_the_same_bytes_from_any_number_of_shards() {
    let place = summed();
    sweep(&place, "sum.toml", "0/1", "one");
    let whole = merged(&place, "one");
    assert!(place.read(&block(3).replace("blocks", "one")).contains("\nholds summary 2\n"));
    for (count, order) in [(4, vec![2, 0, 3, 1]), (7, vec![6, 1, 0, 5, 2, 4, 3])] {
        let out = format!("of-{count}");
        for index in order {
            sweep(&place, "sum.toml", &format!("{index}/{count}"), &out);
        }
        assert_eq!(merged(&place, &out), whole, "{count} shards");
    }
}

#[test]
fn a_summary_says_what_its_rows_say() {
    let place = summed();
    sweep(&place, "sum.toml", "0/1", "sums");
    sweep(&place, "s.toml", "0/1", "rows");
    let (sums, rows) = (merged(&place, "sums"), merged(&place, "rows"));
    let columns: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    let place_of = |name: &str| columns.iter().position(|column| *column == name).unwrap();
    let (mode, frequency) = (place_of("slip_mode"), place_of("max_imaginary_per_s"));
    let mut counted = 0;
    for line in sums.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let bin: i32 = cells[0].parse().unwrap();
        let (from, to) = (10f64.powi(bin + 2), 10f64.powi(bin + 3));
        let inside = |stress: f64| stress >= from * 0.999_999 && (stress < to * 0.999_999 || bin == 4);
        let members: Vec<f64> = rows
            .lines()
            .skip(1)
            .map(|row| row.split(',').collect::<Vec<_>>())
            .filter(|row| inside(row[0].parse().unwrap()) && row[mode] == cells[1])
            .map(|row| row[frequency].parse().unwrap())
            .collect();
        assert_eq!(cells[2].parse::<usize>().unwrap(), members.len(), "{line}");
        let number = |index: usize| cells[index].parse::<f64>().unwrap();
        assert_eq!(number(4), members.iter().copied().fold(f64::INFINITY, f64::min), "{line}");
        assert_eq!(number(5), members.iter().copied().fold(0.0, f64::max), "{line}");
        // Another order of addition: some hundred roundings of terms of one sign.
        let sum: f64 = members.iter().sum();
        assert!((number(6) - sum).abs() <= 1e-12 * sum, "{line}");
        counted += members.len();
    }
    assert_eq!(counted, 37 * 31);
}

#[test]
fn a_sweep_killed_at_any_time_goes_on_and_ends_with_the_same_bytes() {
    let place = summed();
    sweep(&place, "sum.toml", "0/1", "whole");
    for blocks in [1, 4, 9] {
        let out = format!("killed-{blocks}");
        let mut child = Command::new(env!("CARGO_BIN_EXE_slipmode"))
            .args(["sweep", "sum.toml", "--out", &out, "--threads", "1"])
            .current_dir(place.path(""))
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let limit = Instant::now() + Duration::from_secs(60);
        let is_under_way = |child: &mut std::process::Child| {
            let done = place.path(&out).is_dir() && names_in(&place.path(&out)).len() >= blocks;
            !done && child.try_wait().unwrap().is_none() && Instant::now() < limit
        };
        while is_under_way(&mut child) {
            sleep(Duration::from_micros(200));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        sweep(&place, "sum.toml", "0/1", &out);
        assert_eq!(merged(&place, &out), merged(&place, "whole"), "killed after {blocks} blocks");
    }
}

#[test]
fn a_column_that_rows_do_not_have_is_named_before_anything_is_computed() {
    let place = workplace();
    place.write("bad.toml", format!("{SCENE}[sweep.summary]\nby = [\"slip_mood\"]\n"));
    place
        .run(["sweep", "bad.toml", "--out", "o"])
        .expect_refusal(&["sweep.summary names the column `slip_mood`", "slip_mode"]);
    assert_eq!(place.names(), ["bad.toml", "s.toml"]);
}

#[test]
fn the_asymptotes_error_alone_is_that_of_the_boundary_rows() {
    let place = workplace();
    let head = SCENE.split("[sweep]").next().unwrap();
    let grid = "[sweep.grid]\nnormal_stress_pa = { from = 1e3, to = 1e7, points = 9 }\n\
        loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 7 }\n";
    for work in ["boundary", "asymptote-error"] {
        place.write(&format!("{work}.toml"), format!("{head}[sweep]\nwork = \"{work}\"\n{grid}"));
        sweep(&place, &format!("{work}.toml"), "0/1", work);
    }
    let (long, short) = (merged(&place, "boundary"), merged(&place, "asymptote-error"));
    assert_eq!(
        short.lines().next().unwrap(),
        "normal_stress_pa,loading_velocity_m_per_s,log10_normal_stress_distance,arc,asymptote,asymptote_relative_error"
    );
    for (long, short) in long.lines().zip(short.lines()).skip(1) {
        let (long, short): (Vec<&str>, Vec<&str>) = (long.split(',').collect(), short.split(',').collect());
        assert_eq!(long[..2], short[..2]);
        assert_eq!((long[5], long[7]), (short[3], short[4]), "{long:?}");
        for (stated, found) in [(long[3], short[2]), (long[8], short[5])] {
            let (stated, found): (f64, f64) = (stated.parse().unwrap(), found.parse().unwrap());
            assert!((stated - found).abs() <= 1e-8 * stated.abs().max(1e-3), "{long:?} {short:?}");
        }
    }
    assert_eq!(short.lines().count(), 64);
}
