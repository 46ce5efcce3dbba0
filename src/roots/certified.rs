//! All roots of a rational cubic, enclosed to any number of digits.
//!
//! Multiplicity is decided exactly first. Distinct roots then follow from one certified real root y of the depressed cubic:
//! the other two are −y/2 ± √D/(2f'(y)) with the exact discriminant D, so that a difference of close roots,
//! or a small imaginary part, keeps its full relative accuracy.

use rug::{Float, Integer};

use super::bracket::outermost_real_root;
use super::depressed::{Depressed, bits};
use super::multiple::rational_roots;
use crate::number::{Ball, Field, Rational, Real, bits_for_digits};

/// Guard bits: the few operations after the root is known lose less than half of them.
const GUARD_BITS: u32 = 16;

/// One root of a cubic: the true root lies within `radius` of re + i·im.
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
        Self { re: enclosure.centre().clone(), im, radius: enclosure.radius().clone(), multiplicity }
    }

    fn complex(re: &Ball, im: &Ball) -> Self {
        let radius =
            Ball::new(Float::new(2), re.radius().clone()) + Ball::new(Float::new(2), im.radius().clone());
        let radius = radius.radius().clone();
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
#[must_use]
pub fn certified_roots(cubic: &[Rational; 4], digits: u32) -> CertifiedRoots {
    let target_bits = bits_for_digits(digits);
    let Some(depressed) = Depressed::of(cubic) else {
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

fn multiple_roots(depressed: &Depressed, bits: u32) -> Vec<CertifiedRoot> {
    let rounded = |(root, multiplicity)| CertifiedRoot::real(&Ball::from_rational(&root, bits), multiplicity);
    rational_roots(depressed).into_iter().map(rounded).collect()
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
        let ball = |value: &Integer| Ball::from_integer(value, bits);
        let y = outermost_real_root(depressed, bits);
        let slope = y.square() * Ball::from(3) + ball(&depressed.linear);
        let divisor = ball(&(depressed.lead.clone() * 6u32));
        let half_width =
            Ball::from_integer(&depressed.discriminant.clone().abs(), bits).sqrt() / (slope * &divisor);
        let quadratic = ball(&depressed.quadratic);
        let twice = Ball::from(2);
        Self {
            single: (y.clone() - &quadratic) * &twice / &divisor,
            pair_centre: -(y + quadratic * twice) / &divisor,
            pair_half_width: half_width,
        }
    }
}

impl Depressed {
    /// Bits by which y must be known better than the smallest part that is wanted: log2 of max(|y|, |c2|)/(3c3·smallest).
    ///
    /// Counted in binary exponents, from bounds that are a few bits apart from the truth; all in advance of any root.
    fn lost_bits(&self) -> u32 {
        let largest = (i64::from(self.scale_log2()) + 1).max(i64::from(bits(&self.quadratic)));
        // 3c3 is at least 2^(bits of c3).
        let largest = largest - i64::from(bits(&self.lead));
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
        let lowest = i64::from(bits(&self.lead)) - 1;
        1 + exponent_bound(self.cubic[..3].iter().rev(), lowest)
    }

    /// A lower bound of log2 of half the distance of the pair: √|D|/(6c3·f') with f' ≤ 3y² + |P| < 2^(2k+4).
    fn half_width_log2(&self) -> i64 {
        let root = (i64::from(bits(&self.discriminant)) - 1).div_euclid(2);
        root - 2 * i64::from(self.scale_log2()) - 4 - i64::from(bits(&self.lead)) - 3
    }

    /// A lower bound of log2 of a complex pair's |Re| when it is not zero: c1c2 − c0c3 = −2·Re·c3²·|x + pair|².
    fn pair_real_part_log2(&self) -> i64 {
        let hurwitz = self.hurwitz();
        if self.discriminant_sign() > 0 || hurwitz.is_zero() {
            return i64::MAX;
        }
        let largest = self.largest_modulus_log2() + 1;
        i64::from(bits(&hurwitz)) - 2 - 2 * i64::from(bits(&self.lead)) - 2 * largest
    }
}

/// max over k ≥ 1 of ⌈(log2 |c_k| − lowest)/k⌉, the coefficients counted from k = 1, zeros left out.
fn exponent_bound<'c>(coefficients: impl Iterator<Item = &'c Integer>, lowest: i64) -> i64 {
    (1i64..)
        .zip(coefficients)
        .filter(|(_, coefficient)| !coefficient.is_zero())
        .map(|(k, coefficient)| {
            let difference = i64::from(bits(coefficient)) - lowest;
            difference.div_euclid(k) + i64::from(difference.rem_euclid(k) != 0)
        })
        .max()
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use proptest::prelude::*;

    fn decimals(texts: [&str; 4]) -> [Rational; 4] {
        texts.map(|text| parse_decimal(text).unwrap())
    }

    /// Every part that is not exactly zero must have its relative accuracy, and enclosures must be apart.
    fn assert_contract(found: &CertifiedRoots, digits: u32) {
        assert_eq!(found.roots.iter().map(|root| root.multiplicity).sum::<u32>(), 3);
        let wanted = -f64::from(digits) * std::f64::consts::LOG2_10;
        for root in &found.roots {
            for part in [root.re_ball(), root.im_ball()] {
                assert!(part.relative_radius_log2() <= wanted, "{root:?}");
            }
        }
        for (index, root) in found.roots.iter().enumerate() {
            for other in &found.roots[..index] {
                let apart = (root.re.clone() - &other.re).abs() > root.radius.clone() + &other.radius
                    || (root.im.clone() - &other.im).abs() > root.radius.clone() + &other.radius;
                assert!(apart, "{root:?} meets {other:?}");
            }
        }
    }

    /// The second way: the cubic rebuilt from the root balls must contain the cubic it came from.
    fn assert_rebuilds(found: &CertifiedRoots, cubic: &[Rational; 4]) {
        let complex = found.discriminant_sign < 0;
        let real: Vec<Ball> = found
            .roots
            .iter()
            .filter(|root| root.im.is_zero())
            .flat_map(|root| std::iter::repeat_n(root.re_ball(), root.multiplicity as usize))
            .collect();
        let (sum, product) = if complex {
            let (re, im) = (found.roots[2].re_ball(), found.roots[2].im_ball());
            (re.clone() * Ball::from(2), re.square() + im.square())
        } else {
            (real[1].clone() + &real[2], real[1].clone() * &real[2])
        };
        let monic = |k: usize| Rational::from(&cubic[k] / &cubic[3]);
        assert!((-(real[0].clone() + &sum)).contains(&monic(2)));
        assert!((real[0].clone() * &sum + &product).contains(&monic(1)));
        assert!((-(real[0].clone() * &product)).contains(&monic(0)));
    }

    fn check(cubic: &[Rational; 4], digits: u32) -> CertifiedRoots {
        let found = certified_roots(cubic, digits);
        assert_contract(&found, digits);
        assert_rebuilds(&found, cubic);
        found
    }

    #[test]
    fn the_cusp_at_equal_effects_is_a_triple_root_at_minus_three() {
        // η = 1/8, κ = 27/8, β = 1.
        let found = check(&decimals(["3.375", "3.375", "1.125", "0.125"]), 1000);
        assert_eq!(found.roots.len(), 1);
        assert_eq!((found.roots[0].multiplicity, found.roots[0].radius.is_zero()), (3, true));
        assert_eq!(found.roots[0].re, -3);
    }

    #[test]
    fn a_double_root_has_multiplicity_two_and_a_neighbour_1e_1000_away_has_not() {
        // (x + 1)²(x + 2) = x³ + 4x² + 5x + 2.
        let double = check(&decimals(["2", "5", "4", "1"]), 50);
        assert_eq!(double.roots.iter().map(|r| r.multiplicity).collect::<Vec<_>>(), [1, 2]);
        for (shift, roots) in [("1e-1000", 3), ("-1e-1000", 3)] {
            let mut cubic = decimals(["2", "5", "4", "1"]);
            cubic[0] += parse_decimal(shift).unwrap();
            assert_eq!(check(&cubic, 50).roots.len(), roots);
        }
    }

    #[test]
    fn a_pair_on_the_imaginary_axis_has_real_part_exactly_zero() {
        // (x² + 3)(2x + 5) and a neighbour 1e-60 off it.
        let mut cubic = decimals(["15", "6", "5", "2"]);
        assert!(check(&cubic, 100).roots[2].re.is_zero());
        cubic[0] += parse_decimal("1e-60").unwrap();
        let near = check(&cubic, 100);
        assert!(!near.roots[2].re.is_zero() && near.roots[2].re.to_f64().abs() < 1e-60);
    }

    #[test]
    fn roots_thousands_of_orders_of_magnitude_apart_keep_their_digits() {
        check(&decimals(["1e-3000", "1", "1e2500", "1e-9000"]), 60);
        check(&decimals(["1e3000", "-1", "1e-2500", "1e1000"]), 60);
    }

    #[test]
    fn ten_thousand_digits_are_certified() {
        let found = check(&decimals(["0.7", "0.31", "1.013", "0.013"]), 10_000);
        assert!(found.precision_bits > 33_219 && found.precision_bits < 33_400);
    }

    #[test]
    fn zero_roots_and_lower_degrees_are_guarded() {
        let found = check(&decimals(["0", "2", "3", "1"]), 30);
        assert!(found.roots[2].re.is_zero() && found.roots[2].radius.is_zero());
        assert!(certified_roots(&decimals(["1", "2", "1", "0"]), 30).roots.is_empty());
    }

    fn coefficient() -> impl Strategy<Value = Rational> {
        (1i64..1_000_000_000, -40i32..40, prop::bool::ANY).prop_map(|(digits, exponent, negative)| {
            let value = parse_decimal(&format!("{digits}e{exponent}")).unwrap();
            if negative { -value } else { value }
        })
    }

    proptest! {
        #[test]
        fn any_cubic_is_enclosed_and_rebuilt(
            cubic in prop::array::uniform4(coefficient()), digits in 1u32..120,
        ) {
            check(&cubic, digits);
        }

        #[test]
        fn rational_roots_are_found_also_when_close(
            root in -1000i64..1000, gap in 0i64..3, power in 0u32..80, other in -1000i64..1000,
        ) {
            let distance = Rational::from(gap) >> power;
            let (a, b, c) = (Rational::from(root), Rational::from(root) + distance, Rational::from((other, 7)));
            let cubic = [
                -(a.clone() * &b * &c),
                a.clone() * &b + b.clone() * &c + c.clone() * &a,
                -(a.clone() + &b + &c),
                Rational::from(1),
            ];
            let found = check(&cubic, 40);
            for exact in [a, b, c] {
                prop_assert!(found.roots.iter().any(|r| r.re_ball().contains(&exact)), "{} missed", exact);
            }
        }
    }
}
