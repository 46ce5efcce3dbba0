//! Both signs of a point in one byte, and the count of precision levels behind many of them.

use std::ops::AddAssign;

use crate::roots::PrecisionLevel;
use crate::stability::SpectralClass;

/// The signs of K − K_c and of the discriminant of one point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct SignPair(pub(super) u8);

impl SignPair {
    /// The mark of a point that the 64-bit filter leaves open; never seen outside this module.
    pub(super) const UNDECIDED: Self = Self(u8::MAX);

    /// The pair of these signs, each −1, 0 or 1.
    #[must_use]
    pub const fn new(transition_sign: i8, boundary_sign: i8) -> Self {
        Self(((transition_sign + 1) + 3 * (boundary_sign + 1)) as u8)
    }

    /// The pair of two certain non-zero signs, without branches.
    #[inline(always)]
    pub(super) const fn from_decided(stable: bool, real: bool) -> Self {
        Self(2 * stable as u8 + 6 * real as u8)
    }

    /// The sign of K − K_c: +1 linearly stable.
    #[must_use]
    pub const fn transition_sign(self) -> i8 {
        (self.0 % 3) as i8 - 1
    }

    /// The sign of the discriminant: +1 all roots real, −1 a complex pair, 0 on the boundary.
    #[must_use]
    pub const fn boundary_sign(self) -> i8 {
        (self.0 / 3) as i8 - 1
    }

    /// The class that the two signs give.
    #[must_use]
    pub const fn spectral_class(self) -> SpectralClass {
        SpectralClass::from_signs(self.transition_sign(), self.boundary_sign())
    }
}

/// How many points each precision level decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PrecisionCounts {
    /// By the 64-bit filter.
    pub f64: u64,
    /// By double-double.
    pub double_double: u64,
    /// By rationals.
    pub exact: u64,
}

impl PrecisionCounts {
    pub(super) fn count(&mut self, precision_level: PrecisionLevel) {
        match precision_level {
            PrecisionLevel::F64 => self.f64 += 1,
            PrecisionLevel::DoubleDouble => self.double_double += 1,
            PrecisionLevel::Exact => self.exact += 1,
        }
    }
}

impl AddAssign for PrecisionCounts {
    fn add_assign(&mut self, other: Self) {
        self.f64 += other.f64;
        self.double_double += other.double_double;
        self.exact += other.exact;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_signs_survive_the_byte() {
        for transition in -1..=1 {
            for boundary in -1..=1 {
                let pair = SignPair::new(transition, boundary);
                assert_eq!((pair.transition_sign(), pair.boundary_sign()), (transition, boundary));
                assert_ne!(pair, SignPair::UNDECIDED);
            }
        }
        assert_eq!(SignPair::from_decided(true, false), SignPair::new(1, -1));
        assert_eq!(SignPair::from_decided(false, true), SignPair::new(-1, 1));
    }
}
