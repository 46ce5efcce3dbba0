//! What is measured: commands that differ in one number.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::Path;

use crate::least_squares::Form;

/// Commands that differ in one number, from small to large.
pub struct Series {
    pub name: &'static str,
    /// What the number counts.
    pub variable: &'static str,
    /// The command with `N` in place of the number.
    pub template: String,
    pub commands: Vec<SizedCommand>,
    /// The form of the law that is expected, if any.
    pub form: Option<Form>,
    /// A size that is asked about and not measured.
    pub asked: Option<f64>,
}

/// One command.
pub struct SizedCommand {
    pub size: f64,
    pub arguments: Vec<String>,
}

const SLIDER: &str = "-a 0.004 -b 0.006 -d 1e-5 -k 1e7 -m 1000";
pub(super) const HEADER: &str = "direct_effect,evolution_effect,critical_slip_distance_m,stiffness_pa_per_m,\
    mass_per_area_kg_per_m2,normal_stress_pa,loading_velocity_m_per_s";

/// Every series; the files that the commands read are written into the folder.
///
/// # Errors
/// When a file cannot be written.
pub fn all(folder: &Path) -> io::Result<Vec<Series>> {
    for rows in ROWS {
        fs::write(folder.join(format!("rows-{rows}.csv")), rows_of(rows, [-9.0, 1.0], [2.0, 9.0]))?;
    }
    for runs in RUNS {
        fs::write(folder.join(format!("runs-{runs}.csv")), rows_of(runs, [-6.0, -1.0], [3.0, 7.0]))?;
    }
    let grid = |threads: &str, side: &str| {
        format!(
            "classify {SLIDER} --grid-loading-velocity 1e-9:10:{side} --grid-normal-stress 1e2:1e9:{side} --threads {threads}"
        )
    };
    Ok(vec![
        Series {
            asked: Some(1e12),
            ..squares("points of a grid, 1 thread", grid("1", "N"), &[1000, 3163, 10_000, 31_623])
        },
        series("points of a grid of 10^8, threads", "threads", grid("N", "10000"), &[1, 2], None),
        Series {
            asked: Some(1e9),
            ..series("rows of a file classified", "rows", files("classify", "rows"), &ROWS, START)
        },
        Series {
            asked: Some(1e7),
            ..series(
                "rows of a file simulated",
                "runs",
                files("simulate --law slip", "runs") + " --tolerance 1e-2",
                &RUNS,
                START,
            )
        },
        series(
            "tolerance of 1024 simulations",
            "1/tolerance",
            "simulate --law slip --points runs-1024.csv --threads 1 --tolerance 1/N".into(),
            &[100, 10_000, 1_000_000, 100_000_000, 10_000_000_000],
            Some(Form::Power),
        ),
        series(
            "certified digits of the roots",
            "digits",
            format!("roots {SLIDER} -s 1e5 -v 1e-3 --digits N"),
            &[30_000, 100_000, 300_000, 1_000_000],
            Some(Form::Power),
        ),
    ])
}

/// Beside what each row takes, the program has to be started.
const START: Option<Form> = Some(Form::Beside(0.0));
/// Beside what each point takes, each row of a square has to be prepared.
const ROWS_OF_A_GRID: Option<Form> = Some(Form::Beside(0.5));

/// Rows of the files that are classified.
const ROWS: [u64; 4] = [10_000, 100_000, 300_000, 1_000_000];
/// Rows of the files that are simulated.
const RUNS: [u64; 4] = [64, 256, 1024, 4096];

fn files(command: &str, name: &str) -> String {
    format!("{command} --points {name}-N.csv --threads 1")
}

fn series(
    name: &'static str,
    variable: &'static str,
    template: String,
    sizes: &[u64],
    form: Option<Form>,
) -> Series {
    let command = |size: &u64| SizedCommand { size: *size as f64, arguments: words(&template, *size) };
    Series { name, variable, commands: sizes.iter().map(command).collect(), template, form, asked: None }
}

/// A series whose number is the side of a square of points.
fn squares(name: &'static str, template: String, sides: &[u64]) -> Series {
    let mut series = series(name, "points", template, sides, ROWS_OF_A_GRID);
    series.commands.iter_mut().for_each(|command| command.size *= command.size);
    series
}

/// The words of a command; `N` becomes the number, and `1/N` its inverse.
fn words(template: &str, number: u64) -> Vec<String> {
    let digits = number.to_string();
    let word = |word: &str| match word {
        "1/N" => format!("{:e}", 1.0 / number as f64),
        _ => word.replace('N', &digits),
    };
    template.split_whitespace().map(word).collect()
}

/// Rows over a rectangle of log10 V0 and log10 σ, written with seven digits.
fn rows_of(count: u64, velocity: [f64; 2], stress: [f64; 2]) -> String {
    let mut text = format!("{HEADER}\n");
    for index in 0..count {
        let (velocity, stress) = place(index, velocity, stress);
        let _ = writeln!(text, "0.004,0.006,1e-5,1e7,1000,{stress:.6e},{velocity:.6e}");
    }
    text
}

/// V0 and σ at a place of a rectangle of their logarithms: a deterministic sequence that fills it evenly.
pub(super) fn place(index: u64, [v0, v1]: [f64; 2], [s0, s1]: [f64; 2]) -> (f64, f64) {
    // Steps by the plastic number, the two-dimensional companion of the golden ratio.
    const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];
    let [x, y] = STEPS.map(|step| (step * index as f64).fract());
    (libm::exp10(v0 + (v1 - v0) * x), libm::exp10(s0 + (s1 - s0) * y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_and_its_inverse_stand_where_the_template_says() {
        assert_eq!(words("roots --digits N x-N.csv", 30), ["roots", "--digits", "30", "x-30.csv"]);
        assert_eq!(words("-t 1/N", 100), ["-t", "1e-2"]);
    }

    #[test]
    fn sizes_of_squares_are_points_and_rows_stay_in_their_rectangle() {
        assert_eq!(squares("a", "N".into(), &[10, 20]).commands[1].size, 400.0);
        let text = rows_of(50, [-2.0, -1.0], [3.0, 4.0]);
        for row in text.lines().skip(1) {
            let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
            assert!((1e3..=1e4).contains(&cells[5]) && (1e-2..=1e-1).contains(&cells[6]), "{row}");
        }
        assert_eq!(text.lines().count(), 51);
    }
}
