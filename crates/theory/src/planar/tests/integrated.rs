//! The lemmas' conclusions on the massless slider, integrated in other variables and by other code than the proofs use.
//!
//! u = ln(V/V_l), y = ln(V_l θ/L), time in L/V_l, κ = K L/A and β = B/A. Each motion is integrated twice, the second time with steps
//! of half the length. The classical fourth-order method then has about a fifteenth of their difference as the error of the second.

#[derive(Clone, Copy)]
enum Law {
    Aging,
    Slip,
}

#[derive(Clone, Copy)]
struct Slider {
    law: Law,
    kappa: f64,
    beta: f64,
    /// 1 with constant velocity of the load point, 0 with the load point at rest.
    load: f64,
}

type State = [f64; 2];

impl Slider {
    fn rates(self, [u, y]: State) -> State {
        let v = libm::exp(u);
        let evolution = match self.law {
            Law::Aging => libm::exp(-y) - v,
            Law::Slip => -v * (u + y),
        };
        [self.kappa * (self.load - v) - self.beta * evolution, evolution]
    }

    /// One step of a length that changes neither coordinate by more than `size`, and the time it takes.
    fn step(self, state: State, size: f64) -> (State, f64) {
        let k1 = self.rates(state);
        // Where the velocity is largest the rates change fastest: their own rate of change is that of the exponentials.
        let fastest = 1.0 + self.beta;
        let h =
            size / (fastest * (1.0 + k1[0].abs() + k1[1].abs() + libm::exp(state[0]) + libm::exp(-state[1])));
        let along = |rate: State, h: f64| [0, 1].map(|n| state[n] + h * rate[n]);
        let k2 = self.rates(along(k1, h / 2.0));
        let k3 = self.rates(along(k2, h / 2.0));
        let k4 = self.rates(along(k3, h));
        ([0, 1].map(|n| state[n] + h / 6.0 * (k1[n] + 2.0 * (k2[n] + k3[n]) + k4[n])), h)
    }

    /// The motion until a condition is met, with the time it took; none after too many steps.
    fn until(self, start: State, size: f64, done: impl Fn(State) -> bool) -> Option<(State, f64)> {
        let (mut state, mut time) = (start, 0.0);
        for _ in 0..MOST_STEPS {
            if done(state) {
                return Some((state, time));
            }
            let (next, h) = self.step(state, size);
            (state, time) = (next, time + h);
        }
        None
    }

    /// The hill, in the coordinates.
    fn hill(self, [u, y]: State) -> f64 {
        u + (self.kappa + 1.0) * y - libm::exp(u + y) - self.kappa * libm::exp(y)
    }
}

const MOST_STEPS: usize = 2_000_000;

const BETA: f64 = 1.6;

/// Starts near steady sliding and far from it, on all sides.
const STARTS: [State; 5] = [[0.1, 0.0], [2.0, 1.0], [-3.0, -1.0], [-4.0, 3.0], [3.0, -2.5]];

fn loaded(law: Law, ratio: f64) -> Slider {
    Slider { law, kappa: ratio * (BETA - 1.0), beta: BETA, load: 1.0 }
}

#[test]
fn the_quantity_is_conserved_and_the_motion_returns_to_its_start() {
    let slider = loaded(Law::Aging, 1.0);
    for start in STARTS {
        // Behind steady sliding, and back through the start's side of the line from it through steady sliding.
        let side = |state: State| start[0] * state[1] - start[1] * state[0];
        let turn = |size: f64| {
            let (away, _) =
                slider.until(start, size, |state| side(state).abs() > 1e-3 && behind(start, state)).unwrap();
            let first = side(away).signum();
            let (back, _) = slider
                .until(away, size, |state| side(state).signum() == first && !behind(start, state))
                .unwrap();
            back
        };
        let (coarse, fine) = (turn(1e-2), turn(5e-3));
        let change = |state: State| slider.hill(state) - slider.hill(start);
        // The fourth order: half the step leaves a sixteenth of the drift, up to a factor of two and the sums' rounding.
        let rounding = 1e-11 * slider.hill(start).abs();
        assert!(
            change(fine).abs() <= change(coarse).abs() / 8.0 + rounding,
            "{start:?}: {} {}",
            change(coarse),
            change(fine)
        );
        // On the level through the start the line through steady sliding has one point on this side: within a step of the start.
        let distance = libm::hypot(fine[0] - start[0], fine[1] - start[1]);
        assert!(distance <= 2.0 * 5e-3, "{start:?} returns to {fine:?}");
    }
}

/// Whether a state lies on the other side of steady sliding than another one.
fn behind(start: State, state: State) -> bool {
    start[0] * state[0] + start[1] * state[1] < 0.0
}

#[test]
fn above_the_critical_stiffness_every_start_approaches_steady_sliding_and_below_it_none_does() {
    let near = |state: State| libm::hypot(state[0], state[1]) < 1e-3;
    for ratio in [1.2, 3.0] {
        for start in STARTS {
            assert!(loaded(Law::Aging, ratio).until(start, 2e-2, near).is_some(), "{ratio} {start:?}");
        }
    }
    for ratio in [0.5, 0.9] {
        for start in STARTS {
            let slider = loaded(Law::Aging, ratio);
            let fast = |[u, _]: State| u > 12.0;
            let (state, _) = slider.until(start, 2e-2, fast).unwrap();
            assert!(slider.hill(state) < slider.hill(start), "{ratio} {start:?}");
        }
    }
}

#[test]
fn with_the_load_point_at_rest_the_ratio_separates_the_motions() {
    let fast = |[u, _]: State| u > 25.0;
    let slow = |[u, _]: State| u < -12.0;
    for ratio in [0.4, 0.8] {
        let slider = Slider { load: 0.0, ..loaded(Law::Aging, ratio) };
        let separating = (BETA - 1.0) / (BETA - 1.0 - slider.kappa);
        // v reaches infinity before 1/(growth·v), with growth K/(B − A) = κ/(β − 1).
        for y in [-1.0, 0.0, 2.0] {
            let at = |w: f64| [libm::log(w) - y, y];
            let start = at(1.01 * separating);
            let (_, time) = slider.until(start, 1e-2, fast).unwrap();
            assert!(time < (BETA - 1.0) / slider.kappa / libm::exp(start[0]), "{ratio} {y}: {time}");
            assert!(slider.until(at(0.99 * separating), 1e-2, slow).is_some(), "{ratio} {y}");
        }
    }
    // At and above the critical stiffness: at first faster, from the start beyond β/(β − κ), and slower in the end.
    for ratio in [1.0, 1.5] {
        let slider = Slider { load: 0.0, ..loaded(Law::Aging, ratio) };
        let start = [libm::log(2.0 * BETA / (BETA - slider.kappa)), 0.0];
        assert!(slider.rates(start)[0] > 0.0);
        let (state, _) = slider.until(start, 1e-2, slow).unwrap();
        assert!(slider.rates(state)[0] < 0.0);
    }
}

#[test]
fn with_the_slip_law_a_large_disturbance_runs_away_above_the_critical_stiffness_and_a_small_one_does_not() {
    for ratio in [1.2, 3.0] {
        let slider = loaded(Law::Slip, ratio);
        let beyond = slider.kappa / (BETA - 1.0) + 0.01;
        let start = [0.0, beyond];
        let (_, time) = slider.until(start, 1e-2, |[u, _]| u > 25.0).unwrap();
        assert!(time < BETA / slider.kappa, "{ratio}: {time}");
        let near = |state: State| libm::hypot(state[0], state[1]) < 1e-3;
        assert!(slider.until([0.05, 0.0], 1e-2, near).is_some(), "{ratio}");
    }
}
