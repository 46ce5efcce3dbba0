//! `cargo xtask bench --certified`: CPU time of certificates and of plain runs, widths of the bounds, and error bars that are certified,
//! at points of the grid of fig 3a.
//!
//! The command line with the profile `dist` is measured, into `crates/bench/results/certified.csv`, and `docs/certified-cost.svg` is drawn.
//! A test draws the figure again, and compares it and the summary in `docs/evidence/times-certified.csv` with the file.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::figure::{Axis, Caption, Panel, Panels, Series};

use crate::chart::ends;
use crate::cost::measure::once;
use crate::{measured_on, process, repository};

/// One of so many rows of a report's file of certificates is measured.
const EVERY: usize = 11;
/// Rows of the plain run, all of the same point.
const PLAIN_ROWS: usize = 100;
/// Relative error bars that are tried.
const ERROR_BARS: [f64; 10] = [1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];
/// Decades of normal stress and of velocity between neighbours of the grid.
const SPACING: f64 = 0.25;
/// Columns of a file of certificates that a file of points has too: inputs and law.
const INPUTS: usize = 8;

const FILE: &str = "certified.csv";
const FIGURE: &str = "docs/certified-cost.svg";
const SUMMARY: &str = "docs/evidence/times-certified.csv";
const HEADER: &str = "law,certificate,normal_stress_pa,loading_velocity_m_per_s,certified_cpu_s,plain_cpu_s,relative_width_of_peak,relative_width_of_period,certified_error_bars\n";
const CERTIFICATES: [&str; 2] = ["cycle", "decay"];

/// What one point costs.
#[derive(Debug, Clone, PartialEq)]
struct Cost {
    law: String,
    certificate: String,
    certified_s: f64,
    plain_s: f64,
    peak_width: f64,
    /// None for a decay.
    period_width: Option<f64>,
    /// Widest relative error bars of normal stress and of loading velocity that are certified together; 0 where none are.
    error_bars: f64,
}

impl Cost {
    fn ratio(&self) -> f64 {
        self.certified_s / self.plain_s
    }

    /// The part of a cell of the grid, in logarithms, that the certificate for these error bars covers.
    fn share(&self) -> f64 {
        let decades = libm::log10((1.0 + self.error_bars) / (1.0 - self.error_bars));
        (decades / SPACING) * (decades / SPACING)
    }
}

/// Measures every point of the sample, and writes the rows, the machine, the figure and the summary.
///
/// # Errors
/// When the build or a measured command fails, or a file cannot be read or written.
pub fn run() -> Result<(), String> {
    let place =
        GridPlace { program: process::build_dist()?, folder: repository::root().join("target/certified") };
    fs::create_dir_all(&place.folder).map_err(|error| format!("{}: {error}", place.folder.display()))?;
    let mut text = String::from(HEADER);
    for law in EvolutionLaw::ALL {
        let path =
            repository::root().join(format!("reports/im-avouac/vectors/certified-{}.csv", law.as_str()));
        let stored = fs::read_to_string(&path).map_err(|error| cannot(&path, &error))?;
        let inputs = |line: &str| line.split(',').take(INPUTS).collect::<Vec<_>>().join(",");
        let header = inputs(stored.lines().next().unwrap_or_default());
        for line in stored.lines().skip(1).step_by(EVERY) {
            text += &place.measured(&header, &inputs(line))?;
        }
    }
    let costs = read(&text).ok_or("target/certified: a row of other cells")?;
    write(&measured_on::folder().join(FILE), &text)?;
    write(&repository::root().join(FIGURE), &figure(&costs))?;
    measured_on::write(FILE, &measured_on::facts())?;
    write(&repository::root().join(SUMMARY), &summary(&costs))?;
    Ok(())
}

fn cannot(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {error}", path.display())
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| cannot(path, &error))
}

/// The program and the folder in which it runs.
struct GridPlace {
    program: PathBuf,
    folder: PathBuf,
}

impl GridPlace {
    /// The row of one point.
    fn measured(&self, header: &str, point: &str) -> Result<String, String> {
        write(&self.folder.join("one.csv"), &format!("{header}\n{point}\n"))?;
        write(
            &self.folder.join("many.csv"),
            &format!("{header}\n{}", format!("{point}\n").repeat(PLAIN_ROWS)),
        )?;
        let certified_s = self.cpu_s("simulate --certify --points one.csv -o certified.csv --threads 1")?;
        let plain_s = self.cpu_s("simulate --points many.csv -o plain.csv --threads 1 --tolerance 1e-8")?;
        let found = WrittenRow::read(&self.folder.join("certified.csv"))?;
        let cell = |name: &str| found.cell(name);
        let width = |low: &str, high: &str| {
            let [low, high] = [cell(low)?, cell(high)?].map(str::parse::<f64>);
            let width = low.ok().zip(high.ok()).map(|(low, high)| format!("{:.3e}", high / low - 1.0));
            Ok::<_, String>(width.unwrap_or_default())
        };
        Ok(format!(
            "{},{},{},{},{certified_s:.3e},{:.3e},{},{},{:e}\n",
            cell("law")?,
            cell("certificate")?,
            cell("normal_stress_pa")?,
            cell("loading_velocity_m_per_s")?,
            plain_s / PLAIN_ROWS as f64,
            width("peak_velocity_low_m_per_s", "peak_velocity_high_m_per_s")?,
            width("period_low_s", "period_high_s")?,
            self.error_bars(header, point, cell("certificate")?)?
        ))
    }

    /// The widest relative error bars of those tried for which this and all narrower ones have the point's own certificate.
    fn error_bars(&self, header: &str, point: &str, certificate: &str) -> Result<f64, String> {
        let mut widest = 0.0;
        for half_width in ERROR_BARS {
            let with_bars = |(name, value): (&str, &str)| match name {
                "normal_stress_pa" | "loading_velocity_m_per_s" => {
                    format!("{value}±{:e}", half_width * value.parse::<f64>().unwrap_or(f64::NAN))
                }
                _ => value.to_string(),
            };
            let cells: Vec<String> = header.split(',').zip(point.split(',')).map(with_bars).collect();
            write(&self.folder.join("bars.csv"), &format!("{header}\n{}\n", cells.join(",")))?;
            self.run("simulate --certify --points bars.csv -o over-bars.csv --threads 1")?;
            if WrittenRow::read(&self.folder.join("over-bars.csv"))?.cell("certificate")? != certificate {
                break;
            }
            widest = half_width;
        }
        Ok(widest)
    }

    /// The smaller CPU time of two runs of a command.
    fn cpu_s(&self, command: &str) -> Result<f64, String> {
        Ok(self.run(command)?.min(self.run(command)?))
    }

    /// The CPU time of one run.
    fn run(&self, command: &str) -> Result<f64, String> {
        let arguments: Vec<String> = command.split_whitespace().map(String::from).collect();
        once(&self.program, &arguments, &self.folder).map(|measured| measured.cpu_s)
    }
}

/// The table of one row that the program has written.
struct WrittenRow {
    path: PathBuf,
    text: String,
}

impl WrittenRow {
    fn read(path: &Path) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|error| cannot(path, &error))?;
        Ok(Self { path: path.to_path_buf(), text })
    }

    fn cell(&self, name: &str) -> Result<&str, String> {
        let (names, cells) = self.text.split_once('\n').unwrap_or_default();
        let of_name = names.split(',').zip(cells.trim_end().split(',')).find(|(known, _)| *known == name);
        of_name.map(|(_, cell)| cell).ok_or(format!("{}: no column {name}", self.path.display()))
    }
}

/// The rows of the file; none when one has other cells.
fn read(text: &str) -> Option<Vec<Cost>> {
    let row = |line: &str| {
        let [law, certificate, _, _, certified_s, plain_s, peak, period, error_bars] =
            line.split(',').collect::<Vec<_>>()[..]
        else {
            return None;
        };
        Some(Cost {
            law: law.into(),
            certificate: certificate.into(),
            certified_s: certified_s.parse().ok()?,
            plain_s: plain_s.parse().ok()?,
            peak_width: peak.parse().ok()?,
            period_width: period.parse().ok(),
            error_bars: error_bars.parse().ok()?,
        })
    };
    text.strip_prefix(HEADER)?.lines().map(row).collect()
}

/// The costs of each law and certificate, with its name.
fn groups(costs: &[Cost]) -> impl Iterator<Item = (String, Vec<&Cost>)> {
    let kinds = CERTIFICATES
        .into_iter()
        .flat_map(|certificate| EvolutionLaw::ALL.map(|law| (law.as_str(), certificate)));
    kinds.map(move |(law, certificate)| {
        let of = |cost: &&Cost| cost.law == law && cost.certificate == certificate;
        (format!("{certificate}, {law} law"), costs.iter().filter(of).collect())
    })
}

fn figure(costs: &[Cost]) -> String {
    let panel =
        |heading: &str, width: fn(&Cost) -> Option<f64>, time: (&str, &str, fn(&Cost) -> f64), what: &str| {
            let (title, unit, time) = time;
            let point = |cost: &Cost| Some((width(cost)?, time(cost)));
            let axis = |title: &str, unit: &str, values: Vec<f64>| {
                let [from, to] = ends(values.into_iter()).unwrap_or([1.0, 10.0]);
                // Marks at an end are drawn whole.
                Axis::log10(title, unit, from / 1.5, 1.5 * to)
            };
            let series = groups(costs)
                .map(|(name, costs)| Series::points(name, costs.into_iter().filter_map(point).collect()));
            Panel {
                heading: vec![heading.into()],
                x: axis(what, "", costs.iter().filter_map(width).collect()),
                y: axis(title, unit, costs.iter().map(time).collect()),
                series: series.collect(),
                references: Vec::new(),
            }
        };
    let peak: fn(&Cost) -> Option<f64> = |cost| Some(cost.peak_width);
    let period: fn(&Cost) -> Option<f64> = |cost| cost.period_width;
    let seconds: (&str, &str, fn(&Cost) -> f64) = ("CPU time", "s", |cost| cost.certified_s);
    let ratio: (&str, &str, fn(&Cost) -> f64) = ("CPU time, plain runs", "", Cost::ratio);
    let widths = ["Relative width, peak", "Relative width, period"];
    Panels {
        caption: Caption::new(
            "certified-cost",
            "CPU time of certificates against the relative width of their bounds",
            "Four charts with logarithmic axes: the CPU time of a certificate in seconds and in plain runs, against the relative width of the bounds of the peak velocity and of the period. Bounds of cycles that take more time are not narrower. Of the decays whose bounds are wider than 1e-11, those that take more time have narrower bounds.",
        ),
        columns: 2,
        height: 220.0,
        panels: vec![
            panel("**a** seconds and peak velocity", peak, seconds, widths[0]),
            panel("**b** seconds and period", period, seconds, widths[1]),
            panel("**c** plain runs and peak velocity", peak, ratio, widths[0]),
            panel("**d** plain runs and period", period, ratio, widths[1]),
        ],
    }
    .svg()
}

/// A name, and the value of a point that has one.
type Quantity = (&'static str, fn(&Cost) -> Option<f64>);

/// Least, lower quartile, median, upper quartile and largest value of each law and certificate, as a table.
fn summary(costs: &[Cost]) -> String {
    let mut text =
        String::from("certificate,points,what,least,lower quartile,median,upper quartile,largest\n");
    let quantities: [Quantity; 6] = [
        ("CPU time, s", |cost| Some(cost.certified_s)),
        ("CPU time, plain runs", |cost| Some(cost.ratio())),
        ("relative width of the peak", |cost| Some(cost.peak_width)),
        ("relative width of the period", |cost| cost.period_width),
        ("relative error bars that are certified", |cost| Some(cost.error_bars)),
        ("part of the grid's cell that they cover", |cost| Some(cost.share())),
    ];
    for (name, costs) in groups(costs) {
        for (what, of) in quantities {
            let mut values: Vec<f64> = costs.iter().filter_map(|cost| of(cost)).collect();
            values.sort_by(f64::total_cmp);
            if let Some(last) = values.len().checked_sub(1) {
                let quarters =
                    [0, 1, 2, 3, 4].map(|quarter| format!("{:.1e}", values[(last * quarter + 2) / 4]));
                // Writing to a string cannot fail.
                let _ = writeln!(text, "\"{name}\",{},\"{what}\",{}", values.len(), quarters.join(","));
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figure_and_summary_follow_from_the_measured_rows() {
        let costs = read(include_str!("../results/certified.csv")).unwrap();
        assert_eq!(costs.len(), 2 * 441_usize.div_ceil(EVERY));
        assert!(
            figure(&costs) == include_str!("../../../docs/certified-cost.svg"),
            "draw docs/certified-cost.svg again"
        );
        assert_eq!(summary(&costs), include_str!("../../../docs/evidence/times-certified.csv"));
    }

    #[test]
    fn a_row_of_other_cells_is_refused_and_a_decay_has_no_period() {
        let row = "slip,decay,1e3,1e-3,0.5,0.25,4e-13,,1e-1\n";
        let costs = read(&format!("{HEADER}{row}")).unwrap();
        assert_eq!((costs[0].ratio(), costs[0].period_width), (2.0, None));
        // Error bars from 10^-0.125 to 10^0.125 of the value would cover the whole cell; these reach 0.087 decades in both directions.
        assert!((costs[0].share().sqrt() - 0.087_150_175_7 / 0.25).abs() < 1e-9);
        assert_eq!(read(&format!("{HEADER}{row}slip,decay\n")), None);
        assert_eq!(read(row), None);
        assert!(
            summary(&costs)
                .contains("\"decay, slip law\",1,\"CPU time, s\",5.0e-1,5.0e-1,5.0e-1,5.0e-1,5.0e-1\n")
        );
    }
}
