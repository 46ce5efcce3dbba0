//! `simulate --smallest-kick`: kicks just below and above the smallest are followed by an integrator of this file.

use serde_json::Value;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{nearest_f64, parse_decimal};
use slipmode_theory::hopf::square_amplitude;

use crate::harness::{SLIDER, Workplace};

const ETA: f64 = 0.024_877_467_105_263_157;
const BETA: f64 = 1.5;

/// The paper's slider at 0.22 mm/s: η is that above and K/K_c = 1.003 at 48640 Pa; the edge of bistability is at 1.0059.
fn found(stress: &str, law: &str) -> Value {
    let point = ["-s", stress, "-v", "2.2e-4", "--law", law, "--smallest-kick", "--json"];
    let ended = Workplace::new().run(["simulate"].iter().chain(&SLIDER).chain(&point).copied());
    serde_json::from_str(&ended.expect_success()).unwrap()
}

/// V/V0 - 1 of both kicks of velocity, then the change of stress over aσ of both kicks of stress.
fn ratios(found: &Value) -> [Option<f64>; 4] {
    let kicks = found["smallest_kicks"]["kicks"].as_array().unwrap();
    let names: Vec<_> = kicks.iter().map(|kick| kick["kick"].as_str().unwrap()).collect();
    assert_eq!(names, ["velocity-up", "velocity-down", "stress-up", "stress-down"]);
    [0, 1, 2, 3].map(|index| kicks[index]["ratio"].as_f64())
}

/// The slider with the aging law, written independently: x = ln(V/V0), y = ln(V0 θ/D_c), and the stress of the spring over aσ.
fn rates(kappa: f64, [x, y, zeta]: [f64; 3]) -> [f64; 3] {
    let velocity = x.exp();
    [(zeta - x - BETA * y) / (ETA * velocity), (-y).exp() - velocity, kappa * (1.0 - velocity)]
}

/// ln(V_peak/V0) at the end of a long run, by steps of the classical fourth-order method that resolve η V/V0.
fn late_peak(kappa: f64, mut state: [f64; 3]) -> f64 {
    const STEP: f64 = 0.005;
    const STEPS: u32 = 3_000_000;
    let mut peak = f64::NEG_INFINITY;
    for step in 0..STEPS {
        let along = |rate: [f64; 3], h: f64| [0, 1, 2].map(|n| state[n] + h * rate[n]);
        let k1 = rates(kappa, state);
        let k2 = rates(kappa, along(k1, STEP / 2.0));
        let k3 = rates(kappa, along(k2, STEP / 2.0));
        let k4 = rates(kappa, along(k3, STEP));
        state = [0, 1, 2].map(|n| state[n] + STEP / 6.0 * (k1[n] + 2.0 * (k2[n] + k3[n]) + k4[n]));
        // Two periods of the linear oscillation.
        if step > STEPS - 4000 {
            peak = peak.max(state[0]);
        }
    }
    peak
}

#[test]
fn kicks_just_below_decay_and_kicks_just_above_reach_the_cycle() {
    let found = found("48640", "aging");
    let kappa = 1e7 * 1e-5 / (0.004 * 48640.0);
    let cycle = (found["peak_velocity_m_per_s"].as_f64().unwrap() / 2.2e-4).ln();
    let [up, down, loaded, unloaded] = ratios(&found);
    assert_eq!((found["smallest_kicks"]["strength"].as_str(), down), (Some("sampled"), None));
    let after_velocity = |ratio: f64| [ratio.ln_1p(), 0.0, 0.0];
    let after_stress = |ratio: f64| [0.0, 0.0, ratio];
    for (ratio, after) in [
        (up, &after_velocity as &dyn Fn(f64) -> [f64; 3]),
        (loaded, &after_stress),
        (unloaded, &after_stress),
    ] {
        let ratio = ratio.unwrap();
        let [below, above] = [0.999, 1.001].map(|part| late_peak(kappa, after(part * ratio)));
        assert!(below < 0.1 * cycle, "{ratio} {below}");
        assert!((above / cycle - 1.0).abs() < 1e-4, "{ratio} {above} {cycle}");
    }
    let kicks = &found["smallest_kicks"]["kicks"];
    let size = |index: usize, name: &str| kicks[index][name].as_f64().unwrap();
    assert!((size(0, "velocity_change_m_per_s") / (2.2e-4 * up.unwrap()) - 1.0).abs() < 1e-12);
    assert!((size(2, "stress_change_pa") / (0.004 * 48640.0 * loaded.unwrap()) - 1.0).abs() < 1e-12);
    assert!(
        (0.0..1e-5).contains(&size(0, "relative_error")) && (0.0..1e-5).contains(&size(2, "relative_error"))
    );
}

#[test]
fn no_kick_leaves_with_the_slip_law_or_beyond_the_strip() {
    for (stress, law) in [("48640", "slip"), ("48000", "aging")] {
        let found = found(stress, law);
        assert_eq!(ratios(&found), [None; 4], "{stress} {law}");
        assert_eq!(found["smallest_kicks"]["conclusion"], "No tried kick leaves steady sliding.");
        let largest = &found["smallest_kicks"]["kicks"][3]["largest_ratio"];
        assert_eq!(largest, -10.0);
    }
}

#[test]
fn below_the_critical_stiffness_every_kick_leaves() {
    for law in ["slip", "aging"] {
        let found = found("1e5", law);
        assert_eq!(ratios(&found), [Some(0.0); 4], "{law}");
        assert_eq!(found["smallest_kicks"]["strength"], "exact");
    }
}

#[test]
fn at_the_critical_stiffness_the_lyapunov_coefficient_decides() {
    // η = 0.02, κ = 0.51 and β = 1.5 are decimals: K = K_c exactly.
    let slider = ["-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "5.1e6", "-m", "2000", "-s", "25000"];
    let found = |law: &str| -> (i32, Value) {
        let more = ["-v", "1e-4", "--law", law, "--smallest-kick", "--json"];
        let ended = Workplace::new().run(["simulate"].iter().chain(&slider).chain(&more).copied());
        (ended.code, serde_json::from_str(&ended.stdout).unwrap())
    };
    let (code, aging) = found("aging");
    assert_eq!((code, ratios(&aging)), (0, [Some(0.0); 4]));
    assert_eq!(aging["smallest_kicks"]["strength"], "exact");
    // Small disturbances decay more slowly than a return shows.
    let (code, slip) = found("slip");
    assert_eq!((code, &slip["smallest_kicks"]), (1, &Value::Null));
}

#[test]
fn error_bars_and_rows_are_refused() {
    let place = Workplace::new();
    let more = ["-v", "2.2e-4", "--law", "aging", "--smallest-kick"];
    let bars = ["-s", "48640±10"];
    place
        .run(["simulate"].iter().chain(&SLIDER).chain(&bars).chain(&more).copied())
        .expect_refusal(&["--smallest-kick: needs values without error bars"]);
    place.run(["simulate", "--points", "in.csv", "--law", "aging", "--smallest-kick"]).expect_refusal(&[
        "--smallest-kick",
        "cannot be used with",
        "--points",
    ]);
}

/// Amplitude of ln(V/V0) of the oscillation that a small kick of stress excites at K = K_c, over the kick: the part of the kick along the
/// left eigenvector of s = i√(β − 1).
fn excited(eta: f64) -> f64 {
    let omega_squared = BETA - 1.0;
    let kappa = omega_squared * (1.0 + eta);
    // η + β/(1 + s)² − κ/s², with 1/(1 + s)² = (1 − s)²/(1 + ω²)².
    let shrunk = BETA / ((1.0 + omega_squared) * (1.0 + omega_squared));
    let real = eta + shrunk * (1.0 - omega_squared) + kappa / omega_squared;
    let imaginary = -2.0 * shrunk * omega_squared.sqrt();
    2.0 / (omega_squared.sqrt() * real.hypot(imaginary))
}

#[test]
fn small_kicks_approach_what_the_lyapunov_coefficient_says() {
    let square = nearest_f64(
        &square_amplitude(
            EvolutionLaw::Aging,
            &parse_decimal("0.02").unwrap(),
            &parse_decimal("1.5").unwrap(),
        )
        .unwrap(),
    );
    let deviation = |stiffness: &str, excess: f64| {
        let slider = ["-a", "0.004", "-b", "0.006", "-d", "1e-5", "-m", "2000", "-s", "25000", "-v", "1e-4"];
        let more = ["-k", stiffness, "--law", "aging", "--smallest-kick", "--json"];
        let ended = Workplace::new().run(["simulate"].iter().chain(&slider).chain(&more).copied());
        let [_, _, up, down] = ratios(&serde_json::from_str(&ended.expect_success()).unwrap());
        // What is even in the kick differs between up and down by a part as the amplitude, and cancels in the mean.
        let mean = 0.5 * (up.unwrap() - down.unwrap());
        mean * excited(0.02) / (square * excess).sqrt() - 1.0
    };
    let [small, large] = [deviation("5.1005100e6", 1e-4), deviation("5.105100e6", 1e-3)];
    // The next term is as the square of the amplitude, and so as K/K_c - 1: a tenth.
    assert!((large / small - 10.0).abs() < 2.0, "{small} {large}");
}
