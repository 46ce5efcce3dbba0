//! The paper's derivations as proofs over ℚ.
//!
//! The numbered equations are input data ([`PaperEquations`]). Each function derives its result from eqs 1-4 (or from
//! what was derived from them), compares it with what the paper states, and returns the proof or the refutation:
//! an equation with a wrong sign is refuted by name, with the exact remainder.

pub mod areas;
pub mod asymptote_series;
pub mod boundary;
pub mod characteristic;
pub mod criteria;
mod equations;
pub mod exchange;
pub mod frequency;
pub mod inertial;
pub mod linearisation;
pub mod non_inertial;
mod notation;
pub mod period;
pub mod quasi_static;
pub mod regularised;
pub mod steady_state;
pub mod third_order;
pub mod transition;

pub use equations::{Equation, EquationFault, EquationsError, PaperEquations};

#[cfg(test)]
mod tests {
    use super::equations::tests::paper;
    use super::*;
    use crate::polynomial::{Proof, Refutation};

    type Prover = fn(&PaperEquations) -> Result<Proof, Refutation>;

    /// Every proof of this module, by the path of its function.
    const PROVERS: [(&str, Prover); 31] = [
        ("steady_state::prove", steady_state::prove),
        ("steady_state::laws_differ_at_rest", steady_state::laws_differ_at_rest),
        ("regularised::linearisation", regularised::linearisation),
        ("linearisation::laws_agree", linearisation::laws_agree),
        ("linearisation::prove", linearisation::prove),
        ("third_order::prove", third_order::prove),
        ("characteristic::prove", characteristic::prove),
        ("characteristic::dimensionless", characteristic::dimensionless),
        ("transition::stability", transition::stability),
        ("transition::parts", transition::parts),
        ("transition::velocity_destabilises", transition::velocity_destabilises),
        ("transition::critical_stress_and_velocity", transition::critical_stress_and_velocity),
        ("transition::intrinsically_stable", transition::intrinsically_stable),
        ("transition::crossing_frequency", transition::crossing_frequency),
        ("quasi_static::reduced_equation", quasi_static::reduced_equation),
        ("quasi_static::vanishing_frequency", quasi_static::vanishing_frequency),
        ("quasi_static::geometric_mean", quasi_static::geometric_mean),
        ("inertial::small_slip_distance", inertial::small_slip_distance),
        ("inertial::large_slip_distance", inertial::large_slip_distance),
        ("frequency::bounded", frequency::bounded),
        ("frequency::limits", frequency::limits),
        ("frequency::low_frequency_zone", frequency::low_frequency_zone),
        ("non_inertial::at_critical_stress", non_inertial::at_critical_stress),
        ("non_inertial::mass_and_stiffness", non_inertial::mass_and_stiffness),
        ("exchange::frequency_contours", exchange::frequency_contours),
        ("boundary::prove", boundary::prove),
        ("boundary::cusp", boundary::cusp),
        ("boundary::transition_avoids", boundary::transition_avoids),
        ("criteria::inertial_parameter", criteria::inertial_parameter),
        ("criteria::slip_distance_and_stiffness", criteria::slip_distance_and_stiffness),
        ("criteria::all_parameters", criteria::all_parameters),
    ];

    #[test]
    fn the_papers_equations_are_proved_and_the_proofs_recheck_after_a_round_trip() {
        for (name, prover) in PROVERS {
            let proof = prover(&paper()).unwrap_or_else(|refutation| panic!("{name}: {refutation}"));
            let text = serde_json::to_string(&proof).expect("serialisable");
            let read: Proof = serde_json::from_str(&text).expect("readable");
            assert_eq!(read.recheck(), Ok(()), "{name}");
        }
    }
}
