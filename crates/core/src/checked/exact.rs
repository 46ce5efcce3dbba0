//! Exact numbers, made from texts, whole numbers and 64-bit numbers.

use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::number::format::exact_text;
use crate::number::{DecimalError, Rational, nearest_f64, parse_quotient};

/// An exact number.
///
/// A text is a decimal or a quotient of two, and means what it says: `"0.1"` is 1/10. A 64-bit number is its exact binary value, so
/// that `0.1_f64` is not 1/10.
///
/// ```
/// use slipmode_core::Exact;
///
/// let tenth: Exact = "0.1".parse()?;
/// assert_eq!(tenth, "1/10".parse()?);
/// assert_ne!(tenth, Exact::try_from(0.1)?);
/// assert_eq!(tenth.to_string(), "0.1");
/// assert!(Exact::try_from(f64::NAN).is_err());
/// # Ok::<(), slipmode_core::NumberError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "String", into = "String"))]
pub struct Exact(pub(super) Rational);

/// Why something is no exact number.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NumberError {
    /// A text that is no decimal and no quotient of two, or one that divides by zero.
    #[error("{0}")]
    Text(#[from] DecimalError),
    /// A 64-bit number that is infinite or none at all.
    #[error("{0} is not a finite number")]
    NotFinite(String),
}

impl Exact {
    /// The nearest 64-bit number.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        nearest_f64(&self.0)
    }
}

impl FromStr for Exact {
    type Err = NumberError;

    fn from_str(text: &str) -> Result<Self, NumberError> {
        Ok(Self(parse_quotient(text)?))
    }
}

impl TryFrom<&str> for Exact {
    type Error = NumberError;

    fn try_from(text: &str) -> Result<Self, NumberError> {
        text.parse()
    }
}

impl TryFrom<String> for Exact {
    type Error = NumberError;

    fn try_from(text: String) -> Result<Self, NumberError> {
        text.parse()
    }
}

impl TryFrom<f64> for Exact {
    type Error = NumberError;

    fn try_from(value: f64) -> Result<Self, NumberError> {
        Rational::from_f64(value).map(Self).ok_or_else(|| NumberError::NotFinite(value.to_string()))
    }
}

/// Whole numbers are exact.
macro_rules! from_whole {
    ($($whole:ty)*) => {
        $(impl From<$whole> for Exact {
            fn from(value: $whole) -> Self {
                Self(value.into())
            }
        })*
    };
}

from_whole!(i32 i64 u32 u64);

impl From<Infallible> for NumberError {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

impl From<Exact> for String {
    fn from(value: Exact) -> Self {
        value.to_string()
    }
}

/// The decimal where one of at most 40 digits is exact, else a quotient.
impl fmt::Display for Exact {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&exact_text(&self.0))
    }
}
