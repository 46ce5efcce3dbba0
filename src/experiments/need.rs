//! Required computations of a scene: claims, tables and figures name them as data, and nothing else is computed.

use std::collections::BTreeSet;

/// One kind of work that a claim, a table or a figure can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Need {
    /// max Im(s) and the spectral class on a (V, σ) grid.
    Map,
    /// The exact boundary with its asymptotes, and the agreement of its three routes.
    Boundary,
    /// max Im(s) along lines of constant normal stress.
    Frequency,
    /// The asymptotes' worst error against b/a.
    EffectRatioSweep,
    /// Where each asymptote is good to a given relative error.
    Tolerance,
    /// Slip modes on a (V, σ) grid against the simplified map of the asymptotes.
    Zones,
    /// Points with references from independent programs.
    HardCases,
    /// Returns with references from an independent program.
    HardReturns,
    /// The nonlinear slider on a (V, σ) grid.
    Simulations,
    /// Small disturbances along the eigenvectors, and steady sliding itself.
    LinearRegime,
    /// Every completion of the start V_l/10.
    StartSensitivity,
    /// Where oscillation begins along lines of constant normal stress.
    Onset,
    /// The nonlinear slider close to K = K_c.
    NearTransition,
    /// The nonlinear slider's course at named points.
    Trajectories,
    /// The fixed-step scheme of the original simulations against converged runs.
    OriginalScheme,
    /// Work against error of the integrators.
    WorkPrecision,
    /// Estimated errors compared with true ones.
    ErrorBound,
    /// Work against error of roots, classes, boundary points and sweeps.
    SpeedCounts,
    /// Times that other commands measured.
    Timings,
    /// Sweeps that ran elsewhere.
    Swept,
}

impl Need {
    /// Every need.
    pub const ALL: &'static [Self] = &[
        Self::Map,
        Self::Boundary,
        Self::Frequency,
        Self::EffectRatioSweep,
        Self::Tolerance,
        Self::Zones,
        Self::HardCases,
        Self::HardReturns,
        Self::Simulations,
        Self::LinearRegime,
        Self::StartSensitivity,
        Self::Onset,
        Self::NearTransition,
        Self::Trajectories,
        Self::OriginalScheme,
        Self::WorkPrecision,
        Self::ErrorBound,
        Self::SpeedCounts,
        Self::Timings,
        Self::Swept,
    ];

    /// The stable name used in the ids of work items.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Need::Map => "map",
            Need::Boundary => "boundary",
            Need::Frequency => "frequency",
            Need::EffectRatioSweep => "effect-ratio-sweep",
            Need::Tolerance => "tolerance",
            Need::Zones => "zones",
            Need::HardCases => "hard-cases",
            Need::HardReturns => "hard-cycles",
            Need::Simulations => "simulations",
            Need::LinearRegime => "linear-regime",
            Need::StartSensitivity => "start-sensitivity",
            Need::Onset => "onset",
            Need::NearTransition => "near-transition",
            Need::Trajectories => "trajectories",
            Need::OriginalScheme => "original-scheme",
            Need::WorkPrecision => "work-precision",
            Need::ErrorBound => "error-bound",
            Need::SpeedCounts => "speed-counts",
            Need::Timings => "timings",
            Need::Swept => "swept",
        }
    }
}

/// A set of needs, in a fixed order.
pub type Needs = BTreeSet<Need>;
