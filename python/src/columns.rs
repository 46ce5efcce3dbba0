//! The seven columns of a call: arrays, lists of texts, or one value for all rows.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyBytes, PyFloat, PyString};
use rayon::prelude::*;
use slipmode::scene::{AllowedRange, Fault, Faults, Problem, Quantity, Uncertain, with_unit};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Dd, Rational, parse_decimal_to_dd};

use crate::call::on_own_threads;
use crate::{fault, input_error};

/// Rows of a part, the unit of parallel work: that of `classify --points`.
pub const PART: usize = 2048;
/// Bytes of a 64-bit number.
const WIDTH: usize = 8;
/// Between two looks at signals.
const TICK: Duration = Duration::from_millis(20);

/// A column as Python hands it over: its name in messages, its values, and the size in SI of its unit.
pub type Given = (String, Values, Option<String>);

/// The values of a column.
pub enum Values {
    /// One text for all rows, in the grammar of the command line.
    Text(String),
    /// Little-endian 64-bit numbers; NaN is missing.
    Floats(PyBackedBytes),
    /// A text for each row; an empty one is missing.
    Texts(Vec<String>),
    /// One number for all rows.
    Float(f64),
}

/// A column that was read, as far as that is the same for all rows.
struct Column {
    name: String,
    quantity: Quantity,
    unit: Option<Rational>,
    values: Values,
    /// The one value.
    constant: Option<Dd>,
}

/// The rows of a call.
pub struct Rows {
    columns: [Column; 7],
    /// The number of rows.
    pub length: usize,
}

impl Rows {
    /// Reads what is the same for all rows.
    pub fn new(given: [Given; 7], length: usize) -> PyResult<Self> {
        let mut faults = Faults::new();
        let mut quantities = Quantity::ALL.into_iter();
        let columns = given.map(|(name, values, unit)| {
            let quantity = quantities.next().unwrap_or(Quantity::ALL[0]);
            let unit = unit.map(|size| AllowedRange::PHYSICAL.parse(&size).unwrap_or_default());
            let mut column = Column { name, quantity, unit, values, constant: None };
            if column.is_constant() {
                column.constant = column.doubled(0).unwrap_or_else(|fault| {
                    faults.push(fault);
                    None
                });
            }
            column
        });
        if faults.is_empty() { Ok(Self { columns, length }) } else { Err(input_error(&faults)) }
    }

    /// A row in double-double; none where a value is missing.
    pub fn doubled(&self, row: usize) -> Result<Option<Parameters<Dd>>, Faults> {
        let mut values = [Dd::from(0.0); 7];
        for (value, column) in values.iter_mut().zip(&self.columns) {
            match column.doubled(row) {
                Ok(Some(found)) => *value = found,
                Ok(None) => return Ok(None),
                Err(_) => {
                    return Err(self.columns.iter().filter_map(|column| column.exact(row).err()).collect());
                }
            }
        }
        Ok(Some(Parameters::from(values)))
    }

    /// A row that [`Self::doubled`] has read, exactly.
    pub fn exact(&self, row: usize) -> Parameters<Rational> {
        let value = |column: &Column| column.exact(row).ok().flatten().unwrap_or_default();
        Parameters::from(self.columns.each_ref().map(value))
    }

    /// A row whose values are all 64-bit numbers, as such.
    pub fn binary(&self, row: usize) -> Option<Parameters<f64>> {
        let mut values = [0.0; 7];
        for (value, column) in values.iter_mut().zip(&self.columns) {
            *value = match &column.values {
                Values::Float(number) => *number,
                Values::Floats(bytes) if column.unit.is_none() => float(bytes, row),
                _ => return None,
            };
        }
        Some(Parameters::from(values))
    }

    /// Quantities whose unit was stated.
    pub fn with_unit(&self) -> Vec<Quantity> {
        let has_unit = |column: &&Column| match &column.values {
            Values::Text(text) => with_unit(text).is_some(),
            _ => column.unit.is_some(),
        };
        self.columns.iter().filter(has_unit).map(|column| column.quantity).collect()
    }
}

impl Column {
    const fn is_constant(&self) -> bool {
        matches!(self.values, Values::Text(_) | Values::Float(_))
    }

    fn doubled(&self, row: usize) -> Result<Option<Dd>, Fault> {
        if self.constant.is_some() {
            return Ok(self.constant);
        }
        // The ends of the range are decimals: the numbers next to them are compared exactly.
        let plain = |value: f64| (1e-299..=1e299).contains(&value).then(|| Dd::from(value));
        let quick = match &self.values {
            _ if self.unit.is_some() => None,
            Values::Float(value) => plain(*value),
            Values::Floats(bytes) => plain(float(bytes, row)),
            Values::Text(text) => parse_decimal_to_dd(text),
            Values::Texts(texts) => texts.get(row).and_then(|text| parse_decimal_to_dd(text)),
        };
        if quick.is_some() { Ok(quick) } else { Ok(self.exact(row)?.as_ref().map(Dd::from_rational)) }
    }

    fn exact(&self, row: usize) -> Result<Option<Rational>, Fault> {
        let given = match &self.values {
            Values::Float(value) => Err(*value),
            Values::Floats(bytes) => Err(float(bytes, row)),
            Values::Text(text) => Ok(text.as_str()),
            Values::Texts(texts) => Ok(texts.get(row).map_or("", String::as_str)),
        };
        if !self.is_constant() && given.map_or_else(f64::is_nan, str::is_empty) {
            return Ok(None);
        }
        let read = |text: &str| Uncertain::of(self.quantity, text)?.exact("a value without an error bar");
        let exact = given.map_or_else(|value| self.binary(value), read);
        exact.map(Some).map_err(|problem| {
            let key = if self.is_constant() { self.name.clone() } else { format!("{}[{row}]", self.name) };
            fault(key, given.map_or_else(|value| format!("{value:e}"), str::to_string), problem)
        })
    }

    /// The exact value of a 64-bit number in the column's unit.
    fn binary(&self, value: f64) -> Result<Rational, Problem> {
        let range = AllowedRange::PHYSICAL;
        let out_of_range = || Problem::OutOfRange { allowed: range.text() };
        let exact = Rational::from_f64(value).ok_or_else(out_of_range)?;
        range.check(self.unit.as_ref().map_or_else(|| exact.clone(), |size| Rational::from(&exact * size)))
    }
}

impl<'a, 'py> FromPyObject<'a, 'py> for Values {
    type Error = PyErr;

    fn extract(values: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(number) = values.cast::<PyFloat>() {
            return Ok(Self::Float(number.value()));
        }
        if let Ok(text) = values.cast::<PyString>() {
            return text.to_cow().map(|text| Self::Text(text.into_owned()));
        }
        match values.cast::<PyBytes>() {
            Ok(bytes) => Ok(Self::Floats(bytes.to_owned().into())),
            Err(_) => values.extract().map(Self::Texts),
        }
    }
}

fn float(bytes: &[u8], row: usize) -> f64 {
    let (words, _) = bytes.as_chunks::<WIDTH>();
    words.get(row).map_or(f64::NAN, |word| f64::from_le_bytes(*word))
}

/// Makes columns of `widths` bytes for each row, one behind the other; a column of width 0 has no cells. `work` fills the cells of the rows from a first one on.
///
/// Parts are worked on in parallel. Other threads of Python run meanwhile, and Ctrl-C ends the work.
pub fn fill<'py, const N: usize>(
    py: Python<'py>,
    length: usize,
    widths: [usize; N],
    work: impl Fn(usize, [&mut [u8]; N]) -> Result<(), Faults> + Sync,
) -> PyResult<Bound<'py, PyBytes>> {
    PyBytes::new_with(py, length * widths.iter().sum::<usize>(), |bytes| {
        let parts = parts(bytes, length, widths);
        let is_cancelled = AtomicBool::new(false);
        let part = |(index, cells)| match is_cancelled.load(Ordering::Relaxed) {
            false => work(index * PART, cells),
            true => Ok(()),
        };
        let all = || on_own_threads(|| parts.into_par_iter().enumerate().map(part).collect::<Vec<_>>());
        let found = if length <= PART { py.detach(all) } else { watched(py, &is_cancelled, all)? };
        // The first fault, whatever the order in which parts were done.
        found?.into_iter().collect::<Result<(), Faults>>().map_err(|faults| input_error(&faults))
    })
}

/// The cells of each part, of every column.
fn parts<const N: usize>(mut bytes: &mut [u8], length: usize, widths: [usize; N]) -> Vec<[&mut [u8]; N]> {
    let mut columns = widths.map(|width| {
        let (column, rest) = std::mem::take(&mut bytes).split_at_mut(width * length);
        bytes = rest;
        column.chunks_mut((width * PART).max(1))
    });
    (0..length.div_ceil(PART))
        .map(|_| columns.each_mut().map(|cells| cells.next().unwrap_or_default()))
        .collect()
}

/// Does work on a thread of its own and looks at signals meanwhile.
fn watched<T: Send>(
    py: Python<'_>,
    is_cancelled: &AtomicBool,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    std::thread::scope(|scope| {
        let waiting = std::thread::current();
        let worker = scope.spawn(move || {
            let done = work();
            waiting.unpark();
            done
        });
        while !worker.is_finished() {
            py.detach(|| std::thread::park_timeout(TICK));
            py.check_signals().inspect_err(|_| is_cancelled.store(true, Ordering::Relaxed))?;
        }
        worker.join().map_err(|panic| std::panic::resume_unwind(panic))
    })
}
