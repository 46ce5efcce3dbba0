//! The scene file: its head, its sections, and what they need of each other.

use crate::experiments::Scene;
use crate::experiments::experiment::{Experiment, Requirement};
use crate::scene::document::read_document;
use crate::scene::quantity::read_parameters;
use crate::scene::section::Section;
use crate::scene::sections::NAME_RULE;
use crate::scene::{AllowedRange, Fault, Faults, Limits, ParametersSection, Problem, same_name};
use crate::sweep::SweepSection;
use slipmode_core::stability::InertialThreshold;

impl Scene {
    /// Reads a scene from the bytes of its file; `file` is the name that messages use.
    ///
    /// # Errors
    /// All the faults of the file at once.
    pub fn parse(file: &str, bytes: &[u8], limits: &Limits) -> Result<Self, Faults> {
        read_document(file, bytes, *limits, |top| Some(Self::head(top).with_experiments(top)))
    }

    /// The threshold between inertial and non-inertial that the scene chose, or the default.
    pub(crate) fn threshold(&self) -> InertialThreshold {
        self.inertial_threshold.as_ref().and_then(InertialThreshold::from_ratio).unwrap_or_default()
    }

    /// What stands before the experiments' sections.
    fn head(top: &mut Section<'_>) -> Self {
        let name = top.name("name", NAME_RULE);
        let title = top.text("title", "a text");
        let parameters = top.optionally("parameters", |entry| entry.table(read_parameters)?);
        let ratio = |section: &mut Section<'_>| section.decimal("frequency_ratio", AllowedRange::OPEN_UNIT);
        let inertial_threshold = top.optionally("inertial_threshold", |entry| entry.table(ratio));
        let head = Self { name, title, parameters, inertial_threshold, ..Self::default() };
        let known = head.known_parameters(top);
        let sweep = top.optionally("sweep", |entry| SweepSection::read(entry, known));
        Self { sweep, ..head }
    }

    /// What `[parameters]` states; `None` where it is faulty.
    pub(super) fn known_parameters(&self, top: &mut Section<'_>) -> Option<Option<&ParametersSection>> {
        let is_faulty = top.optional("parameters").is_some() && self.parameters.is_none();
        (!is_faulty).then_some(self.parameters.as_ref())
    }
}

/// Reads the section of an experiment, and checks that the scene states what the section needs.
pub(super) fn read_experiment<E: Experiment>(
    parameters: Option<Option<&ParametersSection>>,
    key: &'static str,
    top: &mut Section<'_>,
) -> Option<E> {
    top.optionally(key, |entry| {
        let problem = match (E::REQUIREMENT, parameters) {
            (Requirement::Nothing, _) => None,
            (_, Some(None)) => Some(Problem::Needs("a [parameters] section".into())),
            (Requirement::CriticalNormalStress, Some(Some(parameters))) => {
                (!parameters.slider.has_transition()).then_some(Problem::NoCriticalNormalStress)
            }
            (Requirement::OperatingPoint, Some(Some(parameters))) => {
                let needs =
                    || Problem::Needs("normal_stress_pa and loading_velocity_m_per_s in [parameters]".into());
                parameters.point().is_none().then(needs)
            }
            (_, _) => None,
        };
        problem.map(|problem| entry.refuse::<()>(problem));
        entry.table(E::read)
    })
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
            let of = format!("the name of the scene in {first_file}");
            let problem = Problem::Duplicate { of, folded: first.name != scene.name };
            faults.push(Fault { value: Some(scene.name.clone()), ..Fault::of(file, "name", problem) });
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

#[cfg(test)]
mod tests;
