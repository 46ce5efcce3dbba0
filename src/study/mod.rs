//! What a scene needs, planned and computed: pure, and the same bytes on any number of threads.

mod boundary;
mod frequency;
mod grid;
mod hard_case_methods;
mod hard_cases;
mod least_peak;
mod map;
mod near_transition;
mod need;
mod outcome;
mod plan;
mod run;
mod simulations;
mod sweep;
mod tolerance;
mod zones;

pub use boundary::{BoundaryOutcome, END_ERROR, boundary_outcome};
pub use frequency::{FrequencyLine, FrequencyOutcome, frequency_lines};
pub use grid::Grid;
pub use hard_case_methods::{Method, MethodScore};
pub use hard_cases::{FamilyOutcome, HardCase, compare_hard_cases, read_hard_cases};
pub use least_peak::{LeastPeak, MINIMISER_ERROR_DEX, least_peaks};
pub use map::{MapPoint, classify_rectangle};
pub use near_transition::{NearRun, near_runs};
pub use need::{Need, Needs};
pub use outcome::{Outcome, References, SceneOutcome, effect_ratio};
pub use plan::{Item, all_needs, plan};
pub use run::{Progress, inertial_threshold, run};
pub use simulations::{SimulatedPoint, SimulationsOutcome, simulations};
pub use sweep::{SweepOutcome, SweepRow, sweep_effect_ratio};
pub use tolerance::{ToleranceOutcome, ToleranceRow, tolerance_limits};
pub use zones::{ThresholdShare, ZonesOutcome, compare_zones};
