//! `classify` as functions for a program: a point, and a grid with its picture, without a command line and without files.
//!
//! They read the same texts by the same routines as the command, so that faults and warnings have the same words.

use crate::cli::classify::grid::GridOptions;
use crate::cli::classify::grid_files::GridPicture;
use crate::cli::classify::view::ClassifiedPoint;
use crate::cli::options::{Arguments, SliderOptions, ThresholdOption};
use crate::cli::{Captured, captured};

/// Classifies the point of these values, in the order of the options, as `classify` does.
///
/// ```
/// use slipmode::cli::capture_point;
///
/// let values = ["0.004", "0.006", "10um", "1e7", "1000", "1MPa", "10um/s"];
/// let (point, messages) = capture_point(values, None);
/// assert_eq!(point.unwrap().slip_mode(), "stick-slip");
/// assert_eq!(messages.exit_code, 0);
/// ```
pub fn capture_point(
    values: [&str; 7],
    inertial_threshold: Option<&str>,
) -> (Option<ClassifiedPoint>, Captured) {
    captured(false, || {
        let mut arguments = Arguments::default();
        let threshold = ThresholdOption::of(inertial_threshold).threshold(&mut arguments);
        let parameters = SliderOptions::of(values).parameters(&mut arguments);
        let (parameters, threshold) = arguments.finish(parameters.zip(threshold))?;
        Ok(ClassifiedPoint::new(parameters, &threshold))
    })
}

/// Draws a grid of loading velocities and normal stresses, each `FROM:TO:N`, as `classify --svg` does.
pub fn capture_grid(
    slider: [&str; 5],
    [loading_velocity, normal_stress]: [&str; 2],
    inertial_threshold: Option<&str>,
) -> (Option<GridPicture>, Captured) {
    captured(false, || {
        let mut arguments = Arguments::default();
        let threshold = ThresholdOption::of(inertial_threshold).threshold(&mut arguments);
        let grid = GridOptions::drawn(loading_velocity, normal_stress);
        let request = grid.read(&SliderOptions::of(slider), None, false, &mut arguments);
        let (request, threshold) = arguments.finish(request.zip(threshold))?;
        Ok(request.picture(&threshold))
    })
}
