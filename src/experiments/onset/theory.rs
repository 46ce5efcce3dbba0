//! The theory's velocities of an onset: the exact boundary of the stable zone, and where the mode becomes inertial.

use crate::experiments::map::run::exactly;
use crate::experiments::onset::Located;
use slipmode_core::friction::Slider;
use slipmode_core::number::search::border_between;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::{Arc, BoundaryCurve, InertialThreshold, Section, SlipMode, classify};

/// Certain digits of the theory's velocities: more than any table shows.
pub(crate) const DIGITS: u32 = 20;

/// The boundary of the stable zone with the largest velocity at a normal stress: arc and velocity.
pub(crate) fn stable_boundary(parameters: &Slider<Rational>, stress: &Rational) -> Option<(Arc, Ball)> {
    let upper_is_stable = !parameters.has_transition();
    BoundaryCurve::new(parameters, DIGITS)
        .crossings(&Section::AtNormalStress(stress.clone()))
        .into_iter()
        .map(|crossing| (crossing.arc, crossing.position.loading_velocity_m_per_s))
        .filter(|(arc, _)| *arc == Arc::Lower || upper_is_stable)
        .max_by(|(_, one), (_, other)| one.to_f64().total_cmp(&other.to_f64()))
}

/// The normal stress at which a line of constant velocity leaves the overdamped area of stable sliding upwards: eq 16 but for
/// inertia.
pub(crate) fn stable_boundary_stress(parameters: &Slider<Rational>, velocity: &Rational) -> Option<Ball> {
    BoundaryCurve::new(parameters, DIGITS)
        .crossings(&Section::AtVelocity(velocity.clone()))
        .into_iter()
        .filter(|crossing| crossing.arc == Arc::Lower)
        .map(|crossing| crossing.position.normal_stress_pa)
        .max_by(|one, other| one.to_f64().total_cmp(&other.to_f64()))
}

/// Largest factor above the boundary at which the threshold is sought, and the width in ln V to which it is located.
const INERTIAL_REACH: f64 = 1e3;
const INERTIAL_WIDTH: f64 = 1e-12;

/// Halving on the exact slip mode.
pub(crate) fn inertial_velocity(
    parameters: &Slider<Rational>,
    threshold: &InertialThreshold,
    stress: &Rational,
    boundary: f64,
) -> Option<Located> {
    let is_inertial = |log_velocity: f64| {
        let point = parameters.at(stress.clone(), exactly(libm::exp(log_velocity)));
        Some(classify(&point, threshold).slip_mode == SlipMode::InertialUnderdampedOscillation)
    };
    let ends = (libm::log(boundary), libm::log(boundary * INERTIAL_REACH));
    // With a < b the stable zone ends at V_c; the last inertial velocity below it serves as the upper end.
    let mut upper = (1..=64).map(|index| ends.0 + (ends.1 - ends.0) * f64::from(index) / 64.0);
    let upper = upper.find(|&place| is_inertial(place) == Some(true))?;
    let (low, high) = border_between(is_inertial, (ends.0, upper), INERTIAL_WIDTH)?;
    Some(Located { value: libm::exp(high), error_dex: (high - low) / std::f64::consts::LN_10 })
}
