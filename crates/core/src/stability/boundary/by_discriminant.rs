//! Crossings of the boundary as roots of the discriminant of eq 8, by the engine of the inverse questions.

use rug::Rational;

use crate::friction::Slider;
use crate::stability::boundary::Section;
use crate::stability::inverse::{Solution, Target, Undecided, solve};

/// Digits beyond those requested, so that a comparison does not see the radii.
const GUARD_DIGITS: u32 = 8;

/// All crossings of the section with their arcs, ascending in the coordinate that is sought.
///
/// # Errors
/// Those of [`solve`].
pub fn by_discriminant(
    slider: &Slider<Rational>,
    section: &Section,
    digits: u32,
) -> Result<Vec<Solution>, Undecided> {
    let (unknown, parameters) = section.unknown(slider);
    solve(&parameters, unknown, &Target::Boundary, digits.saturating_add(GUARD_DIGITS))
}
