//! Work against error of the integrators on the hard cases, and the time of sweeps and grids.
//!
//! Every method runs one period of the limit cycle from the same state on V = V_l. The reference is Radau IIA of order 13 in
//! double-double at a local tolerance of 1e-20. Printed per method and tolerance: steps (refused ones included), evaluations, time of
//! the best of several repetitions, and the errors of ln(V_peak/V_l) and of the duration. Steps and errors do not depend on the machine.
//! Omissions: Taylor series where a return would take more than a hundred thousand steps.

use std::time::Instant;

use slipmode_bench::integrators::{METHODS, MeasuredReturn, reference_return};
use slipmode_core::dynamics::{Control, Model, Options, simulate_model};
use slipmode_core::friction::{EvolutionLaw, Groups};

/// The paper's values at σ = 10^s Pa and V_l = 10^v m/s.
fn paper(v: f64, s: f64, direct_effect: f64, evolution_effect: f64) -> Groups<f64> {
    Groups {
        inertial_parameter: 1000.0 * libm::exp10(2.0 * v) / (libm::exp10(s) * direct_effect * 1e-5),
        stiffness_group: 100.0 / (direct_effect * libm::exp10(s)),
        effect_ratio: evolution_effect / direct_effect,
    }
}

/// Prints the returns of one method at several tolerances, with the best time of five.
fn measure(name: &str, orbit: impl Fn(f64) -> Option<MeasuredReturn<f64>>, exact: &MeasuredReturn<f64>) {
    for exponent in [3, 5, 7, 9, 11] {
        let tolerance = libm::exp10(-f64::from(exponent));
        let mut best = f64::INFINITY;
        let mut result = None;
        for _ in 0..5 {
            let began = Instant::now();
            result = orbit(tolerance);
            best = best.min(began.elapsed().as_secs_f64());
        }
        match result {
            Some(orbit) => println!(
                "  {name:<12} 1e-{exponent:<3} {:>7} {:>8} {:>9.1} {:>9.1e} {:>9.1e}",
                orbit.steps,
                orbit.evaluations,
                best * 1e6,
                (orbit.peak - exact.peak).abs(),
                (orbit.duration / exact.duration - 1.0).abs()
            ),
            None => println!("  {name:<12} 1e-{exponent:<3} not finished"),
        }
    }
}

fn work_precision() {
    for (v, s) in [(-5.5, 6.5), (-6.0, 7.5), (-5.0, 5.0), (-1.5, 4.0), (-1.0, 2.5)] {
        for law in EvolutionLaw::ALL {
            let model = Model::new(paper(v, s, 0.004, 0.006), law);
            let Some((section, exact)) = reference_return(&model) else { continue };
            println!("sigma 1e{s} Pa, V_l 1e{v} m/s, {} law, ln(V_peak/V_l) = {}", law.as_str(), exact.peak);
            println!("  method       local   steps    evals   time/us   err peak   err dur");
            for (name, run) in METHODS {
                let control = |local_tolerance| Control { local_tolerance, most_steps: 100_000 };
                measure(name, |tolerance| run(&model, &section, control(tolerance)).ok(), &exact);
            }
        }
    }
}

/// Runs a square grid of (V_l, σ) and prints failures, runs a second and the largest stated error.
fn grid(name: &str, side: u32, velocity: [f64; 2], stress: [f64; 2], effects: &[[f64; 2]], tolerance: f64) {
    let options = Options::at(tolerance);
    let at = |[low, high]: [f64; 2], i: u32| low + (high - low) * f64::from(i) / f64::from(side - 1);
    let (mut runs, mut failures, mut steps) = (0u32, 0u32, 0u64);
    let began = Instant::now();
    for &[a, b] in effects {
        for law in EvolutionLaw::ALL {
            for (i, j) in (0..side * side).map(|cell| (cell / side, cell % side)) {
                let model = Model::new(paper(at(velocity, i), at(stress, j), a, b), law);
                runs += 1;
                match simulate_model(&model, &options) {
                    Ok(outcome) => steps += outcome.steps(),
                    Err(_) => failures += 1,
                }
            }
        }
    }
    let seconds = began.elapsed().as_secs_f64();
    println!(
        "{name}: {runs} runs, {failures} failures, {steps} steps, {seconds:.2} s on one core, {:.0} runs/s",
        f64::from(runs) / seconds
    );
}

fn main() {
    work_precision();
    let unstable = [0.004, 0.006];
    grid("figures 3 and 6 at 1e-8", 21, [-6.0, -1.0], [2.5, 7.5], &[unstable, [0.006, 0.004]], 1e-8);
    grid("sweep at 1e-2", 20, [-6.0, -1.0], [3.0, 7.0], &[unstable], 1e-2);
}
