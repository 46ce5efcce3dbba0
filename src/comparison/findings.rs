//! Every finding on a run at its own parameters, and the verdict on the run.

use super::agreement::Subject;
use super::{
    Agreement, Finding, Observable, Origin, Reference, Simulate, StatedMode, StatedRun, Theory, Value,
};
use crate::comparison::recording::{Measured, RecordedBehaviour, RecordedDecay};
use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::number::nearest_f64;

/// A run compared with theory and simulation.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The linear theory.
    pub theory: Theory,
    /// Our simulation, or why there is none.
    pub simulation: Result<Simulation, String>,
    /// Every quantity against every reference.
    pub findings: Vec<Finding>,
    /// `differs` when a quantity does; `agrees-within-error-bars` when one does and none differs; then `agrees`.
    pub verdict: Agreement,
    /// The unit that explains a difference, when one does; or why nothing could be compared.
    pub diagnosis: Option<String>,
}

/// The loosest our simulation ever is, and how far below the run's tolerance it has to be.
const LOOSEST_SIMULATION: f64 = 1e-8;
const BELOW_TOLERANCE: f64 = 0.01;
/// The tightest relative error that a simulation can be requested to meet.
const TIGHTEST_SIMULATION: f64 = 1e-15;
/// Relative error of theory's 64-bit numbers.
const THEORY_ERROR: f64 = 1e-14;

/// The comparison without a guess at what went wrong.
pub(crate) fn compare_as_stated(run: &StatedRun, simulate: Simulate<'_>) -> Comparison {
    let theory = Theory::of(&run.parameters);
    let tolerance = (BELOW_TOLERANCE * run.tolerance).clamp(TIGHTEST_SIMULATION, LOOSEST_SIMULATION);
    let simulation = simulate(&run.parameters, run.law, tolerance);
    let mut side = Side { run, theory: &theory, simulation: &simulation, findings: Vec::new() };
    side.compare();
    let findings = side.findings;
    Comparison { verdict: verdict_of(&findings), theory, simulation, findings, diagnosis: None }
}

/// The verdict on a run with these findings.
pub(super) fn verdict_of(findings: &[Finding]) -> Agreement {
    findings.iter().map(|finding| finding.verdict).max().unwrap_or(Agreement::NotCompared)
}

/// Both sides of a comparison, and what was found so far.
struct Side<'r> {
    run: &'r StatedRun,
    theory: &'r Theory,
    simulation: &'r Result<Simulation, String>,
    findings: Vec<Finding>,
}

const START: &str = "our run ends in steady sliding, so this belongs to its transient, which depends on the start: name it in a column `start`";
const STILL: &str = "our simulation does not oscillate";
const NO_PAIR: &str = "all roots of the linear theory are real";
const OTHER_END: &str = "the trajectory and our simulation end differently";
const UNDECIDED: &str = "on the transition the linear theory does not decide the long-term behaviour";
const NONLINEAR: &str =
    "our simulation departs from the linear theory here, which holds for small deviations";

impl Side<'_> {
    fn compare(&mut self) {
        if let Some(mode) = self.run.mode {
            self.compare_mode(Origin::Column, mode);
        }
        for (observable, value) in self.run.stated() {
            self.compare_stated(observable, value);
        }
        let Some(recording) = &self.run.recording else { return };
        let level = nearest_f64(&self.run.parameters.point.loading_velocity_m_per_s);
        match recording.long_term(libm::log(level), self.returns_per_cycle()) {
            Ok(RecordedBehaviour::Cycle { peak_ratio, period_s, stress_drop_pa }) => {
                self.compare_mode(Origin::Trajectory, StatedMode::Behaviour(Behaviour::Periodic));
                let peak = Measured { value: peak_ratio.value * level, ..peak_ratio };
                let open = |ours: Behaviour| (ours != Behaviour::Periodic).then_some(OTHER_END);
                self.compare_simulated(Observable::PeakVelocity, Origin::Trajectory, peak, open);
                self.compare_simulated(Observable::Period, Origin::Trajectory, period_s, open);
                if let Some(drop) = stress_drop_pa {
                    self.compare_simulated(Observable::StressDrop, Origin::Trajectory, drop, open);
                }
            }
            Ok(RecordedBehaviour::Decay(decay)) => {
                self.compare_mode(Origin::Trajectory, StatedMode::Behaviour(Behaviour::Decaying));
                self.compare_decay(decay);
            }
            Err(undecided) => {
                let subject = (Observable::Mode, Origin::Trajectory, Reference::Simulation);
                self.findings.push(not_compared(subject, Value::None, &undecided.to_string()));
            }
        }
    }

    /// Crossings of V = V_l in one period of our cycle; one for a decay.
    fn returns_per_cycle(&self) -> usize {
        let simulation = self.simulation.as_ref().ok();
        let both = simulation.and_then(|found| found.period_s.zip(found.frequency_hz));
        both.map_or(1, |(period, frequency)| libm::round(period * frequency).clamp(1.0, 64.0) as usize)
    }

    fn compare_mode(&mut self, origin: Origin, mode: StatedMode) {
        let theory = match mode {
            StatedMode::Behaviour(_) => self.theory.behaviour.map(Behaviour::as_str),
            StatedMode::Slip(_) => Some(self.theory.slip_mode.as_str()),
        };
        let simulated = self.simulation.as_ref().map(|found| match mode {
            StatedMode::Behaviour(_) => found.behaviour.as_str(),
            StatedMode::Slip(_) => found.slip_mode.as_str(),
        });
        let word = mode.as_str();
        let subject = (Observable::Mode, origin, Reference::Simulation);
        self.findings.push(match simulated {
            Ok(ours) => Finding::of_words(subject, [word, ours]),
            Err(why) => without_simulation(subject, Value::Word(word), why),
        });
        let subject = (Observable::Mode, origin, Reference::Theory);
        self.findings.push(match theory {
            None => not_compared(subject, Value::Word(word), UNDECIDED),
            // The theory is linear: where our own simulation departs from it, it does not speak against a run.
            Some(ours) if word != ours && simulated.is_ok_and(|simulated| simulated != ours) => {
                Finding { ours: Value::Word(ours), ..not_compared(subject, Value::Word(word), NONLINEAR) }
            }
            Some(ours) => Finding::of_words(subject, [word, ours]),
        });
    }

    fn compare_stated(&mut self, observable: Observable, value: f64) {
        let stated = Measured { value, relative_error: 0.0 };
        let of_transient = matches!(observable, Observable::PeakVelocity | Observable::StressDrop)
            && !self.run.has_known_start;
        let open = |ours: Behaviour| (of_transient && ours == Behaviour::Decaying).then_some(START);
        self.compare_simulated(observable, Origin::Column, stated, open);
        // A cycle is not linear: only a decay has the theory's frequency.
        let behaviour = self.simulation.as_ref().map_or(self.theory.behaviour, |ours| Some(ours.behaviour));
        if behaviour == Some(Behaviour::Decaying) {
            self.compare_linear(observable, Origin::Column, stated);
        }
    }

    /// A number against our simulation, unless `open` says why a simulation with this end has none to compare.
    fn compare_simulated(
        &mut self,
        observable: Observable,
        origin: Origin,
        run: Measured,
        open: impl Fn(Behaviour) -> Option<&'static str>,
    ) {
        let subject = (observable, origin, Reference::Simulation);
        self.findings.push(match self.simulation {
            Err(why) => without_simulation(subject, Value::Number(run), why),
            Ok(ours) => match (open(ours.behaviour), simulated(ours, observable)) {
                (Some(why), _) => not_compared(subject, Value::Number(run), why),
                (None, Some(ours)) => Finding::of_numbers(subject, [run, ours], self.run.tolerance),
                (None, None) => Finding::without_counterpart(subject, run, self.run.tolerance, STILL),
            },
        });
    }

    /// Period, frequency and growth rate of a decay against the pair of the linear theory.
    fn compare_linear(&mut self, observable: Observable, origin: Origin, run: Measured) {
        let ours = match observable {
            Observable::Period => self.theory.frequency_hz.map(|frequency| 1.0 / frequency),
            Observable::Frequency => self.theory.frequency_hz,
            Observable::GrowthRate => Some(self.theory.growth_rate_per_s),
            Observable::Mode | Observable::PeakVelocity | Observable::StressDrop => return,
        };
        let subject = (observable, origin, Reference::Theory);
        self.findings.push(match ours {
            Some(value) => {
                let ours = Measured { value, relative_error: THEORY_ERROR };
                Finding::of_numbers(subject, [run, ours], self.run.tolerance)
            }
            None => Finding::without_counterpart(subject, run, self.run.tolerance, NO_PAIR),
        });
    }

    fn compare_decay(&mut self, decay: RecordedDecay) {
        let origin = Origin::Trajectory;
        if let Some(period) = decay.period_s {
            if self.simulation.as_ref().is_ok_and(|ours| ours.behaviour == Behaviour::Decaying) {
                self.compare_simulated(Observable::Period, origin, period, |_| None);
            }
            self.compare_linear(Observable::Period, origin, period);
        }
        // The pair's rate is seen in returns; without returns the slowest root is, which is the last one when all are real.
        if let Some(rate) = decay.rate_per_s
            && decay.period_s.is_some() == self.theory.frequency_hz.is_some()
        {
            self.compare_linear(Observable::GrowthRate, origin, rate);
        }
    }
}

fn not_compared(subject: Subject, run: Value, why: &str) -> Finding {
    Finding::because(subject, run, Agreement::NotCompared, why)
}

fn without_simulation(subject: Subject, run: Value, why: &str) -> Finding {
    not_compared(subject, run, &format!("our simulation failed: {why}"))
}

/// A value of our simulation with its relative error.
#[must_use]
pub fn simulated(found: &Simulation, observable: Observable) -> Option<Measured> {
    let (value, relative_error) = match observable {
        Observable::PeakVelocity => (found.peak_velocity_m_per_s, found.peak_relative_error),
        Observable::Period => found.period_s.zip(found.period_relative_error)?,
        Observable::StressDrop => (found.stress_drop_pa, found.stress_drop_relative_error),
        Observable::Frequency => found.frequency_hz.zip(found.period_relative_error)?,
        Observable::Mode | Observable::GrowthRate => return None,
    };
    Some(Measured { value, relative_error })
}
