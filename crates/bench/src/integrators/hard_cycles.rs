//! Cycles where integrators go wrong, each from a state on V = V_l to the next upward crossing: V down to 1e-79 V_l, K next to K_c, no inertia, tolerances below rounding; every method of ours
//! against references from an unrelated program, and what a whole simulation says.

use rayon::prelude::*;

use super::returns::{METHODS, MeasuredReturn};
use slipmode::scene::{CsvProblem, Fault, Faults, Problem};
use slipmode_core::dynamics::{Behaviour, Control, Failure, Model, Options, Outcome, State, simulate_model};
use slipmode_core::friction::{EvolutionLaw, Groups, Parameters};
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};

/// A cycle with the answers of an independent program.
#[derive(Debug, Clone, PartialEq)]
pub struct HardCycle {
    /// What makes it hard.
    pub family: String,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η, κ, β.
    pub groups: Groups<f64>,
    /// The state on V = V_l.
    start: State<f64>,
    /// ln(V_peak/V_l).
    log_peak: f64,
    /// ln(V_min/V_l).
    pub log_trough: f64,
    /// Duration, D_c/V_l.
    duration: f64,
}

/// What one method did with a cycle, or a simulation with the slider.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodVerdict {
    /// The method.
    pub method: &'static str,
    /// The tolerance requested: local for a cycle, of the answer for a simulation.
    pub tolerance: f64,
    /// The larger of the errors of ln V_peak and of the duration, relative; or why there is no answer.
    pub answer: Result<MethodAnswer, Failure>,
}

/// The answer of one method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodAnswer {
    /// Of a cycle the error, of a simulation the error that it states.
    pub error: f64,
    /// What a simulation ends in.
    pub behaviour: Option<Behaviour>,
}

/// One cycle by every method.
#[derive(Debug, Clone, PartialEq)]
pub struct HardCycleOutcome {
    /// The cycle.
    pub case: HardCycle,
    /// Method by method, tolerance by tolerance.
    pub verdicts: Vec<MethodVerdict>,
}

const COLUMNS: [&str; 10] = [
    "family",
    "law",
    "inertial_parameter",
    "stiffness_group",
    "effect_ratio",
    "start_y",
    "start_z",
    "expected_log_peak",
    "expected_log_trough",
    "expected_duration",
];

/// Reads a file of cycles: CSV with these columns in this order, and `#` lines of words.
///
/// # Errors
/// A header or a row of other columns, and what is not a number, each with its line.
pub fn read_hard_cycles(file: &str, text: &str) -> Result<Vec<HardCycle>, Faults> {
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.starts_with('#'));
    let fault = |line, key: &str, value: Option<&str>, problem| {
        vec![Fault {
            file: file.into(),
            line: Some(line),
            key: key.into(),
            value: value.map(str::to_owned),
            problem,
        }]
    };
    let wanted = COLUMNS.join(",");
    match lines.next() {
        Some((_, header)) if header == wanted => {}
        found => {
            let line = found.map_or(1, |(line, _)| line);
            return Err(fault(line, "", None, CsvProblem::NoHeader(wanted).into()));
        }
    }
    let read = |(line, row): (usize, &str)| {
        let cells: Vec<&str> = row.split(',').collect();
        if cells.len() != COLUMNS.len() {
            let problem = CsvProblem::CellCount { found: cells.len(), wanted: COLUMNS.len() };
            return Err(fault(line, "", None, problem.into()));
        }
        let number = |column: usize| {
            let refused = |reason| Problem::NotANumber { reason, allowed: None };
            let read = parse_decimal(cells[column]).map(|value: Rational| nearest_f64(&value));
            read.map_err(|reason| fault(line, COLUMNS[column], Some(cells[column]), refused(reason)))
        };
        let law = EvolutionLaw::from_word(cells[1]);
        let unknown = || {
            let problem = Problem::UnknownWord { nearest: None, allowed: "aging, slip".into() };
            fault(line, COLUMNS[1], Some(cells[1]), problem)
        };
        Ok(HardCycle {
            family: cells[0].to_owned(),
            law: law.ok_or_else(unknown)?,
            groups: Groups {
                inertial_parameter: number(2)?,
                stiffness_group: number(3)?,
                effect_ratio: number(4)?,
            },
            start: [0.0, number(5)?, number(6)?],
            log_peak: number(7)?,
            log_trough: number(8)?,
            duration: number(9)?,
        })
    };
    lines.map(read).collect()
}

/// Local tolerances of the cycles: an ordinary one, and two below what 64 bits can tell.
const TOLERANCES: [f64; 3] = [1e-9, 1e-16, 1e-20];

/// Tolerances of the simulations: an ordinary one, and one below rounding.
const ASKED: [f64; 2] = [1e-8, 1e-16];

/// The most steps of a cycle: ten times what the hardest one takes.
const MOST_STEPS: u64 = 20_000;

/// Every case by every method.
#[must_use]
pub fn run_hard_cycles(cases: &[HardCycle]) -> Vec<HardCycleOutcome> {
    cases.par_iter().map(|case| HardCycleOutcome { case: case.clone(), verdicts: verdicts(case) }).collect()
}

fn verdicts(case: &HardCycle) -> Vec<MethodVerdict> {
    let model = Model::new(case.groups.clone(), case.law);
    let returns = METHODS.into_iter().flat_map(|(method, run)| {
        let model = &model;
        // A method that does not finish at an ordinary tolerance is not run at a tighter one.
        let mut stopped = false;
        TOLERANCES.into_iter().map_while(move |tolerance| {
            if stopped {
                return None;
            }
            let answer =
                run(model, &case.start, Control { local_tolerance: tolerance, most_steps: MOST_STEPS })
                    .map(|orbit| case.assess(&orbit));
            stopped = answer.is_err();
            Some(MethodVerdict { method, tolerance, answer })
        })
    });
    let whole = ASKED.map(|tolerance| {
        let options = Options { most_returns: MOST_RETURNS, ..Options::at(tolerance) };
        MethodVerdict {
            method: "simulation",
            tolerance,
            answer: simulate_model(&model, &options).map(stated),
        }
    });
    returns.chain(whole).collect()
}

/// Oscillations of a whole simulation before it is called undecided.
const MOST_RETURNS: u64 = 1_000;

fn stated(outcome: Outcome) -> MethodAnswer {
    // Units in which an outcome is what it is.
    let found = outcome.in_si(&Parameters::from([1.0; 7]));
    let error = found.peak_relative_error.max(found.period_relative_error.unwrap_or(0.0));
    MethodAnswer { error, behaviour: Some(found.behaviour) }
}

impl HardCycle {
    fn assess(&self, orbit: &MeasuredReturn<f64>) -> MethodAnswer {
        // The peak of a small oscillation is itself the measure of its error.
        let peak = (orbit.peak - self.log_peak).abs() / self.log_peak.abs().min(1.0);
        let duration = (orbit.duration / self.duration - 1.0).abs();
        MethodAnswer { error: peak.max(duration), behaviour: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcomes() -> Vec<HardCycleOutcome> {
        let text = include_str!("../../../../reports/im-avouac/timings/simulation-hard.txt");
        run_hard_cycles(&read_hard_cycles("simulation-hard.txt", text).unwrap())
    }

    #[test]
    fn order_nine_finishes_every_return_and_no_answer_is_far_from_the_reference() {
        let outcomes = outcomes();
        assert!(outcomes.len() >= 10, "{}", outcomes.len());
        assert!(outcomes.iter().any(|found| found.case.log_trough < -149.0));
        for found in &outcomes {
            let of = |method| found.verdicts.iter().filter(move |verdict| verdict.method == method);
            for verdict in of("Radau IIA 9").chain(of("Radau IIA 13")) {
                assert!(
                    verdict.answer.as_ref().is_ok_and(|answer| answer.error < 1e-10),
                    "{:?} {verdict:?}",
                    found.case
                );
            }
            // Low orders run out of steps where more is requested than 64 bits hold; what they answer is right.
            for verdict in of("Radau IIA 5").chain(of("Rodas5P")) {
                let answer = verdict.answer.as_ref();
                assert!(
                    answer.map_or(verdict.tolerance < 1e-15, |answer| answer.error < 1e-8),
                    "{verdict:?}"
                );
            }
        }
    }

    #[test]
    fn a_simulation_at_a_tolerance_below_rounding_refuses_or_meets_it() {
        for found in outcomes() {
            let below = found
                .verdicts
                .iter()
                .find(|verdict| verdict.method == "simulation" && verdict.tolerance < 1e-15);
            let answer = &below.unwrap().answer;
            assert!(
                answer
                    .as_ref()
                    .map_or_else(|failure| !failure.to_string().is_empty(), |answer| answer.error <= 1e-16),
                "{:?} {answer:?}",
                found.case
            );
        }
    }

    #[test]
    fn a_file_that_is_no_list_of_cycles_is_refused_with_its_line() {
        for (text, named) in [
            ("", "1: empty"),
            ("family,law\n", "1: empty"),
            (&format!("{}\nf,slip,1,1,1,0,1,1,1\n", COLUMNS.join(",")), "2: 9 cells"),
            (&format!("{}\nf,fast,1,1,1,0,1,1,1,1\n", COLUMNS.join(",")), "2: law = fast"),
            (&format!("{}\nf,slip,x,1,1,0,1,1,1,1\n", COLUMNS.join(",")), "2: inertial_parameter = x"),
        ] {
            let faults = read_hard_cycles("laps.txt", text).unwrap_err();
            assert!(faults[0].to_string().contains(named), "{}", faults[0]);
        }
    }
}
