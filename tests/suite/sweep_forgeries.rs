//! Blocks whose heading was damaged, and blocks whose contents were altered and sealed with a right digest.

use std::time::{Duration, Instant};

use slipmode::archive::sha256_hex;

use crate::harness::Workplace;
use crate::sweep::{block, merged, swept, workplace};

/// The lines of a heading before its digest.
const STATED_LINES: usize = 8;

/// The block's heading before its digest, and its CSV.
fn parts(content: &str) -> (String, String) {
    let (heading, csv) = content.split_once("\n\n").unwrap();
    (heading.lines().take(STATED_LINES).map(|line| format!("{line}\n")).collect(), csv.to_string())
}

/// A block with the right length, length of column names, and digest.
pub fn sealed(stated: &str, csv: &str) -> String {
    let columns = csv.split_inclusive('\n').next().unwrap_or_default().len();
    let numbers = [("columns ", columns), ("bytes ", csv.len())];
    let line = |line: &str| {
        let number = numbers.iter().find(|(key, _)| line.starts_with(key));
        number.map_or_else(|| format!("{line}\n"), |(key, number)| format!("{key}{number}\n"))
    };
    let stated: String = stated.lines().map(line).collect();
    format!("{stated}sha256 {}\n\n{csv}", sha256_hex(format!("{stated}{csv}").as_bytes()))
}

/// A merge that names this block, this problem and no other block.
#[track_caller]
fn expect_only(place: &Workplace, number: usize, problem: &str) {
    let started = Instant::now();
    let ended = place.run(["merge", "blocks", "-o", "out.csv"]);
    assert!(started.elapsed() < Duration::from_secs(20), "{:?}", started.elapsed());
    let name = format!("block-{number:09}.csv");
    assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{}", ended.stderr);
    for line in ended.stderr.lines() {
        assert!(
            line.contains(&format!("{name}: ")) && line.contains(problem),
            "{problem:?} is not in {line:?}"
        );
    }
    assert!(!place.path("out.csv").exists());
}

#[test]
fn a_flipped_bit_in_a_heading_is_damage_of_that_block_and_it_is_computed_again() {
    let place = swept();
    let whole = merged(&place, "blocks");
    for (number, line, column, bit) in
        [(0, 1, 8, 1), (0, 2, 9, 2), (5, 1, 40, 1), (5, 2, 30, 4), (5, 3, 6, 1)]
    {
        let sound = place.read(&block(number));
        let start: usize = sound.split_inclusive('\n').take(line).map(str::len).sum();
        let mut bytes = sound.clone().into_bytes();
        bytes[start + column] ^= bit;
        place.write(&block(number), bytes);
        expect_only(&place, number, "its SHA-256 is not the stated one");
        let missing = place.run(["merge", "blocks", "--missing"]).expect_success();
        assert_eq!(missing, format!("{number}\n"));
        place.run(["sweep", "s.toml", "--out", "blocks"]).expect_success();
        assert_eq!(place.read(&block(number)), sound);
    }
    assert_eq!(merged(&place, "blocks"), whole);
}

#[test]
fn altered_rows_and_columns_with_a_right_digest_are_refused_and_computed_again() {
    let place = swept();
    let sound = place.read(&block(5));
    let (stated, csv) = parts(&sound);
    assert_eq!(sealed(&stated, &csv), sound);
    let (columns, rows) = csv.split_once('\n').unwrap();
    let last = rows.lines().last().unwrap();
    let without_last = &csv[..csv.len() - last.len() - 1];
    let fewer = stated.replace("points 100", "points 99");
    for (stated, csv, problem) in [
        (&stated, format!("{csv}{last}\n"), "contains 101 rows, not 100"),
        (&stated, without_last.to_string(), "contains 99 rows, not 100"),
        (&fewer, without_last.to_string(), "has 99 points, not 100 as in block-000000000.csv"),
        (&stated, csv.replacen("slip_mode", "slip_mood", 1), "has other columns than block-000000000.csv"),
        (&stated, csv.replacen(last, &format!("{last},1"), 1), "row 100 has another number of cells"),
        (&stated, csv.replacen(last, &format!("\0{}", &last[1..]), 1), "contains the character U+0000"),
        (&stated, format!("{columns}\n{}", rows.trim_end()), "a line does not end where its heading says"),
    ] {
        place.write(&block(5), sealed(stated, &csv));
        expect_only(&place, 5, problem);
        place.run(["sweep", "s.toml", "--out", "blocks"]).expect_success();
        assert_eq!(place.read(&block(5)), sound, "{problem}");
    }
}

#[test]
fn a_count_of_blocks_that_no_sweep_has_is_refused_at_once() {
    for count in ["18446744073709551615", "10000001"] {
        let place = swept();
        let (stated, csv) = parts(&place.read(&block(0)));
        let altered = stated.replace("block 0 of 12", &format!("block 0 of {count}"));
        assert_ne!(altered, stated);
        place.write(&block(0), sealed(&altered, &csv));
        let problem = format!("is one of {count} blocks (allowed: at most 10000000)");
        expect_only(&place, 0, &problem);
        place.run(["merge", "blocks", "--missing"]).expect_refusal(&[&problem]);
    }
}

#[test]
fn a_summary_of_other_rows_than_its_points_is_refused() {
    let place = workplace();
    let scene = place.read("s.toml") + "[sweep.summary]\nby = [\"slip_mode\"]\n";
    place.write("s.toml", &scene);
    place.run(["sweep", "s.toml", "--out", "blocks"]).expect_success();
    let (stated, csv) = parts(&place.read(&block(5)));
    let (columns, rows) = csv.split_once('\n').unwrap();
    let (first, rest) = rows.split_once('\n').unwrap();
    let (mode, count) = first.rsplit_once(',').unwrap();
    let more = count.parse::<u64>().unwrap() + 1;
    place.write(&block(5), sealed(&stated, &format!("{columns}\n{mode},{more}\n{rest}")));
    expect_only(&place, 5, "sums up 101 rows, not 100");
}
