//! Stability of steady sliding under the original scheme, and what its step does to the points of fig 3a.
//!
//! A step of the scheme, linearised about steady sliding, is a 3 × 3 matrix on (u, y, ζ), the same for both laws. With
//! c = (1 − cos ωh)/(κh), s = sin(ωh)/(ωh), d = e^{−h} and N = 1 + c(1 − β(1 − d)) the mean velocity of the step is
//!
//! ```text
//! x = (s u − cβd y + c ζ)/N      y' = d y − (1 − d) x      ζ' = ζ − κh x      u' = cos(ωh) u + (ζ − x − βy') sin(ωh) ω/κ
//! ```
//!
//! A pair of its eigenvalues leaves the unit circle where 1 − a1 + a0 a2 − a0² = 0, for λ³ + a2 λ² + a1 λ + a0.

use rayon::prelude::*;
use rug::Float;

use super::long_term::{converged_cycle, scheme_peak, steps_needed};
use crate::paper::{exactly, model_at};
use slipmode::scene::{LogAxis, PlanePoint, Rectangle};
use slipmode_core::friction::{EvolutionLaw, Groups, Slider};
use slipmode_core::number::{Rational, nearest_f64};

/// Bits of the eigenvalue conditions: the third power of a step of 1e-12 is still far from rounding.
const BITS: u32 = 256;

/// The most steps of a run of the scheme at a point of the map.
const MAP_STEPS: f64 = 1e5;

/// Half-way between the log of a peak that stayed and one that vanished, e^{-1} of ours.
const LOST: f64 = -1.0;

/// The points of fig 3a under one law and one step of the scheme.
#[derive(Debug, Clone, PartialEq)]
pub struct SchemeMapRow {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// Step in units of √(M/K).
    pub fraction: f64,
    /// Points of the map.
    pub points: usize,
    /// Points at which steady sliding is stable under the scheme and unstable in truth, or the reverse.
    pub flipped: usize,
    /// Limit cycles at which the scheme was run.
    pub cycles: usize,
    /// Limit cycles left out because the scheme would take too many steps.
    pub left_out: usize,
    /// Limit cycles that the scheme lost or could not follow.
    pub lost: usize,
    /// Least and largest ln of the scheme's long-term peak over ours.
    pub bias_range: Option<[f64; 2]>,
    /// Median of its size.
    pub median_bias: Option<f64>,
}

/// 1 − a1 + a0 a2 − a0²: positive when the pair of the scheme's eigenvalues lies inside the unit circle.
fn margin(groups: &Groups<Rational>, fraction: &Float) -> Float {
    let number = |value: &Rational| Float::with_val(BITS, value);
    let [eta, kappa, beta] =
        [&groups.inertial_parameter, &groups.stiffness_group, &groups.effect_ratio].map(number);
    let frequency = Float::with_val(BITS, &kappa / &eta).sqrt();
    let h = Float::with_val(BITS, fraction / &frequency);
    // not f64: MPFR's.
    let (sine, cosine) = fraction.clone().sin_cos(Float::new(BITS));
    let d = Float::with_val(BITS, -&h).exp();
    let c = (Float::with_val(BITS, 1) - &cosine) / (Float::with_val(BITS, &kappa * &h));
    let s = Float::with_val(BITS, &sine / fraction);
    let one_less_d = Float::with_val(BITS, 1) - &d;
    let norm = Float::with_val(BITS, 1)
        + &c * (Float::with_val(BITS, 1) - Float::with_val(BITS, &beta * &one_less_d));
    let x = [s / &norm, -(c.clone() * &beta * &d) / &norm, c / &norm];
    let y: [Float; 3] = std::array::from_fn(|i| {
        let kept = if i == 1 { d.clone() } else { Float::new(BITS) };
        kept - Float::with_val(BITS, &one_less_d * &x[i])
    });
    let travel = Float::with_val(BITS, &kappa * &h);
    let z: [Float; 3] = std::array::from_fn(|i| {
        Float::with_val(BITS, u32::from(i == 2)) - Float::with_val(BITS, &travel * &x[i])
    });
    let pull = sine * frequency / &kappa;
    let u: [Float; 3] = std::array::from_fn(|i| {
        let imbalance =
            Float::with_val(BITS, u32::from(i == 2)) - &x[i] - Float::with_val(BITS, &beta * &y[i]);
        let kept = if i == 0 { cosine.clone() } else { Float::new(BITS) };
        kept + Float::with_val(BITS, &pull * &imbalance)
    });
    let matrix = [u, y, z];
    let minor = |i: usize, j: usize| {
        Float::with_val(BITS, &matrix[i][i] * &matrix[j][j])
            - Float::with_val(BITS, &matrix[i][j] * &matrix[j][i])
    };
    let a2 = -(matrix[0][0].clone() + &matrix[1][1] + &matrix[2][2]);
    let a1 = minor(0, 1) + minor(0, 2) + minor(1, 2);
    let a0 = -determinant(&matrix);
    Float::with_val(BITS, 1) - a1 + a0.clone() * a2 - Float::with_val(BITS, a0.square_ref())
}

fn determinant(m: &[[Float; 3]; 3]) -> Float {
    let cofactor = |i: usize, j: usize| {
        Float::with_val(BITS, &m[1][i] * &m[2][j]) - Float::with_val(BITS, &m[1][j] * &m[2][i])
    };
    m[0][0].clone() * cofactor(1, 2) - m[0][1].clone() * cofactor(0, 2) + m[0][2].clone() * cofactor(0, 1)
}

/// K_c of the scheme over the true K_c, less 1, at the velocity of these groups; none when it is not within a factor of two.
///
/// η is that of the point with K = K_c; K alone is moved, the step stays at `fraction`·√(M/K).
#[must_use]
pub fn critical_shift(inertial_parameter: &Rational, effect_ratio: &Rational, fraction: f64) -> Option<f64> {
    let critical = Rational::from(effect_ratio - 1) * Rational::from(inertial_parameter + 1);
    let fraction = Float::with_val(BITS, fraction);
    let stable = |ratio: &Rational| {
        let groups = Groups {
            inertial_parameter: inertial_parameter.clone(),
            stiffness_group: critical.clone() * ratio,
            effect_ratio: effect_ratio.clone(),
        };
        margin(&groups, &fraction).is_sign_positive()
    };
    let (mut low, mut high) = (Rational::from((1, 2)), Rational::from(2));
    if stable(&low) || !stable(&high) {
        return None;
    }
    for _ in 0..50 {
        let middle = Rational::from(&low + &high) / 2;
        if stable(&middle) { high = middle } else { low = middle }
    }
    Some(nearest_f64(&(low - Rational::from(1))))
}

/// The scheme's critical stiffness at one velocity and step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SchemeTransition {
    /// Loading velocity, m/s.
    pub loading_velocity_m_per_s: f64,
    /// Step in units of √(M/K).
    pub fraction: f64,
    /// K_c of the scheme over the true one, less 1.
    pub shift: f64,
}

/// By velocity, where K = K_c exists, then by step.
pub(crate) fn transitions(
    parameters: &Slider<Rational>,
    axis: &LogAxis,
    fractions: &[f64],
) -> Vec<SchemeTransition> {
    let beta = parameters.effect_ratio();
    let mut found = Vec::new();
    for velocity in axis.coordinates() {
        // η/κ = M V²/(K D_c²) does not contain σ, and κ = (β − 1)(1 + η) on the line.
        let groups = parameters.at(Rational::from(1), exactly(velocity)).groups();
        let slope = groups.inertial_parameter / groups.stiffness_group * Rational::from(&beta - 1);
        if slope <= 0 || slope >= 1 {
            continue;
        }
        let inertial = slope.clone() / (Rational::from(1) - slope);
        found.extend(fractions.iter().filter_map(|&fraction| {
            let shift = critical_shift(&inertial, &beta, fraction)?;
            Some(SchemeTransition { loading_velocity_m_per_s: velocity, fraction, shift })
        }));
    }
    found
}

/// Every point of the rectangle, by law and step.
pub(crate) fn map_rows(
    parameters: &Slider<Rational>,
    rectangle: &Rectangle,
    fractions: &[f64],
) -> Vec<SchemeMapRow> {
    let velocities = rectangle.loading_velocity_m_per_s.coordinates();
    let stresses = rectangle.normal_stress_pa.coordinates();
    let places: Vec<(f64, f64)> =
        stresses.iter().flat_map(|&s| velocities.iter().map(move |&v| (v, s))).collect();
    let rows = EvolutionLaw::ALL.into_iter().flat_map(|law| fractions.iter().map(move |&f| (law, f)));
    let flips: Vec<usize> = fractions.iter().map(|&f| flipped(parameters, &places, f)).collect();
    rows.zip(flips.iter().cycle())
        .map(|((law, fraction), &flipped)| map_row(parameters, &places, law, fraction, flipped))
        .collect()
}

/// Points whose stability the scheme gets wrong.
fn flipped(parameters: &Slider<Rational>, places: &[(f64, f64)], fraction: f64) -> usize {
    let fraction = Float::with_val(BITS, fraction);
    let wrong = |&&(velocity, stress): &&(f64, f64)| {
        let groups = parameters.at(exactly(stress), exactly(velocity)).groups();
        parameters.has_transition()
            && (groups.transition_margin() > 0) != margin(&groups, &fraction).is_sign_positive()
    };
    places.par_iter().filter(wrong).count()
}

/// How the scheme fared on one limit cycle.
enum Fate {
    LeftOut,
    Lost,
    Bias(f64),
}

fn map_row(
    parameters: &Slider<Rational>,
    places: &[(f64, f64)],
    law: EvolutionLaw,
    fraction: f64,
    flipped: usize,
) -> SchemeMapRow {
    let fates: Vec<Fate> = places
        .par_iter()
        .filter_map(|&(velocity, stress)| {
            let place =
                PlanePoint { loading_velocity_m_per_s: exactly(velocity), normal_stress_pa: exactly(stress) };
            let model = model_at(parameters, &place, law);
            let cycle = converged_cycle(&model)?;
            if steps_needed(&model, &cycle, fraction) > MAP_STEPS {
                return Some(Fate::LeftOut);
            }
            let bias = scheme_peak(&model, &cycle, fraction).map(|peak| peak.log_peak - cycle.orbit.peak);
            Some(bias.ok().filter(|&bias| bias > LOST).map_or(Fate::Lost, Fate::Bias))
        })
        .collect();
    let mut biases: Vec<f64> = fates
        .iter()
        .filter_map(|fate| if let Fate::Bias(bias) = fate { Some(*bias) } else { None })
        .collect();
    biases.sort_by(f64::total_cmp);
    let bias_range = biases.first().zip(biases.last()).map(|(&low, &high)| [low, high]);
    let mut sizes: Vec<f64> = biases.iter().map(|bias| bias.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let left_out = fates.iter().filter(|fate| matches!(fate, Fate::LeftOut)).count();
    SchemeMapRow {
        law,
        fraction,
        points: places.len(),
        flipped,
        cycles: fates.len() - left_out,
        left_out,
        lost: fates.iter().filter(|fate| matches!(fate, Fate::Lost)).count(),
        bias_range,
        median_bias: sizes.get(sizes.len() / 2).copied(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_critical_stiffness_of_the_scheme_comes_to_the_true_one_at_first_order() {
        let (inertial, ratio) = (Rational::from((1, 100)), Rational::from((3, 2)));
        let shifts =
            [0.1, 0.05, 0.025, 0.0125, 0.00625].map(|f| critical_shift(&inertial, &ratio, f).unwrap());
        // At first order the ratio of two shifts is 2 up to a remainder that halves with the step, too.
        let from_two: Vec<f64> = shifts.windows(2).map(|pair| 2.0 - pair[0] / pair[1]).collect();
        for pair in from_two.windows(2) {
            assert!((pair[0] / pair[1] - 2.0).abs() < 0.5, "{from_two:?}");
        }
        assert!(from_two.last().is_some_and(|last| last.abs() < 0.1), "{from_two:?}");
    }
}
