//! A trajectory sampled for a figure or a file, and the free residual of a run.
//!
//! ζ is integrated with the state. Slip is integrated apart from it, by Gauss-Legendre quadrature of e^x over the polynomials of the
//! steps; since ζ must be ζ_0 + κ (t − slip), their difference is a check that costs the solution nothing.

use super::integrator::{Control, Integrator};
use super::stepper::Stepper;
use super::{Failure, Model, Scalar, State};

/// One sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time since the start, D_c/V_l.
    pub time: f64,
    /// x, y and ζ.
    pub state: State<f64>,
}

/// A sampled run.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Samples in order of time: the start, then a fixed number in each step.
    pub samples: Vec<Sample>,
    /// Largest |ζ − ζ_0 − κ (t − slip)| over the run, in units of aσ.
    pub free_residual: f64,
}

/// Abscissae in [0, 1] and weights of the eight-point Gauss-Legendre rule.
pub(super) const GAUSS: [[f64; 2]; 8] = [
    [0.019855071751231884, 0.05061426814518813],
    [0.10166676129318664, 0.11119051722668724],
    [0.2372337950418355, 0.15685332293894363],
    [0.4082826787521751, 0.181341891689181],
    [0.591717321247825, 0.181341891689181],
    [0.7627662049581645, 0.15685332293894363],
    [0.8983332387068134, 0.11119051722668724],
    [0.9801449282487681, 0.05061426814518813],
];

/// Runs until a time (D_c/V_l) and samples every step at equal parts of its length, from the step's polynomial.
///
/// # Errors
/// Those of the integrator.
pub fn trajectory<M: Stepper<f64>>(
    model: &Model<f64>,
    method: M,
    start: State<f64>,
    control: Control,
    until: f64,
    samples_per_step: usize,
) -> Result<Trajectory, Failure> {
    let mut run = Integrator::new(model, method, start, control)?;
    let mut samples = vec![Sample { time: 0.0, state: start }];
    // The slip beyond loading is integrated apart from the stress.
    let (mut excess_slip, mut free_residual) = (0.0, 0.0f64);
    while until - run.time() > 1e-13 * until {
        let began = run.time();
        run.advance(Some(&(until - began)))?;
        for part in 1..samples_per_step {
            let theta = part as f64 / samples_per_step as f64;
            samples.push(Sample { time: began + theta * run.step(), state: run.state_within(&theta) });
        }
        samples.push(Sample { time: run.time(), state: *run.state() });
        let excess = |theta: f64| run.state_within(&theta)[0].exponentials().1;
        excess_slip += run.step() * GAUSS.iter().map(|&[theta, weight]| weight * excess(theta)).sum::<f64>();
        let expected = start[2] - model.groups().stiffness_group * excess_slip;
        free_residual = free_residual.max((run.state()[2] - expected).abs());
    }
    Ok(Trajectory { samples, free_residual })
}

/// The states at these times (D_c/V_l, ascending, from 0), each from the polynomial of the step in which it lies.
///
/// # Errors
/// Those of the integrator.
pub fn trajectory_at<M: Stepper<f64>>(
    model: &Model<f64>,
    method: M,
    start: State<f64>,
    control: Control,
    times: &[f64],
) -> Result<Vec<Sample>, Failure> {
    let until = times.last().copied().unwrap_or(0.0);
    let mut run = Integrator::new(model, method, start, control)?;
    let mut samples: Vec<Sample> = Vec::new();
    let mut later = times.iter().copied().peekable();
    while let Some(time) = later.next_if(|time| *time <= 0.0) {
        samples.push(Sample { time, state: start });
    }
    while until - run.time() > 1e-13 * until {
        let began = run.time();
        run.advance(Some(&(until - began)))?;
        while let Some(time) = later.next_if(|time| *time <= run.time()) {
            samples.push(Sample { time, state: run.state_within(&((time - began) / run.step())) });
        }
    }
    // The end of the last step and the last time differ by a rounding.
    samples.extend(later.map(|time| Sample { time, state: *run.state() }));
    Ok(samples)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{Radau, Start};
    use crate::friction::{EvolutionLaw, Groups};

    #[test]
    fn stress_and_slip_integrated_apart_agree_over_several_stick_slip_cycles() {
        // σ = 10^5 Pa, V_l = 10^-5 m/s with the paper's values. σ itself is 250 units of aσ.
        let groups = Groups { inertial_parameter: 2.5e-5, stiffness_group: 0.25, effect_ratio: 1.5 };
        for law in EvolutionLaw::ALL {
            let model = Model::new(groups.clone(), law);
            let control = Control { local_tolerance: 1e-11, most_steps: 1_000_000 };
            let start = Start::default().at_a_tenth(&model);
            let run = trajectory(&model, Radau::<f64, 5>::new(), start, control, 300.0, 1).unwrap();
            assert!(run.free_residual / 250.0 < 1e-10, "{law:?}: {:e}", run.free_residual / 250.0);
            assert!(
                run.samples
                    .windows(2)
                    .all(|pair| pair[0].time < pair[1].time || pair[1].time - pair[0].time < 1e-9)
            );
        }
    }

    #[test]
    fn states_at_stated_times_are_those_of_the_steps() {
        let groups = Groups { inertial_parameter: 2.5e-5, stiffness_group: 0.25, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let control = Control { local_tolerance: 1e-11, most_steps: 1_000_000 };
        let start = Start::default().at_a_tenth(&model);
        let run = trajectory(&model, Radau::<f64, 5>::new(), start, control, 30.0, 3).unwrap();
        let times: Vec<f64> = run.samples.iter().map(|sample| sample.time).collect();
        let found = trajectory_at(&model, Radau::<f64, 5>::new(), start, control, &times).unwrap();
        assert_eq!(found.len(), times.len());
        for (one, other) in found.iter().zip(&run.samples) {
            assert_eq!(one.time, other.time);
            for (here, there) in one.state.iter().zip(other.state) {
                // The same polynomials at the same places, up to the rounding of the place within its step.
                assert!((here - there).abs() < 1e-7 * (1.0 + there.abs()), "{one:?} {other:?}");
            }
        }
        let even =
            trajectory_at(&model, Radau::<f64, 5>::new(), start, control, &[0.0, 10.0, 20.0, 30.0]).unwrap();
        assert_eq!(even.iter().map(|sample| sample.time).collect::<Vec<_>>(), [0.0, 10.0, 20.0, 30.0]);
        assert_eq!(even[0].state, start);
    }
}
