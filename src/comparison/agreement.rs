//! One quantity of a run against one reference: how far apart, how far apart they may be, and the verdict.

use serde::{Serialize, Serializer};

use crate::comparison::recording::Measured;
use crate::scene::{stem_of_key, unit_of_key};

slipmode_algebra::named! {
    /// What is compared: its column, with its unit.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Observable {
        /// Limit cycle or decay, or the slip mode.
        Mode = "mode",
        /// m/s.
        PeakVelocity = "peak_velocity_m_per_s",
        /// s.
        Period = "period_s",
        /// Pa.
        StressDrop = "stress_drop_pa",
        /// Hz.
        Frequency = "frequency_hz",
        /// 1/s, of the long-term deviation of ln V.
        GrowthRate = "growth_rate_per_s",
    }
}

impl Observable {
    /// What a column of a runs file may give as a number.
    pub const STATED: [Self; 4] = [Self::PeakVelocity, Self::Period, Self::StressDrop, Self::Frequency];

    /// The name for people.
    #[must_use]
    pub fn words(self) -> String {
        stem_of_key(self.as_str()).replace('_', " ")
    }

    /// The unit for people; empty for words.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Mode => "",
            Self::Frequency => "Hz",
            _ => unit_of_key(self.as_str()),
        }
    }
}

impl Serialize for Observable {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

slipmode_algebra::named! {
    /// Where a run's value comes from.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Origin {
        /// A column of the runs file.
        Column = "column",
        /// Its trajectory.
        Trajectory = "trajectory",
    }
}

slipmode_algebra::named! {
    /// What a run is compared with.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Reference {
        /// The linear theory.
        Theory = "theory",
        /// Our simulation.
        Simulation = "simulation",
    }
}

slipmode_algebra::named! {
    /// A verdict on one quantity or on a run. The greatest of several is that of all: one that differs decides, then one that agrees.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Agreement {
        /// Nothing follows, for a reason that is given.
        NotCompared = "not-compared",
        /// Within the tolerance and both errors.
        Agrees = "agrees",
        /// Not at the middle of the parameters' error bars, but within the sampled range over them.
        AgreesWithinErrorBars = "agrees-within-error-bars",
        /// Beyond them.
        Differs = "differs",
    }
}

/// A value of either side.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A number with its error.
    Number(Measured),
    /// A word.
    Word(&'static str),
    /// There is none.
    None,
}

/// One quantity of a run against one reference.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// What is compared.
    pub observable: Observable,
    /// Where the run's value comes from.
    pub origin: Origin,
    /// What it is compared with.
    pub reference: Reference,
    /// The run's value.
    pub run: Value,
    /// The reference's value.
    pub ours: Value,
    /// run/ours − 1, for numbers; the distance from the range, where there is one.
    pub difference: Option<f64>,
    /// The tolerance plus the errors of both sides, for numbers.
    pub allowed: Option<f64>,
    /// The sampled range of the reference over error bars, with its errors; none where the middle values decide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
    /// The verdict.
    pub verdict: Agreement,
    /// Why it could not be compared, or what a difference means; empty when the numbers say it all.
    #[serde(rename = "reason")]
    pub why: String,
}

/// What is compared, where the run's value comes from, and what it is compared with.
pub type Subject = (Observable, Origin, Reference);

impl Finding {
    /// A finding about words, decided by their equality.
    pub(crate) fn of_words(subject: Subject, [run, ours]: [&'static str; 2]) -> Self {
        let verdict = if run == ours { Agreement::Agrees } else { Agreement::Differs };
        Self { ours: Value::Word(ours), ..Self::because(subject, Value::Word(run), verdict, "") }
    }

    /// A finding about numbers: within tolerance and errors they agree, beyond them they differ. With an error above the tolerance
    /// they are not compared, whatever they are: an agreement would only say how little is known, and a difference rest on an estimate.
    pub(crate) fn of_numbers(subject: Subject, [run, ours]: [Measured; 2], tolerance: f64) -> Self {
        let difference = run.value / ours.value - 1.0;
        let allowed = tolerance + run.relative_error + ours.relative_error;
        let unresolved = unresolved("the trajectory", run, tolerance)
            .or_else(|| unresolved("our simulation", ours, tolerance));
        let verdict = match unresolved {
            Some(_) => Agreement::NotCompared,
            None if difference.abs() > allowed => Agreement::Differs,
            None => Agreement::Agrees,
        };
        Self {
            ours: Value::Number(ours),
            difference: Some(difference),
            allowed: Some(allowed),
            ..Self::because(subject, Value::Number(run), verdict, &unresolved.unwrap_or_default())
        }
    }

    /// A number of a run that oscillates, where the reference does not for a reason in words.
    pub(crate) fn without_counterpart(subject: Subject, run: Measured, tolerance: f64, why: &str) -> Self {
        let unresolved = unresolved("the trajectory", run, tolerance);
        let verdict = if unresolved.is_some() { Agreement::NotCompared } else { Agreement::Differs };
        Self::because(subject, Value::Number(run), verdict, unresolved.as_deref().unwrap_or(why))
    }

    /// A finding with a verdict for a reason in words.
    pub(crate) fn because(subject: Subject, run: Value, verdict: Agreement, why: &str) -> Self {
        let (observable, origin, reference) = subject;
        Self {
            observable,
            origin,
            reference,
            run,
            ours: Value::None,
            difference: None,
            allowed: None,
            range: None,
            verdict,
            why: why.into(),
        }
    }
}

/// Why a number decides nothing, if its error exceeds the tolerance or is no number.
fn unresolved(whose: &str, number: Measured, tolerance: f64) -> Option<String> {
    let error = number.relative_error;
    let shown = if error.is_finite() { format!("only to {error:.1e}") } else { "not at all".into() };
    let reason = || format!("{whose} resolves it {shown}, coarser than the tolerance {tolerance:.1e}");
    let resolves = error <= tolerance;
    (!resolves).then(reason)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(run: (f64, f64), ours: (f64, f64), tolerance: f64) -> Agreement {
        let both = [run, ours].map(|(value, relative_error)| Measured { value, relative_error });
        let subject = (Observable::Period, Origin::Trajectory, Reference::Simulation);
        Finding::of_numbers(subject, both, tolerance).verdict
    }

    #[test]
    fn numbers_agree_within_tolerance_and_errors_and_no_further() {
        assert_eq!(verdict((1.009, 0.0), (1.0, 0.0), 0.01), Agreement::Agrees);
        assert_eq!(verdict((1.011, 0.0), (1.0, 0.0), 0.01), Agreement::Differs);
        assert_eq!(verdict((1.011, 0.002), (1.0, 0.0), 0.01), Agreement::Agrees);
        assert_eq!(verdict((0.98, 0.0), (1.0, 0.0), 0.01), Agreement::Differs);
    }

    #[test]
    fn an_error_beyond_the_tolerance_is_no_verdict() {
        assert_eq!(verdict((1.0, 0.02), (1.0, 0.0), 0.01), Agreement::NotCompared);
        assert_eq!(verdict((1.0, f64::INFINITY), (1.0, 0.0), 0.01), Agreement::NotCompared);
        assert_eq!(verdict((1.0, 0.0), (1.0, 0.02), 0.01), Agreement::NotCompared);
        assert_eq!(verdict((2.0, 0.02), (1.0, 0.0), 0.01), Agreement::NotCompared);
        assert_eq!(verdict((2.0, 0.01), (1.0, 0.0), 0.01), Agreement::Differs);
    }
}
