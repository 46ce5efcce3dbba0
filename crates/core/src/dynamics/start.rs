//! Where a run starts: the paper says V = V_l/10 and leaves the rest open, so the rest is a choice here.

use super::{Model, Scalar, State};

slipmode_algebra::named! {
    /// How a start at a velocity other than V_l is completed: what the state and the spring are doing at that moment.
    ///
    /// ```
    /// use slipmode_core::dynamics::Start;
    ///
    /// assert_eq!(Start::default().as_str(), "steady-at-velocity");
    /// assert_eq!(Start::ALL.len(), 4);
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub enum Start {
        /// θ = D_c/V, spring in equilibrium with friction: steady sliding at V, before loading goes on at V_l (the default).
        #[default]
        SteadyAtVelocity = "steady-at-velocity",
        /// θ = D_c/V, spring as in steady sliding at V_l.
        SteadyStateSpringAtLoading = "steady-state-spring-at-loading",
        /// θ = D_c/V_l, spring in equilibrium with friction at V.
        VelocityStepInEquilibrium = "velocity-step-in-equilibrium",
        /// θ and spring as in steady sliding at V_l: a kick of the velocity alone, which dies within a time of order η.
        VelocityKick = "velocity-kick",
    }
}

impl Start {
    /// The state for ln(V/V_l) = `log_velocity_ratio`.
    #[must_use]
    pub fn state<R: Scalar>(self, model: &Model<R>, log_velocity_ratio: &R) -> State<R> {
        let x = log_velocity_ratio.clone();
        let y = match self {
            Self::SteadyAtVelocity | Self::SteadyStateSpringAtLoading => -x.clone(),
            Self::VelocityStepInEquilibrium | Self::VelocityKick => R::from(0),
        };
        let zero = R::from(0);
        let steady_friction = model.friction(&[zero.clone(), zero.clone(), zero.clone()]);
        let equilibrium = model.friction(&[x.clone(), y.clone(), zero]);
        let zeta = match self {
            Self::SteadyStateSpringAtLoading | Self::VelocityKick => steady_friction,
            Self::SteadyAtVelocity | Self::VelocityStepInEquilibrium => equilibrium,
        };
        [x, y, zeta]
    }

    /// The paper's start, V = V_l/10.
    #[must_use]
    pub fn at_a_tenth<R: Scalar>(self, model: &Model<R>) -> State<R> {
        self.state(model, &-R::from(10).logarithm())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::{EvolutionLaw, Groups};

    #[test]
    fn the_default_start_is_that_of_steady_sliding_at_a_tenth() {
        let groups = Groups { inertial_parameter: 0.5, stiffness_group: 2.0, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let [x, y, zeta] = Start::default().at_a_tenth(&model);
        assert_eq!([x, y], [-std::f64::consts::LN_10, std::f64::consts::LN_10]);
        assert!((zeta - 0.5 * std::f64::consts::LN_10).abs() < 1e-15);
        // Friction balances the spring, the state is steady: only the spring moves at first.
        let rate = model.rate(&[x, y, zeta]);
        assert!(rate[0].abs() < 1e-14 && rate[1].abs() < 1e-15 && (rate[2] - 2.0 * 0.9).abs() < 1e-15);
    }
}
