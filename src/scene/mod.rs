//! Scenes, reports and claims as their files state them: read from text, validated, exact.
//!
//! Every reader takes the bytes of a file and its name, opens nothing, and returns either a valid value or
//! **all** the faults at once, each with file, line, key, value and allowed range.
//! Decimals are taken from their text ([`slipmode_core::number::parse_decimal`]); no number passes through binary.

mod axis;
mod claim_list;
mod csv_problem;
mod document;
mod equations_file;
mod fault;
mod file_text;
mod name;
mod near_transition;
mod numerical_error;
mod onset;
mod operating_points;
mod part;
mod quantity;
mod range;
mod report_plan;
mod schema;
mod section;
mod sections;
mod simulations;
mod speed;
mod sweep;
mod swept;
mod trajectories;

pub use axis::{Limits, LogAxis, LogCoordinates};
pub use claim_list::{ClaimEntry, ExpectedVerdict, read_claims};
pub use csv_problem::CsvProblem;
pub use equations_file::read_equations;
pub use fault::{Fault, Faults, Problem};
pub use file_text::{MAX_FILE_BYTES, file_text, is_forbidden};
pub use name::{NameError, check_name, nearest, same_name};
pub use near_transition::NearTransition;
pub use numerical_error::{ErrorBoundSection, OriginalSchemeSection, Place, WorkPrecisionSection};
pub use onset::OnsetSection;
pub use operating_points::{LinearRegimeSection, StartSensitivitySection};
pub use part::Part;
pub use quantity::{Quantity, SceneParameters};
pub use range::{AllowedRange, parse_whole};
pub use report_plan::{Chapter, ReportPlan, check_distinct_scene_names};
pub use schema::Scene;
pub use sections::{
    BoundarySection, EffectRatioSweep, FrequencySection, HardCases, Rectangle, ToleranceSection,
};
pub use simulations::SimulationsSection;
pub use speed::{SpeedCountsSection, TimingsSection};
pub use sweep::{
    ColumnBins, ColumnStatistics, Coordinate, MOST_SUMMARY_CELLS, MOST_SWEEP_POINTS, Spacing, Span,
    Statistic, SummarySection, SweepPoints, SweepSection, SweepWork,
};
pub use swept::{SweptEntry, SweptSection};
pub use trajectories::{TrajectoriesSection, TrajectoryPoint};
