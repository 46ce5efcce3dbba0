//! Three roots of a cubic: the precision that was worked with against the digits that came out right.
//!
//! The reference of every root is a certified one to twenty digits more than the most that are requested.

use rayon::prelude::*;
use rug::Float;
use rug::ops::CompleteRound;

use super::Sizes;
use super::sets::{Set, sets};
use crate::methods::{TEXTBOOK, wide};
use crate::textbook::Three;
use slipmode_core::number::{Dd, Rational, Real, nearest_f64};
use slipmode_core::roots::{BoundedCubic, CertifiedRoots, Pair, Working, certified_roots};

/// One method on one set of cubics.
#[derive(Debug, Clone, PartialEq)]
pub struct RootCount {
    /// `random` or `hard`.
    pub set: &'static str,
    /// The method.
    pub method: &'static str,
    /// Digits requested, where the method has such.
    pub digits: Option<u32>,
    /// Cubics solved.
    pub cubics: usize,
    /// Cubics without an answer: left open by the bounds, or not finite.
    pub open: usize,
    /// Bits of the arithmetic, the most over the set.
    pub bits: u32,
    /// −log10 of the worst error of a root relative to its modulus; none when every cubic is open.
    pub digits_right: Option<f64>,
}

/// Digits of the references beyond the most requested.
const MORE_DIGITS: u32 = 20;

/// Cubics of a set that are solved to so many digits: their number falls where each takes long.
fn share(count: usize, digits: u32) -> usize {
    let most = if digits > 5_000 {
        6
    } else if digits > 500 {
        40
    } else {
        count
    };
    count.min(most)
}

/// Both sets by every method.
pub(crate) fn count(sizes: &Sizes) -> Vec<RootCount> {
    sets(sizes.cubics).iter().flat_map(|set| of_set(set, sizes.digits)).collect()
}

fn of_set(set: &Set, digits: &[u32]) -> Vec<RootCount> {
    let references: Vec<CertifiedRoots> =
        set.cubics.par_iter().map(|cubic| certified_roots(cubic, 40 + MORE_DIGITS)).collect();
    let row = |method, digits, bits, answers: &[Option<f64>]| RootCount {
        set: set.name,
        method,
        digits,
        cubics: answers.len(),
        open: answers.iter().filter(|answer| answer.is_none()).count(),
        bits,
        digits_right: answers.iter().flatten().copied().reduce(f64::min),
    };
    let by = |solve: &(dyn Fn(&[Rational; 4]) -> Option<[Part; 3]> + Sync)| -> Vec<Option<f64>> {
        let both = set.cubics.par_iter().zip(&references);
        both.map(|(cubic, reference)| Some(right(&solve(cubic)?, reference))).collect()
    };
    let mut rows: Vec<RootCount> = TEXTBOOK
        .into_iter()
        .map(|(name, solve)| {
            row(name, None, 53, &by(&|cubic| of_three(solve(cubic.each_ref().map(nearest_f64)))))
        })
        .collect();
    rows.push(row("64-bit with bounds", None, 53, &by(&|cubic| bounded(cubic, nearest_f64))));
    rows.push(row("double-double with bounds", None, 106, &by(&|cubic| bounded(cubic, Dd::from_rational))));
    rows.extend(digits.iter().map(|&digits| {
        let cubics = &set.cubics[..share(set.cubics.len(), digits)];
        let found: Vec<(u32, f64)> = cubics.par_iter().map(|cubic| certified(cubic, digits)).collect();
        let answers: Vec<Option<f64>> = found.iter().map(|(_, right)| Some(*right)).collect();
        let bits = found.iter().map(|(bits, _)| *bits).max().unwrap_or(0);
        row("certified", Some(digits), bits, &answers)
    }));
    rows
}

/// Real and imaginary part.
type Part = [Float; 2];

fn of_three(roots: Three) -> Option<[Part; 3]> {
    let finite = roots.iter().all(|root| root.re.is_finite() && root.im.is_finite());
    finite.then(|| roots.map(|root| [Float::with_val(53, root.re), Float::with_val(53, root.im)]))
}

/// A precision level with error bounds, whose coefficients are rounded once; none where it leaves the pair open.
fn bounded<R: Working + Real>(cubic: &[Rational; 4], round: impl Fn(&Rational) -> R) -> Option<[Part; 3]> {
    let coefficients = cubic.each_ref().map(round);
    let magnitudes = coefficients.each_ref().map(|value| value.leading().abs());
    let found = BoundedCubic { coefficients, magnitudes, relative_error: R::UNIT }.spectrum();
    let real = |value: R| [wide(value), Float::new(53)];
    match found.pair {
        Pair::NotSeparated => None,
        Pair::Real([low, high]) => Some([real(found.real.value), real(low.value), real(high.value)]),
        Pair::Complex { re, im } => {
            let (re, im) = (wide(re.value), wide(im.value));
            Some([real(found.real.value), [re.clone(), -im.clone()], [re, im]])
        }
    }
}

/// The precision worked with, and the digits right against a reference to more of them.
fn certified(cubic: &[Rational; 4], digits: u32) -> (u32, f64) {
    let found = certified_roots(cubic, digits);
    let reference = certified_roots(cubic, digits + MORE_DIGITS);
    let parts = found.roots.iter().map(|root| [root.re.clone(), root.im.clone()]);
    let worst = parts.map(|part| digits_of(&part, &reference)).fold(f64::INFINITY, f64::min);
    (found.precision_bits, worst)
}

fn right(found: &[Part; 3], reference: &CertifiedRoots) -> f64 {
    found.iter().map(|part| digits_of(part, reference)).fold(f64::INFINITY, f64::min)
}

/// −log10 of the distance to the nearest true root over its modulus; that of no digit is 0.
fn digits_of(part: &Part, reference: &CertifiedRoots) -> f64 {
    let [re, im] = part;
    let error = |root: &slipmode_core::roots::CertifiedRoot| {
        let precision = root.re.prec().max(64);
        let apart = |one: &Float, other: &Float| (one - other).complete(precision);
        // not f64: MPFR's.
        let distance = apart(re, &root.re).hypot(&apart(im, &root.im));
        // not f64: MPFR's.
        let modulus = root.re.clone().hypot(&root.im);
        // not f64: MPFR's.
        if distance.is_zero() { f64::INFINITY } else { (modulus.log10() - distance.log10()).to_f64() }
    };
    let most = reference.roots.iter().map(error).fold(f64::NEG_INFINITY, f64::max);
    // A reference rounded to p bits says nothing beyond them.
    most.clamp(0.0, f64::from(reference.precision_bits) * std::f64::consts::LOG10_2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn certified_roots_have_every_digit_and_hard_cubics_cost_precision_or_digits() {
        let rows = count(&Sizes { cubics: 28, digits: &[16, 50], ..Sizes::REPORTED });
        for row in rows.iter().filter(|row| row.method == "certified") {
            assert!(row.open == 0 && row.digits_right.unwrap() >= f64::from(row.digits.unwrap()), "{row:?}");
        }
        let of = |set, method| rows.iter().find(|row| row.set == set && row.method == method).unwrap();
        assert!(
            of("random", "companion eigenvalues").digits_right
                > of("hard", "companion eigenvalues").digits_right
        );
        assert!(of("hard", "64-bit with bounds").open > 0);
        assert!(
            of("hard", "double-double with bounds").digits_right
                < of("random", "double-double with bounds").digits_right
        );
    }
}
