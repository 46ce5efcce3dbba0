//! The scene file: its head, its sections, and what they need of each other.

use crate::experiments::Scene;
use crate::experiments::experiment::{Experiment, Requirement};
use crate::scene::document::read_document;
use crate::scene::quantity::read_parameters;
use crate::scene::section::Section;
use crate::scene::sections::{NAME_RULE, safe_name};
use crate::scene::{AllowedRange, Fault, Faults, Limits, ParametersSection, Problem, same_name};
use crate::sweep::SweepSection;
use slipmode_core::number::Rational;
use slipmode_core::stability::InertialThreshold;

/// What a scene states besides its experiments; each value is absent, faulty, or sound.
pub(super) struct Head {
    pub name: Option<String>,
    pub title: Option<String>,
    pub parameters: Option<Option<ParametersSection>>,
    pub inertial_threshold: Option<Option<Rational>>,
    pub sweep: Option<Option<SweepSection>>,
}

impl Scene {
    /// Reads a scene from the bytes of its file; `file` is the name that messages use.
    ///
    /// # Errors
    /// All the faults of the file at once.
    pub fn parse(file: &str, bytes: &[u8], limits: &Limits) -> Result<Self, Faults> {
        read_document(file, bytes, |top, faults| Self::read(Head::read(top, faults), top, limits, faults))
    }

    /// The threshold between inertial and non-inertial that the scene chose, or the default.
    #[must_use]
    pub fn threshold(&self) -> InertialThreshold {
        self.inertial_threshold.as_ref().and_then(InertialThreshold::from_ratio).unwrap_or_default()
    }
}

impl Head {
    fn read(top: &mut Section<'_>, faults: &mut Faults) -> Self {
        let name = top.required("name", NAME_RULE, faults).and_then(|entry| safe_name(&entry, faults));
        let title = top.required("title", "a text", faults).and_then(|entry| entry.text(faults));
        let parameters = top.optional("parameters").map(|entry| {
            let mut section = entry.section(faults)?;
            let parameters = read_parameters(&mut section, faults);
            section.finish(faults);
            parameters
        });
        let inertial_threshold = top.optional("inertial_threshold").map(|entry| {
            let mut section = entry.section(faults)?;
            let range = AllowedRange::OPEN_UNIT;
            let ratio = section
                .required("frequency_ratio", &range.text(), faults)
                .and_then(|entry| entry.decimal(range, faults));
            section.finish(faults);
            ratio
        });
        let read = parameters.as_ref().map(Option::as_ref);
        let sweep = top.optional("sweep").map(|entry| SweepSection::read(&entry, read, faults));
        Self { name, title, parameters, inertial_threshold, sweep }
    }
}

/// Reads the section of an experiment, and checks that the scene states what the section needs.
pub(super) fn read_experiment<E: Experiment>(
    head: &Head,
    key: &'static str,
    top: &mut Section<'_>,
    limits: &Limits,
    faults: &mut Faults,
) -> Option<Option<E>> {
    let entry = top.optional(key)?;
    match (E::REQUIREMENT, &head.parameters) {
        (Requirement::Nothing, _) => {}
        (_, None) => faults.push(entry.fault(Problem::Needs("a [parameters] section".into()))),
        (Requirement::CriticalNormalStress, Some(Some(parameters)))
            if !parameters.slider.has_transition() =>
        {
            faults.push(entry.fault(Problem::NoCriticalNormalStress));
        }
        (Requirement::Parameters | Requirement::CriticalNormalStress, Some(_)) => {}
    }
    Some(E::read(&entry, limits, faults))
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
