//! max Im(s), spectral class and slip mode on a (V, σ) grid (figs 1, 6a and 7).

use crate::parallel;
use slipmode_core::friction::Slider;

use crate::experiments::shared::Grid;
use crate::scene::Rectangle;
use slipmode_core::number::{Rational, Wide};
use slipmode_core::roots::PrecisionLevel;
use slipmode_core::stability::{Classification, InertialThreshold, SlipMode, SpectralClass, classify};

/// What a map keeps of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapPoint {
    /// The class given by two exact signs.
    pub spectral_class: SpectralClass,
    /// The slip mode, decided exactly.
    pub slip_mode: SlipMode,
    /// Largest Im(s), 1/s: relative error at most 1e-14, exactly 0 where all roots are real.
    pub max_imaginary_per_s: Wide,
    /// The precision level that decided.
    pub precision_level: PrecisionLevel,
}

/// Classifies every point of a rectangle; its coordinates are the f64 of the axes, taken as exact rationals.
#[must_use]
pub fn classify_rectangle(
    parameters: &Slider<Rational>,
    rectangle: &Rectangle,
    threshold: &InertialThreshold,
) -> Grid<MapPoint> {
    let velocities = rectangle.loading_velocity_m_per_s.coordinates();
    let stresses = rectangle.normal_stress_pa.coordinates();
    let at = |velocity: f64, stress: f64| {
        let Classification { spectral_class, slip_mode, max_imaginary_per_s, precision_level, .. } =
            classify(&parameters.at(exactly(stress), exactly(velocity)), threshold);
        MapPoint { spectral_class, slip_mode, max_imaginary_per_s, precision_level }
    };
    let row = |&stress: &f64| velocities.iter().map(|&velocity| at(velocity, stress)).collect::<Vec<_>>();
    let values = parallel::flat_map(&stresses, row);
    Grid { loading_velocity_m_per_s: velocities, normal_stress_pa: stresses, values }
}

/// A grid coordinate as the binary rational that it is; the scene reader lets finite coordinates through only.
pub(crate) fn exactly(coordinate: f64) -> Rational {
    Rational::from_f64(coordinate).unwrap_or_default()
}
