//! Rows of `classify --points` whose numbers are the same and printed in another layout.
//!
//! A layout that the fast reader refuses, or whose rows are decided by rationals, would show in the count; one that is only
//! slow to read, in the CPU time.

use std::fmt::Write as _;
use std::fs;

use slipmode_core::friction::Parameters;
use slipmode_core::number::parse_decimal_to_dd;
use slipmode_core::stability::InertialThreshold;
use slipmode_core::stability::batch::classify_points;

use super::Sweep;
use crate::cost::measure;
use crate::process;
use crate::repository;
use crate::split_mix::SplitMix64;

/// Rows of a file.
const ROWS: usize = 100_000;

/// log10 of the ends of a, b, D_c, K, M, σ and V0.
const DECADES: [[f64; 2]; 7] =
    [[-4.0, -1.5], [-4.0, -1.5], [-7.0, -2.0], [4.0, 12.0], [-2.0, 7.0], [2.0, 9.0], [-9.0, 1.0]];

/// A layout of numbers: its name, and how it writes one.
type Layout = (&'static str, fn(f64) -> String);

/// Layouts of the same numbers, the one with an exponent first.
struct Family {
    name: &'static str,
    file: &'static str,
    layouts: &'static [Layout],
    /// The highest allowed ratio of the time of a layout to that of the one before.
    highest_ratio: f64,
}

const EXPONENT: Layout = ("exponent", |value| format!("{value:.16e}"));

/// Decimals of up to 40 places have up to 2.5 times as many characters as those with an exponent.
const FAMILIES: [Family; 3] = [
    Family {
        name: "7 digits",
        file: "7",
        layouts: &[
            ("exponent", |value| format!("{value:.6e}")),
            ("plain", |value| plain(&format!("{value:.6e}"))),
        ],
        highest_ratio: 1.3,
    },
    Family {
        name: "17 digits",
        file: "17",
        layouts: &[EXPONENT, ("shortest plain", |value| format!("{value}"))],
        highest_ratio: 1.3,
    },
    Family {
        name: "more places than digits",
        file: "places",
        layouts: &[
            EXPONENT,
            ("20 places", |value| format!("{value:.20}")),
            ("40 places", |value| format!("{value:.40}")),
        ],
        highest_ratio: 1.5,
    },
];

/// The same decimal without an exponent.
fn plain(text: &str) -> String {
    let value: f64 = text.parse().unwrap_or_default();
    format!("{value}")
}

/// The sweeps over layouts, a count and a time for either number of digits.
///
/// # Errors
/// When the program cannot be built or run, or a file cannot be written.
pub(super) fn sweeps() -> Result<Vec<Sweep>, String> {
    let (program, folder) = (process::build_dist()?, repository::root().join("target/cost"));
    fs::create_dir_all(&folder).map_err(|error| format!("target/cost: {error}"))?;
    let mut sweeps = Vec::new();
    for family in FAMILIES {
        let (mut counts, mut times) = (Vec::new(), Vec::new());
        for (name, write) in family.layouts {
            let rows = rows(*write);
            counts.push((name.to_string(), decided_together(&rows) as f64));
            let file = format!("layout-{}-{}.csv", family.file, name.replace(' ', "-"));
            fs::write(folder.join(&file), text(&rows))
                .map_err(|error| format!("target/cost/{file}: {error}"))?;
            let arguments = ["classify", "--quiet", "--threads", "1", "--points", &file].map(str::to_string);
            let cpu_s = measure::run(&program, &arguments, &folder)?.cpu_s;
            times.push((name.to_string(), cpu_s * 1e6 / ROWS as f64));
        }
        let sweep = |quantity, points, allowed_ratio| Sweep {
            name: format!("rows of a file classified: {}", family.name),
            variable: "layout",
            quantity,
            points,
            allowed_ratio,
        };
        // Two of a hundred thousand rows may lie so near to a limit that their digits matter.
        sweeps.push(sweep("rows decided in double-double", counts, 0.9999..=1.0001));
        sweeps.push(sweep("CPU us per row", times, 0.0..=family.highest_ratio));
    }
    Ok(sweeps)
}

fn rows(write: fn(f64) -> String) -> Vec<[String; 7]> {
    let mut random = SplitMix64(13);
    let row = |_| DECADES.map(|[low, high]| write(libm::exp10(random.between(low, high))));
    (0..ROWS).map(row).collect()
}

fn text(rows: &[[String; 7]]) -> String {
    let mut text = format!("{}\n", crate::cost::series::HEADER);
    for row in rows {
        let _ = writeln!(text, "{}", row.join(","));
    }
    text
}

/// The rows that need no exact arithmetic.
fn decided_together(rows: &[[String; 7]]) -> usize {
    let read = |row: &[String; 7]| {
        let cells: Option<Vec<_>> = row.iter().map(|cell| parse_decimal_to_dd(cell)).collect();
        cells.and_then(|cells| <[_; 7]>::try_from(cells).ok()).map(Parameters::from)
    };
    let points: Vec<_> = rows.iter().filter_map(read).collect();
    classify_points(&points, &InertialThreshold::default()).iter().flatten().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_in_any_layout_is_decided_without_rationals_and_one_beyond_it_is_not() {
        for (_, write) in FAMILIES.iter().flat_map(|family| family.layouts) {
            let rows: Vec<_> = rows(*write).into_iter().take(200).collect();
            assert_eq!(decided_together(&rows), 200, "{:?}", rows[0]);
        }
        let beyond = [[("1e-50"); 7].map(str::to_string)];
        assert_eq!(decided_together(&beyond), 0);
    }

    #[test]
    fn layouts_of_seven_digits_are_the_same_decimals() {
        for value in [1.234_567_8e-5, 2.5e7, 0.01] {
            let [first, second] = [0, 1].map(|layout| FAMILIES[0].layouts[layout].1(value));
            assert!(!second.contains('e'), "{second}");
            assert_eq!(
                slipmode_core::number::parse_decimal(&first),
                slipmode_core::number::parse_decimal(&second)
            );
        }
    }
}
