//! What the first sentence of a report answers.

slipmode_algebra::named! {
    /// What a report is for.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Question {
        /// Which claims of the paper hold.
        #[default]
        Claims = "claims",
        /// Which formula may be used for this slider.
        Formulas = "formulas",
        /// What the slider does at its operating point.
        OperatingPoint = "operating-point",
    }
}
