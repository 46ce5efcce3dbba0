//! Inverse questions: which normal stress, loading velocity, stiffness or mass gives a stated behaviour?
//!
//! Along one unknown the coefficients of eq 8 are polynomials over ℚ, and each behaviour is a polynomial equation with
//! conditions on signs. Sturm's theorem counts its positive solutions, so none is missed and none invented.
//! No such equation holds identically: as σ → 0 or V0 → ∞ the roots tend to −V0/D_c and ±iω_n, and for K and M a
//! coefficient of the polynomial is not zero.

mod family;
mod frequency;
mod over_box;
mod pair_roots;
mod root;
mod tails;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;

use rug::Rational;
use thiserror::Error;

use crate::friction::{Parameters, Quantity};
use crate::number::{Ball, Field, bits_for_digits};
use crate::roots::discriminant;
use crate::stability::{Arc, DampingRatio, InertialThreshold};
use family::{Family, hurwitz, shifted};
use frequency::FrequencyCondition;
pub use over_box::{SolutionRange, is_nowhere, solve_over_box};
use root::Root;
use slipmode_algebra::{MOST_BITS, UnivariatePolynomial};

slipmode_algebra::named! {
    /// What is solved for; every solution is positive.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Unknown {
        /// σ, Pa.
        NormalStress = "normal-stress",
        /// V0, m/s.
        LoadingVelocity = "loading-velocity",
        /// K, Pa/m.
        Stiffness = "stiffness",
        /// M, kg/m².
        MassPerArea = "mass",
    }
}

impl From<Unknown> for Quantity {
    fn from(unknown: Unknown) -> Self {
        match unknown {
            Unknown::NormalStress => Self::NormalStress,
            Unknown::LoadingVelocity => Self::LoadingVelocity,
            Unknown::Stiffness => Self::Stiffness,
            Unknown::MassPerArea => Self::MassPerArea,
        }
    }
}

/// What the slider shall do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Target {
    /// The largest Re(s) is this, 1/s; at 0 the slider is on the transition K = K_c (eq 9).
    GrowthRate(Rational),
    /// The discriminant of eq 8 is zero: the boundary max Im(s) = 0.
    Boundary,
    /// The pair's Im(s) is this, 1/s.
    AngularFrequency(Rational),
    /// The pair's Im(s) is 2π times this, Hz.
    Frequency(Rational),
    /// The pair's Im(s) is ω_n times the ratio of this threshold.
    FrequencyRatio(InertialThreshold),
}

slipmode_algebra::named! {
    /// Which roots of eq 8 a solution is about.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum SolutionKind {
        /// A complex pair.
        ComplexPair = "complex-pair",
        /// The largest real root.
        RealRoot = "real-root",
        /// A double root on the upper arc of the boundary.
        UpperArc = "upper-arc",
        /// A double root on the lower arc of the boundary.
        LowerArc = "lower-arc",
    }
}

/// A value of the unknown at which the slider does what it shall.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The value, enclosed to the requested digits.
    pub value: Ball,
    /// The value itself, where it is known to be rational.
    pub exact: Option<Rational>,
    /// The sign of K − K_c there, exact.
    pub transition_sign: i8,
    /// The roots that the target is about.
    pub kind: SolutionKind,
}

/// No precision within the bound separates the solutions.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("undecided: the solutions are not separated with {MOST_BITS} bits")]
pub struct Undecided;

/// All positive values of the unknown for which the slider does what `target` says, ascending; their number is exact.
///
/// The unknown's own value in `parameters` has no effect.
///
/// For a frequency in Hz the coefficients are polynomials in π². As π is transcendental, no sign that has to be decided is
/// zero, so that enclosures of π of enough bits decide the number of solutions as exactly as rationals do.
///
/// # Errors
/// When that takes more bits than the bound allows.
///
/// ```
/// use slipmode_core::stability::inverse::{Target, Unknown, solve};
/// use slipmode_core::{friction::Parameters, number::parse_decimal};
///
/// let number = |text| parse_decimal(text).unwrap();
/// let parameters = Parameters::from(["0.004", "0.006", "1e-5", "1e7", "1000", "1", "1e-3"].map(number));
/// // K = K_c at σ = σ_c − M V0²/(a D_c).
/// let found = solve(&parameters, Unknown::NormalStress, &Target::GrowthRate(number("0")), 20).unwrap();
/// assert_eq!(found[0].exact, Some(number("25000")));
/// ```
pub fn solve(
    parameters: &Parameters<Rational>,
    unknown: Unknown,
    target: &Target,
    digits: u32,
) -> Result<Vec<Solution>, Undecided> {
    let family = Family::new(parameters, unknown);
    let found = match target {
        Target::GrowthRate(rate) => at_growth_rate(&family, rate),
        Target::Boundary => on_boundary(&family, parameters, unknown),
        Target::AngularFrequency(frequency) => {
            let square = Rational::from(frequency.square_ref());
            Ok(of_pair(pair_roots::at_square(&family, |cubic| cubic[3].clone() * &square)))
        }
        Target::FrequencyRatio(threshold) => {
            Ok(of_pair(pair_roots::at_square(&family, of_ratio(parameters, unknown, threshold))))
        }
        Target::Frequency(frequency) => FrequencyCondition::new(&family).at_hertz(frequency).map(of_pair),
    }?;
    solutions(&family, found, digits)
}

/// All positive values of the unknown for which the pair has this damping ratio, ascending; their number is exact.
///
/// # Errors
/// Those of [`solve`].
pub fn at_damping_ratio(
    parameters: &Parameters<Rational>,
    unknown: Unknown,
    ratio: &DampingRatio,
    digits: u32,
) -> Result<Vec<Solution>, Undecided> {
    let family = Family::new(parameters, unknown);
    let found = of_pair(pair_roots::at_squared_ratio(&family, &ratio.value().square()));
    let mut all = solutions(&family, found, digits)?;
    all.retain(|solution| (solution.transition_sign > 0) == (*ratio.value() > 0));
    Ok(all)
}

fn solutions(
    family: &Family,
    found: Vec<(Root, SolutionKind)>,
    digits: u32,
) -> Result<Vec<Solution>, Undecided> {
    let (bits, stability) = (bits_for_digits(digits), family.along(2, |_, cubic| hurwitz(cubic)));
    let mut solutions = Vec::with_capacity(found.len());
    for (root, kind) in found {
        let transition_sign = root.sign_of(&stability)? as i8;
        solutions.push(Solution { value: root.enclosed(bits), exact: root.exact(), transition_sign, kind });
    }
    solutions.sort_by(|one, other| one.value.centre().total_cmp(other.value.centre()));
    Ok(solutions)
}

/// Aω² at (ω/ω_n)² = T, from the coefficients of eq 8: A·TK/M where V0 is the unknown, else T·E·D_c/V0.
fn of_ratio(
    parameters: &Parameters<Rational>,
    unknown: Unknown,
    threshold: &InertialThreshold,
) -> impl Fn(&[Rational; 4]) -> Rational {
    let (power, scale) = match unknown {
        Unknown::LoadingVelocity => (3, parameters.slider.natural_angular_frequency_squared_per_s2()),
        _ => (0, parameters.rate_per_s().recip()),
    };
    let factor = scale * threshold.squared_ratio();
    move |cubic| Rational::from(&cubic[power] * &factor)
}

type RootsFound = Result<Vec<(Root, SolutionKind)>, Undecided>;

fn of_pair(roots: Vec<Root>) -> Vec<(Root, SolutionKind)> {
    roots.into_iter().map(|root| (root, SolutionKind::ComplexPair)).collect()
}

/// Where the rightmost root or pair has this real part.
///
/// About s = g the cubic is A h³ + B′h² + C′h + E′. The other roots lie not to the right of a root h = 0 when B′, C′ ≥ 0
/// (Routh-Hurwitz), and a pair h = ±iω with a third root not to its right means B′C′ = AE′ with B′ ≥ 0 and C′ > 0.
/// Where B′ = 0 as well, h = 0 is a root.
fn at_growth_rate(family: &Family, rate: &Rational) -> RootsFound {
    let coefficient = |index: usize| family.along(1, move |_, cubic| shifted(cubic, rate)[index].clone());
    let (linear, quadratic) = (coefficient(1), coefficient(2));
    let mut found = Vec::new();
    for root in Root::all_of(&coefficient(0)) {
        if root.sign_of(&linear)? != Ordering::Less && root.sign_of(&quadratic)? != Ordering::Less {
            found.push((root, SolutionKind::RealRoot));
        }
    }
    for root in Root::all_of(&family.along(2, |_, cubic| hurwitz(&shifted(cubic, rate)))) {
        if root.sign_of(&linear)? == Ordering::Greater && root.sign_of(&quadratic)? == Ordering::Greater {
            found.push((root, SolutionKind::ComplexPair));
        }
    }
    Ok(found)
}

/// Where eq 8 has a double root r. On the lower arc all roots are below s = −V0/D_c, where eq 8 then rises and is convex.
fn on_boundary(family: &Family, parameters: &Parameters<Rational>, unknown: Unknown) -> RootsFound {
    let coefficient = |index: usize| -> UnivariatePolynomial {
        let at_state = |value: &Rational, cubic: &[Rational; 4]| {
            shifted(cubic, &-family::at(parameters, unknown, value).rate_per_s())[index].clone()
        };
        family.along(2, at_state)
    };
    let (linear, quadratic) = (coefficient(1), coefficient(2));
    let mut found = Vec::new();
    for root in Root::all_of(&family.along(4, |_, cubic| discriminant(cubic))) {
        let is_lower =
            root.sign_of(&linear)? == Ordering::Greater && root.sign_of(&quadratic)? == Ordering::Greater;
        let arc = if is_lower { Arc::Lower } else { Arc::Upper };
        found.push((root, arc.into()));
    }
    Ok(found)
}

impl From<Arc> for SolutionKind {
    fn from(arc: Arc) -> Self {
        match arc {
            Arc::Upper => Self::UpperArc,
            Arc::Lower => Self::LowerArc,
        }
    }
}
