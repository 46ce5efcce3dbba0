//! What follows from a classification: the frequency in Hz and relative to the natural one, and K_c.

use slipmode::csv::{Cells, Column, Datum, Remark, RowWork, push_cell, push_cells};
use slipmode::scene::{Faults, Uncertain};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Dd, Rational, nearest_f64};
use slipmode_core::stability::Classification;

use crate::cli::classify::ranges::{cell, outward};
use crate::cli::classify::rows::{BoxFound, Classified, ClassifyRows, Found};

/// Values beyond the range of 64-bit numbers are absent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derived {
    /// max Im(s)/2π, Hz; 0 exactly when no root is complex.
    pub frequency_hz: Option<f64>,
    /// K_c of eq 9, Pa/m.
    pub critical_stiffness_pa_per_m: Option<f64>,
    /// K/K_c; absent for a ≥ b, where K_c is not positive.
    pub stiffness_over_critical: Option<f64>,
    /// ω_n = √(K/M), 1/s.
    pub natural_angular_frequency_per_s: Option<f64>,
    /// max Im(s)/ω_n.
    pub frequency_over_natural: Option<f64>,
}

/// The columns that `classify --points` appends last.
const COLUMNS: [Column<Derived>; 4] = [
    ("frequency_hz", |found| Datum::Number(found.frequency_hz)),
    ("critical_stiffness_pa_per_m", |found| Datum::Number(found.critical_stiffness_pa_per_m)),
    ("stiffness_over_critical", |found| Datum::Number(found.stiffness_over_critical)),
    ("frequency_over_natural", |found| Datum::Number(found.frequency_over_natural)),
];

/// Below this share of b, b − a is taken from the exact values: double-double has lost too many digits there.
const LEAST_DIFFERENCE: f64 = 1e-10;

impl Derived {
    /// From the exact values.
    pub fn of(parameters: &Parameters<Rational>, found: &Classification) -> Self {
        let critical = parameters.critical_stiffness();
        let ratio = (critical > 0).then(|| Rational::from(&parameters.slider.stiffness_pa_per_m / &critical));
        let natural_squared = parameters.slider.natural_angular_frequency_squared_per_s2();
        Self::new(
            nearest_f64(&critical),
            ratio.as_ref().map(nearest_f64),
            nearest_f64(&natural_squared),
            found,
        )
    }

    /// From values in double-double; none where they lose digits.
    fn quickly(parameters: &Parameters<Dd>, found: &Classification) -> Option<Self> {
        let slider = &parameters.slider;
        let difference = slider.effect_difference().hi();
        if difference.abs() < LEAST_DIFFERENCE * slider.evolution_effect.hi() {
            return None;
        }
        let critical = parameters.critical_stiffness();
        let ratio = (slider.stiffness_pa_per_m / critical).hi();
        let natural_squared = slider.natural_angular_frequency_squared_per_s2().hi();
        let has_range = [critical.hi(), ratio, natural_squared].into_iter().all(f64::is_normal);
        has_range
            .then(|| Self::new(critical.hi(), (difference > 0.0).then_some(ratio), natural_squared, found))
    }

    fn new(critical: f64, ratio: Option<f64>, natural_squared: f64, found: &Classification) -> Self {
        let in_range = |value: f64| (value == 0.0 || value.is_normal()).then_some(value);
        let positive = |value: f64| value.is_normal().then_some(value);
        let natural = positive(natural_squared).map(f64::sqrt);
        let frequency = found.max_imaginary_per_s.to_f64();
        Self {
            frequency_hz: frequency.and_then(|frequency| in_range(frequency / std::f64::consts::TAU)),
            critical_stiffness_pa_per_m: in_range(critical),
            stiffness_over_critical: ratio.and_then(positive),
            natural_angular_frequency_per_s: natural,
            frequency_over_natural: frequency
                .zip(natural)
                .and_then(|(frequency, natural)| in_range(frequency / natural)),
        }
    }
}

/// Classifies rows, and appends what follows.
#[derive(Debug)]
pub struct ClassifyPoints(pub ClassifyRows);

impl RowWork for ClassifyPoints {
    type Input = (Classified, Option<Derived>);
    type Kept = ();

    const APPENDED: &'static [&'static str] = &{
        let mut names = [""; ClassifyRows::APPENDED.len() + COLUMNS.len()];
        let mut index = 0;
        while index < names.len() {
            let first = ClassifyRows::APPENDED.len();
            names[index] =
                if index < first { ClassifyRows::APPENDED[index] } else { COLUMNS[index - first].0 };
            index += 1;
        }
        names
    };
    const BLOCK_ROWS: usize = ClassifyRows::BLOCK_ROWS;
    const BLOCKS_PER_THREAD: usize = ClassifyRows::BLOCKS_PER_THREAD;

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        let classified = self.0.read(cells)?;
        let derived = derived_of_row(cells, &classified);
        Ok((classified, derived))
    }

    fn read_rows(&self, cells: &[Cells<'_>]) -> Vec<Result<Self::Input, Faults>> {
        let rows = self.0.read_rows(cells).into_iter().zip(cells);
        let row = |(read, cells): (Result<Classified, Faults>, &Cells<'_>)| {
            read.map(|classified| {
                let derived = derived_of_row(*cells, &classified);
                (classified, derived)
            })
        };
        rows.map(row).collect()
    }

    fn append(&self, (classified, derived): &Self::Input, out: &mut Vec<u8>) -> Remark {
        let remark = self.0.append(classified, out);
        match (&classified.found, derived) {
            (_, Some(derived)) => push_cells(&COLUMNS, derived, out),
            (Found::Box(found), None) => append_ranges(found, out),
            (Found::Point(_), None) => out.extend_from_slice(",".repeat(COLUMNS.len()).as_bytes()),
        }
        remark
    }
}

/// The ranges of the frequency and of K_c; the other two columns are empty.
fn append_ranges(found: &BoxFound, out: &mut Vec<u8>) {
    let [_, _, frequency] = found.ranges.enclosures();
    let critical = outward(&found.over.critical_stiffness_pa_per_m);
    for range in [frequency, Some(critical), None, None] {
        out.push(b',');
        push_cell(out, cell(range).as_bytes());
    }
}

/// What follows for a row; nothing where it has error bars.
fn derived_of_row(cells: Cells<'_>, classified: &Classified) -> Option<Derived> {
    let Found::Point(found) = &classified.found else { return None };
    let quick = cells.dd_parameters().and_then(|parameters| Derived::quickly(&parameters, found));
    quick.or_else(|| {
        let values = cells.uncertain().ok()?;
        Some(Derived::of(&Parameters::from(values.each_ref().map(Uncertain::middle)), found))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;
    use slipmode_core::stability::{InertialThreshold, classify};

    #[test]
    fn double_double_gives_what_the_exact_values_give() {
        for values in [
            ["0.004", "0.006", "1e-5", "1e7", "1000", "1e5", "1e-3"],
            ["0.009", "0.0126", "8e-6", "2e9", "2400", "5e6", "1e-5"],
            ["0.006", "0.004", "1e-5", "1e7", "1000", "1e5", "1e-3"],
            ["0.004", "0.00400000000000001", "1e-5", "1e7", "1000", "1e5", "1e-3"],
            ["0.004", "0.006", "1e-5", "1e7", "1000", "1e3", "1e-5"],
        ] {
            let exact = Parameters::from(values.map(|text| parse_decimal(text).unwrap()));
            let found = classify(&exact, &InertialThreshold::default());
            let wanted = Derived::of(&exact, &found);
            let quick = Derived::quickly(&exact.map(Dd::from_rational), &found);
            let (difference, b) = (nearest_f64(&exact.slider.effect_difference()), 0.004);
            assert_eq!(quick.is_some(), difference.abs() > LEAST_DIFFERENCE * b, "{values:?}");
            for quick in quick.iter() {
                let close = |one: Option<f64>, other: Option<f64>| match (one, other) {
                    (Some(one), Some(other)) => (one - other).abs() <= 4.0 * f64::EPSILON * other.abs(),
                    (one, other) => one == other,
                };
                assert!(close(quick.critical_stiffness_pa_per_m, wanted.critical_stiffness_pa_per_m));
                assert!(close(quick.stiffness_over_critical, wanted.stiffness_over_critical), "{values:?}");
                assert!(close(quick.frequency_over_natural, wanted.frequency_over_natural));
                assert_eq!(quick.frequency_hz, wanted.frequency_hz);
            }
            assert_eq!(wanted.stiffness_over_critical.is_some(), difference > 0.0);
        }
    }
}
