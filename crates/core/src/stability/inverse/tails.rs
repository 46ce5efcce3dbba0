//! Where the polynomials of an inverse question have no zero near 0 and far out, for all points of a box: with intervals as coefficients.

use super::frequency::angular_frequency;
use super::{Target, Unknown};
use crate::friction::Quantity;
use crate::number::Interval;
use crate::stability::over_box::{ParameterBox, Scaled, Values};

/// The part of the axis of the unknown that is left to search.
pub(super) struct Tails {
    /// Its ends.
    pub(super) window: [f64; 2],
    /// Whether there is no solution below, and above.
    pub(super) is_bounded: [bool; 2],
}

/// A box is halved so often for a bound.
const HALVINGS: u32 = 7;
/// Room for the rounding of a bound.
const ROOM: f64 = 1e-9;

/// The part of the axis outside of which no point of the box has a solution, as far as that is decided.
pub(super) fn tails(region: &ParameterBox, unknown: Unknown, target: &Target, octaves: i32) -> Tails {
    let scaled = Scaled::new(region);
    let parameter = Quantity::from(unknown) as usize;
    let unit = Interval::enclosing(&Scaled::units(region)[parameter]);
    let values = scaled.values();
    let question = |values: &Values| polynomials(values, parameter, target, scaled.rate);
    let lowest = bound(&values, &question, parameter, HALVINGS, false);
    let highest = bound(&values, &question, parameter, HALVINGS, true);
    let widest = libm::ldexp(1.0, octaves);
    let low = lowest.map_or(unit.low / widest, |low| low * unit.low * (1.0 - ROOM));
    let high = highest.map_or(unit.high * widest, |high| high * unit.high * (1.0 + ROOM));
    Tails { window: [low, high.max(low * 2.0)], is_bounded: [lowest.is_some(), highest.is_some()] }
}

/// A number below (or above) which no polynomial has a zero, at no point of the part.
fn bound(
    values: &Values,
    question: &impl Fn(&Values) -> Vec<Polynomial>,
    unknown: usize,
    halvings: u32,
    is_above: bool,
) -> Option<f64> {
    let of_all: Option<Vec<f64>> =
        question(values).iter().map(|polynomial| polynomial.free_of_zeros(is_above)).collect();
    let worse = |one: f64, other: f64| if is_above { one.max(other) } else { one.min(other) };
    if let Some(bounds) = of_all {
        return bounds.into_iter().reduce(worse);
    }
    let widths = values.map(|value| value.width() / value.high);
    let widest = (0..7).filter(|i| *i != unknown).max_by(|i, j| widths[*i].total_cmp(&widths[*j]))?;
    let middle = values[widest].middle();
    if halvings == 0 || !(values[widest].low < middle && middle < values[widest].high) {
        return None;
    }
    let half = |low: f64, high: f64| {
        let mut half = *values;
        half[widest] = Interval { low, high };
        bound(&half, question, unknown, halvings - 1, is_above)
    };
    let (first, second) = (half(values[widest].low, middle)?, half(middle, values[widest].high)?);
    Some(worse(first, second))
}

/// A polynomial in the unknown; a coefficient that is exactly zero has no other value.
#[derive(Debug, Clone)]
struct Polynomial(Vec<Interval>);

const ZERO: Interval = Interval::point(0.0);

impl Polynomial {
    fn constant(value: Interval) -> Self {
        Self(vec![value])
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = vec![ZERO; self.0.len() + other.0.len() - 1];
        for (i, one) in self.0.iter().enumerate().filter(|(_, value)| **value != ZERO) {
            for (j, other) in other.0.iter().enumerate().filter(|(_, value)| **value != ZERO) {
                product[i + j] = added(product[i + j], *one * *other);
            }
        }
        Self(product)
    }

    fn plus(&self, other: &Self) -> Self {
        let at = |polynomial: &Self, i: usize| polynomial.0.get(i).copied().unwrap_or(ZERO);
        let length = self.0.len().max(other.0.len());
        Self((0..length).map(|i| added(at(self, i), at(other, i))).collect())
    }

    fn scaled(&self, factor: Interval) -> Self {
        self.times(&Self::constant(factor))
    }

    fn by(&self, factor: f64) -> Self {
        self.scaled(Interval::point(factor))
    }

    /// A positive number below (or above) which there is no zero.
    fn free_of_zeros(&self, is_above: bool) -> Option<f64> {
        let mut coefficients: Vec<Interval> = self.0.clone();
        if is_above {
            coefficients.reverse();
        }
        let mut rest = coefficients.into_iter().skip_while(|value| *value == ZERO);
        let first = rest.next()?;
        let least = if first.low > 0.0 { first.low } else { -first.high };
        let most = rest.fold(0.0, |most: f64, value| most.max(-value.low).max(value.high));
        if !(least > 0.0 && most.is_finite()) {
            return None;
        }
        let ratio = least / (least + most);
        (ratio > 0.0).then_some(if is_above { (1.0 + ROOM) / ratio } else { (1.0 - ROOM) * ratio })
    }
}

fn added(one: Interval, other: Interval) -> Interval {
    match (one == ZERO, other == ZERO) {
        (true, _) => other,
        (_, true) => one,
        _ => one + other,
    }
}

/// Polynomials of which one is zero wherever the target is met; the unknown is the variable.
fn polynomials(values: &Values, unknown: usize, target: &Target, rate: Interval) -> Vec<Polynomial> {
    let parameters: [Polynomial; 7] = std::array::from_fn(|i| {
        if i == unknown {
            Polynomial(vec![ZERO, Interval::point(1.0)])
        } else {
            Polynomial::constant(values[i])
        }
    });
    let [a, b, d, k, m, s, v] = &parameters;
    let difference = a.plus(&b.by(-1.0));
    let (direct, inertia) = (s.times(a).times(d), m.times(v).times(v));
    // Eq 8 in z = s D₀/V₀, times D_c V0.
    let sum = inertia.plus(&direct);
    let cubic = [
        k.times(v).times(v),
        v.times(&k.times(d).plus(&s.times(&difference))),
        sum.clone(),
        m.times(d).times(v),
    ];
    match target {
        Target::GrowthRate(growth) if growth.is_zero() => {
            vec![k.times(a).times(d).times(d).plus(&difference.times(&sum))]
        }
        Target::GrowthRate(growth) => at_growth(&cubic, Interval::enclosing(growth) / rate),
        Target::Boundary => vec![discriminant(&cubic)],
        // Aω² = T·K V0/D_c in these units.
        Target::FrequencyRatio(threshold) => {
            vec![at_frequency(
                &cubic,
                &k.times(d).times(v).scaled(Interval::enclosing(threshold.squared_ratio())),
            )]
        }
        frequency => {
            let square = (angular_frequency(frequency) / rate).square();
            vec![at_frequency(&cubic, &cubic[3].scaled(square))]
        }
    }
}

/// The value of the cubic at the rate, and the Hurwitz determinant about it.
fn at_growth([c0, c1, c2, c3]: &[Polynomial; 4], rate: Interval) -> Vec<Polynomial> {
    let square = rate.square();
    let value = c0.plus(&c1.scaled(rate)).plus(&c2.scaled(square)).plus(&c3.scaled(square * rate));
    let slope = c1.plus(&c2.scaled(rate * 2.0)).plus(&c3.scaled(square * 3.0));
    let quadratic = c2.plus(&c3.scaled(rate * 3.0));
    let hurwitz = slope.times(&quadratic).plus(&value.times(c3).by(-1.0));
    vec![value, hurwitz]
}

/// c3·R(ω) = c3Δ + 4wH² + 32w²c3H + 64w³c3² with H = c2² − 3c1c3 and w = c3ω².
fn at_frequency(cubic: &[Polynomial; 4], square: &Polynomial) -> Polynomial {
    let [_, c1, c2, c3] = cubic;
    let spread = c2.times(c2).plus(&c1.times(c3).by(-3.0));
    let first = discriminant(cubic).times(c3);
    let second = spread.times(&spread).times(square).by(4.0);
    let third = square.times(square).times(c3).times(&spread).by(32.0);
    let fourth = square.times(square).times(square).times(c3).times(c3).by(64.0);
    first.plus(&second).plus(&third).plus(&fourth)
}

/// c1²c2² − 4c0c2³ − 4c1³c3 − 27c0²c3² + 18c0c1c2c3.
fn discriminant([c0, c1, c2, c3]: &[Polynomial; 4]) -> Polynomial {
    let (middle, outer) = (c1.times(c2), c0.times(c3));
    let cubes = c0.times(&c2.times(c2).times(c2)).plus(&c1.times(c1).times(c1).times(c3)).by(-4.0);
    let mixed = middle.times(&outer).by(18.0).plus(&outer.times(&outer).by(-27.0));
    middle.times(&middle).plus(&cubes).plus(&mixed)
}
