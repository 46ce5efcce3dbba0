//! `slipmode classify`: one point for people or programs, every row of a CSV file, or the counts of a grid.

pub mod box_view;
pub mod call;
mod derived;
mod grid;
pub mod grid_files;
pub mod ranges;
pub mod rows;
mod sample;
pub mod view;

use std::path::PathBuf;

use clap::Args;

use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, SliderOptions, ThresholdOption};
use crate::cli::points::{self, RowsOptions};
use crate::cli::progress::Progress;
use grid::GridOptions;
use rows::ClassifyRows;
use sample::SampleOptions;
use view::ClassifiedPoint;

/// Options of `classify`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: SliderOptions,
    #[command(flatten)]
    threshold: ThresholdOption,
    #[command(flatten)]
    grid: GridOptions,
    /// One JSON object instead of text
    ///
    /// A value with an error bar is 0.009±0.001, 0.009+-0.001, 0.009(1), 0.009±5% or [0.008, 0.010]. Then the object has the slip
    /// modes that are possible, each with an exact point within the error bars.
    #[arg(long, conflicts_with = "points")]
    json: bool,
    /// Classify every row of a CSV file; `-` reads standard input
    ///
    /// The header names the seven inputs with their SI units (direct_effect, evolution_effect, critical_slip_distance_m,
    /// stiffness_pa_per_m, mass_per_area_kg_per_m2, normal_stress_pa, loading_velocity_m_per_s), or by symbol (a, b, d_c, k, m,
    /// sigma, v0) or in another unit (d_c_um, normal_stress_mpa), in any order. Columns of errors have a word for it in their names
    /// (d_c_error_um, sigma_std_mpa); a cell may have an error bar or a unit of its own. Other columns are kept. Text that a spreadsheet
    /// would run as a formula gets a `'` in front. Limits: 1 000 columns, 64 KiB per cell, 1 MiB per row, any number of rows. Without --keep-going, nothing is written unless every row is valid.
    #[arg(long, value_name = "FILE.csv")]
    points: Option<PathBuf>,
    #[command(flatten)]
    rows: RowsOptions,
    #[command(flatten)]
    sample: SampleOptions,
}

impl Options {
    /// Whether neither rows nor a grid are classified.
    pub fn is_of_one_point(&self) -> bool {
        self.points.is_none() && !self.grid.is_given()
    }
}

/// Runs the command.
///
/// # Errors
/// When the arguments or the rows are at fault, or the output cannot be written.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let is_box = options.is_of_one_point() && options.slider.is_uncertain();
    let threshold = if is_box {
        options.threshold.threshold_over_box(&mut arguments)
    } else {
        options.threshold.threshold(&mut arguments)
    };
    if options.points.is_none() {
        options.rows.refuse_without_points(options.grid.is_given(), &mut arguments);
    }
    if !options.grid.is_given() {
        options.grid.refuse_without_grid(&mut arguments);
    }
    if !is_box {
        options.sample.refuse(&mut arguments);
    }
    if is_box {
        let region = options.slider.region(None, &mut arguments);
        let sample = options.sample.read(&mut arguments);
        let answer = threshold
            .zip(region)
            .and_then(|(threshold, region)| box_view::answer(&region, &threshold, sample.as_ref()));
        return arguments.finish(answer)?.print(options.json);
    }
    if options.grid.is_given() {
        let rows = options.rows.output.as_deref();
        let request = options.grid.read(&options.slider, rows, options.json, &mut arguments);
        let (request, threshold) = arguments.finish(request.zip(threshold))?;
        return request.run(&threshold, options.json, *progress);
    }
    let Some(points) = &options.points else {
        let parameters = options.slider.parameters(&mut arguments);
        let (parameters, threshold) = arguments.finish(parameters.zip(threshold))?;
        return ClassifiedPoint::new(parameters, &threshold).answer().print(options.json);
    };
    options.slider.refuse_beside_points(&mut arguments);
    let threshold = arguments.finish(threshold)?;
    points::run(points, &options.rows, ClassifyRows::<true> { threshold }, *progress)
}
