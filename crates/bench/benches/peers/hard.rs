//! The hard families: double roots, K = K_c and triple roots, exactly in 64-bit inputs and at distances down to one rounding.

use slipmode_core::friction::Parameters;

use super::random::Random;

/// Zero and ±1e-6 … ±1e-16: how far a point lies from the place that its family is about, relative.
fn distance(number: usize) -> f64 {
    let exponent = number % 12;
    let sign = if (number / 12).is_multiple_of(2) { 1.0 } else { -1.0 };
    if exponent == 0 { 0.0 } else { sign * libm::exp10(-5.0 - exponent as f64) }
}

/// Inputs whose units are 1: short binary numbers, so that their products are exact.
fn slider(direct_effect: f64, evolution_effect: f64, stiffness: f64, mass: f64) -> Parameters<f64> {
    Parameters::from([direct_effect, evolution_effect, 1.0, stiffness, mass, 1.0, 1.0])
}

/// On the lower arc with double root r, a multiple of 1/64; then K times 1 + ε.
fn double_root(random: &mut Random, epsilon: f64) -> Parameters<f64> {
    let ratio = random.sixty_fourths(0.25, 4.0);
    let r = -1.0 - (64.0 * ratio.sqrt()).ceil() / 64.0 - random.sixty_fourths(0.1, 6.0);
    let square = (r + 1.0) * (r + 1.0);
    let direct = (2.0 * r * square).abs();
    let stiffness = (r * r * ((2.0 * r + 1.0) * ratio - square)).abs();
    slider(direct, ratio * direct, stiffness * (1.0 + epsilon), (ratio - square).abs())
}

/// On K = K_c with b > a; then K times 1 + ε.
fn transition(random: &mut Random, epsilon: f64) -> Parameters<f64> {
    let ratio = random.sixty_fourths(1.1, 8.0);
    let inertia = random.sixty_fourths(0.1, 8.0);
    slider(1.0, ratio, (ratio - 1.0) * (1.0 + inertia) * (1.0 + epsilon), inertia)
}

/// At the triple root r, a multiple of 1/64; then b times 1 + ε.
fn triple_root(random: &mut Random, epsilon: f64) -> Parameters<f64> {
    let r = -1.0 - random.sixty_fourths(0.1, 8.0);
    let cube = |x: f64| (x * x * x).abs();
    slider((3.0 * r + 1.0).abs(), cube(r + 1.0) * (1.0 + epsilon), cube(r), 1.0)
}

/// Points of a family: `disc`, `hopf` or `cusp`.
pub fn points(family: &str, count: usize) -> Vec<Parameters<f64>> {
    let place = match family {
        "disc" => double_root,
        "hopf" => transition,
        _ => triple_root,
    };
    let mut random = Random::new(family.len() as u64 + u64::from(family.as_bytes()[0]));
    (0..count).map(|number| place(&mut random, distance(number))).collect()
}
