//! The precision levels, from the fastest arithmetic to the one that is always right.

slipmode_algebra::named! {
    /// Which arithmetic gave an answer; a higher level is slower and decides more.
    ///
    /// ```
    /// use slipmode_core::roots::PrecisionLevel;
    ///
    /// assert!(PrecisionLevel::F64 < PrecisionLevel::DoubleDouble);
    /// assert_eq!(PrecisionLevel::Exact.as_str(), "exact");
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
    pub enum PrecisionLevel {
        /// 64-bit with a forward error bound.
        F64 = "f64",
        /// Double-double with a forward error bound.
        DoubleDouble = "double-double",
        /// Integers or rationals for signs; for values the depressed cubic from integers, or balls of the needed precision.
        Exact = "exact",
    }
}
