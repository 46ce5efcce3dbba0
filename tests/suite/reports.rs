//! `report` and `verify`: a folder read whole, verdicts compared with the record, files against the published copy.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::harness::{Workplace, names_in};

const PLAN: &str = "name = \"small\"\ntitle = \"Small\"\nscenes = [\"a\"]\n\
    [[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n";
const CLAIMS: &str = "[[claim]]\nid = \"S1\"\nplace = \"eq 9\"\nwords = \"W\"\nexpected = \"holds\"\n";
const SCENE: &str = "name = \"a\"\ntitle = \"A\"\n";
const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

/// A small report that can be made in an instant.
fn small_report() -> Workplace {
    let place = Workplace::new();
    place.write("small/report.toml", PLAN);
    place.write("small/claims.toml", CLAIMS);
    place.write("small/equations.toml", EQUATIONS);
    place.write("small/scenes/a.toml", SCENE);
    place.write("small/prose/c.md", "Words.\n");
    place
}

/// Makes the report and publishes it.
fn published() -> Workplace {
    let place = small_report();
    place.run(["report", "small", "-o", "out"]).expect_success();
    copy(&place.path("out"), &place.path("small/published"));
    place
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for name in names_in(from) {
        let (from, to) = (from.join(&name), to.join(&name));
        if from.is_dir() {
            copy(&from, &to);
        } else if name != "environment.json" {
            fs::copy(from, to).unwrap();
        }
    }
}

#[test]
fn a_report_that_is_as_published_and_as_recorded_is_verified() {
    let place = published();
    let said = place.run(["verify", "small", "-o", "out"]).expect_success();
    assert!(said.starts_with("S1   holds         exact"), "{said}");
    assert!(said.contains("1 claim: 1 holds, 0 hold within a limit, 0 fail, 0 not checked"), "{said}");
    assert!(said.contains(" distinct proof steps, 0 of them without a certificate\n"), "{said}");
    assert!(place.read("out/ledger.json").contains("\"verdict\": \"holds\""));
    assert!(place.read("out/environment.json").contains("MPFR"));
    let threads = place.run(["verify", "small", "-o", "out-2", "--threads", "2"]).expect_success();
    assert_eq!(threads.replace("out-2", "out"), said);
}

#[test]
fn a_page_shows_its_parts_what_rests_on_what_and_how_each_claim_is_decided_again() {
    let place = small_report();
    place.write("small/claims.toml", format!("{CLAIMS}{}", CLAIMS.replace("S1", "L3")));
    let second = PLAN.split_once("[[chapter]]").unwrap().1.replace("\"c\"", "\"d\"");
    place.write("small/report.toml", format!("{PLAN}[[chapter]]{second}part = \"code-verification\"\n"));
    place.run(["report", "small", "-o", "out"]).expect_success();
    let (page, text) = (place.page("out/index.html"), place.read("out/ledger.md"));
    assert!(page.contains("id=\"claims-picture\"") && page.contains("S1 on L3."), "{page}");
    assert!(place.read("out/figures/claims-picture.svg").contains("href=\"#claim-S1\""));
    assert!(text.contains("figures/claims-picture.svg"));
    for report in [&page, &text] {
        assert!(report.contains("slipmode verify small --claim S1"));
        assert!(report.contains("Code verification: exact"));
    }
    assert!(page.contains("<h3 id=\"d-title\">C</h3>") && text.contains("\n### C\n"));
}

#[test]
fn a_result_for_programs_has_a_test_for_each_claim_and_each_file_that_moved() {
    let place = published();
    let said = place.run(["verify", "small", "-o", "out"]).expect_success();
    assert_eq!(place.run(["verify", "small", "-o", "out", "--junit", "all.xml"]).expect_success(), said);
    let result = place.read("all.xml");
    assert!(result.contains("tests=\"2\" failures=\"0\" skipped=\"0\""), "{result}");
    assert!(result.contains("<testcase classname=\"small: claims\" name=\"S1 W\">"), "{result}");
    place.write(
        "small/claims.toml",
        CLAIMS.replace("\"holds\"", "\"fails\"").replace("\"W\"", "\"K < K_c & <b>\""),
    );
    let moved = place.run(["verify", "small", "-o", "out", "--junit", "-"]);
    assert_eq!(moved.code, 1);
    for part in [
        "tests=\"6\" failures=\"6\"",
        "name=\"S1 K &lt; K_c &amp; &lt;b&gt;\"",
        "message=\"recorded fails, now holds\"",
        "classname=\"small: published copy\" name=\"report.md\"><failure message=\"report.md:",
    ] {
        assert!(moved.stdout.contains(part), "{part}: {}", moved.stdout);
    }
    let not_checked = "reason = \"No theory.\"";
    place.write("small/claims.toml", CLAIMS.replace("\"holds\"", "\"not-checked\"") + not_checked);
    let skipped = place.run(["verify", "small", "-o", "out", "--junit", "-"]).stdout;
    assert!(skipped.contains("<skipped message=\"not-checked\"/>"), "{skipped}");
    place
        .run(["verify", "small", "-o", "out", "--junit", "small/claims.toml"])
        .expect_refusal(&["claims.toml"]);
    let both = ["verify", "small", "-o", "out", "--json", "--junit", "-"];
    place.run(both).expect_refusal(&["--junit = -: needs a file: standard output has the object"]);
}

#[test]
fn drift_of_a_verdict_is_named_with_old_and_new() {
    let place = published();
    place.write("small/claims.toml", CLAIMS.replace("\"holds\"", "\"fails\""));
    let ended = place.run(["verify", "small", "-o", "out"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.contains("S1: recorded fails, now holds"), "{}", ended.stderr);
    for arguments in [["report", "small", "-o", "out"], ["archive", "small", "-o", "small.zip"]] {
        let ended = place.run(arguments);
        let warning = "warning: S1: recorded fails, now holds; `verify` and `replay` exit with 1\n";
        assert_eq!((ended.code, ended.stderr.as_str()), (0, warning));
    }
}

#[test]
fn a_wrong_equation_fails_the_claim_that_rests_on_it() {
    let place = published();
    let wrong = EQUATIONS.replacen("(b-a)", "(b+a)", 1).replacen("(b - a)", "(b + a)", 1);
    assert_ne!(wrong, EQUATIONS);
    place.write("small/equations.toml", wrong);
    let ended = place.run(["verify", "small", "-o", "out"]);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    assert!(ended.stderr.contains("S1: recorded holds, now "), "{}", ended.stderr);
}

#[cfg(unix)]
#[test]
fn files_that_moved_are_named_one_by_one() {
    let place = published();
    let published = |name: &str| place.path("small/published").join(name);
    let ledger = place.read("small/published/ledger.json");
    fs::write(published("ledger.json"), ledger.replace("eq 9", "eq 8")).unwrap();
    fs::remove_file(published("report.md")).unwrap();
    fs::write(published("more.txt"), "").unwrap();
    fs::write(published("two\nlines"), "").unwrap();
    fs::write(published("environment.json"), "{}").unwrap();
    let ended = place.run(["verify", "small", "-o", "out"]);
    assert_eq!(ended.code, 1);
    for message in [
        "differs from the published copy",
        "report.md: not in the published copy",
        "more.txt: in the published copy, but not in the report",
        "two\\u{a}lines: in the published copy, but not in the report",
        "environment.json: not as slipmode writes it",
        "differences: 0 verdicts, 5 files",
    ] {
        assert!(ended.stderr.contains(message), "{message}: {}", ended.stderr);
    }
    let into = ["archive", "small", "-o", "small/published/ledger.json"];
    place.run(into).expect_refusal(&["ledger.json: is read and written by this command"]);
    fs::remove_dir_all(place.path("small/published")).unwrap();
    std::os::unix::fs::symlink("nowhere", place.path("small/published")).unwrap();
    place.run(["verify", "small", "-o", "out"]).expect_refusal(&["small/published: is no folder"]);
}

#[test]
fn a_report_without_a_published_page_is_compared_in_all_other_files() {
    let place = small_report();
    place.write("small/report.toml", PLAN.replace("scenes", "publish_page = false\nscenes"));
    let printed = place.run(["report", "small", "--for-publication", "-o", "out"]).expect_success();
    assert!(printed.ends_with("out/report.md\n"), "{printed}");
    assert!(!place.path("out/index.html").exists());
    copy(&place.path("out"), &place.path("small/published"));
    place.run(["verify", "small", "-o", "made"]).expect_success();
    assert!(place.path("made/index.html").exists());
    copy(&place.path("small"), &place.path("reports/of another name"));
    place.run(["verify", "reports/of another name", "-o", "made"]).expect_success();
    place.write("small/published/index.html", "<html>");
    let ended = place.run(["verify", "small", "-o", "made"]);
    assert_eq!(ended.code, 1);
    assert!(
        ended.stderr.contains("index.html: in the published copy, but not in the report"),
        "{}",
        ended.stderr
    );
}

#[test]
fn every_fault_of_every_file_of_a_report_is_told_at_once() {
    let place = small_report();
    place.write("small/report.toml", PLAN.replace("[\"a\"]", "[\"a\", \"b\"]"));
    place.write("small/scenes/b.toml", format!("{SCENE}colour = 1\n"));
    place.write("small/claims.toml", format!("{CLAIMS}{CLAIMS}{}", CLAIMS.replace("S1", "S0")));
    fs::remove_file(place.path("small/prose/c.md")).unwrap();
    place.run(["verify", "small", "-o", "out"]).expect_refusal(&[
        "small/claims.toml:7: claim[2].id = \"S1\": the same as an earlier claim `S1`",
        "small/claims.toml:12: claim[3].id = \"S0\": unknown",
        "small/scenes/b.toml:3: colour: unknown key",
        "small/prose/c.md: cannot be read",
    ]);
    assert_eq!(place.names(), ["small"]);
}

#[test]
fn doubled_scenes_are_refused_by_file_and_by_name() {
    let place = small_report();
    place.write("small/report.toml", PLAN.replace("[\"a\"]", "[\"a\", \"A\"]"));
    place
        .run(["report", "small"])
        .expect_refusal(&["scenes[2] = \"A\": the same as an earlier `a` when case is ignored"]);
    place.write("small/report.toml", PLAN.replace("[\"a\"]", "[\"a\", \"b\"]"));
    place.write("small/scenes/b.toml", SCENE);
    place.run(["report", "small"]).expect_refusal(&[
        "small/scenes/b.toml: name = a: the same as the name of the scene in small/scenes/a.toml",
    ]);
    assert_eq!(place.names(), ["small"]);
}

#[test]
fn a_folder_that_is_no_report_is_refused() {
    let place = Workplace::new();
    place.run(["verify", "none"]).expect_refusal(&["none: no such folder"]);
    let small = small_report();
    small.write("small/equations.toml", "x = 1");
    small.run(["report", "small"]).expect_refusal(&["small/equations.toml:1: unknown field `x`"]);
}

/// The numbers of the paper's figures that a report places, in the order of its chapters.
fn figures_placed(report: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports").join(report);
    let plan = fs::read_to_string(folder.join("report.toml")).unwrap();
    let files = plan.lines().filter_map(|line| line.strip_prefix("prose = \"")?.strip_suffix('"'));
    let texts = files.map(|file| fs::read_to_string(folder.join("prose").join(file)).unwrap());
    let placed = |text: String| -> Vec<String> {
        let ids = text.lines().filter_map(|line| line.strip_prefix("[[figure:fig-")?.strip_suffix("]]"));
        ids.map(str::to_owned).collect()
    };
    texts.flat_map(placed).collect()
}

#[test]
fn the_figures_of_the_paper_come_in_the_order_of_the_paper() {
    for (report, least) in [("im-avouac", 14), ("paper-on-paper", 4), ("rock-friction", 4)] {
        let placed = figures_placed(report);
        assert!(placed.len() >= least && placed.is_sorted(), "{report}: {placed:?}");
        assert_eq!(placed[0], "1", "{report}: the first figure stands beside the answer");
    }
}

/// The table of the paper's statements names every claim about the paper, and no claim that the report does not decide.
#[test]
fn every_statement_of_the_paper_has_a_claim_or_a_reason_and_every_claim_a_statement() {
    let statements = include_str!("../../reports/im-avouac/prose/statements.md");
    let claims = include_str!("../../reports/im-avouac/claims.toml");
    let linked: BTreeSet<&str> =
        statements.split("(#claim-").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    let ids = claims.split("id = \"").skip(1).filter_map(|rest| rest.split('"').next());
    // Claims X are results of this report, not statements of the paper.
    let of_paper: BTreeSet<&str> = ids.filter(|id| !id.starts_with('X')).collect();
    assert_eq!(linked, of_paper);
    let rows = statements.lines().filter(|line| line.starts_with("| ")).skip(2);
    for row in rows {
        assert!(row.contains("(#claim-") || row.contains("| not decided: "), "{row}");
    }
}

#[test]
fn a_certificate_is_printed_once_and_linked_elsewhere() {
    let place = small_report();
    let [areas, cases] = ["B1", "B9"].map(|id| CLAIMS.replace("S1", id));
    place.write("small/claims.toml", areas + &cases);
    place.run(["report", "small", "-o", "out"]).expect_warnings();
    let (page, text) = (place.page("out/index.html"), place.read("out/ledger.md"));
    assert_eq!(text.matches("  areas-for-weakening: ").count(), 1, "{text}");
    assert_eq!(text.matches("Certificate: see claim [B1](#b1).").count(), 1, "{text}");
    assert_eq!(page.matches("The certificate is in claim <a href=\"#claim-B1\">B1</a>").count(), 1);
}

#[test]
fn the_answer_stands_first_and_follows_the_verdicts() {
    let place = small_report();
    for (words, expected) in [
        ("1 holds as stated", "all claims about the stability transition hold"),
        ("1 fails", "One claim is wrong as stated"),
    ] {
        place.run(["report", "small", "-o", "out"]).expect_warnings();
        for file in ["out/index.html", "out/ledger.md"] {
            let report = place.read(file);
            let answer = report.find(words).expect(words);
            assert!(
                report.contains(expected) && answer < report.rfind("Ledger of claims").unwrap(),
                "{report}"
            );
        }
        let wrong = EQUATIONS.replacen("(b-a)", "(b+a)", 1).replacen("(b - a)", "(b + a)", 1);
        place.write("small/equations.toml", wrong);
    }
}
