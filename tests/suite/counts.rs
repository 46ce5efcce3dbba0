//! Counts of claims, verdicts and findings are the same in ledgers, reports, README and paper; numbers in sentences lie on their safe side.

use std::collections::BTreeSet;
use std::path::PathBuf;

use serde_json::Value;

const REPORTS: [&str; 9] = [
    "friction-laws",
    "gu-et-al-1984",
    "hoffmann-et-al-2002",
    "im-avouac",
    "paper-on-paper",
    "ranjith-rice-1999",
    "rice-ruina-1983",
    "rock-friction",
    "ziegler-1952",
];

fn root() -> PathBuf {
    env!("CARGO_MANIFEST_DIR").into()
}

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn published(report: &str, file: &str) -> String {
    read(&format!("reports/{report}/published/{file}"))
}

/// The claims of a ledger of one source.
fn claims(ledger: &Value, source: &str) -> Vec<Value> {
    let all = ledger["claims"].as_array().expect("claims").iter();
    all.filter(|claim| claim["source"] == source).cloned().collect()
}

fn count(claims: &[Value], verdict: &str) -> usize {
    claims.iter().filter(|claim| claim["verdict"] == verdict).count()
}

/// The findings among claims with a verdict, by following `same_as` to an earlier claim.
fn findings(claims: &[Value], verdict: &str) -> usize {
    let first = |claim: &Value| {
        let mut id = claim["id"].as_str().expect("an id").to_owned();
        while let Some(same) =
            claims.iter().find(|one| one["id"] == id.as_str()).and_then(|one| one["same_as"].as_str())
        {
            id = same.to_owned();
        }
        id
    };
    claims.iter().filter(|claim| claim["verdict"] == verdict).map(first).collect::<BTreeSet<_>>().len()
}

fn hold(count: usize) -> &'static str {
    if count == 1 { "holds" } else { "hold" }
}

#[test]
fn every_document_has_the_counts_of_the_ledgers() {
    let mut compared = 0;
    for report in REPORTS {
        let ledger: Value = serde_json::from_str(&published(report, "ledger.json")).expect("JSON");
        let paper = claims(&ledger, "paper");
        let verdicts = [
            ("✗ fails (with a counter-example)", "fails"),
            ("≈ holds within (inside a quantified limit)", "holds-within"),
            ("✓ holds (as stated)", "holds"),
            ("– not checked (in this report)", "not-checked"),
        ];
        let [edition, whole] = ["report.md", "ledger.md"].map(|file| published(report, file));
        if paper.is_empty() {
            assert!(
                !edition.contains("claims of the paper") && !whole.contains("| Verdict | Claims |"),
                "{report}"
            );
            continue;
        }
        for (words, verdict) in verdicts {
            let row = format!("| {words} | {} |", count(&paper, verdict));
            assert!(edition.contains(&row) && whole.contains(&row), "{report}: {row}");
            compared += 2;
        }
        let [held, limited, failed] =
            ["holds", "holds-within", "fails"].map(|verdict| count(&paper, verdict));
        let fail = if failed == 1 { "fails" } else { "fail" };
        let counted = format!(
            "Of the {} claims of the paper in this report, {held} {} as stated, {limited} {} within a limit, and {failed} {fail}",
            paper.len(),
            hold(held),
            hold(limited)
        );
        assert!(edition.contains(&counted) && whole.contains(&counted), "{report}: {counted}");
        compared += 8;
        let distinct = findings(&paper, "fails");
        if distinct < failed {
            assert!(edition.contains(&format!("They are {distinct} findings")), "{report}: {distinct}");
            compared += 1;
        }
    }
    let ledger: Value = serde_json::from_str(&published("im-avouac", "ledger.json")).expect("JSON");
    let (paper, own) = (claims(&ledger, "paper"), claims(&ledger, "result"));
    let of_runs =
        paper.iter().filter(|claim| claim["id"].as_str().is_some_and(|id| id.starts_with('N'))).count();
    let [held, limited, failed] = ["holds", "holds-within", "fails"].map(|verdict| count(&paper, verdict));
    let verdicts = format!(
        "{held} hold, {limited} hold within a region of parameters, and {failed} fail, which are {} findings",
        findings(&paper, "fails")
    );
    let readme = format!(
        "The report decides {} claims of the paper, {} about the linear theory and {of_runs} about the simulations: {verdicts}.",
        paper.len(),
        paper.len() - of_runs
    );
    assert!(read("README.md").contains(&readme), "README.md: {readme}");
    assert!(read("README.md").contains(&format!("X1 to X{}", own.len())), "README.md: {} results", own.len());
    assert!(read("paper.md").contains(&verdicts), "paper.md: {verdicts}");
    compared += 12;
    assert!(compared >= 60, "{compared}");
}

#[test]
fn the_readers_edition_is_read_in_a_quarter_of_an_hour() {
    for report in REPORTS {
        let text = published(report, "report.md");
        let without_targets = text.split("](").enumerate().map(|(index, part)| match part.split_once(')') {
            Some((_, rest)) if index > 0 => rest,
            _ => part,
        });
        let words = without_targets
            .flat_map(str::split_whitespace)
            .filter(|word| word.chars().any(char::is_alphanumeric));
        let count = words.count();
        assert!(count <= 6000, "{report}: {count} words");
    }
}

/// The numbers of a sentence, each with the words before it.
fn number_after(text: &str, words: &str) -> f64 {
    let rest = &text[text.find(words).unwrap_or_else(|| panic!("no {words}")) + words.len()..];
    let rest = rest.trim_start().trim_start_matches('$').replace('−', "-");
    let end = rest.find([' ', ',', ';', '$', ')']).unwrap_or(rest.len());
    let (mantissa, power) = rest[..end]
        .trim_end_matches('.')
        .split_once("\\times10^{")
        .unwrap_or((rest[..end].trim_end_matches('.'), "0}"));
    let power: i32 = power.trim_end_matches('}').parse().unwrap();
    mantissa.parse::<f64>().unwrap() * 10f64.powi(power)
}

/// A cell of a published table of the first paper, by conditions on other columns.
fn cell(table: &str, column: &str, conditions: &[(&str, &str)]) -> f64 {
    let text = published("im-avouac", &format!("tables/{table}.csv"));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().unwrap().clone();
    let at = |name: &str| {
        head.iter().position(|one| one == name).unwrap_or_else(|| panic!("{table}: {name} in {head:?}"))
    };
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let row = rows.iter().find(|row| conditions.iter().all(|(name, value)| &row[at(name)] == *value));
    row.unwrap_or_else(|| panic!("{table}: {conditions:?}"))[at(column)].parse().unwrap()
}

/// Every value of a column of a published table.
fn column(table: &str, column: &str) -> Vec<f64> {
    let text = published("im-avouac", &format!("tables/{table}.csv"));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let at = reader.headers().unwrap().iter().position(|one| one == column).unwrap();
    reader.records().filter_map(|row| row.unwrap()[at].parse().ok()).collect()
}

/// A number in words that has to be at least, or at most, the computed one, and not far from it.
fn is_safe(stated: f64, exact: f64, at_least: bool) {
    let is_on_its_side = if at_least { stated >= exact } else { stated <= exact };
    assert!(is_on_its_side && (stated - exact).abs() <= 0.1 * exact.abs(), "{stated} for {exact}");
}

#[test]
fn numbers_of_the_answer_lie_on_their_safe_side() {
    let text = published("im-avouac", "report.md");
    let limits = [
        ("15", "V0 below", false),
        ("16", "V0 below", false),
        ("18", "σ above", true),
        ("20", "σ below", false),
    ];
    for (equation, place, at_least) in limits {
        let stated = number_after(&text, &format!("eq {equation} for {place}"));
        let row = [
            ("scene", "potentially-unstable"),
            ("asymptote", &format!("eq{equation}")),
            ("relative_error", "0.01"),
        ];
        is_safe(stated, cell("tolerance", "limit", &row), at_least);
    }
    let ledger: Value = serde_json::from_str(&published("im-avouac", "ledger.json")).unwrap();
    let claim = |id: &str| ledger["claims"].as_array().unwrap().iter().find(|one| one["id"] == id).unwrap();
    let errors = &text[text.find("their errors are up to").unwrap()..];
    let columns = ["quasi_static_upper", "quasi_static_lower", "inertial_upper", "inertial_lower"];
    for (equation, column) in ["15", "16", "18", "20"].into_iter().zip(columns) {
        let exact = cell("worst-errors", column, &[("slider", "a < b")]);
        let before = &errors[..errors.find(&format!(" % (eq {equation})")).unwrap()];
        let stated = before.rsplit([' ']).next().unwrap().replace('−', "-");
        is_safe(stated.parse().unwrap(), 100.0 * exact, exact > 0.0);
    }
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let instead = |id: &str| claim(id)["change"]["instead"].as_str().unwrap().to_owned();
    is_safe(
        number_after(&instead("N4"), "up to K/K_c = "),
        1.0 + largest(&column("bistability-edge", "edge_excess")),
        true,
    );
    let (turn, offset) =
        (column("least-peaks", "cycle_mode_change_dex"), column("least-peaks", "offset_dex"));
    let width = instead("N12");
    is_safe(number_after(&width, "becomes a vibration "), least(&turn), false);
    is_safe(number_after(&width, "vibration 0.63 to "), largest(&turn), true);
    is_safe(number_after(&width, "is lowest "), least(&offset), false);
    is_safe(number_after(&width, "-0.49 to "), largest(&offset), true);
}
