//! The small stable cycle just below K = K_c, from larger members of its family.
//!
//! A return changes a run next to this cycle by less than f64 resolves, and so no run says where the cycle is. The family of cycles does: with the size
//! given and the stiffness sought its members are well-conditioned. Its measure of size is D, half of the stress drop in aσ. A shift of time by half
//! a period turns D into −D, so that
//!
//! K/K_c − 1 = D² e,  x_peak − x_trough = 2 D p,  x_peak + x_trough = 2 D² q,  ζ_high + ζ_low = 2 D² z,  period = T
//!
//! with e, p, q, z and T power series in D². At D = 0 the normal form gives e, and the linear theory p and T. The polynomials through these and three
//! members are evaluated at the D² where K/K_c − 1 has its exact value. The error of the interpolation is thrice the difference from the polynomials
//! without the largest member, and the error of the members thrice the difference from members at a local tolerance a hundred times coarser. The members
//! alone also give e at D = 0: unless it is that of the normal form, there is no answer.

use super::cycle_family::{CycleFamily, Member};
use super::integrator::Work;
use super::outcome::Errors;
use super::return_errors::OF_DIFFERENCE;
use super::section_return::Return;
use super::slow_pair::NearTransition;
use super::{Cycle, Model, Oscillation};
use crate::number::search::interpolated;

/// Amplitudes of ln(V/V_l) of the members.
const AMPLITUDES: [f64; 3] = [0.05, 0.1, 0.2];

/// The relative difference that is permitted between e of the normal form and of the members.
const AGREEMENT: f64 = 0.01;

/// Iterations of D² = (K/K_c − 1)/e(D²): each gains the digits by which e differs little from its value at zero.
const ITERATIONS: usize = 20;

/// Rounding errors of the few operations, in units of the last place.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The local tolerance of the coarser of the two sets of members over that of the finer.
const COARSER: f64 = 100.0;

/// Local tolerance of the members' returns.
pub(super) const LOCAL_TOLERANCE: f64 = 1e-12;

/// One observable by two polynomials: its value and the error of the interpolation.
type Estimated = [f64; 2];

/// The cycle at this K/K_c − 1, its errors and what its members cost; none when it is not among the members, or they do not confirm the
/// normal form. `small` is the oscillation of small deviations from steady sliding.
pub(super) fn small_cycle(
    model: &Model<f64>,
    near: &NearTransition,
    small: &Oscillation<f64>,
) -> Option<(Cycle<f64>, Errors, Work)> {
    let [coarse, fine] = [COARSER, 1.0].map(|factor| {
        let members = Members::find(model, near, factor * LOCAL_TOLERANCE)?;
        Some((members.cycle(near.excess)?, members.work()))
    });
    let ((coarse, of_coarse), (fine, mut work)) = (coarse?, fine?);
    work += of_coarse;
    // An observable that agrees by chance errs as much as the others.
    let differences = [
        coarse.size / fine.size,
        coarse.orbit.peak / fine.orbit.peak,
        coarse.orbit.trough / fine.orbit.trough,
    ];
    let largest = differences.iter().fold(0.0f64, |largest, ratio| largest.max((ratio - 1.0).abs()));
    let distance = fine.distance + OF_DIFFERENCE * largest + ROUNDING;
    let of_log = fine.interpolation + distance * fine.orbit.peak.max(-fine.orbit.trough) + ROUNDING;
    let of_period = OF_DIFFERENCE * (coarse.orbit.duration / fine.orbit.duration - 1.0).abs();
    let errors = Errors {
        peak: of_log,
        period: Some(fine.of_period + of_period + 2.0 * distance * fine.stretching + ROUNDING),
        trough: of_log,
        drop: 2.0 * distance * fine.size,
    };
    // Next to the cycle ln A changes at the rate −2 (growth rate) times the deviation of ln A.
    let contraction = Some(libm::exp(-2.0 * small.growth_rate * fine.orbit.duration));
    let (from, orbit) = (fine.orbit.end, fine.orbit);
    Some((Cycle { orbit, returns_per_cycle: 1, contraction, distance, from }, errors, work))
}

/// The members that the observables are interpolated between.
struct Members {
    members: [Member; 3],
    /// D and D² of each.
    sizes: [f64; 3],
    squares: [f64; 3],
    critical: f64,
    inertial_parameter: f64,
    effect_ratio: f64,
    /// e at D = 0 by the normal form.
    excess_at_zero: f64,
}

/// A cycle between the members, with what the interpolation leaves.
struct Interpolated {
    /// D.
    size: f64,
    orbit: Return<f64>,
    /// Relative error of D, and the error of the extremes of ln(V/V_l) at given D.
    distance: f64,
    interpolation: f64,
    /// Relative error of the period at given D, and the relative difference from the period of small deviations.
    of_period: f64,
    stretching: f64,
}

impl Members {
    fn find(model: &Model<f64>, near: &NearTransition, local_tolerance: f64) -> Option<Self> {
        let groups = model.groups();
        let (inertial_parameter, effect_ratio) = (groups.inertial_parameter, groups.effect_ratio);
        let family = CycleFamily { law: model.law(), inertial_parameter, effect_ratio, local_tolerance };
        let (critical, stress) =
            (groups.critical_stiffness_group(), stress_per_log(inertial_parameter, effect_ratio));
        let imbalance = inertial_parameter * (effect_ratio - 1.0).sqrt();
        let member = |amplitude: f64| {
            let stiffness = critical * (1.0 + amplitude * amplitude / near.square_amplitude);
            family.member(stress * amplitude, [imbalance * amplitude, stiffness]).ok()
        };
        let [small, middle, large] = AMPLITUDES.map(member);
        let members = [small?, middle?, large?];
        let sizes =
            members.each_ref().map(|member| 0.5 * (member.orbit.highest_stress - member.orbit.lowest_stress));
        let squares = sizes.map(|size| size * size);
        let excess_at_zero = 1.0 / (near.square_amplitude * stress * stress);
        let found =
            Self { members, sizes, squares, critical, inertial_parameter, effect_ratio, excess_at_zero };
        let [of_members, _] = found.excess(None, 0.0);
        ((of_members / excess_at_zero - 1.0).abs() < AGREEMENT).then_some(found)
    }

    /// What the members cost.
    fn work(&self) -> Work {
        let mut work = Work::default();
        self.members.iter().for_each(|member| work += member.work);
        work
    }

    /// A function of D² from its values at the members, and at zero where that is known.
    fn even(&self, at_zero: Option<f64>, of: impl Fn(&Return<f64>, f64) -> f64, square: f64) -> Estimated {
        let values = std::array::from_fn(|n| of(&self.members[n].orbit, self.sizes[n]));
        estimated(at_zero, &self.squares, &values, square)
    }

    /// e.
    fn excess(&self, at_zero: Option<f64>, square: f64) -> Estimated {
        let excess = self.members.each_ref().map(|member| member.stiffness_group / self.critical - 1.0);
        let values = std::array::from_fn(|n| excess[n] / self.squares[n]);
        estimated(at_zero, &self.squares, &values, square)
    }

    /// The cycle at this K/K_c − 1.
    fn cycle(&self, excess: f64) -> Option<Interpolated> {
        let e = |square| self.excess(Some(self.excess_at_zero), square);
        let square = (0..ITERATIONS).fold(excess / self.excess_at_zero, |square, _| excess / e(square)[0]);
        if !(square > 0.0 && square <= self.squares[2]) {
            return None;
        }
        let size = square.sqrt();
        let [excess, of_excess] = e(square);
        let log_per_stress = 1.0 / stress_per_log(self.inertial_parameter, self.effect_ratio);
        let half_range =
            self.even(Some(log_per_stress), |orbit, size| 0.5 * (orbit.peak - orbit.trough) / size, square);
        let mean = self.even(None, |orbit, size| 0.5 * (orbit.peak + orbit.trough) / (size * size), square);
        let mean_stress = |orbit: &Return<f64>, size: f64| {
            0.5 * (orbit.highest_stress + orbit.lowest_stress) / (size * size)
        };
        let [mean_stress, _] = self.even(None, mean_stress, square);
        let at_zero = std::f64::consts::TAU / (self.effect_ratio - 1.0).sqrt();
        let [period, of_period] = self.even(Some(at_zero), |orbit, _| orbit.duration, square);
        let highest_stress = size + square * mean_stress;
        let (middle, swing) = (square * mean[0], size * half_range[0]);
        Some(Interpolated {
            size,
            orbit: Return {
                duration: period,
                peak: middle + swing,
                trough: middle - swing,
                highest_stress,
                lowest_stress: square * mean_stress - size,
                end: [0.0, self.log_state_at_crossing(size), highest_stress],
            },
            distance: 0.5 * (of_excess / excess).abs(),
            interpolation: size * half_range[1] + square * mean[1],
            of_period: of_period / period,
            stretching: (period / at_zero - 1.0).abs(),
        })
    }

    /// y at the upward crossing of V = V_l: D times a series in D, because the downward crossing is another point.
    fn log_state_at_crossing(&self, size: f64) -> f64 {
        let at_zero = 1.0 / ((1.0 + self.inertial_parameter) * self.effect_ratio);
        let values = std::array::from_fn(|n| self.members[n].orbit.end[1] / self.sizes[n]);
        size * estimated(Some(at_zero), &self.sizes, &values, size)[0]
    }
}

/// |ζ| over |ln(V/V_l)| of small deviations on K = K_c.
fn stress_per_log(inertial_parameter: f64, effect_ratio: f64) -> f64 {
    (effect_ratio - 1.0).sqrt() * (1.0 + inertial_parameter)
}

/// The polynomial through all values, and through the one at zero where it is known; its error by the polynomial without the last value.
fn estimated(zero: Option<f64>, places: &[f64; 3], values: &[f64; 3], at: f64) -> Estimated {
    let measured = places.iter().copied().zip(values.iter().copied());
    let known: Vec<(f64, f64)> = zero.map(|value| (0.0, value)).into_iter().chain(measured).collect();
    let [value, lower] = [0, 1].map(|dropped| interpolated(&known[..known.len() - dropped], at));
    [value, OF_DIFFERENCE * (value - lower).abs()]
}
