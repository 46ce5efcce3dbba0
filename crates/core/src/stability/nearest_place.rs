//! The place of the boundary that is nearest to a point in ln σ at the same V0, and how far the nearer asymptote is off there.
//!
//! At given V0 the ratio g = η/κ is given, and λ solves the equation of `parameter_equation` for it. In ln λ the quotient
//! left/right is monotone along the upper arc and turns once, at the cusp, along the lower one, so that Newton's
//! method in logarithms cannot miss. All terms of either side are positive: 64-bit numbers hold each side to some units in the
//! last place, and the sign of their difference at λ(1 ± δ) certifies the root. What 64-bit cannot certify goes to the
//! enclosures of [`BoundaryCurve`].

use rug::{Float, Rational};

use super::boundary::{BoundaryCurve, BoundaryPoint, Section};
use super::{Arc, ArcFrame, Asymptote};
use crate::friction::Parameters;
use crate::number::{Dd, Field};

/// A place of the boundary as a point at the same V0 sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestPlace {
    /// log10(σ_boundary/σ).
    pub log10_normal_stress_distance: f64,
    /// The arc it lies on.
    pub arc: Arc,
    /// The nearer asymptote by log10 distance, as in [`BoundaryPoint`].
    pub asymptote: Asymptote,
    /// exact/asymptote − 1: of σ for eqs 15 and 16, of V0 for eqs 18 and 20.
    pub relative_error: f64,
}

/// 64-bit numbers cannot certify the answer; [`NearestPlace::of`] can.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Uncertain;

impl NearestPlace {
    /// The place and its error to [`Self::CERTAIN`]; none where no σ is on the boundary at this V0 (a = b beyond the cusp).
    #[must_use]
    pub fn of(parameters: &Parameters<Rational>) -> Option<Self> {
        let rounded = parameters.map(Dd::from_rational);
        // Effects that differ beyond double-double's digits are not equal ones: these have no upper arc.
        let seem_equal = rounded.slider.direct_effect == rounded.slider.evolution_effect;
        let are_equal = parameters.slider.direct_effect == parameters.slider.evolution_effect;
        let quick = if seem_equal && !are_equal { Err(Uncertain) } else { Self::quickly(&rounded) };
        quick.unwrap_or_else(|Uncertain| {
            nearest_boundary_point(parameters, DIGITS)
                .map(|point| Self::of_point(&point, &parameters.point.normal_stress_pa))
        })
    }

    /// How well the numbers are known: absolutely, and relatively too where the error does not change sign nearby.
    pub const CERTAIN: f64 = 1e-9;

    /// The same in a microsecond from inputs that are each within a relative [`Dd::UNIT`] of the true ones; a and b that are
    /// the same double-double are taken to be equal.
    ///
    /// # Errors
    /// Where a and b differ so little that their difference is not known to 64-bit's digits, next to the cusp, half-way between two places, where both asymptotes are equally far, and beyond the range of 64-bit.
    pub fn quickly(parameters: &Parameters<Dd>) -> Result<Option<Self>, Uncertain> {
        let groups = parameters.groups().map(Dd::hi);
        let all = [groups.inertial_parameter, groups.stiffness_group, groups.effect_ratio];
        if !all.iter().all(|group| (1e-40..1e40).contains(group)) {
            return Err(Uncertain);
        }
        let excess = parameters.slider.effect_difference() / parameters.slider.direct_effect;
        if excess.hi() != 0.0 && excess.hi().abs() < LEAST_EXCESS {
            return Err(Uncertain);
        }
        let line = Line {
            frame: ArcFrame::new(excess.hi(), groups.effect_ratio.sqrt()),
            velocity_squared: groups.inertial_parameter / groups.stiffness_group,
        };
        let distances = |(arc, parameter)| {
            let (inverse_stiffness_group, _) = line.frame.place(arc, &parameter);
            (arc, parameter, groups.stiffness_group * inverse_stiffness_group)
        };
        let places = line.places()?;
        let mut nearest: Option<(Arc, f64, f64)> = None;
        for place in places.into_iter().flatten().map(distances) {
            nearest = Some(match nearest {
                None => place,
                Some(other) if clearly_less(stretch(place.2), stretch(other.2))? => place,
                Some(other) => other,
            });
        }
        nearest.map(|(arc, parameter, ratio)| line.place(arc, parameter, ratio)).transpose()
    }

    fn of_point(point: &BoundaryPoint, stress: &Rational) -> Self {
        let ratio = Float::with_val(80, point.normal_stress_pa.centre() / Float::with_val(80, stress));
        Self {
            // not f64: MPFR's logarithm.
            log10_normal_stress_distance: ratio.log10().to_f64(),
            arc: point.arc,
            asymptote: point.asymptote,
            relative_error: point.relative_error.to_f64(),
        }
    }
}

/// |b/a − 1| below this loses 64-bit's digits to the rounding of a and b: 2 · 2^-102 / 2^-48 is 2^-53.
const LEAST_EXCESS: f64 = 1.0 / (1u64 << 48) as f64;

/// Digits of the certified way: the distance of two nearby σ loses some.
const DIGITS: u32 = 20;

/// The place of the boundary at the same V0 whose σ is nearest in its logarithm, enclosed to this many digits.
#[must_use]
pub fn nearest_boundary_point(parameters: &Parameters<Rational>, digits: u32) -> Option<BoundaryPoint> {
    let stress = Float::with_val(64, &parameters.point.normal_stress_pa);
    let stretch = |place: &BoundaryPoint| {
        let ratio = Float::with_val(64, place.normal_stress_pa.centre() / &stress);
        if ratio < 1 { ratio.recip() } else { ratio }
    };
    BoundaryCurve::new(&parameters.slider, digits)
        .on_section(&Section::AtVelocity(parameters.point.loading_velocity_m_per_s.clone()))
        .into_iter()
        .min_by(|one, other| stretch(one).total_cmp(&stretch(other)))
}

/// The line of given V0 through the boundary of one β.
struct Line {
    frame: ArcFrame<f64>,
    /// g = η/κ.
    velocity_squared: f64,
}

/// How far next to a root the sign has to be certain: λ is then known to this, and no error or σ changes by more than four times as much.
const BESIDE: f64 = 1.0 / (1u64 << 34) as f64;
/// Relative error of the difference of two sides, in terms of their sum: each has less than 40 roundings of 2⁻⁵³.
const SIDES: f64 = 1.0 / (1u64 << 46) as f64;
/// A bound on Newton steps; fewer than ten suffice where the root is simple.
const MOST_STEPS: usize = 40;

impl Line {
    /// λ of the places: on the upper arc, on the lower one before the cusp, and after it.
    fn places(&self) -> Result<[Option<(Arc, f64)>; 3], Uncertain> {
        let (q, sum) = (self.frame.root_ratio, self.frame.sum);
        let upper_end = self.velocity_squared * self.frame.difference.square();
        let lower_end = self.velocity_squared * sum.square();
        let upper = if upper_end == 0.0 {
            None
        } else {
            // The two ends of the arc: λ²·gd² = 1 and λ·gd²q = 1.
            let start = (1.0 / upper_end.sqrt()).min(1.0 / (upper_end * q));
            Some((Arc::Upper, self.root(Arc::Upper, start, 1)?))
        };
        if self.sign(Arc::Lower, self.cusp())? > 0 {
            return Ok([upper, None, None]);
        }
        // Either start is outside the two roots, where left/right > 1 and Newton's steps cannot overshoot.
        let quasi_static = self.root(Arc::Lower, 1.0 / (lower_end * q), 1)?;
        let inertial = self.root(Arc::Lower, sum * self.velocity_squared.sqrt(), -1)?;
        Ok([upper, Some((Arc::Lower, quasi_static)), Some((Arc::Lower, inertial))])
    }

    /// λ of the cusp: r = −1 − v with v³ = β(3v + 2), and λ = A/(v − q); from above, Newton's steps descend to v.
    fn cusp(&self) -> f64 {
        let q = self.frame.root_ratio;
        let beta = q.square();
        let mut v = (3.0 * beta).sqrt() + libm::cbrt(2.0 * beta);
        for _ in 0..MOST_STEPS {
            let next = v - (v * v.square() - beta * (3.0 * v + 2.0)) / (3.0 * (v.square() - beta));
            let moved = v - next;
            v = next;
            // Once within some units of the last place the steps turn to noise.
            if moved <= 1e-15 * v {
                break;
            }
        }
        self.frame.sum / (v - q)
    }

    /// Left and right side of the arc's equation, each a sum of positive terms.
    fn sides(&self, arc: Arc, parameter: f64) -> (f64, f64) {
        let (linear, cubic) = self.polynomials(parameter);
        let next = (1.0 + parameter).square();
        let here = parameter.square();
        match arc {
            Arc::Upper => {
                (self.velocity_squared * self.frame.difference.square() * here * cubic, next * linear)
            }
            Arc::Lower => (self.velocity_squared * self.frame.sum.square() * next * cubic, here * linear),
        }
    }

    /// B = A + 2qλ and P = A + 2qAλ + 2q²λ².
    fn polynomials(&self, parameter: f64) -> (f64, f64) {
        let (twice, sum) = (2.0 * self.frame.root_ratio * parameter, self.frame.sum);
        (sum + twice, sum + twice * sum + twice * self.frame.root_ratio * parameter)
    }

    /// d ln(left/right)/d ln λ.
    fn slope(&self, arc: Arc, parameter: f64) -> f64 {
        let (q, sum) = (self.frame.root_ratio, self.frame.sum);
        let (linear, cubic) = self.polynomials(parameter);
        let x = q * parameter;
        let shared = (2.0 * x * sum + 4.0 * x * q * parameter) / cubic - 2.0 * x / linear;
        let turning = 2.0 / (1.0 + parameter);
        match arc {
            Arc::Upper => shared + turning,
            Arc::Lower => shared - turning,
        }
    }

    /// The sign of left − right, when it is certain.
    fn sign(&self, arc: Arc, parameter: f64) -> Result<i8, Uncertain> {
        let (left, right) = self.sides(arc, parameter);
        let difference = left - right;
        match difference.abs() > SIDES * (left + right) && (left + right).is_finite() {
            true => Ok(if difference > 0.0 { 1 } else { -1 }),
            false => Err(Uncertain),
        }
    }

    /// The root reached from `start`, certified: the sign beyond it, towards larger λ, is `beyond`, and the other one before it.
    fn root(&self, arc: Arc, start: f64, beyond: i8) -> Result<f64, Uncertain> {
        let mut parameter = start;
        for _ in 0..MOST_STEPS {
            let (left, right) = self.sides(arc, parameter);
            let step = libm::log(left / right) / self.slope(arc, parameter);
            parameter *= libm::exp(-step);
            // Steps converge quadratically: after one of 10⁻⁸ the rest is rounding.
            if step.abs() < 1e-8 || !step.is_finite() {
                break;
            }
        }
        let certified = self.sign(arc, parameter * (1.0 + BESIDE))? == beyond
            && self.sign(arc, parameter * (1.0 - BESIDE))? == -beyond;
        if certified { Ok(parameter) } else { Err(Uncertain) }
    }

    /// The place at λ, whose σ is `ratio` times the point's.
    fn place(&self, arc: Arc, parameter: f64, ratio: f64) -> Result<NearestPlace, Uncertain> {
        let of_square = self.frame.inertial_error_of_square(arc, &parameter);
        let inertial = of_square / ((1.0 + of_square).sqrt() + 1.0);
        let quasi_static = self.frame.quasi_static_error(arc, &parameter);
        let inertial_is_nearer = clearly_less(stretch(1.0 + inertial), stretch(1.0 + quasi_static))?;
        let (asymptote, relative_error) = if inertial_is_nearer {
            (Asymptote::inertial(arc), inertial)
        } else {
            (Asymptote::quasi_static(arc), quasi_static)
        };
        let log10_normal_stress_distance = libm::log10(ratio);
        Ok(NearestPlace { log10_normal_stress_distance, arc, asymptote, relative_error })
    }
}

/// max(x, 1/x).
fn stretch(ratio: f64) -> f64 {
    if ratio < 1.0 { 1.0 / ratio } else { ratio }
}

/// Whether one number is less than the other, when they are not nearly equal.
fn clearly_less(one: f64, other: f64) -> Result<bool, Uncertain> {
    let apart = (one - other).abs() > NearestPlace::CERTAIN * other;
    if apart { Ok(one < other) } else { Err(Uncertain) }
}

#[cfg(test)]
mod tests;
