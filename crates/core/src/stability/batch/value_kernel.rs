//! Growth rate and frequency of the points of one grid row without branches, for vector units, each with a proved error.
//!
//! Eq 8 times aσD_c has the coefficients c0 = k, c1 = k + δσ, c2 = ασ + m, c3 = m with k = K D_c², m = M V0², α = a D_c and
//! δ = (a − b)D_c. The roots follow as in [`ShortCubic`](crate::roots::ShortCubic): y³ + 3P'y + Q = 0 for y = 3c3·x + c2, the
//! pair (−y − 2c2)/(6c3) ± (9/2)√Δ/f'(y). All that cancels is computed in double-double, whose every operation errs by at
//! most U = 2^-102; |y| comes from Newton's iteration in 64-bit and one step with a double-double residual.
//!
//! **The bound.** Each coefficient errs by at most 4U of its terms. A product of n coefficients in a sum then errs by
//! at most 4nU and a U for every operation: P' by 12U, Q by 18U and Δ by 28U of the sums of the magnitudes of their terms.
//! With z = |y|, F(z) = z³ + 3P'z − |Q| has one positive root, where F' = 3(z² + P') ≥ 2z². Where F' ≥ (3/2)z² still holds and
//! the Newton step t is below 1e-6·z, F''/(2F') is at most 2/z around, a root lies within 2|t| (Newton-Kantorovich), and
//! the step leaves at most 2t²/z times a factor near 1, in addition to the rounding of t and the errors of the data and residual
//! over F'. A point at which the bounds do not prove two units in the last place is marked, and is left to a higher precision level.

use super::dispatch::Kernel;
use crate::friction::{Parameters, Slider};
use crate::number::{Dd, Field, Rational, Real};

/// The relative error up to which a value is taken before it is rounded to 64 bits: a half unit in the last place.
pub(super) const TOLERANCE: f64 = f64::EPSILON / 2.0;

/// Covers the rounding of the bounds themselves and the second order of their first-order terms (each below 1/100).
const SLACK: f64 = 1.05;

/// Terms outside 2^±120 are left to a higher precision level: inside, no fourth-order product over- or underflows, nor does its rounding error.
const MOST: f64 = power_of_two(120);
const LEAST: f64 = power_of_two(-120);

/// Newton steps in 64-bit: from at most 1.6 times the root to 1e-12 of it.
const STEPS: usize = 5;

const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// What the rows of a grid share: k, M, α, δ and D_c.
#[derive(Debug, Clone)]
pub(super) struct ValueTerms {
    spring: Dd,
    mass: Dd,
    direct: Dd,
    difference: Dd,
    length: Dd,
}

/// The coefficients of a row, and what turns its results into 1/s.
#[derive(Debug, Clone, Copy)]
pub(super) struct ValueRow {
    spring: Dd,
    inertia: Dd,
    direct: Dd,
    difference: Dd,
    /// V0/(3 c3 D_c), from 3c3·x to 1/s.
    of_shifted: Dd,
    /// (9/2)V0/D_c, from √|Δ|/f' to 1/s.
    of_width: Dd,
    usable: bool,
}

impl ValueTerms {
    /// The terms of this slider.
    pub(super) fn new(slider: &Slider<Rational>) -> Self {
        let length = &slider.critical_slip_distance_m;
        let difference = Rational::from(&slider.direct_effect - &slider.evolution_effect);
        Self {
            spring: Dd::from_rational(&(slider.stiffness_pa_per_m.clone() * Field::square(length))),
            mass: Dd::from_rational(&slider.mass_per_area_kg_per_m2),
            direct: Dd::from_rational(&(slider.direct_effect.clone() * length)),
            difference: Dd::from_rational(&(difference * length)),
            length: Dd::from_rational(length),
        }
    }

    /// The terms of one point, in the double-doubles that hold its 64-bit numbers exactly.
    #[inline(always)]
    fn of_slider(slider: &Slider<f64>) -> Self {
        let length = Dd::from(slider.critical_slip_distance_m);
        let difference = Dd::exact_sum(slider.direct_effect, -slider.evolution_effect);
        Self {
            spring: Dd::exact_product(slider.stiffness_pa_per_m, slider.critical_slip_distance_m) * length,
            mass: Dd::from(slider.mass_per_area_kg_per_m2),
            direct: Dd::exact_product(slider.direct_effect, slider.critical_slip_distance_m),
            difference: difference * length,
            length,
        }
    }

    /// The row of this V0.
    #[inline(always)]
    pub(super) fn row(&self, loading_velocity_m_per_s: f64) -> ValueRow {
        let rate = Dd::from(loading_velocity_m_per_s) / self.length;
        let inertia = self.mass * Dd::exact_product(loading_velocity_m_per_s, loading_velocity_m_per_s);
        let mut usable = is_in_range(loading_velocity_m_per_s);
        for term in [rate, self.spring, inertia, self.length, self.mass] {
            usable &= is_in_range(term.hi());
        }
        ValueRow {
            spring: self.spring,
            inertia,
            direct: self.direct,
            difference: self.difference,
            of_shifted: rate / (inertia * Dd::from(3.0)),
            of_width: rate * Dd::from(4.5),
            usable,
        }
    }
}

#[inline(always)]
fn is_in_range(size: f64) -> bool {
    (size > LEAST) & (size < MOST)
}

/// The largest real and imaginary part in 1/s, and whether both are within [`TOLERANCE`] before the last rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Parts {
    real: f64,
    imaginary: f64,
    certain: bool,
}

/// The outermost root |y| with a bound of its relative error.
#[derive(Debug, Clone, Copy)]
struct Outermost {
    root: Dd,
    error: f64,
}

impl ValueRow {
    #[inline(always)]
    fn at(&self, stress: f64) -> Parts {
        let unit = Dd::UNIT;
        let (c0, c3) = (self.spring, self.inertia);
        let (direct, difference) = (self.direct * Dd::from(stress), self.difference * Dd::from(stress));
        let (c1, c2) = (c0 + difference, direct + c3);
        let spread = difference.hi().abs();
        let in_range =
            is_in_range(stress) & is_in_range(direct.hi()) & (is_in_range(spread) | (spread == 0.0));
        let [m0, m1, m2, m3] = [c0.hi(), c0.hi() + spread, c2.hi(), c3.hi()];

        let (square, inner, outer, odd) = (c2.square(), c1 * c2, c0 * c3, c1 * c3);
        let linear = odd * Dd::from(3.0) - square;
        let linear_error = 12.0 * unit * SLACK * (3.0 * m1 * m3 + m2 * m2);
        let constant = c2 * (square.scale(2.0) - odd * Dd::from(9.0)) + outer * c3 * Dd::from(27.0);
        let constant_error =
            18.0 * unit * SLACK * (m2 * (2.0 * m2 * m2 + 9.0 * m1 * m3) + 27.0 * m0 * m3 * m3);
        let cubes = (c0 * c2 * square + odd * c1.square()).scale(4.0);
        let products = inner.square() + inner * outer * Dd::from(18.0);
        let delta = products - cubes - outer.square() * Dd::from(27.0);
        let (mi, mo) = (m1 * m2, m0 * m3);
        let sizes = mi * (mi + 18.0 * mo) + 27.0 * mo * mo + 4.0 * (m0 * m2 * m2 * m2 + m1 * m1 * m1 * m3);
        let delta_relative = 28.0 * unit * SLACK * sizes / delta.hi().abs();

        let Outermost { root: z, error } = outermost(linear, constant.abs(), linear_error, constant_error);
        let negative = constant.hi() > 0.0;
        let y = if negative { -z } else { z };
        let slope = (z.square() + linear) * Dd::from(3.0);
        let square_of_root = z.hi() * z.hi();
        let slope_error = 3.0 * (linear_error + square_of_root * (2.0 * error + 2.0 * unit));
        let slope_relative = SLACK * (slope_error / slope.hi().abs() + 2.0 * unit);

        let width = delta.abs().sqrt() / slope;
        let width_relative = SLACK * (0.5 * delta_relative + slope_relative + 8.0 * unit);
        let complex = delta.hi() < 0.0;
        // In units of 3c3·x: the half width is 13.5·c3·√|Δ|/f'.
        let shifted_width = width * c3 * Dd::from(13.5);
        let width_error = SLACK * shifted_width.hi() * (width_relative + 8.0 * unit);
        let single = y - c2;
        let common = SLACK * (z.hi() * (error + unit) + m2 * 8.0 * unit);
        let centre = -(y.scale(0.5) + c2);
        let end = if complex { centre } else { centre + shifted_width };
        let end_error = if complex { common } else { common + width_error + unit * end.hi().abs() };
        let single_is_top = single.hi() > end.hi();
        let top = if single_is_top { single } else { end };
        let top_error =
            SLACK * (if single_is_top { common } else { end_error } + 8.0 * unit * top.hi().abs());
        let apart = (single.hi() - end.hi()).abs() > 2.0 * (common + end_error);
        let height = if complex & !single_is_top { shifted_width.hi() } else { 0.0 };
        let modulus = (top.hi() * top.hi() + height * height).sqrt();

        let certain = in_range
            & self.usable
            & apart
            & (delta_relative < 1e-2)
            & (width_relative < TOLERANCE)
            & (top_error < TOLERANCE * modulus)
            & (top_error < top.hi().abs());
        let imaginary = (width * self.of_width).hi();
        Parts {
            real: (top * self.of_shifted).hi(),
            imaginary: if complex { imaginary } else { 0.0 },
            certain,
        }
    }
}

/// The positive root of z³ + 3P'z − |Q|, the largest in modulus, given P', |Q| and the bounds of their errors.
#[inline(always)]
fn outermost(linear: Dd, constant: Dd, linear_error: f64, constant_error: f64) -> Outermost {
    let (p, q) = (3.0 * linear.hi(), constant.hi());
    let cube_root = cube_root_above(q);
    let descending = 1.33 * cube_root.max((-p).max(0.0).sqrt());
    let ascending = cube_root.min(q / p);
    let mut z = if p > 0.0 { ascending } else { descending };
    for _ in 0..STEPS {
        let square = z * z;
        z = (2.0 * square * z + q) / (3.0 * square + p);
    }
    let start = Dd::from(z);
    let residual = (start.square() + linear * Dd::from(3.0)) * start - constant;
    let slope = 3.0 * z * z + p;
    let step = residual.hi() / slope;
    let moved = (step / z).abs();
    let of_data = 3.0 * linear_error * z + constant_error;
    let of_evaluation = 8.0 * Dd::UNIT * (z * z * z + p.abs() * z + q);
    let relative = 8.0 * f64::EPSILON * moved + 3.0 * moved * moved + (of_data + of_evaluation) / (slope * z);
    // Beyond this the step's bound does not hold; what is not a number is not below it.
    let error =
        if (moved < 1e-6) & (slope > 1.5 * z * z) { SLACK * relative + Dd::UNIT } else { f64::INFINITY };
    Outermost { root: start - Dd::from(step), error }
}

/// ∛x times a factor between 1 and 1.12, for positive normal x: a third of the bits' value, shifted.
#[inline(always)]
fn cube_root_above(x: f64) -> f64 {
    const SHIFT: f64 = 715_094_163.0 * 4_294_967_296.0;
    let third = x.to_bits() as i64 as f64 * (1.0 / 3.0) + SHIFT;
    f64::from_bits(third as i64 as u64) * 1.06
}

/// Where the parts of a block of points go; parts that are not numbers mark a point that has to be left to a higher precision level.
pub(super) struct PartColumns<'a> {
    pub(super) real: &'a mut [f64],
    pub(super) imaginary: &'a mut [f64],
}

impl PartColumns<'_> {
    #[inline(always)]
    fn set(&mut self, index: usize, parts: Parts) {
        self.real[index] = if parts.certain { parts.real } else { f64::NAN };
        self.imaginary[index] = if parts.certain { parts.imaginary } else { f64::NAN };
    }
}

/// The loop over the σ of a row.
pub(super) struct ValueLoop<'a> {
    pub(super) row: &'a ValueRow,
    pub(super) stresses: &'a [f64],
    pub(super) parts: PartColumns<'a>,
}

impl Kernel for ValueLoop<'_> {
    #[inline(always)]
    fn run(self) {
        let (row, count) = (*self.row, self.stresses.len());
        let mut parts = PartColumns {
            real: &mut self.parts.real[..count],
            imaginary: &mut self.parts.imaginary[..count],
        };
        for index in 0..count {
            parts.set(index, row.at(self.stresses[index]));
        }
    }
}

/// The loop over a block of unrelated points.
pub(super) struct PointValueLoop<'a> {
    pub(super) columns: &'a Parameters<&'a [f64]>,
    pub(super) parts: PartColumns<'a>,
}

impl Kernel for PointValueLoop<'_> {
    #[inline(always)]
    fn run(self) {
        let count = self.columns.slider.direct_effect.len();
        let columns = self.columns.map(|column| &column[..count]);
        let mut parts = PartColumns {
            real: &mut self.parts.real[..count],
            imaginary: &mut self.parts.imaginary[..count],
        };
        for index in 0..count {
            let Parameters { slider, point } = columns.map(|column| column[index]);
            let row = ValueTerms::of_slider(&slider).row(point.loading_velocity_m_per_s);
            let mut found = row.at(point.normal_stress_pa);
            // b enters as a − b only, which would hide a b that is not positive.
            found.certain &= is_in_range(slider.evolution_effect);
            parts.set(index, found);
        }
    }
}
