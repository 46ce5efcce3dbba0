//! `claims.toml`: the claims that a report decides, with the verdict recorded when they were last reviewed.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use slipmode_theory::{Equations, EquationsText, circle};

use crate::scene::claim_computed::{Known, Procedures};
use crate::scene::claim_formula::{ClaimFormula, StatedClaim, StatedReading};
use crate::scene::claim_library::{library_file, library_ids, library_sentence};
use crate::scene::claim_scope::FormulaEntries;
use crate::scene::claim_subject::{InAnswer, Sliders, Subject, read_subjects};
use crate::scene::document::read_document;
use crate::scene::equations_file::equations_of;
use crate::scene::report_plan::distinct;
use crate::scene::section::{Entry, Section};
use crate::scene::{Fault, Faults, Limits, Problem, Sentence, Verdict};

/// One claim of the paper, in our words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimEntry {
    /// The id, such as `R2`.
    pub id: String,
    /// Where in the paper.
    pub place: String,
    /// The claim, in neutral words.
    pub words: String,
    /// The recorded verdict; the verdict itself is always computed.
    pub expected: Verdict,
    /// What kind of sentence it is, and whose.
    pub sentence: Sentence,
    /// What the claim says as formulas.
    pub stated: Option<StatedClaim>,
    /// Why the claim is out of reach.
    pub reason: Option<String>,
    /// Claims whose truth this one presupposes.
    pub rests_on: Vec<String>,
    /// What it is about.
    pub subject: Option<Subject>,
    /// Where a report's answer uses it.
    pub in_answer: Option<InAnswer>,
    /// The sliders for which a new report lists it.
    pub sliders: Vec<Sliders>,
}

impl ClaimEntry {
    /// All its formulas and parts.
    pub fn formulas(&self) -> impl Iterator<Item = &ClaimFormula> {
        self.stated.iter().flat_map(StatedClaim::parts).map(|(_, formula)| formula)
    }
    /// A claim that is listed by its id alone, as the first paper's claim of this id states it.
    fn with_library(self, equations: &Equations, procedures: &Procedures) -> Self {
        match library_claim(&self.id, equations, procedures) {
            None => self,
            Some(Ok(ClaimEntry { stated, rests_on, subject, in_answer, .. })) => {
                Self { stated, rests_on, subject: subject.or(self.subject), in_answer, ..self }
            }
            Some(Err(reason)) => Self { reason: Some(reason), ..self },
        }
    }
}

/// Reads `claims.toml`. A claim may have any id, and its formulas and parts decide it; one that has none of them and no reason is one
/// of the first paper's. Formulas are read in the names of the equations; where the equations are at fault themselves (none), formulas
/// are not read.
///
/// # Errors
/// All the faults at once: among them unknown ids (with the nearest known one) and ids given twice.
pub fn read_claims(
    file: &str,
    bytes: &[u8],
    procedures: &Procedures,
    equations: Option<&Equations>,
) -> Result<Vec<ClaimEntry>, Faults> {
    read_document(file, bytes, Limits::default(), |top| claims_of(top, procedures, equations))
}

/// Reads one file that has the sections of `equations.toml` and those of `claims.toml`.
///
/// # Errors
/// All the faults at once, as of the two files.
pub fn read_equations_and_claims(
    file: &str,
    bytes: &[u8],
    procedures: &Procedures,
) -> Result<(Equations, Vec<ClaimEntry>), Faults> {
    let mut faults = Faults::new();
    let read = read_document(file, bytes, Limits::default(), |top| {
        let equations = top.deserialized(&EquationsText::SECTIONS).map(|text| {
            let (equations, of_equations) = equations_of(file, text);
            faults = of_equations;
            equations
        });
        let claims = claims_of(top, procedures, equations.as_ref().filter(|_| faults.is_empty()));
        Some((equations?, claims?))
    });
    match read {
        Ok(read) if faults.is_empty() => Ok(read),
        Ok(_) => Err(faults),
        Err(others) => Err(faults.into_iter().chain(others).collect()),
    }
}

/// A claim of the library in the names of a report's equations.
///
/// # Errors
/// Why it cannot be read in these names.
pub fn library_claim(
    id: &str,
    equations: &Equations,
    procedures: &Procedures,
) -> Option<Result<ClaimEntry, String>> {
    let read = read_claims("claims.toml", library_file(id)?.as_bytes(), procedures, Some(equations));
    let read = read.map(|mut claims| claims.pop());
    let words =
        |fault: &Fault| format!("The claim's formulas cannot be read in the report's equations: {fault}.");
    read.map_err(|faults| faults.first().map_or_else(String::new, words)).transpose()
}

/// The claims of a file, in the names of these equations.
fn claims_of(
    top: &mut Section<'_>,
    procedures: &Procedures,
    equations: Option<&Equations>,
) -> Option<Vec<ClaimEntry>> {
    let mut seen: Vec<String> = Vec::new();
    let subjects = top.optionally("subject", read_subjects).unwrap_or_default();
    let known = Known { equations, procedures };
    let claims = top
        .required("claim", "[[claim]] sections")?
        .list(|member| member.table(|section| read_claim(section, &known, &subjects, &mut seen))?);
    let of_library = |id: &str| library_claim(id, equations?, procedures)?.ok()?.stated;
    let (claims, unknown) = with_premises(claims?, of_library);
    if equations.is_none() {
        return Some(claims);
    }
    for (id, premise) in &unknown {
        let needs = format!(
            "the id of a claim that does not rest on this one: of this file, or of the first paper; at most {MOST_BEHIND} stand behind a claim"
        );
        top.fault(&format!("claim {id}: premises: {premise}"), Problem::Needs(needs));
    }
    let wrong = wrong_references(&claims);
    for (key, needs) in &wrong {
        top.fault(key, Problem::Needs((*needs).into()));
    }
    (unknown.is_empty() && wrong.is_empty()).then_some(claims)
}

/// What claims refer to that is no claim, or no earlier one; a claim that rests on itself.
fn wrong_references(claims: &[ClaimEntry]) -> Vec<(String, &'static str)> {
    let place = |id: &String| claims.iter().position(|claim| claim.id == *id);
    let is_unknown = |id: &String| place(id).is_none() && library_file(id).is_none();
    let uses =
        claims.iter().map(|claim| (claim.id.clone(), claim.rests_on.iter().cloned().collect())).collect();
    let mut wrong = Vec::new();
    for (claim, at) in claims.iter().zip(0..) {
        let mut tell = |key: &str, needs| wrong.push((format!("claim {}: {key}", claim.id), needs));
        for id in claim.rests_on.iter().filter(|id| is_unknown(id)) {
            tell(&format!("rests_on: {id}"), "the id of a claim, of this file or of the first paper");
        }
        if circle(&claim.id, &uses).is_some() {
            tell("rests_on", "claims that do not rest on this one");
        }
        if let Some(id) = &claim.sentence.same_as
            && (is_unknown(id) || place(id).is_some_and(|earlier| earlier >= at))
        {
            tell(&format!("same_as: {id}"), "the id of an earlier claim");
        }
    }
    wrong
}

fn read_claim(
    section: &mut Section<'_>,
    known: &Known<'_>,
    subjects: &[Subject],
    seen: &mut Vec<String>,
) -> Option<ClaimEntry> {
    let stated = read_stated(section, known);
    let is_exact = matches!(&stated, Some(Some(stated)) if stated.parts().all(|(_, one)| one.is_equation()));
    let sentence = Sentence::read(section, is_exact);
    let reason = section.optional("reason");
    let is_stated = !matches!(stated, Some(None)) || reason.is_some();
    let id = section.read("id", "the id of a claim", |entry| read_id(entry, is_stated, seen));
    let [place, words] = ["place", "words"].map(|key| section.text(key, "a text"));
    let allowed = Verdict::ALL.map(Verdict::as_str).join(", ");
    let expected = section.required("expected", &allowed);
    let expected = expected.and_then(|entry| entry.word(&Verdict::ALL, Verdict::as_str));
    let reason = reason.and_then(|entry| read_reason(&entry, &stated, expected));
    let rests_on = section.optionally("rests_on", |entry| entry.list(Entry::text)).unwrap_or_default();
    let in_answer = section.optionally("in_answer", |entry| entry.word(&InAnswer::ALL, InAnswer::as_str));
    let slider = |member: &Entry<'_>| member.word(&Sliders::ALL, Sliders::as_str);
    let sliders = section.optionally("sliders", |entry| entry.list(slider)).unwrap_or_default();
    let mut stated = stated?;
    // A formula or a list of parts without words of its own says what the claim's words say.
    for reading in stated.iter_mut().flat_map(|stated| &mut stated.readings) {
        let own = reading.parts.iter_mut().map(|(own, _)| own).chain([&mut reading.words]);
        own.filter(|own| own.is_empty()).for_each(|own| own.clone_from(&words));
    }
    let entry = ClaimEntry {
        sentence: sentence.or_else(|| library_sentence(&id).filter(|_| !is_stated)).unwrap_or_default(),
        subject: subjects.iter().find(|subject| id.starts_with(&subject.letter)).cloned(),
        id,
        place,
        words,
        expected: expected?,
        stated,
        reason,
        rests_on,
        in_answer,
        sliders,
    };
    Some(match known.equations.filter(|_| !is_stated) {
        Some(equations) => entry.with_library(equations, known.procedures),
        None => entry,
    })
}

/// The most premises behind a claim, those of its premises counted.
const MOST_BEHIND: usize = 256;

/// A claim with all its premises.
struct Done {
    stated: Arc<StatedClaim>,
    decided_for: Option<String>,
    /// How many claims stand behind it, itself counted.
    behind: usize,
}

/// The claims with what their premises say, and each premise that is no claim or rests on its own claim. A premise that the file
/// does not list is one of the first paper's claims.
fn with_premises(
    mut claims: Vec<ClaimEntry>,
    of_library: impl Fn(&str) -> Option<StatedClaim>,
) -> (Vec<ClaimEntry>, Vec<(String, String)>) {
    let ids: BTreeSet<String> = claims.iter().map(|claim| claim.id.clone()).collect();
    let stated = claims.iter_mut().filter_map(|claim| claim.stated.as_mut());
    for premise in stated.flat_map(StatedClaim::premises_mut).filter(|one| !ids.contains(&one.id)) {
        premise.stated = of_library(&premise.id).map(Arc::new).unwrap_or_default();
    }
    let mut done: BTreeMap<String, Done> = BTreeMap::new();
    loop {
        let known = done.len();
        for claim in &mut claims {
            let Some(stated) = claim.stated.as_mut().filter(|_| !done.contains_key(&claim.id)) else {
                continue;
            };
            let mut behind = 1;
            for premise in stated.premises_mut() {
                if let Some(found) = done.get(&premise.id) {
                    (premise.stated, premise.decided_for) = (found.stated.clone(), found.decided_for.clone());
                    behind += found.behind;
                }
            }
            if behind <= MOST_BEHIND && stated.premises_mut().all(|one| !one.stated.readings.is_empty()) {
                let (stated, decided_for) = (Arc::new(stated.clone()), claim.sentence.decided_for.clone());
                done.insert(claim.id.clone(), Done { stated, decided_for, behind });
            }
        }
        if done.len() == known {
            break;
        }
    }
    let mut unknown = Vec::new();
    for claim in claims.iter_mut().filter(|claim| !done.contains_key(&claim.id)) {
        let open = claim.stated.iter_mut().flat_map(StatedClaim::premises_mut);
        let open = open.filter(|premise| premise.stated.readings.is_empty());
        unknown.extend(open.map(|premise| (claim.id.clone(), premise.id.clone())));
    }
    (claims, unknown)
}

/// The formulas of a claim; the inner none for a claim without any.
fn read_stated(section: &mut Section<'_>, known: &Known<'_>) -> Option<Option<StatedClaim>> {
    let formula = FormulaEntries::of(section);
    let [parts, readings] = ["part", "reading"].map(|key| section.optional(key));
    let words = section.entries(&["criterion", "leaves_out", "argued", "remarks"]);
    if !formula.is_stated() && parts.is_none() && readings.is_none() {
        return match formula.scope().chain(words.iter()).next() {
            None => Some(None),
            Some(entry) => {
                entry.needs("`formula`, `motion`, `proofs`, `check`, [[claim.part]] or [[claim.reading]]")
            }
        };
    }
    let leaves_out = section.text("leaves_out", "what of the words the formulas leave out, or \"nothing\"");
    let alone = |parts| vec![StatedReading { words: String::new(), parts }];
    let readings = match (formula.is_stated(), parts, readings) {
        (true, None, None) => formula.read(known).map(|formula| alone(vec![(String::new(), formula)])),
        (false, Some(parts), None) => formula.no_scope().and_then(|()| read_parts(&parts, known)).map(alone),
        (false, None, Some(readings)) => formula.no_scope().and_then(|()| {
            readings.list(|reading| {
                reading.table(|reading| {
                    let words = reading.text("words", "a text");
                    let parts = reading.required("part", "[[claim.reading.part]] sections");
                    Some(StatedReading { words, parts: read_parts(&parts?, known)? })
                })?
            })
        }),
        (_, parts, readings) => readings
            .or(parts)?
            .needs("nothing else beside it: a claim has `formula`, [[claim.part]] or [[claim.reading]]"),
    };
    let (argued, remarks, criterion) =
        (words.text("argued"), words.texts("remarks"), words.text("criterion"));
    Some(Some(StatedClaim { criterion, leaves_out, argued, remarks, readings: readings? }))
}

/// Why a claim is out of reach: it has no formula, and is recorded as not checked.
fn read_reason(
    entry: &Entry<'_>,
    stated: &Option<Option<StatedClaim>>,
    expected: Option<Verdict>,
) -> Option<String> {
    let text = entry.text()?;
    match (stated, expected) {
        (Some(Some(_)), _) => entry.needs("no formula beside it: a claim with a reason is out of reach"),
        (_, Some(Verdict::NotChecked) | None) => Some(text),
        _ => entry.needs("`expected = \"not-checked\"`: the claim is out of reach"),
    }
}

fn read_parts(parts: &Entry<'_>, known: &Known<'_>) -> Option<Vec<(String, ClaimFormula)>> {
    parts.list(|part| {
        part.table(|part| {
            let words = part.text("words", "a text");
            let formula = FormulaEntries::of(part);
            if !formula.is_stated() {
                part.fault("formula", Problem::Missing { allowed: "a formula, or `motion`".into() });
            }
            Some((words, formula.read(known)?))
        })?
    })
}

fn read_id(entry: &Entry<'_>, is_stated: bool, seen: &mut Vec<String>) -> Option<String> {
    let id = distinct(entry, entry.text()?, "claim ", seen)?;
    if !is_stated {
        entry.word(&library_ids().collect::<Vec<_>>(), |known| known)?;
    } else {
        let is_letter = |first: char| first.is_ascii_uppercase();
        let well_formed =
            id.starts_with(is_letter) && id[1..].chars().all(|c| c.is_ascii_digit()) && id.len() > 1;
        if !well_formed {
            return entry.needs("the form of an id: a capital letter and a number, such as `R2`");
        }
    }
    Some(id)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(id: &str, expected: &str) -> String {
        format!("[[claim]]\nid = \"{id}\"\nplace = \"eq 8\"\nwords = \"w\"\nexpected = \"{expected}\"\n")
    }

    #[test]
    fn claims_are_read_in_order() {
        let [first, second] = [7, 0].map(|place| library_ids().nth(place).unwrap());
        let text = claim(first, "holds-within") + &claim(second, "fails");
        let claims = read_claims("claims.toml", text.as_bytes(), &Procedures::default(), None).unwrap();
        assert_eq!(claims.iter().map(|claim| claim.id.as_str()).collect::<Vec<_>>(), [first, second]);
        assert_eq!(claims[0].expected, Verdict::HoldsWithin);
    }

    #[test]
    fn doubled_and_unknown_ids_and_unknown_verdicts_are_all_reported() {
        let known = claim(library_ids().next().unwrap(), "holds");
        let text = known.repeat(2) + &claim("A9", "hold");
        let faults = read_claims("claims.toml", text.as_bytes(), &Procedures::default(), None).unwrap_err();
        let lines: Vec<_> = faults.iter().filter_map(|fault| fault.line).collect();
        assert_eq!(lines, [7, 12, 15]);
        assert!(matches!(faults[0].problem, Problem::Duplicate { folded: false, .. }));
        assert!(faults[2].to_string().contains("did you mean `holds`?"), "{}", faults[2]);
    }
}
