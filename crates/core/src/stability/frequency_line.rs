//! The line on which the complex pair of eq 8 has a stated ω/ω_n = √T: certified points on it.
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

use std::cmp::Ordering;

use rug::Rational;

use crate::friction::{Groups, Slider};
use crate::number::{Ball, Field, Real, bits_for_digits};
use crate::stability::boundary::{Section, log2, power_of_two, stretch};
use crate::stability::inverse::{Solution, Target, Undecided, Unknown, solve};
use crate::stability::logarithm::log10_one_plus;
use crate::stability::{Asymptote, InertialThreshold};

/// Bits beyond the digits requested.
const GUARD_BITS: u32 = 64;

/// The line of one friction, spring and mass, ready for points of a given number of digits.
///
/// ```
/// use slipmode_core::stability::{FrequencyLine, InertialThreshold};
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let line = FrequencyLine::new(&slider, &InertialThreshold::default(), 20);
/// // Where the line crosses K = K_c, η = T/(1 − T) = 1: at V0 = V_c/√2 and σ = σ_c/2.
/// let crossing = line.transition().unwrap();
/// assert!((crossing.normal_stress_pa.to_f64() / 25e3 - 1.0).abs() < 1e-15);
/// assert!((crossing.groups.inertial_parameter.to_f64() - 1.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone)]
pub struct FrequencyLine {
    slider: Slider<Rational>,
    threshold: InertialThreshold,
    effect_ratio: Rational,
    digits: u32,
}

/// A point of the line, every number enclosed.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct FrequencyLinePoint {
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
    /// The nearer of eqs 18 and 20 times 1/√(1 − T), by the logarithm of V0 at the same σ.
    pub asymptote: Asymptote,
    /// The V0 of this multiple at the same σ, m/s.
    pub asymptote_value: Ball,
    /// exact/asymptote − 1.
    pub relative_error: Ball,
    /// log10(exact/asymptote).
    pub log10_distance: Ball,
}

impl FrequencyLine {
    /// The line ω/ω_n of the threshold, to this many digits where its numbers do not cancel.
    #[must_use]
    pub fn new(slider: &Slider<Rational>, threshold: &InertialThreshold, digits: u32) -> Self {
        Self {
            slider: slider.clone(),
            threshold: threshold.clone(),
            effect_ratio: slider.effect_ratio(),
            digits,
        }
    }

    /// `count` points from the end at eq 20 to the other end, and the crossing of K = K_c between them.
    ///
    /// The parameter is spaced evenly in its logarithm, and reaches so far that the asymptotes are off by about `end_error`.
    #[must_use]
    pub fn sample(&self, count: usize, end_error: f64) -> Vec<FrequencyLinePoint> {
        let bits = bits_for_digits(self.digits) + GUARD_BITS + 4 * (-libm::log2(end_error)) as u32;
        let [low, high] = self.reach_log2(end_error);
        let step = (high - low) / (count.max(2) - 1) as f64;
        let at = |index: usize| power_of_two(high - step * index as f64).with_precision(bits);
        let crossing = self.transition();
        let parameters =
            (0..count).map(at).filter(|parameter| crossing.is_none() || parameter.centre() != &1);
        let (stable, unstable): (Vec<_>, Vec<_>) = parameters
            .map(|parameter| self.at_parameter(&parameter, bits))
            .partition(|point| point.transition_sign > 0);
        stable.into_iter().chain(crossing).chain(unstable).collect()
    }

    /// Where the line crosses K = K_c: η = T/(1 − T), κ = (β − 1)(1 + η); none for a ≥ b.
    #[must_use]
    pub fn transition(&self) -> Option<FrequencyLinePoint> {
        let excess = Rational::from(&self.effect_ratio - 1_u32);
        let squared_ratio = self.threshold.squared_ratio();
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
    pub fn on_section(&self, section: &Section) -> Result<Vec<FrequencyLinePoint>, Undecided> {
        let one = || Rational::from(1);
        let (unknown, [stress, velocity]) = match section {
            Section::AtVelocity(velocity) => (Unknown::NormalStress, [one(), velocity.clone()]),
            Section::AtNormalStress(stress) => (Unknown::LoadingVelocity, [stress.clone(), one()]),
        };
        let parameters = self.slider.at(stress, velocity);
        let target = Target::FrequencyRatio(self.threshold.clone());
        let found = solve(&parameters, unknown, &target, self.digits.saturating_add(GUARD_BITS))?;
        Ok(found.into_iter().map(|solution| self.solved(section, &solution)).collect())
    }

    fn solved(&self, section: &Section, solution: &Solution) -> FrequencyLinePoint {
        let bits = solution.value.precision_bits();
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let (stress, velocity) = match section {
            Section::AtVelocity(velocity) => (solution.value.clone(), ball(velocity)),
            Section::AtNormalStress(stress) => (ball(stress), solution.value.clone()),
        };
        let groups = self.slider.map(ball).at(stress.clone(), velocity.clone()).groups();
        let real_part = match solution.transition_sign {
            0 => Ball::from(0),
            _ => real_part(&groups, &ball(self.threshold.squared_ratio())),
        };
        let row = self.row(solution.transition_sign, real_part, groups, bits);
        FrequencyLinePoint { normal_stress_pa: stress, loading_velocity_m_per_s: velocity, ..row }
    }

    /// log2 of the least and the greatest parameter of a sample: (u − 1)/(β − 1) for b > a, else −x.
    fn reach_log2(&self, end_error: f64) -> [f64; 2] {
        let log2_of = |value: &Rational| log2(&Ball::from_rational(value, GUARD_BITS));
        let beta = log2_of(&self.effect_ratio);
        let rest = log2_of(&(Rational::from(1) - self.threshold.squared_ratio()));
        let excess = || log2_of(&Rational::from(&self.effect_ratio - 1_u32).abs());
        let error = libm::log2(end_error);
        let far = beta - error;
        match self.effect_ratio.cmp(&Rational::from(1)) {
            Ordering::Greater => [1.0 + rest + error - beta, 2.0 * far - rest - excess()],
            Ordering::Equal => [error, far],
            Ordering::Less => [rest + error + excess() - beta, far],
        }
    }

    fn at_parameter(&self, parameter: &Ball, bits: u32) -> FrequencyLinePoint {
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let [beta, squared_ratio] = [&self.effect_ratio, self.threshold.squared_ratio()].map(ball);
        let one = || Ball::from(1);
        let (sign, x, u) = if self.effect_ratio > 1 {
            let u = (beta.clone() - one()) * parameter + one();
            let sign = if parameter.centre() > &1 { 1 } else { -1 };
            (sign, real_part_at(&u, &beta, &squared_ratio), u)
        } else {
            let x = -parameter.clone();
            let u = modulus_at(&x, &beta, &squared_ratio);
            (1, x, u)
        };
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

    fn row(
        &self,
        transition_sign: i8,
        real_part: Ball,
        groups: Groups<Ball>,
        bits: u32,
    ) -> FrequencyLinePoint {
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let velocity_squared = groups.inertial_parameter.clone() / &groups.stiffness_group;
        let normal_stress_pa = ball(&self.slider.stress_scale_pa()) / &groups.stiffness_group;
        let loading_velocity_m_per_s =
            (ball(&self.slider.velocity_scale_squared()) * velocity_squared).sqrt();
        let (asymptote, relative_error) = self.nearer_asymptote(&groups, bits);
        FrequencyLinePoint {
            transition_sign,
            real_part,
            asymptote,
            asymptote_value: loading_velocity_m_per_s.clone() / (Ball::from(1) + &relative_error),
            log10_distance: log10_one_plus(&relative_error),
            relative_error,
            normal_stress_pa,
            loading_velocity_m_per_s,
            groups,
        }
    }

    /// The nearer asymptote and its error: (V_exact/V_asymptote)² = 4(1 − T)ηκ, over (β − 1)² for eq 18.
    fn nearer_asymptote(&self, groups: &Groups<Ball>, bits: u32) -> (Asymptote, Ball) {
        let ball = |value: Rational| Ball::from_rational(&value, bits);
        let rest = ball(Rational::from(1) - self.threshold.squared_ratio());
        let square = (rest * &groups.inertial_parameter * &groups.stiffness_group).times_small(4);
        let error = |square: Ball| {
            // √(1+e) − 1 = e/(1 + √(1+e)) does not cancel for small e.
            let root = square.sqrt();
            (square - Ball::from(1)) / (root + Ball::from(1))
        };
        let lower = error(square.clone());
        let excess = Rational::from(&self.effect_ratio - 1_u32);
        if excess != 0 {
            let upper = error(square / ball(excess.square()));
            if stretch(&upper).upper() < stretch(&lower).lower() {
                return (Asymptote::InertialUpper, upper);
            }
        }
        (Asymptote::InertialLower, lower)
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
