//! The simplified map of fig 7, drawn from the paper's equations, against exact slip modes (claim Z1).

use crate::number::Ball;
use crate::scene::SceneParameters;
use crate::stability::{Asymptote, SlipMode};
use crate::study::map::exactly;
use crate::study::{Grid, MapPoint};

/// Exact slip modes beside those the simplified map assigns.
#[derive(Debug, Clone, PartialEq)]
pub struct ZonesOutcome {
    /// The slip mode of each point, decided exactly.
    pub exact: Grid<SlipMode>,
    /// The slip mode that eqs 9, 15, 16, 18, 20 and the line V0 = √|V_c²| assign.
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
