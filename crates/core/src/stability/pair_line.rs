//! The line on which the complex pair of eq 8 has a stated ω/ω_n = √T, or a stated damping ratio ([`damping`]): certified points on it.
//!
//! With p = x ± iy a pair in units of V0/D_c and u = |1 + p|², eq 8 is linear in η and κ and gives
//!
//! * η = (β − u)/(2xu) and κ = (u − 1 − 2x)((1 + 2x)β − u)/(2xu);
//! * y²η = Tκ, which is ω = √T ω_n, exactly where Q(x, u) = 0 with
//!   Q = (T−1)u² + ((1+x)² + β − T(1+β)(1+2x))u + β(T(1+2x)² − (1+x)²).
//!
//! Q is quadratic in u, and in x: Q = (u + β(4T−1))x² + 2(u(1 − T(1+β)) + β(2T−1))x + (T−1)(u−1)(u−β).
//! η, κ and y² = u − (1+x)² are positive
//!
//! * for β > 1 at one x for each u > 1 but u = β: between 0 and √u − 1 for u < β (K < K_c), between −1 − √u and 0 for u > β.
//!   At u = β the line crosses K = K_c with x = 0 and η = T/(1 − T);
//! * for β ≤ 1 at one u for each x < 0, the larger root.
//!
//! Each follows from the signs of Q at the ends of the range: Q = T(q−1)²(q² − β(2q−1)) at x = q − 1, u = q².
//! With σ → 0 the line tends to eq 20 times 1/√(1−T), and for b ≠ a with σ → ∞ to eq 18 times 1/√(1−T).

mod damping;

use std::cmp::Ordering;

use rug::Rational;

use crate::friction::{Groups, Slider};
use crate::number::{Ball, Field, Real, bits_for_digits};
use crate::stability::boundary::{Section, log2, power_of_two, stretch};
use crate::stability::inverse::{Solution, Target, Undecided, at_damping_ratio, solve};
use crate::stability::logarithm::log10_one_plus;
use crate::stability::{Asymptote, InertialThreshold};
use damping::Curve;
pub use damping::DampingRatio;

/// Bits beyond the digits requested.
const GUARD_BITS: u32 = 64;

/// What the pair has all along a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PairRatio {
    /// ω/ω_n of this threshold.
    Frequency(InertialThreshold),
    /// −Re(s)/|s|.
    Damping(DampingRatio),
}

/// The line of one friction, spring and mass, ready for points of a given number of digits.
///
/// ```
/// use slipmode_core::stability::{PairLine, PairRatio, InertialThreshold};
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let line = PairLine::new(&slider, &PairRatio::Frequency(InertialThreshold::default()), 20);
/// // Where the line crosses K = K_c, η = T/(1 − T) = 1: at V0 = V_c/√2 and σ = σ_c/2.
/// let crossing = line.transition().unwrap();
/// assert!((crossing.normal_stress_pa.to_f64() / 25e3 - 1.0).abs() < 1e-15);
/// assert!((crossing.groups.inertial_parameter.to_f64() - 1.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone)]
pub struct PairLine {
    slider: Slider<Rational>,
    ratio: PairRatio,
    effect_ratio: Rational,
    digits: u32,
}

/// A point of the line, every number enclosed.
#[derive(Debug, Clone)]
pub struct PairLinePoint {
    /// The sign of K − K_c: −1 where the oscillation grows, 1 where it decays.
    pub transition_sign: i8,
    /// Re(s) of the pair, in units of V0/D_c.
    pub real_part: Ball,
    /// σ, Pa.
    pub normal_stress_pa: Ball,
    /// V0, m/s.
    pub loading_velocity_m_per_s: Ball,
    /// η, κ, β.
    pub groups: Groups<Ball>,
    /// The nearest asymptote, by the logarithm of V0 or σ: eqs 18 and 20 times 1/√(1 − T) or 1/|ζ|. The line of a damping ratio has
    /// limits of σ as V0 → 0, too, which are eqs 15 and 16 at ζ = ±1.
    pub asymptote: Asymptote,
    /// The V0 of this multiple at the same σ, m/s; or the limit of σ, Pa.
    pub asymptote_value: Ball,
    /// exact/asymptote − 1.
    pub relative_error: Ball,
    /// log10(exact/asymptote).
    pub log10_distance: Ball,
}

impl PairLine {
    /// The line of this ratio, to this many digits where its numbers do not cancel.
    #[must_use]
    pub fn new(slider: &Slider<Rational>, ratio: &PairRatio, digits: u32) -> Self {
        Self { slider: slider.clone(), ratio: ratio.clone(), effect_ratio: slider.effect_ratio(), digits }
    }

    /// `count` points on each curve of the line, from the end at eq 20 where it has one, and the crossing of K = K_c between them.
    ///
    /// The parameter is spaced evenly in its logarithm, and reaches so far that the asymptotes are off by about `end_error`.
    #[must_use]
    pub fn sample(&self, count: usize, end_error: f64) -> Vec<PairLinePoint> {
        let bits = bits_for_digits(self.digits) + GUARD_BITS + 4 * (-libm::log2(end_error)) as u32;
        let crossing = self.transition();
        let mut points = Vec::new();
        for (end, [from, to]) in self.reach_log2(end_error) {
            let step = (to - from) / (count.max(2) - 1) as f64;
            let at = |index: usize| power_of_two(from + step * index as f64).with_precision(bits);
            let parameters =
                (0..count).map(at).filter(|parameter| crossing.is_none() || parameter.centre() != &1);
            points.extend(parameters.map(|parameter| self.at_parameter(end, &parameter, bits)));
        }
        let (stable, unstable): (Vec<_>, Vec<_>) =
            points.into_iter().partition(|point| point.transition_sign > 0);
        stable.into_iter().chain(crossing).chain(unstable).collect()
    }

    /// Where the line crosses K = K_c: η = T/(1 − T), κ = (β − 1)(1 + η); none for a ≥ b, and none of a damping ratio.
    #[must_use]
    pub fn transition(&self) -> Option<PairLinePoint> {
        let excess = Rational::from(&self.effect_ratio - 1_u32);
        let PairRatio::Frequency(threshold) = &self.ratio else { return None };
        let squared_ratio = threshold.squared_ratio();
        let rest = Rational::from(1) - squared_ratio;
        let bits = bits_for_digits(self.digits) + GUARD_BITS;
        let ball = |value: Rational| Ball::from_rational(&value, bits);
        let groups = Groups {
            inertial_parameter: ball(Rational::from(squared_ratio / &rest)),
            stiffness_group: ball(excess.clone() / rest),
            effect_ratio: ball(self.effect_ratio.clone()),
        };
        (excess > 0).then(|| self.row(0, Ball::from(0), groups, bits))
    }

    /// The points at a given V0 in m/s or σ in Pa, ascending in the other coordinate; their number is exact.
    ///
    /// # Errors
    /// When no precision within the bound separates the solutions.
    pub fn on_section(&self, section: &Section) -> Result<Vec<PairLinePoint>, Undecided> {
        let (unknown, parameters) = section.unknown(&self.slider);
        let digits = self.digits.saturating_add(GUARD_BITS);
        let found = match &self.ratio {
            PairRatio::Frequency(threshold) => {
                solve(&parameters, unknown, &Target::FrequencyRatio(threshold.clone()), digits)
            }
            PairRatio::Damping(ratio) => at_damping_ratio(&parameters, unknown, ratio, digits),
        }?;
        Ok(found.into_iter().map(|solution| self.solved(section, &solution)).collect())
    }

    fn solved(&self, section: &Section, solution: &Solution) -> PairLinePoint {
        let bits = solution.value.precision_bits();
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let (stress, velocity) = match section {
            Section::AtVelocity(velocity) => (solution.value.clone(), ball(velocity)),
            Section::AtNormalStress(stress) => (ball(stress), solution.value.clone()),
        };
        let groups = self.slider.map(ball).at(stress.clone(), velocity.clone()).groups();
        let real_part = match &self.ratio {
            _ if solution.transition_sign == 0 => Ball::from(0),
            PairRatio::Frequency(threshold) => real_part(&groups, &ball(threshold.squared_ratio())),
            PairRatio::Damping(ratio) => ratio.real_part(&groups, bits),
        };
        let row = self.row(solution.transition_sign, real_part, groups, bits);
        PairLinePoint { normal_stress_pa: stress, loading_velocity_m_per_s: velocity, ..row }
    }

    /// The curves of the line with the reach of a sample, from the end at eq 20 on.
    fn reach_log2(&self, end_error: f64) -> Vec<Curve> {
        match &self.ratio {
            PairRatio::Frequency(threshold) => {
                vec![(None, self.frequency_reach_log2(threshold, end_error))]
            }
            PairRatio::Damping(ratio) => ratio.reach_log2(&self.effect_ratio, end_error),
        }
    }

    /// The parameter is (u − 1)/(β − 1) for b > a, else −x.
    fn frequency_reach_log2(&self, threshold: &InertialThreshold, end_error: f64) -> [f64; 2] {
        let log2_of = |value: &Rational| log2(&Ball::from_rational(value, GUARD_BITS));
        let beta = log2_of(&self.effect_ratio);
        let rest = log2_of(&(Rational::from(1) - threshold.squared_ratio()));
        let excess = || log2_of(&Rational::from(&self.effect_ratio - 1_u32).abs());
        let error = libm::log2(end_error);
        let far = beta - error;
        match self.effect_ratio.cmp(&Rational::from(1)) {
            Ordering::Greater => [2.0 * far - rest - excess(), 1.0 + rest + error - beta],
            Ordering::Equal => [far, error],
            Ordering::Less => [far, rest + error + excess() - beta],
        }
    }

    fn at_parameter(&self, end: Option<Asymptote>, parameter: &Ball, bits: u32) -> PairLinePoint {
        let one = || Ball::from(1);
        let beta = Ball::from_rational(&self.effect_ratio, bits);
        let [x, u] = match &self.ratio {
            PairRatio::Damping(ratio) => ratio.at(end, parameter, &self.effect_ratio, bits),
            PairRatio::Frequency(threshold) => {
                let squared_ratio = Ball::from_rational(threshold.squared_ratio(), bits);
                if self.effect_ratio > 1 {
                    let u = (beta.clone() - one()) * parameter + one();
                    [real_part_at(&u, &beta, &squared_ratio), u]
                } else {
                    let x = -parameter.clone();
                    let u = modulus_at(&x, &beta, &squared_ratio);
                    [x, u]
                }
            }
        };
        let sign = if x.centre().is_sign_negative() { 1 } else { -1 };
        let twice = x.clone().times_small(2);
        let next = twice.clone() + one();
        let denominator = twice * &u;
        let groups = Groups {
            inertial_parameter: (beta.clone() - &u) / &denominator,
            stiffness_group: (u.clone() - &next) * (next * &beta - &u) / denominator,
            effect_ratio: beta,
        };
        self.row(sign, x, groups, bits)
    }

    fn row(&self, transition_sign: i8, real_part: Ball, groups: Groups<Ball>, bits: u32) -> PairLinePoint {
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let velocity_squared = groups.inertial_parameter.clone() / &groups.stiffness_group;
        let normal_stress_pa = ball(&self.slider.stress_scale_pa()) / &groups.stiffness_group;
        let loading_velocity_m_per_s =
            (ball(&self.slider.velocity_scale_squared()) * velocity_squared).sqrt();
        let (asymptote, relative_error) = self.nearest_asymptote(&groups, bits);
        let value = if asymptote.is_quasi_static() { &normal_stress_pa } else { &loading_velocity_m_per_s };
        PairLinePoint {
            transition_sign,
            real_part,
            asymptote,
            asymptote_value: value.clone() / (Ball::from(1) + &relative_error),
            log10_distance: log10_one_plus(&relative_error),
            relative_error,
            normal_stress_pa,
            loading_velocity_m_per_s,
            groups,
        }
    }

    /// The nearest asymptote and its error: (V_exact/V_asymptote)² = 4(1 − T)ηκ or 4ζ²ηκ, over (β − 1)² for eq 18.
    fn nearest_asymptote(&self, groups: &Groups<Ball>, bits: u32) -> (Asymptote, Ball) {
        let ball = |value: Rational| Ball::from_rational(&value, bits);
        let (factor, tends_to, limits) = match &self.ratio {
            PairRatio::Frequency(threshold) => {
                (Rational::from(1) - threshold.squared_ratio(), [true, true], Vec::new())
            }
            PairRatio::Damping(ratio) => {
                (ratio.squared(), ratio.tends_to(&self.effect_ratio), ratio.limits(&self.effect_ratio, bits))
            }
        };
        let square = (ball(factor) * &groups.inertial_parameter * &groups.stiffness_group).times_small(4);
        let error = |square: Ball| {
            // √(1+e) − 1 = e/(1 + √(1+e)) does not cancel for small e.
            let root = square.sqrt();
            (square - Ball::from(1)) / (root + Ball::from(1))
        };
        let excess = Rational::from(&self.effect_ratio - 1_u32);
        let [lower, upper] = tends_to;
        let lower = lower.then(|| (Asymptote::InertialLower, error(square.clone())));
        let upper =
            (upper && excess != 0).then(|| (Asymptote::InertialUpper, error(square / ball(excess.square()))));
        let limit = |(asymptote, modulus): (Asymptote, Ball)| {
            (asymptote, modulus.square() / &groups.stiffness_group - Ball::from(1))
        };
        let all = lower.into_iter().chain(upper).chain(limits.into_iter().map(limit));
        all.reduce(
            |best, other| {
                if stretch(&other.1).upper() < stretch(&best.1).lower() { other } else { best }
            },
        )
        .unwrap_or((Asymptote::InertialLower, Ball::from(0)))
    }
}

/// x at this u for β > 1: the root of Q in x at which Q falls.
fn real_part_at(u: &Ball, beta: &Ball, squared_ratio: &Ball) -> Ball {
    let one = || Ball::from(1);
    let quadratic = u.clone() + (squared_ratio.clone().times_small(4) - one()) * beta;
    let linear =
        (one() - (one() + beta) * squared_ratio) * u + (squared_ratio.clone().times_small(2) - one()) * beta;
    let constant = (squared_ratio.clone() - one()) * (u.clone() - one()) * (u.clone() - beta);
    let root = (linear.square() - quadratic.clone() * &constant).sqrt();
    // Of the two forms of one root, the one that does not cancel; where the leading coefficient is zero, it is the second.
    if linear.centre().is_sign_positive() { -(linear + root) / quadratic } else { constant / (root - linear) }
}

/// u at this x < 0: the larger root of Q in u.
fn modulus_at(x: &Ball, beta: &Ball, squared_ratio: &Ball) -> Ball {
    let one = || Ball::from(1);
    let rest = one() - squared_ratio;
    let [square, next] = [(x.clone() + one()).square(), x.clone().times_small(2) + one()];
    let linear = square.clone() + beta - (one() + beta) * squared_ratio * &next;
    let constant = (next.square() * squared_ratio - square) * beta;
    let root = (linear.square() + (rest.clone() * &constant).times_small(4)).sqrt();
    if linear.centre().is_sign_positive() {
        (linear + root) / rest.times_small(2)
    } else {
        constant.times_small(2) / (root - linear)
    }
}

/// x of a point of the line, where y² = Tκ/η: both parts of eq 8 at p = x + iy, divided as polynomials in x.
///
/// The divisor is η²((x − t)² + 9y²) with the real root t, which is positive.
fn real_part(groups: &Groups<Ball>, squared_ratio: &Ball) -> Ball {
    let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } = groups;
    let one = || Ball::from(1);
    let [quadratic, linear] = [one() + eta, kappa.clone() + one() - beta];
    let product = eta.clone() * kappa;
    let dividend = product.clone().times_small(9)
        - quadratic.clone() * &linear
        - (quadratic.clone() * squared_ratio * kappa).times_small(8);
    let divisor =
        quadratic.square() - (linear * eta).times_small(3) + (product * squared_ratio).times_small(12);
    dividend / divisor.times_small(2)
}

#[cfg(test)]
mod tests;
