//! What a scene's sections say, compute and show: one folder an experiment. Pure, and the same bytes on any number of threads.

pub mod boundary;
pub mod effect_ratio_sweep;
pub mod error_bound;
mod experiment;
mod figures;
pub mod frequency;
pub mod hard_cases;
pub mod linear_regime;
pub mod map;
pub mod near_transition;
pub mod onset;
pub mod original_scheme;
mod outcome;
mod registry;
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
pub mod work_precision;
pub mod zones;

pub use experiment::{Experiment, Requirement, Setting};
pub use figures::{Figure, FigureMaker};
pub use outcome::{Outcome, References};
pub use registry::{Need, Scene, SceneOutcome, figure_makers, table_makers};
pub use run::{Needs, Progress, all_needs, run};
pub use scene::check_distinct_scene_names;
pub use tables::TableMaker;
pub(crate) use tables::unless_empty;
pub use work::Work;

use slipmode_core::theory::PaperEquations;

/// What a table or a check may look at.
#[derive(Debug, Clone, Copy)]
pub struct Context<'c> {
    /// The paper's equations as the report states them: the thing under test.
    pub equations: &'c PaperEquations,
    /// What was computed for the report's scenes.
    pub outcome: &'c Outcome,
}
