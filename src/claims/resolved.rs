//! A claim as resolved: one text with its words, its formulas, over what they are said, and everything of `equations.toml` that they
//! reach. Its SHA-256 is the claim's digest, to which theorems and planted faults are bound.
//!
//! The text has one order and one layout. Remarks, the order and the layout of the files, and what the claim does not reach have no
//! place in it.

use sha2::{Digest, Sha256};
use slipmode_algebra::{Expression, Symbol};
use slipmode_theory::{Equations, Start, without_layout};

use crate::scene::{ClaimEntry, ClaimFormula, Computed, Scope, StatedClaim, Statement};

/// The text of a claim with what it reaches: by its formulas, or by the function that decides it.
#[must_use]
pub fn resolved_claim(claim: &ClaimEntry, equations: &Equations) -> String {
    let mut lines = vec![format!("words: {}", one_line(&claim.words))];
    let mut start = Start::default();
    match (&claim.stated, &claim.reason) {
        (Some(stated), _) => lines.extend(of_readings(stated, equations, &mut start)),
        (None, Some(reason)) => lines.push(format!("out of reach: {}", one_line(reason))),
        (None, None) => {}
    }
    with_reached(lines, &start, equations)
}

/// The text of one formula of a claim with what it reaches.
#[must_use]
pub fn resolved_formula(formula: &ClaimFormula, equations: &Equations) -> String {
    let mut start = Start::default();
    let lines = of_formula("", formula, equations, &mut start);
    with_reached(lines, &start, equations)
}

fn with_reached(mut lines: Vec<String>, start: &Start<'_>, equations: &Equations) -> String {
    lines.extend(equations.reached(start));
    lines.push(String::new());
    lines.join("\n")
}

/// SHA-256 of a text in lower-case hexadecimal.
#[must_use]
pub fn sha256_hex(text: &str) -> String {
    Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The readings of a claim, each with its parts.
fn of_readings<'c>(stated: &'c StatedClaim, equations: &'c Equations, start: &mut Start<'c>) -> Vec<String> {
    let argued = stated.argued.iter().map(|step| format!("argued: {}", one_line(step)));
    let criterion = stated.criterion.iter().map(|found| format!("criterion: {}", one_line(found)));
    let mut lines: Vec<String> = argued.chain(criterion).collect();
    for reading in &stated.readings {
        lines.push(format!("reading: {}", one_line(&reading.words)));
        for (words, formula) in &reading.parts {
            lines.push(format!("part: {}", one_line(words)));
            lines.extend(of_formula("", formula, equations, start));
        }
    }
    lines
}

/// A formula with its scope and its limit; `place` is written before each key.
fn of_formula<'c>(
    place: &str,
    formula: &'c ClaimFormula,
    equations: &'c Equations,
    start: &mut Start<'c>,
) -> Vec<String> {
    start.expressions.extend(formula.expressions());
    let scope = &formula.scope;
    let bounded = scope.within.iter().map(|(name, _)| name).chain(scope.at.iter().map(|(name, _)| name));
    start
        .names
        .extend(bounded.chain(formula.statement.variable()).chain(&scope.there_is).chain(&scope.moves));
    if let Statement::Motion(motion) = &formula.statement {
        start.systems.push(&motion.name);
    }
    let key = if formula.rows.is_some() { "rows" } else { "formula" };
    let table = formula.rows.as_ref().map_or(String::new(), |rows| format!("{}: ", rows.table));
    let mut lines = match formula.computed() {
        None => vec![format!("{place}{key}: {table}{}", without_layout(&formula.text))],
        Some(computed) => of_computed(place, computed, equations, start),
    };
    let at_least = formula.rows.iter().map(|rows| rows.at_least).filter(|least| *least > 0);
    lines.extend(at_least.map(|least| format!("{place}at_least: {least}")));
    lines.extend(of_scope(scope).into_iter().map(|line| format!("{place}{line}")));
    if let Some(limit) = &formula.limit {
        let (words, outside) = &limit.outside;
        lines.push(format!("{place}limit: {}", one_line(&limit.words)));
        lines.push(format!("{place}outside: {}", one_line(words)));
        lines.extend(of_formula(&format!("{place}outside "), outside, equations, start));
    }
    lines
}

/// What proofs, premises or a procedure decide, with the equations that they reach.
fn of_computed<'c>(
    place: &str,
    computed: &'c Computed,
    equations: &'c Equations,
    start: &mut Start<'c>,
) -> Vec<String> {
    let line = |key: &str, text: &str| format!("{place}{key}: {}", one_line(text));
    let mut lines: Vec<String> = computed.check.iter().map(|name| line("check", name)).collect();
    lines.extend(computed.of.iter().map(|of| line("of", of)));
    for number in &computed.equations {
        let role = equations.iter().find(|one| one.number == *number).and_then(|one| one.role);
        lines.extend(role.map(|role| line("role", &format!("{} is equation {number}", role.as_str()))));
        start.equations.push(number);
    }
    for id in &computed.proofs {
        lines.push(line("proof", &format!("{id}: {}", computed.stated.says(id))));
        start.equations.extend(computed.stated.reached(id, equations));
    }
    lines.extend(computed.counter_example.iter().map(|shown| line("counter-example", shown)));
    for premise in &computed.premises {
        lines.push(line("premise", &premise.id));
        let inside = of_readings(&premise.stated, equations, start);
        lines.extend(inside.into_iter().map(|inner| format!("{place}premise {inner}")));
    }
    lines
}

/// Over what a formula is said: the members of each key in alphabetical order.
fn of_scope(scope: &Scope) -> Vec<String> {
    let key = |word: &str, mut members: Vec<String>| {
        members.sort();
        members.into_iter().map(|member| format!("{word}: {member}")).collect::<Vec<_>>()
    };
    let equal = |(name, value): &(Symbol, Expression)| format!("{name} = {value}");
    let names = |list: &[Symbol]| list.iter().map(Symbol::to_string).collect();
    let of = [
        ("given", scope.given.iter().map(|condition| without_layout(&condition.text)).collect()),
        ("there_is", names(&scope.there_is)),
        ("moves", names(&scope.moves)),
        ("witness", scope.witness.iter().map(equal).collect()),
        (
            "box",
            scope.within.iter().map(|(name, [low, high])| format!("{low} <= {name} <= {high}")).collect(),
        ),
        ("at", scope.at.iter().map(|(name, value)| format!("{name} = {value}")).collect()),
    ];
    of.into_iter().flat_map(|(word, members)| key(word, members)).collect()
}

/// Words with one space between two of them.
fn one_line(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::claims::{TIES, procedures};
    use crate::scene::{read_claims, read_equations};

    /// A report's equations as the tables of their file, so that one place of it can be altered.
    struct File {
        equations: toml::Table,
        claims: Vec<u8>,
    }

    impl File {
        fn of(report: &str) -> Self {
            let read = |name: &str| {
                std::fs::read(format!("{}/reports/{report}/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
            };
            let equations = String::from_utf8(read("equations.toml")).unwrap().parse().unwrap();
            Self { equations, claims: read("claims.toml") }
        }

        /// The resolved claims by their ids; none when the altered file is refused.
        fn resolved(&self, table: &toml::Table) -> Option<Vec<(String, String)>> {
            let equations = read_equations("equations.toml", table.to_string().as_bytes()).ok()?;
            let claims = read_claims("claims.toml", &self.claims, &procedures(), Some(&equations)).ok()?;
            Some(claims.iter().map(|claim| (claim.id.clone(), resolved_claim(claim, &equations))).collect())
        }
    }

    /// Every alteration of one place of a file: what is altered, as lines of a resolved claim begin with it, and the file.
    fn alterations(table: &toml::Table) -> Vec<(String, toml::Table)> {
        let mut found = Vec::new();
        let positive = table["assumptions"]["positive"].as_array().unwrap();
        let other = positive[0].as_str().unwrap();
        for (section, name, key) in
            [("equation", "number", "equation"), ("definition", "name", "is"), ("system", "name", "rates")]
        {
            for at in 0..table.get(section).and_then(toml::Value::as_array).map_or(0, Vec::len) {
                let mut altered = table.clone();
                let entry = altered[section].as_array_mut().unwrap()[at].as_table_mut().unwrap();
                let place = format!("{section} {}", entry[name].as_str().unwrap());
                let place = if section == "definition" { format!("{place} =") } else { format!("{place}:") };
                let text = match &mut entry[key] {
                    toml::Value::Array(rates) => &mut rates[0],
                    text => text,
                };
                let known = text.as_str().unwrap();
                *text = toml::Value::String(match section {
                    "definition" if known.starts_with("characteristic(") => format!("s + {other}"),
                    "definition" => format!("2*{other}"),
                    "system" => format!("2*({known})"),
                    // Twice nothing would be nothing.
                    _ if known.ends_with("= 0") => format!("{known} + 1"),
                    _ => known.replacen("= ", "= 2*", 1),
                });
                found.push((place, altered));
            }
        }
        for name in positive {
            let mut altered = table.clone();
            let assumptions = altered["assumptions"].as_table_mut().unwrap();
            assumptions["positive"].as_array_mut().unwrap().retain(|known| known != name);
            let free = assumptions.entry("free").or_insert_with(|| toml::Value::Array(Vec::new()));
            free.as_array_mut().unwrap().push(name.clone());
            found.push((format!("variable {}:", name.as_str().unwrap()), altered));
        }
        found
    }

    #[test]
    fn an_alteration_of_what_a_claim_reaches_changes_its_digest_and_no_other_does() {
        let reports =
            ["im-avouac", "paper-on-paper", "ranjith-rice-1999", "rice-ruina-1983", "rock-friction"];
        for report in reports {
            let mut file = File::of(report);
            // An altered equation would have another unit, and be refused.
            file.equations.remove("units");
            let sound = file.resolved(&file.equations).unwrap();
            let (mut tried, mut reached) = (0, BTreeSet::new());
            for (place, altered) in alterations(&file.equations) {
                // What is refused when it is read leaves no claim to decide.
                let Some(altered) = file.resolved(&altered) else { continue };
                tried += 1;
                for ((id, before), (_, after)) in sound.iter().zip(&altered) {
                    let is_reached = before.lines().any(|line| line.starts_with(&place));
                    assert_eq!(sha256_hex(before) != sha256_hex(after), is_reached, "{report} {id}: {place}");
                    reached.extend(is_reached.then(|| (id.clone(), place.clone())));
                }
            }
            let tied: BTreeSet<&str> =
                TIES.iter().filter(|tie| tie.report == report).map(|tie| tie.claim.as_str()).collect();
            let is_noticed = |id: &&str| reached.iter().any(|(known, _)| known == id);
            assert!(tried > 10 && tied.iter().all(is_noticed), "{report}: {tried}, {tied:?}");
        }
    }

    #[test]
    fn layout_order_and_remarks_change_no_digest_and_words_scope_and_units_do() {
        let file = File::of("rice-ruina-1983");
        let sound = file.resolved(&file.equations).unwrap();
        let mut turned = file.equations.clone();
        for section in ["equation", "definition", "system"] {
            turned[section].as_array_mut().unwrap().reverse();
        }
        for equation in turned["equation"].as_array_mut().unwrap() {
            equation["note"] = toml::Value::String("another remark".into());
        }
        assert_eq!(file.resolved(&turned).unwrap(), sound);
        let text = String::from_utf8(file.claims.clone()).unwrap();
        let altered = |from: &str, to: &str| {
            assert!(text.contains(from), "{from}");
            let claims = text.replacen(from, to, 1).into_bytes();
            let file = File { claims, equations: file.equations.clone() };
            file.resolved(&file.equations).unwrap()
        };
        assert_eq!(altered("formula = \"", "formula = \"  "), sound);
        assert_eq!(altered("[[claim]]", "# a remark\n[[claim]]"), sound);
        assert_ne!(altered("words = \"", "words = \"Other: "), sound);
        assert_ne!(altered("given = [\"", "given = [\"L > 0\", \""), sound);
        let mut other_units = file.equations.clone();
        other_units["units"]["K"] = toml::Value::String("Pa*m/m^2".into());
        assert_ne!(file.resolved(&other_units).unwrap(), sound);
    }
}
