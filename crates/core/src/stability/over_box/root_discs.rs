//! Enclosures of the roots of eq 8 for all points of a part of a box.
//!
//! In the variable z = s D₀/V₀, with D_c, V0, σ, K and M in units of D₀, V₀, σ₀, σ₀/D₀ and σ₀D₀/V₀², eq 8 is
//! f = (z + v/d)(m z² + k) + s z (a z/v + (a − b)/d).
//!
//! For any three distinct numbers z_i let W_i = f(z_i)/(m Π(z_i − z_j)). The discs of radius 3|W_i| about the z_i hold all roots, and
//! a union of discs that is apart from the others holds as many roots as discs. With bounds of |W_i| over all points this is so for each point.

use num_complex::Complex64;

use crate::number::{Field, Interval, Rectangle};
use crate::roots::bounded_roots;

/// The seven parameters of a part, in units of the box.
pub(in crate::stability) type Values = [Interval; 7];

/// Steps of the iteration that improves approximate roots.
const POLISHING_STEPS: u32 = 2;

/// Which part of the roots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::stability) enum RootPart {
    /// The largest real part.
    Real,
    /// The largest imaginary part.
    Imaginary,
}

/// The coefficients of eq 8 by ascending power.
pub(super) fn cubic<F: Field + Copy>(values: &[F; 7]) -> [F; 4] {
    let [a, b, d, k, m, s, v] = *values;
    let rate = v / d;
    [k * rate, k + s * (a - b) / d, m * rate + s * a / v, m]
}

/// Discs that hold the three roots; the first is about a real number, the others about real numbers or a conjugate pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct RootDiscs {
    centres: [Complex64; 3],
    radii: [f64; 3],
    /// Whether two discs may have a common point: of the first and second, first and third, second and third.
    touch: [bool; 3],
    /// Where the first disc is apart: half the sum of the other two roots, and a quarter of their squared difference.
    pub(super) others: Option<[Interval; 2]>,
}

impl RootDiscs {
    /// The discs of all points of a part; none beyond the range of 64-bit numbers.
    pub(super) fn of(values: &Values) -> Option<Self> {
        let cubic = cubic(values);
        let centres = approximate_roots(&cubic)?;
        let radii = [0, 1, 2].map(|i| weight(&cubic, &centres, i).high);
        let apart = |i: usize, j: usize| {
            let distance = distance(centres[i], centres[j]);
            let reach = Interval::point(radii[i]) + Interval::point(radii[j]);
            distance.low > reach.high
        };
        let touch = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| !apart(i, j));
        let first = Interval::about(centres[0].re, radii[0]);
        let others = (!touch[0] && !touch[1]).then(|| other_two(&cubic, first));
        radii.iter().all(|radius| radius.is_finite()).then_some(Self { centres, radii, touch, others })
    }

    fn is_joined(&self, i: usize, j: usize) -> bool {
        i == j || self.touch[i + j - 1]
    }

    /// Whether a disc holds exactly one root.
    fn is_alone(&self, i: usize) -> bool {
        (0..3).all(|j| j == i || !self.is_joined(i, j))
    }

    /// Whether a disc holds one root, which is real.
    fn is_real(&self, i: usize) -> bool {
        self.centres[i].im == 0.0 && self.is_alone(i)
    }

    /// A rectangle about a disc.
    fn rectangle(&self, i: usize) -> Rectangle {
        let (centre, radius) = (self.centres[i], self.radii[i]);
        let re = Interval::about(centre.re, radius);
        if self.is_real(i) {
            Rectangle::real(re)
        } else {
            Rectangle { re, im: Interval::about(centre.im, radius) }
        }
    }

    /// The largest value of the three roots.
    pub(super) fn largest(&self, quantity: RootPart) -> Interval {
        let all: [Interval; 3] = std::array::from_fn(|i| self.rectangle(i).part(quantity));
        let high = all.iter().fold(f64::NEG_INFINITY, |high, values| high.max(values.high));
        // A union of discs holds a root, which is not below all of its discs.
        let chained = self.touch.iter().filter(|touch| **touch).count() > 1;
        let least_of_union = |i: usize| {
            let members = (0..3).filter(|j| chained || self.is_joined(i, *j));
            members.map(|j| all[j].low).fold(f64::INFINITY, f64::min)
        };
        let low = (0..3).map(least_of_union).fold(f64::NEG_INFINITY, f64::max);
        let by_discs = Interval { low, high };
        match (quantity, self.others) {
            (RootPart::Real, None) => by_discs,
            (RootPart::Real, Some([half_sum, square])) => {
                let highest = (half_sum + square.square_root()).high.max(all[0].high);
                by_discs.intersection(Interval { low: half_sum.low, high: highest })
            }
            (RootPart::Imaginary, others) => {
                let by_discs = Interval { low: low.max(0.0), high: high.max(0.0) };
                others.map_or(by_discs, |[_, square]| by_discs.intersection((-square).square_root()))
            }
        }
    }
}

/// The value at a point of a box, which has the enclosures of the box's ends where it is at one.
pub(super) fn value_at(quantity: RootPart, point: &[f64; 7], ends: [&Values; 2]) -> Option<Interval> {
    let values = std::array::from_fn(|i| match point[i] {
        value if value <= ends[0][i].high => ends[0][i],
        value if value >= ends[1][i].low => ends[1][i],
        value => Interval::point(value),
    });
    Some(RootDiscs::of(&values)?.largest(quantity))
}

/// Half the sum of the roots beside a real one, and a quarter of the square of their difference: negative for a pair.
fn other_two([c0, c1, c2, c3]: &[Interval; 4], real: Interval) -> [Interval; 2] {
    let steep = *c3 * real;
    let product = -*c0 / steep;
    // By the sum of all roots, and by the sum of their products, which does not cancel for a large root.
    let by_sum = -(*c2 / *c3 + real) * 0.5;
    let by_products = (*c1 + *c0 / real) / steep * 0.5;
    let half_sum = by_sum.intersection(by_products);
    [half_sum, half_sum.square() - product]
}

impl Rectangle {
    fn part(self, quantity: RootPart) -> Interval {
        if quantity == RootPart::Real { self.re } else { self.im }
    }
}

/// Bounds of 3|W_i|.
fn weight(cubic: &[Interval; 4], centres: &[Complex64; 3], i: usize) -> Interval {
    let z = Rectangle { re: Interval::point(centres[i].re), im: Interval::point(centres[i].im) };
    let (square, cube) = (z.square(), z.square() * z);
    let value = Rectangle::real(cubic[0])
        + z.times_real(&cubic[1])
        + square.times_real(&cubic[2])
        + cube.times_real(&cubic[3]);
    let others = (0..3).filter(|j| *j != i);
    let product = others.fold(cubic[3], |product, j| product * distance(centres[i], centres[j]));
    value.squared_magnitude().square_root() * 3.0 / product
}

fn distance(one: Complex64, other: Complex64) -> Interval {
    let part = |x: f64, y: f64| (Interval::point(x) - Interval::point(y)).square();
    (part(one.re, other.re) + part(one.im, other.im)).square_root()
}

/// Half the sum and the product of the roots beside a real one: the sum by that of all three, or by the sum of their products, whichever cancels less.
pub(super) fn beside([c0, c1, c2, c3]: [f64; 4], real: f64) -> [f64; 2] {
    let (product, sum, products) = (-c0 / (c3 * real), c2 / c3, c1 / c3);
    let is_by_sum = sum.abs() + real.abs() < (products.abs() + product.abs()) / real.abs();
    [0.5 * if is_by_sum { -(sum + real) } else { (products - product) / real }, product]
}

/// Roots of the cubic with the middle coefficients, moved apart by about as much as the coefficients leave open.
fn approximate_roots(cubic: &[Interval; 4]) -> Option<[Complex64; 3]> {
    let [c0, c1, c2, c3] = cubic.map(Interval::middle);
    let real = bounded_roots([c0, c1, c2, c3]).real.value;
    let [half_sum, product] = beside([c0, c1, c2, c3], real);
    let quarter_discriminant = half_sum * half_sum - product;
    let spread = cubic.iter().rev().fold(0.0, |sum, c| sum * half_sum.abs() + 0.5 * c.width());
    let gap = (half_sum - real).abs().max(quarter_discriminant.abs().sqrt()).max(libm::cbrt(spread / c3));
    let least = (spread / (c3 * gap)).max(f64::EPSILON * half_sum * half_sum);
    let imaginary = |square: f64| Complex64::new(half_sum, square.max(least).sqrt());
    let mut centres = if quarter_discriminant < 0.0 {
        let upper = imaginary(-quarter_discriminant);
        [Complex64::new(real, 0.0), upper, upper.conj()]
    } else {
        let root = quarter_discriminant.max(least).sqrt();
        [real, half_sum - root, half_sum + root].map(|root| Complex64::new(root, 0.0))
    };
    if quarter_discriminant.abs() > least {
        (0..POLISHING_STEPS).for_each(|_| centres = polished([c0, c1, c2, c3], centres));
    }
    centres.iter().all(|centre| centre.re.is_finite() && centre.im.is_finite()).then_some(centres)
}

/// A step of Weierstrass's iteration for all three roots; a conjugate pair remains one.
fn polished([c0, c1, c2, c3]: [f64; 4], centres: [Complex64; 3]) -> [Complex64; 3] {
    let step = |i: usize| {
        let z = centres[i];
        let value = ((z * c3 + c2) * z + c1) * z + c0;
        let product =
            (0..3).filter(|j| *j != i).fold(Complex64::from(c3), |product, j| product * (z - centres[j]));
        z - value / product
    };
    let (first, second) = (step(0), step(1));
    if centres[1].im == 0.0 {
        [first, second, step(2)]
    } else {
        [Complex64::from(first.re), second, second.conj()]
    }
}
