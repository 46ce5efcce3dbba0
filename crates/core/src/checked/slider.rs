//! A slider and its operating point, checked where they are made.

use super::answers::{Boundary, Classification, Root};
use super::exact::{Exact, NumberError};
use super::input_error::{InputError, InputErrors};
use crate::dynamics::{Failure, Options, Simulation, simulate};
use crate::friction::{self, EvolutionLaw, Parameters, Quantity};
use crate::number::Rational;
use crate::roots::certified_roots;
use crate::stability::{InertialThreshold, classify};

/// A slider on a spring with rate-and-state friction: a, b, D_c, K and M.
///
/// ```
/// use slipmode_core::{OperatingPoint, Slider};
///
/// let slider = Slider::new("0.004", "0.006", "1e-5", 10_000_000, 1000.0)?;
/// let point = OperatingPoint::new("1e6", "1e-5")?;
/// assert_eq!(slider.classify(&point).slip_mode.to_string(), "stick-slip");
/// // All faults at once.
/// assert_eq!(Slider::new(0.004, -1, f64::NAN, 1, 1).unwrap_err().iter().count(), 2);
/// # Ok::<(), slipmode_core::InputErrors>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Vec<Exact>", into = "Vec<Exact>"))]
pub struct Slider(friction::Slider<Rational>);

/// Where the slider is run: normal stress σ and loading velocity V0.
///
/// ```
/// use slipmode_core::OperatingPoint;
///
/// assert!(OperatingPoint::new("1e6", "1e-5").is_ok());
/// let errors = OperatingPoint::new(-9e6, 0).unwrap_err();
/// assert_eq!(
///     errors.to_string(),
///     "normal_stress_pa: -9e6 is not positive; loading_velocity_m_per_s: 0 is not positive"
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Vec<Exact>", into = "Vec<Exact>"))]
pub struct OperatingPoint(friction::OperatingPoint<Rational>);

/// All values, or all faults.
fn all<const COUNT: usize>(
    values: [Result<Rational, InputError>; COUNT],
) -> Result<[Rational; COUNT], InputErrors> {
    let faults: Vec<InputError> = values.iter().filter_map(|value| value.clone().err()).collect();
    if faults.is_empty() { Ok(values.map(Result::unwrap_or_default)) } else { Err(InputErrors(faults)) }
}

impl Slider {
    /// The slider with a, b, D_c in m, K in Pa/m and M in kg/m². Texts, whole numbers and [`Exact`] numbers are exact; a 64-bit number
    /// is its binary value.
    ///
    /// # Errors
    /// Every value that is no number, not positive, or out of the range 1e-300 to 1e300.
    pub fn new(
        direct_effect: impl TryInto<Exact, Error: Into<NumberError>>,
        evolution_effect: impl TryInto<Exact, Error: Into<NumberError>>,
        critical_slip_distance_m: impl TryInto<Exact, Error: Into<NumberError>>,
        stiffness_pa_per_m: impl TryInto<Exact, Error: Into<NumberError>>,
        mass_per_area_kg_per_m2: impl TryInto<Exact, Error: Into<NumberError>>,
    ) -> Result<Self, InputErrors> {
        let values = all([
            Quantity::DirectEffect.checked(direct_effect),
            Quantity::EvolutionEffect.checked(evolution_effect),
            Quantity::CriticalSlipDistance.checked(critical_slip_distance_m),
            Quantity::Stiffness.checked(stiffness_pa_per_m),
            Quantity::MassPerArea.checked(mass_per_area_kg_per_m2),
        ])?;
        Ok(Self(values.into()))
    }

    /// One of the five values; none of the operating point.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> Option<Exact> {
        self.0.value(quantity).cloned().map(Exact)
    }

    /// Stability, oscillation and slip mode of steady sliding. Signs and names are exact; rates have a relative error of at most 1e-14.
    /// An oscillation counts as inertial above √½ of the natural frequency.
    #[must_use]
    pub fn classify(&self, point: &OperatingPoint) -> Classification {
        Classification::of(&classify(&self.at(point), &InertialThreshold::default()))
    }

    /// The three roots s of eq 8, the exponents of a small disturbance in 1/s, each part to this many certain digits; `digits` is cut to
    /// the range 1 to 1 000 000. A multiple root stands once, with its multiplicity.
    #[must_use]
    pub fn roots(&self, point: &OperatingPoint, digits: u32) -> Vec<Root> {
        let digits = digits.clamp(1, MOST_DIGITS);
        let found = certified_roots(&self.at(point).characteristic_cubic_per_s(), digits);
        found.roots.iter().map(|root| Root::of(root, digits)).collect()
    }

    /// The boundary max Im(s) = 0 of this slider to this many certain digits; `digits` is cut to the range 1 to 1 000 000.
    #[must_use]
    pub fn boundary(&self, digits: u32) -> Boundary {
        Boundary::of(&self.0, digits.clamp(1, MOST_DIGITS))
    }

    /// Simulates the nonlinear slider from V0/10 until its long-term behaviour is known.
    ///
    /// # Errors
    /// A [`Failure`] when the long-term behaviour is undecided, or the tolerance (relative, of peak velocity and period) is out of reach
    /// or none from 1e-15 to 1e-2.
    pub fn simulate(
        &self,
        point: &OperatingPoint,
        law: EvolutionLaw,
        tolerance: f64,
    ) -> Result<Simulation, Failure> {
        if !(LEAST_TOLERANCE..=1e-2).contains(&tolerance) {
            return Err(Failure::UnreachableTolerance { requested: tolerance, reached: LEAST_TOLERANCE });
        }
        simulate(&self.at(point), law, &Options::at(tolerance))
    }

    fn at(&self, point: &OperatingPoint) -> Parameters<Rational> {
        Parameters { slider: self.0.clone(), point: point.0.clone() }
    }
}

/// The least relative error that 64-bit numbers can have.
const LEAST_TOLERANCE: f64 = 1e-15;

/// The most digits of a result.
const MOST_DIGITS: u32 = 1_000_000;

impl OperatingPoint {
    /// The point with σ in Pa and V0 in m/s; numbers as in [`Slider::new`].
    ///
    /// # Errors
    /// As [`Slider::new`].
    pub fn new(
        normal_stress_pa: impl TryInto<Exact, Error: Into<NumberError>>,
        loading_velocity_m_per_s: impl TryInto<Exact, Error: Into<NumberError>>,
    ) -> Result<Self, InputErrors> {
        let [normal_stress_pa, loading_velocity_m_per_s] = all([
            Quantity::NormalStress.checked(normal_stress_pa),
            Quantity::LoadingVelocity.checked(loading_velocity_m_per_s),
        ])?;
        Ok(Self(friction::OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }))
    }

    /// σ, Pa.
    #[must_use]
    pub fn normal_stress_pa(&self) -> Exact {
        Exact(self.0.normal_stress_pa.clone())
    }

    /// V0, m/s.
    #[must_use]
    pub fn loading_velocity_m_per_s(&self) -> Exact {
        Exact(self.0.loading_velocity_m_per_s.clone())
    }
}

#[cfg(feature = "serde")]
mod stored {
    //! A slider is stored as its five numbers, and an operating point as its two, in the order of the constructors.

    use super::{Exact, OperatingPoint, Slider};

    impl TryFrom<Vec<Exact>> for Slider {
        type Error = String;

        fn try_from(values: Vec<Exact>) -> Result<Self, String> {
            let [a, b, d, k, m] = values.try_into().map_err(|_| "a slider has five numbers".to_owned())?;
            Self::new(a, b, d, k, m).map_err(|faults| faults.to_string())
        }
    }

    impl From<Slider> for Vec<Exact> {
        fn from(slider: Slider) -> Self {
            let values: [_; 5] = slider.0.into();
            values.map(Exact).into()
        }
    }

    impl TryFrom<Vec<Exact>> for OperatingPoint {
        type Error = String;

        fn try_from(values: Vec<Exact>) -> Result<Self, String> {
            let [s, v] = values.try_into().map_err(|_| "an operating point has two numbers".to_owned())?;
            Self::new(s, v).map_err(|faults| faults.to_string())
        }
    }

    impl From<OperatingPoint> for Vec<Exact> {
        fn from(point: OperatingPoint) -> Self {
            vec![point.normal_stress_pa(), point.loading_velocity_m_per_s()]
        }
    }
}
