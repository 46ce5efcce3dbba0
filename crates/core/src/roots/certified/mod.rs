//! All roots of a rational cubic, enclosed to any number of digits.
//!
//! Multiplicity is decided exactly first. Distinct roots then follow from one certified real root y of the depressed cubic:
//! the other two are −y/2 ± √D/(2f'(y)) with the exact discriminant D, so that a difference of close roots,
//! or a small imaginary part, keeps its full relative accuracy.

mod limbs;
mod precision;
mod short;
#[cfg(test)]
mod tests;

use rug::{Float, Integer};

use super::bracket::outermost_real_root;
use super::depressed::{Depressed, integer_coefficients};
use crate::number::{Ball, Field, Rational, Real, bits_for_digits};

/// Guard bits: the few operations after the root is known lose less than half of them.
const GUARD_BITS: u32 = 16;

/// One root of a cubic: the true root lies within `radius` of re + i·im.
///
/// ```
/// use slipmode_core::{number::Rational, roots::certified_roots};
///
/// // x³ − 2: the real root encloses the cube root of 2.
/// let roots = certified_roots(&[-2, 0, 0, 1].map(Rational::from), 40).roots;
/// let cube = roots[0].re_ball() * &roots[0].re_ball() * &roots[0].re_ball();
/// assert!(cube.contains(&Rational::from(2)) && roots[0].radius < 1e-40);
/// ```
#[derive(Debug, Clone)]
pub struct CertifiedRoot {
    /// Real part; exactly zero when the true one is.
    pub re: Float,
    /// Imaginary part; exactly zero for a real root.
    pub im: Float,
    /// Upper bound of the distance to the true root; zero when the root is exact.
    pub radius: Float,
    /// How often the root counts: 1, 2 or 3.
    pub multiplicity: u32,
}

/// The roots of a cubic with what was decided exactly about them.
///
/// ```
/// use slipmode_core::{number::Rational, roots::certified_roots};
///
/// // (x + 1)³: one root of multiplicity three, exactly.
/// let found = certified_roots(&[1, 3, 3, 1].map(Rational::from), 20);
/// assert_eq!((found.roots.len(), found.roots[0].multiplicity), (1, 3));
/// assert!(found.roots[0].radius.is_zero());
/// ```
#[derive(Debug, Clone)]
pub struct CertifiedRoots {
    /// Real roots first, ascending; then the conjugate pair, negative imaginary part first. Enclosures are disjoint.
    pub roots: Vec<CertifiedRoot>,
    /// Sign of the discriminant: +1 three distinct real roots, −1 a complex pair, 0 a multiple root.
    pub discriminant_sign: i8,
    /// The precision the roots were computed with.
    pub precision_bits: u32,
}

impl CertifiedRoot {
    /// The enclosure of the real part, exact when the real part is exactly zero.
    #[must_use]
    pub fn re_ball(&self) -> Ball {
        component_ball(&self.re, &self.radius)
    }

    /// The enclosure of the imaginary part, exact for a real root.
    #[must_use]
    pub fn im_ball(&self) -> Ball {
        component_ball(&self.im, &self.radius)
    }

    fn real(enclosure: &Ball, multiplicity: u32) -> Self {
        let im = Float::new(enclosure.precision_bits());
        Self { re: enclosure.centre().clone(), im, radius: enclosure.radius(), multiplicity }
    }

    fn complex(re: &Ball, im: &Ball) -> Self {
        let radius = Ball::new(Float::new(2), re.radius()) + Ball::new(Float::new(2), im.radius());
        let radius = radius.radius();
        Self { re: re.centre().clone(), im: im.centre().clone(), radius, multiplicity: 1 }
    }
}

fn component_ball(part: &Float, radius: &Float) -> Ball {
    if part.is_zero() { Ball::exact(part.clone()) } else { Ball::new(part.clone(), radius.clone()) }
}

/// The roots of c0 + c1·x + c2·x² + c3·x³ to this many certain digits.
///
/// Every real part and every imaginary part that is not exactly zero has a relative error of at most 10^-digits,
/// also next to a double root, next to the imaginary axis and for roots many orders of magnitude apart.
/// A polynomial of degree below three (c3 = 0) is not a cubic and gives no roots.
///
/// ```
/// use slipmode_core::{friction::Parameters, roots::certified_roots, number::parse_decimal};
///
/// let number = |text| parse_decimal(text).unwrap();
/// let parameters = Parameters::from(["0.004", "0.006", "1e-5", "1e7", "1000", "1e6", "0.1"].map(number));
/// // The exponents s in 1/s of a small disturbance of steady sliding, to 30 certain digits.
/// let found = certified_roots(&parameters.characteristic_cubic_per_s(), 30);
/// assert_eq!(found.discriminant_sign, -1);
/// assert!(found.roots[0].im.is_zero() && found.roots[1].im < 0 && found.roots[2].im > 0);
/// ```
#[must_use]
pub fn certified_roots(cubic: &[Rational; 4], digits: u32) -> CertifiedRoots {
    let target_bits = bits_for_digits(digits);
    let integers = integer_coefficients(cubic);
    if let Some(found) = in_limbs(integers.each_ref(), target_bits) {
        return found;
    }
    let Some(depressed) = Depressed::of_integers(integers) else {
        return CertifiedRoots { roots: Vec::new(), discriminant_sign: 0, precision_bits: target_bits };
    };
    let discriminant_sign = depressed.discriminant_sign();
    let precision_bits = match discriminant_sign {
        0 => target_bits,
        _ => target_bits + depressed.lost_bits() + GUARD_BITS,
    };
    let roots = match discriminant_sign {
        0 => multiple_roots(&depressed, precision_bits),
        1 => real_roots(&depressed, precision_bits),
        _ => real_root_and_pair(&depressed, precision_bits),
    };
    CertifiedRoots { roots, discriminant_sign, precision_bits }
}

/// The roots in the fewest limbs that have 64 bits of room, for up to some hundred digits; none where their bounds are too large.
fn in_limbs(cubic: [&Integer; 4], target_bits: u32) -> Option<CertifiedRoots> {
    match target_bits {
        ..=128 => short::roots::<3>(cubic, target_bits),
        129..=192 => short::roots::<4>(cubic, target_bits),
        193..=384 => short::roots::<7>(cubic, target_bits),
        _ => None,
    }
}

/// The distinct roots, ascending, of a cubic whose discriminant is zero. Over the rationals every root is then rational.
///
/// With y³ + Py + Q = 0 and 4P³ + 27Q² = 0 the simple root is y = 3Q/P and the double root y = −3Q/(2P).
fn multiple_roots(depressed: &Depressed, bits: u32) -> Vec<CertifiedRoot> {
    let root = |(y, multiplicity): (Rational, u32)| {
        let root = (y - depressed.quadratic()) / (depressed.lead().clone() * 3u32);
        CertifiedRoot::real(&Ball::from_rational(&root, bits), multiplicity)
    };
    if depressed.linear.is_zero() {
        return vec![root((Rational::new(), 3))];
    }
    let simple = Rational::from((depressed.constant.clone() * 3u32, depressed.linear.clone()));
    let double = simple.clone() / -2;
    let mut roots = [(simple, 1), (double, 2)];
    roots.sort();
    roots.map(root).into()
}

fn real_roots(depressed: &Depressed, bits: u32) -> Vec<CertifiedRoot> {
    let enclosures = Enclosures::of(depressed, bits);
    let mut roots = [
        enclosures.single,
        enclosures.pair_centre.clone() - &enclosures.pair_half_width,
        enclosures.pair_centre + &enclosures.pair_half_width,
    ];
    if depressed.cubic[0].is_zero() {
        // Zero is a root; no enclosure of positive radius says so.
        for root in roots.iter_mut().filter(|root| root.contains_zero()) {
            *root = Ball::exact(Float::new(bits));
        }
    }
    roots.sort_by(|x, y| x.centre().total_cmp(y.centre()));
    roots.iter().map(|root| CertifiedRoot::real(root, 1)).collect()
}

fn real_root_and_pair(depressed: &Depressed, bits: u32) -> Vec<CertifiedRoot> {
    let Enclosures { mut single, mut pair_centre, pair_half_width } = Enclosures::of(depressed, bits);
    if depressed.cubic[0].is_zero() {
        single = Ball::exact(Float::new(bits));
    }
    if depressed.hurwitz().is_zero() && depressed.cubic[1].cmp0() == depressed.cubic[3].cmp0() {
        // c1c2 = c0c3 and c1/c3 > 0: the cubic is (x² + c1/c3)(c3x + c2), and the pair purely imaginary.
        pair_centre = Ball::exact(Float::new(bits));
    }
    vec![
        CertifiedRoot::real(&single, 1),
        CertifiedRoot::complex(&pair_centre, &-pair_half_width.clone()),
        CertifiedRoot::complex(&pair_centre, &pair_half_width),
    ]
}

/// A real root and the other two as centre ± half width (half width real or imaginary by the discriminant's sign).
struct Enclosures {
    single: Ball,
    pair_centre: Ball,
    pair_half_width: Ball,
}

impl Enclosures {
    /// x = (y − c2)/(3c3) for the certified y, and for −y/2 ± √|D|/(2f'(y)).
    fn of(depressed: &Depressed, bits: u32) -> Self {
        let ball = |value: &Integer| Ball::from_short_integer(value, bits);
        let y = outermost_real_root(depressed, bits);
        let slope = y.square() * Ball::from(3) + ball(&depressed.linear);
        let divisor = ball(&(depressed.lead().clone() * 6u32));
        let half_width =
            Ball::from_integer(&depressed.discriminant().clone().abs(), bits).sqrt() / (slope * &divisor);
        let quadratic = ball(depressed.quadratic());
        let twice = Ball::from(2);
        Self {
            single: (y.clone() - &quadratic) * &twice / &divisor,
            pair_centre: -(y + quadratic * twice) / &divisor,
            pair_half_width: half_width,
        }
    }
}
