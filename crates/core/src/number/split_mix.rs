//! Uniform random numbers from a fixed seed, by the SplitMix64 sequence of Steele, Lea and Flood.

/// A generator; its state is the seed.
#[derive(Debug, Clone)]
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    /// The next 64 bits.
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Uniform in [0, 1).
    #[must_use]
    pub fn unit(&mut self) -> f64 {
        // The upper 53 bits are a number of f64 without rounding.
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [low, high).
    #[must_use]
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sequence_is_that_of_splitmix64() {
        assert_eq!(SplitMix64(0).bits(), 0xe220_a839_7b1d_cdaf);
        let first = SplitMix64(0).unit();
        assert!((first - 0.883_310_808_213_642_2).abs() < 1e-15, "{first}");
        assert_eq!(SplitMix64(0).between(2.0, 4.0), 2.0 + 2.0 * first);
    }
}
