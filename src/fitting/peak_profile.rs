//! The sum of squares of a table of peak velocities over S, with K/K_c,qs fitted at each S: its minimum and the ends of its interval.

use slipmode_core::dynamics::{DEEP, DeepCycle, PeakLaw};
use slipmode_core::number::search::{border_between, golden_section};

use super::peak_rows::{PeakFailure, PeakGiven, PeakRow, UNKNOWNS, noise};

/// A of the largest peak that is tried, and places between it and the smallest.
const LARGEST: f64 = 150.0;
const PLACES: u32 = 90;
/// ln of a K/K_c,qs below that of the largest peak that is tried, and a K/K_c,qs far above deep stick-slip.
const SOFTEST: f64 = -200.0;
const NOT_DEEP: f64 = 10.0;
/// How closely ln S is found.
const WIDTH: f64 = 1e-9;

/// The law at one b/a and one part of the spring's loss, on the table.
#[derive(Clone, Copy)]
pub(super) struct Case<'t> {
    pub rows: &'t [PeakRow],
    pub given: &'t PeakGiven,
    pub law: PeakLaw,
    pub loss: f64,
    /// The largest K/K_c,qs.
    pub deepest: f64,
}

/// Its fit.
#[derive(Debug, Clone)]
pub struct CaseFit {
    /// S at the normal stress of the first row, m/s.
    pub scale_m_per_s: f64,
    /// One standard error of it, from the noise: its interval over that of a standard error.
    pub standard_error: f64,
    /// The ends of its 95 % interval, from the noise; none where the table sets no bound.
    pub ends: [Option<f64>; 2],
    /// K/K_c,qs.
    pub softness: f64,
    pub(super) residuals: Vec<f64>,
    pub(super) cost: f64,
}

/// The best K/K_c,qs at a held scale.
#[derive(Debug)]
pub(super) struct Held {
    log_softness: f64,
    pub residuals: Vec<f64>,
    cost: f64,
}

impl Case<'_> {
    /// κ and V_l/S of a row.
    fn groups(&self, row: &PeakRow, scale: f64, log_softness: f64) -> [f64; 2] {
        let kappa = (self.law.effect_ratio - 1.0) * libm::exp(log_softness) / row.stress;
        [kappa, row.load_m_per_s / (scale * row.stress)]
    }

    /// The peak of a row by the law, m/s.
    fn peak(&self, row: &PeakRow, scale: f64, log_softness: f64) -> Option<f64> {
        let [kappa, load] = self.groups(row, scale, log_softness);
        Some(self.law.peak(load, kappa, self.loss)? * scale * row.stress)
    }

    /// The logarithms of the least and the greatest K/K_c,qs.
    fn bounds(&self, scale: f64) -> Option<[f64; 2]> {
        let deepest = libm::log(self.deepest);
        let [low, high] = match self.given.slip_velocity_m_per_s {
            Some(ends) => ends.map(|velocity| libm::log(velocity / scale)),
            None => [SOFTEST, deepest],
        };
        (low <= deepest && high >= SOFTEST).then_some([low.max(SOFTEST), high.min(deepest)])
    }

    /// The least sum of squares at this scale, by steps of Gauss and Newton that are halved until they lead downhill. Where a slider is too
    /// stiff, the law has no peaks: the search starts at a softer one.
    pub fn held(&self, log_scale: f64) -> Option<Held> {
        const MOST_STEPS: usize = 50;
        /// Above the rounding of a sum of squares, and a step that changes it by less.
        const ROUNDING: f64 = 1e-12;
        const LEAST_STEP: f64 = 1e-6;
        let scale = libm::exp(log_scale);
        let [low, high] = self.bounds(scale)?;
        let first = &self.rows[0];
        let peak = first.peak_m_per_s / (scale * first.stress);
        let loading = first.load_m_per_s / first.peak_m_per_s;
        let rough = self.law.remainder(&DeepCycle { peak, loading, stiffness_group: 1.0 });
        let mut start = (rough - libm::log(self.law.effect_ratio - 1.0)).clamp(low, high);
        let mut best = loop {
            match self.at(scale, start) {
                Some(held) => break held,
                None if start > low => start = (start - 1.0).max(low),
                None => return None,
            }
        };
        for _ in 0..MOST_STEPS {
            let mut step = self.step(scale, &best)?;
            loop {
                let next = (best.log_softness + step).clamp(low, high);
                if (next - best.log_softness).abs() < LEAST_STEP {
                    return Some(best);
                }
                let found = self.at(scale, next).filter(|held| held.cost <= best.cost * (1.0 + ROUNDING));
                if let Some(found) = found {
                    best = found;
                    break;
                }
                step *= 0.5;
            }
        }
        None
    }

    fn weight(row: &PeakRow) -> f64 {
        1.0 / (row.relative_error * row.relative_error)
    }

    /// The residuals at a scale and K/K_c,qs.
    fn at(&self, scale: f64, log_softness: f64) -> Option<Held> {
        let residual =
            |row: &PeakRow| Some(libm::log(row.peak_m_per_s / self.peak(row, scale, log_softness)?));
        let residuals: Vec<f64> = self.rows.iter().map(residual).collect::<Option<_>>()?;
        let squares =
            self.rows.iter().zip(&residuals).map(|(row, residual)| Self::weight(row) * residual * residual);
        Some(Held { log_softness, cost: squares.sum(), residuals })
    }

    /// The change of ln(K/K_c,qs) to the least sum of squares, if peaks were linear in it.
    fn step(&self, scale: f64, held: &Held) -> Option<f64> {
        /// Between the rounding and the curvature of the peaks.
        const SOFTER: f64 = 1e-5;
        let softer = self.at(scale, held.log_softness - SOFTER)?;
        let [mut slope, mut square] = [0.0; 2];
        for (row, (residual, moved)) in self.rows.iter().zip(held.residuals.iter().zip(&softer.residuals)) {
            let derivative = (residual - moved) / SOFTER;
            slope += Self::weight(row) * derivative * residual;
            square += Self::weight(row) * derivative * derivative;
        }
        Some(-slope / square)
    }

    fn cost(&self, log_scale: f64) -> f64 {
        self.held(log_scale).map_or(f64::INFINITY, |held| held.cost)
    }

    /// Places of ln S, from peaks that are too large for any slider to those at which the law ends.
    fn places(&self) -> Vec<f64> {
        let scales = || self.rows.iter().map(|row| row.peak_m_per_s / row.stress);
        let low = libm::log(scales().fold(0.0, f64::max) / LARGEST);
        let high = libm::log(scales().fold(f64::INFINITY, f64::min) / (1.0 + self.law.healing()));
        (0..=PLACES).map(|n| low + (high - low) * f64::from(n) / f64::from(PLACES)).collect()
    }

    pub fn fit(&self) -> Result<CaseFit, PeakFailure> {
        let not_deep = PeakFailure::NotDeep(self.law.law);
        let places = self.places();
        let costs: Vec<f64> = places.iter().map(|place| self.cost(*place)).collect();
        let best = (0..costs.len()).min_by(|one, other| costs[*one].total_cmp(&costs[*other])).unwrap_or(0);
        if !costs[best].is_finite() {
            return Err(not_deep);
        }
        if best == 0 {
            return Err(PeakFailure::Flat);
        }
        let beside = (places[best - 1], places[(best + 1).min(costs.len() - 1)]);
        let at = golden_section(|place| Some(self.cost(place)), beside, WIDTH).unwrap_or(places[best]);
        let held = self.held(at).ok_or(not_deep.clone())?;
        // At the bound of deep stick-slip: stiffer sliders must not fit far better.
        if self.deepest == DEEP && held.log_softness >= libm::log(DEEP) {
            let stiffer = Case { deepest: NOT_DEEP, ..*self }.fit();
            if stiffer.is_ok_and(|fit| held.cost > self.most(fit.cost)) {
                return Err(not_deep);
            }
        }
        let most = self.most(held.cost);
        let end = |place: usize| {
            let outside = |place| Some(self.cost(place) > most);
            libm::exp(
                border_between(outside, (at, places[place]), WIDTH).map_or(places[place], |(_, end)| end),
            )
        };
        let below = (0..best).rev().find(|place| costs[*place] > most);
        // Where the table sets no bound from above, the law does: beyond the last place it has no such peaks.
        let above = (best + 1..costs.len()).find(|place| costs[*place] > most).unwrap_or(costs.len() - 1);
        let [_, quantile] = noise(self.rows, self.given, held.cost, UNKNOWNS);
        let ends = [below.map(end), Some(end(above))];
        let scale = libm::exp(at);
        let width = libm::log(ends[1].unwrap_or(scale) / ends[0].unwrap_or(scale));
        let sides = if ends[0].is_some() { 2.0 } else { 1.0 };
        Ok(CaseFit {
            scale_m_per_s: scale,
            standard_error: scale * width / (sides * quantile),
            ends,
            softness: libm::exp(held.log_softness),
            residuals: held.residuals,
            cost: held.cost,
        })
    }

    /// The largest sum of squares within the 95 % interval.
    fn most(&self, cost: f64) -> f64 {
        let [variance, quantile] = noise(self.rows, self.given, cost, UNKNOWNS);
        cost + quantile * quantile * variance
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::EvolutionLaw;

    /// A table of either law, with deviations that no K/K_c,qs explains.
    fn table(law: EvolutionLaw) -> Vec<PeakRow> {
        let peak_law = PeakLaw::new(law, 1.5);
        let row = |n: u32| {
            let load = 1e-4 * libm::pow(4.0, f64::from(n));
            let noise = [0.02, -0.03, 0.01, 0.03, -0.02][n as usize];
            let peak_m_per_s = peak_law.peak(load, 0.02, 0.5).unwrap() * (1.0 + noise);
            PeakRow { load_m_per_s: load, peak_m_per_s, relative_error: 0.02, stress: 1.0 }
        };
        (0..5).map(row).collect()
    }

    #[test]
    fn the_best_stiffness_at_a_held_scale_is_that_of_a_search_over_all() {
        for law in EvolutionLaw::ALL {
            let rows = table(law);
            let given = PeakGiven {
                laws: vec![law],
                effect_ratio: [1.5; 2],
                slip_velocity_m_per_s: None,
                hidden: 0.0,
                has_errors: true,
            };
            let with = |loss: f64, deepest: f64| Case {
                rows: &rows,
                given: &given,
                law: PeakLaw::new(law, 1.5),
                loss,
                deepest,
            };
            let mut compared = 0;
            for case in [with(0.5, DEEP), with(1.0, DEEP), with(0.0, NOT_DEEP), with(1.0, NOT_DEEP)] {
                for scale in (-12..=6).map(|n| libm::exp(0.05 * f64::from(n))) {
                    let [low, high] = case.bounds(scale).unwrap();
                    let costs = (0..=4000).filter_map(|n| {
                        let at = 0.05f64.mul_add(-f64::from(n), high).max(low);
                        case.at(scale, at).map(|held| held.cost)
                    });
                    let least = costs.fold(f64::INFINITY, f64::min);
                    let held = case.held(libm::log(scale));
                    let found = held.map_or(f64::INFINITY, |held| held.cost);
                    assert!(
                        found <= least * (1.0 + 1e-9),
                        "{law:?} {} {scale}: {found} above {least}",
                        case.loss
                    );
                    compared += usize::from(least.is_finite());
                }
            }
            assert!(compared > 40, "{compared}");
        }
    }
}
