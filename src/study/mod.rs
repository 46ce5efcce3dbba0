//! What a scene needs, planned and computed: pure, and the same bytes on any number of threads.

mod bistability;
mod blocks;
mod boundary;
mod comparison;
mod csv_records;
mod cycle_families;
mod error_bound;
mod families;
mod first_swing;
#[cfg(test)]
mod fixtures;
mod frequency;
mod grid;
mod hard_case_methods;
mod hard_cases;
mod hard_returns;
mod least_peak;
mod linear_modes;
mod linear_regime;
mod low_discrepancy;
mod map;
mod near_transition;
mod need;
mod onset;
mod onset_search;
mod onset_theory;
mod original_scheme;
mod outcome;
mod plan;
mod recording;
mod run;
mod scheme_least_peak;
mod scheme_run;
mod scheme_stability;
mod search;
mod simulations;
mod snapshots;
mod speed;
mod start_sensitivity;
mod steady_sliding;
mod summary;
mod sweep;
mod sweep_points;
mod swept;
mod textbook;
mod thinning;
mod timings;
mod tolerance;
mod trajectories;
mod work_precision;
mod zones;

pub use bistability::{Edge, Threshold, place_on_transition};
pub use blocks::{Blocks, Shard, array_string};
pub use boundary::{BoundaryOutcome, END_ERROR, boundary_outcome};
pub use comparison::{
    Agreement, Comparison, Finding, Observable, Origin, Reference, Simulate, StatedMode, StatedRun, Theory,
    Value, compare_run,
};
pub use cycle_families::{AmplitudeDeviation, CycleFamilyOutcome, FamilyCycle};
pub use error_bound::{BoundCheck, error_bound};
pub use families::{Factors, Families, NamedPoint, PointState};
pub use frequency::{FrequencyLine, FrequencyOutcome, frequency_lines};
pub use grid::Grid;
pub use hard_case_methods::{Method, MethodScore};
pub use hard_cases::{FamilyOutcome, HardCase, compare_hard_cases, read_hard_cases};
pub use hard_returns::{
    HardReturn, ReturnAnswer, ReturnOutcome, ReturnVerdict, read_hard_returns, run_hard_returns,
};
pub use least_peak::{FLATNESS_LEVELS, LeastPeak, SIDE_WIDTH, least_peaks};
pub use linear_modes::Direction;
pub use linear_regime::{LinearRegimeOutcome, Mismatch, ModeRuns, linear_regime};
pub use low_discrepancy::LowDiscrepancy;
pub use map::{MapPoint, classify_rectangle};
pub use near_transition::{NearRun, NearTransitionOutcome, near_transition};
pub use need::{Need, Needs};
pub use onset::{Onset, OnsetOutcome, OtherUnit, ShownRun, onset};
pub use onset_search::{Located, SeenOnset};
pub use original_scheme::{OriginalSchemeOutcome, SchemeSeries, SchemeStep, original_scheme};
pub use outcome::{Outcome, References, SceneOutcome, effect_ratio};
pub use plan::{Item, all_needs, plan};
pub use recording::{Gap, LEAST_SAMPLES, Measured, RecordedBehaviour, RecordedDecay, Recording, Undecided};
pub use run::{Progress, inertial_threshold, run};
pub use scheme_least_peak::SchemeLeastPeak;
pub use scheme_run::{AFFORDABLE_STEPS, SchemePeak};
pub use scheme_stability::{SchemeMapRow, SchemeTransition, critical_shift};
pub use simulations::{SimulatedPoint, SimulationsOutcome, simulations};
pub use speed::{BoundaryCount, ClassCounts, MethodCount, RootCount, SpeedCounts, SweepCount, speed_counts};
pub use start_sensitivity::{Early, StartGroup, StartRun, start_sensitivity};
pub use steady_sliding::{SteadyRun, steady_sliding};
pub use summary::{RowPlaces, Summary, SummaryError, SummaryRow};
pub use sweep::{SweepOutcome, SweepRow, sweep_effect_ratio};
pub use sweep_points::{PointSource, Varying};
pub use swept::{Swept, read_swept};
pub use timings::{
    Aim, Bound, CostRow, CostSeries, CoverageRow, Form, Law, MachineRow, PeerGroup, PeerRow, Reached,
    Timings, aims, cost_series, cycle_groups, micro, read_cost, read_coverage, read_machine, read_peers,
    work_groups,
};
pub use tolerance::{ToleranceOutcome, ToleranceRow, tolerance_limits};
pub use trajectories::{Course, DRAWING_TOLERANCE, Moment, TrajectoryRun, trajectories};
pub use work_precision::{
    MeasuredReturn, NamedMethod, WorkCase, WorkPoint, reference_return, return_methods, return_of,
    work_precision,
};
pub use zones::{ThresholdShare, ZonesOutcome, compare_zones};
