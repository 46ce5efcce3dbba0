//! The crate `differential-equations` as a player: one stick-slip cycle by its Radau method, our equations written out for it.

use std::cell::Cell;

use differential_equations::prelude::*;
use slipmode_core::dynamics::Model;
use slipmode_core::friction::EvolutionLaw;

use super::cycles::read_lines;
use super::row::{Row, scientific, tolerances};
use slipmode_bench::cpu_clock::best_of;

const REPETITIONS: usize = 3;
const MOST_STEPS: usize = 200_000;

/// Bisections that find a moment within a step, as for the other players.
const BISECTIONS: usize = 60;

struct Slider<'m>(&'m Model<f64>);

impl ODE<f64, [f64; 3]> for Slider<'_> {
    fn diff(&self, _time: f64, s: &[f64; 3], d: &mut [f64; 3]) {
        let groups = self.0.groups();
        let velocity = libm::exp(s[0]);
        d[0] = (s[2] - s[0] - groups.effect_ratio * s[1]) / (velocity * groups.inertial_parameter);
        d[1] = match self.0.law() {
            EvolutionLaw::Slip => -velocity * (s[0] + s[1]),
            EvolutionLaw::Aging => libm::exp(-s[1]) - velocity,
        };
        d[2] = -groups.stiffness_group * libm::expm1(s[0]);
    }

    fn jacobian(&self, _time: f64, s: &[f64; 3], out: &mut Matrix<f64>) {
        let arrow = self.0.jacobian(s);
        let rows = [[arrow.xx, arrow.xy, arrow.xz], [arrow.yx, arrow.yy, 0.0], [arrow.zx, 0.0, 0.0]];
        for (i, row) in rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                out[(i, j)] = *entry;
            }
        }
    }
}

/// Watches the steps: notes the largest velocity, and stops at the next upward crossing of V = V_l.
struct Watch<'m> {
    slider: Slider<'m>,
    rising: bool,
    below: bool,
    /// ln(V_peak/V_l) so far and, once it is known, the duration; the solver keeps the watch to itself.
    seen: &'m Cell<(f64, Option<f64>)>,
}

impl Watch<'_> {
    fn slope(&self, state: &[f64; 3]) -> f64 {
        let mut rate = [0.0; 3];
        self.slider.diff(0.0, state, &mut rate);
        rate[0]
    }
}

impl Solout<f64, [f64; 3]> for Watch<'_> {
    fn solout<I>(
        &mut self,
        now: f64,
        before: f64,
        state: &[f64; 3],
        _last: &[f64; 3],
        interpolator: &mut I,
        _solution: &mut Solution<f64, [f64; 3]>,
    ) -> ControlFlag<f64, [f64; 3]>
    where
        I: Interpolation<f64, [f64; 3]> + ?Sized,
    {
        if now <= before {
            return ControlFlag::Continue;
        }
        let mut bisect = |is_past: &dyn Fn(&[f64; 3]) -> bool| {
            let (mut low, mut high, mut at) = (before, now, *state);
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (low + high);
                let Ok(there) = interpolator.interpolate(middle) else { break };
                if is_past(&there) {
                    (high, at) = (middle, there);
                } else {
                    low = middle;
                }
            }
            (high, at)
        };
        let rising = self.slope(state) > 0.0;
        if state[0] > 0.0 && self.rising && !rising {
            let (_, top) = bisect(&|there| self.slope(there) <= 0.0);
            let (peak, duration) = self.seen.get();
            self.seen.set((peak.max(top[0]), duration));
        }
        self.rising = rising;
        if state[0] > 0.0 && self.below {
            self.seen.set((self.seen.get().0, Some(bisect(&|there| there[0] > 0.0).0)));
            return ControlFlag::Terminate;
        }
        self.below = state[0] < 0.0;
        ControlFlag::Continue
    }
}

/// Peak and duration of the cycle from a crossing; none when the method gives up.
fn cycle(model: &Model<f64>, start: [f64; 3], longest: f64, tolerance: f64) -> Option<[f64; 2]> {
    let slider = Slider(model);
    let seen = Cell::new((f64::NEG_INFINITY, None));
    let watch = Watch { slider: Slider(model), rising: true, below: false, seen: &seen };
    let method = ImplicitRungeKutta::radau5().rtol([tolerance; 3]).atol([tolerance; 3]).max_steps(MOST_STEPS);
    IVP::ode(&slider, 0.0, longest, start).method(method).solout(watch).solve().ok()?;
    let (peak, duration) = seen.get();
    duration.map(|duration| [peak, duration])
}

/// The method at every tolerance.
pub fn play(folder: &std::path::Path) {
    for line in read_lines(&folder.join("cycles.txt")) {
        let start = [line.rest[0], line.rest[1], line.rest[2]];
        for tolerance in tolerances() {
            let (seconds, found) =
                best_of(REPETITIONS, || cycle(&line.model, start, 10.0 * line.rest[4], tolerance));
            let error = found.map(|[peak, duration]| {
                scientific((peak - line.rest[3]).abs().max((duration / line.rest[4] - 1.0).abs()))
            });
            Row {
                work: format!("cycles-{}", line.name),
                method: "differential-equations-radau5",
                options: "analytic~Jacobian;rtol=atol",
                tolerance: Some(tolerance),
                items: 1,
                seconds,
                error,
                wrong: usize::from(found.is_none()),
                counts: None,
            }
            .print();
        }
    }
}
