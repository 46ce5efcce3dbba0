//! Whether a box meets the area in which all roots are real and below −1.
//!
//! With the order "M, K, V, D_c up; σ, a, b down" a box meets the area exactly when a path along its edges does, which goes from
//! its least to its greatest corner and changes D_c, b, K, σ, a, M, V in this order. A box lies in the area exactly when
//! its least and its greatest corner do (the proof `lower-area-between-two-corners` of the report on Im and Avouac), so the path meets it in one piece.
//!
//! A point is in the area when G(w) = M V0² w/σ + K/(σw) − a − b/(D_c w − 1) has G(w₁) ≥ 0 ≥ G(w₂) for some 1/D_c < w₁ < w₂ (or a
//! triple root). G rises along the order. The ratio ∂G(w₁)/∂G(w₂) does not grow from one parameter of the path to the next:
//! for D_c/b, b/K and K/σ because w₁ < w₂, for σ because G(w₁) ≥ 0 ≥ G(w₂), and it is 1 for a and w₁/w₂ for M and V0. So
//! exchanging a later parameter for an earlier one at constant G(w₂) never lowers G(w₁), until the point is on the path.

use rug::{Complete, Integer};

use super::Met;
use super::coefficient::{Coefficient, Rough};
use super::corners::{A, B, Corner, D, Filtered, K, M, Point, S, V};
use super::polynomials::Lines;
use super::tensor::Tensor;
use crate::number::Rational;
use slipmode_algebra::{SturmSequence, UnivariatePolynomial};

/// The corner that is least in the order.
pub(super) const LEAST: Corner = Corner::high(&[A, B, S]);

/// The order in which the path changes the parameters.
const ORDER: [usize; 7] = [D, B, K, S, A, M, V];

/// Whether the box meets the lower area.
pub(super) fn meets<'a>(filtered: &'a Filtered<'_>) -> Met<'a> {
    let mut corner = LEAST;
    let corners: Vec<Corner> = std::iter::once(LEAST)
        .chain(ORDER.iter().filter(|parameter| filtered.region.is_wide(**parameter)).map(|parameter| {
            corner = corner.flipped(*parameter);
            corner
        }))
        .collect();
    if let Some(inside) = corners.iter().find(|corner| filtered.at_corner(**corner).is_lower()) {
        return Met::at_corner(filtered, *inside);
    }
    if is_clearly_nowhere(filtered) {
        return Met::NOWHERE;
    }
    let edges = corners.windows(2).map(|ends| [ends[0], ends[1]]);
    let found = edges.filter_map(|ends| Edge::new(filtered, ends)).find_map(|edge| edge.search());
    found.map_or(Met::NOWHERE, |point| Met::found_by(|| point))
}

/// Whether one of the two sides of [`Lines::lower_area`] is not positive anywhere in the box, by the ends of its terms. Far from
/// the area this saves the edges.
fn is_clearly_nowhere(filtered: &Filtered<'_>) -> bool {
    let end = |corner: Corner| filtered.rounded(corner).map(|value| value.hi());
    let [low, high] = [end(Corner::high(&[])), end(Corner::high(&[]).opposite())];
    let inertia = |at: &[f64; 7]| at[M] * at[V] * at[V];
    let least_stress = |effects: f64| effects * low[S] * low[D];
    // Neither overflow nor underflow, and at most five roundings a term.
    let is_usual = low.iter().chain(&high).all(|value| (1e-60..1e60).contains(value));
    let exceeds = |left: f64, right: f64| left > right * (1.0 + 1e-14);
    is_usual
        && (exceeds(2.0 * inertia(&low), high[A] * high[S] * high[D])
            || exceeds(least_stress(low[A] + low[B]), inertia(&high) + high[K] * high[D] * high[D]))
}

/// The polynomials along an edge between two corners; none if the signs of their Bernstein coefficients show that it misses
/// the area.
fn polynomials<T: Coefficient>(
    filtered: &Filtered<'_>,
    ends: [Corner; 2],
    parameter: usize,
) -> Option<[Tensor<T>; 3]> {
    let lines = Lines::<T>::between(filtered, ends, &[(parameter, 0)]);
    let never = |tensor: &Tensor<T>, test: fn(&T) -> bool| tensor.clone().into_bernstein().all(test);
    let [half, sum] = lines.lower_area();
    if [&half, &sum].into_iter().any(|side| never(side, |value| value.is_negative() || value.is_zero())) {
        return None;
    }
    let discriminant = lines.discriminant();
    (!never(&discriminant, T::is_negative)).then_some([discriminant, half, sum])
}

/// An edge of the box, from 0 to 1, with no end in the area.
struct Edge {
    ends: [Point; 2],
    discriminant: UnivariatePolynomial,
    sides: [UnivariatePolynomial; 2],
    sturm: SturmSequence,
}

impl Edge {
    /// The polynomials along an edge; none if it clearly misses the area.
    fn new(filtered: &Filtered<'_>, ends: [Corner; 2]) -> Option<Self> {
        filtered.edges.set(filtered.edges.get() + 1);
        let parameter = ORDER.into_iter().find(|i| ends[0].flipped(*i) == ends[1])?;
        polynomials::<Rough>(filtered, ends, parameter)?;
        let [discriminant, half, sum] = polynomials::<Integer>(filtered, ends, parameter)?;
        let (discriminant, sides) = (discriminant.univariate(), [half.univariate(), sum.univariate()]);
        let sturm = SturmSequence::new(&discriminant);
        Some(Self { ends: ends.map(|corner| filtered.region.corner(corner)), discriminant, sides, sturm })
    }

    /// Whether the edge meets the area, and a point if that is rational.
    fn search(&self) -> Option<Option<Point>> {
        self.between(&Rational::new(), &Rational::from(1))
    }

    fn is_inside(&self, at: &Rational) -> bool {
        self.discriminant.evaluate(at) >= 0 && self.sides.iter().all(|side| side.evaluate(at) > 0)
    }

    /// Searches a part of the edge whose ends are outside. The area's piece would end at roots of the discriminant.
    fn between(&self, low: &Rational, high: &Rational) -> Option<Option<Point>> {
        let is_root = |at: &Rational| self.discriminant.evaluate(at) == 0;
        let within = self.sturm.count_roots(low, high) - usize::from(is_root(high));
        match within {
            0 => return None,
            1 => return self.touched_between(low, high),
            _ => {}
        }
        let middle = (low + high).complete() / 2u32;
        if self.is_inside(&middle) {
            return Some(self.point(&middle));
        }
        self.between(low, &middle).or_else(|| self.between(&middle, high))
    }

    /// With one root between, the piece is that point alone: a multiple root of the discriminant, negative on both sides.
    ///
    /// At such a root both sides are positive or one is negative, so that halving decides.
    fn touched_between(&self, low: &Rational, high: &Rational) -> Option<Option<Point>> {
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
                    Some(None) => return Some(None),
                    Some(Some(root)) => return Some(self.point(&root)),
                    None => {}
                },
                _ => {}
            }
            let middle = (&low + &high).complete() / 2u32;
            if self.discriminant.evaluate(&middle) == 0 {
                return self.is_inside(&middle).then(|| self.point(&middle));
            }
            if self.sturm.count_roots(&low, &middle) == 1 { high = middle } else { low = middle }
        }
    }

    fn point(&self, at: &Rational) -> Option<Point> {
        let [start, end] = &self.ends;
        Some(std::array::from_fn(|i| (&end[i] - &start[i]).complete() * at + &start[i]))
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
