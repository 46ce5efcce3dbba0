//! `fit --peaks`: its options, its answer and its rows.

use clap::Args;
use serde_json::json;
use slipmode::csv::PeakTable;
use slipmode::experiments::fit::estimate_words;
use slipmode::fitting::{CaseFit, EFFECT_RATIOS, PeakComparison, PeakFit, PeakFits, PeakGiven, hidden_part};
use slipmode::scene::{AllowedRange, Problem, Quantity, Uncertain, all_of, parse_value};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Rational, nearest_f64};

use super::Request;
use super::view::estimated;
use crate::cli::answer::{Answer, csv_of_numbers};
use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, option_of};

/// Options of `fit --peaks`.
#[derive(Debug, Args)]
pub struct PeakOptions {
    /// The file is a table of peak velocities of stick-slip, which give (b - a) sigma/sqrt(K M) = 2 V_18 without a velocity step
    ///
    /// Columns: loading_velocity_m_per_s; peak_velocity_m_per_s, the mean over some cycles; optionally the standard error of this mean
    /// (peak_velocity_error_m_per_s, or in % of it) and normal_stress_pa. Limits: 5 to 500 rows, load velocities over a factor of 3 or
    /// more and below a tenth of V_18.
    #[arg(
        long = "peaks",
        conflicts_with_all = ["drift", "loading_velocity_m_per_s", "into"]
    )]
    pub is_table: bool,
    /// b/a or its range, such as [1.5, 2], 1.2 to 5 [default: all of this range]
    #[arg(long, value_name = "B/A", requires = "is_table", allow_hyphen_values = true)]
    effect_ratio: Option<String>,
    /// D_c or its range: the height of the peaks then counts, not only their fall; with K and M
    #[arg(
        short = 'd',
        long,
        value_name = "D",
        requires = "is_table",
        requires = "stiffness_pa_per_m",
        requires = "mass_per_area_kg_per_m2",
        allow_hyphen_values = true
    )]
    critical_slip_distance_m: Option<String>,
    /// The -3 dB frequency of the velocity record: the peaks may be higher by what a low-pass of first order takes; with K and M
    #[arg(
        long,
        value_name = "F",
        requires = "is_table",
        requires = "stiffness_pa_per_m",
        requires = "mass_per_area_kg_per_m2",
        allow_hyphen_values = true
    )]
    bandwidth_hz: Option<String>,
}

/// What is known besides the table.
pub struct Known {
    /// For the fit; whether the peaks have errors is known with the table.
    pub given: PeakGiven,
    /// K and M in SI.
    machine: Option<[f64; 2]>,
    slip_distance_m: Option<[f64; 2]>,
    bandwidth_hz: Option<f64>,
}

impl PeakOptions {
    /// Reads the options.
    ///
    /// # Errors
    /// All that are at fault.
    pub fn read(&self, request: &Request) -> Result<Known, Failure> {
        let mut arguments = Arguments::default();
        let known = [request.given.stiffness_pa_per_m, request.given.mass_per_area_kg_per_m2];
        let machine = all_of(known);
        arguments.refuse("--peaks", machine.is_none() && known != [None; 2], "both of -k and -m, or neither");
        let has_stress = request.normal_stress_pa.is_some();
        arguments.refuse("--normal-stress-pa", machine.is_none() && has_stress, "-k and -m: they give b - a");
        let ends = |ends: Uncertain| [ends.lower, ends.upper].map(|end| nearest_f64(&end));
        let mut range =
            |option: &str, text: &Option<String>, read: &dyn Fn(&str) -> Result<Rational, Problem>| {
                arguments.number(option, text.as_ref()?, |text| Uncertain::parse(text, read)).map(ends)
            };
        let ratio =
            range("--effect-ratio", &self.effect_ratio, &|text| AllowedRange::EFFECT_RATIO.parse(text));
        let distance = Quantity::CriticalSlipDistance;
        let slip_distance_m =
            range(&option_of(distance), &self.critical_slip_distance_m, &|text| parse_value(distance, text));
        let bandwidth =
            self.bandwidth_hz.as_deref().and_then(|text| arguments.measured("--bandwidth-hz", text, "Hz"));
        let bandwidth_hz = bandwidth.as_ref().map(nearest_f64);
        let rate = machine.map(|[stiffness, mass]| (stiffness / mass).sqrt());
        let slower = |(rate, hertz): (f64, f64)| hidden_part(std::f64::consts::TAU * hertz / rate);
        let given = PeakGiven {
            laws: request.laws.clone(),
            effect_ratio: ratio.unwrap_or(EFFECT_RATIOS),
            slip_velocity_m_per_s: slip_distance_m.zip(rate).map(|(ends, rate)| ends.map(|end| end * rate)),
            hidden: rate.zip(bandwidth_hz).map_or(0.0, slower),
            has_errors: false,
        };
        arguments.finish(Some(Known { given, machine, slip_distance_m, bandwidth_hz }))
    }
}

/// States (b − a)σ/√(KM) with its interval and the parts of its error.
pub fn answer(table: &PeakTable, fits: &PeakFits, known: &Known) -> Answer {
    let [stiffness, mass] = known.machine.map_or([None; 2], |machine| machine.map(Some));
    let inputs = json!({
        "effect_ratio": known.given.effect_ratio,
        "normal_stress_pa": table.normal_stress_pa,
        "stiffness_pa_per_m": stiffness,
        "mass_per_area_kg_per_m2": mass,
        "critical_slip_distance_m": known.slip_distance_m,
        "bandwidth_hz": known.bandwidth_hz,
        "peak_velocity_errors": table.has_errors,
    });
    let best = &fits.laws[0];
    let impedance = known.machine.map(|[stiffness, mass]| (stiffness * mass).sqrt());
    let effects = impedance.zip(table.normal_stress_pa).map(|(impedance, stress)| impedance / stress);
    let of_best = |names, size: Option<f64>| {
        size.map_or_else(Answer::default, |size| scaled(names, best, fits.ends, size))
    };
    let scatter = match table.has_errors {
        true => format!("{} times their errors", round_digits(best.scatter, 2)),
        false => format!("{} %", round_digits(100.0 * best.scatter, 2)),
    };
    let mut answer = Answer::to(inputs)
        .item("law", "evolution law", best.law.as_str())
        .and(of_best(["twice_v18_m_per_s", "(b - a) sigma/sqrt(K M)", "m/s"], Some(1.0)))
        .and(of_best(["effect_difference_stress_pa", "(b - a) sigma", "Pa"], impedance))
        .and(of_best(["effect_difference", "b - a", ""], effects))
        .and(error_parts(fits, known))
        .list("laws", fits.laws.iter().map(of_law))
        .named("scatter of the peaks", &scatter)
        .item("rows", "rows", table.rows.len() as u64);
    if let Some(found) = &fits.comparison {
        let part = Answer::default()
            .with("other_law", fits.laws[1].law.as_str())
            .with("distance", found.distance)
            .with("quantile", found.quantile)
            .with("tells_apart", found.tells_apart());
        answer = answer.part("law_comparison", part).text(&format!("{}\n", comparison_words(fits, found)));
    }
    let remarks = remarks(table, fits, known);
    let lines: String = remarks.iter().map(|remark| format!("{remark}\n")).collect();
    answer.with("remarks", remarks).text(&lines)
}

fn scaled(names: [&str; 3], fit: &PeakFit, ends: [Option<f64>; 2], size: f64) -> Answer {
    let estimate = [fit.central.scale_m_per_s, fit.central.standard_error].map(|value| value * size);
    estimated(names, estimate, ends.map(|end| end.map(|end| end * size)))
}

/// The fit of one law: its value at the middle b/a, and its interval over b/a, the model and the bandwidth.
fn of_law(fit: &PeakFit) -> Answer {
    let name = format!("with the {} law", fit.law.as_str());
    scaled(["twice_v18_m_per_s", &name, "m/s"], fit, fit.ends, 1.0)
        .with("law", fit.law.as_str())
        .with("from_noise_m_per_s", fit.central.ends)
        .with("stiffness_over_quasi_static", fit.central.softness)
        .with("residual_standard_deviation", fit.scatter)
}

/// What each unknown alone makes of the value.
fn error_parts(fits: &PeakFits, known: &Known) -> Answer {
    let best = &fits.laws[0];
    let scales = || fits.laws.iter().map(|fit| fit.central.scale_m_per_s);
    let over_laws = [scales().fold(f64::INFINITY, f64::min), scales().fold(0.0, f64::max)];
    let CaseFit { scale_m_per_s, standard_error, ends: from_noise, .. } = best.central;
    let seen = [scale_m_per_s, scale_m_per_s / (1.0 - known.given.hidden)];
    let parts = [
        ("noise", "error from noise", from_noise),
        ("law", "error from the law", over_laws.map(Some)),
        ("effect_ratio", "error from b/a", best.over_effect_ratio.map(Some)),
        ("model", "error of the peak law", best.over_loss.map(Some)),
        ("bandwidth", "error from the bandwidth", seen.map(Some)),
    ];
    let part = |part: Answer, (key, name, ends): (&str, &str, [Option<f64>; 2])| {
        let [_, range] = estimate_words(scale_m_per_s, standard_error, ends, "m/s");
        part.with(key, ends).named(name, &format!("{range} m/s"))
    };
    Answer::default().part("error_parts_m_per_s", parts.into_iter().fold(Answer::default(), part))
}

fn comparison_words(fits: &PeakFits, found: &PeakComparison) -> String {
    let [better, other] = [0, 1].map(|place| fits.laws[place].law.as_str());
    let [distance, quantile] = [found.distance, found.quantile].map(|number| round_digits(number, 3));
    match found.tells_apart() {
        true => format!(
            "The table tells the laws apart: the peaks are {distance} standard errors nearer to the {better} law than to the {other} law, more than {quantile}."
        ),
        false => format!(
            "The table does not tell the laws apart: the peaks are {distance} standard errors nearer to the {better} law than to the {other} law, less than {quantile}. The interval is over both laws."
        ),
    }
}

/// Scatter beyond the errors is reported where chance rarely makes it.
const RARE: f64 = 2.58;

fn remarks(table: &PeakTable, fits: &PeakFits, known: &Known) -> Vec<String> {
    let best = &fits.laws[0];
    let degrees = table.rows.len() as f64 - 2.0;
    let mut sentences = Vec::new();
    if known.given.effect_ratio == EFFECT_RATIOS {
        let [low, high] = EFFECT_RATIOS;
        sentences.push(format!("b/a is taken from {low} to {high}: --effect-ratio narrows the interval."));
    }
    if table.has_errors && best.scatter * best.scatter > 1.0 + RARE * (2.0 / degrees).sqrt() {
        sentences.push(format!(
            "The peaks scatter {} times as much as their errors: the intervals are that much wider.",
            round_digits(best.scatter, 2)
        ));
    }
    if fits.ends[0].is_none() {
        sentences.push("The table sets no bound of (b - a) sigma/sqrt(K M) from below: measure over more load velocities, or give K, M and D_c.".into());
    }
    for law in &fits.without_fit {
        sentences.push(format!(
            "The {} law requires K/K_c,qs above 0.1, where the method does not hold: the interval is that of the {} law alone.",
            law.as_str(),
            best.law.as_str()
        ));
    }
    if known.given.hidden > 0.0 {
        sentences.push(format!(
            "The bandwidth permits peaks that are higher by {} %.",
            round_digits(100.0 * known.given.hidden / (1.0 - known.given.hidden), 2)
        ));
    }
    sentences
}

/// The table with the peaks by the better law, as CSV.
pub fn rows(table: &PeakTable, fits: &PeakFits) -> String {
    let names =
        "loading_velocity_m_per_s,peak_velocity_m_per_s,fitted_peak_velocity_m_per_s,residual_m_per_s";
    let rows = table.rows.iter().zip(&fits.laws[0].peaks_m_per_s).map(|(row, fitted)| {
        let (load, peak) = (row.load_m_per_s, row.peak_m_per_s);
        [load, peak, *fitted, peak - fitted]
    });
    csv_of_numbers(names, rows)
}
