//! One equation of a file, what it is, and what is at fault in one.
//!
//! Procedures find an equation by its role, whatever its number.

use std::fmt;

use crate::notation::did_you_mean;
use slipmode_algebra::{Condition, Expression};
use slipmode_core::friction::EvolutionLaw;

/// One equation of a paper.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// Its number in the paper, or a name where the paper gives none.
    pub number: String,
    /// The left side.
    pub left: Expression,
    /// The right side.
    pub right: Expression,
    /// Both sides as the page at hand shows them, where that differs from what is meant.
    pub printed: Option<(Expression, Expression)>,
    /// Why it differs, or what it is.
    pub note: String,
    /// What it is stated for, besides the assumptions of the file.
    pub given: Vec<Condition>,
    /// What it is: procedures find it so.
    pub role: Option<Role>,
}

impl Equation {
    /// left − right, which the equation says is zero.
    #[must_use]
    pub fn residual(&self) -> Expression {
        self.left.clone() - self.right.clone()
    }

    /// The names `left_N`, `right_N` and `residual_N`, each with what it means.
    #[must_use]
    pub fn sides(&self) -> [(String, Expression); 3] {
        [("left", self.left.clone()), ("right", self.right.clone()), ("residual", self.residual())]
            .map(|(side, expression)| (format!("{side}_{}", self.word()), expression))
    }

    /// Its number as a part of a name, as in `left_steady_state`.
    #[must_use]
    pub fn word(&self) -> String {
        self.number.replace(['-', '.'], "_")
    }

    /// The equation in LaTeX.
    #[must_use]
    pub fn latex(&self) -> String {
        format!("{} = {}", self.left.latex(), self.right.latex())
    }
}

impl fmt::Display for Equation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} = {}", self.left, self.right)
    }
}

/// What is wrong with one equation of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EquationFault {
    /// The key at fault, such as `equation 16`.
    pub key: String,
    /// What is wrong with it.
    pub message: String,
}

impl fmt::Display for EquationFault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.key, self.message)
    }
}

slipmode_algebra::named! {
    /// What an equation is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
    pub enum Role {
        /// Friction by velocity and state.
        Friction = "friction",
        /// The rate of the state, which heals at rest.
        AgingLaw = "aging-law",
        /// The rate of the state, which evolves by slip only.
        SlipLaw = "slip-law",
        /// The motion of the slider: mass, spring and friction per normal stress.
        Motion = "motion",
        /// The state in steady sliding.
        SteadyState = "steady-state",
        /// Friction in steady sliding.
        SteadyFriction = "steady-friction",
        /// Friction without a limit of small velocities.
        RegularisedFriction = "regularised-friction",
        /// The cubic of which a small disturbance's rate is a root.
        Characteristic = "characteristic",
        /// The same without inertia.
        QuasiStaticCharacteristic = "quasi-static-characteristic",
        /// K_c, where max Re(s) = 0.
        Transition = "transition",
        /// The part of K_c without inertia.
        QuasiStaticTransition = "quasi-static-transition",
        /// The part of K_c with inertia.
        InertialTransition = "inertial-transition",
        /// The normal stress of the transition without inertia.
        CriticalNormalStress = "critical-normal-stress",
        /// The velocity of the transition where inertia prevails.
        CriticalVelocity = "critical-velocity",
        /// The boundary's upper arc at low velocity: a normal stress.
        QuasiStaticUpper = "quasi-static-upper",
        /// The boundary's lower arc at low velocity: a normal stress.
        QuasiStaticLower = "quasi-static-lower",
        /// The boundary's upper arc at high velocity: where a ratio in proportion to velocity is 1.
        InertialUpper = "inertial-upper",
        /// The boundary's lower arc at high velocity: where a ratio in proportion to velocity is 1.
        InertialLower = "inertial-lower",
        /// The root at low velocity on the transition.
        FrequencyLimit = "frequency-limit",
        /// The angular frequency of mass and spring.
        NaturalFrequency = "natural-frequency",
        /// η.
        InertialParameter = "inertial-parameter",
    }
}

impl Role {
    /// The role of this word.
    pub(super) fn read(word: &str) -> Result<Self, String> {
        Self::from_word(word).ok_or_else(|| {
            let all = Self::ALL.map(Self::as_str);
            format!("'{word}' is no role{} (allowed: {})", did_you_mean(word, all), all.join(", "))
        })
    }

    /// The law's equation.
    #[must_use]
    pub const fn of_law(law: EvolutionLaw) -> Self {
        match law {
            EvolutionLaw::Aging => Self::AgingLaw,
            EvolutionLaw::Slip => Self::SlipLaw,
        }
    }

    /// The symbol that stands alone on its left, where procedures take its right side for that.
    pub(super) const fn left(self) -> Option<&'static str> {
        Some(match self {
            Self::Friction | Self::RegularisedFriction => "mu",
            Self::AgingLaw | Self::SlipLaw => "theta'",
            Self::SteadyState => "theta_ss",
            Self::SteadyFriction => "mu_ss",
            Self::Transition => "K_c",
            Self::QuasiStaticTransition => "K_c_qs",
            Self::InertialTransition => "K_c_dyn",
            Self::CriticalNormalStress => "sigma_c",
            Self::CriticalVelocity => "V_c",
            Self::QuasiStaticUpper | Self::QuasiStaticLower => "sigma",
            Self::FrequencyLimit => "s",
            Self::NaturalFrequency => "omega_n",
            Self::InertialParameter => "eta",
            Self::Motion
            | Self::Characteristic
            | Self::QuasiStaticCharacteristic
            | Self::InertialUpper
            | Self::InertialLower => return None,
        })
    }
}
