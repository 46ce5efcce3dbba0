//! Two ledgers compared, claim by claim and field by field.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Map, Value};

use super::untrusted::shown;

/// When two texts count as the same.
pub type SameText = fn(&str, &str) -> bool;

/// How the second ledger (JSON) differs from the first: one line for each claim and field; empty when they agree.
///
/// # Errors
/// When one of them is not a ledger.
pub fn ledger_differences(old: &[u8], new: &[u8], same: SameText) -> Result<Vec<String>, String> {
    let (old, new) = (Ledger::read(old, "the first")?, Ledger::read(new, "the second")?);
    let mut comparison = Comparison { same, found: Vec::new() };
    for (id, old) in &old.claims {
        match new.claims.get(id) {
            None => comparison.found.push(format!("{}: only in the first ledger", shown(id))),
            Some(new) => comparison.objects(&format!("{}: ", shown(id)), old, new),
        }
    }
    let added = new.claims.keys().filter(|id| !old.claims.contains_key(*id));
    comparison.found.extend(added.map(|id| format!("{}: only in the second ledger", shown(id))));
    comparison.objects("ledger: ", &old.rest, &new.rest);
    Ok(comparison.found)
}

/// A ledger's claims by id, and its other fields.
struct Ledger {
    claims: BTreeMap<String, Map<String, Value>>,
    rest: Map<String, Value>,
}

impl Ledger {
    fn read(json: &[u8], which: &str) -> Result<Self, String> {
        Self::of_json(json).map_err(|why| format!("{which} is not a ledger: {why}"))
    }

    fn of_json(json: &[u8]) -> Result<Self, String> {
        let mut rest: Map<String, Value> = serde_json::from_slice(json).map_err(|error| error.to_string())?;
        if let Some(key) = doubled_key(&String::from_utf8_lossy(json)) {
            return Err(format!("an object has the key {} twice", shown(&key)));
        }
        let Some(Value::Array(list)) = rest.remove("claims") else { Err("it has no list `claims`")? };
        let mut claims = BTreeMap::new();
        for claim in list {
            let Value::Object(claim) = claim else { Err("a claim is not an object")? };
            let Some(Value::String(id)) = claim.get("id") else { Err("a claim has no id")? };
            let has_strength = claim.get("strength").is_some_and(|it| it.is_string() || it.is_null());
            if !has_strength || !claim.get("verdict").is_some_and(Value::is_string) {
                return Err(format!("claim {} has no verdict or no strength", shown(id)));
            }
            if let Some(known) = claims.insert(id.clone(), claim) {
                return Err(format!("it lists claim {} twice", text(&known["id"])));
            }
        }
        Ok(Self { claims, rest })
    }
}

/// The first key that an object has twice, in a text that is JSON. Each reader keeps one of the values, not all of them the same one.
fn doubled_key(json: &str) -> Option<String> {
    let (mut objects, mut rest) = (Vec::new(), json);
    while let Some(at) = rest.find(['"', '{', '}']) {
        let mut texts = serde_json::Deserializer::from_str(&rest[at..]).into_iter::<String>();
        let text = texts.next()?.ok();
        let length = if text.is_some() { texts.byte_offset() } else { 1 };
        let (found, after) = rest[at..].split_at(length);
        match (found, text.filter(|_| after.trim_start().starts_with(':'))) {
            ("{", _) => objects.push(BTreeSet::new()),
            ("}", _) => drop(objects.pop()),
            (_, Some(key)) if !objects.last_mut()?.insert(key.clone()) => return Some(key),
            _ => {}
        }
        rest = after;
    }
    None
}

struct Comparison {
    same: SameText,
    found: Vec<String>,
}

impl Comparison {
    fn objects(&mut self, place: &str, old: &Map<String, Value>, new: &Map<String, Value>) {
        for field in old.keys().chain(new.keys()).collect::<BTreeSet<_>>() {
            let (old, new) = (old.get(field).unwrap_or(&Value::Null), new.get(field).unwrap_or(&Value::Null));
            self.values(&format!("{place}{}", shown(field).replace('_', "-")), old, new);
        }
    }

    fn values(&mut self, place: &str, old: &Value, new: &Value) {
        match (old, new) {
            (Value::Object(old), Value::Object(new)) => self.objects(&format!("{place}."), old, new),
            (Value::Array(old), Value::Array(new)) if old.len() == new.len() => {
                for (number, (old, new)) in (1..).zip(old.iter().zip(new)) {
                    self.values(&format!("{place}[{number}]"), old, new);
                }
            }
            (Value::String(old), Value::String(new)) if (self.same)(old, new) => {}
            (old, new) if old == new => {}
            (Value::String(old), Value::String(new)) => {
                let [old, new] = from_difference([old, new]);
                self.found.push(format!("{place}: {old} -> {new}"));
            }
            (old, new) => self.found.push(format!("{place}: {} -> {}", text(old), text(new))),
        }
    }
}

/// Two texts as messages show them; without most of a long beginning that both have.
fn from_difference([old, new]: [&String; 2]) -> [String; 2] {
    let same = old.chars().zip(new.chars()).take_while(|(old, new)| old == new).count();
    let left_out = if same < MOST_SAME { 0 } else { same - MOST_SAME / 2 };
    let mark = if left_out == 0 { "" } else { "…" };
    [old, new].map(|text| format!("{mark}{}", shown(&text.chars().skip(left_out).collect::<String>())))
}

/// The longest beginning that two texts may share as messages show them, in characters.
const MOST_SAME: usize = 60;

fn text(value: &Value) -> String {
    match value {
        Value::Null => "none".into(),
        Value::String(text) => shown(text),
        Value::Array(list) => format!("{} entries", list.len()),
        Value::Object(_) => "an object".into(),
        other => shown(&other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OLD: &str = r#"{"report": "r", "claims": [{"id": "A1", "verdict": "fails", "strength": "exact", "limit": null, "words": "W",
        "counter_example": "x = 1", "evidence": [{"kind": "proof", "runs": 7}]},
        {"id": "A8", "verdict": "holds", "strength": "exact", "limit": null, "counter_example": null}]}"#;

    fn differences(new: &str) -> Vec<String> {
        ledger_differences(OLD.as_bytes(), new.as_bytes(), |old, new| old == new).unwrap()
    }

    #[test]
    fn each_difference_is_named_with_old_and_new() {
        assert!(differences(OLD).is_empty());
        let open =
            OLD.replacen("\"fails\", \"strength\": \"exact\"", "\"not-checked\", \"strength\": null", 1);
        assert_eq!(differences(&open), ["A1: strength: exact -> none", "A1: verdict: fails -> not-checked"]);
        let new = OLD.replace("\"fails\"", "\"holds\"").replace("\"x = 1\"", "null").replace("A8", "A9");
        assert_eq!(
            differences(&new),
            [
                "A1: counter-example: x = 1 -> none",
                "A1: verdict: fails -> holds",
                "A8: only in the first ledger",
                "A9: only in the second ledger"
            ]
        );
    }

    #[test]
    fn texts_that_differ_late_are_shown_from_there() {
        let [one, other] =
            ["y", "z"].map(|end| OLD.replace("\"W\"", &format!("\"{}{end}\"", "x".repeat(100))));
        let found = ledger_differences(one.as_bytes(), other.as_bytes(), |old, new| old == new).unwrap();
        let same = "x".repeat(30);
        assert_eq!(found, [format!("A1: words: …{same}y -> …{same}z")]);
    }

    #[test]
    fn every_field_is_compared() {
        for (from, to, line) in [
            ("\"W\"", "\"V\\u001b\"", "A1: words: W -> V\\u{1b}"),
            ("\"runs\": 7", "\"runs\": 8", "A1: evidence[1].runs: 7 -> 8"),
            ("\"runs\": 7}", "\"runs\": 7}, {}", "A1: evidence: 1 entries -> 2 entries"),
            ("\"report\": \"r\"", "\"report\": \"s\"", "ledger: report: r -> s"),
            ("\"words\"", "\"x\": 1, \"words\"", "A1: x: none -> 1"),
        ] {
            assert_eq!(differences(&OLD.replace(from, to)), [line]);
        }
    }

    #[test]
    fn what_is_no_ledger_is_refused() {
        let refusal = |first: &[u8]| ledger_differences(first, OLD.as_bytes(), |_, _| true).unwrap_err();
        for bad in [&b"{}"[..], b"", b"[]", br#"{"claims": [1]}"#, br#"{"claims": [{"id": "A1"}]}"#] {
            assert!(refusal(bad).starts_with("the first is not a ledger"), "{}", refusal(bad));
        }
        assert_eq!(
            refusal(OLD.replace("A8", "A1").as_bytes()),
            "the first is not a ledger: it lists claim A1 twice"
        );
        for (from, to) in [
            ("\"runs\": 7", "\"runs\": 7, \"runs\": 7"),
            ("\"runs\": 7", "\"runs\": 8, \"run\\u0073\" : 7"),
            ("{\"report\": \"r\"", "{\"runs\": [], \"report\": \"{\\\"}\", \"runs\": []"),
        ] {
            let doubled = OLD.replacen(from, to, 1);
            let why = "the first is not a ledger: an object has the key runs twice";
            assert_eq!(refusal(doubled.as_bytes()), why, "{doubled}");
        }
    }
}
