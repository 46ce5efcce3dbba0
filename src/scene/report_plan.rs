//! `report.toml`: the scenes and chapters of a report.

use crate::scene::document::read_document;
use crate::scene::part::Part;
use crate::scene::section::{Entry, given};
use crate::scene::sections::{NAME_RULE, safe_name};
use crate::scene::{Faults, Problem, same_name};

/// A report: the scenes that it computes and the chapters that describe them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportPlan {
    /// The name, safe as a file name; the output folder has it.
    pub name: String,
    /// The title, for people.
    pub title: String,
    /// Whether the published copy contains the page, besides ledger, Markdown, tables and figures; true by default.
    pub publish_page: bool,
    /// The names of the scenes, each in `scenes/NAME.toml`.
    pub scenes: Vec<String>,
    /// The folder of tables and charts that were measured apart, if any.
    pub measured: Option<String>,
    /// The chapters, in order.
    pub chapters: Vec<Chapter>,
}

/// A chapter: prose that places figures, tables, equations and claims.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chapter {
    /// The deep link, safe as a file name and distinct among the chapters.
    pub id: String,
    /// The title, for people.
    pub title: String,
    /// The name of the Markdown file in `prose/`.
    pub prose: String,
    /// The part of the report that it belongs to, if any; the chapters of a part follow one another, and the first
    /// chapter, the introduction, has none.
    pub part: Option<Part>,
}

impl ReportPlan {
    /// Reads `report.toml` from its bytes.
    ///
    /// # Errors
    /// All the faults at once: among them scenes listed twice, also when only case differs.
    pub fn parse(file: &str, bytes: &[u8]) -> Result<Self, Faults> {
        read_document(file, bytes, |top, faults| {
            let name = top.required("name", NAME_RULE, faults).and_then(|entry| safe_name(&entry, faults));
            let title = top.required("title", "a text", faults).and_then(|entry| entry.text(faults));
            let publish_page = top.optional("publish_page").map_or(Some(true), |entry| entry.truth(faults));
            let scenes = top
                .required("scenes", "a list of scene names", faults)
                .and_then(|entry| read_scene_names(&entry, faults));
            let measured = top.optional("measured").map(|entry| read_measured(&entry, faults));
            let chapters = top
                .required("chapter", "[[chapter]] sections", faults)
                .and_then(|entry| read_chapters(&entry, faults));
            Some(Self {
                name: name?,
                title: title?,
                publish_page: publish_page?,
                scenes: scenes?,
                measured: given(measured)?,
                chapters: chapters?,
            })
        })
    }
}

fn read_scene_names(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<String>> {
    let mut names = Vec::new();
    entry.list(faults, |member, faults| distinct_name(member, &mut names, faults))
}

/// `[measured]`: the name of the folder.
fn read_measured(entry: &Entry<'_>, faults: &mut Faults) -> Option<String> {
    let mut section = entry.section(faults)?;
    let folder = section.required("folder", NAME_RULE, faults).and_then(|entry| safe_name(&entry, faults));
    section.finish(faults);
    folder
}

/// Why the first chapter has no part.
const INTRODUCTION_STANDS_APART: &str =
    "no part on the first chapter: it is the introduction, which precedes all parts";

fn read_chapters(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<Chapter>> {
    let mut ids = Vec::new();
    let mut parts = Vec::new();
    entry.list(faults, |member, faults| {
        let mut section = member.section(faults)?;
        let id = section
            .required("id", NAME_RULE, faults)
            .and_then(|entry| distinct_name(&entry, &mut ids, faults));
        let title = section.required("title", "a text", faults).and_then(|entry| entry.text(faults));
        let prose =
            section.required("prose", "a file of prose/", faults).and_then(|entry| safe_name(&entry, faults));
        let stated = section.optional("part");
        let part = stated.as_ref().and_then(|entry| {
            if parts.is_empty() {
                faults.push(entry.fault(Problem::Needs(INTRODUCTION_STANDS_APART.into())));
                return None;
            }
            Part::read(entry, &parts, faults)
        });
        parts.push(part);
        section.finish(faults);
        (stated.is_none() || part.is_some()).then_some(())?;
        Some(Chapter { id: id?, title: title?, prose: prose?, part })
    })
}

/// A name that differs from those before it in more than case.
pub(crate) fn distinct_name(
    entry: &Entry<'_>,
    earlier: &mut Vec<String>,
    faults: &mut Faults,
) -> Option<String> {
    let name = safe_name(entry, faults)?;
    if let Some(first) = earlier.iter().find(|first| same_name(first, &name)) {
        let folded = *first != name;
        faults.push(entry.fault(Problem::Duplicate { of: format!("an earlier `{first}`"), folded }));
        return None;
    }
    earlier.push(name.clone());
    Some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHAPTER: &str = "[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n";

    fn plan(scenes: &str) -> Result<ReportPlan, Faults> {
        let text = format!("name = \"r\"\ntitle = \"R\"\nscenes = {scenes}\n{CHAPTER}");
        ReportPlan::parse("report.toml", text.as_bytes())
    }

    #[test]
    fn a_report_lists_scenes_and_chapters() {
        let plan = plan("[\"one\", \"two\"]").unwrap();
        assert_eq!(plan.scenes, ["one", "two"]);
        assert_eq!(plan.chapters[0].prose, "c.md");
        assert!(plan.publish_page && plan.measured.is_none());
    }

    #[test]
    fn a_report_can_name_a_folder_of_measurements() {
        let plan = |value: &str| {
            let text =
                format!("name = \"r\"\ntitle = \"R\"\nscenes = [\"one\"]\n{CHAPTER}[measured]\n{value}\n");
            ReportPlan::parse("report.toml", text.as_bytes())
        };
        assert_eq!(plan("folder = \"timings\"").unwrap().measured.as_deref(), Some("timings"));
        for (value, named) in
            [("folder = \"../x\"", "measured.folder"), ("", "measured.folder"), ("file = 1", "measured.f")]
        {
            let fault = plan(value).unwrap_err()[0].to_string();
            assert!(fault.contains(named), "{fault}");
        }
    }

    #[test]
    fn the_page_is_published_unless_the_report_says_otherwise() {
        let plan = |value: &str| {
            let text =
                format!("name = \"r\"\ntitle = \"R\"\npublish_page = {value}\nscenes = [\"one\"]\n{CHAPTER}");
            ReportPlan::parse("report.toml", text.as_bytes())
        };
        assert!(plan("true").unwrap().publish_page);
        assert!(!plan("false").unwrap().publish_page);
        let fault = plan("\"no\"").unwrap_err()[0].to_string();
        assert!(fault.contains("report.toml:3: publish_page") && fault.contains("true or false"), "{fault}");
    }

    #[test]
    fn chapters_are_kept_apart_in_parts_and_all_faults_are_told() {
        let chapter = |id: &str, part: &str| CHAPTER.replace("\"c\"", &format!("{id:?}")) + part;
        let plan = |parts: [&str; 4]| {
            let chapters: String =
                ["c", "d", "e", "f"].into_iter().zip(parts).map(|(id, part)| chapter(id, part)).collect();
            let text = format!("name = \"r\"\ntitle = \"R\"\nscenes = [\"a\"]\n{chapters}");
            ReportPlan::parse("report.toml", text.as_bytes())
        };
        let (code, valid) = ("part = \"code-verification\"\n", "part = \"validation\"\n");
        let read: Vec<Option<Part>> =
            plan(["", code, code, valid]).unwrap().chapters.iter().map(|c| c.part).collect();
        let (code_part, valid_part) = (Some(Part::CodeVerification), Some(Part::Validation));
        assert_eq!(read, [None, code_part, code_part, valid_part]);
        let told =
            |parts| -> Vec<String> { plan(parts).unwrap_err().iter().map(ToString::to_string).collect() };
        let two = told(["", code, valid, code]);
        assert!(two.len() == 1 && two[0].contains("follow one another"), "{two:?}");
        let two = told([code, code, valid, "part = \"validatoin\"\n"]);
        assert_eq!(two.len(), 2, "{two:?}");
        assert!(
            two[0].contains("precedes all parts") && two[1].contains("did you mean `validation`"),
            "{two:?}"
        );
    }

    #[test]
    fn doubled_scenes_are_refused_also_when_only_case_differs() {
        for scenes in ["[\"one\", \"one\"]", "[\"one\", \"ONE\"]"] {
            let fault = &plan(scenes).unwrap_err()[0];
            assert!(fault.to_string().contains("the same as an earlier `one`"), "{fault}");
        }
    }
}
