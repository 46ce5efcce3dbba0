//! The points of a grid as rows, and its slip modes as a picture.

use std::io::Write;

use slipmode::csv::RowWork;
use slipmode::experiments::boundary::END_ERROR;
use slipmode::experiments::pictures::mode_picture;
use slipmode::experiments::shared::Grid;
use slipmode::parallel;
use slipmode::scene::{LogAxis, LogCoordinates};
use slipmode_core::friction::Slider;
use slipmode_core::number::format::shortest;
use slipmode_core::number::{Dd, Rational};
use slipmode_core::stability::batch::{GridCell, GridKernel, SignPair};
use slipmode_core::stability::boundary::BoundaryCurve;
use slipmode_core::stability::{Classification, InertialThreshold, SlipMode, classify, classify_quickly};

use crate::cli::classify::grid::GridRequest;
use crate::cli::classify::rows::{Classified, ClassifyRows, RowFound};
use crate::cli::failure::Failure;
use crate::cli::output::Output;

/// Points on each arc of the drawn boundary, and their digits.
const BOUNDARY_POINTS: usize = 200;
const BOUNDARY_DIGITS: u32 = 17;
/// Points of a row that are classified together.
const POINTS_TOGETHER: u32 = 4096;

/// The coordinates of a grid, and the picture of its slip modes.
#[derive(Debug)]
pub struct GridPicture {
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: Vec<f64>,
    /// Normal stresses, Pa.
    pub normal_stress_pa: Vec<f64>,
    /// The picture as SVG.
    pub svg: String,
}

impl GridRequest {
    /// Writes a row for every point: its coordinates, and the columns of `classify --points`. Memory does not grow with the grid.
    pub fn write_rows(
        &self,
        threshold: &InertialThreshold,
        mut output: Output,
        done: impl Fn(u64),
    ) -> Result<(), Failure> {
        let work = ClassifyRows::<false> { threshold: threshold.clone() };
        let rounded = self.slider.map(Dd::from_rational);
        let names = ClassifyRows::<false>::APPENDED.join(",");
        let head = format!("loading_velocity_m_per_s,normal_stress_pa,{names}\n");
        output.write_all(head.as_bytes())?;
        let [velocities, stresses] =
            [&self.loading_velocities, &self.normal_stresses].map(LogCoordinates::of);
        let columns = self.loading_velocities.points;
        for row in 0..self.normal_stresses.points {
            let stress = stresses.at(row);
            let part = |&first: &u32| {
                let mut text = Vec::new();
                for column in first..columns.min(first.saturating_add(POINTS_TOGETHER)) {
                    let velocity = velocities.at(column);
                    text.extend_from_slice(format!("{},{}", shortest(velocity), shortest(stress)).as_bytes());
                    let found = RowFound::Point(self.classified(&rounded, threshold, [velocity, stress]));
                    work.append(&Classified { found, derived: None, warnings: Vec::new() }, &mut text);
                    text.push(b'\n');
                }
                text
            };
            let firsts: Vec<u32> = (0..columns).step_by(POINTS_TOGETHER as usize).collect();
            for text in parallel::map(&firsts, part) {
                output.write_all(&text)?;
            }
            done(u64::from(columns));
        }
        output.commit()
    }

    /// Draws the slip modes.
    pub fn picture(&self, threshold: &InertialThreshold) -> GridPicture {
        let [velocities, stresses] =
            [&self.loading_velocities, &self.normal_stresses].map(LogAxis::coordinates);
        let values = self.modes(threshold, &velocities, &stresses);
        let modes = Grid { loading_velocity_m_per_s: velocities, normal_stress_pa: stresses, values };
        let points = BoundaryCurve::new(&self.slider, BOUNDARY_DIGITS).sample(BOUNDARY_POINTS, END_ERROR);
        let svg = mode_picture(&self.slider, &modes, &points, threshold).unwrap_or_default();
        let Grid { loading_velocity_m_per_s, normal_stress_pa, .. } = modes;
        GridPicture { loading_velocity_m_per_s, normal_stress_pa, svg }
    }

    /// The slip modes, row by row of constant normal stress.
    fn modes(&self, threshold: &InertialThreshold, velocities: &[f64], stresses: &[f64]) -> Vec<SlipMode> {
        let undecided = GridCell::new(SignPair::new(0, 0), SlipMode::StickSlip);
        let kernel = GridKernel::new(&self.slider, threshold, stresses);
        let column = |&velocity: &f64| {
            let mut cells = vec![undecided; stresses.len()];
            kernel.as_ref()?.classify_row(velocity, &mut cells).map(|_| cells)
        };
        let columns: Option<Vec<Vec<GridCell>>> = parallel::map(velocities, column).into_iter().collect();
        // Every coordinate of a logarithmic axis in the allowed range is positive and finite.
        let columns = columns.unwrap_or_default();
        let row = |row: usize| columns.iter().map(move |cells| cells[row].slip_mode());
        (0..stresses.len()).flat_map(row).collect()
    }

    /// The point of these coordinates, taken as the binary numbers that they are.
    fn classified(
        &self,
        rounded: &Slider<Dd>,
        threshold: &InertialThreshold,
        [velocity, stress]: [f64; 2],
    ) -> Classification {
        let rounded = rounded.at(Dd::from(stress), Dd::from(velocity));
        classify_quickly(&rounded, threshold).unwrap_or_else(|| {
            let [stress, velocity] =
                [stress, velocity].map(|value| Rational::from_f64(value).unwrap_or_default());
            classify(&self.slider.at(stress, velocity), threshold)
        })
    }
}
