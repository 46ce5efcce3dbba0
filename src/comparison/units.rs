//! Units that are wrong by a power of ten: a run that does not fit as stated fits if one value is read in another unit.

use super::findings::compare_as_stated;
use super::{Agreement, Observable, Simulate, StatedRun, Value};
use crate::scene::{Quantity, stem_of_key, unit_of};
use slipmode_core::number::{Rational, nearest_f64};

/// Which value may be in another unit.
#[derive(Clone, Copy)]
enum What {
    Parameter(Quantity),
    Observed(Observable),
}

use What::{Observed, Parameter};

/// The guesses, the likeliest first: what is in another unit, and each unit that it may have with log10 of the wanted unit's number over
/// the one that was written.
const GUESSES: [(What, &[(&str, i32)]); 8] = [
    (Parameter(Quantity::NormalStress), &[("MPa", 6), ("kPa", 3)]),
    (Parameter(Quantity::LoadingVelocity), &[("mm/s", -3), ("um/s", -6)]),
    (Parameter(Quantity::CriticalSlipDistance), &[("um", -6), ("mm", -3)]),
    (Parameter(Quantity::Stiffness), &[("MPa/m", 6), ("GPa/m", 9)]),
    (Observed(Observable::PeakVelocity), &[("mm/s", -3), ("um/s", -6)]),
    (Observed(Observable::StressDrop), &[("MPa", 6), ("kPa", 3)]),
    (Observed(Observable::Period), &[("ms", -3)]),
    (Observed(Observable::Frequency), &[("kHz", 3), ("rad/s", 0)]),
];

/// The first guess with which every quantity of the run fits that can be compared, one number at least among them.
pub fn diagnose(run: &StatedRun, simulate: Simulate<'_>) -> Option<String> {
    let mut guesses = GUESSES.iter().flat_map(|(what, units)| units.iter().map(move |unit| (*what, *unit)));
    guesses.find_map(|(what, (seems, power))| {
        let other = what.times_power_of_ten(power, run)?;
        let found = compare_as_stated(&other, simulate);
        let has_number = |finding: &&super::Finding| {
            finding.verdict == Agreement::Agrees && matches!(finding.run, Value::Number(_))
        };
        let numbers = found.findings.iter().filter(has_number).count();
        (found.verdict == Agreement::Agrees && numbers > 0).then(|| what.message(seems, power, numbers))
    })
}

impl What {
    fn times_power_of_ten(self, power: i32, run: &StatedRun) -> Option<StatedRun> {
        let mut other = run.clone();
        match self {
            Parameter(quantity) => {
                let mut values: [Rational; 7] = other.parameters.into();
                values[quantity as usize] *= power_of_ten(power);
                other.parameters = values.into();
            }
            Observed(of) => {
                let radians = std::f64::consts::TAU.recip();
                let factor = if power == 0 { radians } else { nearest_f64(&power_of_ten(power)) };
                apply_to_observables(&mut other, of, factor)?;
            }
        }
        Some(other)
    }

    fn message(self, seems: &str, power: i32, numbers: usize) -> String {
        let (name, wanted) = match self {
            Parameter(quantity) => (stem_of_key(quantity.as_str()).replace('_', " "), unit_of(quantity)),
            Observed(of) => (of.words(), of.unit()),
        };
        let factor = if power == 0 { "divided by 2 pi".into() } else { format!("times 1e{power}") };
        let fit = if numbers == 1 {
            "the run's number fits".into()
        } else {
            format!("all {numbers} numbers of the run fit")
        };
        format!("{name} looks like {seems} (wanted: {wanted}): {fit} with it {factor}, and not as written")
    }
}

/// Scales the stated value, or that part of a trajectory which it would come from.
fn apply_to_observables(other: &mut StatedRun, of: Observable, factor: f64) -> Option<()> {
    let index = Observable::STATED.iter().position(|known| *known == of)?;
    let stated = other.values[index].as_mut();
    let is_stated = stated.map(|value| *value *= factor).is_some();
    let factors = match (of, &other.recording) {
        (Observable::PeakVelocity, Some(_)) => [1.0, factor, 1.0],
        (Observable::Period, Some(_)) => [factor, 1.0, 1.0],
        (Observable::StressDrop, Some(recording)) if !recording.stresses_pa.is_empty() => [1.0, 1.0, factor],
        _ => return is_stated.then_some(()),
    };
    other.recording.iter_mut().for_each(|recording| *recording = recording.scaled(factors).into());
    Some(())
}

fn power_of_ten(power: i32) -> Rational {
    let size = Rational::from(rug::Integer::from(rug::Integer::u_pow_u(10, power.unsigned_abs())));
    if power < 0 { size.recip() } else { size }
}
