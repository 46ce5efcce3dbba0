//! Signs and slip mode of a point in one byte.

use super::SignPair;
use crate::stability::{SlipMode, SpectralClass};

/// Both signs and the slip mode of one point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct GridCell(u8);

/// How many values [`SignPair`] has.
const SIGN_PAIRS: u8 = 9;

impl GridCell {
    /// How many different cells there can be; [`code`](Self::code) lies below.
    pub(super) const COUNT: usize = SIGN_PAIRS as usize * SlipMode::ALL.len();

    /// The mark of a point that the 64-bit filter leaves open; never seen outside this module.
    pub(super) const UNDECIDED: Self = Self(u8::MAX);

    /// The cell of these signs and this mode.
    #[must_use]
    pub const fn new(signs: SignPair, slip_mode: SlipMode) -> Self {
        Self(signs.0 + SIGN_PAIRS * slip_mode as u8)
    }

    /// The cell of two certain non-zero signs and the answers to the two questions behind the modes, without branches.
    #[inline(always)]
    pub(super) const fn from_decided(stable: bool, real: bool, inertial: bool, upper_area: bool) -> Self {
        const fn either(answer: bool, yes: SlipMode, no: SlipMode) -> u8 {
            if answer { yes as u8 } else { no as u8 }
        }
        let when_real = if stable {
            either(upper_area, SlipMode::OverdampedOscillation, SlipMode::OverdampedStableSliding)
        } else {
            SlipMode::StickSlip as u8
        };
        let when_complex = if stable {
            either(
                inertial,
                SlipMode::InertialUnderdampedOscillation,
                SlipMode::NonInertialUnderdampedOscillation,
            )
        } else {
            either(inertial, SlipMode::HarmonicVibration, SlipMode::StickSlip)
        };
        let mode = if real { when_real } else { when_complex };
        Self(SignPair::from_decided(stable, real).0 + SIGN_PAIRS * mode)
    }

    /// A number below [`COUNT`](Self::COUNT) that stands for the cell.
    #[inline(always)]
    pub(super) const fn code(self) -> usize {
        self.0 as usize
    }

    /// Every cell, by code.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        (0..Self::COUNT as u8).map(Self)
    }

    /// Both signs.
    #[must_use]
    pub const fn signs(self) -> SignPair {
        SignPair(self.0 % SIGN_PAIRS)
    }

    /// The class that the two signs give.
    pub(crate) const fn spectral_class(self) -> SpectralClass {
        self.signs().spectral_class()
    }

    /// The slip mode.
    #[must_use]
    pub const fn slip_mode(self) -> SlipMode {
        SlipMode::ALL[(self.0 / SIGN_PAIRS) as usize % SlipMode::ALL.len()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::slip_mode::slip_mode_by;

    #[test]
    fn signs_and_mode_survive_the_byte() {
        for (index, mode) in SlipMode::ALL.into_iter().enumerate() {
            assert_eq!(mode as usize, index);
            for (transition, boundary) in [(-1, -1), (0, -1), (1, 0), (1, 1)] {
                let signs = SignPair::new(transition, boundary);
                let cell = GridCell::new(signs, mode);
                assert_eq!((cell.signs(), cell.slip_mode()), (signs, mode));
                assert!(cell.code() < GridCell::COUNT && cell != GridCell::UNDECIDED);
            }
        }
        assert_eq!(GridCell::all().count(), GridCell::COUNT);
    }

    #[test]
    fn the_branchless_table_of_modes_is_the_other_one() {
        for bits in 0..16 {
            let [stable, real, inertial, upper] = [1, 2, 4, 8].map(|bit| bits & bit != 0);
            let cell = GridCell::from_decided(stable, real, inertial, upper);
            let mode = slip_mode_by(cell.spectral_class(), || Some(upper), || Some(inertial));
            assert_eq!(Some(cell.slip_mode()), mode);
            assert_eq!(cell.signs(), SignPair::from_decided(stable, real));
        }
    }
}
