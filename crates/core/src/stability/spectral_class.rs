//! The four areas of the paper's figure 1, and the line between stable and unstable.

slipmode_algebra::named! {
    /// What the three roots of eq 8 say, decided by two signs.
    ///
    /// ```
    /// use slipmode_core::stability::SpectralClass;
    ///
    /// // Unstable (K < K_c) with a complex pair of roots.
    /// assert_eq!(SpectralClass::from_signs(-1, -1).as_str(), "unstable-complex");
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
    pub enum SpectralClass {
        /// All roots real and negative: perturbations decay without oscillation.
        StableReal = "stable-real",
        /// A complex pair with negative real part: decaying oscillation.
        StableComplex = "stable-complex",
        /// All roots real, two of them positive: growth without oscillation.
        UnstableReal = "unstable-real",
        /// A complex pair with positive real part: growing oscillation.
        UnstableComplex = "unstable-complex",
        /// On the transition K = K_c: a purely imaginary pair, neither growing nor decaying.
        Neutral = "neutral",
    }
}

impl SpectralClass {
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
}
