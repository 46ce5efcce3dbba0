//! What was proved: theorems, steps by kind with their obstacles, and assumptions.

use super::assumptions::{listed, refused};
use super::{Mode, Said, Task};
use crate::prelude::*;

/// Prints the counts. The list of accepted theorems.
///
/// # Errors
/// When theorems assume too much, or an altered one was not refused. A theorem that is not accepted is named, and not in the list.
pub fn print(steps: &Steps, checked: &[(Task, Said)], mode: Mode) -> Result<String> {
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
        let refused = proved.len();
        println!("prove: Coq refused {refused} of {all} altered theorems, none of them by a time limit");
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

/// The lists that the program writes: what became of each step of each proof, and the files of archives.
pub struct Steps {
    lines: Vec<[String; 8]>,
    /// Path, SHA-256, and the theorems in it.
    files: Vec<[String; 3]>,
}

impl Steps {
    /// Reads both lists.
    ///
    /// # Errors
    /// When a line has another number of fields.
    pub fn read(steps: &str, files: &str) -> Result<Self> {
        let lines = steps.lines().skip(1).map(|line| fields("steps.tsv", line));
        let files = files.lines().map(|line| fields("files.tsv", line));
        Ok(Self { lines: lines.collect::<Result<_, _>>()?, files: files.collect::<Result<_, _>>()? })
    }

    /// Accepted theorems, each with its digest, and the files of archives of which Coq has accepted every theorem.
    fn record(&self, proved: &BTreeSet<&str>) -> String {
        let theorems = self.lines.iter().filter(|[.., theorem, _, _]| proved.contains(theorem.as_str()));
        let theorems = theorems.map(|[.., theorem, digest, _]| format!("{theorem} {digest}\n"));
        let is_proved = |name: &str| name.is_empty() || proved.contains(name);
        let files = self.files.iter().filter(|[_, _, names]| names.split(' ').all(is_proved));
        let files = files.map(|[path, digest, _]| format!("{path} {digest}\n"));
        theorems.chain(files).collect::<BTreeSet<String>>().into_iter().collect()
    }

    /// A line for each kind of step, one for each step without a theorem that Coq accepted, and the table of claims.
    fn coverage(&self, proved: &BTreeSet<&str>) -> String {
        let (mut kinds, mut open) = (BTreeMap::new(), String::new());
        let mut claims = BTreeMap::<[&str; 2], Vec<Checked<'_>>>::new();
        for [report, claim, proof, step, kind, theorem, _, obstacle] in &self.lines {
            let is_proved = proved.contains(theorem.as_str());
            let why = if theorem.is_empty() { obstacle } else { "Coq did not accept it" };
            claims.entry([report, claim]).or_default().push(Checked { kind, theorem, is_proved, why });
            let counts: &mut [usize; 2] = kinds.entry(kind).or_default();
            counts[0] += usize::from(is_proved);
            counts[1] += 1;
            if !is_proved && !matches!(kind.as_str(), WHOLE | BY_HAND) {
                open += &format!("not proved: {report} {claim}, {proof}, step {step} ({kind}): {why}\n");
            }
        }
        let kinds =
            kinds.iter().map(|(kind, [done, all])| format!("{kind:<12} {done:>4} of {all:>4} steps\n"));
        let mut text = kinds.collect::<String>() + &open;
        let mut counts = [0; 5];
        for ([report, id], steps) in &claims {
            let Some((way, words)) = way(steps) else { continue };
            counts[way] += 1;
            text += &format!("{report:<18} {id:<4} {words}\n");
        }
        let [generated, by_hand, steps, argued, open] = counts;
        let (whole, all): (usize, usize) = (generated + by_hand, counts.iter().sum());
        text += &format!("claims decided exactly: {all}, of which {whole} are whole theorems");
        text += &format!(" ({} %): {generated} generated, {by_hand} by hand\n", 100 * whole / all.max(1));
        text += &format!("the others: {steps} by steps, {argued} with an argued step, ");
        text + &format!("{open} with a step that is not proved\n")
    }
}

/// The fields of a line.
fn fields<const COUNT: usize>(list: &str, line: &str) -> Result<[String; COUNT]> {
    let fields: Vec<String> = line.split('\t').map(str::to_owned).collect();
    fields.try_into().map_err(|_| Failure::check(format!("{list}: {line}")))
}

/// The kind of a claim's formula as a theorem.
const WHOLE: &str = "whole";

/// The kind of a theorem that is written by hand.
const BY_HAND: &str = "by hand";

/// The kind of a step in words.
const ARGUED: &str = "argued";

/// A step of a claim, and what Coq said of its theorem.
struct Checked<'s> {
    kind: &'s str,
    theorem: &'s str,
    is_proved: bool,
    /// Why there is no theorem that Coq accepted.
    why: &'s str,
}

/// How Coq has checked a claim: by whole theorems that are generated (0) or written by hand (1), by steps (2), by steps of which some are
/// argued in words (3), or not in all steps (4); and the same in words. None for a claim without a line on whole theorems, which
/// computations decide besides.
fn way(steps: &[Checked<'_>]) -> Option<(usize, String)> {
    let of = |kind: &'static str| steps.iter().filter(move |step| step.kind == kind);
    let whole: Vec<&Checked<'_>> = of(WHOLE).chain(of(BY_HAND)).collect();
    if whole.is_empty() {
        return None;
    }
    let obstacles: BTreeSet<&str> =
        whole.iter().filter(|step| !step.is_proved).map(|step| step.why).collect();
    let reasons = Vec::from_iter(obstacles).join("; ");
    let names: Vec<&str> = of(BY_HAND).filter(|step| step.is_proved).map(|step| step.theorem).collect();
    let is_open = steps.iter().any(|step| !step.is_proved && ![WHOLE, BY_HAND, ARGUED].contains(&step.kind));
    Some(if whole.iter().all(|step| step.is_proved) && of(WHOLE).next().is_some() {
        (0, "whole (generated)".into())
    } else if !names.is_empty() && of(BY_HAND).all(|step| step.is_proved) {
        (1, format!("whole (by hand: {})", names.join(", ")))
    } else if is_open {
        (4, format!("not all steps: {reasons}"))
    } else if of(ARGUED).next().is_some() {
        (3, format!("argued: {reasons}"))
    } else {
        (2, format!("by steps: {reasons}"))
    })
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
        r\tS3\tp\t1\tidentity\tidentity_1\t00ff\t\n\
        r\tS4\tp\twhole\twhole\t\t\tno formula\n\
        r\tS4\tby hand\twhole\tby hand\tSlider.S4\t00ee\t\n";

    const FILES: &str =
        "library/Slider.v\t00dd\t\nr/claim_S1.v\t00cc\tidentity_1\nr/claim_S4.v\t00bb\tidentity_1 sign_1\n";

    fn result(output: Said, mode: Mode) -> Result<String> {
        let task = Task {
            file: "r/claim_S1".into(),
            text: String::new(),
            theorems: vec![if mode == Mode::Faults { "fault_1" } else { "identity_1" }.into()],
        };
        print(&Steps::read(STEPS, FILES).unwrap(), &[(task, output)], mode)
    }

    #[test]
    fn steps_are_counted_by_kind_and_those_without_a_theorem_are_named() {
        let steps = Steps::read(STEPS, FILES).unwrap();
        let text = steps.coverage(&BTreeSet::from(["identity_1"]));
        assert!(text.contains("identity        3 of    3 steps"), "{text}");
        assert!(text.contains("not proved: r S1, p, step 2 (argued): no certificate\n"), "{text}");
        assert!(
            text.contains("S1   argued: no formula\n") && text.contains("S2   whole (generated)\n"),
            "{text}"
        );
        let both = steps.coverage(&BTreeSet::from(["identity_1", "Slider.S4"]));
        assert!(both.contains("S4   whole (by hand: Slider.S4)\n"), "{both}");
        assert!(
            both.contains(
                "decided exactly: 3, of which 2 are whole theorems (66 %): 1 generated, 1 by hand\n"
            )
        );
        assert!(text.contains("S4   by steps: Coq did not accept it; no formula\n"), "{text}");
        let nothing = steps.coverage(&BTreeSet::new());
        assert!(nothing.contains("r S2, p, step 1 (identity): Coq did not accept it"), "{nothing}");
        assert!(
            nothing.ends_with("1 by steps, 0 with an argued step, 2 with a step that is not proved\n"),
            "{nothing}"
        );
        assert!(steps.record(&BTreeSet::from(["Slider.S4"])).contains("Slider.S4 00ee"));
        assert_eq!(steps.record(&BTreeSet::new()), "library/Slider.v 00dd\n");
        assert!(Steps::read("a\nb\tc\n", FILES).is_err() && Steps::read(STEPS, "a\n").is_err());
    }

    #[test]
    fn a_file_without_a_list_of_assumptions_or_with_a_strange_axiom_fails() {
        let clean = result(Ok("Closed under the global context\n".into()), Mode::Proofs);
        assert_eq!(clean.unwrap(), "identity_1 00ff\nlibrary/Slider.v 00dd\nr/claim_S1.v 00cc\n");
        assert!(result(Ok(String::new()), Mode::Proofs).is_err());
        assert!(result(Ok("Axioms:\nmine : False\n".into()), Mode::Proofs).is_err());
        assert_eq!(result(Err("Timeout!".into()), Mode::Proofs).unwrap(), "library/Slider.v 00dd\n");
    }

    #[test]
    fn an_altered_theorem_must_be_refused_and_in_time() {
        assert!(result(Ok("refused 1\n".into()), Mode::Faults).is_ok());
        assert!(result(Ok("refused 2\n".into()), Mode::Faults).is_err());
        assert!(result(Err("Timeout!".into()), Mode::Faults).is_err());
    }
}
