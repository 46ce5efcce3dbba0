//! Cubics with a multiple root: over the rationals every root is then rational, so all of them are exact.

use rug::Rational;

use super::depressed::Depressed;

/// The distinct roots, ascending, with their multiplicities, of a cubic whose discriminant is zero.
///
/// With y³ + Py + Q = 0 and 4P³ + 27Q² = 0 the simple root is y = 3Q/P and the double root y = −3Q/(2P).
pub(super) fn rational_roots(depressed: &Depressed) -> Vec<(Rational, u32)> {
    let map_back = |y: Rational| (y - depressed.quadratic()) / (depressed.lead().clone() * 3u32);
    if depressed.linear.is_zero() {
        return vec![(map_back(Rational::new()), 3)];
    }
    let simple = Rational::from((depressed.constant.clone() * 3u32, depressed.linear.clone()));
    let double = simple.clone() / -2;
    let mut roots = vec![(map_back(simple), 1), (map_back(double), 2)];
    roots.sort();
    roots
}
