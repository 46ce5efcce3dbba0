//! A number with the precision of f64 and a range without practical end.

use std::fmt;

use rug::Float;

use super::format;

/// mantissa·2^exponent with 1 ≤ |mantissa| < 2, or zero: 53 significant bits, never infinite and never not a number.
///
/// Inputs may have exponents of ten up to ±10 000, so that a rate can lie far outside f64's range;
/// saturating there would be a silent lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wide {
    mantissa: f64,
    exponent: i32,
}

impl Wide {
    /// Zero, exactly.
    pub const ZERO: Self = Self { mantissa: 0.0, exponent: 0 };

    /// The nearest value to a finite float; zero for one that is not finite.
    #[must_use]
    pub fn from_float(value: &Float) -> Self {
        Self::scaled(Float::with_val(53, value).to_f64_exp())
    }

    /// From 1/2 ≤ |mantissa| < 1.
    fn scaled((mantissa, exponent): (f64, i32)) -> Self {
        if mantissa == 0.0 || !mantissa.is_finite() {
            return Self::ZERO;
        }
        Self { mantissa: mantissa * 2.0, exponent: exponent - 1 }
    }

    /// The f64 itself; `None` for an infinity or what is not a number.
    #[must_use]
    pub fn from_f64(value: f64) -> Option<Self> {
        value.is_finite().then(|| Self::scaled(libm::frexp(value)))
    }

    /// The value as f64 when f64 holds it to full precision; `None` when it would overflow, or lose bits as a subnormal.
    #[must_use]
    pub fn to_f64(self) -> Option<f64> {
        if self.mantissa == 0.0 {
            return Some(0.0);
        }
        // The power of two is a normal number, and its product with 1 ≤ |mantissa| < 2 is exact.
        let power = |exponent: i32| f64::from_bits(((1023 + exponent) as u64) << 52);
        (-1022..=1023).contains(&self.exponent).then(|| self.mantissa * power(self.exponent))
    }

    /// The exact value as a 53-bit float.
    #[must_use]
    pub fn to_float(self) -> Float {
        Float::with_val(53, self.mantissa) << self.exponent
    }

    /// Hands on its text piece by piece.
    pub fn pieces(self, mut put: impl FnMut(&str)) {
        match self.to_f64() {
            Some(value) => format::shortest_pieces(value, put),
            None => put(&format::round_float(&self.to_float(), 17)),
        }
    }

    /// Whether the value is exactly zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.mantissa == 0.0
    }
}

impl fmt::Display for Wide {
    /// The shortest decimal that reads back as the same 53 bits; 17 digits beyond f64's range.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut written = Ok(());
        self.pieces(|piece| written = written.and_then(|()| formatter.write_str(piece)));
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_finite_f64_survives_the_round_trip() {
        for value in [0.0, 1.0, -1.5, 1e-300, f64::MAX, f64::MIN_POSITIVE, -2.5e-7] {
            assert_eq!(Wide::from_f64(value).unwrap().to_f64(), Some(value));
        }
        assert!(Wide::from_f64(f64::NAN).is_none());
    }

    #[test]
    fn a_value_beyond_f64_keeps_its_digits_and_says_so() {
        let huge = Wide::from_float(&(Float::with_val(60, 3) << 40_000));
        assert_eq!(huge.to_f64(), None);
        assert_eq!(huge.to_float(), Float::with_val(53, 3) << 40_000);
        assert!(huge.to_string().ends_with("e12041"), "{huge}");
    }
}
