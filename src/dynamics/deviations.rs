//! Small deviations from steady sliding, simulated: the oscillation that a slower real mode hides in late behaviour.
//!
//! Three runs start a hair's breadth away from steady sliding along the three axes. Their states at one time are the columns of
//! the propagator, whose eigenvalues e^{pΔ} show a pair with its period and growth rate if there is one, however fast it
//! dies. No linear theory enters: the equations are the nonlinear ones, with errors of the order of the deviation.

use super::integrator::{Control, Integrator};
use super::{Failure, Model, Radau};

/// Size of the deviations: the equations are linear to this relative accuracy.
const SIZE: f64 = 1e-11;

/// Factor between the times at which the propagator is examined.
const RATIO: f64 = 1.5;

/// The phases of the pair between which its eigenvalue is read off: neither lost beside 1 nor near the negative axis.
const PHASES: std::ops::Range<f64> = 0.5..2.0;

/// Part of the propagator below which its eigenvalues are rounding and truncation errors.
const RESOLUTION: f64 = 1e-8;

/// Period and growth rate (in D_c/V_l) of the oscillation of small deviations; none when all modes are real.
///
/// The local tolerance is relative to the deviation.
///
/// # Errors
/// Those of the integrator.
pub fn oscillation_of_small_deviations(
    model: &Model<f64>,
    local_tolerance: f64,
) -> Result<Option<(f64, f64)>, Failure> {
    let control = Control { local_tolerance, most_steps: 1_000_000 };
    let start = |axis: usize| std::array::from_fn(|i| if i == axis { SIZE } else { 0.0 });
    let run = |axis| Integrator::new(model, Radau::<f64, 5>::new(), start(axis), control);
    let mut runs = [run(0)?, run(1)?, run(2)?];
    let jacobian = model.jacobian(&[0.0; 3]);
    let entries = [jacobian.xx, jacobian.xy, jacobian.xz, jacobian.yx, jacobian.yy, jacobian.zx];
    let fastest = entries.iter().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
    let mut time = 0.1 / fastest;
    loop {
        for run in &mut runs {
            while time - run.time() > time * 1e-14 {
                let rest = time - run.time();
                run.advance(Some(&rest))?;
            }
        }
        // Row i, column j: component i of run j.
        let propagator = std::array::from_fn(|i| std::array::from_fn(|j| runs[j].state()[i] / SIZE));
        match pair_of(&propagator) {
            Sight::Pair { ln_modulus, phase } if PHASES.contains(&phase) => {
                return Ok(Some((std::f64::consts::TAU * time / phase, ln_modulus / time)));
            }
            Sight::Lost => return Ok(None),
            _ => time *= RATIO,
        }
    }
}

/// What the eigenvalues of a propagator show.
enum Sight {
    /// A complex pair.
    Pair { ln_modulus: f64, phase: f64 },
    /// Real eigenvalues, the second of them still measurable.
    Real,
    /// At most one eigenvalue is above the resolution, or one has grown out of the linear range.
    Lost,
}

fn pair_of(m: &[[f64; 3]; 3]) -> Sight {
    let minor = |i: usize, j: usize| m[i][i] * m[j][j] - m[i][j] * m[j][i];
    let trace = m[0][0] + m[1][1] + m[2][2];
    let second = minor(0, 1) + minor(0, 2) + minor(1, 2);
    let determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    let norm = m.iter().flatten().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
    if second.abs() < RESOLUTION * norm * norm.max(RESOLUTION) || norm > 1e6 {
        return Sight::Lost;
    }
    // z³ − trace z² + second z − determinant: the real zero by bisection and Newton, the pair from the quotient.
    let real = real_zero(trace, second, determinant);
    let sum = trace - real;
    let product = second - real * sum;
    let discriminant = 0.25 * sum * sum - product;
    if discriminant < -1e-7 * product.abs() && product > 0.0 {
        return Sight::Pair {
            ln_modulus: 0.5 * libm::log(product),
            phase: libm::atan2((-discriminant).sqrt(), 0.5 * sum),
        };
    }
    Sight::Real
}

fn real_zero(trace: f64, second: f64, determinant: f64) -> f64 {
    let value = |z: f64| ((z - trace) * z + second) * z - determinant;
    let bound = 1.0 + trace.abs().max(second.abs()).max(determinant.abs());
    let (mut low, mut high) = (-bound, bound);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if value(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
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
            let (period, growth) = oscillation_of_small_deviations(&model, 1e-9).unwrap().unwrap();
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
