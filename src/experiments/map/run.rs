//! max Im(s), spectral class and slip mode on a (V, σ) grid (figs 1, 6a and 7).

use crate::parallel;
use slipmode_core::friction::Slider;

use crate::experiments::shared::Grid;
use crate::scene::Rectangle;
use slipmode_core::number::Rational;
use slipmode_core::stability::{Classification, InertialThreshold, classify};

/// Classifies every point of a rectangle; its coordinates are the f64 of the axes, taken as exact rationals.
pub(crate) fn classify_rectangle(
    parameters: &Slider<Rational>,
    rectangle: &Rectangle,
    threshold: &InertialThreshold,
) -> Grid<Classification> {
    let velocities = rectangle.loading_velocity_m_per_s.coordinates();
    let stresses = rectangle.normal_stress_pa.coordinates();
    let row = |&stress: &f64| {
        let at = |&velocity: &f64| classify(&parameters.at(exactly(stress), exactly(velocity)), threshold);
        velocities.iter().map(at).collect::<Vec<_>>()
    };
    let values = parallel::flat_map(&stresses, row);
    Grid { loading_velocity_m_per_s: velocities, normal_stress_pa: stresses, values }
}

/// A grid coordinate as the binary rational that it is; the scene reader lets finite coordinates through only.
pub(crate) fn exactly(coordinate: f64) -> Rational {
    Rational::from_f64(coordinate).unwrap_or_default()
}
