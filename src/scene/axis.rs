//! Logarithmic axes: their limits, and their coordinates, the same bits on every machine.

use rug::Float;

use crate::scene::Problem;
use slipmode_core::number::{Rational, nearest_f64};

/// What a scene may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The most points of one grid, line or sweep (`--max-points`).
    pub max_points: u64,
}

impl Limits {
    pub(crate) fn check(self, points: u64) -> Result<(), Problem> {
        let limit = self.max_points;
        if points <= limit {
            Ok(())
        } else {
            Err(Problem::TooManyPoints { points: points.to_string(), limit })
        }
    }
}

impl Default for Limits {
    /// 4 194 304 points, a square of 2048 × 2048.
    fn default() -> Self {
        Self { max_points: 1 << 22 }
    }
}

/// Points spread evenly in the logarithm between two positive ends.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct LogAxis {
    /// The first coordinate; positive.
    pub from: Rational,
    /// The last coordinate; greater than `from`.
    pub to: Rational,
    /// The number of coordinates, at least 2.
    pub points: u32,
}

/// Working precision of a coordinate: far more than the 53 bits kept, so that only an exact tie is undecided.
const WORKING_BITS: u32 = 192;

/// Where a result within a few units of the working precision's end is rounded_twice: a decimal such as 1e23 lies exactly
/// between two 64-bit numbers, and must meet the tie from either side.
const SETTLED_BITS: u32 = 160;

impl LogAxis {
    /// The coordinates, ascending: from·(to/from)^(i/(n−1)), rounded to the nearest f64.
    ///
    /// They are defined as these binary numbers: everything computed at a coordinate takes it as an exact rational.
    /// The ends are the f64 nearest to `from` and `to`.
    #[must_use]
    pub fn coordinates(&self) -> Vec<f64> {
        let coordinates = LogCoordinates::of(self);
        (0..self.points).map(|index| coordinates.at(index)).collect()
    }
}

/// The coordinates of a [`LogAxis`] one by one, for axes that are not to be held in memory.
#[derive(Debug, Clone)]
pub struct LogCoordinates {
    ends: [f64; 2],
    log10_ends: [Float; 2],
    intervals: u32,
}

impl LogCoordinates {
    /// Prepares the coordinates of an axis.
    #[must_use]
    pub fn of(axis: &LogAxis) -> Self {
        let ends = [&axis.from, &axis.to].map(|end| Float::with_val(WORKING_BITS, end));
        Self {
            ends: [&axis.from, &axis.to].map(nearest_f64),
            log10_ends: ends.map(Float::log10),
            intervals: axis.points.saturating_sub(1).max(1),
        }
    }

    /// The coordinate of this index, the same bits as in [`LogAxis::coordinates`].
    #[must_use]
    pub fn at(&self, index: u32) -> f64 {
        let ([from, to], [first, last]) = (self.ends, &self.log10_ends);
        match index {
            0 => from,
            index if index >= self.intervals => to,
            // One weighted mean, so that a whole power of ten comes out as a whole exponent.
            index => {
                let weighted = Float::with_val(WORKING_BITS, first * (self.intervals - index))
                    + Float::with_val(WORKING_BITS, last * index);
                Float::with_val(SETTLED_BITS, Float::exp10(weighted / self.intervals)).to_f64()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;

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
