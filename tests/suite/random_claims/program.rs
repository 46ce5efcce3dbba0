//! What the program says about claims: a folder as a user writes it, and `slipmode verify`.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use super::claim::Claim;
use super::world::World;

/// How long a folder may take; what takes longer is divided until the slow claim stands alone.
const PATIENCE: Duration = Duration::from_secs(60);

/// What the program says about a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    Holds,
    Fails(String),
    NotChecked,
    /// Refused, with the message.
    Refused(String),
    /// Neither a verdict nor a refusal: how the program ended.
    Broken(String),
}

/// Writes claims as a folder with a report, as a user does.
pub fn write_folder(folder: &Path, world: &World, claims: &[(usize, &Claim)]) {
    let equations: String =
        claims.iter().map(|(number, claim)| claim.definitions_toml(*number, world)).collect();
    let text: String = claims.iter().map(|(number, claim)| claim.toml(*number, world) + "\n").collect();
    fs::create_dir_all(folder.join("prose")).unwrap();
    fs::write(folder.join("report.toml"), REPORT).unwrap();
    fs::write(folder.join("equations.toml"), world.toml() + &equations).unwrap();
    fs::write(folder.join("claims.toml"), text).unwrap();
    fs::write(folder.join("prose/c.md"), "Words.\n").unwrap();
}

const REPORT: &str = "name = \"r\"\ntitle = \"R\"\npublish_page = false\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n";

/// The answers to claims that stand in one folder, in their order.
pub fn answers(world: &World, claims: &[Claim]) -> Vec<Answer> {
    let mut answers: Vec<Option<Answer>> = vec![None; claims.len()];
    loop {
        let open: Vec<(usize, &Claim)> =
            (0..claims.len()).filter(|at| answers[*at].is_none()).map(|at| (at, &claims[at])).collect();
        if open.is_empty() {
            return answers.into_iter().flatten().collect();
        }
        for (at, answer) in decided(world, &open) {
            answers[at] = Some(answer);
        }
    }
}

/// What one run of the program answers; claims without an answer go into the next run.
fn decided(world: &World, claims: &[(usize, &Claim)]) -> Vec<(usize, Answer)> {
    let place = TempDir::new().unwrap();
    write_folder(&place.path().join("r"), world, claims);
    let Some((code, errors)) = run(place.path()) else {
        return match claims {
            [(at, _)] => vec![(*at, Answer::Broken(format!("no answer within {} s", PATIENCE.as_secs())))],
            _ => {
                let (first, second) = claims.split_at(claims.len() / 2);
                [decided(world, first), decided(world, second)].concat()
            }
        };
    };
    match code {
        Some(0 | 1) if place.path().join("out/ledger.json").exists() => verdicts(place.path(), claims),
        Some(2) if !errors.contains("panicked") => refusals(&errors, world, claims),
        _ => match claims {
            [(at, _)] => vec![(*at, Answer::Broken(format!("exit code {code:?}: {errors}")))],
            _ => {
                let (first, second) = claims.split_at(claims.len() / 2);
                [decided(world, first), decided(world, second)].concat()
            }
        },
    }
}

/// The exit code and standard error; none when the program was ended because it took too long.
fn run(place: &Path) -> Option<(Option<i32>, String)> {
    let errors = place.join("errors");
    let mut child = Command::new(env!("CARGO_BIN_EXE_slipmode"))
        .args(["verify", "r", "-o", "out"])
        .current_dir(place)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(fs::File::create(&errors).unwrap())
        .spawn()
        .unwrap();
    let start = Instant::now();
    let code = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status.code();
        }
        if start.elapsed() > PATIENCE {
            child.kill().unwrap();
            child.wait().unwrap();
            return None;
        }
        sleep(Duration::from_millis(5));
    };
    Some((code, fs::read_to_string(&errors).unwrap()))
}

fn verdicts(place: &Path, claims: &[(usize, &Claim)]) -> Vec<(usize, Answer)> {
    let text = fs::read_to_string(place.join("out/ledger.json")).unwrap();
    let ledger: serde_json::Value = serde_json::from_str(&text).unwrap();
    let found = ledger["claims"].as_array().unwrap();
    let answer = |(at, _): &(usize, &Claim)| {
        let entry = found.iter().find(|entry| entry["id"] == format!("C{at}"));
        let answer = match entry.and_then(|entry| entry["verdict"].as_str()) {
            Some("holds") => Answer::Holds,
            Some("fails") => Answer::Fails(entry.unwrap()["counter_example"].to_string()),
            Some("not-checked") => Answer::NotChecked,
            other => Answer::Broken(format!("the verdict {other:?}")),
        };
        (*at, answer)
    };
    claims.iter().map(answer).collect()
}

/// The claims that a refusal names, by their place in the file, counted from 1, or by a name that they define.
fn refusals(errors: &str, world: &World, claims: &[(usize, &Claim)]) -> Vec<(usize, Answer)> {
    let mut refused: Vec<(usize, Answer)> = Vec::new();
    for line in errors.lines() {
        let by_place = line.split_once("claim[").and_then(|(_, rest)| rest.split_once(']'));
        let by_place =
            by_place.and_then(|(place, _)| claims.get(place.parse::<usize>().ok()?.checked_sub(1)?));
        let by_name = || {
            let key = line.split_once("equations.toml: ")?.1.split_once(':')?.0;
            let name = key.split_once(' ')?.1;
            claims
                .iter()
                .find(|(number, claim)| claim.definitions_toml(*number, world).contains(&format!("{name}\"")))
        };
        if let Some((at, _)) = by_place.or_else(by_name)
            && !refused.iter().any(|(known, _)| known == at)
        {
            refused.push((*at, Answer::Refused(line.to_owned())));
        }
    }
    if refused.is_empty() {
        let all =
            |(at, _): &(usize, &Claim)| (*at, Answer::Broken(format!("a refusal of nothing: {errors}")));
        return claims.iter().map(all).collect();
    }
    refused
}
