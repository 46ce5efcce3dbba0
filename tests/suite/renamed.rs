//! The first paper's report in other names: procedures and proofs know its equations by their roles, not by names.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use toml::{Table, Value};

use crate::harness::{Workplace, names_in};

const REPORT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/im-avouac");

/// Keys with words, ids and numbers, in which no variable has a place.
const OF_WORDS: &str = "says id lemma block over argued number role note words place quote criterion leaves_out remarks title kind expected \
    check proofs premises shows equations rests_on sliders in_answer letter source same_as change counter_example extent name limit";

/// Tables whose keys are names.
const OF_NAMES: &str = "let at witness box units";

/// Every variable of the report's equations by its new name.
struct Renamed(BTreeMap<String, String>);

impl Renamed {
    fn of(equations: &Table) -> Self {
        let list = |key: &str| equations["assumptions"][key].as_array().unwrap().iter();
        let all =
            list("positive").chain(list("free")).chain(equations["quantities"].as_table().unwrap().values());
        let all = all.map(|name| name.as_str().unwrap()).chain(["Delta_delta", "Delta_theta"]);
        let renamed = |name: &str| match name {
            "a" => "A".to_owned(),
            "D_c" => "L".to_owned(),
            _ => format!("{name}_own"),
        };
        Self(all.map(|name| (name.to_owned(), renamed(name))).collect())
    }

    /// A formula in the new names.
    fn text(&self, text: &str) -> String {
        let mut found = String::new();
        let mut word = String::new();
        // The end of the text ends its last word.
        for character in text.chars().map(Some).chain([None]) {
            match character.filter(|one| one.is_ascii_alphanumeric() || *one == '_') {
                Some(character) => word.push(character),
                None => {
                    found += self.0.get(&word).unwrap_or(&word);
                    word.clear();
                    found.extend(character);
                }
            }
        }
        found
    }

    /// What stands under a key, in the new names.
    fn value(&self, key: &str, value: &Value, around: &Table) -> Value {
        let is_in = |words: &str| words.split_whitespace().any(|word| word == key);
        match value {
            Value::Table(_) if key == "numbers" => value.clone(),
            Value::Table(table) => {
                let named = |key: &String| if is_in(OF_NAMES) { self.text(key) } else { key.clone() };
                // The keys below names are no keys of the grammar.
                let below = |name: &String| if is_in(OF_NAMES) { String::new() } else { name.clone() };
                let entries =
                    table.iter().map(|(name, value)| (named(name), self.value(&below(name), value, table)));
                Value::Table(entries.collect())
            }
            Value::Array(all) => {
                all.iter().map(|one| self.value(key, one, around)).collect::<Vec<_>>().into()
            }
            // A statement over rows is in the names of columns.
            Value::String(_) if key == "formula" && around.contains_key("rows") => value.clone(),
            Value::String(text) if key == "says" => {
                let parts = text.split('{').enumerate().map(|(at, part)| match part.split_once('}') {
                    Some((name, rest)) if at > 0 => format!("{{{}}}{rest}", self.text(name)),
                    _ => part.to_owned(),
                });
                Value::String(parts.collect())
            }
            // What a domain adds to, or what a procedure is asked about.
            Value::String(_)
                if key == "of" && !["in", "at"].iter().any(|beside| around.contains_key(*beside)) =>
            {
                value.clone()
            }
            Value::String(text) if !is_in(OF_WORDS) => Value::String(self.text(text)),
            _ => value.clone(),
        }
    }
}

/// A copy of the report's input in which `change` sees each file of TOML that is about equations.
fn copy(place: &Workplace, from: &Path, to: &str, change: &dyn Fn(&Table) -> Table) {
    for name in names_in(from).into_iter().filter(|name| name != "published") {
        let (path, to) = (from.join(&name), format!("{to}/{name}"));
        if path.is_dir() {
            copy(place, &path, &to, change);
        } else if name.starts_with("equations.") || name.starts_with("claims.") || from.ends_with("proofs") {
            let table: Table = toml::from_str(&fs::read_to_string(path).unwrap()).unwrap();
            place.write(&to, change(&table).to_string());
        } else if name == "report.toml" {
            place.write(
                &to,
                fs::read_to_string(path).unwrap().replace("name = \"im-avouac\"", "name = \"another-paper\""),
            );
        } else {
            place.write(&to, fs::read(path).unwrap());
        }
    }
}

/// The verdict and the limit of each claim of a ledger.
fn verdicts(ledger: &str) -> Vec<(String, String, Option<String>)> {
    let ledger: serde_json::Value = serde_json::from_str(ledger).unwrap();
    let claims = ledger["claims"].as_array().unwrap().iter();
    let text = |value: &serde_json::Value| value.as_str().unwrap().to_owned();
    claims
        .map(|claim| {
            (text(&claim["id"]), text(&claim["verdict"]), claim["limit"].as_str().map(str::to_owned))
        })
        .collect()
}

#[test]
fn a_copy_of_the_papers_report_with_all_variables_renamed_has_the_same_verdicts_and_limits() {
    let place = Workplace::new();
    let equations: Table =
        toml::from_str(&fs::read_to_string(format!("{REPORT}/equations.toml")).unwrap()).unwrap();
    let renamed = Renamed::of(&equations);
    assert!(renamed.0.len() > 20);
    let change = |table: &Table| match renamed.value("", &Value::Table(table.clone()), table) {
        Value::Table(table) => table,
        _ => unreachable!("a table stays one"),
    };
    copy(&place, Path::new(REPORT), "another-paper", &change);
    let said = place.read("another-paper/equations.toml");
    assert!(said.contains("mu_own = mu_0_own + A*ln(V_own/V_0_own)") && !said.contains("= \"a\""), "{said}");
    place.run(["report", "another-paper", "-o", "out"]).expect_warnings();
    let published = fs::read_to_string(format!("{REPORT}/published/ledger.json")).unwrap();
    assert_eq!(verdicts(&place.read("out/ledger.json")), verdicts(&published));
}
