//! Random claims whose truth is known by construction, decided by the program as a user runs it.
//!
//! A claim begins as a statement whose truth follows from how it is built, and is then disguised by changes that keep its truth. The
//! program may leave a claim undecided. It must never call a false claim true, a true one false, or decide what has no meaning. The
//! independent program in `tests/independent` reads the claims that were decided, and must contradict no verdict.
//!
//! 400 claims are decided, and 2 000 where slow tests run (`cargo xtask test --slow`): the same 400 and more from the same generator.
//! `SLIPMODE_RANDOM_CLAIMS=100000` decides more, `SLIPMODE_RANDOM_CLAIMS_SEED` others, and
//! `SLIPMODE_RANDOM_CLAIMS_FOLDER` keeps the folders, each with `truth.csv`.

mod claim;
mod disguise;
mod families;
mod program;
mod rewriting;
mod term;
mod trial;
mod world;

use std::collections::BTreeMap;
use std::env;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::harness::{Workplace, is_slow};
use crate::independent::compared;
use crate::random::Random;
use program::{Answer, write_folder};
use trial::Trial;
use world::World;

/// The claims of a quick run.
const QUICK: usize = 400;

/// The claims of a run with slow tests.
const SLOW: usize = 2_000;

/// The least share of the true and the false claims that is decided, in percent; 72 were measured.
const LEAST_SHARE: usize = 60;

/// The claims of one folder.
const IN_A_FOLDER: usize = 100;

fn setting(name: &str) -> Option<u64> {
    let text = env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name} = {text} is no whole number")))
}

/// The names that the program lets a user give to a variable, and those of them that it then takes for something else.
fn accepted_names() -> (Vec<&'static str>, Vec<&'static str>) {
    let mut names: Vec<&str> = world::pool().collect();
    loop {
        let claims: String =
            (1..).zip(&names).map(|(number, name)| holds(number, &format!("{name} + 1 > 0"))).collect();
        let equations = format!("[assumptions]\npositive = {names:?}\n");
        let place = Workplace::with_report(&equations, &claims, "Words.\n");
        let ended = place.run(["verify", "r", "-o", "out"]);
        if ended.code != 2 {
            let drift = |name: &&str| {
                let number = names.iter().position(|known| known == name).unwrap() + 1;
                ended.stderr.lines().any(|line| line.starts_with(&format!("C{number}: recorded")))
            };
            return names.iter().copied().partition(|name| !drift(name));
        }
        let before = names.len();
        let is_named = |number: usize, name: &str| {
            ended.stderr.contains(&format!("'{name}'")) || ended.stderr.contains(&format!("claim[{number}]"))
        };
        names = (1..)
            .zip(names)
            .filter(|(number, name)| !is_named(*number, name))
            .map(|(_, name)| name)
            .collect();
        assert!(names.len() < before, "{}", ended.stderr);
    }
}

/// A claim that a formula holds.
fn holds(number: usize, formula: &str) -> String {
    format!(
        "[[claim]]\nid = \"C{number}\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\n\
         formula = {formula:?}\n\n"
    )
}

#[test]
fn a_variable_with_a_word_of_the_grammar_as_its_name_is_refused_or_is_that_variable() {
    let (accepted, mistaken) = accepted_names();
    assert!(mistaken.is_empty(), "{mistaken:?}");
    assert!(accepted.len() > 90, "{accepted:?}");
}

/// At how many points the independent program evaluates each claim.
const POINTS: &str = "5";

/// How many wrong verdicts of a kind are shown.
const SHOWN: usize = 6;

/// How many claims of a kind there were, by answer.
#[derive(Default)]
struct Tally {
    decided: usize,
    not_checked: usize,
    refused: usize,
    wrong: usize,
}

#[test]
fn no_random_claim_gets_a_wrong_verdict() {
    let usual = if is_slow() { SLOW } else { QUICK };
    let count = setting("SLIPMODE_RANDOM_CLAIMS").map_or(usual, |count| usize::try_from(count).unwrap());
    let seed = setting("SLIPMODE_RANDOM_CLAIMS_SEED").unwrap_or(29);
    let place = Workplace::new();
    let kept = env::var_os("SLIPMODE_RANDOM_CLAIMS_FOLDER").map_or_else(|| place.path(""), PathBuf::from);
    let mut folders = Vec::new();
    let (accepted, _) = accepted_names();
    let mut tallies: BTreeMap<(&str, claim::Truth), Tally> = BTreeMap::new();
    for folder in 0..count.div_ceil(IN_A_FOLDER) {
        let random = &mut Random(seed.wrapping_add(folder as u64 * 1_000_003));
        let world = World::drawn(random, &accepted);
        let trials: Vec<Trial> = (0..IN_A_FOLDER).map(|_| Trial::drawn(random)).collect();
        let claims: Vec<claim::Claim> = trials.iter().map(Trial::claim).collect();
        let answers = program::answers(&world, &claims);
        folders.push(kept.join(format!("r{folder}")));
        keep(&folders[folder], &world, &claims, &answers);
        for (number, (answer, trial)) in answers.into_iter().zip(&trials).enumerate() {
            let claim = &claims[number];
            let tally = tallies.entry((claim.kind, claim.truth)).or_default();
            match &answer {
                Answer::Holds | Answer::Fails(_) => tally.decided += 1,
                Answer::NotChecked => tally.not_checked += 1,
                Answer::Refused(_) => tally.refused += 1,
                Answer::Broken(_) => {}
            }
            if trial::is_wrong(claim.truth, &answer) {
                tally.wrong += 1;
                if tally.wrong <= SHOWN {
                    println!("{}", trial.shrunk(&world, &answer));
                }
            }
        }
    }
    let (table, share) = table(&tallies);
    println!("{table}");
    let all: usize = tallies.values().map(|tally| tally.wrong).sum();
    assert!(all == 0, "{all} of {count} claims got a wrong verdict (seed {seed})");
    assert!(share >= LEAST_SHARE, "{share} % decided, at least {LEAST_SHARE} % are expected");
    let folders = folders.iter().map(|folder| folder.to_str().unwrap());
    let Some(ended) = compared(&folders.chain(["--points", POINTS, "--quiet"]).collect::<Vec<_>>()) else {
        return;
    };
    println!("{}", ended.stdout);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
}

/// The claims that were decided as a folder with a report and its ledger, and beside them the truth of all and what the program says.
fn keep(folder: &Path, world: &World, claims: &[claim::Claim], answers: &[Answer]) {
    let (mut decided, mut entries) = (Vec::new(), Vec::new());
    let mut truths = String::from("claim,kind,truth,verdict\n");
    for ((number, claim), answer) in claims.iter().enumerate().zip(answers) {
        let (verdict, counter_example) = match answer {
            Answer::Holds => ("holds", Some("null")),
            Answer::Fails(counter_example) => ("fails", Some(counter_example.as_str())),
            Answer::NotChecked => ("not-checked", None),
            Answer::Refused(_) => ("refused", None),
            Answer::Broken(_) => ("broken", None),
        };
        writeln!(truths, "C{number},{},{:?},{verdict}", claim.kind, claim.truth).unwrap();
        if let Some(example) = counter_example {
            decided.push((number, claim));
            entries.push(format!(
                "{{\"id\": \"C{number}\", \"verdict\": \"{verdict}\", \"counter_example\": {example}}}"
            ));
        }
    }
    write_folder(folder, world, &decided);
    std::fs::write(folder.join("ledger.json"), format!("{{\"claims\": [{}]}}\n", entries.join(", ")))
        .unwrap();
    std::fs::write(folder.join("truth.csv"), truths).unwrap();
}

/// The number that was decided, by kind and truth, and the share of the true and the false claims in percent.
fn table(tallies: &BTreeMap<(&str, claim::Truth), Tally>) -> (String, usize) {
    let mut text = format!(
        "{:<28} {:<12} {:>7} {:>11} {:>7} {:>5}\n",
        "kind", "truth", "decided", "not checked", "refused", "wrong"
    );
    let (mut decided, mut all) = (0, 0);
    for ((kind, truth), tally) in tallies {
        let Tally { decided: own, not_checked, refused, wrong } = tally;
        writeln!(
            text,
            "{kind:<28} {:<12} {own:>7} {not_checked:>11} {refused:>7} {wrong:>5}",
            format!("{truth:?}")
        )
        .unwrap();
        if *truth != claim::Truth::Meaningless {
            decided += own;
            all += own + not_checked + refused;
        }
    }
    let share = 100 * decided / all.max(1);
    text += &format!("decided: {decided} of {all} claims that are true or false ({share} %)\n");
    (text, share)
}

#[test]
fn equations_at_fault_are_refused_before_a_claim_uses_them() {
    let claims = holds(1, "a + b > a");
    let assumptions = "[assumptions]\npositive = [\"a\", \"b\", \"x\"]\nfree = [\"y\"]\n";
    let mut accepted = Vec::new();
    for (equations, word) in families::faulty_equations() {
        let ended = Workplace::with_report(&format!("{assumptions}{equations}"), &claims, "Words.\n")
            .run(["verify", "r"]);
        if ended.code != 2 || !ended.stderr.contains(word) || ended.stderr.contains("panicked") {
            accepted.push(format!("{equations}{ended:?}"));
        }
    }
    assert!(accepted.is_empty(), "{}", accepted.join("\n\n"));
}
