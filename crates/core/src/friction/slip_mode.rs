//! The names of the slip modes: the linear theory and the simulation use the same words without knowing each other.

slipmode_algebra::named! {
    /// How the slider slips, in the words of the paper's figures 1 and 7.
    ///
    /// ```
    /// use slipmode_core::friction::SlipMode;
    ///
    /// assert_eq!(SlipMode::HarmonicVibration.as_str(), "harmonic-vibration");
    /// assert_eq!(SlipMode::ALL.len(), 6);
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
    pub enum SlipMode {
        /// Stable, all roots real.
        OverdampedStableSliding = "overdamped-stable-sliding",
        /// Stable, oscillating well below the natural frequency.
        NonInertialUnderdampedOscillation = "non-inertial-underdamped-oscillation",
        /// Stable, oscillating near the natural frequency.
        InertialUnderdampedOscillation = "inertial-underdamped-oscillation",
        /// Unstable, not oscillating or oscillating well below the natural frequency.
        StickSlip = "stick-slip",
        /// Unstable, oscillating near the natural frequency.
        HarmonicVibration = "harmonic-vibration",
        /// Stable with real roots in the upper area of a > b (fig. 7b, iii).
        OverdampedOscillation = "overdamped-oscillation",
    }
}

impl SlipMode {
    /// The name in figures and sentences.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::OverdampedStableSliding => "overdamped stable sliding",
            Self::NonInertialUnderdampedOscillation => "non-inertial underdamped oscillation",
            Self::InertialUnderdampedOscillation => "inertial underdamped oscillation",
            Self::StickSlip => "stick-slip",
            Self::HarmonicVibration => "harmonic vibration",
            Self::OverdampedOscillation => "overdamped oscillation",
        }
    }
}
