//! Where the roots of a polynomial lie, from discs that certainly contain them.
//!
//! The centres come from the method of Ehrlich and Aberth in 64-bit numbers and from that of Weierstrass in more bits. The radii are
//! those of Smith's discs n·|P(z)/(c_n Π(z − z_j))|, in intervals of 64-bit numbers or in balls: their union contains every root, and one that meets no other contains one root.
//! Of a polynomial with exact coefficients, roots of which the opposite is a root too (all of those on the imaginary axis among them)
//! and repeated roots are first taken out by greatest common divisors, so that the discs decide in the end.

use std::cmp::Ordering;

use num_complex::Complex64;
use rug::Float;

use slipmode_algebra::number::Interval;
use slipmode_core::number::{Ball, Real};
use slipmode_theory::root_location::RootStatement;

use super::evaluate::NEAR;
use super::number::{Number, Trouble, all};
use super::polynomial::Exact;

/// The precisions of discs; the first one is that of 64-bit numbers.
const BITS: [u32; 3] = [NEAR, 192, 640];

/// How often the centres are improved in 64 bits.
const ITERATIONS: usize = 100;

/// What real and imaginary parts are enclosed in.
trait Part: Real {
    fn exact(number: Float) -> Self;

    /// The least and the greatest number in it.
    fn ends(&self) -> [Float; 2];
}

impl Part for Ball {
    fn exact(number: Float) -> Self {
        Self::exact(number)
    }

    fn ends(&self) -> [Float; 2] {
        [self.lower(), self.upper()]
    }
}

impl Part for Interval {
    /// A centre in 64 bits is one.
    fn exact(number: Float) -> Self {
        Self::point(number.to_f64())
    }

    fn ends(&self) -> [Float; 2] {
        [self.low, self.high].map(|end| Float::with_val(NEAR, end))
    }
}

/// A complex number in two enclosures.
#[derive(Debug, Clone)]
struct Complex<N> {
    re: N,
    im: N,
}

impl<N: Part> Complex<N> {
    fn point(re: Float, im: Float) -> Self {
        Self { re: N::exact(re), im: N::exact(im) }
    }

    fn minus(&self, other: &Self) -> Self {
        Self { re: self.re.clone() - &other.re, im: self.im.clone() - &other.im }
    }

    fn times(&self, other: &Self) -> Self {
        Self {
            re: self.re.clone() * &other.re - self.im.clone() * &other.im,
            im: self.re.clone() * &other.im + self.im.clone() * &other.re,
        }
    }

    fn squared_size(&self) -> N {
        self.re.square() + self.im.square()
    }

    fn size(&self) -> N {
        self.squared_size().sqrt()
    }

    fn over(&self, other: &Self) -> Self {
        let conjugate = Self { re: other.re.clone(), im: -other.im.clone() };
        let (above, below) = (self.times(&conjugate), other.squared_size());
        Self { re: above.re / &below, im: above.im / &below }
    }
}

/// A disc that meets no other one and contains one root.
struct Disc {
    re: Float,
    im: Float,
    radius: Float,
}

impl Disc {
    /// On which side of the imaginary axis it lies; none where it meets the axis.
    fn side(&self) -> Option<Ordering> {
        let size = Float::with_val(self.re.prec(), self.re.abs_ref());
        (size > self.radius).then(|| self.re.cmp0())?
    }

    fn meets(&self, other: &Self) -> bool {
        let prec = self.re.prec();
        let [re, im] = [(&self.re, &other.re), (&self.im, &other.im)]
            .map(|(one, two)| Ball::exact(one.clone()) - Ball::exact(two.clone()));
        let [apart, _] = Complex { re, im }.size().ends();
        Float::with_val_round(prec, &self.radius + &other.radius, rug::float::Round::Up).0 >= apart
    }
}

/// Whether the statement on the roots of a polynomial is true; none where its coefficients leave it open. They stand by ascending power.
///
/// The polynomial zero has every number as a root, and another constant has none.
pub(super) fn is_true(statement: RootStatement, coefficients: &[Number]) -> Option<bool> {
    let mut list = coefficients.to_vec();
    while list.last().is_some_and(Number::is_exactly_zero) {
        list.pop();
    }
    if list.is_empty() {
        return Some(statement == RootStatement::Unstable);
    }
    match exact(&list) {
        // Most points need no exact arithmetic.
        Some(exact) => by_discs(&BITS[..1], statement, &list).or_else(|| of_exact(statement, &exact)),
        None => {
            list.last()?.sign().filter(|sign| *sign != Ordering::Equal)?;
            by_discs(bits(&list), statement, &list)
        }
    }
}

/// The polynomial, where every coefficient is known exactly.
fn exact(coefficients: &[Number]) -> Option<Exact> {
    let known = coefficients.iter().map(|one| match one {
        Number::Exact(value) => Some(value.clone()),
        _ => None,
    });
    known.collect::<Option<_>>().map(Exact::new)
}

/// The precisions of discs that these coefficients are worth.
fn bits(coefficients: &[Number]) -> &'static [u32] {
    let is_near = coefficients.iter().any(|one| matches!(one, Number::Near(_)));
    if is_near { &BITS[..1] } else { &BITS }
}

fn of_exact(statement: RootStatement, polynomial: &Exact) -> Option<bool> {
    let distinct = polynomial.squarefree();
    if statement == RootStatement::AllReal {
        return by_discs(&BITS, statement, &distinct.numbers());
    }
    let (zero, rest) = distinct.without_zero();
    let (pairs, rest) = rest.without_opposite_roots();
    // The roots of `pairs` are the squares of the roots whose opposites are roots too: on the axis where negative, else to both sides.
    let on_axis_alone = || {
        by_discs(&BITS, RootStatement::AllReal, &pairs.numbers())
            .and_then(|real| Some(real && by_discs(&BITS, RootStatement::Stable, &pairs.numbers())?))
    };
    let others = || by_discs(&BITS, statement, &rest.numbers());
    match statement {
        RootStatement::Stable if zero || pairs.degree() > 0 => Some(false),
        RootStatement::Stable => others(),
        _ if pairs.degree() > 0 => match on_axis_alone()? {
            true => others(),
            false => Some(true),
        },
        _ => others(),
    }
}

/// Whether a root lies on the imaginary axis.
pub(super) fn is_one_on_axis(coefficients: &[Number]) -> Option<bool> {
    let Some(exact) = exact(coefficients) else {
        coefficients.last()?.sign().filter(|sign| *sign != Ordering::Equal)?;
        let apart = discs(bits(coefficients), coefficients, |discs| {
            discs.iter().all(|disc| disc.side().is_some()).then_some(())
        });
        return apart.map(|()| false);
    };
    let (zero, rest) = exact.squarefree().without_zero();
    let (pairs, _) = rest.without_opposite_roots();
    if zero || pairs.degree() == 0 {
        return Some(zero);
    }
    // A square that is negative is on the axis; one that is not real, or positive, is not.
    discs(&BITS, &pairs.numbers(), |discs| {
        let is_off_axis = |disc: &Disc| Some(!is_real(disc, discs)? || disc.side()? != Ordering::Less);
        let none = all(discs.iter().map(|disc| is_off_axis(disc).ok_or(Trouble::Open)));
        none.map(|none| !none).ok()
    })
}

fn by_discs(bits: &[u32], statement: RootStatement, coefficients: &[Number]) -> Option<bool> {
    if coefficients.len() < 2 {
        return Some(statement != RootStatement::Unstable);
    }
    discs(bits, coefficients, |discs| {
        let wanted = |disc: &Disc| match statement {
            RootStatement::Stable => disc.side().map(|side| side == Ordering::Less),
            RootStatement::Unstable => disc.side().map(|side| side != Ordering::Greater),
            RootStatement::AllReal => is_real(disc, discs),
        };
        let all = all(discs.iter().map(|disc| wanted(disc).ok_or(Trouble::Open)));
        all.map(|all| all == (statement != RootStatement::Unstable)).ok()
    })
}

/// Whether the root in a disc is real: its conjugate lies in the mirror image, and a disc has one root.
fn is_real(disc: &Disc, all: &[Disc]) -> Option<bool> {
    let size = Float::with_val(disc.im.prec(), disc.im.abs_ref());
    if size > disc.radius {
        return Some(false);
    }
    let image = Disc {
        re: disc.re.clone(),
        im: Float::with_val(disc.im.prec(), -&disc.im),
        radius: disc.radius.clone(),
    };
    (all.iter().filter(|other| image.meets(other)).count() == 1).then_some(true)
}

/// What discs decide that meet no other one, at the first precision at which they do.
fn discs<T>(bits: &[u32], coefficients: &[Number], decide: impl Fn(&[Disc]) -> Option<T>) -> Option<T> {
    if coefficients.len() < 2 {
        return decide(&[]);
    }
    let mut centres = approximate(coefficients)?;
    for &bits in bits {
        centres = centres.into_iter().map(|one| one.map(|part| Float::with_val(bits, part))).collect();
        let found = if bits == NEAR {
            let intervals: Vec<Interval> = coefficients.iter().map(Number::interval).collect();
            enclosed(&intervals, &centres)
        } else {
            let balls: Vec<Ball> =
                coefficients.iter().map(|one| one.ball(bits).with_precision(bits)).collect();
            improve(&balls, &mut centres, bits);
            enclosed(&balls, &centres)
        };
        if let Some(found) = found
            && let Some(decided) = decide(&found)
        {
            return Some(decided);
        }
    }
    None
}

/// Discs around centres, where they meet no other one.
fn enclosed<N: Part>(coefficients: &[N], centres: &[[Float; 2]]) -> Option<Vec<Disc>> {
    let points: Vec<Complex<N>> =
        centres.iter().map(|[re, im]| Complex::point(re.clone(), im.clone())).collect();
    let count = N::from(i32::try_from(points.len()).ok()?);
    let disc = |at: usize| {
        let [_, radius] = (correction(coefficients, &points, at).size() * &count).ends();
        let [re, im] = centres[at].clone();
        radius.is_finite().then_some(Disc { re, im, radius })
    };
    let found = (0..points.len()).map(disc).collect::<Option<Vec<_>>>()?;
    let apart = |at: usize| found[at + 1..].iter().all(|other| !found[at].meets(other));
    (0..found.len()).all(apart).then_some(found)
}

/// P(z)/(c_n Π(z − z_j)) at one of the centres.
fn correction<N: Part>(coefficients: &[N], points: &[Complex<N>], at: usize) -> Complex<N> {
    let z = &points[at];
    let zero = || N::from(0);
    let value = coefficients.iter().rev().fold(Complex { re: zero(), im: zero() }, |value, coefficient| {
        let next = value.times(z);
        Complex { re: next.re + coefficient, im: next.im }
    });
    let leading = coefficients.last().cloned().unwrap_or_else(zero);
    let others = points.iter().enumerate().filter(|(other, _)| *other != at);
    let below = others
        .fold(Complex { re: leading, im: zero() }, |product, (_, other)| product.times(&z.minus(other)));
    value.over(&below)
}

/// Steps of Weierstrass, which double the number of right digits of simple roots.
fn improve(coefficients: &[Ball], centres: &mut [[Float; 2]], bits: u32) {
    for _ in 0..8 {
        for at in 0..centres.len() {
            let points: Vec<Complex<Ball>> =
                centres.iter().map(|[re, im]| Complex::point(re.clone(), im.clone())).collect();
            let step = correction(coefficients, &points, at);
            if step.re.is_bounded() && step.im.is_bounded() {
                let [re, im] = &mut centres[at];
                *re = Float::with_val(bits, &*re - step.re.centre());
                *im = Float::with_val(bits, &*im - step.im.centre());
            }
        }
    }
}

/// Roots in 64 bits; none for coefficients beyond their range.
fn approximate(coefficients: &[Number]) -> Option<Vec<[Float; 2]>> {
    let list: Vec<f64> = coefficients.iter().map(|one| one.ball(64).to_f64()).collect();
    let is_usable =
        |value: &f64| value.is_finite() && (*value == 0.0 || (1e-150..1e150).contains(&value.abs()));
    let usable = list.iter().all(is_usable) && list.last().is_some_and(|leading| *leading != 0.0);
    if !usable {
        return None;
    }
    let mut roots = starts(&list);
    for _ in 0..ITERATIONS {
        let mut largest = 0.0_f64;
        for at in 0..roots.len() {
            let z = roots[at];
            let (value, slope) =
                list.iter().rev().fold((Complex64::ZERO, Complex64::ZERO), |(value, slope), one| {
                    (value * z + one, slope * z + value)
                });
            if value == Complex64::ZERO {
                continue;
            }
            let newton = value / slope;
            let others = roots.iter().enumerate().filter(|(other, _)| *other != at);
            let repelled: Complex64 = others.map(|(_, other)| (z - other).inv()).sum();
            let step = newton / (Complex64::ONE - newton * repelled);
            if step.re.is_finite() && step.im.is_finite() {
                roots[at] = z - step;
                largest = largest.max(step.l1_norm() / z.l1_norm().max(f64::MIN_POSITIVE));
            }
        }
        if largest < 1e-15 {
            break;
        }
    }
    let float = |value: f64| Float::with_val(64, value);
    Some(roots.into_iter().map(|root| [float(root.re), float(root.im)]).collect())
}

/// Starting points on circles whose radii are those of Newton's polygon.
fn starts(coefficients: &[f64]) -> Vec<Complex64> {
    let others = coefficients.iter().enumerate().filter(|(_, value)| **value != 0.0);
    let sizes = others.map(|(power, value)| (power, libm::log2(value.abs())));
    let sizes: Vec<(usize, f64)> = sizes.collect();
    let lowest = sizes.first().map_or(0, |(power, _)| *power);
    let mut roots = vec![Complex64::ZERO; lowest];
    let mut at = 0;
    while at + 1 < sizes.len() {
        let (from, size) = sizes[at];
        let slope = |next: &usize| (sizes[*next].1 - size) / (sizes[*next].0 - from) as f64;
        let steepest = (at + 1..sizes.len()).max_by(|one, two| slope(one).total_cmp(&slope(two)));
        let Some(next) = steepest else { break };
        let (radius, count) = (libm::exp2(-slope(&next)), sizes[next].0 - from);
        // Directions that are no symmetric set, by turning (0.6 + 0.8i) again and again.
        let mut direction = Complex64::new(0.6, 0.8);
        for _ in 0..count {
            roots.push(direction * radius);
            direction *= Complex64::new(-0.28, 0.96);
        }
        at = next;
    }
    roots
}
