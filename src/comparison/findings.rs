//! A run compared: every finding, the verdict on the run, and a unit that would explain a difference.

use super::units::diagnose;
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
    /// `differs` when a quantity does, `agrees` when one does and none differs.
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

/// Compares a run.
#[must_use]
pub fn compare_run(run: &StatedRun, simulate: Simulate<'_>) -> Comparison {
    let mut found = compare_as_stated(run, simulate);
    found.diagnosis = match found.verdict {
        Agreement::Agrees => None,
        _ if run.is_empty() => Some("the row has nothing to compare".into()),
        // Velocities in another unit never pass V_l, so that such a trajectory is not even compared.
        Agreement::Differs | Agreement::NotCompared => diagnose(run, simulate),
    };
    found
}

/// The comparison without a guess at what went wrong.
pub(crate) fn compare_as_stated(run: &StatedRun, simulate: Simulate<'_>) -> Comparison {
    let theory = Theory::of(&run.parameters);
    let tolerance = (BELOW_TOLERANCE * run.tolerance).clamp(TIGHTEST_SIMULATION, LOOSEST_SIMULATION);
    let simulation = simulate(&run.parameters, run.law, tolerance);
    let findings = Side { run, theory: &theory, simulation: &simulation }.findings();
    let has = |verdict| findings.iter().any(|finding: &Finding| finding.verdict == verdict);
    let verdict = match () {
        () if has(Agreement::Differs) => Agreement::Differs,
        () if has(Agreement::Agrees) => Agreement::Agrees,
        () => Agreement::NotCompared,
    };
    Comparison { theory, simulation, findings, verdict, diagnosis: None }
}

/// Both sides of a comparison.
struct Side<'r> {
    run: &'r StatedRun,
    theory: &'r Theory,
    simulation: &'r Result<Simulation, String>,
}

const START: &str = "our run ends in steady sliding, so this belongs to its transient, which depends on the start: name it in a column `start`";
const STILL: &str = "our simulation does not oscillate";
const NO_PAIR: &str = "all roots of the linear theory are real";
const OTHER_END: &str = "the trajectory and our simulation end differently";

impl Side<'_> {
    fn findings(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        if let Some(mode) = self.run.mode {
            self.compare_mode(Origin::Column, mode, &mut findings);
        }
        for (observable, value) in self.run.stated() {
            self.compare_stated(observable, value, &mut findings);
        }
        if let Some(recording) = &self.run.recording {
            let level = nearest_f64(&self.run.parameters.point.loading_velocity_m_per_s);
            match recording.long_term(libm::log(level), self.returns_per_cycle()) {
                Ok(RecordedBehaviour::Cycle { peak_ratio, period_s, stress_drop_pa }) => {
                    self.compare_mode(
                        Origin::Trajectory,
                        StatedMode::Behaviour(Behaviour::Periodic),
                        &mut findings,
                    );
                    let peak = Measured { value: peak_ratio.value * level, ..peak_ratio };
                    self.compare_cycle([Some(peak), Some(period_s), stress_drop_pa], &mut findings);
                }
                Ok(RecordedBehaviour::Decay(decay)) => {
                    self.compare_mode(
                        Origin::Trajectory,
                        StatedMode::Behaviour(Behaviour::Decaying),
                        &mut findings,
                    );
                    self.compare_decay(decay, &mut findings);
                }
                Err(undecided) => {
                    let place = (Observable::Mode, Origin::Trajectory, Reference::Simulation);
                    let why = undecided.to_string();
                    findings.push(Finding::because(place, Value::None, Agreement::NotCompared, &why));
                }
            }
        }
        findings
    }

    /// Crossings of V = V_l in one period of our cycle; one for a decay.
    fn returns_per_cycle(&self) -> usize {
        let simulation = self.simulation.as_ref().ok();
        let both = simulation.and_then(|found| found.period_s.zip(found.frequency_hz));
        both.map_or(1, |(period, frequency)| libm::round(period * frequency).clamp(1.0, 64.0) as usize)
    }

    fn compare_mode(&self, origin: Origin, mode: StatedMode, findings: &mut Vec<Finding>) {
        let of_behaviour = |behaviour: Behaviour| behaviour.as_str();
        let (simulated, theory) = match mode {
            StatedMode::Behaviour(_) => (
                self.simulation.as_ref().map(|found| of_behaviour(found.behaviour)),
                self.theory.behaviour.map(of_behaviour),
            ),
            StatedMode::Slip(_) => (
                self.simulation.as_ref().map(|found| found.slip_mode.as_str()),
                Some(self.theory.slip_mode.as_str()),
            ),
        };
        findings.push(match simulated {
            Ok(word) => Finding::of_words(origin, Reference::Simulation, mode.as_str(), word),
            Err(why) => self.without_simulation(Observable::Mode, origin, Value::Word(mode.as_str()), why),
        });
        findings.push(self.theory_on_mode(origin, mode, simulated.ok(), theory));
    }

    /// The theory is linear: where our own simulation departs from it, it does not speak against a run.
    fn theory_on_mode(
        &self,
        origin: Origin,
        mode: StatedMode,
        simulated: Option<&'static str>,
        theory: Option<&'static str>,
    ) -> Finding {
        let place = (Observable::Mode, origin, Reference::Theory);
        let run = Value::Word(mode.as_str());
        let open = |why: &str| Finding::because(place, run, Agreement::NotCompared, why);
        let Some(word) = theory else {
            return open("on the transition the linear theory does not decide the long-term behaviour");
        };
        let mut found = Finding::of_words(origin, Reference::Theory, mode.as_str(), word);
        if found.verdict == Agreement::Differs && simulated.is_some_and(|simulated| simulated != word) {
            found.verdict = Agreement::NotCompared;
            found.why =
                "our simulation departs from the linear theory here, which holds for small deviations".into();
        }
        found
    }

    fn compare_stated(&self, observable: Observable, value: f64, findings: &mut Vec<Finding>) {
        let place = (observable, Origin::Column, Reference::Simulation);
        let run = Value::Number { value, relative_error: 0.0 };
        let simulation = match self.simulation {
            Ok(simulation) => simulation,
            Err(why) => {
                findings.push(self.without_simulation(observable, Origin::Column, run, why));
                // A cycle is not linear: only a decay has the theory's frequency.
                if self.theory.behaviour == Some(Behaviour::Decaying) {
                    self.compare_linear(observable, Origin::Column, (value, 0.0), findings);
                }
                return;
            }
        };
        let of_transient = matches!(observable, Observable::PeakVelocity | Observable::StressDrop)
            && simulation.behaviour == Behaviour::Decaying
            && !self.run.has_known_start;
        findings.push(match simulated(simulation, observable) {
            _ if of_transient => Finding::because(place, run, Agreement::NotCompared, START),
            Some(ours) => {
                self.numbers(observable, Origin::Column, Reference::Simulation, [(value, 0.0), ours])
            }
            None => Finding::because(place, run, Agreement::Differs, STILL),
        });
        if simulation.behaviour == Behaviour::Decaying {
            self.compare_linear(observable, Origin::Column, (value, 0.0), findings);
        }
    }

    /// Period, frequency and growth rate of a decay against the pair of the linear theory.
    fn compare_linear(
        &self,
        observable: Observable,
        origin: Origin,
        run: (f64, f64),
        findings: &mut Vec<Finding>,
    ) {
        let ours = match observable {
            Observable::Period => self.theory.frequency_hz.map(|frequency| 1.0 / frequency),
            Observable::Frequency => self.theory.frequency_hz,
            Observable::GrowthRate => Some(self.theory.growth_rate_per_s),
            Observable::Mode | Observable::PeakVelocity | Observable::StressDrop => return,
        };
        findings.push(match ours {
            Some(ours) => self.numbers(observable, origin, Reference::Theory, [run, (ours, THEORY_ERROR)]),
            None => {
                let value = Value::Number { value: run.0, relative_error: run.1 };
                Finding::because((observable, origin, Reference::Theory), value, Agreement::Differs, NO_PAIR)
            }
        });
    }

    fn compare_cycle(&self, measured: [Option<Measured>; 3], findings: &mut Vec<Finding>) {
        let observables = [Observable::PeakVelocity, Observable::Period, Observable::StressDrop];
        for (observable, measured) in observables.into_iter().zip(measured) {
            let Some(Measured { value, relative_error }) = measured else { continue };
            let run = Value::Number { value, relative_error };
            let place = (observable, Origin::Trajectory, Reference::Simulation);
            findings.push(match self.simulation {
                Err(why) => self.without_simulation(observable, Origin::Trajectory, run, why),
                Ok(ours) if ours.behaviour != Behaviour::Periodic => {
                    Finding::because(place, run, Agreement::NotCompared, OTHER_END)
                }
                Ok(ours) => match simulated(ours, observable) {
                    Some(ours) => {
                        let both = [(value, relative_error), ours];
                        self.numbers(observable, Origin::Trajectory, Reference::Simulation, both)
                    }
                    None => Finding::because(place, run, Agreement::Differs, STILL),
                },
            });
        }
    }

    fn compare_decay(&self, decay: RecordedDecay, findings: &mut Vec<Finding>) {
        let origin = Origin::Trajectory;
        if let Some(Measured { value, relative_error }) = decay.period_s {
            if let Ok(ours) = self.simulation
                && ours.behaviour == Behaviour::Decaying
            {
                let place = (Observable::Period, origin, Reference::Simulation);
                findings.push(match simulated(ours, Observable::Period) {
                    Some(ours) => {
                        let both = [(value, relative_error), ours];
                        self.numbers(Observable::Period, origin, Reference::Simulation, both)
                    }
                    None => Finding::because(
                        place,
                        Value::Number { value, relative_error },
                        Agreement::Differs,
                        STILL,
                    ),
                });
            }
            self.compare_linear(Observable::Period, origin, (value, relative_error), findings);
        }
        // The pair's rate is seen in returns; without returns the slowest root is, which is the last one when all are real.
        if let Some(Measured { value, relative_error }) = decay.rate_per_s
            && decay.period_s.is_some() == self.theory.frequency_hz.is_some()
        {
            self.compare_linear(Observable::GrowthRate, origin, (value, relative_error), findings);
        }
    }

    fn numbers(
        &self,
        observable: Observable,
        origin: Origin,
        reference: Reference,
        both: [(f64, f64); 2],
    ) -> Finding {
        Finding::of_numbers(observable, origin, reference, both, self.run.tolerance)
    }

    fn without_simulation(&self, observable: Observable, origin: Origin, run: Value, why: &str) -> Finding {
        let why = format!("our simulation failed: {why}");
        Finding::because((observable, origin, Reference::Simulation), run, Agreement::NotCompared, &why)
    }
}

/// A value of our simulation with its relative error.
fn simulated(found: &Simulation, observable: Observable) -> Option<(f64, f64)> {
    let with_period_error = |value: Option<f64>| value.zip(found.period_relative_error);
    match observable {
        Observable::PeakVelocity => Some((found.peak_velocity_m_per_s, found.peak_relative_error)),
        Observable::Period => with_period_error(found.period_s),
        Observable::StressDrop => Some((found.stress_drop_pa, found.stress_drop_relative_error)),
        Observable::Frequency => with_period_error(found.frequency_hz),
        Observable::Mode | Observable::GrowthRate => None,
    }
}
