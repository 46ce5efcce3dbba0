//! The simplified map of fig 7, drawn from the paper's equations, against exact slip modes.

use crate::experiments::shared::Grid;
use slipmode_core::friction::Slider;
use slipmode_core::number::{Rational, Wide, nearest_f64};
use slipmode_core::stability::{Asymptote, Classification, SlipMode, SpectralClass};

/// ω/ω_n of the thresholds whose effect on the map is reported, besides the default √(1/2).
const FREQUENCY_RATIOS: [f64; 7] = [0.1, 0.3, 0.5, std::f64::consts::FRAC_1_SQRT_2, 0.9, 0.95, 0.99];

slipmode_algebra::named! {
    /// A line that could divide inertial from non-inertial oscillation in fig 7. The paper's text gives no equation for it.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum InertialLine {
        /// V0² = |V_c²| (eq 13), where eq 23 equals ω_n.
        CriticalVelocity = "V0 = V_c",
        /// η = 1, where K = K_c has ω = ω_n/√2.
        InertialParameter = "η = 1",
        /// The straight line, on logarithmic axes, from the corner of eqs 15 and 18 to that of eqs 16 and 20.
        Corners = "line between the corners",
        /// Eq 18, continued below eq 15.
        InertialUpper = "{inertial-upper}",
        /// Eq 20, continued above eq 16.
        InertialLower = "{inertial-lower}",
    }
}

/// Exact slip modes next to those the simplified map assigns.
#[derive(Debug, Clone, PartialEq)]
pub struct ZonesOutcome {
    /// The slip mode of each point, decided exactly.
    pub exact: Grid<SlipMode>,
    /// The slip mode that eqs 9, 15, 16, 18, 20 and the line V0² = |V_c²| assign.
    pub simplified: Grid<SlipMode>,
    /// The same with the straight line between the corners of the asymptotes, as fig 7 seems to draw it; for a = b, where eqs 15 and
    /// 18 have no corner, as `simplified`.
    pub between_corners: Grid<SlipMode>,
    /// Points where the first two disagree on stability or on whether roots are complex.
    pub disagreeing_areas: usize,
    /// Points where they disagree on the slip mode (also on inertial against non-inertial).
    pub disagreeing_modes: usize,
    /// How far a line of the map with the straight line between the corners is from where the slip mode changes, at most, in decades
    /// along an axis.
    pub modes_off_dex: f64,
    /// How many points a map with each line between inertial and non-inertial puts into another slip mode than the exact one, in the
    /// order of the list.
    pub inertial_lines: Vec<(InertialLine, usize)>,
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

/// Compares the exact slip modes of a map with the simplified map of fig 7 on the same points.
pub(crate) fn compare_zones(parameters: &Slider<Rational>, map: &Grid<Classification>) -> ZonesOutcome {
    let lines = Lines::new(&parameters.map(nearest_f64));
    let zones = |line| Grid {
        loading_velocity_m_per_s: map.loading_velocity_m_per_s.clone(),
        normal_stress_pa: map.normal_stress_pa.clone(),
        values: map.points().map(|(velocity, stress, _)| lines.zone(line, velocity, stress)).collect(),
    };
    let misplaced = |zones: &Grid<Zone>| {
        let pairs = map.values.iter().zip(&zones.values);
        pairs.filter(|(point, zone)| point.slip_mode != zone.slip_mode()).count()
    };
    // For a = b eqs 15 and 18 are infinite, and there is no corner between them.
    let drawn =
        InertialLine::ALL.into_iter().filter(|line| *line != InertialLine::Corners || lines.has_corners());
    let inertial_lines = drawn.map(|line| (line, misplaced(&zones(line)))).collect();
    let simplified = zones(InertialLine::CriticalVelocity);
    let pairs = map.values.iter().zip(&simplified.values);
    let exact = map.map(|point| point.slip_mode);
    let between_corners = match lines.has_corners() {
        true => zones(InertialLine::Corners).map(Zone::slip_mode),
        false => simplified.map(Zone::slip_mode),
    };
    ZonesOutcome {
        modes_off_dex: off_dex(&exact, &between_corners),
        exact,
        disagreeing_areas: pairs.filter(|(point, zone)| area(point.spectral_class) != zone.area()).count(),
        disagreeing_modes: misplaced(&simplified),
        between_corners,
        simplified: simplified.map(Zone::slip_mode),
        inertial_lines,
        thresholds: threshold_shares(parameters, map),
    }
}

/// How far the points that are drawn wrong are from those where the drawn value is exact, at most, in decades along an axis.
fn off_dex<T: PartialEq>(exact: &Grid<T>, drawn: &Grid<T>) -> f64 {
    let wrong = drawn.values.iter().enumerate().filter(|(index, value)| exact.values[*index] != **value);
    wrong.map(|(index, value)| exact.distance_dex(index, value)).fold(0.0, f64::max)
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
struct Lines {
    slider: Slider<f64>,
    /// Eqs 15 and 16, Pa.
    upper_pa: f64,
    lower_pa: f64,
}

impl Lines {
    fn new(slider: &Slider<f64>) -> Self {
        let stress = |asymptote: Asymptote| asymptote.value(slider, &1.0);
        Self {
            slider: slider.clone(),
            upper_pa: stress(Asymptote::QuasiStaticUpper),
            lower_pa: stress(Asymptote::QuasiStaticLower),
        }
    }

    fn has_corners(&self) -> bool {
        self.upper_pa.is_finite()
    }

    fn zone(&self, line: InertialLine, velocity: f64, stress: f64) -> Zone {
        let velocity_of = |asymptote: Asymptote| asymptote.value(&self.slider, &stress);
        let point = self.slider.at(stress, velocity);
        let inertial = match line {
            // Eq 23 meets ω_n at V_c; for a > b the same line with |b − a|.
            InertialLine::CriticalVelocity => {
                velocity * velocity > self.slider.critical_velocity_squared().abs()
            }
            InertialLine::InertialParameter => point.groups().inertial_parameter > 1.0,
            InertialLine::Corners => velocity > self.velocity_between_corners(stress),
            InertialLine::InertialUpper => velocity > velocity_of(Asymptote::InertialUpper),
            InertialLine::InertialLower => velocity > velocity_of(Asymptote::InertialLower),
        };
        Zone {
            stable: self.slider.stiffness_pa_per_m > point.critical_stiffness(),
            upper: stress > self.upper_pa && velocity < velocity_of(Asymptote::InertialUpper),
            lower: stress < self.lower_pa && velocity < velocity_of(Asymptote::InertialLower),
            inertial,
        }
    }

    /// Eq 18 above the upper corner, eq 20 below the lower one, the straight line between them on logarithmic axes, m/s.
    fn velocity_between_corners(&self, stress: f64) -> f64 {
        let low = stress.min(self.lower_pa);
        let high = stress.max(self.upper_pa);
        let [from, to] = [(Asymptote::InertialLower, low), (Asymptote::InertialUpper, high)]
            .map(|(asymptote, stress)| asymptote.value(&self.slider, &stress));
        let share = libm::log(stress / low) / libm::log(high / low);
        from * libm::pow(to / from, share)
    }
}

fn threshold_shares(parameters: &Slider<Rational>, map: &Grid<Classification>) -> Vec<ThresholdShare> {
    let natural = parameters.map(nearest_f64).natural_angular_frequency_per_s();
    let oscillating = map.values.iter().filter(|point| point.max_imaginary_per_s != Wide::ZERO);
    let ratio = |point: &Classification| point.max_imaginary_per_s.to_f64().unwrap_or(0.0) / natural;
    let ratios: Vec<f64> = oscillating.map(ratio).collect();
    let above = |threshold: f64| ratios.iter().filter(|ratio| **ratio > threshold).count();
    let default = above(std::f64::consts::FRAC_1_SQRT_2);
    FREQUENCY_RATIOS
        .iter()
        .map(|&frequency_ratio| {
            let inertial = above(frequency_ratio);
            let (oscillating, moved) = (ratios.len(), inertial.abs_diff(default));
            ThresholdShare { frequency_ratio, oscillating, inertial, moved }
        })
        .collect()
}
