//! What was proved: theorems, steps by kind with their obstacles, and assumptions.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use super::assumptions::{listed, refused};
use super::{Checked, Mode};
use crate::failure::Failure;

/// Prints the counts.
///
/// # Errors
/// When a file was not accepted, a theorem assumes too much, or an altered one was not refused.
pub fn print(steps: &str, checked: &[Checked], mode: Mode, time: Duration) -> Result<(), Failure> {
    let mut faults = Vec::new();
    for Checked { file, output, .. } in checked {
        faults.extend(output.as_ref().err().map(|message| format!("{file}: {message}")));
    }
    let seconds = time.as_secs_f64();
    if mode == Mode::Proofs {
        let (theorems, lists) = proved(checked, &mut faults);
        println!("{}", coverage(steps, &theorems));
        for (list, count) in lists {
            println!(
                "prove: {count} theorems assume {}",
                if list.is_empty() { "nothing".into() } else { list }
            );
        }
        println!("prove: {} theorems in {} files, {seconds:.0} s", theorems.len(), checked.len());
    } else {
        let count = refusals(checked, &mut faults);
        println!("prove: {count} altered theorems refused, none of them by a time limit, {seconds:.0} s");
    }
    if faults.is_empty() { Ok(()) } else { Err(Failure::check(faults.join("\n"))) }
}

/// The theorems that Coq accepted, and how many have which assumptions.
fn proved(checked: &[Checked], faults: &mut Vec<String>) -> (BTreeSet<String>, BTreeMap<String, usize>) {
    let (mut theorems, mut lists) = (BTreeSet::new(), BTreeMap::new());
    for Checked { file, output, theorems: names } in checked {
        let Ok(output) = output else { continue };
        let assumed = listed(output);
        if assumed.len() != names.len() {
            faults.push(format!(
                "{file}: {} lists of assumptions for {} theorems",
                assumed.len(),
                names.len()
            ));
        }
        for (name, mut list) in names.iter().zip(assumed) {
            for axiom in refused(&list) {
                faults.push(format!("{file}: {name} assumes {axiom}"));
            }
            list.sort();
            *lists.entry(list.join(", ")).or_insert(0) += 1;
            theorems.insert(name.clone());
        }
    }
    (theorems, lists)
}

/// A line for each kind of step, and one for each obstacle.
fn coverage(steps: &str, proved: &BTreeSet<String>) -> String {
    // Distinct steps: a theorem is one however many claims rest on it.
    let (mut kinds, mut obstacles) = (BTreeMap::new(), BTreeMap::new());
    let mut claims: BTreeMap<(&str, &str), bool> = BTreeMap::new();
    for line in steps.lines().skip(1) {
        let fields: Vec<&str> = line.split('\t').collect();
        let [report, claim, _, _, kind, theorem, _, obstacle] = fields[..] else { continue };
        let is_proved = proved.contains(theorem);
        *claims.entry((report, claim)).or_insert(true) &= is_proved;
        let kind: &mut (BTreeSet<&str>, BTreeSet<&str>, usize) = kinds.entry(kind).or_default();
        kind.2 += usize::from(!is_proved);
        if is_proved {
            kind.0.insert(theorem);
        } else {
            kind.1.insert(theorem);
            let why = if theorem.is_empty() { obstacle } else { "Coq refused the theorem" };
            *obstacles.entry(why).or_insert(0_usize) += 1;
        }
    }
    let mut text = String::new();
    for (kind, (proved, _, open)) in &kinds {
        text += &format!("{kind:<12} {:>4} theorems, {open:>3} steps without\n", proved.len());
    }
    for (obstacle, count) in obstacles {
        text += &format!("not covered: {count} steps: {obstacle}\n");
    }
    let whole = claims.values().filter(|whole| **whole).count();
    text + &format!("claims with every step of every proof checked: {whole} of {}", claims.len())
}

/// How many altered theorems Coq refused.
fn refusals(checked: &[Checked], faults: &mut Vec<String>) -> usize {
    let mut count = 0;
    for Checked { file, output, theorems } in checked {
        let Ok(output) = output else { continue };
        let messages: Vec<&str> =
            output.split("The command has indeed failed with message:").skip(1).collect();
        let late = messages.iter().filter(|message| message.contains("Timeout")).count();
        if late > 0 || messages.len() != theorems.len() {
            faults.push(format!(
                "{file}: {} of {} altered theorems refused, {late} by a time limit",
                messages.len(),
                theorems.len()
            ));
        }
        count += messages.len() - late;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: &str = "report\tclaim\tproof\tstep\tkind\ttheorem\tfile\tobstacle\n\
        r\tS1\tp\t1\tidentity\tidentity_1\tr/claim_S1\t\n\
        r\tS1\tp\t2\targued\t\t\tno certificate\n\
        r\tS2\tp\t1\tidentity\tidentity_1\tr/claim_S1\t\n";

    fn checked(output: &str) -> Checked {
        let output = Ok(output.to_owned());
        Checked { file: "r/claim_S1".into(), output, theorems: vec!["identity_1".into()] }
    }

    #[test]
    fn steps_are_counted_by_kind_and_obstacles_are_named() {
        let text = coverage(STEPS, &BTreeSet::from(["identity_1".to_owned()]));
        assert!(text.contains("identity        1 theorems,   0 steps without"), "{text}");
        assert!(text.contains("not covered: 1 steps: no certificate"), "{text}");
        assert!(text.ends_with("checked: 1 of 2"), "{text}");
        assert!(coverage(STEPS, &BTreeSet::new()).contains("2 steps: Coq refused the theorem"));
    }

    #[test]
    fn a_theorem_without_its_list_or_with_a_strange_axiom_fails() {
        let time = Duration::ZERO;
        assert!(print(STEPS, &[checked("Closed under the global context\n")], Mode::Proofs, time).is_ok());
        assert!(print(STEPS, &[checked("")], Mode::Proofs, time).is_err());
        assert!(print(STEPS, &[checked("Axioms:\nmine : False\n")], Mode::Proofs, time).is_err());
    }

    #[test]
    fn an_altered_theorem_must_be_refused_and_in_time() {
        let time = Duration::ZERO;
        let refused =
            "The command has indeed failed with message:\nTactic failure: not a valid ring equation.\n";
        assert!(print(STEPS, &[checked(refused)], Mode::Faults(false), time).is_ok());
        assert!(print(STEPS, &[checked("")], Mode::Faults(false), time).is_err());
        let late = "The command has indeed failed with message:\nTimeout!\n";
        assert!(print(STEPS, &[checked(late)], Mode::Faults(false), time).is_err());
    }
}
