//! Both Floquet multipliers of a limit cycle, from central differences of its return map.
//!
//! Only multipliers well above the errors of the map mean anything: deep stick-slip is superattracting, and there the
//! differences show rounding. Those come out as zero.

use super::integrator::{Control, Integrator};
use super::long_term::Cycle;
use super::section_return::next_return;
use super::{Failure, Model, Radau};

/// Relative size of the differences: their truncation error is its square.
const DIFFERENCE: f64 = 1e-4;

/// Local tolerance of the returns; the map's errors are far below it.
const LOCAL_TOLERANCE: f64 = 1e-9;

/// Relative error of a return's end; over the difference it is the resolution of the derivative.
const RETURN_ERROR: f64 = 1e-11;

/// The multipliers as (re, im) pairs, by descending modulus.
///
/// # Errors
/// Those of the integrator.
pub fn floquet_multipliers(model: &Model<f64>, cycle: &Cycle<f64>) -> Result<[(f64, f64); 2], Failure> {
    let [_, y, zeta] = cycle.orbit.end;
    let size = y.abs().max(zeta.abs());
    // A larger difference would leave the part of the section that trajectories cross upward, where ζ > φ.
    let upward = model.imbalance(&cycle.orbit.end).abs() / (1.0 + model.groups().effect_ratio);
    let difference = (DIFFERENCE * size).min(0.1 * upward);
    let resolution = RETURN_ERROR * size / difference;
    let mut derivative = [[0.0; 2]; 2];
    for column in 0..2 {
        let mut ends = [[0.0; 3]; 2];
        for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]) {
            let mut start = [0.0, y, zeta];
            start[column + 1] += sign * difference;
            let control = Control { local_tolerance: LOCAL_TOLERANCE, most_steps: 10_000_000 };
            let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
            for _ in 0..cycle.returns_per_cycle {
                next_return(&mut run)?;
            }
            *end = *run.state();
        }
        for (row, entries) in derivative.iter_mut().enumerate() {
            let slope = (ends[1][row + 1] - ends[0][row + 1]) / (2.0 * difference);
            entries[column] = if slope.abs() < resolution { 0.0 } else { slope };
        }
    }
    Ok(eigenvalues(derivative, resolution))
}

fn eigenvalues([[a, b], [c, d]]: [[f64; 2]; 2], resolution: f64) -> [(f64, f64); 2] {
    let half_trace = 0.5 * (a + d);
    // ((a − d)/2)² + bc does not cancel as the trace and the determinant would.
    let discriminant = 0.25 * (a - d) * (a - d) + b * c;
    let root = discriminant.abs().sqrt();
    if discriminant < 0.0 {
        return [(half_trace, root), (half_trace, -root)];
    }
    let large = if half_trace < 0.0 { half_trace - root } else { half_trace + root };
    let determinant = a * d - b * c;
    let small = if large == 0.0 { 0.0 } else { determinant / large };
    [(large, 0.0), (if small.abs() < resolution { 0.0 } else { small }, 0.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{LongTerm, Options, simulate_model};
    use crate::friction::{EvolutionLaw, Groups};

    #[test]
    fn the_leading_multiplier_is_the_contraction_seen_in_the_approach() {
        // Just beyond K = K_c in the vibration domain: κ is 0.97 of the critical (β − 1)(1 + η).
        let groups = Groups { inertial_parameter: 9.0, stiffness_group: 0.97 * 5.0, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Aging);
        let outcome = simulate_model(&model, &Options::default()).unwrap();
        let LongTerm::Cycle(cycle) = outcome.long_term() else { unreachable!("K < K_c cannot decay") };
        let [leading, other] = floquet_multipliers(&model, cycle).unwrap();
        assert!(leading.1 == 0.0 && leading.0 > 0.5 && leading.0 < 1.0, "{leading:?}");
        let seen = outcome.contraction().unwrap();
        assert!((leading.0 - seen).abs() < 1e-3, "{leading:?} {seen}");
        assert!(other.0.abs() < 0.1);
    }

    #[test]
    fn deep_stick_slip_is_superattracting() {
        let groups = Groups { inertial_parameter: 7.9e-7, stiffness_group: 7.9e-3, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let outcome = simulate_model(&model, &Options::default()).unwrap();
        let LongTerm::Cycle(cycle) = outcome.long_term() else { unreachable!("K < K_c cannot decay") };
        let [leading, _] = floquet_multipliers(&model, cycle).unwrap();
        assert!(leading.0.hypot(leading.1) < 1e-2, "{leading:?}");
    }
}
