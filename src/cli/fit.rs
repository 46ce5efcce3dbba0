//! `slipmode fit`: a, b, D_c and more from a record of velocity steps, with intervals, and a report on what follows.

mod laboratory;
mod peaks;
mod view;

use std::path::PathBuf;

use clap::Args;
use slipmode::csv::{read_peak_table, read_step_record};
use slipmode::experiments::fit::{fit_picture, peak_picture};
use slipmode::fitting::{FitGiven, Fits, StepRecord, fit_peaks};
use slipmode::scene::{CsvProblem, Quantity, of_word, unit_of};
use slipmode_core::friction::{EvolutionLaw, OperatingPoint};
use slipmode_core::number::format::shortest;
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};

use crate::cli::dialect::DialectOptions;
use crate::cli::failure::Failure;
use crate::cli::input::{fault_of, open_csv};
use crate::cli::options::{Arguments, option_of};
use crate::cli::output::Output;
use crate::cli::points::print_unread;
use crate::cli::progress::Progress;

/// Options of `fit`.
#[derive(Debug, Args)]
pub struct Options {
    /// The record, one sample per row, or with --peaks a table; `-` reads standard input
    ///
    /// Columns: time_s; load_point_displacement_m or load_point_velocity_m_per_s; shear_stress_pa or friction; optionally
    /// normal_stress_pa. Another unit may stand behind a name, as in load_point_displacement_um. A velocity or a normal stress holds
    /// until the next row; a displacement is linear between rows. The record begins with steady sliding and has one or more steps of
    /// velocity. Limits: 20 to 200 000 rows.
    #[arg(value_name = "RECORD.csv")]
    record: PathBuf,
    /// The evolution law: `slip` (eq 3), `aging` (eq 2), or `both`, which reports the one that fits better
    #[arg(long, value_name = "LAW", default_value = "both", allow_hyphen_values = true)]
    law: String,
    /// σ, for a record without the column normal_stress_pa
    #[arg(short = 's', long, value_name = "S", allow_hyphen_values = true)]
    normal_stress_pa: Option<String>,
    /// K, shear stress per slip [default: fitted]
    #[arg(short = 'k', long, value_name = "K", allow_hyphen_values = true)]
    stiffness_pa_per_m: Option<String>,
    /// M, moving mass per area of contact [default: no inertia]
    #[arg(short = 'm', long, value_name = "M", allow_hyphen_values = true)]
    mass_per_area_kg_per_m2: Option<String>,
    /// Also fit a change of the friction in proportion to the displacement of the load point
    #[arg(long)]
    drift: bool,
    /// V0 at which slip modes are stated, where M is given [default: the velocity before the first step]
    #[arg(
        short = 'v',
        long,
        value_name = "V",
        requires = "mass_per_area_kg_per_m2",
        allow_hyphen_values = true
    )]
    loading_velocity_m_per_s: Option<String>,
    /// Also write the folder of a report on the fitted slider, as `new` does: its name is the report's, and it must not exist
    #[arg(long, value_name = "DIR", requires = "mass_per_area_kg_per_m2")]
    into: Option<PathBuf>,
    #[command(flatten)]
    peaks: peaks::PeakOptions,
    #[command(flatten)]
    dialect: DialectOptions,
    /// One JSON object instead of text
    #[arg(long)]
    json: bool,
    /// Also write the record or the table as CSV with the fitted values and the residuals; `-` is standard output, instead of text
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<PathBuf>,
    /// Also draw the record or the peaks, the fit and the residuals
    #[arg(long, value_name = "OUT.svg")]
    svg: Option<PathBuf>,
}

/// The words of `--law`.
const LAWS: [&str; 3] = ["slip", "aging", BOTH];
const BOTH: &str = "both";

/// What was requested, valid.
struct Request {
    laws: Vec<EvolutionLaw>,
    given: FitGiven,
    normal_stress_pa: Option<f64>,
    loading_velocity_m_per_s: Option<f64>,
}

/// Runs the command.
///
/// # Errors
/// When the arguments or the record are at fault, nothing fits the record, or an output cannot be written.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let request = options.read()?;
    let known = options.peaks.is_table.then(|| options.peaks.read(&request)).transpose()?;
    let [csv, svg] = Output::create_both([options.output.as_deref(), options.svg.as_deref()])?;
    let rows = open_csv(&options.record, options.dialect.dialect())?;
    let no_fit =
        |failure: String| Failure::Input(vec![fault_of(&options.record, CsvProblem::Record(failure).into())]);
    if let Some(mut known) = known {
        let table = read_peak_table(rows, request.normal_stress_pa)?;
        print_unread(table.unread.iter().map(String::as_str));
        known.given.has_errors = table.has_errors;
        let fits = progress.spinner("fitting", || fit_peaks(&table.rows, &known.given));
        let fits = fits.map_err(|failure| no_fit(failure.to_string()))?;
        let answer = peaks::answer(&table, &fits, &known);
        csv.map_or(Ok(()), |output| output.finish(peaks::rows(&table, &fits)))?;
        svg.map_or(Ok(()), |output| output.finish(peak_picture(&table.rows, &fits)))?;
        return answer.print_beside(options.json, options.output.as_deref());
    }
    let (record, unread) = read_step_record(rows, request.normal_stress_pa)?;
    print_unread(unread.iter().map(String::as_str));
    let fits = progress.spinner("fitting", || Fits::of(&record, &request.laws, &request.given));
    let fits = fits.map_err(|failure| no_fit(failure.to_string()))?;
    let point = request.point(&record);
    let answer = view::answer(&record, &fits, &point);
    if let Some(place) = &options.into {
        laboratory::write(place, &record, &fits, &request.laws, &point, *progress)?;
    }
    csv.map_or(Ok(()), |output| output.finish(view::rows(&record, &fits.best)))?;
    svg.map_or(Ok(()), |output| output.finish(fit_picture(&record, &fits)))?;
    answer.print_beside(options.json, options.output.as_deref())
}

impl Options {
    fn read(&self) -> Result<Request, Failure> {
        let mut arguments = Arguments::default();
        let word = arguments.number("--law", &self.law, |text| of_word(text, &LAWS, |word| word));
        let is_meant = |law: &EvolutionLaw| word == Some(BOTH) || word == Some(law.as_str());
        let laws: Vec<EvolutionLaw> =
            [EvolutionLaw::Slip, EvolutionLaw::Aging].into_iter().filter(is_meant).collect();
        let mut number = |text: &Option<String>, quantity: Quantity| {
            let value = arguments.measured(&option_of(quantity), text.as_ref()?, unit_of(quantity));
            value.as_ref().map(nearest_f64)
        };
        let normal_stress_pa = number(&self.normal_stress_pa, Quantity::NormalStress);
        let stiffness_pa_per_m = number(&self.stiffness_pa_per_m, Quantity::Stiffness);
        let mass_per_area_kg_per_m2 = number(&self.mass_per_area_kg_per_m2, Quantity::MassPerArea);
        let loading_velocity_m_per_s = number(&self.loading_velocity_m_per_s, Quantity::LoadingVelocity);
        arguments.refuse_stream("--output", self.output.as_deref().filter(|_| self.json), "the object");
        arguments.refuse_stream("--svg", self.svg.as_deref(), "something else");
        let request = laws.first().copied().map(|law| Request {
            given: FitGiven { law, stiffness_pa_per_m, mass_per_area_kg_per_m2, has_drift: self.drift },
            laws,
            normal_stress_pa,
            loading_velocity_m_per_s,
        });
        arguments.finish(request)
    }
}

impl Request {
    /// σ at the start of the record, and the requested V0 or the velocity before the first step.
    fn point(&self, record: &StepRecord) -> OperatingPoint<Rational> {
        let velocity = self.loading_velocity_m_per_s.unwrap_or_else(|| record.reference_velocity_m_per_s());
        let [normal_stress_pa, loading_velocity_m_per_s] = [record.normal_stress_pa, velocity]
            .map(|value| parse_decimal(&shortest(value)).unwrap_or_default());
        OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }
    }
}
