//! The certified steps of ledgers as files for Coq: one theorem per distinct step, in the file of the first claim that has it; and
//! the formulas of claims as whole theorems.
//!
//! A ledger is read as the text that was published, so that the theorems are about the very certificates that it shows.

mod archived;
mod ties;

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use slipmode_algebra::coq::Theorem;
use slipmode_algebra::{Certificate, Proof};
use slipmode_theory::Equations;

use crate::claims::{self, Conclusion, PROVED, Strength, TIES, WholeTheorem, statement_digest};
use crate::scene::ClaimEntry;

pub use archived::{archived, file_list};
pub use ties::ties;

/// A ledger of which only the proofs are read.
#[derive(Debug, Deserialize)]
struct Ledger {
    claims: Vec<Claim>,
}

#[derive(Debug, Deserialize)]
struct Claim {
    id: String,
    #[serde(flatten)]
    conclusion: Conclusion,
    strength: Option<Strength>,
    evidence: Vec<Evidence>,
}

#[derive(Debug, Deserialize)]
struct Evidence {
    proof: Option<Proof>,
}

/// A report with its published ledger.
#[derive(Debug)]
pub struct Published {
    /// The report's name.
    pub name: String,
    /// The ledger as it was published, in JSON.
    pub ledger: Vec<u8>,
    /// The report's claims.
    pub claims: Vec<ClaimEntry>,
    /// The equations in which they are stated.
    pub equations: Equations,
}

/// The list of steps: what became of each step of each proof.
pub const STEPS_FILE: &str = "steps.tsv";

/// The first line of the list.
const COLUMNS: &str = "report\tclaim\tproof\tstep\tkind\ttheorem\tdigest\tobstacle\n";

/// The largest theorem that Coq is given: with 210 000 characters it takes more than five minutes.
const LARGEST_THEOREM_BYTES: usize = 60_000;

/// The bytes of theorems after which a claim's next theorem begins another file, so that files are checked side by side.
const LARGE_FILE_BYTES: usize = 30_000;

/// A theorem's name and the digest of its statement, or the obstacle.
type Outcome = Result<[String; 2], String>;

/// Theorems and altered theorems in the making, and where each distinct certificate stands.
#[derive(Debug, Default)]
struct Files {
    texts: BTreeMap<String, String>,
    known: Vec<(Certificate, Outcome)>,
    wholes: BTreeSet<String>,
    steps: String,
}

/// The files of these reports' ledgers, and of further proofs that commands rest on and no ledger shows, with a name.
///
/// # Errors
/// When a text is no ledger.
pub fn files(reports: &[Published], further: (&str, Vec<Proof>)) -> Result<BTreeMap<String, String>, String> {
    let mut files = Files { steps: COLUMNS.to_owned(), ..Files::default() };
    for report in reports {
        for claim in &report.ledger()?.claims {
            files.add_claim(report, claim);
        }
    }
    let (name, proofs) = further;
    files.add(name, "proofs", proofs.iter());
    files.texts.insert(STEPS_FILE.to_owned(), files.steps);
    Ok(files.texts)
}

impl Published {
    fn ledger(&self) -> Result<Ledger, String> {
        serde_json::from_slice(&self.ledger).map_err(|error| format!("{}: {error}", self.name))
    }
}

impl Files {
    /// A claim of a ledger: the steps of its proofs, and the theorems that state it whole.
    fn add_claim(&mut self, report: &Published, claim: &Claim) {
        let Published { name, claims, equations, .. } = report;
        self.add(name, &claim.id, claim.evidence.iter().filter_map(|evidence| evidence.proof.as_ref()));
        let stated = claims.iter().find(|known| known.id == claim.id);
        if !PROVED.contains(&claim.strength) {
            return;
        }
        self.add_whole(name, claim, stated, equations);
        let Some(stated) = stated else { return };
        match stated.stated.as_ref().and_then(|stated| stated.argued.as_ref()) {
            // The step in words from the formulas to what the claim says.
            Some(step) => self.list([name, &claim.id, "words", "whole"], "argued", Err(step.clone())),
            None => self.add_by_hand(name, claim, stated, equations),
        }
    }

    /// A line of the list of steps.
    fn list(&mut self, [report, claim, proof, step]: [&str; 4], kind: &str, outcome: Outcome) {
        let (names, obstacle) =
            outcome.map_or_else(|obstacle| (<_>::default(), obstacle), |names| (names, String::new()));
        let [theorem, digest] = &names;
        let cells = [report, claim, proof, step, kind, theorem, digest, &obstacle];
        self.steps += &(cells.map(one_line).join("\t") + "\n");
    }

    /// The steps of proofs, in the files of a claim.
    fn add<'a>(&mut self, report: &str, claim: &str, proofs: impl Iterator<Item = &'a Proof>) {
        let mut open = OpenFile::default();
        let mut number = 1;
        for proof in proofs {
            for (step, index) in proof.steps.iter().zip(1..) {
                let words = format!("{}, {}, step {index}: {}", claim, proof.statement, step.says);
                let outcome = match &step.certificate {
                    Some(certificate) => self.theorem(certificate, &words, &mut open),
                    None => Err("a step of plain reasoning has no certificate".to_owned()),
                };
                let kind = step.certificate.as_ref().map_or("argued", Certificate::kind);
                self.list([report, claim, &proof.id, &index.to_string()], kind, outcome);
                if open.text.len() > LARGE_FILE_BYTES {
                    self.close(&place(report, claim, number), &mut open);
                    number += 1;
                }
            }
        }
        self.close(&place(report, claim, number), &mut open);
    }

    /// The claim's formulas as whole theorems, in a file of their own with the steps that they use.
    fn add_whole(&mut self, report: &str, claim: &Claim, stated: Option<&ClaimEntry>, equations: &Equations) {
        let proofs = || claim.evidence.iter().filter_map(|evidence| evidence.proof.as_ref());
        let proof = |id: &str| proofs().find(|proof| proof.id == id);
        let mut found = stated.map_or(Vec::new(), |stated| claims::whole_theorems(stated, equations, proof));
        let others = proofs().filter(|proof| found.iter().all(|(id, _)| *id != proof.id));
        let no_formula = "a proof or a procedure decides it, not a formula";
        let others: Vec<_> = others.map(|proof| (proof.id.clone(), Err(no_formula.to_owned()))).collect();
        found.extend(others);
        if found.is_empty() {
            found.push((String::new(), Err("a point decides it, without a proof".to_owned())));
        }
        // One theorem a file: one that Coq refuses takes no other with it.
        for ((id, result), number) in found.into_iter().zip(1..) {
            let mut open = OpenFile::default();
            let outcome = result.map(|whole| {
                if self.wholes.insert(whole.name.clone()) {
                    open.add_whole(&whole, &format!("{}, {id}", claim.id));
                }
                [whole.name, whole.digest]
            });
            self.list([report, &claim.id, &id, "whole"], "whole", outcome);
            self.close(&format!("{}_whole", place(report, &claim.id, number)), &mut open);
        }
    }

    /// The theorems written by hand that state the claim.
    fn add_by_hand(&mut self, report: &str, claim: &Claim, stated: &ClaimEntry, equations: &Equations) {
        let digest = claims::sha256_hex(&claims::resolved_claim(stated, equations));
        let tied = claim.tied(&digest);
        let line = [report, &claim.id, "by hand", "whole"];
        if let Some(tie) = TIES.iter().find(|tie| tie.is_about(&tied, equations)) {
            for name in tie.names() {
                self.list(line, "by hand", Ok([name.to_owned(), tie.digest.clone()]));
            }
        } else if TIES.iter().any(|tie| tie.report == report && tie.claim == claim.id) {
            let obstacle =
                "proofs/claims.csv has another digest: read both, then `cargo xtask tie` writes it";
            self.list(line, "by hand", Err(obstacle.to_owned()));
        }
    }

    /// The theorem of a certificate: the known one, or a new one in the open file.
    fn theorem(&mut self, certificate: &Certificate, words: &str, open: &mut OpenFile) -> Outcome {
        if let Some((_, known)) = self.known.iter().find(|(known, _)| known == certificate) {
            return known.clone();
        }
        let made = Theorem::of(certificate).map_err(|obstacle| obstacle.to_string());
        let result = made.and_then(|theorem| {
            let length = theorem.text.len();
            if length > LARGEST_THEOREM_BYTES {
                return Err(format!("Coq would take minutes: the theorem has {length} characters"));
            }
            open.add(&theorem, words);
            let digest = statement_digest(&theorem);
            Ok([theorem.name, digest])
        });
        self.known.push((certificate.clone(), result.clone()));
        result
    }

    fn close(&mut self, place: &str, open: &mut OpenFile) {
        let OpenFile { text, faults, names, .. } = std::mem::take(open);
        if names.is_empty() {
            return;
        }
        let all = names.join(", ");
        let assumptions = format!("Definition all_theorems := ({all}).\nPrint Assumptions all_theorems.\n");
        // The lemmas on signs are no part of the files that do without them, whose record stays.
        let module =
            if ["by_signs", "; met."].iter().any(|used| text.contains(used)) { "Signs" } else { "Claims" };
        let head = format!("From Slipmode Require Import {module}.\n{LIMIT}");
        self.texts.insert(format!("{place}.v"), format!("{head}{text}{assumptions}"));
        self.texts.insert(format!("{place}_faults.v"), format!("{head}{faults}"));
    }
}

/// A time limit in seconds for each lemma.
const LIMIT: &str = "Set Default Timeout 300.\n\n";

/// A file that grows.
#[derive(Debug, Default)]
struct OpenFile {
    text: String,
    faults: String,
    names: Vec<String>,
    lemmas: BTreeSet<String>,
}

impl OpenFile {
    fn add_once(&mut self, name: &str, text: &str) {
        if self.lemmas.insert(name.to_owned()) {
            self.text += &format!("{text}\n");
            self.faults += &format!("{text}\n");
        }
    }

    fn add(&mut self, theorem: &Theorem, words: &str) {
        theorem.lemmas.iter().for_each(|lemma| self.add_once(&lemma.name, &lemma.text));
        self.text += &format!("(** {} *)\n{}\n", comment(words), theorem.text);
        self.faults += &format!("{}\n", theorem.fault);
        self.names.push(theorem.name.clone());
    }

    /// A whole theorem after the steps that it uses, which are lemmas here and theorems in the file of their own claim.
    fn add_whole(&mut self, whole: &WholeTheorem, words: &str) {
        for step in &whole.steps {
            step.lemmas.iter().for_each(|lemma| self.add_once(&lemma.name, &lemma.text));
            self.add_once(&step.name, &step.text.replace("Theorem ", "Lemma "));
        }
        let WholeTheorem { name, statement, proof, altered, .. } = whole;
        self.text +=
            &format!("(** {} *)\nTheorem {name}{statement}.\nProof. {proof}. Qed.\n\n", comment(words));
        self.faults += &format!(
            "Lemma fault_{name}{altered}.\nProof. tryif (solve [{proof}]) then fail 0 \"accepted\" else idtac \"refused {name}\". Abort.\n\n"
        );
        self.names.push(name.clone());
    }
}

/// Where a claim's file stands, without its ending: Coq wants letters, digits and low lines.
fn place(report: &str, claim: &str, number: usize) -> String {
    let letters: String = claim.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let number = if number > 1 { format!("_{number}") } else { String::new() };
    format!("{report}/claim_{letters}{number}")
}

/// Words that end no comment and begin no text inside it.
fn comment(words: &str) -> String {
    words.replace('"', "'").replace("(*", "( *").replace("*)", "* )")
}

fn one_line(text: &str) -> String {
    text.replace(['\t', '\n', '\r'], " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: (&str, Vec<Proof>) = ("", Vec::new());

    fn published(ledger: Vec<u8>) -> [Published; 1] {
        let equations = include_bytes!("../../reports/im-avouac/equations.toml");
        let equations = crate::scene::read_equations("equations.toml", equations).unwrap();
        [Published { name: "r".to_owned(), ledger, claims: Vec::new(), equations }]
    }

    fn ledger(right: &str) -> Vec<u8> {
        let certificate = format!(
            r#"{{"kind": "identity", "left": "(x + y)^2", "right": "{right}",
            "domain": {{"positive": ["x", "y"], "substitutions": []}}}}"#
        );
        let step = format!(
            r#"{{"says": "a (*square*) of \"a\" sum", "equations": [], "certificate": {certificate}}}"#
        );
        let argued = r#"{"says": "so it is", "equations": [], "certificate": null}"#;
        let proof =
            format!(r#"{{"id": "binomial", "statement": "A formula.", "steps": [{step}, {argued}]}}"#);
        let claim = |id: &str| {
            format!(
                r#"{{"id": "{id}", "verdict": "holds", "strength": "argued", "evidence": [{{"kind": "proof", "proof": {proof}}}, {{"kind": "sample"}}]}}"#
            )
        };
        format!(r#"{{"claims": [{}, {}]}}"#, claim("A1"), claim("A-2")).into_bytes()
    }

    #[test]
    fn a_step_of_several_claims_is_one_theorem_and_a_changed_formula_changes_its_statement() {
        let made = files(&published(ledger("x^2 + 2*x*y + y^2")), NONE).expect("a ledger");
        assert_eq!(
            made.keys().map(String::as_str).collect::<Vec<_>>(),
            ["r/claim_A1.v", "r/claim_A1_faults.v", STEPS_FILE]
        );
        let text = &made["r/claim_A1.v"];
        assert!(text.contains("((x + y) ^ 2) = ((x ^ 2) + (2 * x * y) + (y ^ 2))"), "{text}");
        assert!(text.contains("(** A1, A formula., step 1: a ( *square* ) of 'a' sum *)"), "{text}");
        let steps: Vec<Vec<&str>> = made[STEPS_FILE].lines().map(|line| line.split('\t').collect()).collect();
        assert!(steps.len() == 7 && steps[1][5].starts_with("identity_") && steps[1][5..] == steps[4][5..]);
        assert_eq!(steps[3][4..], ["whole", "", "", "a proof or a procedure decides it, not a formula"]);
        assert_eq!(steps[2][4..], ["argued", "", "", "a step of plain reasoning has no certificate"]);
        let other = files(&published(ledger("x^2 + 3*x*y + y^2")), NONE).expect("a ledger");
        assert!(
            other["r/claim_A1.v"].contains("(3 * x * y)") && !other["r/claim_A1.v"].contains("(2 * x * y)")
        );
        assert!(files(&published(b"{}".to_vec()), NONE).is_err());
    }
}
