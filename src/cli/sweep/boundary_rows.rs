//! The work `boundary`: how far a point is from max Im(s) = 0, and how wrong the asymptotes are at the nearest place.

use slipmode::csv::{Cells, Remark, RowWork};
use slipmode::scene::{Faults, Problem};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Ball, Rational, Wide};
use slipmode_core::stability::{Arc, BoundaryPoint, LogDistance, boundary_sign, nearest_boundary_point};

/// Digits of the boundary's place: more than a 64-bit number prints.
const DIGITS: u32 = 20;

/// Measures points against the boundary.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryRows;

impl RowWork for BoundaryRows {
    type Input = Parameters<Rational>;
    type Kept = ();

    const APPENDED: &'static [&'static str] = &[
        "boundary_sign",
        "log10_normal_stress_distance",
        "log10_loading_velocity_distance",
        "arc",
        "boundary_normal_stress_pa",
        "asymptote",
        "asymptote_relative_error",
    ];
    const BLOCK_ROWS: usize = 64;
    const BLOCKS_PER_THREAD: usize = 1;

    fn header_faults(&self, _names: &[String]) -> Vec<(String, Problem)> {
        Vec::new()
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        cells.parameters()
    }

    fn append(&self, parameters: &Self::Input, out: &mut Vec<u8>) -> Remark {
        let distance = LogDistance::to_boundary(parameters);
        let place = nearest_boundary_point(parameters, DIGITS);
        let number = |value: Option<Wide>| value.map(|value| value.to_string()).unwrap_or_default();
        let of_place = |part: fn(&BoundaryPoint) -> String| place.as_ref().map(part).unwrap_or_default();
        let cells = [
            boundary_sign(&parameters.groups()).to_string(),
            number(distance.normal_stress),
            number(distance.loading_velocity),
            of_place(|place| if place.arc == Arc::Upper { "upper" } else { "lower" }.to_string()),
            of_place(|place| nearest_number(&place.normal_stress_pa)),
            of_place(|place| place.asymptote.as_str().to_string()),
            of_place(|place| nearest_number(&place.relative_error)),
        ];
        for cell in cells {
            out.push(b',');
            out.extend_from_slice(cell.as_bytes());
        }
        Remark::default()
    }
}

fn nearest_number(value: &Ball) -> String {
    Wide::from_float(value.centre()).to_string()
}
