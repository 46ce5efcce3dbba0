//! The independent program in `tests/independent`: it agrees with the recorded verdicts, and notices wrong ones.

use std::path::Path;
use std::process::Command;

use crate::harness::{Ended, Workplace};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Runs the program; none where Python or mpmath is missing, which `cargo xtask validate` reports.
pub fn compared(arguments: &[&str]) -> Option<Ended> {
    run("tests/independent", arguments)
}

fn run(program: &str, arguments: &[&str]) -> Option<Ended> {
    let has_mpmath = Command::new("python3").args(["-c", "import mpmath, tomllib"]).output();
    if !has_mpmath.is_ok_and(|output| output.status.success()) {
        return None;
    }
    let output =
        Command::new("python3").arg("-B").arg(Path::new(ROOT).join(program)).args(arguments).output();
    Some(Ended::from(output.unwrap()))
}

const EQUATIONS: &str = "[assumptions]\npositive = [\"a\", \"b\"]\nfree = [\"x\"]\n\
    [[equation]]\nnumber = \"1\"\nequation = \"c = a + b\"\n";

/// A fixed name: points are drawn from the name of the folder, and the name of a workplace differs from run to run.
const FOLDER: &str = "report";
const CLAIMS: &str = "report/claims.toml";

/// Formulas with their conditions and true verdicts.
const ROWS: [(&str, &str, &str); 16] = [
    ("c > a", "", "holds"),
    ("c > 2*a", "", "fails"),
    ("c > 2*a", "given = ['b > a']", "holds"),
    ("c rises with a", "", "holds"),
    ("c -> b as a -> 0", "", "holds"),
    ("c depends on x", "", "fails"),
    ("stable(s^2 + sqrt(a)*s + b, s)", "", "holds"),
    ("not unstable(s^2 + x*s + b, s)", "", "fails"),
    ("all_real(s^2 + a*s + b, s) iff a^2 >= 4*b", "", "holds"),
    ("x^2 >= 0 and exp(x) > 0", "", "holds"),
    ("a^2 - b*a -> infinity as a -> infinity", "", "holds"),
    ("ln(a) - b -> -infinity as a -> 0", "", "holds"),
    ("(a + b)/(a - 2*b) -> infinity as a -> infinity", "", "fails"),
    ("1/b - a -> infinity as a -> infinity", "", "fails"),
    ("b + exp(-a) -> infinity as a -> infinity", "", "fails"),
    ("a/b -> 1 as a -> infinity", "", "fails"),
];

fn place(flipped: Option<usize>) -> Workplace {
    let claims = ROWS.iter().enumerate().map(|(place, (formula, scope, verdict))| {
        let verdict = match (flipped == Some(place), *verdict) {
            (true, "holds") => "fails",
            (true, _) => "holds",
            (false, verdict) => verdict,
        };
        let claim = format!("[[claim]]\nid = \"C{place}\"\nexpected = \"{verdict}\"\nformula = {formula:?}");
        format!("{claim}\n{scope}\n")
    });
    let place = Workplace::new();
    place.write(CLAIMS, claims.collect::<String>());
    place.write(&format!("{FOLDER}/equations.toml"), EQUATIONS);
    place
}

#[test]
fn no_verdict_of_the_reports_is_contradicted() {
    let Some(ended) = compared(&["--points", "1", "--quiet"]) else { return };
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
    assert!(
        ended.stdout.contains(" formulas, ") && ended.stdout.contains(" 0 contradictions "),
        "{}",
        ended.stdout
    );
}

#[test]
fn a_verdict_that_holds_wrongly_is_contradicted_with_a_point() {
    let run = |place: &Workplace| {
        let folder = place.path(FOLDER);
        compared(&["--points", "40", folder.to_str().unwrap()])
    };
    let Some(ended) = run(&place(None)) else { return };
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
    for (index, _) in ROWS.iter().enumerate().filter(|(_, (.., verdict))| *verdict == "fails") {
        let ended = run(&place(Some(index))).unwrap();
        assert_eq!(ended.code, 1, "{}", ended.stdout);
        assert!(ended.stdout.contains(&format!("C{index}: CONTRADICTED")), "{}", ended.stdout);
    }
}

#[test]
fn a_printed_point_that_refutes_nothing_is_contradicted() {
    let ledger = |point: &str| {
        let place = place(None);
        place.write(
            &format!("{FOLDER}/ledger.json"),
            format!("{{\"claims\": [{{\"id\": \"C2\", \"verdict\": \"fails\", \"counter_example\": \"{point}\"}}]}}"),
        );
        place
    };
    for (point, words) in [
        ("at a = 1, b = 2: left minus right is 1", "it is true at the printed point"),
        ("at a = 2, b = 1: left minus right is -1", "does not meet the conditions"),
    ] {
        let folder = ledger(point);
        let Some(ended) = compared(&["--points", "3", folder.path(FOLDER).to_str().unwrap()]) else { return };
        assert_eq!(ended.code, 1, "{}", ended.stdout);
        assert!(ended.stdout.contains(words), "{}", ended.stdout);
    }
}

#[test]
fn what_cannot_be_read_is_refused_with_its_file() {
    let place = place(None);
    place.write(CLAIMS, "[[claim]]\nid = \"C1\"\nexpected = \"holds\"\nformula = \"c > (a\"\n");
    let Some(ended) = compared(&[place.path(FOLDER).to_str().unwrap()]) else { return };
    ended.expect_refusal(&["claims.toml: claim C1: '(a': expected ')'"]);
    place.write(CLAIMS, "[[claim]\n");
    compared(&[place.path(FOLDER).to_str().unwrap()]).unwrap().expect_refusal(&["claims.toml: "]);
}

#[test]
fn the_lines_of_a_frequency_ratio_and_of_a_damping_ratio_are_where_the_roots_of_eq_8_have_it() {
    let cases = if std::env::var_os("SLIPMODE_SLOW").is_some() { "200" } else { "30" };
    let program = "tests/independent/pair_lines.py";
    let Some(ended) = run(program, &[env!("CARGO_BIN_EXE_slipmode"), cases]) else { return };
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{}", ended.stdout);
    assert_eq!(ended.stdout.trim_end(), format!("{cases} cases, 0 contradictions"));
}
