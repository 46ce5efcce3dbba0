//! The slow manifold over a box of states, and a tube around it that holds the whole slider.
//!
//! The slider obeys x' = ξ_n + ψ exactly, with
//!
//! ```text
//! ψ' = R − ψ q/ε − ψ(ξ_n + ψ)      R = N(ξ_{n−1}) − N(ξ_n)      q = 1 + ε(ξ_n + ξ_nx)
//! ```
//!
//! R is of order ε^n. Subtracting the two values of N would lose this; with δ_m = ξ_m − ξ_{m−1} the difference is
//! N(ξ_m) − N(ξ_{m−1}) = δ_m(ξ_m + ξ_{m−1} + ξ_mx) + ξ_{m−1}δ_mx + gδ_my, and δ_{m+1} = −ε times it.
//!
//! While Λ ≤ q/ε − |ξ_n| − 2|ψ| this gives |ψ(t)| ≤ e^{−Λt}|ψ(0)| + sup|R|/Λ, and the same bound with the derivative of the
//! right-hand side by (x, y) in place of R holds for the derivative of ψ by the initial state.

use crate::Constants;
use crate::interval::{Interval, generously_up, worse};
use crate::jet::{CORRECTIONS, Jet};
use slipmode_core::friction::EvolutionLaw;

/// What holds of the slow manifold and of ψ over a box of (x, y).
#[derive(Debug, Clone, Copy)]
pub(super) struct Manifold {
    /// ε.
    pub inertia: Interval,
    /// ξ_n and its derivatives.
    pub rate: Interval,
    pub rate_gradient: [Interval; 2],
    /// g.
    pub state_rate: Interval,
    /// The derivative of (ξ_n, g) by (x, y): the largest sum of sizes in a row, and a bound of its own derivatives.
    pub largest_slope: f64,
    pub largest_bend: f64,
    /// sup|R|.
    pub residual: f64,
    /// R and q/ε with their derivatives.
    residual_gradient: [Interval; 2],
    damping: Interval,
    damping_gradient: [Interval; 2],
}

/// Bounds on ψ and on its derivatives by the coordinates of the section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tube {
    /// |ψ|.
    pub distance: f64,
    /// |∂ψ/∂p|.
    pub slopes: [f64; 2],
}

/// What a step of length h does to the tube.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage {
    start: Tube,
    /// What remains of the bounds when the start is forgotten.
    settled: Tube,
    /// Λ.
    contraction: f64,
    /// e^{μh}, with the largest growth rate μ of deviations.
    pub growth: f64,
    /// How far ψ moves the state, and its derivative by p, until the end: e^{μh}∫|ψ| dt and e^{μh}∫|∂ψ/∂p| dt.
    pub moved: f64,
    pub moved_slopes: [f64; 2],
}

impl Manifold {
    /// Over a box.
    pub fn over(constants: &Constants, at: &[Interval; 2]) -> Self {
        let Constants { inertia, stiffness, effect_ratio, .. } = *constants;
        let [velocity, state_rate] = velocity_and_state_rate(constants.law, at);
        let plain =
            (Jet::constant(Interval::ONE) - velocity).scaled(stiffness) - state_rate.scaled(effect_ratio);
        let own_inertia = velocity.scaled(inertia);
        let mut rate = plain;
        // N(ξ_m) − N(ξ_{m−1}), first N(ξ_0).
        let mut difference = plain * (plain + plain.by_x()) + state_rate * plain.by_y();
        for _ in 0..CORRECTIONS {
            let change = -(own_inertia * difference);
            let before = rate;
            rate = before + change;
            difference =
                change * (rate + before + rate.by_x()) + before * change.by_x() + state_rate * change.by_y();
        }
        let inverse = Jet::exponential_of_minus_x((-at[0]).exp() * inertia.reciprocal());
        let damping = inverse + rate + rate.by_x();
        Self {
            inertia: own_inertia.value(),
            rate: rate.value(),
            rate_gradient: rate.gradient(),
            state_rate: state_rate.value(),
            largest_slope: crate::linear::largest_row(&[rate.gradient(), state_rate.gradient()]),
            largest_bend: generously_up(4.0 * worse(rate.largest_second(), state_rate.largest_second())),
            residual: difference.value().magnitude(),
            residual_gradient: difference.gradient(),
            damping: damping.value(),
            damping_gradient: damping.gradient(),
        }
    }

    /// How strongly inertia delays: ε times the fastest slow rate.
    pub fn delay(&self) -> f64 {
        self.inertia.magnitude() * (self.largest_slope + self.rate.magnitude())
    }

    /// A number not above [`Self::delay`], from the derivatives of g and half of those of ξ_0: in a small part of the time of [`Self::over`].
    ///
    /// Where the delay is small, ξ_n is near ξ_0. Nothing that is proved depends on this number.
    pub fn least_delay(constants: &Constants, [x, y]: &[Interval; 2]) -> f64 {
        let Constants { inertia, stiffness, effect_ratio, law } = *constants;
        let velocity = x.exp();
        let [by_x, by_y] = match law {
            EvolutionLaw::Slip => [-(velocity * (*x + *y + Interval::ONE)), -velocity],
            EvolutionLaw::Aging => [-velocity, -(-*y).exp()],
        };
        let half = Interval::point(0.5);
        let plain = [-(stiffness * velocity) - effect_ratio * by_x, -(effect_ratio * by_y)];
        let rows = [[by_x, by_y], plain.map(|slope| half * slope)];
        (inertia * velocity).magnitude() * crate::linear::largest_row(&rows)
    }

    /// How far the tube is from the manifold where the motion has settled.
    pub fn settled(&self) -> f64 {
        self.residual / self.damping.mignitude()
    }

    /// The rate of change of ψ at most, for |ψ| ≤ `distance`.
    pub fn tube_rate(&self, distance: f64) -> f64 {
        let turning = self.damping.magnitude() + self.rate.magnitude() + distance;
        generously_up(self.residual + distance * turning)
    }

    /// x'' for |ψ| ≤ `distance`.
    pub fn acceleration(&self, distance: f64) -> Interval {
        let [by_x, by_y] = self.rate_gradient;
        (by_x * self.rate.widened(distance) + by_y * self.state_rate).widened(self.tube_rate(distance))
    }

    /// A bound of the derivative of ψ' by (x, y), for |ψ| ≤ `distance`.
    fn source(&self, distance: f64) -> f64 {
        let of = |i: usize| {
            let [of_residual, of_damping, of_rate] =
                [self.residual_gradient[i], self.damping_gradient[i], self.rate_gradient[i]]
                    .map(Interval::magnitude);
            of_residual + distance * (of_damping + of_rate)
        };
        generously_up(of(0) + of(1))
    }

    /// The tube over a step of length h within the box; `derivatives` are the sizes of ∂(x, y)/∂p at its start. None where the tube does not
    /// contract.
    pub fn passage(&self, tube: Tube, h: f64, derivatives: [f64; 2]) -> Option<Passage> {
        let growth = (Interval::point(self.largest_slope) * Interval::point(h)).exp().upper();
        let least = self.damping.lower();
        let first = generously_up(tube.distance + 2.0 * self.residual / least);
        let contraction = (least - self.rate.magnitude() - 2.0 * first) * (1.0 - 1e-9);
        if !(least > 0.0 && contraction > 0.0) {
            return None;
        }
        let settled = generously_up(self.residual / contraction);
        let distance = generously_up(tube.distance + settled);
        if !(distance <= first) {
            return None;
        }
        let time = h.min(generously_up(1.0 / contraction));
        let source = self.source(distance);
        let feedback = generously_up(h * source * growth / contraction);
        if !(feedback < 0.5) {
            return None;
        }
        let moved = generously_up(growth * (tube.distance * time + settled * h));
        let slope_impulses: [f64; 2] = std::array::from_fn(|j| {
            generously_up((tube.slopes[j] * time + feedback * derivatives[j]) / (1.0 - feedback))
        });
        let settled_slopes: [f64; 2] = std::array::from_fn(|j| {
            generously_up(source * growth * (derivatives[j] + slope_impulses[j]) / contraction)
        });
        let settled = Tube { distance: settled, slopes: settled_slopes };
        let moved_slopes = slope_impulses.map(|impulse| generously_up(growth * impulse));
        Some(Passage { start: tube, settled, contraction, growth, moved, moved_slopes })
    }
}

/// e^x and g.
fn velocity_and_state_rate(law: EvolutionLaw, [x, y]: &[Interval; 2]) -> [Jet; 2] {
    let velocity = Jet::exponential_of_x(x.exp());
    let state_rate = match law {
        EvolutionLaw::Slip => {
            let sum = Jet::new(|i, j| match i + j {
                0 => *x + *y,
                1 => Interval::ONE,
                _ => Interval::ZERO,
            });
            -(velocity * sum)
        }
        EvolutionLaw::Aging => Jet::exponential_of_minus_y((-*y).exp()) - velocity,
    };
    [velocity, state_rate]
}

impl Passage {
    /// Bounds after a time or later.
    pub fn after(&self, time: f64) -> Tube {
        let exponent =
            Interval::point(-self.contraction) * Interval::point(time.min(600.0 / self.contraction));
        let fading = exponent.exp().upper();
        let end = |start: f64, settled: f64| generously_up(start * fading + settled);
        Tube {
            distance: end(self.start.distance, self.settled.distance),
            slopes: std::array::from_fn(|j| end(self.start.slopes[j], self.settled.slopes[j])),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{Motion, States};
    use crate::set::{COORDINATES, Set};
    use crate::tests::members::Slider;
    use slipmode_core::number::split_mix::SplitMix64;

    #[test]
    fn the_least_delay_is_not_above_the_delay() {
        for law in EvolutionLaw::ALL {
            for (k, inertia) in (-30..30).flat_map(|k| [1e-9, 1e-3, 10.0].map(|inertia| (k, inertia))) {
                let constants = Constants {
                    inertia: Interval::point(inertia),
                    stiffness: Interval::point(0.3),
                    effect_ratio: Interval::point(1.5),
                    law,
                };
                let at = [Interval::point(f64::from(k)), Interval::symmetric(1e-3 * f64::from(k).abs())];
                let [least, delay] =
                    [Manifold::least_delay(&constants, &at), Manifold::over(&constants, &at).delay()];
                assert!(least <= delay, "{least:e} {delay:e}");
            }
        }
    }

    /// ψ of a slider that has settled, from the whole equations: within the tube, and outside a tube for a thousandth of R.
    #[test]
    fn a_settled_tube_holds_the_whole_slider_and_a_smaller_one_does_not() {
        const STEPS: usize = 100;
        for law in EvolutionLaw::ALL {
            let constants = Constants {
                inertia: Interval::point(0.01),
                stiffness: Interval::point(0.3),
                effect_ratio: Interval::point(1.5),
                law,
            };
            let start = [-1.0, 1.0].map(Interval::point);
            let there = Manifold::over(&constants, &start);
            let state = [start[0], start[1], there.inertia * there.rate];
            let none = [Interval::ZERO; COORDINATES];
            let set = Set::new(none, state, [none; 3]);
            let mut motion = Motion::new(&constants, States::Inertial(set), u64::MAX);
            motion.may_stick = false;
            for _ in 0..STEPS {
                motion.advance(None).unwrap();
            }
            let States::Inertial(set) = &motion.states else { panic!("it sticks") };
            let [x, y, force] = set.hull();
            let here = Manifold::over(&constants, &[x, y]);
            let psi = force * here.inertia.reciprocal() - here.rate;
            let path = Manifold::over(&constants, &[start[0].hull(x), start[1].hull(y)]);
            let at_first = Tube { distance: 0.0, slopes: [0.0; 2] };
            let time = motion.observed.duration.upper();
            let bound =
                |over: &Manifold| over.passage(at_first, time, [0.0; 2]).unwrap().after(time).distance;
            assert!(psi.magnitude() < bound(&path), "{psi:?} {:e}", bound(&path));
            let faulty = Manifold { residual: 1e-3 * path.residual, ..path };
            assert!(psi.mignitude() > bound(&faulty), "{psi:?} {:e}", bound(&faulty));
        }
    }

    /// ψ' from the equation of the whole slider, x'' = (κ(1 − e^x) − x' − βg)/ε − x'², against what the tube takes for it.
    #[test]
    fn the_manifold_obeys_the_equation_of_the_whole_slider() {
        const STEP: f64 = 1e-4;
        for law in EvolutionLaw::ALL {
            let slider = Slider { inertia: 0.05, stiffness: 0.3, effect_ratio: 1.5, law };
            let constants = slider.constants();
            let at = |x: f64, y: f64| Manifold::over(&constants, &[x, y].map(Interval::point));
            let acceleration = |x: f64, y: f64, speed: f64| {
                let plain = -0.3 * libm::expm1(x) - 1.5 * slider.state_rate(x, y);
                (plain - speed) / (0.05 * libm::exp(x)) - speed * speed
            };
            let psi_rate = |x: f64, y: f64, psi: f64| {
                let here = at(x, y);
                let ([by_x, by_y], speed) = (here.rate_gradient.map(|c| c.mid), here.rate.mid + psi);
                acceleration(x, y, speed) - by_x * speed - by_y * slider.state_rate(x, y)
            };
            for [x, y] in [[-1.0, 1.3], [-0.5, 0.2], [-2.0, 1.5]] {
                let here = at(x, y);
                let is_near = |a: f64, b: f64| (a - b).abs() < 1e-6 * (1.0 + a.abs());
                let residual = psi_rate(x, y, 0.0);
                assert!(is_near(residual.abs(), here.residual), "{residual:e} {:e}", here.residual);
                assert!(is_near(here.state_rate.mid, slider.state_rate(x, y)));
                let central = |of: &dyn Fn(f64, f64) -> f64| {
                    let by = |dx: f64, dy: f64| (of(x + dx, y + dy) - of(x - dx, y - dy)) / (2.0 * STEP);
                    [by(STEP, 0.0), by(0.0, STEP)]
                };
                let gradient = central(&|x, y| at(x, y).rate.mid);
                assert!((0..2).all(|i| is_near(gradient[i], here.rate_gradient[i].mid)), "{gradient:?}");
                for psi in [0.0, 1e-3, -1e-3, 0.1, -0.1] {
                    let rate = psi_rate(x, y, psi);
                    assert!(psi == 0.0 || rate.abs() <= here.tube_rate(psi.abs()) * (1.0 + 1e-9));
                    let speed = here.rate.mid + psi;
                    let held = here.acceleration(psi.abs()).widened(1e-9);
                    assert!(held.may_contain(acceleration(x, y, speed)), "{x} {y} {psi}");
                    // −ψ q/ε − ψ(ξ + ψ).
                    let fading = -psi * (here.damping.mid + here.rate.mid + psi);
                    assert!(is_near(rate, residual + fading), "{rate} {residual} {fading}");
                    let [by_x, by_y] = central(&|x, y| psi_rate(x, y, psi));
                    let source = here.source(psi.abs());
                    assert!(
                        by_x.abs() + by_y.abs() <= source * (1.0 + 1e-5) + 1e-6,
                        "{by_x} {by_y} {source}"
                    );
                }
                // The derivatives of the slow rates, and how they change to a neighbour.
                let rows = |x: f64, y: f64| [at(x, y).rate_gradient, [0, 1].map(|_| Interval::ZERO)];
                let own = central(&|x, y| slider.state_rate(x, y));
                assert!(own[0].abs() + own[1].abs() <= here.largest_slope * (1.0 + 1e-6) + 1e-7);
                assert!(gradient[0].abs() + gradient[1].abs() <= here.largest_slope * (1.0 + 1e-6) + 1e-7);
                for [dx, dy] in [[STEP, STEP], [STEP, -STEP], [-STEP, STEP]] {
                    let [before, after] = [rows(x, y)[0], rows(x + dx, y + dy)[0]];
                    let change: f64 = (0..2).map(|i| (after[i].mid - before[i].mid).abs()).sum();
                    assert!(change <= 1.01 * STEP * here.largest_bend, "{change} {}", here.largest_bend);
                    let of_state = |x: f64, y: f64| {
                        let by = |dx: f64, dy: f64| {
                            (slider.state_rate(x + dx, y + dy) - slider.state_rate(x - dx, y - dy))
                                / (2.0 * STEP)
                        };
                        [by(STEP, 0.0), by(0.0, STEP)]
                    };
                    let [before, after] = [of_state(x, y), of_state(x + dx, y + dy)];
                    let change: f64 = (0..2).map(|i| (after[i] - before[i]).abs()).sum();
                    assert!(
                        change <= 1.01 * STEP * here.largest_bend + 1e-8,
                        "{change} {}",
                        here.largest_bend
                    );
                }
            }
        }
    }

    /// ψ' = R − ψ(d + ξ + ψ) and the derivative of ψ by p, whose source is S δ with δ' = μδ + δψ, at the worst signs.
    #[test]
    fn a_passage_bounds_the_motion_in_the_tube() {
        let (damping, rate, growth_rate, parts) = (20.0, -2.0, 1.0, 20_000);
        let one = Interval::ONE;
        let manifold = Manifold {
            inertia: one,
            rate: Interval::point(rate),
            rate_gradient: [Interval::ZERO, one],
            state_rate: one,
            largest_slope: growth_rate,
            largest_bend: 1.0,
            residual: 3.0,
            residual_gradient: [Interval::point(1.5), Interval::point(-0.5)],
            damping: Interval { mid: damping + 1.0, rad: 1.0 },
            damping_gradient: [Interval::ZERO, one],
        };
        for (start, slope, derivative, h) in [
            (0.0, 0.0, 1.0, 0.3),
            (1.5, 0.0, 1.0, 0.05),
            (0.5, 4.0, 0.0, 0.02),
            (1.0, 1.0, 1.0, 0.2),
            (0.3, 5.0, 0.1, 0.5),
        ] {
            let tube = Tube { distance: start, slopes: [slope, 0.5 * slope] };
            let growth = libm::exp(growth_rate * h);
            let derivatives = [derivative, 0.5 * derivative];
            let passage = manifold.passage(tube, h, derivatives).unwrap();
            let dt = h / f64::from(parts);
            // At ψ < 0: |ψ|' = R − |ψ|(d + ξ) + ψ².
            let (mut psi, mut by_p, mut off) = (start, slope, derivative);
            let (mut impulse, mut slope_impulse) = (0.0, 0.0);
            for _ in 0..parts {
                let rates = |[psi, by_p, off]: [f64; 3]| {
                    let fading = damping + rate;
                    let source = 2.0 + 2.0 * psi;
                    [
                        3.0 - psi * (fading - psi),
                        source * off - by_p * (fading - 2.0 * psi),
                        growth_rate * off + by_p,
                    ]
                };
                let first = rates([psi, by_p, off]);
                let middle =
                    rates([psi + 0.5 * dt * first[0], by_p + 0.5 * dt * first[1], off + 0.5 * dt * first[2]]);
                impulse += dt * (psi + 0.5 * dt * first[0]);
                slope_impulse += dt * (by_p + 0.5 * dt * first[1]);
                (psi, by_p, off) = (psi + dt * middle[0], by_p + dt * middle[1], off + dt * middle[2]);
            }
            let end = passage.after(h);
            let holds = |bound: f64, value: f64| bound >= value * (1.0 - 1e-6);
            assert!(
                holds(end.distance, psi) && holds(passage.moved, growth * impulse),
                "{passage:?} {psi} {impulse}"
            );
            assert!(
                holds(end.slopes[0], by_p) && holds(passage.moved_slopes[0], growth * slope_impulse),
                "{passage:?} {by_p}"
            );
            assert!(
                holds(end.slopes[1], 0.5 * by_p)
                    && holds(passage.moved_slopes[1], 0.5 * growth * slope_impulse)
            );
            let first = passage.after(0.0);
            assert!(holds(first.distance, start) && holds(first.slopes[0], slope));
        }
        // No tube holds where nothing damps, where ψ² wins, or where the derivative feeds itself.
        let weak = |damping: f64| Manifold { damping: Interval::point(damping), ..manifold };
        let passage = |manifold: Manifold, distance: f64, h: f64| {
            manifold.passage(Tube { distance, slopes: [1.0; 2] }, h, [1.0; 2])
        };
        assert!(passage(manifold, 0.1, 0.1).is_some());
        let refused = [
            (weak(-1.0), 0.0, 0.1),
            (weak(1.0), 0.0, 0.1),
            (weak(-20.0), 0.1, 0.1),
            (manifold, 10.0, 0.1),
            (manifold, 0.1, 5.0),
            // |ψ|' = 3 − |ψ|(2 − |ψ|) has no zero.
            (Manifold { rate: Interval::point(-18.0), ..weak(20.0) }, 0.0, 0.1),
        ];
        for (manifold, distance, h) in refused {
            assert!(passage(manifold, distance, h).is_none(), "{manifold:?} {distance} {h}");
        }
    }

    /// Over a box of states: ε, ξ, g, their derivatives and q/ε hold those of each state, and |R|, the source and the bends are at least theirs.
    #[test]
    fn a_manifold_over_a_box_holds_those_of_its_states() {
        let mut random = SplitMix64(21);
        for case in 0..60 {
            let law = EvolutionLaw::ALL[case % 2];
            // Without load and with little friction y' alone bends.
            let scale = [1.0, 1e-3][usize::from(case % 3 == 0)];
            let slider = Slider { inertia: 0.05, stiffness: 0.3 * scale, effect_ratio: 1.5 * scale, law };
            let constants = slider.constants();
            let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
            let (at, rad) = ([number(-2.0, -0.2), number(-0.5, 1.5)], [1e-3, 0.05][case % 2]);
            let whole = Manifold::over(&constants, &at.map(|mid| Interval { mid, rad }));
            for _ in 0..20 {
                let [x, y] = at.map(|c| c + rad * number(-1.0, 1.0));
                let here = Manifold::over(&constants, &[x, y].map(Interval::point));
                let holds =
                    |wide: Interval, value: f64| wide.widened(1e-12 * (1.0 + value.abs())).may_contain(value);
                assert!(
                    holds(whole.inertia, 0.05 * libm::exp(x))
                        && holds(whole.state_rate, slider.state_rate(x, y))
                );
                assert!(holds(whole.rate, here.rate.mid) && holds(whole.damping, here.damping.mid));
                for i in 0..2 {
                    assert!(holds(whole.rate_gradient[i], here.rate_gradient[i].mid));
                }
                let least = 1.0 - 1e-12;
                for distance in [0.0, 1e-3, 0.1] {
                    assert!(whole.source(distance) >= least * here.source(distance));
                    assert!(whole.tube_rate(distance) >= least * here.tube_rate(distance));
                }
                assert!(
                    whole.largest_slope >= least * here.largest_slope
                        && whole.largest_bend >= least * here.largest_bend
                );
                // g_xx, g_xy and g_yy: the derivative of g over a step of length one in any direction changes by less.
                let velocity = libm::exp(x);
                let seconds = match law {
                    EvolutionLaw::Slip => [velocity * (x + y + 2.0), velocity, 0.0],
                    EvolutionLaw::Aging => [velocity, 0.0, libm::exp(-y)],
                };
                let [xx, xy, yy] = seconds.map(f64::abs);
                assert!(whole.largest_bend >= xx + 2.0 * xy + yy, "{law:?} {x} {y} {}", whole.largest_bend);
            }
        }
    }

    /// x'' of the whole slider for each ψ in the tube, at states where all terms of its bound have one sign, and others.
    #[test]
    fn the_acceleration_in_the_tube_is_held() {
        let mut random = SplitMix64(22);
        for case in 0..2000 {
            let law = EvolutionLaw::ALL[case % 2];
            let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
            let slider =
                Slider { inertia: 0.02, stiffness: number(0.0, 8.0), effect_ratio: number(0.1, 3.0), law };
            let constants = slider.constants();
            let [x, y] = [number(-2.0, 0.3), number(-1.5, 2.0)];
            let here = Manifold::over(&constants, &[x, y].map(Interval::point));
            for distance in [1e-3, 0.1, 1.0] {
                let held = here.acceleration(distance);
                for psi in [distance, -distance] {
                    let speed = here.rate.mid + psi;
                    let plain =
                        -slider.stiffness * libm::expm1(x) - slider.effect_ratio * slider.state_rate(x, y);
                    let acceleration = (plain - speed) / (0.02 * libm::exp(x)) - speed * speed;
                    let error = 1e-9 * (1.0 + acceleration.abs());
                    assert!(
                        held.widened(error).may_contain(acceleration),
                        "{slider:?} {x} {y} {psi} {held:?} {acceleration}"
                    );
                }
            }
        }
    }

    /// Without any other growth, ψ' by p is S δ/Λ at once and δ' = δψ: the derivative of the state feeds itself, as e^{hS/Λ}.
    #[test]
    fn the_tube_feeds_itself() {
        let (one, h) = (Interval::ONE, 1.0);
        for feedback in [0.01, 0.2, 0.45] {
            let manifold = Manifold {
                inertia: one,
                rate: Interval::ZERO,
                rate_gradient: [Interval::ZERO; 2],
                state_rate: one,
                largest_slope: 0.0,
                largest_bend: 1.0,
                residual: 1e-12,
                residual_gradient: [Interval::point(1e9 * feedback), Interval::ZERO],
                damping: Interval::point(1e9),
                damping_gradient: [Interval::ZERO; 2],
            };
            let passage = manifold.passage(Tube { distance: 0.0, slopes: [0.0; 2] }, h, [1.0, 0.0]).unwrap();
            let exact = [libm::expm1(feedback * h), feedback * libm::exp(feedback * h)];
            let found = [passage.moved_slopes[0], passage.after(h).slopes[0]];
            assert!((0..2).all(|i| found[i] >= exact[i] * (1.0 - 1e-6)), "{feedback} {exact:?} {passage:?}");
        }
    }

    /// A source that is constant while deviations grow fast: ψ' by p is S e^{μt}/Λ at most, and the growth counts in full.
    #[test]
    fn deviations_that_grow_fast_feed_the_tube() {
        let (growth_rate, parts) = (8.0, 20_000);
        let one = Interval::ONE;
        let manifold = Manifold {
            inertia: one,
            rate: Interval::ZERO,
            rate_gradient: [Interval::ZERO; 2],
            state_rate: one,
            largest_slope: growth_rate,
            largest_bend: 1.0,
            residual: 1e-12,
            residual_gradient: [Interval::point(0.5), Interval::ZERO],
            damping: Interval::point(100.0),
            damping_gradient: [Interval::ZERO; 2],
        };
        for h in [0.1, 0.3, 0.4] {
            let tube = Tube { distance: 0.0, slopes: [0.0; 2] };
            let passage = manifold.passage(tube, h, [1.0, 0.0]).unwrap();
            let dt = h / f64::from(parts);
            let (mut by_p, mut off, mut impulse) = (0.0, 1.0, 0.0);
            for _ in 0..parts {
                let rates = |[by_p, off]: [f64; 2]| [0.5 * off - 100.0 * by_p, growth_rate * off + by_p];
                let first = rates([by_p, off]);
                let middle = rates([by_p + 0.5 * dt * first[0], off + 0.5 * dt * first[1]]);
                impulse += dt * (by_p + 0.5 * dt * first[0]);
                (by_p, off) = (by_p + dt * middle[0], off + dt * middle[1]);
            }
            let holds = |bound: f64, value: f64| bound >= value * (1.0 - 1e-6);
            let growth = libm::exp(growth_rate * h);
            assert!(holds(passage.moved_slopes[0], growth * impulse), "{h} {passage:?} {impulse}");
            assert!(holds(passage.after(h).slopes[0], by_p), "{h} {:?} {by_p}", passage.after(h));
        }
    }
}
