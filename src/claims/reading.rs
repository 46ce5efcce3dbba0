//! Readings of a claim and their parts, and the one rule by which they decide it.
//!
//! A claim is read as it is written first, and then in every other way that a fair reader could mean. A reading is the conjunction
//! of its parts. Each part is decided on its own evidence.

use std::collections::BTreeMap;

use crate::claims::{Evidence, Finding, Part, Reading, Verdict};

/// The verdict on a conjunction: one false part makes it fail, else one undecided part leaves it undecided, else one part with a
/// limit limits it. Without parts there is nothing to hold.
pub(crate) fn verdict_of_parts(parts: &[Verdict]) -> Verdict {
    let weight = |verdict: &Verdict| match verdict {
        Verdict::Holds => 0,
        Verdict::HoldsWithin => 1,
        Verdict::NotChecked => 2,
        Verdict::Fails => 3,
    };
    parts.iter().copied().max_by_key(weight).unwrap_or(Verdict::NotChecked)
}

/// A reading and the findings on its parts, before they are joined.
pub(super) struct Draft {
    words: String,
    parts: Vec<(String, Finding)>,
}

impl Draft {
    /// A reading without parts yet.
    pub(super) fn new(words: &str) -> Self {
        Self { words: words.into(), parts: Vec::new() }
    }

    /// Adds a part with the finding on it.
    pub(super) fn part(mut self, words: impl Into<String>, finding: Finding) -> Self {
        self.parts.push((words.into(), finding));
        self
    }
}

/// The finding on a claim with these readings: the first is the claim as it is written, and decides.
///
/// The parts keep their evidence in one list, where evidence that several parts rest on stands once.
pub(super) fn of_readings(drafts: impl IntoIterator<Item = Draft>) -> Finding {
    let (mut evidence, mut remarks, mut contradictions) = (Vec::new(), Vec::new(), Vec::new());
    let mut numbers = BTreeMap::new();
    let mut reading = |Draft { words, parts }: Draft| {
        let mut part = |(words, finding): (String, Finding)| {
            let Finding { verdict, strength, mut limit, counter_example, .. } = finding;
            contradictions.extend(finding.contradictions);
            // The reading as written comes first, and its numbers stay.
            for (name, value) in finding.numbers {
                numbers.entry(name).or_insert(value);
            }
            match verdict {
                Verdict::NotChecked => limit = Some(finding.remarks.join(" ")),
                _ => finding.remarks.into_iter().for_each(|remark| add(&mut remarks, remark)),
            }
            let own: Vec<usize> =
                finding.evidence.into_iter().map(|one| position(&mut evidence, one)).collect();
            let supporting = finding.supporting.iter().filter_map(|at| own.get(at - 1).copied()).collect();
            Part { words, verdict, strength, limit, counter_example, evidence: own, supporting }
        };
        let parts: Vec<Part> = parts.into_iter().map(&mut part).collect();
        let verdicts: Vec<Verdict> = parts.iter().map(|part| part.verdict).collect();
        let verdict = verdict_of_parts(&verdicts);
        // A part that is not decided is no evidence of what a false one decides.
        let strength = parts.iter().map(|part| part.strength).max().flatten();
        let strength = strength.filter(|_| verdict != Verdict::NotChecked);
        Reading { words, verdict, strength, parts }
    };
    let readings: Vec<Reading> = drafts.into_iter().map(&mut reading).collect();
    let Some(written) = readings.first() else { return Finding::not_checked("The claim has no reading.") };
    if written.verdict == Verdict::NotChecked {
        let open = written.parts.iter().filter(|part| part.verdict == Verdict::NotChecked);
        open.for_each(|part| add(&mut remarks, part.result().into()));
    }
    let deciding = |at: &usize| {
        let mut parts = readings.iter().flat_map(|reading| &reading.parts);
        parts.any(|part| part.evidence.contains(at) && !part.supporting.contains(at))
    };
    let supporting = (1..=evidence.len()).filter(|at| !deciding(at)).collect();
    Finding {
        supporting,
        verdict: written.verdict,
        strength: written.strength,
        limit: limit(written),
        counter_example: counter_example(written),
        evidence,
        readings,
        points: Vec::new(),
        contradictions,
        numbers,
        remarks,
    }
}

/// Adds a remark that is not there yet.
fn add(remarks: &mut Vec<String>, remark: String) {
    if !remarks.contains(&remark) {
        remarks.push(remark);
    }
}

/// Where evidence stands in the list, from 1; it is added where it does not stand yet.
fn position(evidence: &mut Vec<Evidence>, one: Evidence) -> usize {
    let known = evidence.iter().position(|other| other.is_same(&one));
    known.unwrap_or_else(|| {
        evidence.push(one);
        evidence.len() - 1
    }) + 1
}

/// The limits of the parts, or for a claim that fails its parts that are true; none for a claim that is not checked.
fn limit(reading: &Reading) -> Option<String> {
    let named = |part: &Part| part.limit.as_ref().map(|limit| format!("{}: {limit}", part.words));
    let list: Vec<String> = match reading.verdict {
        Verdict::Fails => {
            let is_true = |part: &&Part| matches!(part.verdict, Verdict::Holds | Verdict::HoldsWithin);
            let part = |part: &Part| named(part).unwrap_or_else(|| part.words.clone());
            reading.parts.iter().filter(is_true).map(part).collect()
        }
        Verdict::NotChecked => Vec::new(),
        Verdict::Holds | Verdict::HoldsWithin => reading.parts.iter().filter_map(named).collect(),
    };
    let list = (!list.is_empty()).then(|| list.join("; "))?;
    Some(if reading.verdict == Verdict::Fails { format!("true only: {list}") } else { list })
}

/// The counter-examples of the parts that fail, or else those outside the parts' limits.
fn counter_example(reading: &Reading) -> Option<String> {
    let deciding = |part: &&Part| (part.verdict == Verdict::Fails) == (reading.verdict == Verdict::Fails);
    let named = |part: &Part| Some(format!("{}: {}", part.words, part.counter_example.as_ref()?));
    let list: Vec<String> = reading.parts.iter().filter(deciding).filter_map(named).collect();
    (!list.is_empty()).then(|| list.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::Strength;

    const VERDICTS: [Verdict; 4] =
        [Verdict::Holds, Verdict::HoldsWithin, Verdict::Fails, Verdict::NotChecked];

    /// Every list of up to four verdicts.
    fn combinations() -> Vec<Vec<Verdict>> {
        let mut all = vec![Vec::new()];
        let mut longest = all.clone();
        for _ in 0..4 {
            let longer = |list: &Vec<Verdict>| VERDICTS.map(|next| [list.as_slice(), &[next]].concat());
            longest = longest.iter().flat_map(longer).collect();
            all.extend(longest.clone());
        }
        all
    }

    #[test]
    fn the_rule_holds_for_all_combinations_of_parts() {
        let all = combinations();
        assert_eq!(all.len(), 1 + 4 + 16 + 64 + 256);
        for parts in all {
            let any = |verdict| parts.contains(&verdict);
            let expected = if any(Verdict::Fails) {
                Verdict::Fails
            } else if any(Verdict::NotChecked) || parts.is_empty() {
                Verdict::NotChecked
            } else if any(Verdict::HoldsWithin) {
                Verdict::HoldsWithin
            } else {
                Verdict::Holds
            };
            assert_eq!(verdict_of_parts(&parts), expected, "{parts:?}");
        }
    }

    fn sample(quantity: &str) -> Finding {
        let value = String::from("1");
        Finding::from_evidence(Evidence::Sample { quantity: quantity.into(), value, points: 3 })
    }

    fn enclosed(quantity: &str) -> Finding {
        let value = String::from("1");
        Finding::from_evidence(Evidence::Enclosure { quantity: quantity.into(), value })
    }

    #[test]
    fn the_reading_as_written_decides_and_true_parts_are_named() {
        let written = Draft::new("both")
            .part("it rises with σ", enclosed("σ"))
            .part("it rises with V", sample("V").refuted("it falls at V = 1"));
        let other = Draft::new("along σ").part("it rises with σ", enclosed("σ"));
        let found = of_readings([written, other]);
        assert_eq!((found.verdict, found.strength), (Verdict::Fails, Some(Strength::Sampled)));
        assert_eq!(found.limit.as_deref(), Some("true only: it rises with σ"));
        assert_eq!(found.counter_example.as_deref(), Some("it rises with V: it falls at V = 1"));
        let [_, other] = &found.readings[..] else { panic!("two readings") };
        assert_eq!((other.verdict, other.strength), (Verdict::Holds, Some(Strength::Certified)));
        // Both readings rest on the same evidence, which stands once.
        assert_eq!((found.evidence.len(), &other.parts[0].evidence[..]), (2, &[1][..]));
    }

    #[test]
    fn limits_are_named_by_part_and_no_part_is_stronger_than_its_evidence() {
        let limited = enclosed("a").with_evidence(Evidence::Sample {
            quantity: "b".into(),
            value: "2".into(),
            points: 1,
        });
        let found = of_readings([Draft::new("r")
            .part("p", limited.limited("x < 1".into()))
            .part("q", enclosed("a"))]);
        assert_eq!((found.verdict, found.strength), (Verdict::HoldsWithin, Some(Strength::Sampled)));
        assert_eq!(found.limit.as_deref(), Some("p: x < 1"));
        assert_eq!(of_readings([]).verdict, Verdict::NotChecked);
    }

    #[test]
    fn a_claim_with_an_open_part_says_why_it_is_open() {
        let open = || Finding::not_checked("no runs");
        let found =
            of_readings([Draft::new("r").part("p", open()).part("q", open()).part("s", enclosed("a"))]);
        assert_eq!((found.verdict, found.limit), (Verdict::NotChecked, None));
        assert_eq!(found.remarks, ["no runs"]);
    }
}
