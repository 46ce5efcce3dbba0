//! The work `boundary`: how far a point is from max Im(s) = 0, and how wrong the asymptotes are at the nearest place.

use slipmode::csv::{Cells, Column, Datum, Remark, RowWork, names, push_cells};
use slipmode::scene::Faults;
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Ball, Rational, Wide};
use slipmode_core::stability::{Arc, BoundaryPoint, LogDistance, boundary_sign, nearest_boundary_point};

/// Digits of the boundary's place: more than a 64-bit number prints.
const DIGITS: u32 = 20;

/// Measures points against the boundary.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryRows;

/// A point against the boundary.
struct Measured {
    sign: i8,
    distance: LogDistance,
    nearest: Option<BoundaryPoint>,
}

const COLUMNS: [Column<Measured>; 7] = [
    ("boundary_sign", |of| Datum::Text(of.sign.to_string())),
    ("log10_normal_stress_distance", |of| wide(of.distance.normal_stress)),
    ("log10_loading_velocity_distance", |of| wide(of.distance.loading_velocity)),
    ("arc", |of| place(of, |at| if at.arc == Arc::Upper { "upper" } else { "lower" }.to_string())),
    ("boundary_normal_stress_pa", |of| place(of, |at| nearest_number(&at.normal_stress_pa))),
    ("asymptote", |of| place(of, |at| at.asymptote.as_str().to_string())),
    ("asymptote_relative_error", |of| place(of, |at| nearest_number(&at.relative_error))),
];

fn wide(value: Option<Wide>) -> Datum {
    Datum::Text(value.map(|value| value.to_string()).unwrap_or_default())
}

fn place(of: &Measured, part: fn(&BoundaryPoint) -> String) -> Datum {
    Datum::Text(of.nearest.as_ref().map(part).unwrap_or_default())
}

impl RowWork for BoundaryRows {
    type Input = Parameters<Rational>;
    type Kept = ();

    const APPENDED: &'static [&'static str] = &names(&COLUMNS);
    const BLOCK_ROWS: usize = 64;
    const BLOCKS_PER_THREAD: usize = 1;

    fn needs_for_errors(&self) -> Option<&'static str> {
        Some("no errors: a sweep computes exact points; remove it")
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        cells.parameters()
    }

    fn append(&self, parameters: &Self::Input, out: &mut Vec<u8>) -> Remark {
        let measured = Measured {
            sign: boundary_sign(&parameters.groups()),
            distance: LogDistance::to_boundary(parameters),
            nearest: nearest_boundary_point(parameters, DIGITS),
        };
        push_cells(&COLUMNS, &measured, out);
        Remark::default()
    }
}

fn nearest_number(value: &Ball) -> String {
    Wide::from_float(value.centre()).to_string()
}
