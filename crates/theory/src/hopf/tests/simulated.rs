//! Cycles of the nonlinear slider next to K = K_c, integrated, against the amplitude and frequency predicted.

use crate::hopf::closed_form::stated;
use crate::hopf::*;
use slipmode_core::number::nearest_f64;

const EFFECT_RATIO: f64 = 1.5;
const STEPS_PER_CYCLE: usize = 1_000;

type State = [f64; 3];

/// The slider of the derivation, in numbers and written independently of it.
struct Slider {
    law: EvolutionLaw,
    eta: f64,
    kappa: f64,
}

impl Slider {
    fn near(law: EvolutionLaw, eta: f64, distance: f64) -> Self {
        Self { law, eta, kappa: (EFFECT_RATIO - 1.0) * (1.0 + eta) * (1.0 + distance) }
    }

    fn rates(&self, [x, y, zeta]: State) -> State {
        let velocity = libm::exp(x);
        let evolution = match self.law {
            EvolutionLaw::Slip => -velocity * (x + y),
            EvolutionLaw::Aging => libm::exp(-y) - velocity,
        };
        [(zeta - x - EFFECT_RATIO * y) / (self.eta * velocity), evolution, self.kappa * (1.0 - velocity)]
    }

    /// One step of the classical fourth-order method. Its spurious growth per step is (ωh)⁶/144: below 1e-15 here.
    fn step(&self, state: State, h: f64) -> State {
        let along = |rate: State, h: f64| [0, 1, 2].map(|n| state[n] + h * rate[n]);
        let k1 = self.rates(state);
        let k2 = self.rates(along(k1, h / 2.0));
        let k3 = self.rates(along(k2, h / 2.0));
        let k4 = self.rates(along(k3, h));
        [0, 1, 2].map(|n| state[n] + h / 6.0 * (k1[n] + 2.0 * (k2[n] + k3[n]) + k4[n]))
    }

    /// From (0, y, ζ) to the next rise of x through zero: y and ζ there, and the time it took.
    fn next_return(&self, [y, zeta]: [f64; 2]) -> ([f64; 2], f64) {
        let h = period() / STEPS_PER_CYCLE as f64;
        let (mut state, mut time, mut below) = ([0.0, y, zeta], 0.0, false);
        loop {
            let next = self.step(state, h);
            if below && next[0] >= 0.0 {
                break;
            }
            below = next[0] < 0.0;
            (state, time) = (next, time + h);
        }
        // Newton on the length of the last step.
        let mut last = h / 2.0;
        for _ in 0..6 {
            let reached = self.step(state, last);
            last -= reached[0] / self.rates(reached)[0];
        }
        let [_, y, zeta] = self.step(state, last);
        ([y, zeta], time + last)
    }

    /// The cycle through Newton's method on the return map: it finds stable and unstable cycles alike.
    fn cycle(&self, amplitude: f64) -> ([f64; 2], f64) {
        let mut point = section_point(amplitude, self.eta);
        for _ in 0..12 {
            let width = 1e-5 * amplitude;
            let (image, _) = self.next_return(point);
            let column = |n: usize| {
                let moved = |by: f64| {
                    let mut shifted = point;
                    shifted[n] += by;
                    self.next_return(shifted).0
                };
                let (plus, minus) = (moved(width), moved(-width));
                [0, 1].map(|m| (plus[m] - minus[m]) / (2.0 * width))
            };
            let (first, second) = (column(0), column(1));
            let (a, b, c, d) = (first[0] - 1.0, second[0], first[1], second[1] - 1.0);
            let gap = [image[0] - point[0], image[1] - point[1]];
            let determinant = a * d - b * c;
            point[0] -= (d * gap[0] - b * gap[1]) / determinant;
            point[1] -= (a * gap[1] - c * gap[0]) / determinant;
        }
        (point, self.next_return(point).1)
    }

    /// The amplitude of the first harmonic of x along a cycle of this period; the trapezium rule is spectral here.
    fn first_harmonic(&self, [y, zeta]: [f64; 2], period: f64) -> f64 {
        let h = period / STEPS_PER_CYCLE as f64;
        let (mut state, mut cosine, mut sine) = ([0.0, y, zeta], 0.0, 0.0);
        for step in 0..STEPS_PER_CYCLE {
            let phase = 2.0 * std::f64::consts::PI * step as f64 / STEPS_PER_CYCLE as f64;
            cosine += state[0] * libm::cos(phase);
            sine += state[0] * libm::sin(phase);
            state = self.step(state, h);
        }
        2.0 * libm::hypot(cosine, sine) / STEPS_PER_CYCLE as f64
    }
}

fn omega() -> f64 {
    (EFFECT_RATIO - 1.0).sqrt()
}

fn period() -> f64 {
    2.0 * std::f64::consts::PI / omega()
}

/// y and ζ at the rise of x through zero on the linear motion along the critical eigenvector.
fn section_point(amplitude: f64, eta: f64) -> [f64; 2] {
    [amplitude * omega() / EFFECT_RATIO, amplitude * omega() * (1.0 + eta)]
}

/// The value of an expression in η and ω.
fn value(expression: &Expression, eta: f64) -> f64 {
    let of = |inner: &Expression| value(inner, eta);
    match expression {
        Expression::Number(number) => nearest_f64(number),
        Expression::Variable(name) if name.as_str() == "eta" => eta,
        Expression::Variable(_) => omega(),
        Expression::Sum(parts) => parts.iter().map(of).sum(),
        Expression::Product(parts) => parts.iter().map(of).product(),
        Expression::Quotient(left, right) => of(left) / of(right),
        Expression::Negation(inner) => -of(inner),
        Expression::Power(inner, exponent) => libm::pow(of(inner), f64::from(*exponent)),
        Expression::Call(..) | Expression::Generic(..) => f64::NAN,
    }
}

/// K/K_c − 1 at which the predicted amplitude of ln(V/V_l) is this: positive where the cycle lies above K_c.
fn distance(law: EvolutionLaw, eta: f64, amplitude: f64) -> f64 {
    amplitude * amplitude / value(&stated("square_amplitude", law), eta)
}

/// Relative errors of the predicted amplitude and frequency shift.
fn errors(law: EvolutionLaw, eta: f64, amplitude: f64) -> [f64; 2] {
    let distance = distance(law, eta, amplitude);
    let slider = Slider::near(law, eta, distance);
    let (point, period) = slider.cycle(amplitude);
    let shift = 2.0 * std::f64::consts::PI / period - omega();
    let predicted_shift = value(&stated("frequency_slope", law), eta) * distance;
    [slider.first_harmonic(point, period) / amplitude - 1.0, shift / predicted_shift - 1.0]
}

/// The error of both predictions is c A² + O(A⁴), so that 2 e(A/√2) − e(A) is of order A⁴ = 1e-4. The bound
/// allows three times that; a prediction off by a thousandth would miss it. K/K_c − 1 runs from 6e-5 to −1e-2.
#[test]
fn predicted_amplitude_and_frequency_are_those_of_integrated_cycles() {
    let amplitude: f64 = 0.1;
    for law in EvolutionLaw::ALL {
        for eta in [0.1, 1.0, 10.0] {
            let whole = errors(law, eta, amplitude);
            let half = errors(law, eta, amplitude * std::f64::consts::FRAC_1_SQRT_2);
            for (whole, half) in whole.into_iter().zip(half) {
                assert!(
                    (2.0 * half - whole).abs() < 3.0 * amplitude.powi(4),
                    "{law:?}, η = {eta}: {whole:e}, {half:e}"
                );
            }
        }
    }
}

/// Aging law, η = 0.1, K = 1.001 K_c: linearly stable, and yet a kick beyond the unstable cycle runs away.
#[test]
fn a_kick_beyond_the_unstable_cycle_destabilises_a_stable_slider() {
    let (law, eta, distance) = (EvolutionLaw::Aging, 0.1, 1e-3);
    let slider = Slider::near(law, eta, distance);
    let predicted = (value(&stated("square_amplitude", law), eta) * distance).sqrt();
    let after = |start: f64, returns: usize| {
        let mut point = section_point(start * predicted, eta);
        for _ in 0..returns {
            point = slider.next_return(point).0;
        }
        point[1] / (predicted * omega() * (1.0 + eta))
    };
    let decayed = after(0.8, 1_000);
    let grown = after(1.2, 1_000);
    assert!(decayed < 0.5, "{decayed}");
    assert!(grown > 1.5, "{grown}");
}
