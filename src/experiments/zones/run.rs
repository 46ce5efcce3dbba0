//! The simplified map of fig 7, drawn from the paper's equations, against exact slip modes (claim Z1).

use crate::experiments::map::MapPoint;
use crate::experiments::shared::Grid;
use slipmode_core::friction::Slider;
use slipmode_core::number::{Rational, Wide, nearest_f64};
use slipmode_core::stability::{Asymptote, SlipMode, SpectralClass};

/// ω/ω_n of the thresholds whose effect on the map is reported, besides the default √(1/2).
const FREQUENCY_RATIOS: [f64; 7] = [0.1, 0.3, 0.5, std::f64::consts::FRAC_1_SQRT_2, 0.9, 0.95, 0.99];

/// Exact slip modes next to those the simplified map assigns.
#[derive(Debug, Clone, PartialEq)]
pub struct ZonesOutcome {
    /// The slip mode of each point, decided exactly.
    pub exact: Grid<SlipMode>,
    /// The slip mode that eqs 9, 15, 16, 18, 20 and the line V0² = |V_c²| assign.
    pub simplified: Grid<SlipMode>,
    /// Points where the two disagree on stability or on whether roots are complex.
    pub disagreeing_areas: usize,
    /// Points where they disagree on the slip mode (also on inertial against non-inertial).
    pub disagreeing_modes: usize,
    /// How the map depends on the threshold between inertial and non-inertial.
    pub thresholds: Vec<ThresholdShare>,
}

/// The share of oscillating points that a threshold calls inertial.
#[derive(Debug, Clone, PartialEq)]
pub struct ThresholdShare {
    /// ω/ω_n of the threshold.
    pub frequency_ratio: f64,
    /// Points with a complex pair.
    pub oscillating: usize,
    /// Those of them above the threshold.
    pub inertial: usize,
    /// Points whose slip mode differs from that at the default threshold.
    pub moved: usize,
}

/// Holds the exact slip modes of a map against the simplified map of fig 7 on the same points.
#[must_use]
pub fn compare_zones(parameters: &Slider<Rational>, map: &Grid<MapPoint>) -> ZonesOutcome {
    let simplified = Grid {
        loading_velocity_m_per_s: map.loading_velocity_m_per_s.clone(),
        normal_stress_pa: map.normal_stress_pa.clone(),
        values: map
            .points()
            .map(|(velocity, stress, _)| simplified_zone(parameters, velocity, stress))
            .collect(),
    };
    let pairs = || map.values.iter().zip(&simplified.values);
    let disagreeing_areas = pairs().filter(|(point, zone)| area(point.spectral_class) != zone.area()).count();
    let disagreeing_modes = pairs().filter(|(point, zone)| point.slip_mode != zone.slip_mode()).count();
    ZonesOutcome {
        exact: map.map(|point| point.slip_mode),
        simplified: simplified.map(Zone::slip_mode),
        disagreeing_areas,
        disagreeing_modes,
        thresholds: threshold_shares(parameters, map),
    }
}

/// Whether a point is stable, and whether it oscillates.
type Area = (bool, bool);

fn area(class: SpectralClass) -> Area {
    match class {
        SpectralClass::StableReal => (true, false),
        SpectralClass::StableComplex | SpectralClass::Neutral => (true, true),
        SpectralClass::UnstableReal => (false, false),
        SpectralClass::UnstableComplex => (false, true),
    }
}

/// What the simplified map says of a point.
struct Zone {
    stable: bool,
    upper: bool,
    lower: bool,
    inertial: bool,
}

impl Zone {
    fn area(&self) -> Area {
        (self.stable, !(self.upper || self.lower))
    }

    fn slip_mode(&self) -> SlipMode {
        match (self.stable, self.inertial) {
            (true, _) if self.upper => SlipMode::OverdampedOscillation,
            (true, _) if self.lower => SlipMode::OverdampedStableSliding,
            (true, true) => SlipMode::InertialUnderdampedOscillation,
            (true, false) => SlipMode::NonInertialUnderdampedOscillation,
            (false, true) if !self.upper => SlipMode::HarmonicVibration,
            (false, _) => SlipMode::StickSlip,
        }
    }
}

/// The lines of fig 7 in 64 bits: a rounding error could only move a point that lies on a line.
fn simplified_zone(parameters: &Slider<Rational>, velocity: f64, stress: f64) -> Zone {
    let slider = parameters.map(nearest_f64);
    let value = |asymptote: Asymptote| asymptote.value(&slider, &stress);
    Zone {
        stable: slider.stiffness_pa_per_m > slider.at(stress, velocity).critical_stiffness(),
        upper: stress > value(Asymptote::QuasiStaticUpper) && velocity < value(Asymptote::InertialUpper),
        lower: stress < value(Asymptote::QuasiStaticLower) && velocity < value(Asymptote::InertialLower),
        // Eq 23 meets ω_n at V_c; for a > b the same line with |b − a|.
        inertial: velocity * velocity > slider.critical_velocity_squared().abs(),
    }
}

fn threshold_shares(parameters: &Slider<Rational>, map: &Grid<MapPoint>) -> Vec<ThresholdShare> {
    let natural = parameters.map(nearest_f64).natural_angular_frequency_per_s();
    let ratios: Vec<f64> = map
        .values
        .iter()
        .filter(|point| point.max_imaginary_per_s != Wide::ZERO)
        .map(|point| point.max_imaginary_per_s.to_f64().unwrap_or(0.0) / natural)
        .collect();
    let above = |threshold: f64| ratios.iter().filter(|ratio| **ratio > threshold).count();
    let default = above(std::f64::consts::FRAC_1_SQRT_2);
    FREQUENCY_RATIOS
        .iter()
        .map(|&frequency_ratio| {
            let inertial = above(frequency_ratio);
            ThresholdShare {
                frequency_ratio,
                oscillating: ratios.len(),
                inertial,
                moved: inertial.abs_diff(default),
            }
        })
        .collect()
}
