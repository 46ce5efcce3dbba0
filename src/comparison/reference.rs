//! What a run is compared with: the linear theory, exactly, and our simulation, with its errors.

use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::friction::{EvolutionLaw, Parameters, SlipMode};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::roots::certified_roots;
use slipmode_core::stability::{Frequencies, InertialThreshold, SpectralClass, classify};

/// Our simulation of a slider to a relative error, or why there is none in words.
pub type Simulate<'s> =
    &'s (dyn Fn(&Parameters<Rational>, EvolutionLaw, f64) -> Result<Simulation, String> + Sync);

/// Digits of the roots: those of 64-bit numbers.
const DIGITS: u32 = 17;

/// What the linear theory says of a slider.
#[derive(Debug, Clone, PartialEq)]
pub struct Theory {
    /// The class of the spectrum, exact.
    pub class: SpectralClass,
    /// The slip mode, exact.
    pub slip_mode: SlipMode,
    /// What it ends in; none on the transition itself, which the linear theory leaves open.
    pub behaviour: Option<Behaviour>,
    /// K/K_c; none where no transition exists.
    pub stiffness_ratio: Option<f64>,
    /// Im(s)/2π of the pair, Hz; none when all roots are real.
    pub frequency_hz: Option<f64>,
    /// Re(s) of the pair, or the largest root when all are real, 1/s.
    pub growth_rate_per_s: f64,
}

impl Theory {
    /// The theory at a point, with the default threshold for inertial oscillations.
    #[must_use]
    pub fn of(parameters: &Parameters<Rational>) -> Self {
        let found = classify(parameters, &InertialThreshold::default());
        let critical = parameters.critical_stiffness();
        let ratio = || nearest_f64(&Rational::from(&parameters.slider.stiffness_pa_per_m / &critical));
        let roots = certified_roots(&parameters.characteristic_cubic_per_s(), DIGITS).roots;
        // Real roots come first, ascending; the pair last.
        let last = roots.last();
        let is_pair = last.is_some_and(|root| !root.im.is_zero());
        let frequencies = is_pair.then(|| Frequencies::of(parameters, &found));
        Self {
            class: found.spectral_class,
            slip_mode: found.slip_mode,
            behaviour: match found.transition_sign {
                1 => Some(Behaviour::Decaying),
                -1 => Some(Behaviour::Periodic),
                _ => None,
            },
            stiffness_ratio: (critical > 0).then(ratio),
            frequency_hz: frequencies.and_then(|frequencies| frequencies.frequency_hz.to_f64()),
            growth_rate_per_s: last.map_or(0.0, |root| root.re.to_f64()),
        }
    }
}
