//! The scene file: sections, their order of reading, and what they need of each other.

use crate::experiments::linear_regime::{LinearRegimeSection, StartSensitivitySection};
use crate::experiments::near_transition::NearTransition;
use crate::experiments::onset::OnsetSection;
use crate::experiments::original_scheme::{ErrorBoundSection, OriginalSchemeSection, WorkPrecisionSection};
use crate::experiments::simulations::SimulationsSection;
use crate::experiments::speed_counts::{SpeedCountsSection, TimingsSection};
use crate::experiments::swept::SweptSection;
use crate::experiments::trajectories::TrajectoriesSection;
use crate::scene::document::read_document;
use crate::scene::quantity::read_parameters;
use crate::scene::section::{Section, given};
use crate::scene::sections::{NAME_RULE, safe_name};
use crate::scene::{
    AllowedRange, BoundarySection, EffectRatioSweep, Fault, Faults, FrequencySection, HardCases, Limits,
    ParametersSection, Problem, Rectangle, ToleranceSection, same_name,
};
use crate::sweep::SweepSection;
use slipmode_core::number::Rational;

/// What a user requests: valid and exact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Scene {
    /// The name, safe as a file name.
    pub name: String,
    /// The title, for people.
    pub title: String,
    /// The slider; absent in scenes that need none.
    pub parameters: Option<ParametersSection>,
    /// ω/ω_n above which an oscillation is called inertial; absent for the default √(1/2), exactly.
    pub inertial_threshold: Option<Rational>,
    /// `[map]`: max Im(s) and the spectral class on a (V, σ) grid.
    pub map: Option<Rectangle>,
    /// `[boundary]`.
    pub boundary: Option<BoundarySection>,
    /// `[frequency]`.
    pub frequency: Option<FrequencySection>,
    /// `[effect_ratio_sweep]`.
    pub effect_ratio_sweep: Option<EffectRatioSweep>,
    /// `[tolerance]`.
    pub tolerance: Option<ToleranceSection>,
    /// `[zones]`: slip modes on a (V, σ) grid.
    pub zones: Option<Rectangle>,
    /// `[hard_cases]`.
    pub hard_cases: Option<HardCases>,
    /// `[simulations]`: the nonlinear slider on a (V, σ) grid.
    pub simulations: Option<SimulationsSection>,
    /// `[trajectories]`: the nonlinear slider's course at named points.
    pub trajectories: Option<TrajectoriesSection>,
    /// `[linear_regime]`: small disturbances along the eigenvectors.
    pub linear_regime: Option<LinearRegimeSection>,
    /// `[start_sensitivity]`: every completion of the start V_l/10.
    pub start_sensitivity: Option<StartSensitivitySection>,
    /// `[onset]`: where oscillation begins along lines of constant normal stress.
    pub onset: Option<OnsetSection>,
    /// `[near_transition]`: the nonlinear slider close to K = K_c.
    pub near_transition: Option<NearTransition>,
    /// `[original_scheme]`: the fixed-step scheme of the original simulations.
    pub original_scheme: Option<OriginalSchemeSection>,
    /// `[work_precision]`: work against error of the integrators.
    pub work_precision: Option<WorkPrecisionSection>,
    /// `[error_bound]`: stated errors against true ones.
    pub error_bound: Option<ErrorBoundSection>,
    /// `[speed_counts]`: work against error, by counts.
    pub speed_counts: Option<SpeedCountsSection>,
    /// `[timings]`: files with times that other commands measured.
    pub timings: Option<TimingsSection>,
    /// `[sweep]`: points for many machines, and what is computed at each.
    pub sweep: Option<SweepSection>,
    /// `[swept]`: sweeps that ran elsewhere.
    pub swept: Option<SweptSection>,
}

impl Scene {
    /// Reads a scene from the bytes of its file; `file` is the name that messages use.
    ///
    /// # Errors
    /// All the faults of the file at once.
    pub fn parse(file: &str, bytes: &[u8], limits: &Limits) -> Result<Self, Faults> {
        read_document(file, bytes, |section, faults| read_scene(section, limits, faults))
    }
}

fn read_scene(top: &mut Section<'_>, limits: &Limits, faults: &mut Faults) -> Option<Scene> {
    let name = top.required("name", NAME_RULE, faults).and_then(|entry| safe_name(&entry, faults));
    let title = top.required("title", "a text", faults).and_then(|entry| entry.text(faults));
    let parameters = top.optional("parameters").map(|entry| {
        let mut section = entry.section(faults)?;
        let parameters = read_parameters(&mut section, faults);
        section.finish(faults);
        parameters
    });
    let threshold = top.optional("inertial_threshold").map(|entry| {
        let mut section = entry.section(faults)?;
        let range = AllowedRange::OPEN_UNIT;
        let ratio = section
            .required("frequency_ratio", &range.text(), faults)
            .and_then(|entry| entry.decimal(range, faults));
        section.finish(faults);
        ratio
    });
    let map = top.optional("map").map(|entry| Rectangle::read(&entry, limits, faults));
    let boundary = top.optional("boundary").map(|entry| BoundarySection::read(&entry, limits, faults));
    let frequency = top.optional("frequency").map(|entry| FrequencySection::read(&entry, limits, faults));
    let sweep =
        top.optional("effect_ratio_sweep").map(|entry| EffectRatioSweep::read(&entry, limits, faults));
    let tolerance = top.optional("tolerance").map(|entry| ToleranceSection::read(&entry, faults));
    let zones = top.optional("zones").map(|entry| Rectangle::read(&entry, limits, faults));
    let hard_cases = top.optional("hard_cases").map(|entry| HardCases::read(&entry, faults));
    let simulations =
        top.optional("simulations").map(|entry| SimulationsSection::read(&entry, limits, faults));
    let trajectories =
        top.optional("trajectories").map(|entry| TrajectoriesSection::read(&entry, limits, faults));
    let linear_regime =
        top.optional("linear_regime").map(|entry| LinearRegimeSection::read(&entry, limits, faults));
    let start_sensitivity =
        top.optional("start_sensitivity").map(|entry| StartSensitivitySection::read(&entry, limits, faults));
    let onset = top.optional("onset").map(|entry| OnsetSection::read(&entry, limits, faults));
    let near = top.optional("near_transition").map(|entry| NearTransition::read(&entry, limits, faults));
    check_needs(top, parameters.as_ref(), faults);
    let original =
        top.optional("original_scheme").map(|entry| OriginalSchemeSection::read(&entry, limits, faults));
    let work = top.optional("work_precision").map(|entry| WorkPrecisionSection::read(&entry, faults));
    let bound = top.optional("error_bound").map(|entry| ErrorBoundSection::read(&entry, limits, faults));
    let counts = top.optional("speed_counts").map(|entry| SpeedCountsSection::read(&entry, limits, faults));
    let timings = top.optional("timings").map(|entry| TimingsSection::read(&entry, faults));
    let read = parameters.as_ref().map(Option::as_ref);
    let shared = top.optional("sweep").map(|entry| SweepSection::read(&entry, read, faults));
    let swept = top.optional("swept").map(|entry| SweptSection::read(&entry, faults));
    Some(Scene {
        name: name?,
        title: title?,
        parameters: given(parameters)?,
        inertial_threshold: given(threshold)?,
        map: given(map)?,
        boundary: given(boundary)?,
        frequency: given(frequency)?,
        effect_ratio_sweep: given(sweep)?,
        tolerance: given(tolerance)?,
        zones: given(zones)?,
        hard_cases: given(hard_cases)?,
        simulations: given(simulations)?,
        trajectories: given(trajectories)?,
        linear_regime: given(linear_regime)?,
        start_sensitivity: given(start_sensitivity)?,
        onset: given(onset)?,
        near_transition: given(near)?,
        original_scheme: given(original)?,
        work_precision: given(work)?,
        error_bound: given(bound)?,
        speed_counts: given(counts)?,
        timings: given(timings)?,
        sweep: given(shared)?,
        swept: given(swept)?,
    })
}

/// The sections that only mean something for a slider.
const NEED_PARAMETERS: &[&str] = &[
    "map",
    "boundary",
    "frequency",
    "tolerance",
    "zones",
    "simulations",
    "trajectories",
    "linear_regime",
    "start_sensitivity",
    "onset",
    "near_transition",
    "original_scheme",
    "work_precision",
    "speed_counts",
];

/// The sections that only mean something for a slider with a critical normal stress.
const NEED_CRITICAL_STRESS: &[&str] = &["frequency", "near_transition"];

fn check_needs(top: &mut Section<'_>, parameters: Option<&Option<ParametersSection>>, faults: &mut Faults) {
    if parameters.is_none() {
        for key in NEED_PARAMETERS {
            if let Some(entry) = top.optional(key) {
                faults.push(entry.fault(Problem::Needs("a [parameters] section".into())));
            }
        }
    }
    if let Some(Some(parameters)) = parameters
        && !parameters.slider.has_transition()
    {
        for key in NEED_CRITICAL_STRESS {
            if top.optional(key).is_some() {
                faults.push(top.fault(key, Problem::NoCriticalNormalStress));
            }
        }
    }
}

/// Refuses scenes of different files with one name: their outputs would overwrite each other.
///
/// # Errors
/// One fault for each scene whose name an earlier file has, also when only case differs.
pub fn check_distinct_scene_names(scenes: &[(String, Scene)]) -> Result<(), Faults> {
    let mut faults = Faults::new();
    for (index, (file, scene)) in scenes.iter().enumerate() {
        let first = scenes[..index].iter().find(|(_, first)| same_name(&first.name, &scene.name));
        if let Some((first_file, first)) = first {
            faults.push(Fault {
                file: file.clone(),
                line: None,
                key: "name".into(),
                value: Some(scene.name.clone()),
                problem: Problem::Duplicate {
                    of: format!("the name of the scene in {first_file}"),
                    folded: first.name != scene.name,
                },
            });
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

#[cfg(test)]
mod tests;
