//! A slider whose load point changes its velocity: the spring stress at given times, with its derivatives by the parameters.
//!
//! The slider slides steadily at the velocity of the load point before the record begins. Velocity of the load point and normal stress
//! are constant on each piece of the record. Where the normal stress jumps, the spring stress does not: its ratio to the normal stress jumps.
//! Without mass the run is that of an inertia too small to matter.

use super::integrator::{Control, Integrator};
use super::radau::Radau;
use super::sensitivity::{Derivatives, Direction, STAGES, over_step};
use super::{Failure, Model};
use crate::friction::{EvolutionLaw, Groups};

/// A part of a record in which the load point moves at one velocity under one normal stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// When it ends, s; it begins where the one before ends, and the first one at 0.
    pub until_s: f64,
    /// Velocity of the load point, m/s; positive in the first piece, and not negative later.
    pub load_point_velocity_m_per_s: f64,
    /// Normal stress, Pa; positive.
    pub normal_stress_pa: f64,
}

/// Friction and machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenSlider {
    /// a of eq 1.
    pub direct_effect: f64,
    /// b of eq 1.
    pub evolution_effect: f64,
    /// D_c of eqs 1-3, m.
    pub critical_slip_distance_m: f64,
    /// K of eq 4, Pa/m.
    pub stiffness_pa_per_m: f64,
    /// μ0 of eq 1: the friction of steady sliding at the velocity of the first piece.
    pub reference_friction: f64,
    /// M of eq 4, kg/m²; none for a slider without inertia.
    pub mass_per_area_kg_per_m2: Option<f64>,
    /// The evolution law.
    pub law: EvolutionLaw,
}

/// What derivatives are taken by: ln a, ln b, ln D_c, ln K, and μ0.
pub const DRIVEN_PARAMETERS: usize = 5;

/// The spring stress at one time over the normal stress of the first piece, and its derivatives by ln a, ln b, ln D_c, ln K and μ0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Driven {
    /// Spring stress over the normal stress of the first piece: the friction, where the normal stress is constant.
    pub friction: f64,
    /// Its derivatives; zero where none were requested.
    pub derivatives: [f64; DRIVEN_PARAMETERS],
}

/// How exact a run is, and whether it has derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenControl {
    /// Permitted local error of ln V, ln θ and of friction over a.
    pub local_tolerance: f64,
    /// Most steps.
    pub most_steps: u64,
    /// Whether derivatives are computed.
    pub with_derivatives: bool,
}

/// η of a slider without inertia, at the fastest velocity of the load point: ln V then lags by about as much.
const NEGLIGIBLE_INERTIA: f64 = 1e-11;

/// Runs the slider through the pieces and gives the spring stress at these times (s, ascending, not beyond the last piece).
///
/// # Errors
/// Those of the integrator.
pub fn drive(
    slider: &DrivenSlider,
    pieces: &[Piece],
    times_s: &[f64],
    control: DrivenControl,
) -> Result<Vec<Driven>, Failure> {
    let Some(first) = pieces.first() else { return Err(Failure::InvalidStart) };
    let models: Vec<Model<f64>> = pieces.iter().map(|piece| slider.model(pieces, piece)).collect();
    let time_unit_s = slider.critical_slip_distance_m / first.load_point_velocity_m_per_s;
    let limits = Control { local_tolerance: control.local_tolerance, most_steps: control.most_steps };
    let mut run = DrivenRun {
        slider,
        directions: slider.directions(),
        integrator: Integrator::new(&models[0], Radau::new(), [0.0; 3], limits)?,
        derivatives: [[0.0; 3]; DRIVEN_PARAMETERS],
        weight: 1.0,
        with_derivatives: control.with_derivatives,
        times: times_s.iter().map(|time| time / time_unit_s).peekable(),
        driven: Vec::with_capacity(times_s.len()),
    };
    for (piece, model) in pieces.iter().zip(&models) {
        run.enter(model, piece.normal_stress_pa / first.normal_stress_pa);
        run.through(piece.until_s / time_unit_s)?;
    }
    run.rest();
    Ok(run.driven)
}

impl DrivenSlider {
    fn model(&self, pieces: &[Piece], piece: &Piece) -> Model<f64> {
        let reference = pieces[0].load_point_velocity_m_per_s;
        let fastest =
            pieces.iter().fold(0.0f64, |fastest, piece| fastest.max(piece.load_point_velocity_m_per_s));
        let weight = self.direct_effect * piece.normal_stress_pa;
        let inertia = |mass: f64| mass * reference * reference / (weight * self.critical_slip_distance_m);
        let groups = Groups {
            inertial_parameter: self
                .mass_per_area_kg_per_m2
                .map_or_else(|| NEGLIGIBLE_INERTIA * (reference / fastest) * (reference / fastest), inertia),
            stiffness_group: self.stiffness_pa_per_m * self.critical_slip_distance_m / weight,
            effect_ratio: self.evolution_effect / self.direct_effect,
        };
        Model::new(groups, self.law).loaded_at(piece.load_point_velocity_m_per_s / reference)
    }

    /// How the groups change with ln a, ln b, ln D_c, ln K and μ0.
    fn directions(&self) -> [Direction; DRIVEN_PARAMETERS] {
        let has_mass = if self.mass_per_area_kg_per_m2.is_some() { 1.0 } else { 0.0 };
        let direction = |[inertia, stiffness, ratio, time]: [f64; 4]| Direction {
            log_inertial_parameter: has_mass * inertia,
            log_stiffness_group: stiffness,
            log_effect_ratio: ratio,
            log_time_unit: time,
        };
        [
            [-1.0, -1.0, -1.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
            [-1.0, 1.0, 0.0, 1.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0],
        ]
        .map(direction)
    }
}

/// A run in progress; times are in D_c/V_l.
struct DrivenRun<'r, T: Iterator<Item = f64>> {
    slider: &'r DrivenSlider,
    directions: [Direction; DRIVEN_PARAMETERS],
    integrator: Integrator<'r, f64, Radau<f64, STAGES>>,
    derivatives: Derivatives<DRIVEN_PARAMETERS>,
    /// The normal stress over that of the first piece.
    weight: f64,
    with_derivatives: bool,
    times: std::iter::Peekable<T>,
    driven: Vec<Driven>,
}

impl<'r, T: Iterator<Item = f64>> DrivenRun<'r, T> {
    /// Goes on with another model and normal stress; the spring stress stays.
    fn enter(&mut self, model: &'r Model<f64>, weight: f64) {
        let factor = self.weight / weight;
        self.weight = weight;
        let mut state = *self.integrator.state();
        let offset = (factor - 1.0) * self.slider.reference_friction / self.slider.direct_effect;
        state[2] = factor * state[2] + offset;
        for derivative in &mut self.derivatives {
            derivative[2] *= factor;
        }
        self.derivatives[0][2] -= offset;
        self.derivatives[4][2] += (factor - 1.0) / self.slider.direct_effect;
        if self.slider.mass_per_area_kg_per_m2.is_none() {
            // Without inertia the velocity follows at once; in its own time it would take a hundred steps.
            let ratio = model.groups().effect_ratio;
            state[0] = state[2] - ratio * state[1];
            for (derivative, direction) in self.derivatives.iter_mut().zip(&self.directions) {
                let change = direction.log_effect_ratio * state[1];
                derivative[0] = derivative[2] - ratio * (derivative[1] + change);
            }
        }
        self.integrator.continue_with(model, state);
    }

    /// Runs to the end of a piece.
    fn through(&mut self, until: f64) -> Result<(), Failure> {
        while until - self.integrator.time() > 1e-13 * until {
            let began = self.integrator.time();
            self.integrator.advance(Some(&(until - began)))?;
            let step = *self.integrator.step();
            let slopes = self.with_derivatives.then(|| self.carry_derivatives(step));
            while let Some(time) = self.times.next_if(|time| *time <= began + step) {
                let theta = (time - began) / step;
                let excess = self.integrator.state_within(&theta)[2];
                let at_theta = |slope: [f64; STAGES + 1]| {
                    slope.iter().rev().fold(0.0, |sum, coefficient| sum * theta + coefficient)
                };
                let derivatives = slopes.map_or([0.0; DRIVEN_PARAMETERS], |slopes| slopes.map(at_theta));
                self.driven.push(self.friction(excess, derivatives));
            }
        }
        Ok(())
    }

    /// Carries the derivatives over the last step; gives the polynomials in θ of those of ζ.
    fn carry_derivatives(&mut self, step: f64) -> [[f64; STAGES + 1]; DRIVEN_PARAMETERS] {
        let (model, method) = (self.integrator.model, self.integrator.method());
        let before = self.derivatives;
        let stages = over_step(model, method, (&self.integrator.step_start, step), &before, &self.directions);
        let dense = &method.last_stages().1.dense;
        for (p, derivative) in self.derivatives.iter_mut().enumerate() {
            for (c, value) in derivative.iter_mut().enumerate() {
                *value += stages[STAGES - 1][p][c];
            }
        }
        std::array::from_fn(|p| {
            std::array::from_fn(|k| match k {
                0 => before[p][2],
                _ => (0..STAGES).map(|i| dense[k - 1][i] * stages[i][p][2]).sum(),
            })
        })
    }

    /// The friction for ζ and its derivatives.
    fn friction(&self, excess: f64, derivatives: [f64; DRIVEN_PARAMETERS]) -> Driven {
        let a = self.weight * self.slider.direct_effect;
        let mut derivatives = derivatives.map(|derivative| a * derivative);
        derivatives[0] += a * excess;
        derivatives[4] += self.weight;
        Driven { friction: self.weight * self.slider.reference_friction + a * excess, derivatives }
    }

    /// Times that the last step misses by a rounding.
    fn rest(&mut self) {
        let derivatives = self.derivatives.map(|derivative| derivative[2]);
        while self.times.next().is_some() {
            let driven = self.friction(self.integrator.state()[2], derivatives);
            self.driven.push(driven);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const EXACT: DrivenControl =
        DrivenControl { local_tolerance: 1e-12, most_steps: 100_000, with_derivatives: true };

    fn slider(law: EvolutionLaw, mass: Option<f64>) -> DrivenSlider {
        DrivenSlider {
            direct_effect: 0.008,
            evolution_effect: 0.012,
            critical_slip_distance_m: 1e-5,
            stiffness_pa_per_m: 2e10,
            reference_friction: 0.6,
            mass_per_area_kg_per_m2: mass,
            law,
        }
    }

    fn pieces(velocities: &[f64], stresses: &[f64]) -> Vec<Piece> {
        let piece = |(index, (velocity, stress)): (usize, (&f64, &f64))| Piece {
            until_s: 20.0 * (index as f64 + 1.0),
            load_point_velocity_m_per_s: *velocity,
            normal_stress_pa: *stress,
        };
        velocities.iter().zip(stresses).enumerate().map(piece).collect()
    }

    fn changed(slider: &DrivenSlider, parameter: usize, by: f64) -> DrivenSlider {
        let mut changed = *slider;
        match parameter {
            0 => changed.direct_effect *= by.exp(),
            1 => changed.evolution_effect *= by.exp(),
            2 => changed.critical_slip_distance_m *= by.exp(),
            3 => changed.stiffness_pa_per_m *= by.exp(),
            _ => changed.reference_friction += by,
        }
        changed
    }

    #[test]
    fn steady_sliding_ends_at_the_steady_friction_of_the_new_velocity() {
        for law in EvolutionLaw::ALL {
            let pieces = pieces(&[1e-6, 1e-5, 1e-5, 1e-5], &[5e6; 4]);
            let driven = drive(&slider(law, None), &pieces, &[0.0, 10.0, 20.0, 80.0], EXACT).unwrap();
            assert_eq!(driven[1].friction, 0.6);
            // After 60 D_c: mu_0 + (a − b) ln 10.
            assert!(
                (driven[3].friction - (0.6 - 0.004 * std::f64::consts::LN_10)).abs() < 1e-9,
                "{driven:?}"
            );
            assert!((driven[3].derivatives[0] - 0.008 * std::f64::consts::LN_10).abs() < 1e-8);
            assert!((driven[3].derivatives[4] - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_mass_too_small_to_matter_changes_nothing() {
        let pieces = pieces(&[1e-6, 1e-5, 3e-6], &[5e6; 3]);
        let times: Vec<f64> = (0..120).map(|i| f64::from(i) * 0.5).collect();
        let [without, with] = [None, Some(1.0)]
            .map(|mass| drive(&slider(EvolutionLaw::Aging, mass), &pieces, &times, EXACT).unwrap());
        for (one, other) in without.iter().zip(&with) {
            assert!((one.friction - other.friction).abs() < 1e-11, "{one:?} {other:?}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn derivatives_are_those_of_the_run(
            law in 0usize..2, mass in prop::option::of(-2.0f64..8.0), velocity in 0.2f64..20.0,
            stress in prop::array::uniform2(0.9f64..1.1), ratio in 0.3f64..1.4, parameter in 0usize..5,
        ) {
            let mut slider = slider(EvolutionLaw::ALL[law], mass.map(|decade| libm::pow(10.0, decade)));
            slider.evolution_effect = ratio * slider.direct_effect;
            let pieces = pieces(&[1e-6, velocity * 1e-6, 2e-6], &[5e6, stress[0] * 5e6, stress[1] * 5e6]);
            let times: Vec<f64> = (0..60).map(f64::from).collect();
            let run = |slider: &DrivenSlider| drive(slider, &pieces, &times, EXACT).unwrap();
            let derivatives = run(&slider);
            // Central differences of fourth order: the runs are good to 1e-11, the rest is 1e-13 times a fifth derivative.
            let step = 1e-3;
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|by| run(&changed(&slider, parameter, by * step)));
            for (i, exact) in derivatives.iter().enumerate() {
                let difference = (8.0 * (c[i].friction - b[i].friction) - (d[i].friction - a[i].friction)) / (12.0 * step);
                let error = (exact.derivatives[parameter] - difference).abs();
                prop_assert!(error < 2e-7, "{i} {error:e} {} {difference}", exact.derivatives[parameter]);
            }
        }
    }
}
