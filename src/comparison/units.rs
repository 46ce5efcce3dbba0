//! Units that are wrong by a power of ten: a run that does not fit as stated fits if one value is read in another unit.

use super::findings::compare_as_stated;
use super::{Agreement, Observable, Simulate, StatedRun, Value};
use crate::scene::Quantity;
use slipmode_core::number::{Rational, nearest_f64};

/// A guess: one value is in another unit.
struct Guess {
    what: What,
    /// How the message calls the value.
    name: &'static str,
    /// The unit that it seems to have, and the one that is wanted.
    units: [&'static str; 2],
    /// log10 of the wanted unit's number over the one that was written.
    power: i32,
}

enum What {
    Parameter(Quantity),
    Observable(Observable),
}

const fn parameter(quantity: Quantity, name: &'static str, units: [&'static str; 2], power: i32) -> Guess {
    Guess { what: What::Parameter(quantity), name, units, power }
}

const fn observable(of: Observable, name: &'static str, units: [&'static str; 2], power: i32) -> Guess {
    Guess { what: What::Observable(of), name, units, power }
}

/// The guesses, the likeliest first.
const GUESSES: [Guess; 15] = [
    parameter(Quantity::NormalStress, "normal stress", ["MPa", "Pa"], 6),
    parameter(Quantity::NormalStress, "normal stress", ["kPa", "Pa"], 3),
    parameter(Quantity::LoadingVelocity, "loading velocity", ["mm/s", "m/s"], -3),
    parameter(Quantity::LoadingVelocity, "loading velocity", ["um/s", "m/s"], -6),
    parameter(Quantity::CriticalSlipDistance, "critical slip distance", ["um", "m"], -6),
    parameter(Quantity::CriticalSlipDistance, "critical slip distance", ["mm", "m"], -3),
    parameter(Quantity::Stiffness, "stiffness", ["MPa/m", "Pa/m"], 6),
    parameter(Quantity::Stiffness, "stiffness", ["GPa/m", "Pa/m"], 9),
    observable(Observable::PeakVelocity, "peak velocity", ["mm/s", "m/s"], -3),
    observable(Observable::PeakVelocity, "peak velocity", ["um/s", "m/s"], -6),
    observable(Observable::StressDrop, "stress drop", ["MPa", "Pa"], 6),
    observable(Observable::StressDrop, "stress drop", ["kPa", "Pa"], 3),
    observable(Observable::Period, "period", ["ms", "s"], -3),
    observable(Observable::Frequency, "frequency", ["kHz", "Hz"], 3),
    observable(Observable::Frequency, "frequency", ["rad/s", "Hz"], 0),
];

/// The first guess with which every quantity of the run fits that can be compared, one number at least among them.
pub fn diagnose(run: &StatedRun, simulate: Simulate<'_>) -> Option<String> {
    GUESSES.iter().find_map(|guess| {
        let other = guess.applied(run)?;
        let found = compare_as_stated(&other, simulate);
        let has_number = |finding: &&super::Finding| {
            finding.verdict == Agreement::Agrees && matches!(finding.run, Value::Number(_))
        };
        let numbers = found.findings.iter().filter(has_number).count();
        (found.verdict == Agreement::Agrees && numbers > 0).then(|| guess.message(numbers))
    })
}

impl Guess {
    fn applied(&self, run: &StatedRun) -> Option<StatedRun> {
        let mut other = run.clone();
        match self.what {
            What::Parameter(quantity) => {
                let factor = power_of_ten(self.power);
                let parameters = &mut other.parameters;
                let value = match quantity {
                    Quantity::NormalStress => &mut parameters.point.normal_stress_pa,
                    Quantity::LoadingVelocity => &mut parameters.point.loading_velocity_m_per_s,
                    Quantity::CriticalSlipDistance => &mut parameters.slider.critical_slip_distance_m,
                    _ => &mut parameters.slider.stiffness_pa_per_m,
                };
                *value *= factor;
            }
            What::Observable(of) => {
                let factor = if self.power == 0 {
                    std::f64::consts::TAU.recip()
                } else {
                    nearest_f64(&power_of_ten(self.power))
                };
                self.apply_to_observables(&mut other, of, factor)?;
            }
        }
        Some(other)
    }

    /// Scales the stated value, or that part of a trajectory which it would come from.
    fn apply_to_observables(&self, other: &mut StatedRun, of: Observable, factor: f64) -> Option<()> {
        let index = Observable::STATED.iter().position(|known| *known == of)?;
        let stated = other.values[index].as_mut();
        let is_stated = stated.map(|value| *value *= factor).is_some();
        let recording = other.recording.as_mut();
        let rescaled = recording.as_ref().and_then(|recording| match of {
            Observable::PeakVelocity => Some(recording.with_velocities_times(factor)),
            Observable::StressDrop if !recording.stresses_pa.is_empty() => {
                Some(recording.with_stresses_times(factor))
            }
            _ => None,
        });
        match (recording, rescaled) {
            (Some(recording), Some(rescaled)) => {
                *recording = rescaled.into();
                Some(())
            }
            _ => is_stated.then_some(()),
        }
    }

    fn message(&self, numbers: usize) -> String {
        let Self { name, units: [seems, wanted], power, .. } = self;
        let factor = if *power == 0 { "divided by 2 pi".into() } else { format!("times 1e{power}") };
        let fit = if numbers == 1 {
            "the run's number fits".into()
        } else {
            format!("all {numbers} numbers of the run fit")
        };
        format!("{name} looks like {seems} (wanted: {wanted}): {fit} with it {factor}, and not as written")
    }
}

fn power_of_ten(power: i32) -> Rational {
    let size = Rational::from(rug::Integer::from(rug::Integer::u_pow_u(10, power.unsigned_abs())));
    if power < 0 { size.recip() } else { size }
}
