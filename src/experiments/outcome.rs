//! What was computed, scene by scene.

use slipmode_core::friction::Slider;
use std::collections::BTreeMap;

use crate::experiments::Scene;
use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::effect_ratio_sweep::SweepOutcome;
use crate::experiments::error_bound::BoundCheck;
use crate::experiments::frequency::FrequencyOutcome;
use crate::experiments::hard_cases::{FamilyOutcome, HardCase, HardReturn, ReturnOutcome};
use crate::experiments::linear_regime::LinearRegimeOutcome;
use crate::experiments::map::MapPoint;
use crate::experiments::near_transition::NearTransitionOutcome;
use crate::experiments::onset::OnsetOutcome;
use crate::experiments::original_scheme::OriginalSchemeOutcome;
use crate::experiments::shared::Grid;
use crate::experiments::simulations::SimulationsOutcome;
use crate::experiments::speed_counts::SpeedCounts;
use crate::experiments::speed_counts::TimingsSection;
use crate::experiments::start_sensitivity::StartGroup;
use crate::experiments::swept::Swept;
use crate::experiments::timings::Timings;
use crate::experiments::tolerance::ToleranceOutcome;
use crate::experiments::trajectories::TrajectoryRun;
use crate::experiments::work_precision::WorkCase;
use crate::experiments::zones::ZonesOutcome;
use slipmode_core::number::Rational;

/// Everything computed for one scene; what nobody needed is absent.
#[derive(Debug, Clone)]
pub struct SceneOutcome {
    /// The scene.
    pub scene: Scene,
    /// Its map.
    pub map: Option<Grid<MapPoint>>,
    /// Its boundary.
    pub boundary: Option<BoundaryOutcome>,
    /// Its lines of constant normal stress.
    pub frequency: Option<FrequencyOutcome>,
    /// Its sweep over b/a.
    pub effect_ratio_sweep: Option<SweepOutcome>,
    /// Where its asymptotes are good enough.
    pub tolerance: Option<ToleranceOutcome>,
    /// Its slip modes against the simplified map.
    pub zones: Option<ZonesOutcome>,
    /// How its hard cases fared.
    pub hard_cases: Option<Vec<FamilyOutcome>>,
    /// How its hard returns fared.
    pub hard_returns: Option<Vec<ReturnOutcome>>,
    /// Its simulations.
    pub simulations: Option<SimulationsOutcome>,
    /// Its small disturbances, and steady sliding itself.
    pub linear_regime: Option<LinearRegimeOutcome>,
    /// Its completions of the start, a group for each point and law.
    pub start_sensitivity: Option<Vec<StartGroup>>,
    /// Where its oscillation begins.
    pub onset: Option<OnsetOutcome>,
    /// Its slider close to K = K_c.
    pub near_transition: Option<NearTransitionOutcome>,
    /// Its trajectories, point by point and law by law.
    pub trajectories: Option<Vec<TrajectoryRun>>,
    /// The original scheme against converged runs.
    pub original_scheme: Option<OriginalSchemeOutcome>,
    /// Work against error of the integrators.
    pub work_precision: Option<Vec<WorkCase>>,
    /// Stated errors against true ones.
    pub error_bound: Option<Vec<BoundCheck>>,
    /// Work against error, by counts.
    pub speed_counts: Option<SpeedCounts>,
    /// Times that other commands measured.
    pub timings: Option<Timings>,
    /// Its sweeps that ran elsewhere.
    pub swept: Option<Vec<Swept>>,
}

impl SceneOutcome {
    /// A scene of which nothing has been computed yet.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        SceneOutcome {
            scene,
            map: None,
            boundary: None,
            frequency: None,
            effect_ratio_sweep: None,
            tolerance: None,
            zones: None,
            hard_cases: None,
            hard_returns: None,
            simulations: None,
            linear_regime: None,
            start_sensitivity: None,
            onset: None,
            near_transition: None,
            trajectories: None,
            original_scheme: None,
            work_precision: None,
            error_bound: None,
            speed_counts: None,
            timings: None,
            swept: None,
        }
    }

    /// The slider, where the scene states one.
    #[must_use]
    pub fn slider(&self) -> Option<&Slider<Rational>> {
        self.scene.parameters.as_ref().map(|section| &section.slider)
    }
}

/// The outcomes of a report's scenes, in the report's order.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// One per scene.
    pub scenes: Vec<SceneOutcome>,
}

impl Outcome {
    /// The first scene with a < b: the potentially unstable slider of the paper.
    #[must_use]
    pub fn potentially_unstable(&self) -> Option<&SceneOutcome> {
        self.first_with(|p| p.evolution_effect > p.direct_effect)
    }

    /// The first scene with a > b: the intrinsically stable slider of the paper.
    #[must_use]
    pub fn intrinsically_stable(&self) -> Option<&SceneOutcome> {
        self.first_with(|p| p.evolution_effect < p.direct_effect)
    }

    /// The first scene whose a is not below its b: the slider that no velocity makes unstable.
    #[must_use]
    pub fn never_unstable(&self) -> Option<&SceneOutcome> {
        self.first_with(|p| p.evolution_effect <= p.direct_effect)
    }

    fn first_with(&self, wanted: impl Fn(&Slider<Rational>) -> bool) -> Option<&SceneOutcome> {
        self.scenes.iter().find(|scene| scene.slider().is_some_and(&wanted))
    }
}

/// What scenes refer to by file name and `cli` has read: nothing here opens a file.
#[derive(Debug, Clone, Default)]
pub struct References {
    /// Hard cases by file name.
    pub hard_cases: BTreeMap<String, Vec<HardCase>>,
    /// Hard returns by file name.
    pub hard_returns: BTreeMap<String, Vec<HardReturn>>,
    /// Times by the section that names their files.
    pub timings: BTreeMap<TimingsSection, Timings>,
    /// Sweeps by name.
    pub swept: BTreeMap<String, Swept>,
}
