//! What a little inertia does to the closed orbits that the aging law has without inertia at K = K_c.
//!
//! Without inertia and at κ = β − 1 all orbits are closed, H = x + βy − (e^x + β − 1)e^y is constant along each, and Ω = Vθ/D_c obeys
//! Ω' = (β − 1)(Ω − V), V in V_l and time in D_c/V_l. A mass adds the force φ = η V', and H' = (1 − Ω)[(κ − β + 1)(1 − V) − φ']. Along a
//! closed orbit H changes by
//!
//! (κ − β + 1) ∮(Ω − 1)² dt − η ∮Ω'² dt + η² (β − 1)/2 ∮V V'² dt + …
//!
//! The first two terms are Melnikov's integral. In a large orbit V² cancels in the second, which is as V_peak; the third, from the
//! change of the orbit itself, is as V_peak⁴. They balance at η V_peak³ = O(1), where the family of cycles has its fold. What is left out is
//! smaller by η V_peak² = O(η^(1/3)).

use super::peak_law::runge_kutta;
use crate::number::search::border_between;

/// The integrals along the closed orbit with a given peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeOrbit {
    excess: f64,
    /// ∮Ω'² dt, ∮(Ω − 1)² dt and (β − 1)/2 ∮V V'² dt.
    integrals: [f64; 3],
}

impl EdgeOrbit {
    /// K/K_c − 1 at which this orbit becomes a cycle of the slider with a small η.
    #[must_use]
    pub fn stiffness_excess(&self, inertial_parameter: f64) -> f64 {
        let [drive, spring, arrest] = self.integrals;
        let eta = inertial_parameter;
        (eta * (drive - eta * arrest) / (self.excess * spring) - eta) / (1.0 + eta)
    }
}

/// x, ln Ω and the three integrals.
type Motion = [f64; 5];

/// The closed orbit whose peak of ln(V/V_l) is `log_peak` > 0, by steps of this length in time plus slip. None when it does not close.
#[must_use]
pub fn edge_orbit(effect_ratio: f64, log_peak: f64, step: f64) -> Option<EdgeOrbit> {
    /// Far more than a closed orbit takes at any step that resolves it.
    const MOST_STEPS: usize = 1_000_000;
    let excess = effect_ratio - 1.0;
    let peak = libm::exp(log_peak);
    let advance = |motion: Motion, step: f64| runge_kutta(|_, at| rates(effect_ratio, at), 0.0, motion, step);
    let rising = |motion: &Motion| rates(effect_ratio, *motion)[0];
    // V' = 0 at the peak.
    let start = [log_peak, libm::log(effect_ratio * peak / (excess + peak)), 0.0, 0.0, 0.0];
    let mut motion = advance(start, step);
    for _ in 0..MOST_STEPS {
        let next = advance(motion, step);
        if rising(&motion) > 0.0 && rising(&next) <= 0.0 {
            let falls = |part: f64| Some(rising(&advance(motion, part * step)) <= 0.0);
            let (_, part) = border_between(falls, (0.0, 1.0), 1e-14)?;
            let [_, _, integrals @ ..] = advance(motion, part * step);
            return Some(EdgeOrbit { excess, integrals });
        }
        motion = next;
    }
    None
}

/// Rates per time plus slip, which resolves the stick and the slip alike.
fn rates(effect_ratio: f64, [x, log_omega, ..]: Motion) -> Motion {
    let excess = effect_ratio - 1.0;
    let (velocity, omega) = (libm::exp(x), libm::exp(log_omega));
    let over = velocity / omega;
    let growth = excess * (1.0 - velocity) - effect_ratio * (over - velocity);
    let turn = excess * (omega - velocity);
    let acceleration = velocity * growth;
    let integrands =
        [turn * turn, (omega - 1.0) * (omega - 1.0), 0.5 * excess * velocity * acceleration * acceleration];
    let [drive, spring, arrest] = integrands;
    [growth, excess * (1.0 - over), drive, spring, arrest].map(|rate| rate / (1.0 + velocity))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_orbit_has_the_integrals_of_its_slip_in_closed_form() {
        // With Ω falling by β − 1 per D_c, V = V_peak (e/r)^r w^r e^(−w), w = Ω/(β − 1) and r = β/(β − 1) = 3: the second integral is
        // (β − 1)² V_peak (e/r)^r Γ(r + 1), the fourth power (β − 1)/2 V_peak⁴ (e/r)^(4r) 4r Γ(4r − 1)/4^(4r + 1).
        let (r, excess): (f64, f64) = (3.0, 0.5);
        let unit = libm::exp(1.0) / r;
        let drive = excess * excess * libm::pow(unit, r) * 6.0;
        let arrest = 0.5 * excess * libm::pow(unit, 12.0) * 12.0 * 3_628_800.0 / libm::pow(4.0, 13.0);
        let log_peak = 9.0;
        let peak = libm::exp(log_peak);
        let [found, _, third] = edge_orbit(1.5, log_peak, 0.01).unwrap().integrals;
        // ∮V² − ΩV: the second part is (β − 1)/2 ln² V_peak to leading order, below 1 % here.
        assert!((found / (drive * peak) - 1.0).abs() < 0.01, "{found}");
        assert!((third / (arrest * libm::pow(peak, 4.0)) - 1.0).abs() < 1e-3, "{third}");
    }

    #[test]
    fn a_small_orbit_needs_no_other_stiffness_and_steps_do_not_matter() {
        // ∮Ω'² dt is ω² ∮(Ω − 1)² dt with ω² = β − 1, so that K/K_c − 1 vanishes with the amplitude.
        let small = edge_orbit(1.5, 0.01, 0.01).unwrap().stiffness_excess(1e-6);
        assert!(small.abs() < 1e-9, "{small:e}");
        let [fine, coarse] =
            [0.01, 0.02].map(|step| edge_orbit(1.5, 4.0, step).unwrap().stiffness_excess(1e-5));
        assert!((fine / coarse - 1.0).abs() < 1e-6, "{fine:e} {coarse:e}");
        // By another integrator at a relative tolerance of 1e-10.
        assert!((fine / 5.699836787e-5 - 1.0).abs() < 1e-6, "{fine:e}");
    }
}
