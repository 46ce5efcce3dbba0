//! Two ledgers compared with each other, claim by claim.

use std::collections::BTreeMap;

use serde::Deserialize;

/// What of a ledger's entry is compared.
#[derive(Debug, Deserialize, PartialEq, Eq)]
struct Line {
    id: String,
    verdict: String,
    strength: String,
    limit: Option<String>,
    counter_example: Option<String>,
}

#[derive(Debug, Deserialize)]
struct Lines {
    claims: Vec<Line>,
}

/// How the second ledger (JSON) differs from the first: one line for each claim and property; empty when they agree.
///
/// # Errors
/// When one of them is not a ledger.
pub fn ledger_differences(old: &[u8], new: &[u8]) -> Result<Vec<String>, String> {
    let (old, new) = (by_id(old, "the first")?, by_id(new, "the second")?);
    let mut found = Vec::new();
    for (id, old) in &old {
        match new.get(id) {
            None => found.push(format!("{id}: only in the first ledger")),
            Some(new) => found.extend(line_differences(old, new)),
        }
    }
    found.extend(
        new.keys().filter(|id| !old.contains_key(*id)).map(|id| format!("{id}: only in the second ledger")),
    );
    Ok(found)
}

fn by_id(json: &[u8], which: &str) -> Result<BTreeMap<String, Line>, String> {
    let lines: Lines =
        serde_json::from_slice(json).map_err(|error| format!("{which} is not a ledger: {error}"))?;
    let count = lines.claims.len();
    let by_id: BTreeMap<String, Line> =
        lines.claims.into_iter().map(|line| (line.id.clone(), line)).collect();
    if by_id.len() == count { Ok(by_id) } else { Err(format!("{which} lists a claim twice")) }
}

fn line_differences(old: &Line, new: &Line) -> Vec<String> {
    let text = |value: &Option<String>| value.clone().unwrap_or_else(|| "none".into());
    let pairs = [
        ("verdict", old.verdict.clone(), new.verdict.clone()),
        ("strength", old.strength.clone(), new.strength.clone()),
        ("limit", text(&old.limit), text(&new.limit)),
        ("counter-example", text(&old.counter_example), text(&new.counter_example)),
    ];
    let differs = pairs.into_iter().filter(|(_, old, new)| old != new);
    differs.map(|(what, was, is)| format!("{}: {what}: {was} -> {is}", old.id)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const OLD: &str = r#"{"claims": [{"id": "B8", "verdict": "fails", "strength": "exact", "limit": null,
        "counter_example": "x = 1"}, {"id": "S1", "verdict": "holds", "strength": "exact", "limit": null, "counter_example": null}]}"#;

    #[test]
    fn each_difference_is_named_with_old_and_new() {
        assert!(ledger_differences(OLD.as_bytes(), OLD.as_bytes()).unwrap().is_empty());
        let new = OLD.replace("\"fails\"", "\"holds\"").replace("\"x = 1\"", "null").replace("S1", "S2");
        assert_eq!(
            ledger_differences(OLD.as_bytes(), new.as_bytes()).unwrap(),
            [
                "B8: verdict: fails -> holds",
                "B8: counter-example: x = 1 -> none",
                "S1: only in the first ledger",
                "S2: only in the second ledger"
            ]
        );
    }

    #[test]
    fn what_is_no_ledger_is_refused() {
        assert!(
            ledger_differences(b"{}", OLD.as_bytes()).unwrap_err().starts_with("the first is not a ledger")
        );
        let doubled = OLD.replace("S1", "B8");
        assert_eq!(
            ledger_differences(OLD.as_bytes(), doubled.as_bytes()).unwrap_err(),
            "the second lists a claim twice"
        );
    }
}
