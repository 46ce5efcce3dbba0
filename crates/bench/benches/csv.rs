//! Where the time of `classify --points` goes: reading, splitting, parsing, computing, formatting and writing a million rows.
//!
//! Each stage is run alone on one thread over the whole file, by the library's functions that the command calls; the command
//! itself is run last, on one thread. Times depend on the machine and on its load: read the shares.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use csv_core::{ReadRecordResult, Reader};
use slipmode::scene::Quantity;
use slipmode_bench::process::build_dist;
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Dd, parse_decimal_to_dd};
use slipmode_core::stability::batch::classify_points;
use slipmode_core::stability::{Classification, InertialThreshold};

const ROWS: usize = 1_000_000;
const REPETITIONS: usize = 3;

/// Steps by the plastic number, the two-dimensional companion of the golden ratio: they fill the rectangle evenly.
const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];

fn file() -> String {
    let mut text = Quantity::ALL.map(Quantity::as_str).join(",") + "\n";
    for index in 0..ROWS {
        let [x, y] = STEPS.map(|step| (step * index as f64).fract());
        let (stress, velocity) = (libm::exp10(2.0 + 7.0 * y), libm::exp10(-9.0 + 10.0 * x));
        writeln!(text, "0.004,0.006,1e-5,1e7,1000,{stress:.6e},{velocity:.6e}").unwrap();
    }
    text
}

/// The shortest of a few runs, and what the last one gave.
fn timed<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut run = || {
        let start = Instant::now();
        let result = black_box(work());
        (start.elapsed().as_secs_f64(), result)
    };
    let (mut best, mut result) = run();
    for _ in 1..REPETITIONS {
        let (seconds, next) = run();
        best = best.min(seconds);
        result = next;
    }
    (best, result)
}

/// The ends of all cells below the header, and their unquoted bytes.
fn split(bytes: &[u8]) -> (Vec<u8>, Vec<[usize; 7]>) {
    let mut reader = Reader::new();
    let (mut input, mut cells) = (bytes, vec![0; bytes.len()]);
    let (mut filled, mut rows, mut ends) = (0, Vec::new(), [0; 8]);
    loop {
        let (result, read, written, _) = reader.read_record(input, &mut cells[filled..], &mut ends);
        input = &input[read..];
        match result {
            ReadRecordResult::Record => {
                rows.push(std::array::from_fn(|cell| filled + ends[cell]));
                filled += written;
            }
            ReadRecordResult::InputEmpty if !input.is_empty() => {}
            _ if read == 0 => break,
            _ => filled += written,
        }
    }
    rows.remove(0);
    (cells, rows)
}

fn parse(cells: &[u8], rows: &[[usize; 7]]) -> Vec<Parameters<Dd>> {
    let mut start = rows.first().map_or(0, |_| Quantity::ALL.map(Quantity::as_str).concat().len());
    let row = |ends: &[usize; 7]| {
        Parameters::from(ends.map(|end| {
            let text = std::str::from_utf8(&cells[start..end]).unwrap();
            start = end;
            parse_decimal_to_dd(text).unwrap()
        }))
    };
    rows.iter().map(row).collect()
}

fn format_row(found: &Classification, out: &mut String) {
    write!(
        out,
        ",{},{},{},{},{},{},{}",
        found.transition_sign,
        found.boundary_sign,
        found.spectral_class.as_str(),
        found.slip_mode.as_str(),
        found.max_real_per_s,
        found.max_imaginary_per_s,
        found.precision_level.as_str(),
    )
    .unwrap();
}

fn main() {
    let folder = env::temp_dir().join(format!("slipmode-csv-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let (input, output) = (folder.join("in.csv"), folder.join("out.csv"));
    fs::write(&input, file()).unwrap();

    let (reading, bytes) = timed(|| fs::read(&input).unwrap());
    let (splitting, (cells, rows)) = timed(|| split(&bytes));
    let (parsing, points) = timed(|| parse(&cells, &rows));
    let threshold = InertialThreshold::default();
    let (computing, found) = timed(|| {
        let found = classify_points(&points, &threshold);
        found.into_iter().collect::<Option<Vec<Classification>>>().unwrap()
    });
    let (formatting, text) = timed(|| {
        let mut text = String::with_capacity(2 * bytes.len());
        found.iter().for_each(|found| format_row(found, &mut text));
        text
    });
    let (writing, ()) = timed(|| {
        let rows: Vec<u8> = [&bytes[..], text.as_bytes()].concat();
        fs::write(&output, rows).unwrap();
    });
    let stages = [
        ("reading", reading),
        ("splitting", splitting),
        ("parsing", parsing),
        ("computing", computing),
        ("formatting", formatting),
        ("writing", writing),
    ];
    let total: f64 = stages.iter().map(|(_, seconds)| seconds).sum();
    for (stage, seconds) in stages {
        println!(
            "{stage:>11} {:6.1} ns a row, {:4.1} %",
            seconds / ROWS as f64 * 1e9,
            100.0 * seconds / total
        );
    }
    let program = build_dist().unwrap();
    let (command, ()) = timed(|| {
        let mut command = Command::new(&program);
        command.args(["classify", "--threads", "1", "--points"]).arg(&input).arg("--output").arg(&output);
        assert!(command.status().unwrap().success());
    });
    println!("the stages take {:.2} s, the command {command:.2} s, for {ROWS} rows on one thread", total);
    fs::remove_dir_all(&folder).unwrap();
}
