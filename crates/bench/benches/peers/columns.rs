//! Files of 64-bit columns: seven inputs, two exact signs, and the largest parts that FLINT-checked enclosures give.

use std::fs;
use std::path::Path;

use rayon::prelude::*;
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::roots::{CertifiedRoot, certified_roots};

/// Inputs and references, column by column.
pub struct Columns(Vec<Vec<f64>>);

const WIDTH: usize = 12;

/// Signs of K − K_c and of the discriminant, max Re(s), that root's modulus and max Im(s) in 1/s, by rationals and enclosures.
fn reference(point: &Parameters<f64>) -> [f64; 5] {
    let exact = point.map(|value| Rational::from_f64(*value).unwrap());
    let groups = exact.groups();
    let found = certified_roots(&groups.characteristic_cubic(), 17);
    let largest = found.roots.iter().max_by(|one, other| one.re.total_cmp(&other.re)).unwrap();
    let rate = nearest_f64(&exact.rate_per_s());
    let modulus = |root: &CertifiedRoot| root.re.clone().hypot(&root.im).to_f64();
    let imaginary = found.roots.iter().map(|root| root.im.to_f64()).fold(0.0, f64::max);
    let margin = groups.transition_margin();
    [
        f64::from(i8::from(margin > 0) - i8::from(margin < 0)),
        f64::from(found.discriminant_sign),
        largest.re.to_f64() * rate,
        modulus(largest) * rate,
        imaginary * rate,
    ]
}

impl Columns {
    /// Computes the references of some points.
    pub fn of(points: &[Parameters<f64>]) -> Self {
        let rows: Vec<[f64; WIDTH]> = points
            .par_iter()
            .map(|point| {
                let (inputs, answers) = (<[f64; 7]>::from(point.clone()), reference(point));
                std::array::from_fn(|i| if i < 7 { inputs[i] } else { answers[i - 7] })
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

    /// The references of one point: two signs, max Re, that root's modulus, max Im.
    pub fn answers(&self, index: usize) -> [f64; 5] {
        std::array::from_fn(|i| self.0[7 + i][index])
    }
}
