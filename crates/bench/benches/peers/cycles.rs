//! One stick-slip cycle from V = V_l to the next upward crossing of it: time against the error of peak and duration.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use slipmode_bench::integrators::Rodas5P;
use slipmode_core::dynamics::{
    Control, Integrator, LongTerm, Model, Radau, Scalar, Start, State, Stepper, long_term_behaviour,
    next_return,
};
use slipmode_core::friction::{EvolutionLaw, Groups};
use slipmode_core::number::Dd;

use super::row::{Row, scientific, tolerances};
use slipmode_bench::cpu_clock::best_of;

const REPETITIONS: usize = 3;

/// log10 of V_l in m/s and of σ in Pa, at the paper's other values.
const PLACES: [(f64, f64); 5] = [(-5.5, 6.5), (-6.0, 7.5), (-5.0, 5.0), (-1.5, 4.0), (-1.0, 2.5)];

/// The paper's values at σ = 10^s Pa and V_l = 10^v m/s.
pub fn paper(v: f64, s: f64, direct_effect: f64, evolution_effect: f64) -> Groups<f64> {
    Groups {
        inertial_parameter: 1000.0 * libm::exp10(2.0 * v) / (libm::exp10(s) * direct_effect * 1e-5),
        stiffness_group: 100.0 / (direct_effect * libm::exp10(s)),
        effect_ratio: evolution_effect / direct_effect,
    }
}

/// One line of an input file: a name, the law, numbers.
pub struct Line {
    /// The name.
    pub name: String,
    /// The model that law and the first three numbers give.
    pub model: Model<f64>,
    /// The numbers after the groups.
    pub rest: Vec<f64>,
}

/// Reads an input file of the simulations.
pub fn read_lines(path: &Path) -> Vec<Line> {
    let parse = |line: &str| {
        let cells: Vec<&str> = line.split(' ').collect();
        let law = EvolutionLaw::ALL.into_iter().find(|law| law.as_str() == cells[1]).unwrap();
        let numbers: Vec<f64> = cells[2..].iter().map(|cell| cell.parse().unwrap()).collect();
        let groups =
            Groups { inertial_parameter: numbers[0], stiffness_group: numbers[1], effect_ratio: numbers[2] };
        Line { name: cells[0].to_string(), model: Model::new(groups, law), rest: numbers[3..].to_vec() }
    };
    fs::read_to_string(path).unwrap().lines().map(parse).collect()
}

/// The start of such a line.
pub fn line_start(name: &str, model: &Model<f64>) -> String {
    let g = model.groups();
    let law = model.law().as_str();
    format!("{name} {law} {:e} {:e} {:e}", g.inertial_parameter, g.stiffness_group, g.effect_ratio)
}

struct MeasuredCycle {
    peak_and_duration: [f64; 2],
    steps: u64,
    evaluations: u64,
}

fn run_cycle<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: M,
    section: &[f64],
    local_tolerance: f64,
) -> Option<MeasuredCycle> {
    let control = Control { local_tolerance, most_steps: 200_000 };
    let start: State<R> = std::array::from_fn(|i| R::from_f64(section[i]));
    let mut run = Integrator::new(model, method, start, control).ok()?;
    let (orbit, _) = next_return(&mut run).ok()?;
    let (accepted, refused) = run.step_counts();
    Some(MeasuredCycle {
        peak_and_duration: [orbit.peak.to_f64(), orbit.duration.to_f64()],
        steps: accepted + refused,
        evaluations: run.method().evaluations(),
    })
}

/// Writes `cycles.txt`: name, law, groups, the state on V = V_l, ln(V_peak/V_l) and the duration by Radau IIA 13 in double-double.
pub fn prepare(folder: &Path) {
    let mut text = String::new();
    for (v, s) in PLACES {
        for law in EvolutionLaw::ALL {
            let model = Model::new(paper(v, s, 0.004, 0.006), law);
            let control = Control { local_tolerance: 1e-9, most_steps: 10_000_000 };
            let start = Start::default().at_a_tenth(&model);
            let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), start, control).unwrap();
            let Ok(LongTerm::Cycle(_)) = long_term_behaviour(&mut run, 1e-9, 10_000) else { continue };
            let [x, y, z] = *run.state();
            let fine = Model::new(model.groups().map(|&g| Dd::from(g)), law);
            let Some(exact) = run_cycle(&fine, Radau::<Dd, 7>::new(), &[x, y, z], 1e-20) else { continue };
            let [peak, duration] = exact.peak_and_duration;
            let name = format!("v{v}s{s}{}", law.as_str());
            let head = line_start(&name, &model);
            writeln!(text, "{head} {x:e} {y:e} {z:e} {peak:e} {duration:e}").unwrap();
        }
    }
    fs::write(folder.join("cycles.txt"), text).unwrap();
}

fn measure<M: Stepper<f64> + Clone>(name: &'static str, line: &Line, method: &M) {
    for tolerance in tolerances() {
        let (seconds, found) =
            best_of(REPETITIONS, || run_cycle(&line.model, method.clone(), &line.rest, tolerance));
        let error = found.as_ref().map(|found| {
            let [peak, duration] = found.peak_and_duration;
            scientific((peak - line.rest[3]).abs().max((duration / line.rest[4] - 1.0).abs()))
        });
        Row {
            work: format!("cycles-{}", line.name),
            method: name,
            options: "analytic~Jacobian",
            tolerance: Some(tolerance),
            items: 1,
            seconds,
            error,
            wrong: usize::from(found.is_none()),
            counts: found.map(|found| (found.steps, found.evaluations)),
        }
        .print();
    }
}

/// Every method of ours at every tolerance.
pub fn play(folder: &Path) {
    for line in read_lines(&folder.join("cycles.txt")) {
        measure("slipmode-rodas5p", &line, &Rodas5P::new());
        measure("slipmode-radau5", &line, &Radau::<f64, 3>::new());
        measure("slipmode-radau9", &line, &Radau::<f64, 5>::new());
        measure("slipmode-radau13", &line, &Radau::<f64, 7>::new());
    }
}
