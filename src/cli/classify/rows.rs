//! `classify --points`: signs, class, mode, growth rate and frequency of every row.

use slipmode::csv::{Cells, Remark, RowWork, joined, names, push_cell, push_cells};
use slipmode::scene::{Faults, Problem, Uncertain};
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::shortest;
use slipmode_core::number::{Dd, nearest_f64};
use slipmode_core::roots::PrecisionLevel;
use slipmode_core::stability::batch::classify_points;
use slipmode_core::stability::{
    Classification, InertialThreshold, OverBox, ParameterBox, SpectralClass, classify, over_box,
};

use crate::cli::classify::derived::{self, Derived};
use crate::cli::classify::ranges::{RootRanges, cell, outward};
use crate::cli::options::OVER_BOX;
use crate::cli::unit_warnings::slider_warnings;

/// Classifies rows; with `DERIVED`, what follows from a classification is appended too.
#[derive(Debug)]
pub struct ClassifyRows<const DERIVED: bool> {
    /// From which ω/ω_n on an oscillation is called inertial.
    pub threshold: InertialThreshold,
}

/// What a row is: a point, or all points within error bars.
#[derive(Debug)]
pub enum RowFound {
    /// Without error bars.
    Point(Classification),
    /// With error bars.
    Box(Box<BoxFound>),
}

impl RowFound {
    /// What is found within error bars; none for a threshold that is not allowed there.
    pub fn over(region: &ParameterBox, threshold: &InertialThreshold) -> Option<Self> {
        let over = over_box(region, threshold)?;
        let ranges = RootRanges::new(region, &over);
        Some(Self::Box(Box::new(BoxFound { over, ranges })))
    }
}

/// What is found over a box.
#[derive(Debug)]
pub struct BoxFound {
    /// What is certain and what is possible.
    pub over: OverBox,
    /// The ranges of growth rate and frequency.
    pub ranges: RootRanges,
}

/// A row that was read and classified.
#[derive(Debug)]
pub struct Classified {
    /// What it is.
    pub found: RowFound,
    /// What follows for a point, where it is wanted.
    pub derived: Option<Derived>,
    /// Values that look like another unit's.
    pub warnings: Vec<String>,
}

/// The slip mode as a word: on K = K_c it is neutral, an oscillation that neither grows nor decays.
pub fn slip_mode_word(found: &Classification) -> &'static str {
    if found.transition_sign == 0 { NEUTRAL } else { found.slip_mode.as_str() }
}

/// A sign as a number.
const fn sign_word(sign: i8) -> &'static str {
    match sign {
        1.. => "1",
        0 => "0",
        _ => "-1",
    }
}

fn push_word(word: &str, out: &mut Vec<u8>) {
    out.push(b',');
    out.extend_from_slice(word.as_bytes());
}

/// The word of points on K = K_c, as class and as mode.
pub const NEUTRAL: &str = SpectralClass::Neutral.as_str();

/// All columns of a classification, those that follow from it last.
pub const RESULT_COLUMNS: [&str; COLUMNS.len() + derived::COLUMNS.len()] =
    joined(&COLUMNS, &names(&derived::COLUMNS));

/// All columns of `classify --points`: the last one is the largest share of the error bars in which the slip mode is not decided.
const APPENDED: [&str; RESULT_COLUMNS.len() + 1] = joined(&RESULT_COLUMNS, &["undecided_share"]);

/// The columns of a classification.
const COLUMNS: [&str; 7] = [
    "transition_sign",
    "boundary_sign",
    "spectral_class",
    "slip_mode",
    "max_real_per_s",
    "max_imaginary_per_s",
    "rung",
];

impl<const DERIVED: bool> RowWork for ClassifyRows<DERIVED> {
    /// Reading decides every row, many of them together.
    type Input = Classified;
    type Kept = ();

    const APPENDED: &'static [&'static str] = if DERIVED { &APPENDED } else { &COLUMNS };
    const BLOCK_ROWS: usize = 2048;
    const BLOCKS_PER_THREAD: usize = 1;

    /// A row by the exact values of its decimals.
    fn read(&self, cells: Cells<'_>) -> Result<Classified, Faults> {
        let values = cells.uncertain()?;
        let parameters = Parameters::from(values.each_ref().map(Uncertain::middle));
        let warnings = slider_warnings(parameters.map(nearest_f64));
        if values.iter().all(Uncertain::is_certain) {
            let found = classify(&parameters, &self.threshold);
            let derived = DERIVED.then(|| Derived::of(&parameters, &found));
            return Ok(Classified { found: RowFound::Point(found), derived, warnings });
        }
        let found = Uncertain::region(values).and_then(|region| RowFound::over(&region, &self.threshold));
        let needs = || Problem::Needs(format!("--inertial-threshold with {OVER_BOX}"));
        let found = found.ok_or_else(|| vec![cells.fault(None, needs())])?;
        Ok(Classified { found, derived: None, warnings })
    }

    /// Rows in double-double, together; those that it does not decide by the exact values.
    fn read_rows(&self, cells: &[Cells<'_>]) -> Vec<Result<Classified, Faults>> {
        let points: Vec<Option<Parameters<Dd>>> = cells.iter().map(|cells| cells.dd_parameters()).collect();
        let known: Vec<Parameters<Dd>> = points.iter().flatten().cloned().collect();
        let mut classified = classify_points(&known, &self.threshold).into_iter();
        let row = |(cells, point): (&Cells<'_>, Option<Parameters<Dd>>)| {
            let found = point.and_then(|point| classified.next().flatten().map(|found| (point, found)));
            let Some((point, found)) = found else { return self.read(*cells) };
            let derived = DERIVED.then(|| {
                Derived::quickly(&point, &found)
                    .or_else(|| Some(Derived::of(&cells.parameters().ok()?, &found)))
            });
            let warnings = slider_warnings(point.map(Dd::hi));
            Ok(Classified { found: RowFound::Point(found), derived: derived.flatten(), warnings })
        };
        cells.iter().zip(points).map(row).collect()
    }

    fn append(&self, Classified { found, derived, warnings }: &Classified, out: &mut Vec<u8>) -> Remark {
        match found {
            RowFound::Point(found) => append_point(found, out),
            RowFound::Box(found) => append_box(found, out),
        }
        match (found, derived) {
            (_, Some(derived)) => {
                push_cells(&derived::COLUMNS, derived, out);
                push_word("0", out);
            }
            (RowFound::Box(found), None) if DERIVED => {
                let [_, _, frequency] = found.ranges.enclosures();
                push_ranges(
                    [frequency, Some(outward(&found.over.critical_stiffness_pa_per_m)), None, None],
                    out,
                );
                push_word(&shortest(nearest_f64(&found.over.undecided_share())), out);
            }
            _ => {}
        }
        Remark::warning(warnings)
    }
}

fn append_point(found: &Classification, out: &mut Vec<u8>) {
    for word in [
        sign_word(found.transition_sign),
        sign_word(found.boundary_sign),
        found.spectral_class.as_str(),
        slip_mode_word(found),
    ] {
        push_word(word, out);
    }
    for rate in [found.max_real_per_s, found.max_imaginary_per_s] {
        out.push(b',');
        rate.pieces(|piece| out.extend_from_slice(piece.as_bytes()));
    }
    push_word(found.precision_level.as_str(), out);
}

/// All that is possible, separated by semicolons, modes that are not decided last. A value is a range.
fn append_box(BoxFound { over: found, ranges }: &BoxFound, out: &mut Vec<u8>) {
    let mut modes: Vec<&str> = found.slip_modes.iter().map(|possible| possible.what.as_str()).collect();
    modes.extend(found.undecided.iter().map(|(mode, _)| mode.as_str()));
    for [least, greatest] in [found.transition_signs, found.boundary_signs] {
        push_word(&(least..=greatest).map(sign_word).collect::<Vec<_>>().join(";"), out);
    }
    let classes = found.spectral_classes.iter().map(|possible| possible.what.as_str());
    push_word(&classes.collect::<Vec<_>>().join(";"), out);
    push_word(&modes.join(";"), out);
    let [real, imaginary, _] = ranges.enclosures();
    push_ranges([real, imaginary], out);
    push_word(PrecisionLevel::Exact.as_str(), out);
}

fn push_ranges<const N: usize>(ranges: [Option<[f64; 2]>; N], out: &mut Vec<u8>) {
    for range in ranges {
        out.push(b',');
        push_cell(out, cell(range).as_bytes());
    }
}
