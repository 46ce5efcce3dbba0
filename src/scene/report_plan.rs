//! `report.toml`: the scenes and chapters of a report.

use crate::scene::document::read_document;
use crate::scene::paper::Paper;
use crate::scene::part::Part;
use crate::scene::question::Question;
use crate::scene::section::{Entry, ReadSection, Section, keys};
use crate::scene::sections::NAME_RULE;
use crate::scene::{Faults, Limits, Problem, check_name, same_name};

keys! {
    /// A report: the scenes that it computes and the chapters that describe them.
    pub struct ReportPlan {
        /// The name, safe as a file name; the output folder has it.
        pub name: String = |section, key| section.name(key, NAME_RULE),
        /// The folder in the commands that the page prints, the same wherever a copy lies; the name by default.
        pub folder: String = |section, key| section.optionally(key, read_folder).unwrap_or_default(),
        /// The title, for people.
        pub title: String = |section, key| section.text(key, "a text"),
        /// Who made the report, for those who cite it.
        pub authors: Vec<String> = |section, key| {
            section.optionally(key, |entry| entry.list(Entry::text)).unwrap_or_default()
        },
        /// The day of this edition, such as `2026-11-29`.
        pub date: Option<String> = |section, key| section.optionally(key, read_date),
        /// Whether the published copy contains the page, besides ledger, Markdown, tables and figures; true by default.
        pub publish_page: bool = |section, key| section.optionally(key, Entry::truth).unwrap_or(true),
        /// What the first sentence of its answer is about: claims by default.
        pub question: Question = |section, key| {
            section.optionally(key, |entry| entry.word(&Question::ALL, Question::as_str)).unwrap_or_default()
        },
        /// The names of the scenes, each in `scenes/NAME.toml`; none for a report about equations alone.
        pub scenes: Vec<String> = names,
        /// The names of the files of proofs, each in `proofs/NAME.toml`.
        pub proofs: Vec<String> = names,
        /// The names of the charts of equations, each in `charts/NAME.toml`.
        pub charts: Vec<String> = names,
        /// The folder of tables and charts that were measured apart, if any.
        pub measured: Option<String> = |section, key| {
            section.optionally(key, |entry| entry.table(|section| section.name("folder", NAME_RULE)))
        },
        /// The paper that the report accompanies.
        pub paper: Paper = |section, key| {
            section.optionally(key, |entry| entry.table(Paper::read)).unwrap_or_default()
        },
        /// The chapters, in order.
        pub chapters: Vec<Chapter> = |section, _| {
            section.read("chapter", "[[chapter]] sections", read_chapters)
        },
    }
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
        let mut plan = read_document(file, bytes, Limits::default(), |top| Some(Self::read(top)))?;
        if plan.folder.is_empty() {
            plan.folder.clone_from(&plan.name);
        }
        Ok(plan)
    }
}

/// A list of names, each once.
fn names(section: &mut Section<'_>, key: &'static str) -> Vec<String> {
    let mut names = Vec::new();
    let names = section.optionally(key, |entry| entry.list(|member| distinct_name(member, &mut names)));
    names.unwrap_or_default()
}

/// The path of a folder, of names between `/`.
fn read_folder(entry: &Entry<'_>) -> Option<String> {
    let folder = entry.text()?;
    let is_path = folder.split('/').all(|name| check_name(name).is_ok());
    if is_path { Some(folder) } else { entry.needs("a folder such as \"reports/lab\"") }
}

/// A day of the calendar.
fn read_date(entry: &Entry<'_>) -> Option<String> {
    let date = entry.text()?;
    let read = date.parse::<toml::value::Datetime>();
    let is_day = read.is_ok_and(|read| read.date.is_some() && read.time.is_none() && read.offset.is_none());
    if is_day { Some(date) } else { entry.needs("a day such as \"2026-11-29\"") }
}

/// Why the first chapter has no part.
const INTRODUCTION_STANDS_APART: &str =
    "no part on the first chapter: it is the introduction, which precedes all parts";

fn read_chapters(entry: &Entry<'_>) -> Option<Vec<Chapter>> {
    let mut ids = Vec::new();
    let mut parts = Vec::new();
    entry.list(|member| {
        member.table(|section| {
            let id = section.read("id", NAME_RULE, |entry| distinct_name(entry, &mut ids));
            let title = section.text("title", "a text");
            let prose = section.name("prose", "a file of prose/");
            let part = section.optionally("part", |entry| match parts.is_empty() {
                true => entry.needs(INTRODUCTION_STANDS_APART),
                false => Part::read(entry, &parts),
            });
            parts.push(part);
            Chapter { id, title, prose, part }
        })
    })
}

/// A name that differs from those before it in more than case.
pub(crate) fn distinct_name(entry: &Entry<'_>, earlier: &mut Vec<String>) -> Option<String> {
    distinct(entry, entry.name()?, "", earlier)
}

/// A name that is none of the earlier ones, in any case, to which it is added; `what` they name, with a space.
pub(super) fn distinct(
    entry: &Entry<'_>,
    name: String,
    what: &str,
    earlier: &mut Vec<String>,
) -> Option<String> {
    if let Some(first) = earlier.iter().find(|first| same_name(first, &name)) {
        let folded = *first != name;
        return entry.refuse(Problem::Duplicate { of: format!("an earlier {what}`{first}`"), folded });
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
    fn a_report_states_its_folder_by_its_name_or_as_it_says() {
        let folder = |line: &str| {
            let text = format!("name = \"r\"\ntitle = \"R\"\n{line}\n{CHAPTER}");
            ReportPlan::parse("report.toml", text.as_bytes()).map(|plan| plan.folder)
        };
        assert_eq!(folder("").unwrap(), "r");
        assert_eq!(folder("folder = \"reports/lab\"").unwrap(), "reports/lab");
        for path in ["../lab", "/lab", "a b", "lab/"] {
            let faults = folder(&format!("folder = \"{path}\"")).unwrap_err();
            assert!(faults[0].to_string().contains("a folder such as \"reports/lab\""), "{faults:?}");
        }
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
    fn a_report_can_name_the_authors_of_its_paper() {
        let plan = |paper: &str| {
            let text =
                format!("name = \"r\"\ntitle = \"R\"\nscenes = [\"one\"]\n{CHAPTER}[paper]\n{paper}\n");
            ReportPlan::parse("report.toml", text.as_bytes())
        };
        let paper = plan(
            "reference = \"submitted\"\n[[paper.author]]\nname = \"A\"\norcid = \"0000-0002-1825-0097\"",
        );
        let paper = paper.unwrap().paper;
        assert_eq!((paper.title, paper.reference.as_deref()), (None, Some("submitted")));
        assert_eq!(paper.authors[0].orcid.as_deref(), Some("0000-0002-1825-0097"));
        for (text, named) in [
            ("", "paper.author: missing"),
            ("author = []", "paper.author"),
            ("[[paper.author]]\norcid = \"0000-0002-1825-0097\"", "paper.author[1].name: missing"),
            ("[[paper.author]]\nname = \"A\"\norcid = \"0000-0002-1825-0098\"", "with its check digit"),
            ("[[paper.author]]\nname = \"A\"\nemail = \"x\"", "unknown key"),
        ] {
            let fault = plan(text).unwrap_err()[0].to_string();
            assert!(fault.contains(named), "{fault}");
        }
    }

    #[test]
    fn an_edition_has_authors_and_a_day_of_the_calendar() {
        let plan = |lines: &str| {
            let text = format!("name = \"r\"\ntitle = \"R\"\n{lines}\nscenes = [\"one\"]\n{CHAPTER}");
            ReportPlan::parse("report.toml", text.as_bytes())
        };
        let found = plan("authors = [\"A\", \"B\"]\ndate = \"2024-02-29\"").unwrap();
        assert_eq!(
            (found.authors, found.date.as_deref()),
            (vec!["A".into(), "B".into()], Some("2024-02-29"))
        );
        for date in ["2023-02-29", "2026-11", "2026-11-29T10:00:00Z", "10:00:00", "today"] {
            let fault = plan(&format!("date = \"{date}\"")).unwrap_err()[0].to_string();
            assert!(fault.contains("report.toml:3: date") && fault.contains("a day such as"), "{fault}");
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
    fn a_report_can_begin_with_the_formulas() {
        let plan = |value: &str| {
            let text = format!("name = \"r\"\ntitle = \"R\"\n{value}scenes = [\"one\"]\n{CHAPTER}");
            ReportPlan::parse("report.toml", text.as_bytes())
        };
        assert_eq!(plan("").unwrap().question, Question::Claims);
        assert_eq!(plan("question = \"formulas\"\n").unwrap().question, Question::Formulas);
        let fault = plan("question = \"formula\"\n").unwrap_err()[0].to_string();
        assert!(fault.contains("report.toml:3: question") && fault.contains("`formulas`"), "{fault}");
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
