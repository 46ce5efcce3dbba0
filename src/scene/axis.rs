//! Logarithmic axes: their limits, and their coordinates, the same bits on every machine.

use rug::float::Round;
use rug::{Assign, Float};

use crate::number::Rational;

/// What a scene may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The most points of one grid, line or sweep (`--max-points`).
    pub max_points: u64,
}

impl Default for Limits {
    /// 4 194 304 points, a square of 2048 × 2048.
    fn default() -> Self {
        Self { max_points: 1 << 22 }
    }
}

/// Points spread evenly in the logarithm between two positive ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogAxis {
    /// The first coordinate; positive.
    pub from: Rational,
    /// The last coordinate; greater than `from`.
    pub to: Rational,
    /// The number of coordinates, at least 2.
    pub points: u32,
}

/// Working precision of a coordinate: far more than the 53 bits kept, so that only an exact tie can be in doubt.
const WORKING_BITS: u32 = 192;

/// Where a result within a few units of the working precision's end is settled: a decimal such as 1e23 lies exactly
/// between two 64-bit numbers, and must meet the tie from either side.
const SETTLED_BITS: u32 = 160;

impl LogAxis {
    /// The coordinates, ascending: from·(to/from)^(i/(n−1)), rounded to the nearest f64.
    ///
    /// They are defined as these binary numbers: everything computed at a coordinate takes it as an exact rational.
    /// The ends are the f64 nearest to `from` and `to`.
    #[must_use]
    pub fn coordinates(&self) -> Vec<f64> {
        let first = Float::with_val(WORKING_BITS, &self.from).log10();
        let last = Float::with_val(WORKING_BITS, &self.to).log10();
        let intervals = self.points.saturating_sub(1).max(1);
        (0..self.points)
            .map(|index| match index {
                0 => nearest_f64(Float::with_val(WORKING_BITS, &self.from)),
                index if index == intervals => nearest_f64(Float::with_val(WORKING_BITS, &self.to)),
                index => interior(&first, &last, index, intervals),
            })
            .collect()
    }
}

fn interior(first: &Float, last: &Float, index: u32, intervals: u32) -> f64 {
    // One weighted mean, so that a whole power of ten comes out as a whole exponent.
    let weighted = Float::with_val(WORKING_BITS, first * (intervals - index))
        + Float::with_val(WORKING_BITS, last * index);
    let exponent: Float = weighted / intervals;
    nearest_f64(exponent.exp10())
}

fn nearest_f64(value: Float) -> f64 {
    let mut settled = Float::new(SETTLED_BITS);
    settled.assign(&value);
    settled.to_f64_round(Round::Nearest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;

    fn axis(from: &str, to: &str, points: u32) -> Vec<f64> {
        LogAxis { from: parse_decimal(from).unwrap(), to: parse_decimal(to).unwrap(), points }.coordinates()
    }

    #[test]
    fn powers_of_ten_are_met_exactly() {
        assert_eq!(axis("1e-3", "1e3", 7), [1e-3, 1e-2, 1e-1, 1.0, 10.0, 100.0, 1000.0]);
        assert_eq!(axis("1e22", "1e24", 3)[1], 1e23);
        assert_eq!(axis("1e-300", "1e300", 601)[100], 1e-200);
    }

    #[test]
    fn coordinates_ascend_between_their_ends() {
        let coordinates = axis("0.3", "7", 1000);
        assert_eq!((coordinates[0], coordinates[999]), (0.3, 7.0));
        assert!(coordinates.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
