//! The page and the Markdown report as a whole, on the sample view.

mod hostile;
pub(in crate::report) mod sample;

use super::*;
use packed::tests::pieces_of;
use sample::view;

fn folder() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("target/sample-report")
}

#[test]
fn the_sample_is_written_for_looking_at() {
    let (view, folder) = (view(), folder());
    for part in ["figures", "tables"] {
        std::fs::create_dir_all(folder.join(part)).unwrap();
    }
    std::fs::write(folder.join("index.html"), render_html(&view).unwrap()).unwrap();
    std::fs::write(folder.join("report.md"), render_markdown(&view).unwrap()).unwrap();
    for figure in &view.figures {
        std::fs::write(folder.join(format!("figures/{}.svg", figure.id)), &figure.svg).unwrap();
    }
    for table in &view.tables {
        std::fs::write(folder.join(format!("tables/{}.csv", table.id)), table.to_csv()).unwrap();
    }
}

#[test]
fn the_page_is_small_and_asks_for_nothing() {
    let page = render_html(&view()).unwrap();
    assert!(page.len() < PAGE_BUDGET_BYTES, "{}", page.len());
    assert_eq!(page.matches("<script").count(), 1);
    assert!(!page.contains(" style=\"") && !page.contains("@import"));
    let loads = [" src=", "<link", "<iframe", "<object", "<img", "url(http"];
    assert!(loads.iter().all(|load| !page.contains(load)));
}

#[test]
fn ids_on_the_page_are_unique_and_every_deep_link_arrives() {
    let page = render_html(&view()).unwrap();
    let quoted = |start: &str| -> Vec<String> {
        page.split(start).skip(1).map(|rest| rest.split('"').next().unwrap().to_owned()).collect()
    };
    let ids = quoted(" id=\"");
    let unique: std::collections::BTreeSet<&String> = ids.iter().collect();
    assert_eq!(ids.len(), unique.len());
    for link in quoted("href=\"#") {
        assert!(ids.contains(&link), "#{link}");
    }
}

#[test]
fn the_answer_and_all_verdicts_with_their_words_stand_before_everything_else() {
    let (page, text) = (render_html(&view()).unwrap(), render_markdown(&view()).unwrap());
    let words = "is the cubic of eq. 8";
    for (report, marks) in [
        (&page, ["One claim is wrong as stated:", words, "id=\"ledger\"", "id=\"theory\"", "id=\"inputs\""]),
        (&text, ["One claim is wrong as stated:", words, "## Ledger", "### The linear theory", "### Inputs"]),
    ] {
        let places = marks.map(|mark| report.find(mark).expect(mark));
        assert!(places.is_sorted(), "{places:?}");
    }
    // The claim of a sentence that lists its claims stands below it with its words.
    let listed = page.split("One claim is wrong as stated:").nth(1).unwrap();
    assert!(listed.find("The system is unstable whenever").unwrap() < listed.find("</ul>").unwrap());
}

#[test]
fn the_acceptance_criterion_stands_before_the_result() {
    let pieces = pieces_of(&render_html(&view()).unwrap());
    let claim = pieces.iter().find(|piece| piece.contains("id=\"claim-B5\"")).unwrap();
    assert!(claim.find("Holds if").unwrap() < claim.find("Result").unwrap());
}

#[test]
fn the_environment_can_be_taken_out_of_both_reports() {
    let (with, mut bare) = (view(), view());
    bare.environment.clear();
    for render in [render_html, render_markdown] {
        let (full, without) = (render(&with).unwrap(), render(&bare).unwrap());
        assert!(full.contains("4.2.2") && !without_environment(&full).contains("4.2.2"));
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&without_environment(&full)), words(&without));
    }
}

#[test]
fn all_faults_of_a_view_are_told_at_once() {
    let mut view = view();
    view.chapters[0].text_markdown =
        "[[figure:nowhere]]\n[[figur:x]]\n[[table:corners]]\n[[table:corners]]\n".into();
    view.figures[0].id = "../evil".into();
    view.figures[1].id = "FIG-7A".into();
    view.answer[1].claims = vec!["Z9".into()];
    let Err(ReportError::Faults(faults)) = render_html(&view) else { panic!("accepted") };
    for part in ["no figure `nowhere`", "[[figur:x]]", "second time", "../evil", "occurs twice", "`Z9`"] {
        assert!(faults.iter().any(|fault| fault.contains(part)), "{part}: {faults:?}");
    }
    assert!(matches!(render_markdown(&view), Err(ReportError::Faults(_))));
}

#[test]
fn a_dead_link_and_a_broken_formula_name_their_place() {
    let mut view = view();
    view.chapters[0].text_markdown += "\nSee [x](#nowhere) and $\\nonsense{1}$.\n";
    let error = render_html(&view).unwrap_err().to_string();
    assert!(error.contains("theory: link `#nowhere` leads nowhere"), "{error}");
    assert!(error.contains("theory: formula"), "{error}");
}
