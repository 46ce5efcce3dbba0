//! The two laws by which the frictional state evolves (eqs 2 and 3).

slipmode_algebra::named! {
    /// How the state variable θ evolves; both laws share the steady state θ = D_c/V and the linearisation about it.
    ///
    /// ```
    /// use slipmode_core::friction::EvolutionLaw;
    ///
    /// assert_eq!(EvolutionLaw::from_word("aging"), Some(EvolutionLaw::Aging));
    /// assert_eq!(EvolutionLaw::Slip.as_str(), "slip");
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum EvolutionLaw {
        /// dθ/dt = 1 − Vθ/D_c (eq 2): heals at rest.
        Aging = "aging",
        /// dθ/dt = −(Vθ/D_c) ln(Vθ/D_c) (eq 3): evolves by slip only.
        Slip = "slip",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_law_is_found_by_its_word_and_no_other_word_is_a_law() {
        for law in EvolutionLaw::ALL {
            assert_eq!(EvolutionLaw::from_word(law.as_str()), Some(law));
        }
        assert_eq!(EvolutionLaw::from_word("Slip"), None);
    }
}
