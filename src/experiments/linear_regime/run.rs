//! Small disturbances of the nonlinear slider against the roots of eq 8: every root, both laws, a series of amplitudes.
//!
//! A run starts along an eigenvector of one root and ends after the time in which that mode, or the fastest growing
//! one, changes by about a factor of e. The equations know nothing of modes: the growth rate and frequency of what they do come
//!
//! - from the amplitude w·u of the mode at the two ends, ln(w·u(T)/w·u(0))/T, and
//! - from the states at 0, T and 2T alone, without any eigenvector: u(T) = e^{pT} u(0), or the recurrence
//!   u(2T) = s u(T) − q u(0) of a pair, fitted by least squares.
//!
//! Quadratic terms shift both by a relative amount in proportion to the size of the start. The coefficient follows from
//! second-order perturbation theory, so that the law *mismatch ∝ amplitude* is predicted with its constant, not fitted.

use crate::parallel;
use rug::{Complex, Float};

use crate::experiments::linear_regime::LinearRegimeSection;
use crate::experiments::linear_regime::modes::{BITS, Direction, Mode, ROOT_DIGITS};
use crate::experiments::linear_regime::snapshots::{projected_rate, rate_of_snapshots, snapshots};
use crate::experiments::linear_regime::steady_sliding::{SteadyRun, steady_sliding};
use crate::scene::PlanePoint;
use slipmode_core::dynamics::{Failure, Model, Radau};
use slipmode_core::friction::{EvolutionLaw, Groups, Slider};
use slipmode_core::number::{Dd, Rational, nearest_f64};
use slipmode_core::roots::certified_roots;
use slipmode_core::stability::{InertialThreshold, SlipMode, classify};

/// Local tolerance of the runs in double-double, relative to the state.
const FINE: f64 = 1e-20;

/// Local tolerance of the runs in 64-bit, relative to the state.
const COARSE: f64 = 1e-13;

/// One amplitude of one start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mismatch {
    /// Largest of |x|, |y|, |ζ| at the start.
    pub amplitude: f64,
    /// Error of the growth rate by projection, relative to |p|.
    pub growth: f64,
    /// Error of the angular frequency by projection, relative to |p|.
    pub frequency: f64,
    /// Error of the rate from the snapshots alone, relative to |p|.
    pub snapshots: f64,
}

impl Mismatch {
    /// |p_measured − p|/|p| by projection.
    pub(crate) fn size(&self) -> f64 {
        libm::hypot(self.growth, self.frequency)
    }
}

/// All amplitudes of one start: one root, one direction, one law, one point.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeRuns {
    /// V_l, m/s.
    pub loading_velocity_m_per_s: f64,
    /// σ, Pa.
    pub normal_stress_pa: f64,
    /// The slip mode of the point by the exact theory.
    pub slip_mode: SlipMode,
    /// The law.
    pub law: EvolutionLaw,
    /// Re p of the root, in V_l/D_c.
    pub growth_rate: f64,
    /// Im p of the root, in V_l/D_c; zero for a real root.
    pub angular_frequency: f64,
    /// Along which part of the eigenvector the runs start.
    pub direction: Direction,
    /// Relative mismatch over amplitude that the quadratic terms cause, predicted.
    pub coefficient: f64,
    /// From the largest amplitude to the smallest.
    pub mismatches: Vec<Mismatch>,
    /// |p − p'|/|p| between 64-bit and double-double runs from the smallest amplitude: what rounding costs.
    pub difference_of_64_bit: f64,
}

impl ModeRuns {
    /// Slope of ln mismatch over ln amplitude between the largest and the smallest amplitude; 1 is expected. None for one amplitude.
    pub(crate) fn order(&self) -> Option<f64> {
        let (first, last) = (self.mismatches.first()?, self.mismatches.last()?);
        let decades = libm::log(first.amplitude / last.amplitude);
        (decades > 0.0).then(|| libm::log(first.size() / last.size()) / decades)
    }

    /// Measured over predicted mismatch at the smallest amplitude, minus 1.
    pub(crate) fn off_prediction(&self) -> Option<f64> {
        let last = self.mismatches.last()?;
        Some((last.size() / (self.coefficient * last.amplitude) - 1.0).abs())
    }

    /// |p_measured − p|/|p| at the smallest amplitude, by the worse of the two routes.
    pub(crate) fn least_mismatch(&self) -> Option<f64> {
        self.mismatches.last().map(|last| last.size().max(last.snapshots))
    }
}

/// The linear regime of a scene.
#[derive(Debug, Clone, Default)]
pub struct LinearRegimeOutcome {
    /// Every start in the order point, law, root, direction; or why it has no result.
    pub runs: Vec<Result<ModeRuns, Failure>>,
    /// Steady sliding and the free residual at every point, law by law.
    pub steady: Vec<Result<SteadyRun, Failure>>,
}

/// One start that is to be run with all amplitudes.
struct Case<'p> {
    point: &'p PlanePoint,
    groups: Groups<Rational>,
    slip_mode: SlipMode,
    law: EvolutionLaw,
    mode: Mode,
    direction: Direction,
    time: f64,
}

/// Runs every start of the section.
pub(crate) fn linear_regime(
    parameters: &Slider<Rational>,
    section: &LinearRegimeSection,
    threshold: &InertialThreshold,
) -> LinearRegimeOutcome {
    let methods = Methods { fine: Radau::new(), coarse: Radau::new() };
    let mut amplitudes: Vec<f64> = section.amplitudes.iter().map(nearest_f64).collect();
    amplitudes.sort_by(|a, b| b.total_cmp(a));
    let cases: Vec<Case<'_>> =
        section.points.iter().flat_map(|point| cases(parameters, point, section, threshold)).collect();
    LinearRegimeOutcome {
        runs: parallel::map(&cases, |case| run_case(case, &amplitudes, &methods)),
        steady: steady_sliding(parameters, section),
    }
}

fn cases<'p>(
    parameters: &Slider<Rational>,
    point: &'p PlanePoint,
    section: &LinearRegimeSection,
    threshold: &InertialThreshold,
) -> Vec<Case<'p>> {
    let PlanePoint { loading_velocity_m_per_s: velocity, normal_stress_pa: stress } = point;
    let parameters = parameters.at(stress.clone(), velocity.clone());
    let groups = parameters.groups();
    let slip_mode = classify(&parameters, threshold).slip_mode;
    let modes = modes_of(&groups);
    let mut cases = Vec::new();
    for &law in &section.laws {
        for mode in &modes {
            let directions = if mode.is_real() { &[Direction::RealPart][..] } else { &Direction::ALL };
            for &direction in directions {
                let (groups, time) = (groups.clone(), time_of(mode, &modes));
                cases.push(Case { point, groups, slip_mode, law, mode: mode.clone(), direction, time });
            }
        }
    }
    cases
}

/// One mode for each real root and one for a pair: the root of positive imaginary part.
fn modes_of(groups: &Groups<Rational>) -> Vec<Mode> {
    let roots = certified_roots(&groups.characteristic_cubic(), ROOT_DIGITS).roots;
    let upper = roots.iter().filter(|root| !root.im.is_sign_negative() || root.im.is_zero());
    upper.map(|root| Mode::of(root, groups)).collect()
}

/// The time in which the mode changes by a factor of e, or the fastest growing mode does: beyond it, the other mode's own
/// nonlinearity would be measured.
fn time_of(mode: &Mode, all: &[Mode]) -> f64 {
    let fastest = all.iter().map(|mode| mode.rate.real().to_f64()).fold(0.0, f64::max);
    1.0 / mode.modulus().max(fastest)
}

/// Methods with their constants, computed once.
struct Methods {
    fine: Radau<Dd, 7>,
    coarse: Radau<f64, 5>,
}

fn run_case(case: &Case<'_>, amplitudes: &[f64], methods: &Methods) -> Result<ModeRuns, Failure> {
    let fine = Model::new(case.groups.map(Dd::from_rational), case.law);
    let measured = |&amplitude: &f64| {
        let start = case.mode.start(case.direction, amplitude);
        let states = snapshots(&fine, methods.fine.clone(), start, FINE, case.time)?;
        let projected = projected_rate(&case.mode, &states, case.time);
        let seen = rate_of_snapshots(&states, case.mode.is_real(), case.time);
        Ok::<_, Failure>((mismatch(&case.mode, amplitude, &projected, &seen), projected))
    };
    let (mismatches, projected): (Vec<Mismatch>, Vec<Complex>) =
        amplitudes.iter().map(measured).collect::<Result<_, _>>()?;
    let difference_of_64_bit = match amplitudes.iter().zip(projected).next_back() {
        None => 0.0,
        Some((&amplitude, reference)) => {
            let model = Model::new(case.groups.map(nearest_f64), case.law);
            let start = case.mode.start(case.direction, amplitude).map(|component| component.hi());
            let states = snapshots(&model, methods.coarse.clone(), start, COARSE, case.time)?;
            relative(&case.mode, &(projected_rate(&case.mode, &states, case.time) - reference))
        }
    };
    let shift = case.mode.first_order_shift(case.law, case.direction, 1.0, case.time);
    Ok(ModeRuns {
        loading_velocity_m_per_s: nearest_f64(&case.point.loading_velocity_m_per_s),
        normal_stress_pa: nearest_f64(&case.point.normal_stress_pa),
        slip_mode: case.slip_mode,
        law: case.law,
        growth_rate: case.mode.rate.real().to_f64(),
        angular_frequency: case.mode.rate.imag().to_f64(),
        direction: case.direction,
        coefficient: relative(&case.mode, &shift),
        mismatches,
        difference_of_64_bit,
    })
}

/// |difference|/|p|.
fn relative(mode: &Mode, difference: &Complex) -> f64 {
    Float::with_val(BITS, difference.abs_ref()).to_f64() / mode.modulus()
}

fn mismatch(mode: &Mode, amplitude: f64, projected: &Complex, seen: &Complex) -> Mismatch {
    let difference = Complex::with_val(BITS, projected - &mode.rate);
    Mismatch {
        amplitude,
        growth: difference.real().to_f64() / mode.modulus(),
        frequency: difference.imag().to_f64() / mode.modulus(),
        snapshots: relative(mode, &Complex::with_val(BITS, seen - &mode.rate)),
    }
}

#[cfg(test)]
mod tests;
