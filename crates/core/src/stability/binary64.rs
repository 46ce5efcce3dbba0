//! The classification of a point given in 64-bit numbers: hard points stay in integers of fixed length, without rationals.
//!
//! Eq 8 times aσD_c, with p for s·D_c/V0, has the coefficients K D_c², K D_c² + (a − b)σD_c, aσD_c + M V0² and M V0²: sums of
//! products of three 64-bit numbers, which are integers of at most 159 bits times powers of two.

use super::certain_signs;
use super::quick::{classify_quickly, clearly_in_upper_area};
use super::slip_mode::slip_mode_by;
use super::spectrum::{LargestParts, clearly_inertial};
use super::{Classification, InertialThreshold, SpectralClass, classify};
use crate::friction::Parameters;
use crate::number::{Dd, Rational, ShortInteger, odd_part};
use crate::roots::{PrecisionLevel, ShortCubic};

/// Coefficients longer than this are left to rationals.
const MOST_BITS: u32 = 250;

/// The classification of a point whose inputs are exactly these 64-bit numbers, with all that [`classify`] promises.
///
/// `None` when one of them is not positive and finite.
#[must_use]
pub fn classify_binary64(
    parameters: &Parameters<f64>,
    threshold: &InertialThreshold,
) -> Option<Classification> {
    let mut usable = true;
    let in_double_double = parameters.map(|value| {
        usable &= *value > 0.0 && value.is_finite();
        Dd::from(*value)
    });
    if !usable {
        return None;
    }
    let (certain, ..) = certain_signs::filter(parameters);
    let quickly = || certain.then(|| classify_quickly(&in_double_double, threshold)).flatten();
    let exactly =
        || classify(&parameters.map(|value| Rational::from_f64(*value).unwrap_or_default()), threshold);
    Some(quickly().or_else(|| classify_shortly(parameters, threshold)).unwrap_or_else(exactly))
}

/// The classification by short integers; `None` when they are too long, or a value or a name needs more than they give.
fn classify_shortly(parameters: &Parameters<f64>, threshold: &InertialThreshold) -> Option<Classification> {
    // The names are taken from 64-bit groups, which must not have over- or underflown on the way.
    let groups = certain_signs::groups_in_f64(parameters)?;
    let cubic = short_cubic(parameters)?;
    let (transition_sign, boundary_sign) = (cubic.hurwitz_sign(), cubic.discriminant_sign());
    let spectral_class = SpectralClass::from_signs(transition_sign, boundary_sign);
    let parts = LargestParts::of_bounded(&cubic.spectrum()?, transition_sign)?;
    let in_si = parts.times_rate(parameters.map(|value| Dd::from(*value)).rate_per_s())?;
    // The upper area is that of a > b; equal effects are decided here, where the inputs are exact.
    let has_no_upper_area = parameters.slider.evolution_effect >= parameters.slider.direct_effect;
    let slip_mode = slip_mode_by(
        spectral_class,
        || if has_no_upper_area { Some(false) } else { clearly_in_upper_area(&groups) },
        || {
            let natural_squared = groups.natural_angular_frequency_squared();
            clearly_inertial(parts.imaginary.hi(), natural_squared, threshold)
        },
    )?;
    Some(Classification {
        transition_sign,
        boundary_sign,
        spectral_class,
        slip_mode,
        max_real_per_s: in_si.real,
        max_imaginary_per_s: in_si.imaginary,
        precision_level: PrecisionLevel::Exact,
        value_precision_level: PrecisionLevel::DoubleDouble,
    })
}

/// Eq 8 in integers; `None` when they would be too long.
pub(super) fn short_cubic(parameters: &Parameters<f64>) -> Option<ShortCubic> {
    let Parameters { slider: p, point } = parameters.map(|value| odd_part(*value));
    let (length, stress, velocity) =
        (p.critical_slip_distance_m, point.normal_stress_pa, point.loading_velocity_m_per_s);
    let factors = [
        [p.stiffness_pa_per_m, length, length],
        [p.mass_per_area_kg_per_m2, velocity, velocity],
        [p.direct_effect, stress, length],
        [p.evolution_effect, stress, length],
    ];
    let exponents = factors.map(|[one, two, three]| one.1 + two.1 + three.1);
    let unit = exponents.into_iter().min()?;
    let product = |index: usize| {
        let shift = (exponents[index] - unit) as u32;
        let product = ShortInteger::of_factors(factors[index].map(|factor| factor.0));
        (product.bits().saturating_add(shift) <= MOST_BITS).then(|| product.shifted(shift))
    };
    let (spring, inertia) = (product(0)?, product(1)?);
    let (direct, evolution) = (product(2)?, product(3)?);
    let linear = spring.plus(&direct).minus(&evolution);
    ShortCubic::of([&spring, &linear, &direct.plus(&inertia), &inertia])
}

#[cfg(test)]
mod tests;
