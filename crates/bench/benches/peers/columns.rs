//! Files of 64-bit columns: seven inputs, two exact signs, the extremes of the spectrum, and three roots, from enclosures.
//!
//! The roots come in two columns for each part: the part rounded to 64 bits, and what that leaves.

use std::fs;
use std::path::Path;

use num_complex::Complex;
use rayon::prelude::*;
use rug::Float;
use slipmode_core::friction::Parameters;
use slipmode_core::number::Rational;
use slipmode_core::roots::{CertifiedRoot, certified_roots};

/// Inputs and references, column by column.
pub struct Columns(Vec<Vec<f64>>);

/// Decimal digits of the references: more than two columns hold.
const DIGITS: u32 = 40;
const INPUTS: usize = 7;
const ANSWERS: usize = 17;
const WIDTH: usize = INPUTS + ANSWERS;

/// The exact answers of one point, rates in 1/s.
#[derive(Debug, Clone, Copy)]
pub struct Answers {
    /// The sign of K − K_c.
    pub transition_sign: f64,
    /// The sign of the discriminant.
    pub boundary_sign: f64,
    /// max Re(s).
    pub max_real: f64,
    /// The modulus of the root with this real part.
    pub modulus: f64,
    /// max Im(s).
    pub max_imaginary: f64,
}

/// The columns of [`Answers`], then real and imaginary parts of the three roots, by rationals and enclosures.
fn reference(point: &Parameters<f64>) -> [f64; ANSWERS] {
    let exact = point.map(|value| Rational::from_f64(*value).unwrap());
    let groups = exact.groups();
    let found = certified_roots(&groups.characteristic_cubic(), DIGITS);
    let rate = exact.rate_per_s();
    let parts = |root: &CertifiedRoot| [&root.re, &root.im].map(|part| part.clone() * &rate);
    let repeated = found.roots.iter().flat_map(|root| (0..root.multiplicity).map(move |_| parts(root)));
    let roots: Vec<[Float; 2]> = repeated.collect();
    let largest = roots.iter().max_by(|one, other| one[0].total_cmp(&other[0])).unwrap();
    let imaginary = roots.iter().map(|[_, im]| im.to_f64()).fold(0.0, f64::max);
    let margin = groups.transition_margin();
    let mut answers = vec![
        f64::from(i8::from(margin > 0) - i8::from(margin < 0)),
        f64::from(found.discriminant_sign),
        largest[0].to_f64(),
        largest[0].clone().hypot(&largest[1]).to_f64(),
        imaginary,
    ];
    answers.extend(roots.iter().flatten().map(Float::to_f64));
    answers.extend(roots.iter().flatten().map(|part| (part.clone() - part.to_f64()).to_f64()));
    answers.try_into().unwrap()
}

impl Columns {
    /// Computes the references of some points.
    pub fn of(points: &[Parameters<f64>]) -> Self {
        let rows: Vec<[f64; WIDTH]> = points
            .par_iter()
            .map(|point| {
                let (inputs, answers) = (<[f64; INPUTS]>::from(point.clone()), reference(point));
                std::array::from_fn(|i| if i < INPUTS { inputs[i] } else { answers[i - INPUTS] })
            })
            .collect();
        Self((0..WIDTH).map(|column| rows.iter().map(|row| row[column]).collect()).collect())
    }

    /// Writes one column after the other, little-endian.
    pub fn write(&self, path: &Path) {
        let bytes: Vec<u8> = self.0.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
        fs::write(path, bytes).unwrap();
    }

    /// Reads what [`Self::write`] wrote.
    pub fn read(path: &Path) -> Self {
        let bytes = fs::read(path).unwrap();
        let values: Vec<f64> = bytes.as_chunks().0.iter().map(|eight| f64::from_le_bytes(*eight)).collect();
        Self(values.chunks(values.len() / WIDTH).map(<[f64]>::to_vec).collect())
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.0[0].len()
    }

    /// The inputs as columns.
    pub fn inputs(&self) -> Parameters<&[f64]> {
        Parameters::from(std::array::from_fn(|input| self.0[input].as_slice()))
    }

    /// The inputs of one point.
    pub fn point(&self, index: usize) -> Parameters<f64> {
        Parameters::from(std::array::from_fn(|input| self.0[input][index]))
    }

    /// The references of one point.
    pub fn answers(&self, index: usize) -> Answers {
        let at = |column: usize| self.0[INPUTS + column][index];
        Answers {
            transition_sign: at(0),
            boundary_sign: at(1),
            max_real: at(2),
            modulus: at(3),
            max_imaginary: at(4),
        }
    }

    /// The largest distance of a root from the nearest exact one, relative to the modulus of that.
    pub fn root_error(&self, index: usize, roots: &[Complex<f64>; 3]) -> f64 {
        let at = |column: usize| self.0[INPUTS + column][index];
        let distance = |root: &Complex<f64>, exact: usize| {
            // Real and imaginary parts from column 5 on, what they leave from column 11 on.
            let part =
                |value: f64, part: usize| (value - at(5 + 2 * exact + part)) - at(11 + 2 * exact + part);
            let modulus = libm::hypot(at(5 + 2 * exact), at(6 + 2 * exact));
            libm::hypot(part(root.re, 0), part(root.im, 1)) / modulus
        };
        let nearest = |root| (0..3).map(|exact| distance(root, exact)).fold(f64::INFINITY, f64::min);
        roots.iter().map(nearest).fold(0.0, f64::max)
    }
}
