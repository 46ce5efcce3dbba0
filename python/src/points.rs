//! The classification of arrays, by the routine of `classify --points`.

use pyo3::prelude::*;
use pyo3::types::PyByteArray;
use rayon::prelude::*;
use slipmode::scene::{AllowedRange, Fault, Faults, Problem, Quantity, Uncertain};
use slipmode_core::friction::{Parameters, Slider};
use slipmode_core::number::{Dd, Rational};
use slipmode_core::stability::batch::classify_points as classify_rows;
use slipmode_core::stability::{Classification, Frequencies, InertialThreshold, SlipMode, classify};

use crate::{input_error, threshold};

/// Points of a part, the unit of parallel work: that of `classify --points`.
const PART: usize = 2048;
/// Bytes of a 64-bit number.
const WIDTH: usize = 8;

/// What is found of points: columns of 8-bit codes and of 64-bit numbers.
type Columns<'py> = (Codes<'py>, Codes<'py>, Codes<'py>, Codes<'py>, Codes<'py>, Codes<'py>, Codes<'py>);
type Codes<'py> = Bound<'py, PyByteArray>;

/// Classifies points with a common slider, whose normal stresses and loading velocities are little-endian 64-bit numbers, taken
/// as the exact binary numbers that they are.
///
/// Returns the signs of K − K_c and of the discriminant, spectral classes and slip modes as codes of 8 bits, and max Re(s),
/// max Im(s) and the frequency in Hz as 64-bit numbers, NaN beyond their range. `first` is the index of the first point, for messages.
#[pyfunction]
#[pyo3(signature = (slider, normal_stresses, loading_velocities, inertial_threshold=None, first=0))]
pub fn classify_points<'py>(
    py: Python<'py>,
    slider: [String; 5],
    normal_stresses: &[u8],
    loading_velocities: &[u8],
    inertial_threshold: Option<&str>,
    first: usize,
) -> PyResult<Columns<'py>> {
    let work = Work {
        slider: read_slider(&slider).map_err(|faults| input_error(&faults))?,
        threshold: threshold(inertial_threshold)?,
    };
    let rounded = work.slider.map(Dd::from_rational);
    let part = |(index, (stresses, velocities)): (usize, (&[u8], &[u8]))| {
        work.part(&rounded, &numbers(stresses), &numbers(velocities), first + index * PART)
    };
    let found: Result<Vec<Part>, Faults> = py.detach(|| {
        let parts = normal_stresses.par_chunks(PART * WIDTH).zip(loading_velocities.par_chunks(PART * WIDTH));
        parts.enumerate().map(part).collect()
    });
    let parts = found.map_err(|faults| input_error(&faults))?;
    let column = |of: fn(&Part) -> &Vec<u8>| {
        let length = parts.iter().map(|part| of(part).len()).sum();
        PyByteArray::new_with(py, length, |mut rest| {
            for part in &parts {
                let (own, others) = rest.split_at_mut(of(part).len());
                own.copy_from_slice(of(part));
                rest = others;
            }
            Ok(())
        })
    };
    Ok((
        column(|part| &part.transition_signs)?,
        column(|part| &part.boundary_signs)?,
        column(|part| &part.spectral_classes)?,
        column(|part| &part.slip_modes)?,
        column(|part| &part.max_real_per_s)?,
        column(|part| &part.max_imaginary_per_s)?,
        column(|part| &part.frequency_hz)?,
    ))
}

fn numbers(bytes: &[u8]) -> Vec<f64> {
    let (words, _) = bytes.as_chunks::<WIDTH>();
    words.iter().map(|word| f64::from_le_bytes(*word)).collect()
}

/// Checks the five values of a slider, texts in the grammar of the command line; returns whether one has an error bar.
#[pyfunction]
pub fn check_slider(slider: [String; 5]) -> PyResult<bool> {
    let mut faults = Faults::new();
    let mut is_uncertain = false;
    for (quantity, text) in Quantity::OF_THE_SLIDER.into_iter().zip(slider) {
        match Uncertain::parse(&text, |number| quantity.parse(number)) {
            Ok(value) => is_uncertain |= !value.is_certain(),
            Err(problem) => faults.push(fault(quantity.key().into(), text, problem)),
        }
    }
    if faults.is_empty() { Ok(is_uncertain) } else { Err(input_error(&faults)) }
}

/// The five values of a slider, as texts in the grammar of the command line.
fn read_slider(texts: &[String; 5]) -> Result<Slider<Rational>, Faults> {
    let mut faults = Faults::new();
    let values = [0, 1, 2, 3, 4].map(|index: usize| {
        let quantity = Quantity::OF_THE_SLIDER[index];
        let read = quantity.parse(&texts[index]);
        read.map_err(|problem| faults.push(fault(quantity.key().into(), texts[index].clone(), problem)))
            .unwrap_or_default()
    });
    if faults.is_empty() { Ok(Slider::from(values)) } else { Err(faults) }
}

fn fault(key: String, value: String, problem: Problem) -> Fault {
    Fault { file: "Slider".into(), line: None, key, value: Some(value), problem }
}

/// What is the same for all points.
struct Work {
    slider: Slider<Rational>,
    threshold: InertialThreshold,
}

/// The columns of a part.
struct Part {
    transition_signs: Vec<u8>,
    boundary_signs: Vec<u8>,
    spectral_classes: Vec<u8>,
    slip_modes: Vec<u8>,
    max_real_per_s: Vec<u8>,
    max_imaginary_per_s: Vec<u8>,
    frequency_hz: Vec<u8>,
}

impl Work {
    fn part(
        &self,
        rounded: &Slider<Dd>,
        stresses: &[f64],
        velocities: &[f64],
        first: usize,
    ) -> Result<Part, Faults> {
        let points: Vec<(f64, f64)> = stresses.iter().copied().zip(velocities.iter().copied()).collect();
        let mut faults = Faults::new();
        for (index, (stress, velocity)) in points.iter().enumerate() {
            faults.extend(refused(Quantity::NormalStress, *stress, first + index));
            faults.extend(refused(Quantity::LoadingVelocity, *velocity, first + index));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let in_dd = |(stress, velocity): &(f64, f64)| rounded.at(Dd::from(*stress), Dd::from(*velocity));
        let doubled: Vec<Parameters<Dd>> = points.iter().map(in_dd).collect();
        let found = classify_rows(&doubled, &self.threshold);
        let mut part = Part::with_capacity(points.len());
        for ((found, doubled), (stress, velocity)) in found.into_iter().zip(&doubled).zip(points) {
            // The point of these binary numbers, where double-double does not decide.
            let exact = || {
                let [stress, velocity] =
                    [stress, velocity].map(|value| Rational::from_f64(value).unwrap_or_default());
                self.slider.at(stress, velocity)
            };
            let found = found.unwrap_or_else(|| classify(&exact(), &self.threshold));
            let frequencies =
                Frequencies::quickly(doubled, &found).unwrap_or_else(|| Frequencies::of(&exact(), &found));
            part.push(&found, &frequencies);
        }
        Ok(part)
    }
}

/// The fault of a number that is not positive or outside of the allowed range.
fn refused(quantity: Quantity, value: f64, index: usize) -> Option<Fault> {
    // The ends of the range are decimals: the numbers next to them are compared exactly.
    if (1e-299..=1e299).contains(&value) {
        return None;
    }
    let range = AllowedRange::PHYSICAL;
    let problem = match Rational::from_f64(value) {
        Some(exact) => range.check(exact).err()?,
        None => Problem::OutOfRange { allowed: range.text() },
    };
    let key = format!("{}[{index}]", quantity.key());
    Some(Fault { file: "classify".into(), line: None, key, value: Some(format!("{value:e}")), problem })
}

impl Part {
    fn with_capacity(points: usize) -> Self {
        let codes = || Vec::with_capacity(points);
        let numbers = || Vec::with_capacity(points * WIDTH);
        Self {
            transition_signs: codes(),
            boundary_signs: codes(),
            spectral_classes: codes(),
            slip_modes: codes(),
            max_real_per_s: numbers(),
            max_imaginary_per_s: numbers(),
            frequency_hz: numbers(),
        }
    }

    /// The codes are the places in the lists of all classes and all modes, which have the order of the declaration.
    fn push(&mut self, found: &Classification, frequencies: &Frequencies) {
        let mode = if found.transition_sign == 0 { SlipMode::ALL.len() } else { found.slip_mode as usize };
        self.transition_signs.push(found.transition_sign.to_le_bytes()[0]);
        self.boundary_signs.push(found.boundary_sign.to_le_bytes()[0]);
        self.spectral_classes.push(found.spectral_class as u8);
        self.slip_modes.push(mode as u8);
        let bytes = |value: slipmode_core::number::Wide| value.to_f64().unwrap_or(f64::NAN).to_le_bytes();
        self.max_real_per_s.extend_from_slice(&bytes(found.max_real_per_s));
        self.max_imaginary_per_s.extend_from_slice(&bytes(found.max_imaginary_per_s));
        self.frequency_hz.extend_from_slice(&bytes(frequencies.frequency_hz));
    }
}
