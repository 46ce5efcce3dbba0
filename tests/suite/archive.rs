//! `archive`, `replay`, `diff` and `verify --claim`: what a reviewer is handed runs again, and nothing altered passes.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use slipmode::archive::{Caps, DIGESTS_FILE, Files, ReleaseTime, pack, sha256_hex, unpack};

use crate::harness::Workplace;

const PLAN: &str = "name = \"small\"\ntitle = \"Small\"\nscenes = [\"a\"]\n\
    [[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n";
const CLAIMS: &str = "[[claim]]\nid = \"S1\"\nplace = \"eq 9\"\nwords = \"W\"\nexpected = \"holds\"\n\
    [[claim]]\nid = \"B8\"\nplace = \"fig 6\"\nwords = \"W\"\nexpected = \"fails\"\n\
    [[claim]]\nid = \"S2\"\nplace = \"eqs 10, 11\"\nwords = \"W\"\nexpected = \"holds\"\n";
const SCENE: &str = "name = \"a\"\ntitle = \"A\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [boundary]\npoints = 8\ndigits = 30\n";
/// A growth with a second variable, and of a function that ends left of 0; a sum of roots; exponentials; a limit that Coq cannot follow.
const KINDS_OF_THEOREMS: [[&str; 2]; 7] = [
    ["G1", "ln(1 + A*x) < A*x"],
    ["G2", "1 + x + x^2/2 < exp(x)"],
    ["G3", "sqrt(1 + x) < 1 + x/2"],
    ["P1", "sqrt(A + B) < sqrt(A) + sqrt(B)"],
    ["E1", "exp(-x/A) falls with x"],
    ["E2", "A*(B - A*exp(-x/A))^2 < 4*B*A iff (B - A*exp(-x/A))^2 < 4*B"],
    ["L1", "exp(-x/A) -> 1 as x -> 0"],
];
const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

pub fn small_report() -> Workplace {
    let place = Workplace::new();
    place.write("small/report.toml", PLAN);
    place.write("small/claims.toml", CLAIMS);
    place.write("small/equations.toml", EQUATIONS);
    place.write("small/scenes/a.toml", SCENE);
    place.write("small/prose/c.md", "Words.\n\n[[table:boundary]]\n");
    place
}

pub fn archived() -> Workplace {
    let place = small_report();
    place.run(["archive", "small", "-o", "small.zip"]).expect_success();
    place
}

#[test]
fn an_archive_is_replayed_in_another_place() {
    let (from, to) = (archived(), Workplace::new());
    assert!(from.read("small.zip.timings.json").contains("computed in, seconds"));
    fs::copy(from.path("small.zip"), to.path("got.zip")).unwrap();
    let said = to.run(["replay", "got.zip"]).expect_success();
    assert!(said.contains("3 claims: 2 hold, 0 hold within a limit, 1 fails"), "{said}");
    assert!(said.contains("archived by this build: all bytes compared"), "{said}");
    assert_eq!(to.names(), ["got.zip"], "a replay leaves nothing behind");
}

#[test]
fn an_archive_on_standard_output_is_the_same_and_alone_there() {
    let place = archived();
    let before = place.names();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_slipmode"));
    let output = command.args(["archive", "small", "-o", "-"]).current_dir(place.path("")).output().unwrap();
    assert!(output.status.success() && output.stdout == fs::read(place.path("small.zip")).unwrap());
    assert!(String::from_utf8(output.stderr).unwrap().ends_with("  -\n"));
    place.run(["archive", "small", "-o", "-", "--json"]).expect_refusal(&["--output = -: needs a file"]);
    assert_eq!(place.names(), before);
}

#[test]
fn sources_are_packed_as_they_are_and_replay_says_that_nothing_proves_them() {
    let place = small_report();
    place.write("sources.zip", "PK");
    place
        .run(["archive", "small", "-o", "a.zip", "--with-sources", "sources.zip"])
        .expect_refusal(&["sources.zip: is no whole .tar.xz file (`cargo xtask sources` makes one)"]);
    assert!(!place.path("a.zip").exists());
    let sources = b"\xfd7zXZ\0and moreYZ";
    place.write("sources.tar.xz", &sources[..8]);
    let cut = place.run(["archive", "small", "-o", "a.zip", "--with-sources", "sources.tar.xz"]);
    cut.expect_refusal(&["is no whole .tar.xz file"]);
    place.write("sources.tar.xz", sources);
    place.run(["archive", "small", "-o", "a.zip", "--with-sources", "sources.tar.xz"]).expect_success();
    let said = place.run(["replay", "a.zip"]).expect_success();
    assert!(said.contains("all bytes compared\nnot verified: sources.tar.xz: "), "{said}");
    let (files, _) = unpack(&fs::read(place.path("a.zip")).unwrap(), &Caps::default()).unwrap();
    assert_eq!(files["sources.tar.xz"], sources);
    let readme = String::from_utf8(files["README.md"].clone()).unwrap();
    assert!(readme.contains("cargo install --offline --locked"), "{readme}");
}

#[test]
fn archives_have_the_same_bytes_on_any_number_of_threads() {
    let place = small_report();
    for threads in ["1", "2"] {
        place
            .run(["archive", "small", "-o", &format!("{threads}.zip"), "--threads", threads])
            .expect_success();
    }
    assert_eq!(fs::read(place.path("1.zip")).unwrap(), fs::read(place.path("2.zip")).unwrap());
}

#[cfg(unix)]
#[test]
fn an_archive_has_its_theorems_with_their_library_and_coq_accepts_them_without_this_program() {
    let place = archived();
    place.write("own/report.toml", PLAN.replace("small", "own").replace("scenes = [\"a\"]\n", ""));
    let claims = KINDS_OF_THEOREMS.map(|[id, formula]| {
        format!("[[claim]]\nid = \"{id}\"\nplace = \"p\"\nwords = \"W\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\nformula = \"{formula}\"\n")
    });
    place.write("own/claims.toml", claims.concat());
    place.write("own/equations.toml", "[assumptions]\npositive = [\"A\", \"B\", \"x\"]\n");
    place.write("own/prose/c.md", "Words.\n");
    place.run(["archive", "own", "-o", "own.zip"]).expect_success();
    let unpacked = |zip: &str| unpack(&fs::read(place.path(zip)).unwrap(), &Caps::default()).unwrap().0;
    let (files, own) = (unpacked("small.zip"), unpacked("own.zip"));
    for (folder, files) in [("of-small", &files), ("of-own", &own)] {
        for (path, bytes) in files.iter().filter(|(path, _)| path.starts_with("theorems/")) {
            place.write(&format!("{folder}/{path}"), bytes);
        }
        // Files and statements agree with the lists; then the script asks for Coq, which takes minutes.
        let check = place.path(&format!("{folder}/theorems/check.sh"));
        let output = Command::new("/bin/sh").arg(check).env("PATH", without_coq(&place)).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!((output.status.code(), said.as_ref()), (Some(2), "check.sh: coqc is not installed\n"));
    }
    let text = |path: &str| {
        let path = format!("theorems/{path}");
        String::from_utf8(files.get(&path).unwrap_or_else(|| &own[&path]).clone()).unwrap()
    };
    // What Coq cannot follow is no theorem.
    let left_out = String::from_utf8(own["theorems/left-out.txt"].clone()).unwrap();
    let limit = "L1, formula-l1, whole: no tactic for a limit with exp(x/A), which moves with x\n";
    assert!(left_out.contains(limit) && !own.contains_key("theorems/own/claim_L1.v"), "{left_out}");
    assert!(
        text("small/claim_S2_whole.v").contains("Theorem formula_"),
        "{}",
        text("small/claim_S2_whole.v")
    );
    assert!(text("accepted.txt").contains("identity_"));
    let allowed: Vec<&str> = include_str!("../../xtask/axioms.txt").lines().collect();
    assert_eq!(allowed.len(), 4);
    assert!(text("check.sh").contains(&format!("\nallowed='{}'\n", allowed.join("\n"))));
    assert!(allowed.iter().all(|name| text("README.md").contains(&format!("`{name}`"))));
    // The page shows theorems where the ledger names them.
    let ledger = String::from_utf8(files["report/ledger.json"].clone()).unwrap();
    assert_eq!(files.contains_key("report/theorems.md"), ledger.contains("\"theorem\":"));
    let wanted = [
        "library/Tactics.v",
        "library/Functions.v",
        "library/Branches.v",
        "library/Claims.v",
        "library/Cubics.v",
        "library/HalfPlane.v",
        "library/Signs.v",
        "small/claim_S2_whole.v",
        "own/claim_G1.v",
        "own/claim_G1_whole.v",
        "own/claim_G2_whole.v",
        "own/claim_G3.v",
        "own/claim_P1_whole.v",
        "own/claim_E1_whole.v",
        "own/claim_E2.v",
    ];
    let roots = text("own/claim_P1_whole.v");
    assert!(roots.contains("apply (root_part_") && text("own/claim_G1.v").contains("apply (growth_right "));
    let compile = |path: &str| {
        place.write(path, text(path));
        let mut coqc = Command::new("coqc");
        coqc.args(["-R", "library", "Slipmode", path]).current_dir(place.path("."));
        coqc.output()
    };
    // A machine without Coq, or without its library, compiles nothing.
    if !compile(wanted[0]).is_ok_and(|output| output.status.success()) {
        return;
    }
    for path in &wanted[1..] {
        let output = compile(path).unwrap();
        assert!(output.status.success(), "{path}: {}", String::from_utf8_lossy(&output.stderr));
        if !path.starts_with("library") {
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            assert!(said.contains("sig_forall_dec") && !said.contains("formula_"), "{said}");
        }
    }
}

/// A folder with the commands that `check.sh` needs, but for Coq.
#[cfg(unix)]
fn without_coq(place: &Workplace) -> PathBuf {
    let folder = place.path("bin");
    fs::create_dir_all(&folder).unwrap();
    for command in [
        "awk",
        "cat",
        "cp",
        "dirname",
        "find",
        "grep",
        "mkdir",
        "mktemp",
        "paste",
        "rm",
        "sed",
        "sha256sum",
        "sort",
        "tsort",
    ] {
        let paths = std::env::var_os("PATH").unwrap();
        let mut found = std::env::split_paths(&paths).map(|folder| folder.join(command));
        let link = folder.join(command);
        if !link.exists() {
            std::os::unix::fs::symlink(found.find(|path| path.is_file()).unwrap(), link).unwrap();
        }
    }
    folder
}

#[test]
fn a_flipped_byte_anywhere_is_noticed() {
    let place = archived();
    let whole = fs::read(place.path("small.zip")).unwrap();
    // The first header, the packed content, the directory, the end.
    for at in [12, 2_000, whole.len() / 2, whole.len() - 400, whole.len() - 10] {
        let mut altered = whole.clone();
        altered[at] ^= 1;
        place.write("altered.zip", altered);
        let ended = place.run(["replay", "altered.zip"]);
        assert_ne!(ended.code, 0, "byte {at}: {}", ended.stdout);
        assert!(!ended.stderr.is_empty() && !ended.stderr.contains("panicked"), "{}", ended.stderr);
    }
    place.write("cut.zip", &whole[..whole.len() - 100]);
    place.run(["replay", "cut.zip"]).expect_refusal(&["cut.zip: is not a complete zip file"]);
    place.run(["replay", "missing.zip"]).expect_refusal(&["missing.zip"]);
}

/// Alters the files of the archive and seals them again, with fresh digests where `seal` says so.
fn forged(place: &Workplace, seal: bool, alter: impl FnOnce(&mut Files)) {
    let container = fs::read(place.path("small.zip")).unwrap();
    let (mut files, time) = unpack(&container, &Caps::default()).unwrap();
    alter(&mut files);
    if seal {
        self::seal(&mut files);
    }
    place.write("forged.zip", pack(&files, time).unwrap());
}

/// Gives the files fresh digests.
pub fn seal(files: &mut Files) {
    files.remove(DIGESTS_FILE);
    let sums: String = files.iter().map(|(path, bytes)| format!("{}  {path}\n", sha256_hex(bytes))).collect();
    files.insert(DIGESTS_FILE.into(), sums.into_bytes());
}

/// Replaces a text in a file of an archive.
fn replace(files: &mut Files, path: &str, from: &str, to: &str) {
    let text = String::from_utf8(files[path].clone()).unwrap();
    assert!(text.contains(from), "{path} has no {from:?}");
    files.insert(path.into(), text.replace(from, to).into_bytes());
}

/// Replays the forgery, which must fail and say so.
#[track_caller]
fn expect_difference(place: &Workplace, lines: &[&str]) {
    let ended = place.run(["replay", "forged.zip"]);
    assert_eq!(ended.code, 1, "{}{}", ended.stdout, ended.stderr);
    for line in lines {
        assert!(
            ended.stderr.lines().any(|said| said.starts_with(line)),
            "{line:?} is not in:\n{}",
            ended.stderr
        );
    }
}

#[test]
fn an_altered_added_removed_or_renamed_file_is_named() {
    let place = archived();
    forged(&place, false, |files| replace(files, "report/report.md", "Small", "Large"));
    expect_difference(&place, &["report/report.md: its SHA-256 is not the declared one"]);
    forged(&place, false, |files| drop(files.insert("extra.txt".into(), Vec::new())));
    expect_difference(&place, &["extra.txt: not declared"]);
    forged(&place, false, |files| drop(files.remove("CITATION.cff")));
    expect_difference(&place, &["CITATION.cff: declared in SHA256SUMS, but missing"]);
    forged(&place, false, |files| {
        let bytes = files.remove("NOTICE.md").unwrap();
        files.insert("NOTES.md".into(), bytes);
    });
    expect_difference(&place, &["NOTES.md: not declared", "NOTICE.md: declared"]);
}

#[test]
fn a_verdict_is_never_read_from_the_archive() {
    let place = archived();
    forged(&place, true, |files| {
        replace(files, "report/ledger.json", "\"verdict\": \"fails\"", "\"verdict\": \"holds\"");
    });
    expect_difference(&place, &["report/ledger.json:"]);
    forged(&place, true, |files| replace(files, "input/claims.toml", "\"fails\"", "\"holds\""));
    expect_difference(&place, &["B8: recorded holds, now fails"]);
    forged(&place, true, |files| drop(files.insert("report/tables/more.csv".into(), b"x\n".to_vec())));
    expect_difference(&place, &["report/tables/more.csv: archived, but not made by the report"]);
    forged(&place, true, |files| drop(files.insert("input/prose/d.md".into(), b"x\n".to_vec())));
    expect_difference(&place, &["input/prose/d.md: the report does not refer to it"]);
}

#[test]
fn the_stated_time_is_that_of_source_date_epoch_or_none() {
    let place = archived();
    let zip = |path: &str| unpack(&fs::read(place.path(path)).unwrap(), &Caps::default()).unwrap();
    assert_eq!(zip("small.zip").1, ReleaseTime::UNSTATED);
    let archive = |epoch: &str| {
        std::process::Command::new(env!("CARGO_BIN_EXE_slipmode"))
            .args(["archive", "small", "-o", "dated.zip"])
            .env("SOURCE_DATE_EPOCH", epoch)
            .current_dir(place.path(""))
            .output()
            .unwrap()
    };
    assert!(archive("1795243404").status.success());
    let (files, time) = zip("dated.zip");
    assert_eq!(time.to_rfc3339(), "2026-11-21T06:43:24+00:00");
    assert!(String::from_utf8_lossy(&files["ro-crate-metadata.json"]).contains("2026-11-21T06:43:24+00:00"));
    let refused = archive("tomorrow");
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("SOURCE_DATE_EPOCH = tomorrow"));
}

#[test]
fn two_ledgers_are_compared_by_verdict() {
    let place = archived();
    assert_eq!(place.run(["diff", "small.zip", "small.zip"]).expect_success(), "no differences\n");
    place.run(["report", "small", "-o", "out"]).expect_success();
    place.run(["diff", "small.zip", "out/ledger.json"]).expect_success();
    let altered = place.read("out/ledger.json");
    // The first one is the claim's, the next ones are those of its parts.
    let altered = altered.replacen("\"verdict\": \"fails\"", "\"verdict\": \"holds\"", 1);
    place.write("altered.json", altered);
    let ended = place.run(["diff", "out/ledger.json", "altered.json"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (1, "B8: verdict: fails -> holds\n"));
    place.write("empty.json", "");
    place.run(["diff", "empty.json", "out/ledger.json"]).expect_refusal(&["the first is not a ledger"]);
    for forge in [
        |files: &mut Files| replace(files, "report/ledger.json", "\"holds\"", "\"fails\""),
        |files: &mut Files| drop(files.insert(DIGESTS_FILE.into(), files[DIGESTS_FILE].repeat(2))),
    ] {
        forged(&place, false, forge);
        let ended = place.run(["diff", "small.zip", "forged.zip"]);
        let said = ["report/ledger.json: its SHA-256 is not", "SHA256SUMS:"];
        assert!(ended.code == 2 && said.iter().any(|one| ended.stderr.contains(one)), "{}", ended.stderr);
    }
}

#[test]
fn one_claim_is_decided_alone() {
    let place = small_report();
    let said = place.run(["verify", "small", "--claim", "B8"]).expect_success();
    assert!(said.contains("verdict          fails, exact") && said.contains("counter-example"), "{said}");
    assert_eq!(place.names(), ["small"], "nothing is written");
    place
        .run(["verify", "small", "--claim", "b8"])
        .expect_refusal(&["--claim = b8: the report lists no such claim; did you mean B8?"]);
    place
        .run(["verify", "small", "--claim", "N1"])
        .expect_refusal(&["--claim = N1: the report lists no such claim; it is a claim of the paper"]);
    place.run(["verify", "smal"]).expect_refusal(&["smal: no such folder"]);
    place.run(["diff", "small", "small"]).expect_refusal(&["small: is a folder; name a file"]);
    place.write("small/claims.toml", CLAIMS.replace("\"fails\"", "\"holds\""));
    let ended = place.run(["verify", "small", "--claim", "B8"]);
    assert_eq!((ended.code, ended.stderr.trim()), (1, "B8: recorded holds, now fails"));
}
