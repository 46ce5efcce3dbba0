//! How many bits a cubic loses, in advance of any root: from the binary exponents of exact integers alone.

use rug::Integer;

use crate::roots::depressed::{Depressed, bits};

impl Depressed {
    /// Bits by which y must be known better than the smallest part that is wanted: log2 of max(|y|, |c2|)/(3c3·smallest).
    ///
    /// Counted in binary exponents, from bounds that are a few bits apart from the truth; all in advance of any root.
    pub(super) fn lost_bits(&self) -> u32 {
        let largest = (i64::from(self.scale_log2()) + 1).max(i64::from(bits(self.quadratic())));
        // 3c3 is at least 2^(bits of c3).
        let largest = largest - i64::from(bits(self.lead()));
        let smallest =
            self.smallest_modulus_log2().min(self.half_width_log2()).min(self.pair_real_part_log2());
        u32::try_from((largest - smallest).max(0)).unwrap_or(u32::MAX / 4)
    }

    /// A lower bound of log2 of the smallest non-zero |x|: 1/|x| ≤ 2·max |c_k/c_0|^(1/k) (Fujiwara).
    fn smallest_modulus_log2(&self) -> i64 {
        let first = self.cubic.iter().position(|c| !c.is_zero()).unwrap_or(0);
        let lowest = i64::from(bits(&self.cubic[first])) - 1;
        -1 - exponent_bound(self.cubic[first + 1..].iter(), lowest)
    }

    /// An upper bound of log2 of the largest |x|: |x| ≤ 2·max |c_(3−k)/c_3|^(1/k) (Fujiwara).
    fn largest_modulus_log2(&self) -> i64 {
        let lowest = i64::from(bits(self.lead())) - 1;
        1 + exponent_bound(self.cubic[..3].iter().rev(), lowest)
    }

    /// A lower bound of log2 of half the distance of the pair: √|D|/(6c3·f') with f' ≤ 3y² + |P| < 2^(2k+4).
    fn half_width_log2(&self) -> i64 {
        let root = (i64::from(bits(self.discriminant())) - 1).div_euclid(2);
        root - 2 * i64::from(self.scale_log2()) - 4 - i64::from(bits(self.lead())) - 3
    }

    /// A lower bound of log2 of a complex pair's |Re| when it is not zero: c1c2 − c0c3 = −2·Re·c3²·|x + pair|².
    fn pair_real_part_log2(&self) -> i64 {
        let hurwitz = self.hurwitz();
        if self.discriminant_sign() > 0 || hurwitz.is_zero() {
            return i64::MAX;
        }
        let largest = self.largest_modulus_log2() + 1;
        i64::from(bits(&hurwitz)) - 2 - 2 * i64::from(bits(self.lead())) - 2 * largest
    }
}

/// max over k ≥ 1 of ⌈(log2 |c_k| − lowest)/k⌉, the coefficients counted from k = 1, zeros left out.
fn exponent_bound<'c>(coefficients: impl Iterator<Item = &'c Integer>, lowest: i64) -> i64 {
    (1i64..)
        .zip(coefficients)
        .filter(|(_, coefficient)| !coefficient.is_zero())
        .map(|(k, coefficient)| -(lowest - i64::from(bits(coefficient))).div_euclid(k))
        .max()
        .unwrap_or(0)
}
