//! The roots to some hundred digits, in numbers of a few limbs.
//!
//! The formulas are those of [`super::Enclosures`]. Each number that is no sum or product is the zero of a function, found by
//! [`refined`]. Nothing is known in advance of the accuracy: what the error bounds do not grant is left to the other road.

use rug::{Float, Integer};

use super::limbs::{Limbs, power_of_two};
use super::{CertifiedRoot, CertifiedRoots};
use crate::number::{Dd, Field, Real};
use crate::roots::bracket::outermost_root_f64;

/// The roots if N limbs are enough: each root's radius at most 2^−bits times each of its parts and the pair's half width.
///
/// P, Q and the discriminant Δ come from the cubic's Hessian Ax² + Bx + C: P = −3A, Q = 2c2A − 3c3B and 3Δ = 4AC − B².
pub(super) fn roots<const N: usize>(cubic: [&Integer; 4], bits: u32) -> Option<CertifiedRoots> {
    let [c0, c1, c2, c3] = cubic.map(Limbs::<N>::of_integer);
    let a = c2.times(c2).minus(c1.times(c3).times_whole(3));
    let b = c1.times(c2).minus(c0.times(c3).times_whole(9));
    let c = c1.times(c1).minus(c0.times(c2).times_whole(3));
    let discriminant = a.times(c).scaled(2).minus(b.times(b));
    if !discriminant.has_sign() {
        return None;
    }
    let linear = a.times_whole(3).negated();
    let y = outermost_root(linear, a.times(c2).scaled(1).minus(b.times(c3).times_whole(3)));
    let slope = y.times(y).times_whole(3).plus(linear);
    let divisor = c3.times_whole(3);
    // Of 6c3·f'(y), so that one division serves all three parts.
    let inverse = inverse(slope.times(divisor).scaled(1));
    // √(729c3²Δ)/(6c3·f'(y)), where Δ is a third of what is at hand.
    let half_width = square_root(discriminant.abs().times_whole(27)).times(inverse).times(divisor).abs();
    let inverse = slope.times(inverse);
    let single = y.minus(c2).scaled(1).times(inverse);
    let centre = y.plus(c2.scaled(1)).times(inverse).negated();
    let root = |re: Limbs<N>, im: Limbs<N>| {
        let smallest = re.exponent.min(half_width.exponent);
        let radius = re.error(smallest) + im.error(smallest);
        // A part is at least 2^(smallest − 1).
        let is_known = re.has_sign() && radius <= power_of_two(-2 - i64::from(bits));
        let radius = Float::with_val(53, radius) << i32::try_from(smallest).ok()?;
        is_known.then_some(CertifiedRoot { re: re.to_float()?, im: im.to_float()?, radius, multiplicity: 1 })
    };
    let zero = Limbs::of_dd(Dd::from(0));
    let mut roots = vec![root(single, zero)?];
    if discriminant.is_negative {
        roots.extend([root(centre, half_width.negated())?, root(centre, half_width)?]);
    } else {
        roots.extend([root(centre.minus(half_width), zero)?, root(centre.plus(half_width), zero)?]);
        roots.sort_by(|x, y| x.re.total_cmp(&y.re));
    }
    let discriminant_sign = if discriminant.is_negative { -1 } else { 1 };
    Some(CertifiedRoots { roots, discriminant_sign, precision_bits: Limbs::<N>::BITS as u32 })
}

/// The root of y³ + Py + Q farthest from zero.
fn outermost_root<const N: usize>(linear: Limbs<N>, constant: Limbs<N>) -> Limbs<N> {
    let half = |exponent: i64| exponent.div_euclid(2) + exponent.rem_euclid(2);
    let scale = half(linear.exponent).max((constant.exponent + 2).div_euclid(3));
    let (linear, constant) = (linear.scaled(-2 * scale), constant.scaled(-3 * scale));
    let [p, q] = [linear, constant].map(Limbs::to_dd);
    let slope = |y: Dd| y.square() * Dd::from(3) + p;
    let start = Dd::from(outermost_root_f64(p.hi(), q.hi()));
    let start = start - ((start.square() + p) * start + q) / slope(start);
    // At the outermost root f'(y) ≥ 2y²; so f'' = 6y moves f' little next to it.
    let is_outermost = slope(start).hi() >= start.hi() * start.hi();
    let start = if is_outermost { start } else { Dd::from(f64::NAN) };
    let value = |y: Limbs<N>| y.times(y).plus(linear).times(y).plus(constant);
    refined(start, slope(start), value).scaled(scale)
}

/// 1/a.
fn inverse<const N: usize>(value: Limbs<N>) -> Limbs<N> {
    let scaled = value.scaled(-value.exponent);
    let slope = scaled.to_dd();
    let one = Limbs::of_dd(Dd::from(1));
    refined(Dd::from(1) / slope, slope, |z| scaled.times(z).minus(one)).scaled(-value.exponent)
}

/// √a.
fn square_root<const N: usize>(value: Limbs<N>) -> Limbs<N> {
    let half = value.exponent.div_euclid(2);
    let scaled = value.scaled(-2 * half);
    let start = scaled.to_dd().sqrt();
    refined(start, start.scale(2.0), |z| z.times(z).minus(scaled)).scaled(half)
}

/// How far a start may be off, relative.
const START_ERROR: f64 = 1.0 / (1u128 << 86) as f64;

/// How far g' may be from the slope, relative, for every number within four times [`START_ERROR`] of the start.
///
/// The slope itself is right to some ten units of double-double. With |z·g''| ≤ 6|g'|, as for all functions here, g' changes by 2^-81.
const SLOPE_ERROR: f64 = 1.0 / (1u128 << 80) as f64;

/// The zero z of g next to a start, by z − g(z)/s with one slope s for all steps.
///
/// Let g(z) be v + δ with the computed v. A zero ζ has g(z) = g'(ξ)(z − ζ), so that z − v/s misses it by
/// (v/g'(ξ))·(1 − g'(ξ)/s) + δ/g'(ξ). The error left is at most [`SLOPE_ERROR`] of a step, next to δ/s; the factor 2 covers 1/g'
/// against 1/s, and the rounding of both. Such a zero exists, since g' keeps its sign within `reach` = 2|g|/s of z.
/// Each step gains some 98 bits, those of a double-double.
fn refined<const N: usize>(start: Dd, slope: Dd, g: impl Fn(Limbs<N>) -> Limbs<N>) -> Limbs<N> {
    let inverse = Dd::from(1) / slope;
    let (mut z, mut is_near) = (Limbs::of_dd(start), true);
    for _ in 0..(Limbs::<N>::BITS + 20) / 98 {
        let value = g(z.exact());
        let step = value.to_dd() * inverse;
        let reach = 2.0 * (step.hi().abs() + inverse.hi().abs() * value.error(0));
        let next = z.exact().minus(Limbs::of_dd(step));
        is_near &= reach <= START_ERROR * start.hi().abs();
        let error = 2.0 * (SLOPE_ERROR * step.hi().abs() + inverse.hi().abs() * value.error(0));
        z = next.widened(if is_near { error } else { f64::INFINITY });
    }
    z
}
