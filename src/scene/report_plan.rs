//! `report.toml`: the scenes and chapters of a report.

use crate::scene::document::read_document;
use crate::scene::section::{Entry, Section};
use crate::scene::sections::safe_name;
use crate::scene::{Fault, Faults, Problem, Scene, same_name};

/// A report: which scenes it computes, and in which chapters it tells of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportPlan {
    /// The name, safe as a file name; the output folder has it.
    pub name: String,
    /// The title, for people.
    pub title: String,
    /// The names of the scenes, each in `scenes/NAME.toml`.
    pub scenes: Vec<String>,
    /// The chapters, in order.
    pub chapters: Vec<Chapter>,
}

/// A chapter: prose, then figures and tables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chapter {
    /// The title, for people.
    pub title: String,
    /// The Markdown file in `prose/`; absent for a chapter without narrative.
    pub prose: Option<String>,
    /// The ids of its figures, in order.
    pub figures: Vec<String>,
    /// The ids of its tables, in order.
    pub tables: Vec<String>,
}

impl ReportPlan {
    /// Reads `report.toml` from its bytes.
    ///
    /// # Errors
    /// All the faults at once: among them scenes listed twice, also when only case differs.
    pub fn parse(file: &str, bytes: &[u8]) -> Result<Self, Faults> {
        read_document(file, bytes, |top, faults| {
            let name = top
                .required("name", "A-Z a-z 0-9 . _ -, at most 100 characters", faults)
                .and_then(|entry| safe_name(&entry, faults));
            let title = top.required("title", "a text", faults).and_then(|entry| entry.text(faults));
            let scenes = top
                .required("scenes", "a list of scene names", faults)
                .and_then(|entry| distinct_names(&entry, faults));
            let chapters = top
                .required("chapter", "[[chapter]] sections", faults)
                .and_then(|entry| entry.list(faults, Chapter::read));
            Some(Self { name: name?, title: title?, scenes: scenes?, chapters: chapters? })
        })
    }
}

impl Chapter {
    fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let title = section.required("title", "a text", faults).and_then(|entry| entry.text(faults));
        let prose = match section.optional("prose") {
            Some(entry) => safe_name(&entry, faults).map(Some),
            None => Some(None),
        };
        let figures = names(&mut section, "figures", faults);
        let tables = names(&mut section, "tables", faults);
        section.finish(faults);
        Some(Self { title: title?, prose: prose?, figures: figures?, tables: tables? })
    }
}

/// An optional list of ids.
fn names(section: &mut Section<'_>, key: &'static str, faults: &mut Faults) -> Option<Vec<String>> {
    match section.optional(key) {
        Some(entry) => entry.list(faults, safe_name),
        None => Some(Vec::new()),
    }
}

/// A list of names that differ in more than case.
fn distinct_names(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<String>> {
    let mut names: Vec<String> = Vec::new();
    entry.list(faults, |member, faults| {
        let name = safe_name(member, faults)?;
        if let Some(first) = names.iter().find(|first| same_name(first, &name)) {
            let folded = *first != name;
            faults.push(member.fault(Problem::Duplicate { of: format!("an earlier `{first}`"), folded }));
            return None;
        }
        names.push(name.clone());
        Some(name)
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
