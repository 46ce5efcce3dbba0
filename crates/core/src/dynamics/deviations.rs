//! Small deviations from steady sliding, simulated: the oscillation that a slower real mode hides in long-term behaviour.
//!
//! Three runs start a hair's breadth away from steady sliding along the three axes. Their states at one time are the columns of
//! the propagator, whose eigenvalues e^{pΔ} show a pair with its period and growth rate if there is one, however fast it
//! dies. No linear theory enters: the equations are the nonlinear ones, with errors of the order of the deviation.

use super::decay::Oscillation;
use super::integrator::{Control, Integrator, Work};
use super::{Failure, Model, Radau, Scalar, Stepper};

/// Size of the deviations over the root of the rounding error: the equations are linear to this relative accuracy.
const SIZE_IN_ROOTS: f64 = 1e-3;

/// Size of deviations that leaves nothing nonlinear in f64; no power of it that matters underflows.
const LEAST_SIZE: f64 = 1e-40;

/// The first time at which the propagator of inertial modes is examined, in units of √(M/K).
const FIRST_PHASE: f64 = 0.75;

/// Factor between the times at which the propagator is examined.
const RATIO: f64 = 1.5;

/// The phases of the pair between which its eigenvalue is read off: neither small compared with 1 nor near the negative axis.
const PHASES: std::ops::Range<f64> = 0.5..2.0;

/// Part of the propagator below which its eigenvalues are rounding and truncation errors, over the root of the rounding error.
const RESOLUTION_IN_ROOTS: f64 = 1.0;

/// Period and growth rate (in D_c/V_l) of the oscillation of small deviations; none when all modes are real.
///
/// The local tolerance is relative to the deviation.
///
/// # Errors
/// Those of the integrator.
pub fn oscillation_of_small_deviations(
    model: &Model<f64>,
    local_tolerance: f64,
) -> Result<Option<Oscillation<f64>>, Failure> {
    oscillation(model, &Radau::<f64, 5>::new(), local_tolerance)
}

/// The same by any method. In double-double a pair next to a double root keeps its digits.
pub(super) fn oscillation<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: &M,
    local_tolerance: f64,
) -> Result<Option<Oscillation<f64>>, Failure> {
    // From the fastest rate on, in the model's own units.
    let zero: [R; 3] = std::array::from_fn(|_| R::from(0));
    let entries: [R; 6] = model.jacobian(&zero).into();
    let fastest = entries.iter().fold(0.0f64, |largest, entry| largest.max(entry.to_f64().abs()));
    let size = R::from_f64(SIZE_IN_ROOTS * R::UNIT_ROUNDOFF.sqrt());
    let found = modes(model, method, local_tolerance, (size, R::from(1)), 0.1 / fastest)?;
    Ok(found.map(|seen| seen.oscillation))
}

/// The modes of small deviations in units of the spring and the mass, for steady sliding whose forces balance slowly; none when all modes
/// are real.
///
/// # Errors
/// Those of the integrator.
pub(super) fn inertial_modes<M: Stepper<f64> + Clone>(
    model: &Model<f64>,
    method: &M,
    local_tolerance: f64,
) -> Result<Option<Modes>, Failure> {
    let groups = model.groups();
    let first_time = FIRST_PHASE * (groups.inertial_parameter / groups.stiffness_group).sqrt();
    modes(model, method, local_tolerance, (LEAST_SIZE, model.stress_swing()), first_time)
}

/// What small deviations show.
#[derive(Debug, Clone, Copy)]
pub(super) struct Modes {
    /// Of the pair.
    pub oscillation: Oscillation<f64>,
    /// Rate of the real mode; minus infinity where it is too small to be seen.
    pub real_rate: f64,
    /// What the runs cost.
    pub work: Work,
}

/// The modes, by deviations of this size with a unit of ζ that balances the propagator's entries. The propagator is examined at `time`, and later.
fn modes<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: &M,
    local_tolerance: f64,
    (size, stress_unit): (R, R),
    mut time: f64,
) -> Result<Option<Modes>, Failure> {
    let control = Control { local_tolerance, most_steps: 1_000_000 };
    let units = [R::from(1), R::from(1), stress_unit];
    let start = |axis: usize| {
        std::array::from_fn(|i| if i == axis { size.clone() * &units[axis] } else { R::from(0) })
    };
    let run = |axis| Integrator::new(model, method.clone(), start(axis), control);
    let mut runs = [run(0)?, run(1)?, run(2)?];
    loop {
        for run in &mut runs {
            loop {
                let rest = R::from_f64(time) - run.time();
                if rest.to_f64() <= time * 128.0 * R::UNIT_ROUNDOFF {
                    break;
                }
                run.advance(Some(&rest))?;
            }
        }
        // Row i, column j: component i of run j.
        let propagator =
            std::array::from_fn(|i| std::array::from_fn(|j| runs[j].state()[i].clone() / &size / &units[i]));
        match pair_of(&propagator) {
            PairSeen::Pair { ln_modulus, phase, ln_real } if PHASES.contains(&phase) => {
                let period = std::f64::consts::TAU * time / phase;
                let mut work = Work::default();
                runs.iter().for_each(|run| work += run.work());
                return Ok(Some(Modes {
                    oscillation: Oscillation { period, growth_rate: ln_modulus / time },
                    real_rate: ln_real / time,
                    work,
                }));
            }
            PairSeen::Lost => return Ok(None),
            _ => time *= RATIO,
        }
    }
}

/// What the eigenvalues of a propagator show.
enum PairSeen {
    /// A complex pair, and the logarithm of the real eigenvalue's modulus.
    Pair { ln_modulus: f64, phase: f64, ln_real: f64 },
    /// Real eigenvalues, the second of them still measurable.
    Real,
    /// At most one eigenvalue is above the resolution, or one has grown out of the linear range.
    Lost,
}

fn pair_of<R: Scalar>(m: &[[R; 3]; 3]) -> PairSeen {
    let product = |i: usize, j: usize, k: usize, l: usize| m[i][j].clone() * &m[k][l];
    let minor = |i: usize, j: usize, k: usize, l: usize| product(i, k, j, l) - product(i, l, j, k);
    let trace = m[0][0].clone() + &m[1][1] + &m[2][2];
    let second = minor(0, 1, 0, 1) + minor(0, 2, 0, 2) + minor(1, 2, 1, 2);
    let determinant = m[0][0].clone() * minor(1, 2, 1, 2) - m[0][1].clone() * minor(1, 2, 0, 2)
        + m[0][2].clone() * minor(1, 2, 0, 1);
    let norm = m.iter().flatten().fold(0.0f64, |largest, entry| largest.max(entry.to_f64().abs()));
    let resolution = RESOLUTION_IN_ROOTS * R::UNIT_ROUNDOFF.sqrt();
    if second.to_f64().abs() < resolution * norm * norm.max(resolution) || norm > 1e6 {
        return PairSeen::Lost;
    }
    // z³ − trace z² + second z − determinant: the real zero by bisection and Newton, the pair from the quotient.
    let real = real_zero(&trace, &second, &determinant);
    let sum = trace - &real;
    let ln_real = libm::log(real.to_f64().abs());
    let product = second - real * &sum;
    let discriminant = sum.square() / R::from(4) - &product;
    let product_size = product.to_f64();
    // Below this the sign is that of the errors.
    if product_size > 0.0 && discriminant.to_f64() < -10.0 * resolution * product_size {
        return PairSeen::Pair {
            ln_modulus: 0.5 * libm::log(product_size),
            phase: libm::atan2((-discriminant).sqrt().to_f64(), 0.5 * sum.to_f64()),
            ln_real,
        };
    }
    PairSeen::Real
}

/// The zero by bisection in f64, then by Newton's steps as long as they help.
fn real_zero<R: Scalar>(trace: &R, second: &R, determinant: &R) -> R {
    let [t, s, d] = [trace, second, determinant].map(Scalar::to_f64);
    let value = |z: f64| ((z - t) * z + s) * z - d;
    let bound = 1.0 + t.abs().max(s.abs()).max(d.abs());
    let (mut low, mut high) = (-bound, bound);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if value(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let mut zero = R::from_f64(0.5 * (low + high));
    if R::UNIT_ROUNDOFF < f64::EPSILON / 2.0 {
        for _ in 0..3 {
            let value = ((zero.clone() - trace) * &zero + second) * &zero - determinant;
            let slope = (R::from(3) * &zero - R::from(2) * trace) * &zero + second;
            let step = value / slope;
            if !step.is_finite() {
                break;
            }
            zero = zero - step;
        }
    }
    zero
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::{EvolutionLaw, Groups};

    #[test]
    fn a_pair_behind_a_slower_real_mode_is_seen() {
        // (p + 5/4)(p² + 8p + 32) has a pair that dies faster than its real mode; eq 8 divided by η is this cubic when
        // κ/η = 40, 1 + 1/η = 37/4 and (κ + 1 − β)/η = 42.
        let eta = 4.0 / 33.0;
        let kappa = 40.0 * eta;
        let groups = Groups {
            inertial_parameter: eta,
            stiffness_group: kappa,
            effect_ratio: kappa + 1.0 - 42.0 * eta,
        };
        for law in EvolutionLaw::ALL {
            let model = Model::new(groups.clone(), law);
            let Oscillation { period, growth_rate: growth } =
                oscillation_of_small_deviations(&model, 1e-9).unwrap().unwrap();
            assert!((std::f64::consts::TAU / period / 4.0 - 1.0).abs() < 1e-7, "{period}");
            assert!((growth / -4.0 - 1.0).abs() < 1e-7, "{growth}");
        }
    }

    #[test]
    fn real_modes_show_no_oscillation() {
        // η small, κ far above (1 + √β)²: eq 16 puts the point into the lower area.
        let groups = Groups { inertial_parameter: 1e-4, stiffness_group: 20.0, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        assert_eq!(oscillation_of_small_deviations(&model, 1e-9).unwrap(), None);
    }
}
