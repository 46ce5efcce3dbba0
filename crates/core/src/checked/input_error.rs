//! What is wrong with a value of one of the seven inputs.

use std::fmt;

use thiserror::Error;

use super::exact::{Exact, NumberError};
use crate::friction::{LEAST, MOST, Quantity};
use crate::number::{Rational, nearest_f64, parse_decimal};

/// What is wrong with the value of one input.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{quantity}: {problem}")]
#[non_exhaustive]
pub struct InputError {
    /// The input.
    pub quantity: Quantity,
    /// What is wrong.
    pub problem: QuantityError,
}

/// All that is wrong with the values of a slider or an operating point: one at least.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputErrors(pub(super) Vec<InputError>);

impl InputErrors {
    /// Each of them, in the order of the inputs.
    pub fn iter(&self) -> std::slice::Iter<'_, InputError> {
        self.0.iter()
    }
}

impl<'e> IntoIterator for &'e InputErrors {
    type Item = &'e InputError;
    type IntoIter = std::slice::Iter<'e, InputError>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// One after the other, between semicolons.
impl fmt::Display for InputErrors {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let each: Vec<String> = self.iter().map(ToString::to_string).collect();
        formatter.pad(&each.join("; "))
    }
}

impl std::error::Error for InputErrors {}

/// Why a value is none of an input.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// It is no number.
    #[error(transparent)]
    Number(#[from] NumberError),
    /// It is zero or negative.
    #[error("{0} is not positive")]
    NotPositive(Exact),
    /// It is beyond what the exact arithmetic is meant for.
    #[error("out of range (allowed: {LEAST} to {MOST})")]
    OutOfRange,
}

impl Quantity {
    /// The value, if it is one of this input.
    pub(super) fn checked(
        self,
        value: impl TryInto<Exact, Error: Into<NumberError>>,
    ) -> Result<Rational, InputError> {
        let refused = |problem| InputError { quantity: self, problem };
        let exact = value.try_into().map_err(|error| refused(QuantityError::Number(error.into())))?;
        if exact.0 <= 0 {
            return Err(refused(QuantityError::NotPositive(exact)));
        }
        let [least, most] = [LEAST, MOST].map(|end| parse_decimal(end).unwrap_or_default());
        // The 64-bit number 1e300 is above the decimal.
        let is_inside = least <= exact.0 && (exact.0 <= most || exact.0 == nearest_f64(&most));
        if is_inside { Ok(exact.0) } else { Err(refused(QuantityError::OutOfRange)) }
    }
}
