//! The four areas of the paper's figure 1, and the line between stable and unstable.

/// What the three roots of eq 8 say, decided by two signs.
///
/// ```
/// use slipmode_core::SpectralClass;
///
/// // Unstable (K < K_c) with a complex pair of roots.
/// assert_eq!(SpectralClass::from_signs(-1, -1).as_str(), "unstable-complex");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum SpectralClass {
    /// All roots real and negative: perturbations decay without oscillation.
    StableReal,
    /// A complex pair with negative real part: decaying oscillation.
    StableComplex,
    /// All roots real, two of them positive: growth without oscillation.
    UnstableReal,
    /// A complex pair with positive real part: growing oscillation.
    UnstableComplex,
    /// On the transition K = K_c: a purely imaginary pair, neither growing nor decaying.
    Neutral,
}

impl SpectralClass {
    /// Every class, in the order of the enumeration.
    pub const ALL: [Self; 5] =
        [Self::StableReal, Self::StableComplex, Self::UnstableReal, Self::UnstableComplex, Self::Neutral];

    /// The class that the signs of K − K_c and of the discriminant give; a double root counts as real.
    #[must_use]
    pub const fn from_signs(transition_sign: i8, boundary_sign: i8) -> Self {
        match (transition_sign, boundary_sign) {
            (0, _) => Self::Neutral,
            (1.., 0..) => Self::StableReal,
            (1.., _) => Self::StableComplex,
            (_, 0..) => Self::UnstableReal,
            _ => Self::UnstableComplex,
        }
    }

    /// The name in tables and JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::StableReal => "stable-real",
            Self::StableComplex => "stable-complex",
            Self::UnstableReal => "unstable-real",
            Self::UnstableComplex => "unstable-complex",
            Self::Neutral => "neutral",
        }
    }
}
