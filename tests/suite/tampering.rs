//! Archives altered by somebody who seals them again consistently: every kind is refused by name, whether this build made the archive or another one.

use std::fs;
use std::sync::OnceLock;

use serde_json::Value;
use slipmode::archive::{Caps, DIGESTS_FILE, Files, ReleaseTime, pack, sha256_hex, unpack};

use crate::archive::archived;
use crate::harness::{Ended, Workplace, is_slow};

/// The kinds of tampering that `KINDS` has to have at least.
const FEWEST_KINDS: usize = 40;

const CRATE: &str = "ro-crate-metadata.json";
const STATEMENT: &str = "provenance.intoto.json";
const LEDGER: &str = "report/ledger.json";
const TABLE: &str = "report/tables/boundary.csv";
const FIGURE: &str = "report/figures/claims-picture.svg";
const PAGE: &str = "report/index.html";
const MARKDOWN: &str = "report/report.md";

/// A kind of tampering: its name, what it does, and what a replay says where another build made the archive.
///
/// Where this build made it, the replay names the file that was altered.
type Kind = (&'static str, fn(&mut Files), &'static str);

fn text(files: &Files, path: &str) -> String {
    String::from_utf8(files[path].clone()).unwrap()
}

fn put(files: &mut Files, path: &str, text: impl Into<Vec<u8>>) {
    files.insert(path.into(), text.into());
}

/// Replaces the first occurrence of a text, which has to be there.
fn replace(files: &mut Files, path: &str, from: &str, to: &str) {
    let old = text(files, path);
    assert!(old.contains(from), "{path} has no {from:?}");
    put(files, path, old.replacen(from, to, 1));
}

/// Alters the ledger as JSON.
fn in_ledger(files: &mut Files, alter: fn(&mut Value)) {
    let mut ledger: Value = serde_json::from_slice(&files[LEDGER]).unwrap();
    alter(&mut ledger);
    put(files, LEDGER, format!("{ledger:#}\n"));
}

/// Alters the cell of a column in the first row of the table.
fn in_cell(files: &mut Files, column: &str, alter: fn(&str) -> String) {
    let table = text(files, TABLE);
    let mut lines: Vec<String> = table.lines().map(str::to_string).collect();
    let place = lines[0].split(',').position(|name| name == column).unwrap();
    let mut cells: Vec<String> = lines[1].split(',').map(str::to_string).collect();
    cells[place] = alter(&cells[place]);
    lines[1] = cells.join(",");
    put(files, TABLE, lines.join("\n") + "\n");
}

/// Alters every line of the table but the first.
fn in_rows(files: &mut Files, alter: fn(Vec<&str>) -> Vec<String>) {
    let table = text(files, TABLE);
    let (columns, rows) = table.split_once('\n').unwrap();
    let rows = alter(rows.lines().collect());
    put(files, TABLE, format!("{columns}\n{}\n", rows.join("\n")));
}

fn owned(rows: &[&str]) -> Vec<String> {
    rows.iter().map(ToString::to_string).collect()
}

const SIGMA: &str = "normal_stress_pa";

const KINDS: &[Kind] = &[
    (
        "a verdict",
        |f| replace(f, LEDGER, "\"verdict\": \"fails\"", "\"verdict\": \"holds\""),
        "B8: verdict: holds -> fails",
    ),
    (
        "a strength",
        |f| in_ledger(f, |l| l["claims"][0]["strength"] = "kernel".into()),
        "S1: strength: kernel -> exact",
    ),
    (
        "the words of a claim",
        |f| in_ledger(f, |l| l["claims"][0]["words"] = "Proved.".into()),
        "S1: words: Proved. -> W",
    ),
    (
        "a place in the paper",
        |f| in_ledger(f, |l| l["claims"][0]["place"] = "eq 10".into()),
        "S1: place: eq 10 -> eq 9",
    ),
    ("a criterion", |f| in_ledger(f, |l| l["claims"][0]["criterion"] = "x".into()), "S1: criterion: x -> "),
    (
        "what is not established",
        |f| in_ledger(f, |l| l["claims"][0]["not_established"] = "x".into()),
        "S1: not-established: x -> ",
    ),
    (
        "the statement of a proof",
        |f| in_ledger(f, |l| l["claims"][0]["evidence"][0]["proof"]["statement"] = "x".into()),
        "S1: evidence[1].proof.statement: x -> ",
    ),
    (
        "a step of a proof",
        |f| in_ledger(f, |l| l["claims"][0]["evidence"][0]["proof"]["steps"][0]["says"] = "x".into()),
        "S1: evidence[1].proof.steps[1].says: x -> ",
    ),
    (
        "all evidence",
        |f| in_ledger(f, |l| l["claims"][0]["evidence"] = Value::Array(Vec::new())),
        "S1: evidence: 0 entries -> ",
    ),
    (
        "a counter-example",
        |f| in_ledger(f, |l| l["claims"][1]["counter_example"] = Value::Null),
        "B8: counter-example: none -> ",
    ),
    ("a limit", |f| in_ledger(f, |l| l["claims"][0]["limit"] = "η < 1".into()), "S1: limit: η < 1 -> none"),
    (
        "the recorded verdict in the ledger",
        |f| in_ledger(f, |l| l["claims"][1]["expected"] = "holds".into()),
        "B8: expected: holds -> fails",
    ),
    (
        "premises",
        |f| in_ledger(f, |l| l["claims"][0]["rests_on"] = Value::Array(Vec::new())),
        "S1: rests-on: 0 entries -> ",
    ),
    (
        "a claim left out",
        |f| in_ledger(f, |l| drop(l["claims"].as_array_mut().unwrap().pop())),
        "only in the second ledger",
    ),
    (
        "a claim added",
        |f| {
            in_ledger(f, |l| {
                let mut more = l["claims"][0].clone();
                more["id"] = "Z99".into();
                l["claims"].as_array_mut().unwrap().push(more)
            })
        },
        "Z99: only in the first ledger",
    ),
    (
        "a claim twice",
        |f| {
            in_ledger(f, |l| {
                let more = l["claims"][0].clone();
                l["claims"].as_array_mut().unwrap().push(more)
            })
        },
        "it lists claim S1 twice",
    ),
    (
        "claims in another order",
        |f| in_ledger(f, |l| l["claims"].as_array_mut().unwrap().reverse()),
        "report/ledger.json:",
    ),
    (
        "the report's name in the ledger",
        |f| in_ledger(f, |l| l["report"] = "x".into()),
        "ledger: report: x -> small",
    ),
    (
        "a field that no ledger has",
        |f| in_ledger(f, |l| l["claims"][0]["certified_by"] = "me".into()),
        "S1: certified-by: me -> none",
    ),
    (
        "a doubled key",
        |f| replace(f, LEDGER, "\"verdict\": \"fails\",", "\"verdict\": \"holds\", \"verdict\": \"fails\","),
        "report/ledger.json:",
    ),
    (
        "a ledger that is no JSON",
        |f| put(f, LEDGER, "holds"),
        "report/ledger.json: the first is not a ledger",
    ),
    (
        "a cell of 1e30",
        |f| in_cell(f, SIGMA, |_| "1e30".into()),
        "report/tables/boundary.csv:2: 1e30 archived, ",
    ),
    (
        "every cell 1e30",
        |f| {
            in_rows(f, |rows| rows.iter().map(|row| vec!["1e30"; row.split(',').count()].join(",")).collect())
        },
        "report/tables/boundary.csv:2: 1e30 archived, ",
    ),
    (
        "a cell with fewer digits",
        |f| in_cell(f, SIGMA, |_| "2e5".into()),
        "report/tables/boundary.csv:2: 2e5 archived, ",
    ),
    ("a cell's sign", |f| in_cell(f, SIGMA, |cell| format!("-{cell}")), "report/tables/boundary.csv:2: -"),
    (
        "a cell's word",
        |f| in_cell(f, "arc", |_| "lowest".into()),
        "report/tables/boundary.csv:2: lowest archived, ",
    ),
    (
        "a cell with a control character",
        |f| in_cell(f, "arc", |_| "\u{1b}[2J".into()),
        "report/tables/boundary.csv:2: \\u{1b}[2J archived, ",
    ),
    ("a row left out", |f| in_rows(f, |rows| owned(&rows[1..])), "report/tables/boundary.csv: "),
    (
        "a row added",
        |f| in_rows(f, |rows| owned(&[&rows[..], &rows[..1]].concat())),
        "report/tables/boundary.csv: ",
    ),
    (
        "rows in another order",
        |f| in_rows(f, |rows| owned(&rows.into_iter().rev().collect::<Vec<_>>())),
        "report/tables/boundary.csv:2: ",
    ),
    (
        "a column renamed",
        |f| replace(f, TABLE, SIGMA, "shear_stress_pa"),
        "report/tables/boundary.csv:1: shear_stress_pa archived, ",
    ),
    (
        "a table left out",
        |f| drop(f.remove(TABLE)),
        "report/tables/boundary.csv: made by the report, but not archived",
    ),
    (
        "a table added",
        |f| put(f, "report/tables/more.csv", "x\n"),
        "report/tables/more.csv: archived, but not made by the report",
    ),
    ("a figure's text", |f| replace(f, FIGURE, "S1", "S2"), "report/figures/claims-picture.svg:"),
    (
        "a script in a figure",
        |f| replace(f, FIGURE, "</svg>", "<script>alert(1)</script></svg>"),
        "report/figures/claims-picture.svg:",
    ),
    (
        "a figure replaced",
        |f| put(f, FIGURE, "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"),
        "report/figures/claims-picture.svg:",
    ),
    (
        "a figure left out",
        |f| drop(f.remove(FIGURE)),
        "report/figures/claims-picture.svg: made by the report, but not archived",
    ),
    (
        "a figure added",
        |f| put(f, "report/figures/more.svg", "<svg/>"),
        "report/figures/more.svg: archived, but not made by the report",
    ),
    (
        "the page replaced",
        |f| put(f, PAGE, "<!DOCTYPE html><title>All claims hold</title>"),
        "report/index.html:",
    ),
    ("a verdict on the page", |f| replace(f, PAGE, "fails", "holds"), "report/index.html:"),
    (
        "a remark on the page",
        |f| replace(f, PAGE, "</html>", "</html><!-- approved -->"),
        "report/index.html:",
    ),
    (
        "an environment block on the page",
        |f| replace(f, PAGE, "</body>", "<!-- environment:begin -->x<!-- environment:end --></body>"),
        "report/index.html:",
    ),
    (
        "the page left out",
        |f| drop(f.remove(PAGE)),
        "report/index.html: made by the report, but not archived",
    ),
    ("the Markdown report replaced", |f| put(f, MARKDOWN, "# All claims hold\n"), "report/report.md:"),
    ("a verdict in the Markdown report", |f| replace(f, MARKDOWN, "fails", "holds"), "report/report.md:"),
    (
        "an environment block in the Markdown report",
        |f| replace(f, MARKDOWN, "\n", "\n<!-- environment:begin -->x<!-- environment:end -->\n"),
        "report/report.md:",
    ),
    (
        "a command in the README",
        |f| replace(f, "README.md", "slipmode replay", "sh install.sh; slipmode replay"),
        "README.md:",
    ),
    ("a verdict in the README", |f| replace(f, "README.md", "| fails |", "| holds |"), "README.md:"),
    ("a licence", |f| replace(f, "LICENSE-MIT", "MIT", "GPL"), "LICENSE-MIT:"),
    ("the notice", |f| replace(f, "NOTICE.md", "LGPL", "MIT"), "NOTICE.md:"),
    ("an author", |f| replace(f, "CITATION.cff", "slipmode", "somebody"), "CITATION.cff:"),
    (
        "the builder in the statement",
        |f| replace(f, STATEMENT, "urn:slipmode:report", "urn:other:report"),
        "provenance.intoto.json:",
    ),
    (
        "the crate's description",
        |f| replace(f, CRATE, "\"description\": \"", "\"description\": \"Approved. "),
        "ro-crate-metadata.json:",
    ),
    ("the bill of materials", |f| replace(f, "sbom.cdx.json", "\"rug\"", "\"bug\""), "sbom.cdx.json:"),
    (
        "a file beside the report",
        |f| put(f, "install.sh", "true\n"),
        "install.sh: archived, but not made by the report",
    ),
    (
        "a missing licence",
        |f| drop(f.remove("LICENSE-APACHE")),
        "LICENSE-APACHE: made by the report, but not archived",
    ),
    (
        "the recorded verdict",
        |f| replace(f, "input/claims.toml", "\"fails\"", "\"holds\""),
        "B8: recorded holds, now fails",
    ),
    (
        "a parameter",
        |f| replace(f, "input/scenes/a.toml", "0.004", "0.0041"),
        "report/tables/boundary.csv:2: ",
    ),
    (
        "the title",
        |f| replace(f, "input/report.toml", "title = \"Small\"", "title = \"Large\""),
        "report/index.html:",
    ),
    ("prose", |f| replace(f, "input/prose/c.md", "Words.", "Proved."), "report/ledger.md:"),
    (
        "an equation",
        |f| replace(f, "input/equations.toml", "(b - a)*sigma/D_c*(1 + M", "(b - a)*sigma/D_c*(2 + M"),
        "S1: ",
    ),
    (
        "an input that nothing needs",
        |f| put(f, "input/prose/d.md", "x\n"),
        "input/prose/d.md: the report does not refer to it",
    ),
    ("a missing input", |f| drop(f.remove("input/prose/c.md")), "input/prose/c.md: cannot be read"),
];

/// Brings all metadata of an archive into agreement with its files.
fn seal(files: &mut Files) {
    let mut statement: Value = serde_json::from_slice(&files[STATEMENT]).unwrap();
    for place in ["/subject", "/predicate/buildDefinition/resolvedDependencies"] {
        for entry in statement.pointer_mut(place).unwrap().as_array_mut().unwrap() {
            if let Some(bytes) = files.get(entry["name"].as_str().unwrap()) {
                entry["digest"]["sha256"] = sha256_hex(bytes).into();
            }
        }
    }
    put(files, STATEMENT, format!("{statement:#}\n"));
    let mut metadata: Value = serde_json::from_slice(&files[CRATE]).unwrap();
    for entry in metadata["@graph"].as_array_mut().unwrap() {
        let path = entry["@id"].as_str().unwrap();
        if let (Some(bytes), true) = (files.get(path), entry.get("sha256").is_some()) {
            let (digest, length) = (sha256_hex(bytes), bytes.len().to_string());
            (entry["sha256"], entry["contentSize"]) = (digest.into(), length.into());
        }
    }
    put(files, CRATE, format!("{metadata:#}\n"));
    files.remove(DIGESTS_FILE);
    let sums: String = files.iter().map(|(path, bytes)| format!("{}  {path}\n", sha256_hex(bytes))).collect();
    put(files, DIGESTS_FILE, sums);
}

/// Makes it the archive of another build, consistently.
fn of_other_build(files: &mut Files) {
    let versions: Value = serde_json::from_slice(&files["versions.json"]).unwrap();
    let digest = versions["source_sha256"].as_str().unwrap();
    for path in ["versions.json", STATEMENT, CRATE] {
        put(files, path, text(files, path).replace(digest, &"5".repeat(64)));
    }
}

fn original() -> &'static (Files, ReleaseTime) {
    static ORIGINAL: OnceLock<(Files, ReleaseTime)> = OnceLock::new();
    ORIGINAL
        .get_or_init(|| unpack(&fs::read(archived().path("small.zip")).unwrap(), &Caps::default()).unwrap())
}

/// Alters the archive, seals it and replays it.
fn replayed(alter: &dyn Fn(&mut Files), options: &[&str]) -> Ended {
    let (mut files, time) = original().clone();
    alter(&mut files);
    seal(&mut files);
    let place = Workplace::new();
    place.write("forged.zip", pack(&files, time).unwrap());
    let ended = place.run(["replay", "forged.zip"].into_iter().chain(options.iter().copied()));
    assert!(!ended.stderr.contains("panicked"), "{}", ended.stderr);
    ended
}

/// The path of the first file that a kind of tampering alters.
fn altered_path(alter: fn(&mut Files)) -> String {
    let (mut files, old) = (original().0.clone(), &original().0);
    alter(&mut files);
    let differs = |path: &&String| files.get(*path) != old.get(*path);
    old.keys().chain(files.keys()).find(differs).unwrap().clone()
}

#[track_caller]
fn expect_named(ended: &Ended, kind: &str, part: &str) {
    assert!(matches!(ended.code, 1 | 2), "{kind}: exit code {}\n{}", ended.code, ended.stdout);
    assert!(ended.stderr.contains(part), "{kind}: {part:?} is not in:\n{}", ended.stderr);
    assert!(!ended.stderr.contains('\u{1b}'), "{kind}: a control character reaches the terminal");
}

#[test]
fn forty_kinds_of_tampering_are_refused_by_name_in_an_archive_of_this_build() {
    assert!(KINDS.len() >= FEWEST_KINDS);
    assert_eq!(replayed(&|_| {}, &["--strict"]).code, 0, "the archive itself replays");
    // Bytes are compared here. All kinds are tried on another build in every run, and here where slow tests run.
    for (kind, alter, part) in KINDS.iter().step_by(if is_slow() { 1 } else { 5 }) {
        let path = altered_path(*alter);
        // An altered input is seen by what follows from it.
        let named = if path.starts_with("input/") { part } else { path.as_str() };
        expect_named(&replayed(alter, &[]), kind, named);
    }
}

#[test]
fn forty_kinds_of_tampering_are_refused_by_name_in_an_archive_of_another_build() {
    let untouched = replayed(&of_other_build, &["--other-build"]);
    assert_eq!((untouched.code, untouched.stderr.as_str()), (0, ""), "the archive itself replays");
    for (kind, alter, part) in KINDS {
        let both = |files: &mut Files| {
            of_other_build(files);
            alter(files);
        };
        expect_named(&replayed(&both, &["--other-build"]), kind, part);
    }
}

#[test]
fn an_archive_of_another_build_is_compared_only_where_that_is_asked_for() {
    let ended = replayed(&of_other_build, &[]);
    ended.expect_refusal(&[
        "forged.zip: archived by another build (slipmode 0.1.0 of sources 555555555555",
        "--other-build",
    ]);
    // An archive of this build passes with the option too, and is compared byte by byte.
    let said = replayed(&|_| {}, &["--other-build"]).expect_success();
    assert!(said.contains("archived by this build: all bytes compared"), "{said}");
    for (versions, problem) in [
        ("{}", "versions.json: missing field"),
        (
            "{ \"source_sha256\": \"5\", \"versions\": { \"slipmode\": \"0.1.0\" } }",
            "is not what a build of slipmode writes",
        ),
    ] {
        let alter = |files: &mut Files| put(files, "versions.json", versions);
        replayed(&alter, &["--other-build"]).expect_refusal(&[problem]);
    }
}

#[test]
fn what_cannot_be_verified_is_reported_on_its_own_line_and_strict_fails() {
    let said = replayed(&of_other_build, &["--other-build"]).expect_success();
    assert!(said.contains("archived by another build: all files compared"), "{said}");
    assert!(said.lines().any(|line| line.starts_with("not verified: versions.json:")), "{said}");
    assert!(!said.contains("not verified: Cargo.lock"), "{said}");
    let other_lock = |files: &mut Files| {
        of_other_build(files);
        // The bill of materials follows from the lock file, so both are altered.
        let lock = text(files, "Cargo.lock");
        let digest = lock.split("checksum = \"").nth(1).unwrap()[..64].to_string();
        for path in ["Cargo.lock", "sbom.cdx.json"] {
            replace(files, path, &digest, &"0".repeat(64));
        }
    };
    let strict = replayed(&other_lock, &["--other-build", "--strict"]);
    assert_eq!(strict.code, 1, "{}", strict.stderr);
    assert!(strict.stderr.contains("versions.json: ") && strict.stderr.contains("cannot be verified"));
    assert!(strict.stdout.contains("not verified: Cargo.lock: "), "{}{}", strict.stdout, strict.stderr);
}

#[test]
fn a_last_digit_of_another_build_is_no_difference() {
    let last_digit = |files: &mut Files| {
        of_other_build(files);
        in_cell(files, SIGMA, |cell| {
            let (digits, exponent) =
                cell.split_once('e').map_or((cell, ""), |(digits, _)| (digits, &cell[digits.len()..]));
            let last = digits.chars().last().and_then(|digit| digit.to_digit(10)).unwrap();
            format!("{}{}{exponent}", &digits[..digits.len() - 1], if last == 9 { 8 } else { last + 1 })
        });
    };
    let ended = replayed(&last_digit, &["--other-build"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
}
