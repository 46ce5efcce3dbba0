//! The two laws by which the frictional state evolves (eqs 2 and 3).

use crate::number::Field;

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

impl EvolutionLaw {
    /// Numerator and denominator of A²/(K/K_c − 1) of the small cycle next to K = K_c, to leading order, A the amplitude of ln(V/V_l).
    ///
    /// The denominator vanishes where the first Lyapunov coefficient does. `slipmode_theory::hopf` proves the formula.
    pub fn square_amplitude<R: Field>(self, inertial_parameter: &R, effect_ratio: &R) -> [R; 2] {
        let (eta, one) = (inertial_parameter, || R::from(1));
        let excess = effect_ratio.clone() - one();
        let sum = one() + eta;
        let second_harmonic = sum.square() + R::from(4) * eta * eta * &excess;
        match self {
            Self::Slip => {
                let divisor = eta.clone() * (one() + R::from(9) * eta) * (one() + excess);
                [R::from(-4) * second_harmonic, divisor]
            }
            Self::Aging => {
                let margin = eta.square() * (R::from(7) + R::from(4) * excess) + R::from(6) * eta - one();
                [R::from(-4) * sum * second_harmonic, eta.clone() * margin]
            }
        }
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
