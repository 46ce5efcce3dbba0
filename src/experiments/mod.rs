//! What a scene's sections say, compute and show: one folder an experiment. Pure, and the same bytes on any number of threads.
//!
//! Scenes, plans and outcomes are made from the list of all experiments at the end.

pub mod boundary;
pub mod certificates;
mod context;
pub mod described;
pub mod effect_ratio_sweep;
mod experiment;
mod figures;
pub mod fit;
pub mod frequency;
pub mod linear_regime;
pub mod map;
pub mod near_transition;
pub mod onset;
pub mod operating_point;
mod outcome;
pub mod own_weight;
pub mod pictures;
mod run;
mod scene;
pub mod shared;
pub mod simulations;
pub mod start_sensitivity;
pub mod swept;
mod tables;
#[cfg(test)]
pub mod test_experiment;
pub mod tolerance;
pub mod trajectories;
pub mod work;
pub mod zones;

pub use context::Context;
pub use experiment::{Experiment, Requirement};
pub(crate) use experiment::{RunOf, experiment};
pub use figures::{Drawer, Figure, FigureMaker, Words};
pub use outcome::{Outcome, References};
pub use run::{Needs, Progress, all_needs, run};
pub use scene::check_distinct_scene_names;
pub use tables::TableMaker;
pub(crate) use tables::{Rows, table_of};
pub use work::Work;

use std::sync::LazyLock;

use crate::scene::ParametersSection;
use crate::scene::section::Section;
use crate::sweep::SweepSection;
use scene::read_experiment;
use slipmode_core::number::Rational;

/// Makes everything that lists experiments from one line for each: what it is about, the word for the computation, the
/// key of the scene's section, and the section's type.
macro_rules! experiments {
    ($(#[doc = $about:literal] $(#[cfg($condition:meta)])? $word:ident, $key:ident: $section:ty;)*) => {
        /// One kind of computation that a claim, a table or a figure can require.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Need {
            $(#[doc = $about] $(#[cfg($condition)])? $word,)*
        }

        impl Need {
            /// Every computation, in the order in which a scene's computations run.
            pub const ALL: &'static [Self] = &[$($(#[cfg($condition)])? Self::$word,)*];

            /// The key of the section that states it.
            pub(crate) fn key(self) -> &'static str {
                match self {
                    $($(#[cfg($condition)])? Self::$word => stringify!($key),)*
                }
            }

            /// Whether a scene states it.
            pub(crate) fn is_stated_by(self, scene: &Scene) -> bool {
                match self {
                    $($(#[cfg($condition)])? Self::$word => scene.$key.is_some(),)*
                }
            }

            /// Computes it for the scene of an outcome, which keeps the result.
            fn compute(self, outcome: &mut SceneOutcome, references: &References) {
                match self {
                    $($(#[cfg($condition)])? Self::$word => {
                        let section = outcome.scene.$key.as_ref();
                        outcome.$key = section.and_then(|section| section.run(outcome, references));
                    })*
                }
            }
        }

        /// What a user requests: valid and exact.
        #[derive(Debug, Clone, Default, PartialEq, Eq)]
        pub struct Scene {
            /// The name, safe as a file name.
            pub name: String,
            /// The title, for people.
            pub title: String,
            /// The slider; absent in scenes that need none.
            pub parameters: Option<ParametersSection>,
            /// ω/ω_n above which an oscillation is called inertial; absent for the default √(1/2), exactly.
            pub inertial_threshold: Option<Rational>,
            /// Points for many machines, and what is computed at each.
            pub sweep: Option<SweepSection>,
            $(#[doc = $about] $(#[cfg($condition)])? pub $key: Option<$section>,)*
        }

        impl Scene {
            /// What the sections ask of the machine, each with its key.
            pub(crate) fn work(&self) -> Vec<(&'static str, Work)> {
                [$($(#[cfg($condition)])? (stringify!($key), self.$key.as_ref().map(Experiment::work)),)*]
                    .into_iter()
                    .filter_map(|(key, work)| Some((key, work?)))
                    .collect()
            }

            /// With the experiments' sections, which stand after the head of a scene.
            fn with_experiments(self, top: &mut Section<'_>) -> Self {
                let known = self.known_parameters(top);
                Self {
                    $($(#[cfg($condition)])? $key: read_experiment::<$section>(known, stringify!($key), top),)*
                    ..self
                }
            }
        }

        /// Everything computed for one scene; what nothing required is absent.
        #[derive(Debug, Clone)]
        pub struct SceneOutcome {
            /// The scene.
            pub scene: Scene,
            $(#[doc = $about] $(#[cfg($condition)])? pub $key: Option<<$section as Experiment>::Outcome>,)*
        }

        impl SceneOutcome {
            /// A scene of which nothing has been computed yet.
            pub(crate) fn new(scene: Scene) -> Self {
                Self { scene, $($(#[cfg($condition)])? $key: None,)* }
            }
        }

        /// All tables of the experiments.
        pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
            [$($(#[cfg($condition)])? <$section as Experiment>::TABLES,)*].into_iter().flatten().copied().flatten()
        }

        /// What draws the figures of the experiments.
        fn drawers() -> impl Iterator<Item = &'static Drawer> {
            [$($(#[cfg($condition)])? <$section as Experiment>::FIGURES,)*].into_iter().flatten().copied().flatten()
        }
    };
}

/// All figures of the experiments.
pub fn figure_makers() -> impl Iterator<Item = &'static FigureMaker> {
    static MAKERS: LazyLock<Vec<FigureMaker>> =
        LazyLock::new(|| drawers().filter_map(FigureMaker::new).collect());
    MAKERS.iter()
}

experiments! {
    /// max Im(s) and the spectral class on a (V, σ) grid.
    Map, map: map::MapSection;
    /// The exact boundary with its asymptotes, and the agreement of its three routes.
    Boundary, boundary: boundary::BoundarySection;
    /// max Im(s) along lines of constant normal stress.
    Frequency, frequency: frequency::FrequencySection;
    /// The worst errors of the asymptotes against b/a.
    EffectRatioSweep, effect_ratio_sweep: effect_ratio_sweep::EffectRatioSweepSection;
    /// Where each asymptote is good to a given relative error.
    Tolerance, tolerance: tolerance::ToleranceSection;
    /// Slip modes on a (V, σ) grid against the simplified map of the asymptotes.
    Zones, zones: zones::ZonesSection;
    /// The slip mode of the operating point, what leaves it, and which error bar decides it.
    OperatingPoint, operating_point: operating_point::OperatingPointSection;
    /// Slip modes of a slider under its own weight, over velocity and K/M.
    OwnWeight, own_weight: own_weight::OwnWeightSection;
    /// The nonlinear slider on a (V, σ) grid.
    Simulations, simulations: simulations::SimulationsSection;
    /// The nonlinear slider over time at named points.
    Trajectories, trajectories: trajectories::TrajectoriesSection;
    /// Small disturbances along the eigenvectors, and steady sliding itself.
    LinearRegime, linear_regime: linear_regime::LinearRegimeSection;
    /// Every completion of the start V_l/10.
    StartSensitivity, start_sensitivity: start_sensitivity::StartSensitivitySection;
    /// Where oscillation begins along lines of constant normal stress.
    Onset, onset: onset::OnsetSection;
    /// The nonlinear slider close to K = K_c.
    NearTransition, near_transition: near_transition::NearTransitionSection;
    /// Certificates of runs.
    Certificates, certificates: certificates::CertificatesSection;
    /// Friction parameters of a record of velocity steps.
    Fit, fit: fit::FitSection;
    /// Sweeps that ran elsewhere.
    Swept, swept: swept::SweptSection;
    /// The critical stiffness at given normal stresses.
    #[cfg(test)]
    TestExperiment, test_experiment: test_experiment::TestExperimentSection;
}
