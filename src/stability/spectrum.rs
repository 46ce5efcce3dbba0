//! The classification of a point: exact signs, their names, and the growth rate and frequency.

use rug::Float;

use super::{InertialThreshold, SlipMode, SpectralClass, boundary_sign, slip_mode, transition_sign};
use crate::friction::Parameters;
use crate::number::{Rational, Wide};
use crate::roots::{CertifiedRoots, Rung, certified_roots};

/// Digits of the enclosures behind the values: three more than the 1e-14 that is promised, and some.
const VALUE_DIGITS: u32 = 19;

/// What is known of a point: signs and names exactly, values to 1e-14.
#[derive(Debug, Clone, PartialEq)]
pub struct Classification {
    /// Sign of K − K_c: +1 linearly stable, 0 on the transition.
    pub transition_sign: i8,
    /// Sign of the discriminant: +1 all roots real, −1 a complex pair, 0 on the boundary.
    pub boundary_sign: i8,
    /// The class those two signs give.
    pub spectral_class: SpectralClass,
    /// The slip mode.
    pub slip_mode: SlipMode,
    /// Largest Re(s), 1/s, with an error of at most 1e-14 of that root's modulus; exactly 0 on the transition.
    pub max_real_per_s: Wide,
    /// Largest Im(s), 1/s, with a relative error of at most 1e-14; exactly 0 when no root is complex.
    pub max_imaginary_per_s: Wide,
    /// The highest rung that signs or values needed.
    pub rung: Rung,
}

/// Classifies a point. Signs and names are right for the decimals as written, of any length.
#[must_use]
pub fn classify(parameters: &Parameters<Rational>, threshold: &InertialThreshold) -> Classification {
    let groups = parameters.groups();
    let (transition, boundary) = (transition_sign(&groups), boundary_sign(&groups));
    let spectral_class = SpectralClass::from_signs(transition, boundary);
    let roots = certified_roots(&groups.characteristic_cubic(), VALUE_DIGITS);
    let rate_per_s = parameters.rate_per_s();
    let [max_real_per_s, max_imaginary_per_s] =
        largest_parts(&roots).map(|part| Wide::from_float(&Float::with_val(80, part * &rate_per_s)));
    Classification {
        transition_sign: transition,
        boundary_sign: boundary,
        spectral_class,
        slip_mode: slip_mode(&groups, spectral_class, threshold),
        max_real_per_s,
        max_imaginary_per_s,
        rung: Rung::Exact,
    }
}

/// The largest real and the largest imaginary part.
fn largest_parts(roots: &CertifiedRoots) -> [Float; 2] {
    let largest = |parts: &mut dyn Iterator<Item = &Float>| {
        parts.max_by(|x, y| x.total_cmp(y)).map_or_else(|| Float::new(53), |part| Float::with_val(80, part))
    };
    [
        largest(&mut roots.roots.iter().map(|root| &root.re)),
        largest(&mut roots.roots.iter().map(|root| &root.im)),
    ]
}
