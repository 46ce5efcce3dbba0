//! Where nothing is stiff (η ≫ 1): two hundred samples of a harmonic vibration and of an inertial underdamped oscillation.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use slipmode_core::dynamics::{Control, Integrator, Model, Radau, Scalar, Start, State, Stepper, Taylor};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Dd;

use super::cycles::{Line, line_start, paper, read_lines};
use super::row::{Row, scientific, tolerances};
use slipmode_bench::cpu_clock::best_of;

const SAMPLES: usize = 200;
const PERIODS: f64 = 10.0;
const REPETITIONS: usize = 5;

/// A name, log10 of V_l and σ, a and b.
const PLACES: [(&str, f64, f64, f64, f64); 2] =
    [("harmonic", -1.5, 4.0, 0.004, 0.006), ("underdamped", -1.5, 4.0, 0.006, 0.004)];

/// The samples, and how many steps and evaluations they took; none when the run fails.
pub fn samples<R: Scalar, M: Stepper<R>>(
    model: &Model<R>,
    method: M,
    start: State<R>,
    until: &R,
    local_tolerance: f64,
) -> Option<(Vec<State<R>>, u64, u64)> {
    let control = Control { local_tolerance, most_steps: 1_000_000 };
    let mut run = Integrator::new(model, method, start.clone(), control).ok()?;
    let mut found = Vec::with_capacity(SAMPLES);
    let mut began = R::from(0);
    while found.len() < SAMPLES {
        run.advance(Some(&(until.clone() - &began))).ok()?;
        let ends = run.time();
        loop {
            let time = until.clone() * R::from(found.len() as i32 + 1) / R::from(SAMPLES as i32);
            // The end itself may be missed by a rounding of the clock.
            let is_last =
                found.len() + 1 == SAMPLES && (until.clone() - &ends).to_f64() < 1e-13 * until.to_f64();
            if found.len() == SAMPLES || (time > ends && !is_last) {
                break;
            }
            let theta = (time - &began) / run.step();
            found.push(run.state_within(&theta));
        }
        began = ends;
    }
    Some((found, run.step_counts().0 + run.step_counts().1, run.method().evaluations()))
}

/// Name, law, groups, start, the time to run, and the state at its end by Radau IIA 13 in double-double; none when that fails.
pub fn line_with_reference(name: &str, model: &Model<f64>) -> Option<String> {
    let [x, y, z] = Start::default().at_a_tenth(model);
    let g = model.groups();
    let until = PERIODS * std::f64::consts::TAU * (g.inertial_parameter / g.stiffness_group).sqrt();
    let fine = Model::new(g.map(|&g| Dd::from(g)), model.law());
    let start = [x, y, z].map(Dd::from);
    let (found, ..) = samples(&fine, Radau::<Dd, 7>::new(), start, &Dd::from(until), 1e-20)?;
    let [xe, ye, ze] = found[SAMPLES - 1].map(|part| part.to_f64());
    let head = line_start(name, model);
    Some(format!("{head} {x:e} {y:e} {z:e} {until:e} {xe:e} {ye:e} {ze:e}"))
}

/// Writes `smooth.txt`.
pub fn prepare(folder: &Path) {
    let mut text = String::new();
    for (name, v, s, a, b) in PLACES {
        for law in EvolutionLaw::ALL {
            let model = Model::new(paper(v, s, a, b), law);
            let line = line_with_reference(&format!("{name}-{}", law.as_str()), &model);
            line.into_iter().for_each(|line| writeln!(text, "{line}").unwrap());
        }
    }
    fs::write(folder.join("smooth.txt"), text).unwrap();
}

fn measure<M: Stepper<f64> + Clone>(name: &'static str, line: &Line, method: &M) {
    let start = [line.rest[0], line.rest[1], line.rest[2]];
    for tolerance in tolerances() {
        let (seconds, found) =
            best_of(REPETITIONS, || samples(&line.model, method.clone(), start, &line.rest[3], tolerance));
        let distance =
            |end: &State<f64>| (0..3).fold(0.0f64, |d, i| d.max((end[i] - line.rest[4 + i]).abs()));
        Row {
            work: format!("smooth-{}", line.name),
            method: name,
            options: "one~run~at~a~time",
            tolerance: Some(tolerance),
            items: 1,
            seconds,
            error: found.as_ref().map(|(found, ..)| scientific(distance(&found[SAMPLES - 1]))),
            wrong: usize::from(found.is_none()),
            counts: found.map(|(_, steps, evaluations)| (steps, evaluations)),
        }
        .print();
    }
}

/// Taylor series of two degrees, and the implicit method for comparison.
pub fn play(folder: &Path) {
    for line in read_lines(&folder.join("smooth.txt")) {
        measure("slipmode-taylor16", &line, &Taylor::<f64, 16>::new());
        measure("slipmode-taylor20", &line, &Taylor::<f64, 20>::new());
        measure("slipmode-radau9", &line, &Radau::<f64, 5>::new());
    }
}
