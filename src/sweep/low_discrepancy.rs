//! Points of low discrepancy by number: Halton's sequence, shifted by a key.
//!
//! A point is a function of its number and the key alone, so that any block of them can be made anywhere, in any order.

use sha2::{Digest, Sha256};

/// One base for each of the seven quantities: the first primes.
const BASES: [u64; 7] = [2, 3, 5, 7, 11, 13, 17];

/// A sequence of points in the unit cube of up to seven dimensions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LowDiscrepancy {
    /// The shift of each dimension, in units of 2⁻⁶⁴; shifts wrap around at 1.
    shifts: [u64; 7],
}

impl LowDiscrepancy {
    /// The sequence of a key: the digest of the scene.
    #[must_use]
    pub fn new(key: &[u8]) -> Self {
        let shift = |dimension: u8| {
            let digest = Sha256::new().chain_update(key).chain_update([dimension]).finalize();
            digest.iter().take(8).fold(0, |word, byte| word << 8 | u64::from(*byte))
        };
        Self { shifts: [0, 1, 2, 3, 4, 5, 6].map(shift) }
    }

    /// The coordinate of a point in one dimension (0 to 6), in [0, 1), to 53 bits.
    #[must_use]
    pub fn coordinate(&self, number: u64, dimension: usize) -> f64 {
        let dimension = dimension % BASES.len();
        let fraction = radical_inverse(number, BASES[dimension]).wrapping_add(self.shifts[dimension]);
        (fraction >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }
}

/// The digits of a number in a base, mirrored at the point: in units of 2⁻⁶⁴, rounded down.
///
/// Numbers below 2⁵⁸ keep mirrored digits and power within 64 bits for every base up to 17; sweeps have fewer points.
fn radical_inverse(mut number: u64, base: u64) -> u64 {
    let (mut mirrored, mut power) = (0u128, 1u128);
    while number > 0 {
        mirrored = mirrored * u128::from(base) + u128::from(number % base);
        power *= u128::from(base);
        number /= base;
    }
    u64::try_from((mirrored << 64) / power).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_radical_inverse_is_haltons() {
        let halves = [0.0, 0.5, 0.25, 0.75, 0.125].map(|part: f64| (part * 2f64.powi(64)) as u64);
        assert_eq!([0, 1, 2, 3, 4].map(|number| radical_inverse(number, 2)), halves);
        // 5 = 12 in base 3, mirrored 0.21 = 7/9.
        assert_eq!(radical_inverse(5, 3), ((7u128 << 64) / 9) as u64);
        // 17^14 is a one behind fourteen zeros, and close to the largest number for which 64 bits suffice.
        assert_eq!(u128::from(radical_inverse(17u64.pow(14), 17)), (1u128 << 64) / 17u128.pow(15));
    }

    #[test]
    fn every_interval_of_a_base_gets_its_share() {
        // b^k consecutive points from 0 on hit each of the b^k intervals once; a shift moves them all alike.
        let sequence = LowDiscrepancy { shifts: [0; 7] };
        for (dimension, count) in [(0, 1024), (1, 729), (6, 289)] {
            let mut hits = vec![0; count];
            for number in 0..count as u64 {
                // The middle of the interval, where rounding cannot reach its ends.
                let place = sequence.coordinate(number, dimension) * count as f64 + 0.5;
                hits[place as usize % count] += 1;
            }
            assert!(hits.iter().all(|hits| *hits == 1), "dimension {dimension}");
        }
    }

    #[test]
    fn another_key_shifts_the_points_and_the_same_key_does_not() {
        let (one, other) = (LowDiscrepancy::new(b"one"), LowDiscrepancy::new(b"other"));
        assert_eq!(one, LowDiscrepancy::new(b"one"));
        for dimension in 0..7 {
            let shift = |number| {
                let apart = one.coordinate(number, dimension) - other.coordinate(number, dimension);
                (apart + 1.0) % 1.0
            };
            assert!(shift(0) != 0.0 && (shift(0) - shift(12_345)).abs() < 1e-15);
            assert!((0..1000).all(|number| (0.0..1.0).contains(&one.coordinate(number, dimension))));
        }
    }
}
