//! `check.sh` of an archive's theorems refuses a folder that was altered, and names what is at fault.
//!
//! The folder is a small one: a library of one lemma, and one claim. The script is that of every archive, because it takes the names
//! of files and theorems from the lists beside it.

use std::fs;
use std::path::Path;
use std::process::Command;

use slipmode::archive::sha256_hex;

use crate::harness::Workplace;

const LIBRARY: &str = "(** One lemma (* with a comment *). *)\nFrom Coq Require Export Reals Lra.\nOpen Scope R_scope.\n\n\
    Lemma twice (x : R) : x + x = 2 * x.\nProof. ring. Qed.\n";

const CLAIM: &str = "From Slipmode Require Import Claims.\nSet Default Timeout 300.\n\n(** S1, formula-s1 *)\n\
    Theorem formula_00112233aabbccdd (x : R) (x'pos : 0 < x) :\n  0 < x + x.\nProof. rewrite twice; lra. Qed.\n\n\
    Definition all_theorems := (formula_00112233aabbccdd).\nPrint Assumptions all_theorems.\n";

const LIBRARY_FILE: &str = "library/Claims.v";

const CLAIM_FILE: &str = "small/claim_S1_whole.v";

const THEOREM: &str = "formula_00112233aabbccdd";

/// The folder with a library and a claim, and with the lists for them.
struct Theorems(Workplace);

impl Theorems {
    fn new() -> Self {
        let place = Self(Workplace::new());
        place.0.write("check.sh", include_str!("../../proofs/check.sh"));
        place.0.write("README.md", "");
        place.with(LIBRARY_FILE, LIBRARY).with(CLAIM_FILE, CLAIM).with_files().with_accepted()
    }

    fn with(self, path: &str, text: &str) -> Self {
        self.0.write(path, text);
        self
    }

    /// A file with one text in the place of another.
    fn altered(self, path: &str, from: &str, to: &str) -> Self {
        let text = self.0.read(path);
        assert!(text.contains(from), "{from:?} is not in {path}");
        self.with(path, &text.replacen(from, to, 1))
    }

    /// The list of files as they are.
    fn with_files(self) -> Self {
        let line = |path: &str| format!("{}  {path}\n", sha256_hex(self.0.read(path).as_bytes()));
        let lines = [CLAIM_FILE, LIBRARY_FILE].map(line).concat();
        self.with("files.txt", &lines)
    }

    /// The list of what Coq accepted, as if that were the files as they are.
    fn with_accepted(self) -> Self {
        let text = self.0.read(CLAIM_FILE);
        let (_, rest) = text.split_once(&format!("Theorem {THEOREM}")).unwrap();
        let stated = rest.split_once(".\n").unwrap().0;
        let line = |path: &str| format!("{path} {}\n", sha256_hex(self.0.read(path).as_bytes()));
        let lines = format!(
            "{THEOREM} {}\n{}",
            sha256_hex(stated.as_bytes()),
            [LIBRARY_FILE, CLAIM_FILE].map(line).concat()
        );
        self.with("accepted.txt", &lines)
    }

    fn accepted_sha256(&self) -> String {
        sha256_hex(self.0.read("accepted.txt").as_bytes())
    }

    /// The exit code, and what was said last.
    fn check(&self, arguments: &[&str]) -> (i32, String) {
        let output = Command::new("sh").arg(self.0.path("check.sh")).args(arguments).output().unwrap();
        let said = [output.stdout, output.stderr].concat();
        (output.status.code().unwrap(), String::from_utf8(said).unwrap())
    }

    /// The check ends with exit code 1 and names all of this.
    #[track_caller]
    fn expect_refusal(&self, parts: &[&str]) {
        let (code, said) = self.check(&[]);
        let last = said.lines().last().unwrap_or_default();
        assert!(code == 1 && parts.iter().all(|part| last.contains(part)), "{code}, {parts:?}: {said}");
    }
}

/// Whether Coq is there; a machine without it proves nothing.
fn has_coq() -> bool {
    Command::new("coqc").arg("--version").output().is_ok_and(|output| output.status.success())
}

#[test]
fn a_sound_folder_is_accepted_relative_to_a_list_of_known_digest() {
    let folder = Theorems::new();
    let sha256 = folder.accepted_sha256();
    let (code, said) = folder.check(&[&sha256]);
    assert!(said.contains(&format!("accepted.txt has the SHA-256 {sha256}\n")), "{said}");
    assert_eq!(code, if has_coq() { 0 } else { 2 }, "{said}");
    if has_coq() {
        assert!(
            said.contains("Coq accepts all 1 theorems.") && said.contains("\n0 of them are not in"),
            "{said}"
        );
        assert!(!Path::new(&folder.0.path("library/Claims.vo")).exists(), "the folder stays as it is");
    }
    let (code, said) = folder.check(&[&sha256_hex(b"another list")]);
    assert!(code == 1 && said.contains("accepted.txt does not have the SHA-256"), "{said}");
}

#[test]
fn an_altered_statement_or_proof_is_refused_with_the_name_of_the_theorem() {
    let admitted = |folder: Theorems| {
        let false_too = folder.altered(CLAIM_FILE, "\n  0 < x + x", "\n  False /\\ 0 < x + x");
        false_too.altered(CLAIM_FILE, "Proof. rewrite twice; lra. Qed.", "Admitted.")
    };
    // However much of the lists was altered with it, a theorem without a proof is none.
    admitted(Theorems::new()).expect_refusal(&[CLAIM_FILE, THEOREM, "Admitted"]);
    admitted(Theorems::new()).with_files().expect_refusal(&[CLAIM_FILE, THEOREM, "Admitted"]);
    admitted(Theorems::new()).with_files().with_accepted().expect_refusal(&[CLAIM_FILE, THEOREM, "Admitted"]);
    Theorems::new()
        .altered(CLAIM_FILE, "lra. Qed.", "lra. Admitted (* Qed. *).")
        .with_files()
        .with_accepted()
        .expect_refusal(&[CLAIM_FILE, THEOREM, "Admitted"]);
    // Another statement with its own proof is a theorem, but not the accepted one.
    let other = |folder: Theorems| {
        folder.altered(CLAIM_FILE, "  0 < x + x", "  0 < x").altered(CLAIM_FILE, "rewrite twice; lra", "lra")
    };
    other(Theorems::new()).expect_refusal(&[THEOREM, "does not state what accepted.txt lists"]);
    other(Theorems::new()).with_files().expect_refusal(&[THEOREM, "does not state what accepted.txt lists"]);
    // With the list altered too, the digest of the list is another one.
    let known = Theorems::new().accepted_sha256();
    let (code, said) = other(Theorems::new()).with_files().with_accepted().check(&[&known]);
    assert!(code == 1 && said.contains("accepted.txt does not have the SHA-256"), "{said}");
}

#[test]
fn a_sentence_that_assumes_or_changes_how_others_are_read_is_refused_wherever_it_stands() {
    let of_library = |sentence: &str| {
        let library = format!("{LIBRARY}{sentence}\n");
        Theorems::new().with(LIBRARY_FILE, &library).with_files().with_accepted()
    };
    for sentence in [
        "Axiom bad : False.",
        "Parameter bad : False.",
        "Conjecture bad : False.",
        "Lemma bad : False. Proof. admit. Admitted.",
        "Unset Guard Checking.",
        "Set Bullet Behavior None.",
        "Notation \"x < y\" := True.",
        "Infix := plus.",
        "Declare ML Module other.",
        "#[bypass_check(guard)] Fixpoint bad (n : nat) : False := bad n.",
        "Require Import Other.",
        "From Other Require Import All.",
        "(* \" *) Axiom bad : False. (* \" *)",
        "(* a comment that does not end",
        "Goal False. Abort.",
    ] {
        of_library(sentence).expect_refusal(&[LIBRARY_FILE]);
    }
    for (from, to) in [
        ("(** S1, formula-s1 *)", "Lemma twice : True. Proof. exact I. Qed."),
        ("(** S1, formula-s1 *)", "Definition R := nat."),
        ("Print Assumptions all_theorems", "Print Assumptions twice"),
        ("Set Default Timeout 300", "Unset Universe Checking"),
    ] {
        let altered = Theorems::new().altered(CLAIM_FILE, from, to).with_files().with_accepted();
        altered.expect_refusal(&[CLAIM_FILE]);
    }
}

/// The names of the lemmas that the program writes beside the theorems of a report are those that the check allows.
#[test]
fn lemmas_of_a_report_have_names_that_hide_nothing() {
    let source = [
        include_str!("../../crates/algebra/src/coq/growth_right.v"),
        include_str!("../../crates/algebra/src/coq/root_part.v"),
    ]
    .concat();
    let names = source.split("Lemma ").skip(1).map(|rest| rest.split(' ').next().unwrap());
    let mut names: Vec<&str> = names.collect();
    names.sort_unstable();
    let check = include_str!("../../proofs/check.sh");
    let own = check.split_once("\nown='").unwrap().1.split_once('\'').unwrap().0;
    let mut allowed: Vec<&str> = own.split(' ').collect();
    allowed.sort_unstable();
    assert_eq!(names, allowed);
    let with = |text: &str| {
        Theorems::new().altered(CLAIM_FILE, "(** S1, formula-s1 *)", text).with_files().with_accepted()
    };
    let stated = |word: &str, name: &str| format!("{word} {name} : True. Proof. exact I. Qed.\n");
    let lemmas: String = names.iter().map(|name| stated("Lemma", name)).collect();
    let (code, said) = with(&lemmas).check(&[]);
    assert_eq!(code, if has_coq() { 0 } else { 2 }, "{said}");
    for name in names {
        with(&stated("Theorem", name)).expect_refusal(&[CLAIM_FILE, name, "may hide another one"]);
    }
}

#[test]
fn a_file_that_is_missing_added_or_listed_otherwise_is_refused_by_name() {
    let removed = Theorems::new();
    fs::remove_file(removed.0.path(CLAIM_FILE)).unwrap();
    removed.expect_refusal(&[CLAIM_FILE, "is missing"]);
    // Taken out of the list of files too, it is still in the list of what was accepted.
    let lines = removed.0.read("files.txt");
    let kept: String =
        lines.lines().filter(|line| line.contains(LIBRARY_FILE)).map(|line| format!("{line}\n")).collect();
    fs::create_dir_all(removed.0.path("small")).unwrap();
    removed.with("files.txt", &kept).with("small/claim_S3.v", CLAIM).expect_refusal(&["small/claim_S"]);
    Theorems::new().with("small/claim_S2.v", CLAIM).expect_refusal(&["small/claim_S2.v is not in"]);
    Theorems::new().with("library/Claims.vo", "").expect_refusal(&["library/Claims.vo does not belong"]);
    Theorems::new().with("notes.txt", "").expect_refusal(&["notes.txt does not belong"]);
    for list in ["accepted.txt", "files.txt"] {
        let folder = Theorems::new();
        let text = folder.0.read(list);
        let digest = sha256_hex(CLAIM.as_bytes());
        let other = sha256_hex(b"other");
        folder.with(list, &text.replace(&digest, &other)).expect_refusal(&[CLAIM_FILE, list]);
        let missing = Theorems::new();
        fs::remove_file(missing.0.path(list)).unwrap();
        missing.expect_refusal(&[list, "is missing"]);
    }
    let folder = Theorems::new();
    let text = folder.0.read("accepted.txt");
    let line = text.lines().find(|line| line.starts_with(THEOREM)).unwrap();
    let altered = text.replace(line, &format!("{THEOREM} {}", sha256_hex(b"other")));
    folder.with("accepted.txt", &altered).expect_refusal(&[THEOREM, "does not state"]);
}

#[test]
fn coq_has_the_last_word_on_proofs_and_assumptions() {
    if !has_coq() {
        return;
    }
    let wrong = Theorems::new().altered(CLAIM_FILE, "rewrite twice; lra", "exact I");
    wrong.with_files().with_accepted().expect_refusal(&[CLAIM_FILE, "Coq does not accept it"]);
    // A file at fault does not end the check: all are listed at its end.
    let both = Theorems::new().altered(LIBRARY_FILE, "Proof. ring. Qed.", "Proof. exact I. Qed.");
    let (code, said) = both.with_files().with_accepted().check(&[]);
    let list = [LIBRARY_FILE, CLAIM_FILE].map(|file| format!("check.sh: {file}: Coq does not accept it\n"));
    let list = format!("check.sh: 2 of 2 files are refused:\n{}", list.concat());
    assert!(code == 1 && said.ends_with(&list) && !said.contains("Coq accepts all"), "{said}");
    // A variable outside of a section is an axiom; the file's own list of assumptions is about something else.
    let library =
        format!("{LIBRARY}Variable bad : False.\nTheorem other : 0 = 1.\nProof. destruct bad. Qed.\n");
    let assumed = Theorems::new().with(LIBRARY_FILE, &library).with_files().with_accepted();
    assumed.expect_refusal(&[LIBRARY_FILE, "other: assumes more", "bad"]);
}
