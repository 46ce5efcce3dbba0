//! Times that docs/performance.md states, measured again: as multiples of one of them, so that the machine does not count.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::harness::{HEADER, Workplace, is_slow};
use crate::random::Random;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// How far a measured multiple may be from the stated one.
const FACTOR: f64 = 2.0;

/// What a row of the table does, by its name; `$S` is the program. The first row is the unit, and the last takes long.
const WORKS: [(&str, &str); 4] = [
    (
        "roots to 300 000 digits",
        "$S roots -a 0.004 -b 0.006 -d 1e-5 -k 1e7 -m 1000 -s 1e5 -v 1e-3 --digits 300000",
    ),
    (
        "`classify` with ±10 % of all seven values, 20 times",
        "for i in {1..20}; do $S classify -a 0.009±10% -b 0.0126±10% -d 8e-6±10% -k 2e9±10% -m 2400±10% -s 5e6±10% -v 1e-5±10%; done",
    ),
    ("`classify` of 100 000 rows", "$S classify --points rows.csv --threads 1 -o out.csv"),
    ("`verify` of the report on Im & Avouac", "$S verify $ROOT/reports/im-avouac"),
];

/// The CPU time of a script's programs, in seconds; the shell itself takes nearly none.
fn cpu_s(place: &Workplace, script: &str) -> f64 {
    let ended = Command::new("bash")
        .args(["-c", &format!("set -e\n{{ {script}\n}} > said.txt 2>&1\ntimes")])
        .env("S", env!("CARGO_BIN_EXE_slipmode"))
        .env("ROOT", ROOT)
        .env("LC_ALL", "C")
        .current_dir(place.path(""))
        .output()
        .unwrap();
    assert!(ended.status.success(), "{script}: {}", place.read("said.txt"));
    let times = String::from_utf8(ended.stdout).unwrap();
    let of_programs = times.lines().last().unwrap();
    let seconds = |time: &str| {
        let (minutes, seconds) = time.trim_end_matches('s').split_once('m').unwrap();
        60.0 * minutes.parse::<f64>().unwrap() + seconds.parse::<f64>().unwrap()
    };
    of_programs.split_whitespace().map(seconds).sum()
}

/// The number that the document gives for a work.
fn documented_s(name: &str) -> f64 {
    let text = fs::read_to_string(Path::new(ROOT).join("docs/performance.md")).unwrap();
    let row = text.lines().find_map(|line| line.strip_prefix(&format!("| {name} | ")));
    let row = row.unwrap_or_else(|| panic!("docs/performance.md has no time of {name}"));
    row.trim_end_matches(" |").parse().unwrap()
}

#[test]
fn documented_times_are_within_a_factor_of_two() {
    let works = &WORKS[..WORKS.len() - usize::from(!is_slow())];
    let place = Workplace::new();
    let mut random = Random(3);
    let mut rows = format!("{HEADER}\n");
    for _ in 0..100_000 {
        let mut around = |value: f64| value * 10f64.powf(random.whole(-1000, 1000) as f64 / 1000.0);
        let [a, b, d, k, m, s, v] = [0.009, 0.0126, 8e-6, 2e9, 2400.0, 5e6, 1e-3].map(&mut around);
        writeln!(rows, "{a:.6e},{b:.6e},{d:.6e},{k:.6e},{m:.6e},{s:.6e},{v:.6e}").unwrap();
    }
    place.write("rows.csv", rows);
    // The best of three, or one that takes long: what disturbs a run makes it slower.
    let runs = |place: usize| if place + 1 < WORKS.len() { 3 } else { 1 };
    let best = |(n, (_, script)): (usize, &(&str, &str))| {
        (0..runs(n)).map(|_| cpu_s(&place, script)).fold(f64::INFINITY, f64::min)
    };
    let measured: Vec<f64> = works.iter().enumerate().map(best).collect();
    let wrong: Vec<String> = works
        .iter()
        .zip(&measured)
        .map(|((name, _), time)| (name, time / measured[0], documented_s(name) / documented_s(WORKS[0].0)))
        .filter(|(_, found, stated)| !(found / stated < FACTOR && stated / found < FACTOR))
        .map(|(name, found, stated)| format!("{name}: {found:.3} units, documented {stated:.3}"))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
