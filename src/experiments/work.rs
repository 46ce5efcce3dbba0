//! What an experiment asks of the machine, estimated from its section before anything is computed.

use crate::scene::Rectangle;

/// What a section asks for. Measured costs, rounded up.
#[derive(Debug, Clone, PartialEq)]
pub struct Work {
    /// What is asked for, in words.
    pub what: String,
    /// Seconds of one core.
    pub core_seconds: f64,
    /// MiB of memory.
    pub memory_mib: f64,
    /// Certified digits of one result; 0 where there are none.
    pub digits: f64,
}

/// Core-seconds of the decision of one point of a map.
pub const DECISION_S: f64 = 5e-6;
/// Core-seconds of a simulation to 1e-8.
const RUN_S: f64 = 5e-3;
/// Core-seconds of a certified point of few digits, and the factor of its digits to the power 3/2.
const CERTIFIED_POINT_S: [f64; 2] = [1e-4, 2e-8];
/// Core-seconds of a certificate that is proved again.
const CERTIFICATE_S: f64 = 0.2;
/// MiB of a point of a map or of a simulation.
const POINT_MIB: f64 = 200.0 / (1 << 20) as f64;
/// Simulations of one search along a line.
pub const SEARCH_RUNS: f64 = 200.0;

impl Work {
    /// Work on the content of a file, whose size is limited where it is read.
    pub(crate) fn on_a_file() -> Self {
        Self { what: "a file".into(), core_seconds: 0.0, memory_mib: 0.0, digits: 0.0 }
    }

    /// Certificates that are proved again.
    pub(crate) fn certificates(count: usize) -> Self {
        let core_seconds = count as f64 * CERTIFICATE_S;
        Self { what: format!("{count} certificates"), core_seconds, memory_mib: 0.0, digits: 0.0 }
    }

    /// Points that are all kept.
    pub(crate) fn points(points: f64, seconds_per_point: f64) -> Self {
        let (core_seconds, memory_mib) = (points * seconds_per_point, points * POINT_MIB);
        Self { what: format!("{points} points"), core_seconds, memory_mib, digits: 0.0 }
    }

    /// The decisions of a grid.
    pub(crate) fn map(rectangle: &Rectangle) -> Self {
        Self::points(rectangle_points(rectangle), DECISION_S)
    }

    /// Points with certified digits, all kept as text.
    pub(crate) fn certified_points(points: f64, digits: u32) -> Self {
        let digits = f64::from(digits);
        Self {
            what: format!("{points} points of {digits} digits"),
            core_seconds: points * certified_point_s(digits),
            memory_mib: points * (5.0 + digits / 20.0) * POINT_MIB,
            digits,
        }
    }

    /// Runs of the nonlinear slider: a run takes 1.26 times as long for each further digit.
    pub(crate) fn simulations(runs: f64, tolerance: f64) -> Self {
        let core_seconds = runs * RUN_S * libm::pow(tolerance / 1e-8, -0.1);
        let what = format!("{runs} simulations at tolerance {tolerance:e}");
        Self { what, core_seconds, memory_mib: runs * POINT_MIB, digits: 0.0 }
    }
}

/// Core-seconds of a certified point.
pub(crate) fn certified_point_s(digits: f64) -> f64 {
    let [least, factor] = CERTIFIED_POINT_S;
    least + factor * digits * libm::sqrt(digits)
}

/// The points of a grid.
pub(crate) fn rectangle_points(rectangle: &Rectangle) -> f64 {
    f64::from(rectangle.loading_velocity_m_per_s.points) * f64::from(rectangle.normal_stress_pa.points)
}
