//! Sweeps that find cliffs: the cost of one thing while one number changes, where each value may differ from the one before by a
//! stated ratio only.
//!
//! A count (steps, evaluations, a share of rows) is preferred: it is the same on every machine. Where only a time tells, it is CPU
//! time of one thread, best of several rounds in which all points of the sweep take turns.

mod boundary_digits;
mod decimals;
mod tolerances;
mod velocities;

use std::fmt::Write as _;
use std::ops::RangeInclusive;

/// The cost of one thing while one number changes.
pub struct Sweep {
    /// What is done, such as `boundary at given normal stress`.
    pub name: String,
    /// What changes from point to point.
    pub variable: &'static str,
    /// What is measured, with its unit.
    pub quantity: &'static str,
    /// Label and value of each point, in order.
    pub points: Vec<(String, f64)>,
    /// The allowed ratio of each value to the one before.
    pub allowed_ratio: RangeInclusive<f64>,
}

impl Sweep {
    /// The ratio of each value to the one before; none at the first.
    fn ratios(&self) -> impl Iterator<Item = Option<f64>> {
        let pairs = self.points.windows(2).map(|pair| Some(pair[1].1 / pair[0].1));
        std::iter::once(None).chain(pairs)
    }

    /// One message for each ratio outside the bounds. A value that is not finite has no ratio inside them.
    fn violations(&self) -> Vec<String> {
        let (low, high) = self.allowed_ratio.clone().into_inner();
        let outside = |(index, ratio): (usize, Option<f64>)| {
            let ratio = ratio.filter(|ratio| !self.allowed_ratio.contains(ratio))?;
            let [(before, one), (after, next)] = &self.points[index - 1..=index] else { return None };
            Some(format!(
                "{}: {} is {one:.4} at {} {before} and {next:.4} at {after}, ratio {ratio:.3} (allowed: {low} to {high})",
                self.name, self.quantity, self.variable
            ))
        };
        self.ratios().enumerate().filter_map(outside).collect()
    }
}

/// A family of sweeps: its name, and how it is measured.
type Family = (&'static str, fn() -> Result<Vec<Sweep>, String>);

const FAMILIES: [Family; 4] = [
    ("digits of the boundary", boundary_digits::sweeps),
    ("layouts of decimals", decimals::sweeps),
    ("tolerances", tolerances::sweeps),
    ("loading velocities of decays", velocities::sweeps),
];

/// Measures every sweep, writes `sweeps.csv` and `sweeps.md` and prints the Markdown.
///
/// # Errors
/// When a sweep cannot be measured, a file cannot be written, or a ratio is outside its bounds.
pub fn run() -> Result<(), String> {
    let mut sweeps = Vec::new();
    for (name, measure) in FAMILIES {
        eprintln!("cost: sweeps of {name}");
        sweeps.extend(measure()?);
    }
    let markdown = markdown(&sweeps);
    super::write("sweeps", &csv(&sweeps), &markdown)?;
    print!("{markdown}");
    let violations: Vec<String> = sweeps.iter().flat_map(Sweep::violations).collect();
    if violations.is_empty() { Ok(()) } else { Err(violations.join("\n")) }
}

fn csv(sweeps: &[Sweep]) -> String {
    let mut text = String::from("sweep,variable,at,quantity,value,lowest_ratio,highest_ratio\n");
    for sweep in sweeps {
        let (low, high) = (sweep.allowed_ratio.start(), sweep.allowed_ratio.end());
        for (at, value) in &sweep.points {
            let Sweep { name, variable, quantity, .. } = sweep;
            // No cell has a comma or a quote.
            let _ = writeln!(text, "{name},{variable},{at},{quantity},{value:.6e},{low},{high}");
        }
    }
    text
}

fn markdown(sweeps: &[Sweep]) -> String {
    let mut text = String::from("# Sweeps\n\nCommand: `cargo xtask cost --sweeps`.\n\n");
    for sweep in sweeps {
        let (low, high) = (sweep.allowed_ratio.start(), sweep.allowed_ratio.end());
        let _ = writeln!(text, "## {}\n", sweep.name);
        let _ = writeln!(
            text,
            "| {} | {} | ratio ({low} to {high}) |\n|--:|--:|--:|",
            sweep.variable, sweep.quantity
        );
        for ((at, value), ratio) in sweep.points.iter().zip(sweep.ratios()) {
            let ratio = ratio.map_or_else(String::new, |ratio| format!("{ratio:.3}"));
            let _ = writeln!(text, "| {at} | {value:.4} | {ratio} |");
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sweep(values: &[f64]) -> Sweep {
        Sweep {
            name: "boundary".into(),
            variable: "digits",
            quantity: "Newton steps",
            points: values.iter().enumerate().map(|(index, value)| (index.to_string(), *value)).collect(),
            allowed_ratio: 0.9..=1.5,
        }
    }

    #[test]
    fn a_ratio_outside_its_bounds_is_named() {
        assert!(sweep(&[1.0, 1.5, 1.4]).violations().is_empty());
        let [up] = &sweep(&[2.0, 4.0]).violations()[..] else { panic!("one violation") };
        assert!(up.contains("digits 0") && up.contains("ratio 2.000 (allowed: 0.9 to 1.5)"), "{up}");
        assert_eq!(sweep(&[2.0, 1.0]).violations().len(), 1);
    }

    #[test]
    fn a_value_that_is_no_number_is_a_violation() {
        assert_eq!(sweep(&[1.0, f64::NAN, 1.0]).violations().len(), 2);
        assert_eq!(sweep(&[0.0, 0.0]).violations().len(), 1);
    }

    #[test]
    fn every_point_is_in_both_files() {
        let sweeps = [sweep(&[1.0, 1.25])];
        assert!(csv(&sweeps).ends_with("boundary,digits,1,Newton steps,1.250000e0,0.9,1.5\n"));
        assert!(markdown(&sweeps).contains("| 1 | 1.2500 | 1.250 |\n"));
    }
}
