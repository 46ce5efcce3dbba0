//! What was proved: theorems, steps by kind with their obstacles, and assumptions.

use std::collections::{BTreeMap, BTreeSet};

use super::assumptions::{listed, refused};
use super::{Mode, Said, Task};
use crate::failure::Failure;

/// Prints the counts. The list of accepted theorems.
///
/// # Errors
/// When theorems assume too much, or an altered one was not refused. A theorem that is not accepted is named, and not in the list.
pub fn print(steps: &Steps, checked: &[(Task, Said)], mode: Mode) -> Result<String, Failure> {
    let (mut faults, mut axioms, mut proved) = (Vec::new(), BTreeMap::new(), BTreeSet::new());
    for (Task { file, theorems, .. }, said) in checked {
        let judged = match said {
            Err(message) if mode == Mode::Proofs => {
                println!("not accepted: {file}: {message}");
                continue;
            }
            Err(message) => Err(message.clone()),
            Ok(output) if mode == Mode::Faults => refusals(output, theorems),
            Ok(output) => assumed(output),
        };
        match judged {
            Ok(list) => {
                *axioms.entry(list).or_insert(0) += theorems.len();
                proved.extend(theorems.iter().map(String::as_str));
            }
            Err(message) => faults.push(format!("{file}: {message}")),
        }
    }
    let all: usize = checked.iter().map(|(task, _)| task.theorems.len()).sum();
    if mode == Mode::Proofs {
        print!("{}", steps.coverage(&proved));
        for (list, count) in axioms {
            println!("prove: each of {count} theorems assumes {list}");
        }
        println!("prove: Coq accepted {} of {all} theorems in {} files", proved.len(), checked.len());
    } else {
        println!(
            "prove: Coq refused {} of {all} altered theorems, none of them by a time limit",
            proved.len()
        );
    }
    if faults.is_empty() { Ok(steps.record(&proved)) } else { Err(Failure::check(faults.join("\n"))) }
}

/// What the theorems of a file assume at most.
fn assumed(output: &str) -> Result<String, String> {
    let list = listed(output).ok_or("Coq has not listed what the theorems assume")?;
    match refused(&list)[..] {
        [] if list.is_empty() => Ok("nothing".to_owned()),
        [] => Ok(format!("at most {}", list.join(", "))),
        [axiom, ..] => Err(format!("a theorem assumes {axiom}")),
    }
}

/// Each altered theorem was refused: Coq says so of it. A time limit ends the whole file.
fn refusals(output: &str, theorems: &[String]) -> Result<String, String> {
    let said: BTreeSet<&str> = output.lines().filter_map(|line| line.strip_prefix("refused ")).collect();
    match theorems.iter().find(|name| !said.contains(name.trim_start_matches("fault_"))) {
        Some(name) => Err(format!("{name} was not refused")),
        None => Ok(String::new()),
    }
}

/// The list of steps that the program writes: what became of each step of each proof.
pub struct Steps(Vec<[String; 8]>);

impl Steps {
    /// Reads the list.
    ///
    /// # Errors
    /// When a line has another number of fields.
    pub fn read(text: &str) -> Result<Self, Failure> {
        let lines = text.lines().skip(1).map(|line| {
            let fields: Vec<String> = line.split('\t').map(str::to_owned).collect();
            fields.try_into().map_err(|_| Failure::check(format!("steps.tsv: {line}")))
        });
        lines.collect::<Result<_, _>>().map(Self)
    }

    /// Accepted theorems of steps, each with the digest of its certificate.
    fn record(&self, proved: &BTreeSet<&str>) -> String {
        let lines: BTreeSet<String> = self
            .0
            .iter()
            .filter(|[.., theorem, _, _]| proved.contains(theorem.as_str()))
            .map(|[.., theorem, digest, _]| format!("{theorem} {digest}\n"))
            .collect();
        lines.into_iter().collect()
    }

    /// A line for each kind of step, and one for each step without a theorem that Coq accepted.
    fn coverage(&self, proved: &BTreeSet<&str>) -> String {
        let (mut kinds, mut open) = (BTreeMap::new(), String::new());
        let mut claims: BTreeMap<[&str; 2], [&'static str; 2]> = BTreeMap::new();
        for [report, claim, proof, step, kind, theorem, _, obstacle] in &self.0 {
            let is_proved = proved.contains(theorem.as_str());
            let [steps, whole] = claims.entry([report, claim]).or_insert(["by steps", ""]);
            match kind.as_str() {
                "whole" if !is_proved => *whole = "open",
                "whole" if whole.is_empty() => *whole = "whole",
                "argued" => *steps = "argued",
                _ if !is_proved && kind != "whole" => *steps = "not all steps",
                _ => {}
            }
            let counts: &mut [usize; 2] = kinds.entry(kind).or_default();
            counts[0] += usize::from(is_proved);
            counts[1] += 1;
            if !is_proved {
                let why = if theorem.is_empty() { obstacle } else { "Coq did not accept it" };
                open += &format!("not proved: {report} {claim}, {proof}, step {step} ({kind}): {why}\n");
            }
        }
        let mut text = String::new();
        for (kind, [done, all]) in &kinds {
            text += &format!("{kind:<12} {done:>4} of {all:>4} steps\n");
        }
        text += &open;
        // A claim without a line on whole theorems is decided by computations besides.
        let exact: Vec<&[&'static str; 2]> = claims.values().filter(|[_, whole]| !whole.is_empty()).collect();
        text += &format!("claims decided by proofs alone: {}, of which\n", exact.len());
        let best = |[steps, whole]: &[&'static str; 2]| if *whole == "whole" { *whole } else { *steps };
        for word in ["whole", "by steps", "argued", "not all steps"] {
            let count = exact.iter().filter(|claim| best(claim) == word).count();
            text += &format!("{count:>4} {word}\n");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: &str = "report\tclaim\tproof\tstep\tkind\ttheorem\tdigest\tobstacle\n\
        r\tS1\tp\t1\tidentity\tidentity_1\t00ff\t\n\
        r\tS1\tp\t2\targued\t\t\tno certificate\n\
        r\tS1\tp\twhole\twhole\t\t\tno formula\n\
        r\tS2\tp\t1\tidentity\tidentity_1\t00ff\t\n\
        r\tS2\tp\twhole\twhole\tidentity_1\t00ff\t\n\
        r\tS3\tp\t1\tidentity\tidentity_1\t00ff\t\n";

    fn result(output: Said, mode: Mode) -> Result<String, Failure> {
        let task = Task {
            file: "r/claim_S1".into(),
            text: String::new(),
            theorems: vec![if mode == Mode::Faults { "fault_1" } else { "identity_1" }.into()],
        };
        print(&Steps::read(STEPS).unwrap(), &[(task, output)], mode)
    }

    #[test]
    fn steps_are_counted_by_kind_and_those_without_a_theorem_are_named() {
        let steps = Steps::read(STEPS).unwrap();
        let text = steps.coverage(&BTreeSet::from(["identity_1"]));
        assert!(text.contains("identity        3 of    3 steps"), "{text}");
        assert!(text.contains("not proved: r S1, p, step 2 (argued): no certificate\n"), "{text}");
        let table = "proofs alone: 2, of which\n   1 whole\n   0 by steps\n   1 argued\n   0 not all steps\n";
        assert!(text.ends_with(table), "{text}");
        let nothing = steps.coverage(&BTreeSet::new());
        assert!(nothing.contains("r S2, p, step 1 (identity): Coq did not accept it"), "{nothing}");
        assert!(
            nothing.ends_with("   0 whole\n   0 by steps\n   1 argued\n   1 not all steps\n"),
            "{nothing}"
        );
        assert_eq!(steps.record(&BTreeSet::new()), "");
        assert!(Steps::read("a\nb\tc\n").is_err());
    }

    #[test]
    fn a_file_without_a_list_of_assumptions_or_with_a_strange_axiom_fails() {
        let clean = result(Ok("Closed under the global context\n".into()), Mode::Proofs);
        assert_eq!(clean.unwrap(), "identity_1 00ff\n");
        assert!(result(Ok(String::new()), Mode::Proofs).is_err());
        assert!(result(Ok("Axioms:\nmine : False\n".into()), Mode::Proofs).is_err());
        assert_eq!(result(Err("Timeout!".into()), Mode::Proofs).unwrap(), "");
    }

    #[test]
    fn an_altered_theorem_must_be_refused_and_in_time() {
        assert!(result(Ok("refused 1\n".into()), Mode::Faults).is_ok());
        assert!(result(Ok("refused 2\n".into()), Mode::Faults).is_err());
        assert!(result(Err("Timeout!".into()), Mode::Faults).is_err());
    }
}
