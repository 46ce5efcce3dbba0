//! A (V0, σ) grid at fixed material and machine: both decisions are polynomials in σ along a row of constant V0.
//!
//! With k = K·D_c, m = M·V0²/D_c and δ = a − b, eq 8 times aσ has the coefficients k, k + δσ, aσ + m, m. Its discriminant is a
//! quartic in σ, and a·D_c·(K − K_c) = ka + δm + δaσ is linear. A row computes those coefficients once in
//! balls, so that the inner loop is two Horner schemes for values and two for their error bounds.
//!
//! **The filter's bound.** σ is scaled by a power of two to x ≤ 1, the coefficients q_i by another so that the largest lies
//! in [1/2, 1]. Horner's scheme of degree 4 with separate products and sums errs by at most γ₈·Σ|q_i|x^i (γ_n = nu/(1−nu),
//! u = 2^-53), rounding q_i to f64 by u|q_i| and by the radius r_i of its ball. The bound is evaluated in 64-bit itself with
//! e_i = 2^-48·|q_i| + r_i: 32u leaves room for γ₉ and for the bound's own rounding. All intermediate values are
//! at most 5, so nothing overflows; underflow contributes less than 10·2^-1074 and is covered by 2^-1000.

use rayon::prelude::*;
use rug::{Float, Rational};

use super::dispatch::{Kernel, run_on_widest_unit};
use super::{RungCounts, SignPair};
use crate::friction::Parameters;
use crate::number::{Ball, Field};
use crate::stability::ladder;

/// Precision of a row's coefficients before they are rounded to f64: room for a cancellation of 100 bits and more.
const ROW_BITS: u32 = 192;

/// Relative part of the filter's error bound.
const RELATIVE_BOUND: f64 = 1.0 / (1u64 << 48) as f64;

/// Absolute part of the filter's error bound, for underflow: 2^-1000.
const ABSOLUTE_BOUND: f64 = f64::from_bits((1023 - 1000) << 52);

/// The signs of every point of a grid, row after row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Grid {
    /// One entry per point; the σ index runs fastest.
    pub cells: Vec<SignPair>,
    /// How many points each rung decided.
    pub counts: RungCounts,
}

/// Classifies every point of the grid exactly; V0 in m/s and σ in Pa are taken from the slices, the rest from `fixed`.
///
/// `None` unless every V0 and σ is positive and finite.
#[must_use]
pub fn classify_grid(
    fixed: &Parameters<Rational>,
    loading_velocities_m_per_s: &[f64],
    normal_stresses_pa: &[f64],
) -> Option<Grid> {
    let kernel = GridKernel::new(fixed, normal_stresses_pa)?;
    let width = normal_stresses_pa.len();
    let mut cells = vec![SignPair::UNDECIDED; width * loading_velocities_m_per_s.len()];
    let counts = cells
        .par_chunks_mut(width.max(1))
        .zip(loading_velocities_m_per_s)
        .map(|(row, &velocity)| kernel.classify_row(velocity, row))
        .collect::<Option<Vec<_>>>()?;
    let mut total = RungCounts::default();
    counts.into_iter().for_each(|row| total += row);
    Some(Grid { cells, counts: total })
}

/// What the rows of a grid share: the fixed parameters and the scaled σ.
#[derive(Debug, Clone)]
pub struct GridKernel {
    fixed: Parameters<Rational>,
    direct_effect: Ball,
    effect_difference: Ball,
    spring: Ball,
    mass_over_length: Ball,
    normal_stresses_pa: Vec<f64>,
    scaled_stresses: Vec<f64>,
    stress_exponent: i32,
}

fn is_positive(value: &f64) -> bool {
    *value > 0.0 && value.is_finite()
}

impl GridKernel {
    /// Prepares a grid over these σ (Pa); `None` unless all are positive and finite.
    #[must_use]
    pub fn new(fixed: &Parameters<Rational>, normal_stresses_pa: &[f64]) -> Option<Self> {
        if !normal_stresses_pa.iter().all(is_positive) {
            return None;
        }
        let largest = normal_stresses_pa.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let (_, stress_exponent) = libm::frexp(largest);
        let ball = |value: &Rational| Ball::from_rational(value, ROW_BITS);
        let length = &fixed.critical_slip_distance_m;
        Some(Self {
            direct_effect: ball(&fixed.direct_effect),
            effect_difference: ball(&(fixed.direct_effect.clone() - &fixed.evolution_effect)),
            spring: ball(&(fixed.stiffness_pa_per_m.clone() * length)),
            mass_over_length: ball(&(fixed.mass_per_area_kg_per_m2.clone() / length)),
            scaled_stresses: normal_stresses_pa.iter().map(|&s| libm::ldexp(s, -stress_exponent)).collect(),
            normal_stresses_pa: normal_stresses_pa.to_vec(),
            stress_exponent,
            fixed: fixed.clone(),
        })
    }

    /// Classifies the row of this V0 (m/s) exactly; `None` unless it is positive and finite and `cells` has one entry per σ.
    #[must_use]
    pub fn classify_row(&self, loading_velocity_m_per_s: f64, cells: &mut [SignPair]) -> Option<RungCounts> {
        if !is_positive(&loading_velocity_m_per_s) || cells.len() != self.scaled_stresses.len() {
            return None;
        }
        let filter = self.row_filter(loading_velocity_m_per_s);
        run_on_widest_unit(RowLoop { filter: &filter, stresses: &self.scaled_stresses, cells });
        Some(self.decide_the_rest(loading_velocity_m_per_s, cells))
    }

    fn row_filter(&self, loading_velocity_m_per_s: f64) -> RowFilter {
        let velocity = Ball::from(loading_velocity_m_per_s).with_precision(ROW_BITS);
        let inertia = velocity.square() * &self.mass_over_length;
        let (a, difference, k) = (&self.direct_effect, &self.effect_difference, &self.spring);
        RowFilter {
            boundary: self.scaled_to_f64(&boundary_quartic(a, difference, k, &inertia)),
            transition: self.scaled_to_f64(&transition_line(a, difference, k, &inertia)),
        }
    }

    /// The coefficients for x = σ/2^e, scaled by one power of two to a maximum in [1/2, 1], with the coefficients of the bound.
    fn scaled_to_f64<const N: usize>(&self, coefficients: &[Ball]) -> BoundedPolynomial<N> {
        let exponent = |power: usize, value: &Float| {
            value
                .get_exp()
                .map(|exponent| i64::from(exponent) + power as i64 * i64::from(self.stress_exponent))
        };
        let largest =
            coefficients.iter().enumerate().filter_map(|(i, c)| exponent(i, c.centre())).max().unwrap_or(0);
        let scale = |power: usize, value: &Float| {
            let (mantissa, exponent) = value.to_f64_exp();
            let shift = i64::from(exponent) + power as i64 * i64::from(self.stress_exponent) - largest;
            libm::ldexp(mantissa, shift.clamp(-5000, 5000) as i32)
        };
        let mut scaled = BoundedPolynomial { value: [0.0; N], bound: [0.0; N] };
        for (power, coefficient) in coefficients.iter().enumerate().take(N) {
            let value = scale(power, coefficient.centre());
            scaled.value[power] = value;
            // A radius of 32 bits is exact in f64 unless it underflows, which the absolute part covers.
            scaled.bound[power] = RELATIVE_BOUND * value.abs() + scale(power, coefficient.radius());
        }
        scaled.bound[0] += ABSOLUTE_BOUND;
        scaled
    }

    /// Hands the points that the filter left open to the upper rungs.
    fn decide_the_rest(&self, loading_velocity_m_per_s: f64, cells: &mut [SignPair]) -> RungCounts {
        let mut counts = RungCounts::default();
        for (cell, &stress) in cells.iter_mut().zip(&self.normal_stresses_pa) {
            if *cell != SignPair::UNDECIDED {
                counts.f64 += 1;
                continue;
            }
            let (signs, rung) = decide_above_filter(&self.point(loading_velocity_m_per_s, stress));
            *cell = signs;
            counts.count(rung);
        }
        counts
    }

    fn point(&self, loading_velocity_m_per_s: f64, normal_stress_pa: f64) -> Parameters<Rational> {
        Parameters {
            loading_velocity_m_per_s: exact(loading_velocity_m_per_s),
            normal_stress_pa: exact(normal_stress_pa),
            ..self.fixed.clone()
        }
    }
}

/// A finite f64 as the rational that it is (zero otherwise, which the callers' checks exclude).
pub(super) fn exact(value: f64) -> Rational {
    Rational::from_f64(value).unwrap_or_default()
}

/// The signs of a point that the 64-bit filter left open.
pub(super) fn decide_above_filter(point: &Parameters<Rational>) -> (SignPair, crate::roots::Rung) {
    let groups = point.groups();
    let signs = ladder::signs_above_f64(&groups, ladder::BoundedGroups::of(&groups).as_ref());
    (SignPair::new(signs.transition, signs.boundary), signs.rung)
}

/// The discriminant of (k, k + δσ, aσ + m, m), by ascending power of σ.
fn boundary_quartic<R: Field>(a: &R, difference: &R, k: &R, m: &R) -> [R; 5] {
    let integer = R::from;
    let (aa, dd, ad) = (a.square(), difference.square(), a.clone() * difference);
    let (kk, mm, km) = (k.square(), m.square(), k.clone() * m);
    let first = integer(20) * a - integer(12) * difference;
    let second = integer(20) * difference - integer(12) * a;
    [
        -(integer(4) * &km * (k.clone() + m).square()),
        (first * k + second * m) * &km,
        aa.clone() * &kk + mm * &dd + (integer(22) * &ad - integer(12) * (aa.clone() + &dd)) * &km,
        (integer(2) * &ad - integer(4) * &aa) * a * k
            + (integer(2) * &ad - integer(4) * &dd) * difference * m,
        ad.square(),
    ]
}

/// a·D_c·(K − K_c) = a²σ·(κ + (1−β)(1+η)) = ka + δm + δaσ, by ascending power of σ.
fn transition_line<R: Field>(a: &R, difference: &R, k: &R, m: &R) -> [R; 2] {
    [k.clone() * a + difference.clone() * m, difference.clone() * a]
}

/// A polynomial in 64-bit with the polynomial that bounds its error.
#[derive(Debug, Clone, Copy)]
struct BoundedPolynomial<const N: usize> {
    value: [f64; N],
    bound: [f64; N],
}

impl<const N: usize> BoundedPolynomial<N> {
    /// Value and bound at x ≥ 0 by Horner's scheme.
    #[inline(always)]
    fn at(&self, x: f64) -> (f64, f64) {
        let (mut value, mut bound) = (self.value[N - 1], self.bound[N - 1]);
        for power in (0..N - 1).rev() {
            value = value * x + self.value[power];
            bound = bound * x + self.bound[power];
        }
        (value, bound)
    }
}

/// The two polynomials of a row.
#[derive(Debug, Clone, Copy)]
struct RowFilter {
    boundary: BoundedPolynomial<5>,
    transition: BoundedPolynomial<2>,
}

/// The inner loop over the σ of a row.
struct RowLoop<'a> {
    filter: &'a RowFilter,
    stresses: &'a [f64],
    cells: &'a mut [SignPair],
}

impl Kernel for RowLoop<'_> {
    #[inline(always)]
    fn run(self) {
        let filter = *self.filter;
        for (cell, &x) in self.cells.iter_mut().zip(self.stresses) {
            let (boundary, boundary_bound) = filter.boundary.at(x);
            let (transition, transition_bound) = filter.transition.at(x);
            let certain = (boundary.abs() > boundary_bound) & (transition.abs() > transition_bound);
            let signs = SignPair::from_decided(transition > 0.0, boundary > 0.0);
            *cell = if certain { signs } else { SignPair::UNDECIDED };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use crate::roots::discriminant;
    use crate::stability::{boundary_sign, transition_sign};
    use proptest::prelude::*;

    /// The paper's values (V0 and σ do not matter here).
    fn paper(a: &str, b: &str) -> Parameters<Rational> {
        let number = |text: &str| parse_decimal(text).unwrap();
        Parameters {
            direct_effect: number(a),
            evolution_effect: number(b),
            critical_slip_distance_m: number("1e-5"),
            stiffness_pa_per_m: number("1e7"),
            mass_per_area_kg_per_m2: number("100"),
            normal_stress_pa: number("1"),
            loading_velocity_m_per_s: number("1"),
        }
    }

    proptest! {
        #[test]
        fn the_quartic_in_normal_stress_is_the_discriminant(
            values in prop::array::uniform5(1i64..1000),
        ) {
            let [a, b, k, m, s] = values.map(Rational::from);
            let difference = a.clone() - b;
            let cubic = [k.clone(), k.clone() + difference.clone() * &s, a.clone() * &s + &m, m.clone()];
            let quartic = boundary_quartic(&a, &difference, &k, &m);
            let value = quartic.into_iter().rev().fold(Rational::new(), |sum, q| sum * &s + q);
            prop_assert_eq!(value, discriminant(&cubic));
        }

        #[test]
        fn every_cell_has_the_exact_signs(
            velocity in -12f64..3.0, stress in -3f64..12.0, spread in 0f64..3.0, swap in prop::bool::ANY,
        ) {
            let fixed = if swap { paper("0.005", "0.004") } else { paper("0.004", "0.005") };
            let velocities = [0.0, 0.3].map(|x| libm::exp10(velocity + x * spread));
            let stresses = [0.0, 0.1, 0.7, 1.0].map(|x| libm::exp10(stress + x * spread));
            let grid = classify_grid(&fixed, &velocities, &stresses).unwrap();
            let kernel = GridKernel::new(&fixed, &stresses).unwrap();
            for (index, cell) in grid.cells.iter().enumerate() {
                let groups = kernel.point(velocities[index / 4], stresses[index % 4]).groups();
                prop_assert_eq!(cell.transition_sign(), transition_sign(&groups));
                prop_assert_eq!(cell.boundary_sign(), boundary_sign(&groups));
            }
        }
    }

    #[test]
    fn a_grid_point_exactly_on_the_cusp_or_on_the_transition_is_decided_as_zero() {
        let mut fixed = paper("1", "1");
        // a = b = D_c = 1: the cusp η = M V²/σ = 1/8, κ = K/σ = 27/8 at V = 1, σ = 8.
        fixed.critical_slip_distance_m = Rational::from(1);
        fixed.mass_per_area_kg_per_m2 = Rational::from(1);
        fixed.stiffness_pa_per_m = Rational::from(27);
        let grid = classify_grid(&fixed, &[1.0], &[8.0, 9.0]).unwrap();
        assert_eq!(grid.cells[0], SignPair::new(1, 0));
        assert_eq!((grid.counts.exact, grid.counts.f64), (1, 1));
        // K = K_c: κ = (β−1)(1+η) with β = 2, σ = 1, V = 1, M = 26.
        fixed.evolution_effect = Rational::from(2);
        fixed.mass_per_area_kg_per_m2 = Rational::from(26);
        assert_eq!(classify_grid(&fixed, &[1.0], &[1.0]).unwrap().cells[0], SignPair::new(0, -1));
    }

    #[test]
    fn vector_units_and_the_baseline_leave_the_same_bits() {
        let stresses: Vec<f64> = (0..1003).map(|i| libm::exp10(2.0 + 7.0 * f64::from(i) / 1002.0)).collect();
        let kernel = GridKernel::new(&paper("0.004", "0.005"), &stresses).unwrap();
        for exponent in -7..2 {
            let filter = kernel.row_filter(libm::exp10(f64::from(exponent)));
            let mut cells = [vec![SignPair::UNDECIDED; 1003], vec![SignPair::UNDECIDED; 1003]];
            let [plain, vector] = &mut cells;
            RowLoop { filter: &filter, stresses: &kernel.scaled_stresses, cells: plain }.run();
            run_on_widest_unit(RowLoop { filter: &filter, stresses: &kernel.scaled_stresses, cells: vector });
            assert_eq!(plain, vector);
        }
    }

    #[test]
    fn values_that_are_not_positive_and_finite_are_refused() {
        let fixed = paper("0.004", "0.005");
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(classify_grid(&fixed, &[1.0], &[bad]).is_none());
            assert!(classify_grid(&fixed, &[bad], &[1.0]).is_none());
        }
        assert!(classify_grid(&fixed, &[], &[]).unwrap().cells.is_empty());
    }
}
