//! `archive --codecheck`: what an author prepares for a CODECHECK certificate. `xtask/validate/validate_codecheck.py` checks each rule.

use std::fs;

use slipmode::archive::{CODECHECK_FILE, Caps, Files, pack, unpack};

use crate::archive::small_report;
use crate::harness::Workplace;

const PAPER: &str = "[paper]\ntitle = \"A \\\"good\\\" paper: é\"\nreference = \"Under review at a journal\"\n\
    [[paper.author]]\nname = \"Josiah Carberry\"\norcid = \"0000-0002-1825-0097\"\n\
    [[paper.author]]\nname = \"Second: author #2\"\n";

fn packed(place: &Workplace) -> Files {
    unpack(&fs::read(place.path("small.zip")).unwrap(), &Caps::default()).unwrap().0
}

fn text(files: &Files, path: &str) -> String {
    String::from_utf8(files[path].clone()).unwrap()
}

fn report_with_paper() -> Workplace {
    let place = small_report();
    let plan = place.read("small/report.toml");
    place.write("small/report.toml", format!("{plan}{PAPER}"));
    place
}

#[test]
fn authors_and_reference_are_those_of_the_report() {
    let place = report_with_paper();
    let said = place.run(["archive", "small", "-o", "small.zip", "--codecheck"]).expect_success();
    assert!(said.contains("codecheck.yml: open: paper.author[2].orcid: of Second: author #2\n"), "{said}");
    assert_eq!(said.matches("open: ").count(), 1, "{said}");
    let files = packed(&place);
    let written = text(&files, CODECHECK_FILE);
    let paper = "\npaper:\n  title: \"A \\\"good\\\" paper: é\"\n  authors:\n  - name: \"Josiah Carberry\"\n    \
                 ORCID: 0000-0002-1825-0097\n  - name: \"Second: author #2\"\n    # OPEN FIELD: ORCID\n  \
                 reference: \"Under review at a journal\"\n";
    assert!(
        written
            .starts_with("%YAML 1.1\n---\nversion: https://codecheck.org.uk/spec/config/1.0/\n\nmanifest:\n")
    );
    assert!(written.ends_with(paper), "{written}");
    for path in files.keys().filter(|path| path.starts_with("report/")) {
        assert!(written.contains(&format!("  - file: \"{path}\"\n    comment: \"")), "{path}");
    }
    assert!(
        text(&files, "LICENSE").contains("LICENSE-MIT") && text(&files, "README.md").contains("## CODECHECK")
    );
}

#[test]
fn nobody_is_invented() {
    let place = small_report();
    let said = place.run(["archive", "small", "-o", "small.zip", "--codecheck"]).expect_success();
    for open in ["paper.reference: ", "paper.author[1].name: "] {
        assert!(said.contains(&format!("codecheck.yml: open: {open}")), "{said}");
    }
    let written = text(&packed(&place), CODECHECK_FILE);
    assert!(written.contains("  - name: \"OPEN FIELD: the corresponding author\"\n"), "{written}");
    place.run(["archive", "small", "-o", "small.zip"]).expect_success();
    let files = packed(&place);
    assert!(!files.contains_key(CODECHECK_FILE) && !files.contains_key("LICENSE"), "only on request");
}

#[test]
fn the_manifest_is_made_again_and_an_altered_one_is_noticed() {
    let place = report_with_paper();
    place.run(["archive", "small", "-o", "small.zip", "--codecheck"]).expect_success();
    place.run(["replay", "small.zip", "--strict"]).expect_success();
    // The command that the README gives.
    let files = packed(&place);
    for (path, bytes) in &files {
        place.write(&format!("unpacked/{path}"), bytes);
    }
    place.run(["report", "unpacked/input", "--output", "again"]).expect_success();
    for path in files.keys().filter_map(|path| path.strip_prefix("report/")) {
        let (archived, again) =
            (text(&files, &format!("report/{path}")), place.read(&format!("again/{path}")));
        let is_page = ["index.html", "ledger.md"].contains(&path);
        assert!(if is_page { again.len() > archived.len() } else { again == archived }, "{path}");
    }
    let (mut altered, time) = unpack(&fs::read(place.path("small.zip")).unwrap(), &Caps::default()).unwrap();
    let changed = text(&altered, CODECHECK_FILE).replace("Josiah Carberry", "Somebody Else");
    altered.insert(CODECHECK_FILE.into(), changed.into_bytes());
    crate::archive::seal(&mut altered);
    place.write("altered.zip", pack(&altered, time).unwrap());
    let ended = place.run(["replay", "altered.zip"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.contains("codecheck.yml:"), "{}", ended.stderr);
}
