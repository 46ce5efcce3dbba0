//! Whether a box meets the area in which all roots are real and below −1.
//!
//! With the order "M, K, V, D_c up; σ, a, b down" a box meets the area exactly when a path along its edges does, which goes from
//! its least to its greatest corner and changes D_c, b, K, σ, a, M, V in this order. A box lies in the area exactly when
//! its least and its greatest corner do, so the path meets it in one piece.
//!
//! A point is in the area when G(w) = M V0² w/σ + K/(σw) − a − b/(D_c w − 1) has G(w₁) ≥ 0 ≥ G(w₂) for some 1/D_c < w₁ < w₂ (or a
//! triple root). G rises along the order. The ratio ∂G(w₁)/∂G(w₂) does not grow from one parameter of the path to the next:
//! for D_c/b, b/K and K/σ because w₁ < w₂, for σ because G(w₁) ≥ 0 ≥ G(w₂), and it is 1 for a and w₁/w₂ for M and V0. So
//! exchanging a later parameter for an earlier one at constant G(w₂) never lowers G(w₁), until the point is on the path.

use rug::Complete;

use super::Met;
use super::parameter_box::{A, B, Corner, D, Filtered, K, M, Point, S, V};
use super::polynomials::Units;
use super::tensor::Tensor;
use crate::number::Rational;
use crate::polynomial::{SturmSequence, UnivariatePolynomial};

/// The corner that is least in the order.
pub(super) const LEAST: Corner = Corner::high(&[A, B, S]);

/// The order in which the path changes the parameters.
const ORDER: [usize; 7] = [D, B, K, S, A, M, V];

/// Whether the box meets the lower area.
pub(super) fn meets(filtered: &Filtered<'_>) -> Met {
    let mut corner = LEAST;
    let corners: Vec<Corner> = std::iter::once(LEAST)
        .chain(ORDER.iter().filter(|parameter| filtered.region.is_wide(**parameter)).map(|parameter| {
            corner = corner.flipped(*parameter);
            corner
        }))
        .collect();
    if let Some(inside) = corners.iter().find(|corner| filtered.at_corner(**corner).is_lower()) {
        return Met::at(filtered.region.corner(*inside));
    }
    let edges = corners.windows(2).filter(|ends| !clearly_misses(filtered, [ends[0], ends[1]]));
    let mut edges = edges.map(|ends| [ends[0], ends[1]].map(|corner| filtered.region.corner(corner)));
    let mut units = None;
    edges
        .find_map(|ends| Edge::new(units.get_or_insert_with(|| Units::of(filtered.region)), &ends)?.search())
        .unwrap_or(Met::Nowhere)
}

/// Whether an edge clearly misses η < 1/2 or κ + η > 1 + β: each is largest at one of the edge's ends.
fn clearly_misses(filtered: &Filtered<'_>, ends: [Corner; 2]) -> bool {
    const MARGIN: f64 = 1e-9;
    let sides = ends.map(|corner| {
        let [a, b, d, k, m, s, v] = filtered.rounded(corner).map(|value| value.hi());
        let (inertia, direct) = (m * v * v, a * s * d);
        let excess = inertia + k * d * d - direct - b * s * d;
        let size = inertia + k * d * d + direct + b * s * d;
        // A value that is not a normal number misses nothing.
        let normal =
            [inertia, direct, k * d * d, b * s * d].iter().all(|value| *value > 1e-250 && *value < 1e250);
        let misses = |value: f64, size: f64| normal && value < -MARGIN * size;
        [misses(direct - 2.0 * inertia, direct + inertia), misses(excess, size)]
    });
    (0..2).any(|side| sides.iter().all(|misses| misses[side]))
}

/// An edge of the box, from 0 to 1, with no end in the area.
struct Edge<'a> {
    ends: &'a [Point; 2],
    discriminant: UnivariatePolynomial,
    sides: [UnivariatePolynomial; 2],
    sturm: SturmSequence,
}

impl<'a> Edge<'a> {
    /// The polynomials along an edge; none if the signs of Bernstein's coefficients show that it misses the area.
    fn new(units: &Units, ends: &'a [Point; 2]) -> Option<Self> {
        let parameter = (0..7).find(|i| ends[0][*i] != ends[1][*i])?;
        let lines = units.lines(&ends[0], &ends[1], &[(parameter, 0)]);
        let (discriminant, sides) = (lines.discriminant(), lines.lower_area());
        let misses = |tensor: &Tensor, strict: bool| {
            tensor.clone().into_bernstein().all(|value| if strict { *value < 0 } else { *value <= 0 })
        };
        if misses(&discriminant, true) || sides.iter().any(|side| misses(side, false)) {
            return None;
        }
        let discriminant = discriminant.univariate();
        let sturm = SturmSequence::new(&discriminant);
        Some(Self { ends, discriminant, sides: sides.map(|side| side.univariate()), sturm })
    }

    fn search(&self) -> Option<Met> {
        self.between(&Rational::new(), &Rational::from(1))
    }

    fn is_inside(&self, at: &Rational) -> bool {
        self.discriminant.evaluate(at) >= 0 && self.sides.iter().all(|side| side.evaluate(at) > 0)
    }

    /// Searches a part of the edge whose ends are outside. The area's piece would end at roots of the discriminant.
    fn between(&self, low: &Rational, high: &Rational) -> Option<Met> {
        let is_root = |at: &Rational| self.discriminant.evaluate(at) == 0;
        let within = self.sturm.count_roots(low, high) - usize::from(is_root(high));
        match within {
            0 => return None,
            1 => return self.touched_between(low, high),
            _ => {}
        }
        let middle = (low + high).complete() / 2u32;
        if self.is_inside(&middle) {
            return Some(Met::at(self.point(&middle)));
        }
        self.between(low, &middle).or_else(|| self.between(&middle, high))
    }

    /// With one root between, the piece is that point alone: a multiple root of the discriminant, negative on both sides.
    ///
    /// At such a root both sides are positive or one is negative, so that halving decides.
    fn touched_between(&self, low: &Rational, high: &Rational) -> Option<Met> {
        let repeated = self.discriminant.gcd(&self.discriminant.derivative());
        let (mut low, mut high) = (low.clone(), high.clone());
        let counts = SturmSequence::new(&repeated);
        if repeated.degree().unwrap_or(0) == 0 || counts.count_roots(&low, &high) == 0 {
            return None;
        }
        loop {
            let signs = self.sides.each_ref().map(|side| {
                let constant = side.count_roots(&low, &high) == 0 && side.evaluate(&low) != 0;
                constant.then(|| side.evaluate(&low) > 0)
            });
            match signs {
                [Some(false), _] | [_, Some(false)] => return None,
                [Some(true), Some(true)] => match only_rational(&repeated, &low, &high) {
                    Some(None) => return Some(Met::WithoutWitness),
                    Some(Some(root)) => return Some(Met::at(self.point(&root))),
                    None => {}
                },
                _ => {}
            }
            let middle = (&low + &high).complete() / 2u32;
            if self.discriminant.evaluate(&middle) == 0 {
                return self.is_inside(&middle).then(|| Met::at(self.point(&middle)));
            }
            if self.sturm.count_roots(&low, &middle) == 1 { high = middle } else { low = middle }
        }
    }

    fn point(&self, at: &Rational) -> Point {
        let [start, end] = self.ends;
        std::array::from_fn(|i| (&end[i] - &start[i]).complete() * at + &start[i])
    }
}

/// The rational root between two numbers that have one root between them, if it is rational.
///
/// Times the leading integer coefficient it would be an integer. None while there is room for two integers.
fn only_rational(
    polynomial: &UnivariatePolynomial,
    low: &Rational,
    high: &Rational,
) -> Option<Option<Rational>> {
    let leading = polynomial.primitive().coefficients().last()?.clone().abs();
    let width = (high - low).complete() * &leading;
    let candidate = (high * &leading).complete().floor() / leading;
    (width < 1).then(|| (polynomial.evaluate(&candidate) == 0).then_some(candidate))
}
