//! The two arcs of the boundary max Im(s) = 0.

slipmode_algebra::named! {
    /// A connected piece of the boundary in the (V0, σ) plane.
    ///
    /// ```
    /// use slipmode_core::stability::{Arc, Asymptote};
    ///
    /// assert_eq!(Asymptote::quasi_static(Arc::Lower).as_str(), "eq16");
    /// assert_eq!(Asymptote::InertialUpper.arc(), Arc::Upper);
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
    pub enum Arc {
        /// From eq 15 (V0 → 0) to eq 18 (V0 → ∞), around the area of high normal stress; none for a = b.
        ///
        /// The double root lies between 0 and √β − 1: positive (unstable) for a < b, negative (stable) for a > b.
        Upper = "upper",
        /// From eq 16 (V0 → 0) through the cusp to eq 20 (σ → 0), around the area of low normal stress.
        ///
        /// The double root is below −1 − √β, so that this arc is stable.
        Lower = "lower",
    }
}
