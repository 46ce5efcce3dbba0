//! The schemas of `docs/schema/` follow from what the program prints: each key, whether it is always there, and its types.
//!
//! `python/tests/test_schemas.py` compares other outputs with the schemas, by a validator that shares no code with this file.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use serde_json::{Map, Value, json};
use slipmode_algebra::Certificate;
use slipmode_core::number::split_mix::SplitMix64;

use crate::harness::{SLIDER, Workplace};

/// For each schema, invocations whose outputs together have all shapes.
const INVOCATIONS: &str = "tests/data/schemas/invocations.txt";

/// Objects whose keys are data.
const MAPS: [&str; 3] = ["correlations", "points", "verdicts"];

/// Errors of which an error bar of a random slider has one.
const BARS: [&str; 3] = ["±1e-15%", "±5%", "±99.99%"];

/// Random sliders that stand for a `~` of the table.
const SLIDERS: u64 = 40;

/// Objects whose other keys depend on the value of `kind`.
const KINDS: [&str; 2] = ["certificate", "evidence"];

/// Objects that occur at several places and have one type.
const SHARED: [&str; 3] = ["certificate", "domain", "system"];

/// Lists that no invocation of the table fills: what was not decided, for which no input is known, and what a replay of the
/// program's own archive finds.
const EMPTY: [&str; 4] = [".undecided", ".not_decided", "replay.differences", "replay.not_verified"];

/// What all values at one place have in common.
#[derive(Default)]
struct Shape {
    times: usize,
    types: BTreeSet<&'static str>,
    /// How many of the values are objects with these keys.
    objects: usize,
    keys: BTreeMap<String, Shape>,
    kinds: BTreeMap<String, Shape>,
    items: Option<Box<Shape>>,
    lengths: BTreeSet<usize>,
}

/// A schema in the making: the shapes of the values, and those of the objects that occur at several places.
#[derive(Default)]
struct Draft {
    whole: Shape,
    shared: BTreeMap<&'static str, Shape>,
}

impl Draft {
    /// Takes in an output.
    fn see(&mut self, value: &Value) {
        self.whole.see("", value);
        self.see_shared(value);
    }

    fn see_shared(&mut self, value: &Value) {
        for (key, value) in value.as_object().into_iter().flatten() {
            if let Some(name) = SHARED.iter().find(|name| *name == key) {
                self.shared.entry(name).or_default().see(key, value);
            }
            self.see_shared(value);
        }
        value.as_array().into_iter().flatten().for_each(|item| self.see_shared(item));
    }

    /// Compares the schema with the file in `docs/schema`, or writes the file.
    fn compare(&self, name: &str, title: &str) {
        let mut schema = self.whole.schema(name);
        schema["$schema"] = "https://json-schema.org/draft/2020-12/schema".into();
        schema["title"] = title.into();
        for (name, shape) in &self.shared {
            schema["$defs"][name] = shape.schema(name);
        }
        let (path, text) = (root().join(format!("docs/schema/{name}.json")), format!("{schema:#}\n"));
        if std::env::var_os("SLIPMODE_WRITE_SCHEMAS").is_some() {
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(&path, &text).unwrap();
        }
        let written = fs::read_to_string(&path).unwrap_or_default();
        assert!(written == text, "docs/schema/{name}.json: SLIPMODE_WRITE_SCHEMAS=1 writes it anew");
    }
}

impl Shape {
    /// Takes in a value, and the key of the object in which it stands.
    fn see(&mut self, key: &str, value: &Value) {
        self.times += 1;
        self.types.insert(match value {
            Value::Null => "null",
            Value::Bool(_) => "boolean",
            Value::Number(number) if number.is_f64() => "number",
            Value::Number(_) => "integer",
            Value::String(_) => "string",
            Value::Array(_) => "array",
            Value::Object(_) => "object",
        });
        match value {
            Value::Array(items) => {
                self.lengths.insert(items.len());
                let key = if MAPS.contains(&key) { "" } else { key };
                items.iter().for_each(|item| self.items.get_or_insert_default().see(key, item));
            }
            Value::Object(object) if KINDS.contains(&key) => {
                self.kinds.entry(object["kind"].as_str().unwrap().into()).or_default().see_keys(object);
            }
            Value::Object(object) if MAPS.contains(&key) => {
                object.values().for_each(|value| self.items.get_or_insert_default().see("", value));
            }
            Value::Object(object) => self.see_keys(object),
            _ => {}
        }
    }

    fn see_keys(&mut self, object: &Map<String, Value>) {
        self.objects += 1;
        for (key, value) in object {
            self.keys.entry(key.clone()).or_default().see(key, value);
        }
    }

    /// The schema of the values, which stand at this place.
    fn schema(&self, place: &str) -> Value {
        if !self.kinds.is_empty() {
            let of = |(kind, shape): (&String, &Shape)| shape.object(place, Some(kind));
            let null = self.types.contains("null").then(|| json!({ "type": "null" }));
            return json!({ "oneOf": self.kinds.iter().map(of).chain(null).collect::<Vec<_>>() });
        }
        let is_whole = |name: &&str| *name != "integer" || !self.types.contains("number");
        let types: Vec<&str> = self.types.iter().copied().filter(is_whole).collect();
        let mut schema = if self.keys.is_empty() { json!({}) } else { self.object(place, None) };
        schema["type"] = if let [name] = types[..] { name.into() } else { types.into() };
        if let Some(items) = &self.items {
            let is_map = self.types.contains("object");
            let key = if is_map { "additionalProperties" } else { "items" };
            schema[key] = items.schema(&format!("{place}[]"));
            let is_range =
                self.lengths == [2].into() && items.types.is_subset(&["integer", "null", "number"].into());
            if is_range {
                schema["minItems"] = 2.into();
                schema["maxItems"] = 2.into();
            }
        } else {
            let is_empty = EMPTY.iter().any(|end| place.ends_with(end));
            assert!(is_empty || !self.types.contains("array"), "{place}: no output has an item");
        }
        schema
    }

    /// The schema of an object.
    fn object(&self, place: &str, kind: Option<&str>) -> Value {
        let of = |(key, shape): (&String, &Shape)| {
            let schema = match (key.as_str(), kind) {
                ("schema", _) => json!({ "const": 1 }),
                ("kind", Some(kind)) => json!({ "const": kind }),
                (shared, _) if SHARED.contains(&shared) => json!({ "$ref": format!("#/$defs/{shared}") }),
                _ => shape.schema(&format!("{place}.{key}")),
            };
            (key.clone(), schema)
        };
        let properties: Map<String, Value> = self.keys.iter().map(of).collect();
        let always = self.keys.iter().filter(|(_, shape)| shape.times == self.objects);
        let required: Vec<&String> = always.map(|(key, _)| key).collect();
        json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Random options of the seven inputs, the same in every run. Some have values far out of range, or a = b; one has an error bar, which is 0 without `bars`.
fn random_slider(seed: u64, bars: bool) -> Vec<String> {
    let mut state = SplitMix64(seed);
    let mut below = |count: u16| (state.unit() * f64::from(count)) as u16;
    // Questions about error bars take long at the ends of what is allowed.
    let decades = [2, 20, 290][usize::from(below(if bars { 2 } else { 3 }))];
    let mut values = ["4e-3", "6e-3", "1e-5", "1e7", "1e3", "1e5", "1e-3"].map(|usual| {
        let shift = i32::from(below(2 * decades + 1)) - i32::from(decades);
        let (digit, exponent) = usual.split_once('e').unwrap();
        format!("{digit}.{:03}e{}", below(1000), exponent.parse::<i32>().unwrap() + shift)
    });
    if below(4) == 0 {
        values[1] = values[0].clone();
    }
    // An error of 0 is none.
    let bar = if bars { BARS[usize::from(below(3))] } else { "±0" };
    values[usize::from(below(5))] += bar;
    "abdkmsv".chars().zip(values).map(|(option, value)| format!("-{option}={value}")).collect()
}

/// The lines of an invocation, in which a `~` stands for random sliders, and a number behind it says how many options each has.
fn invocations(line: &str, bars: bool) -> Vec<String> {
    let Some((command, rest)) = line.split_once('~') else { return vec![line.to_string()] };
    let (count, rest) = (rest[..1].parse().unwrap(), &rest[1..]);
    let sliders = (0..SLIDERS).map(|seed| random_slider(seed, bars)[..count].join(" "));
    sliders.map(|slider| format!("{command}{slider}{rest}")).collect()
}

/// What an invocation of the table prints.
fn output(place: &Workplace, line: &str) -> Value {
    let line = line.replace('@', &SLIDER.join(" ")).replace('#', env!("CARGO_MANIFEST_DIR"));
    let ended = place.run(line.split_whitespace().chain(["--json"]));
    serde_json::from_str(&ended.stdout).unwrap_or_else(|_| panic!("{line}: {}", ended.stderr))
}

/// The ledgers of the published reports, and one of a slider with error bars.
fn ledgers(place: &Workplace) -> Vec<Value> {
    let own = ["new", "lab", "-d", "10±2um", "-s", "1e5", "-v", "1e-3"].into_iter();
    let made = place.run(own.chain(SLIDER.into_iter().filter(|word| !["-d", "1e-5"].contains(word))));
    assert_eq!(made.code, 0, "{}", made.stderr);
    place.run(["report", "lab", "-o", "out", "--quiet"]).expect_success();
    let reports = fs::read_dir(root().join("reports")).unwrap();
    let published = reports.map(|report| report.unwrap().path().join("published/ledger.json"));
    let ledgers = published.chain([place.path("out/ledger.json")]);
    ledgers.map(|path| serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()).collect()
}

#[test]
fn the_schemas_follow_from_the_outputs() {
    let place = Workplace::new();
    for part in fs::read_to_string(root().join(INVOCATIONS)).unwrap().split("\n[").skip(1) {
        let (heading, lines) = part.split_once('\n').unwrap();
        let (name, title) = heading.split_once("] ").unwrap();
        let mut draft = Draft::default();
        let bars = name.ends_with("error-bars");
        if name == "verify" {
            let claims = place.read("altered/claims.toml");
            place
                .write("altered/claims.toml", claims.replace("expected = \"holds\"", "expected = \"fails\""));
        }
        for line in lines.lines().flat_map(|line| invocations(line, bars)).filter(|line| !line.is_empty()) {
            let found = output(&place, &line);
            // A random slider may have no answer.
            if !line.contains("-a=") || found.get("errors").is_none() {
                draft.see(&found);
            }
        }
        draft.compare(name, title);
    }
}

/// The claims of `check` are those of a ledger, so that both schemas come from the claims of both.
#[test]
fn the_schemas_of_claims_follow_from_ledgers_and_have_every_kind_of_certificate() {
    let place = Workplace::new();
    let [mut ledger, mut check] = [(); 2].map(|()| Draft::default());
    let ledgers = ledgers(&place);
    ledgers.iter().for_each(|found| ledger.see(found));
    let examples = fs::read_dir(root().join("examples/check")).unwrap().map(|file| file.unwrap().path());
    for path in examples.chain([root().join("tests/data/schemas/differs.toml")]) {
        let found = output(&place, &format!("check {}", path.display()));
        ledger.see(&json!({ "report": "", "claims": found["claims"] }));
        check.see(&found);
    }
    let mut one = output(&place, "check #/examples/check/lorenz.toml --claim L1");
    for report in &ledgers {
        one["claims"] = report["claims"].clone();
        check.see(&one);
    }
    let kinds = ledger.shared["certificate"].kinds.keys().map(|kind| format!("`{kind}`"));
    let unknown = serde_json::from_value::<Certificate>(json!({ "kind": "?" })).unwrap_err().to_string();
    let known = unknown.split_once("expected one of ").unwrap().1.split(", ").map(str::to_owned);
    assert_eq!(kinds.collect::<BTreeSet<_>>(), known.collect());
    ledger.compare("ledger", "ledger.json of a report");
    check.compare("check", "slipmode check --json");
}
