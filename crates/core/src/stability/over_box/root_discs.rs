//! Enclosures of the roots of eq 8 for all points of a part of a box, and how they change with each parameter.
//!
//! In the variable z = s D₀/V₀, with D_c, V0, σ, K and M in units of D₀, V₀, σ₀, σ₀/D₀ and σ₀D₀/V₀², eq 8 is
//! f = (z + v/d)(m z² + k) + s z (a z/v + (a − b)/d).
//!
//! For any three distinct numbers z_i let W_i = f(z_i)/(m Π(z_i − z_j)). The discs of radius 3|W_i| about the z_i hold all roots, and
//! a union of discs that is apart from the others holds as many roots as discs. With bounds of |W_i| over all points this is so for each point.

use num_complex::Complex64;

use super::corners::{B, D, K, M, S, V};
use crate::number::{Field, Interval, Rectangle};
use crate::roots::bounded_roots;

/// The seven parameters of a part, in units of the box.
pub(in crate::stability) type Values = [Interval; 7];

/// Steps of the iteration that improves approximate roots.
const POLISHING_STEPS: u32 = 2;

/// How often a root's enclosure is narrowed.
const CONTRACTIONS: u32 = 3;

/// Which part of the roots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::stability) enum Quantity {
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
    others: Option<[Interval; 2]>,
}

impl RootDiscs {
    /// The discs of all points of a part; none beyond the range of 64-bit numbers.
    pub(super) fn of(values: &Values) -> Option<Self> {
        let cubic = cubic(values);
        let centres = approximate_roots(&cubic)?;
        let mut radii = [0.0; 3];
        for (i, radius) in radii.iter_mut().enumerate() {
            *radius = weight(&cubic, &centres, i).high;
        }
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

    /// Enclosures of the roots in discs that hold one root each, narrowed by their derivatives.
    ///
    /// `middle` is a point of the part: by the mean value theorem a root is that of the point, and changes as the derivatives say.
    pub(super) fn tracked(&self, values: &Values, middle: &Self, point: &Values) -> [Option<Tracked>; 3] {
        let of_disc = |i: usize| {
            let rectangle = self.rectangle(i);
            let meets = |j: &usize| rectangle.meets(middle.rectangle(*j));
            let mut same = (0..3).filter(meets);
            let j =
                same.next().filter(|j| same.next().is_none() && self.is_alone(i) && middle.is_alone(*j))?;
            Tracked::new(rectangle, values)?.narrowed(middle.rectangle(j), values, point)
        };
        let [first, second] = [0, 1].map(of_disc);
        let is_pair = self.centres[1].im != 0.0;
        [first, second, if is_pair { second.map(Tracked::conjugate) } else { of_disc(2) }]
    }

    /// The values of the root or roots of each disc.
    fn values(&self, quantity: Quantity, tracked: &[Option<Tracked>; 3]) -> [Interval; 3] {
        std::array::from_fn(|i| {
            tracked[i].map_or_else(|| self.rectangle(i).part(quantity), |root| root.value(quantity))
        })
    }

    /// The largest value of the three roots.
    pub(super) fn largest(&self, quantity: Quantity, tracked: &[Option<Tracked>; 3]) -> Interval {
        let all = self.values(quantity, tracked);
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
            (Quantity::Real, None) => by_discs,
            (Quantity::Real, Some([half_sum, square])) => {
                let highest = (half_sum + square.square_root()).high.max(all[0].high);
                by_discs.intersection(Interval { low: half_sum.low, high: highest })
            }
            (Quantity::Imaginary, others) => {
                let by_discs = Interval { low: low.max(0.0), high: high.max(0.0) };
                others.map_or(by_discs, |[_, square]| by_discs.intersection((-square).square_root()))
            }
        }
    }

    /// As [`other_two`], with the real root that was narrowed; none where the first disc is not apart.
    pub(super) fn others(&self, values: &Values, tracked: &[Option<Tracked>; 3]) -> Option<[Interval; 2]> {
        let narrowed = |others| tracked[0].map_or(others, |real| other_two(&cubic(values), real.root.re));
        self.others.map(narrowed)
    }

    /// The root whose value is the largest at all points. None where another root may have it.
    pub(super) fn top(&self, quantity: Quantity, tracked: &[Option<Tracked>; 3]) -> Option<Tracked> {
        let all = self.values(quantity, tracked);
        let is_pair = self.centres[1].im != 0.0;
        let is_top = |i: usize| {
            let is_conjugate = |j: usize| is_pair && i + j == 3;
            (quantity == Quantity::Real || all[i].low > 0.0)
                && (0..3).all(|j| j == i || is_conjugate(j) || all[i].low > all[j].high)
        };
        (0..3).find(|i| is_top(*i)).and_then(|i| tracked[i])
    }
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

/// A root over a part.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tracked {
    root: Rectangle,
    /// The derivatives of its real and of its imaginary part by each parameter.
    slopes: [[Interval; 7]; 2],
}

impl Tracked {
    fn new(root: Rectangle, values: &Values) -> Option<Self> {
        // Each form has narrow enclosures where the other's terms cancel: the first at small V0, the second at large V0.
        let [of_cubic, of_sum] =
            [derivatives_of_cubic(root, values), derivatives_of_sum(root, values)].map(root_slopes);
        let slopes: [[Interval; 7]; 2] = std::array::from_fn(|part| {
            std::array::from_fn(|i| of_cubic[part][i].intersection(of_sum[part][i]))
        });
        let is_known = slopes.as_flattened().iter().all(|slope| slope.is_finite());
        is_known.then_some(Self { root, slopes })
    }

    /// The conjugate root.
    fn conjugate(self) -> Self {
        let [re, im] = self.slopes;
        Self { root: self.root.conjugate(), slopes: [re, im.map(|slope| -slope)] }
    }

    /// The root by what it is at a point and by its derivatives, as often as it pays.
    fn narrowed(mut self, at_point: Rectangle, values: &Values, point: &Values) -> Option<Self> {
        for _ in 0..CONTRACTIONS {
            let change = |slopes: &[Interval; 7]| {
                let changes = (0..7).map(|i| slopes[i] * (values[i] - point[i]));
                changes.reduce(|sum, change| sum + change)
            };
            let [re, im] = self.slopes.each_ref().map(change);
            let moved = at_point + Rectangle { re: re?, im: im? };
            let (re, im) = (self.root.re.intersection(moved.re), self.root.im.intersection(moved.im));
            self = Self::new(Rectangle { re, im }, values)?;
        }
        Some(self)
    }

    /// The root's value.
    fn value(&self, quantity: Quantity) -> Interval {
        self.root.part(quantity)
    }

    /// Its derivatives.
    pub(super) fn slopes(&self, quantity: Quantity) -> [Interval; 7] {
        self.slopes[usize::from(quantity == Quantity::Imaginary)]
    }
}

impl Rectangle {
    fn part(self, quantity: Quantity) -> Interval {
        if quantity == Quantity::Real { self.re } else { self.im }
    }
}

/// The derivatives of a function by z and by each parameter, in their order.
type Derivatives = (Rectangle, [Rectangle; 7]);

/// How the real and the imaginary part of a root of the function change with each parameter.
fn root_slopes((slope, partial): Derivatives) -> [[Interval; 7]; 2] {
    let scale = slope.squared_magnitude();
    let changes = partial.map(|partial| partial * slope.conjugate());
    [changes.map(|change| -change.re / scale), changes.map(|change| -change.im / scale)]
}

/// The derivatives of f.
fn derivatives_of_cubic(z: Rectangle, values: &Values) -> Derivatives {
    let [a, b, d, k, m, s, v] = *values;
    let [_, c1, c2, c3] = cubic(values);
    let one = Interval::point(1.0);
    let (square, from_pole) = (z.square(), z + Rectangle::real(v / d));
    let machine = square * m + Rectangle::real(k);
    let mut partial = [z * from_pole * (s / v); 7];
    partial[B] = z * -(s / d);
    partial[D] = (machine * v + z * (s * (a - b))) * -(one / d.square());
    partial[K] = from_pole;
    partial[M] = square * from_pole;
    partial[S] = z * (z * (a / v) + Rectangle::real((a - b) / d));
    partial[V] = machine * (one / d) - square * (s * a / v.square());
    (Rectangle::real(c1) + z * (c2 * 2.0) + square * (c3 * 3.0), partial)
}

/// The derivatives of h = m z + k/z + s a/v − s b/(d z + v); f is h times z (z + v/d).
fn derivatives_of_sum(z: Rectangle, values: &Values) -> Derivatives {
    let [a, b, d, k, m, s, v] = *values;
    let inverse = z.reciprocal();
    let from_pole = (z * d + Rectangle::real(v)).reciprocal();
    let square = from_pole.square();
    let mut partial = [Rectangle::real(s / v); 7];
    partial[B] = from_pole * -s;
    partial[D] = z * square * (s * b);
    partial[K] = inverse;
    partial[M] = z;
    partial[S] = Rectangle::real(a / v) - from_pole * b;
    partial[V] = (square * b - Rectangle::real(a / v.square())) * s;
    (Rectangle::real(m) - inverse.square() * k + square * (s * b * d), partial)
}

/// Bounds of 3|W_i|.
fn weight(cubic: &[Interval; 4], centres: &[Complex64; 3], i: usize) -> Interval {
    let z = Rectangle { re: Interval::point(centres[i].re), im: Interval::point(centres[i].im) };
    let (square, cube) = (z.square(), z.square() * z);
    let value = Rectangle::real(cubic[0]) + z * cubic[1] + square * cubic[2] + cube * cubic[3];
    let others = (0..3).filter(|j| *j != i);
    let product = others.fold(cubic[3], |product, j| product * distance(centres[i], centres[j]));
    value.squared_magnitude().square_root() * 3.0 / product
}

fn distance(one: Complex64, other: Complex64) -> Interval {
    let part = |x: f64, y: f64| (Interval::point(x) - Interval::point(y)).square();
    (part(one.re, other.re) + part(one.im, other.im)).square_root()
}

/// Roots of the cubic with the middle coefficients, moved apart by about as much as the coefficients leave open.
fn approximate_roots(cubic: &[Interval; 4]) -> Option<[Complex64; 3]> {
    let [c0, c1, c2, c3] = cubic.map(Interval::middle);
    let real = bounded_roots([c0, c1, c2, c3]).real.value;
    let (half_sum, product) = (-0.5 * (c2 / c3 + real), -c0 / (c3 * real));
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
