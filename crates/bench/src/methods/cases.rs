//! Hard cases: points where programs go wrong, with references that other programs agree on.

use rayon::prelude::*;

use slipmode::scene::{Fault, Faults, Problem, Quantity};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Rational, Wide, nearest_f64, parse_decimal};
use slipmode_core::roots::PrecisionLevel;
use slipmode_core::stability::{InertialThreshold, classify};

/// A point with the answers of independent programs.
#[derive(Debug, Clone, PartialEq)]
pub struct HardCase {
    /// The family that the point belongs to, from the `#` line above it.
    pub family: String,
    /// The seven inputs, exact.
    pub parameters: Parameters<Rational>,
    /// What independent programs found.
    pub expected: Expected,
}

/// The answers of independent programs for one point.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// The sign of K − K_c: `-1`, `0` or `1`.
    pub transition_sign: String,
    /// The sign of the discriminant of eq 8: `-1`, `0` or `1`.
    pub boundary_sign: String,
    spectral_class: String,
    slip_mode: String,
    /// max Re(s), 1/s.
    pub max_real_per_s: Rational,
    /// The modulus of that root, 1/s.
    pub its_modulus_per_s: Rational,
    /// max Im(s), 1/s.
    pub max_imaginary_per_s: Rational,
}

/// How one family of hard cases fared.
#[derive(Debug, Clone, PartialEq)]
pub struct FamilyOutcome {
    /// The family.
    pub family: String,
    /// How many points it has.
    pub points: usize,
    /// How many have a wrong sign, class or slip mode.
    pub wrong: usize,
    /// The largest error of max Re(s) relative to that root's modulus.
    pub worst_real_error: f64,
    /// The largest error of max Im(s) relative to itself.
    pub worst_imaginary_error: f64,
    /// The highest precision level that a point needed.
    pub highest_precision_level: PrecisionLevel,
}

const ANSWERS: [&str; 7] = [
    "expected_transition_sign",
    "expected_boundary_sign",
    "expected_spectral_class",
    "expected_slip_mode",
    "expected_max_real_per_s",
    "its_modulus_per_s",
    "expected_max_imaginary_per_s",
];

/// Reads a file of hard cases: CSV with the seven inputs, the seven answers, and `#` lines that name families.
///
/// # Errors
/// A missing column, a short row or what is not a number, each with its line.
pub fn read_hard_cases(file: &str, text: &str) -> Result<Vec<HardCase>, Faults> {
    let mut family = String::new();
    let mut header: Option<Vec<usize>> = None;
    let mut cases = Vec::new();
    let mut faults = Faults::new();
    for (index, line) in text.lines().enumerate() {
        if let Some(words) = line.strip_prefix('#') {
            words.trim().clone_into(&mut family);
        } else if header.is_none() {
            header = Some(find_columns(file, index + 1, line).map_err(|fault| vec![fault])?);
        } else if let Some(columns) = &header {
            match read_case(file, index + 1, line, columns, &family) {
                Ok(case) => cases.push(case),
                Err(fault) => faults.push(fault),
            }
        }
    }
    if faults.is_empty() { Ok(cases) } else { Err(faults) }
}

fn fault(file: &str, line: usize, key: &str, value: Option<&str>, problem: Problem) -> Fault {
    Fault { file: file.into(), line: Some(line), key: key.into(), value: value.map(str::to_owned), problem }
}

fn column_names() -> impl Iterator<Item = &'static str> {
    Quantity::ALL.into_iter().map(Quantity::as_str).chain(ANSWERS)
}

fn find_columns(file: &str, line: usize, header: &str) -> Result<Vec<usize>, Fault> {
    let names: Vec<&str> = header.split(',').collect();
    column_names()
        .map(|wanted| {
            names.iter().position(|name| *name == wanted).ok_or_else(|| {
                fault(file, line, wanted, None, Problem::Missing { allowed: "a column of this name".into() })
            })
        })
        .collect()
}

fn read_case(file: &str, line: usize, row: &str, columns: &[usize], family: &str) -> Result<HardCase, Fault> {
    let cells: Vec<&str> = row.split(',').collect();
    let mut texts = Vec::with_capacity(columns.len());
    for (&column, name) in columns.iter().zip(column_names()) {
        let missing =
            || fault(file, line, name, None, Problem::Missing { allowed: "a cell in every column".into() });
        texts.push((name, *cells.get(column).ok_or_else(missing)?));
    }
    let number = |index: usize| {
        let (name, text) = texts[index];
        parse_decimal(text).map_err(|reason| {
            fault(file, line, name, Some(text), Problem::NotANumber { reason, allowed: None })
        })
    };
    let word = |index: usize| texts[index].1.to_owned();
    let mut inputs: [Rational; 7] = Default::default();
    for (index, input) in inputs.iter_mut().enumerate() {
        *input = number(index)?;
    }
    if let Some(index) = inputs.iter().position(|input| *input <= 0) {
        let (name, text) = texts[index];
        return Err(fault(file, line, name, Some(text), Problem::NotPositive { allowed: "> 0".into() }));
    }
    let expected = Expected {
        transition_sign: word(7),
        boundary_sign: word(8),
        spectral_class: word(9),
        slip_mode: word(10),
        max_real_per_s: number(11)?,
        its_modulus_per_s: number(12)?,
        max_imaginary_per_s: number(13)?,
    };
    Ok(HardCase { family: family.to_owned(), parameters: Parameters::from(inputs), expected })
}

/// Classifies every case and compares it with its reference, family by family.
#[must_use]
pub fn compare_hard_cases(cases: &[HardCase]) -> Vec<FamilyOutcome> {
    let results: Vec<FamilyOutcome> = cases.par_iter().map(compare).collect();
    let mut families: Vec<FamilyOutcome> = Vec::new();
    for result in results {
        match families.last_mut().filter(|last| last.family == result.family) {
            Some(last) => last.absorb(&result),
            None => families.push(result),
        }
    }
    families
}

impl FamilyOutcome {
    fn absorb(&mut self, other: &Self) {
        self.points += other.points;
        self.wrong += other.wrong;
        self.worst_real_error = self.worst_real_error.max(other.worst_real_error);
        self.worst_imaginary_error = self.worst_imaginary_error.max(other.worst_imaginary_error);
        self.highest_precision_level = self.highest_precision_level.max(other.highest_precision_level);
    }
}

fn compare(case: &HardCase) -> FamilyOutcome {
    let found = classify(&case.parameters, &InertialThreshold::default());
    let expected = &case.expected;
    let right = found.transition_sign.to_string() == expected.transition_sign
        && found.boundary_sign.to_string() == expected.boundary_sign
        && found.spectral_class.as_str() == expected.spectral_class
        && found.slip_mode.as_str() == expected.slip_mode;
    FamilyOutcome {
        family: case.family.clone(),
        points: 1,
        wrong: usize::from(!right),
        worst_real_error: error(found.max_real_per_s, &expected.max_real_per_s, &expected.its_modulus_per_s),
        worst_imaginary_error: error(
            found.max_imaginary_per_s,
            &expected.max_imaginary_per_s,
            &expected.max_imaginary_per_s,
        ),
        highest_precision_level: found.precision_level,
    }
}

/// |found − expected| over `scale`; 0 when both are zero.
fn error(found: Wide, expected: &Rational, scale: &Rational) -> f64 {
    let difference = found.to_float().to_rational().unwrap_or_default() - expected;
    if difference.is_zero() {
        return 0.0;
    }
    if scale.is_zero() { f64::INFINITY } else { nearest_f64(&(difference / scale).abs()) }
}
